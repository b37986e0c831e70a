// A map as the page asks for it: the cells that the kernel computes, and what its numbers are called.

import { InputError, TooMuch } from "./check.js";
import { classColor, classText } from "./classes.js";
import { given } from "./given.js";
import { contradiction, known } from "./paths.js";
import { labText, within } from "./request.js";
import { withValues } from "./scenario.js";
import { tables } from "./tables.js";

const { cell: CELL, laws, events: MOST_EVENTS, quantities } = tables.map;

/** @typedef {{ path: string, from: number, to: number, cells: number }} Axis */

/**
 * The middle of each cell of an axis.
 * @param {Axis} axis
 */
const middles = ({ from, to, cells }) =>
  Array.from({ length: cells }, (_, k) => from + (k + 0.5) * ((to - from) / cells));

/**
 * The scenario of a map, and what is asked of it.
 * @param {Checked} checked
 * @param {{ x: Axis, y: Axis, what: string }} asked
 */
export function checkMap(checked, { x, y }) {
  known(x.path);
  known(y.path);
  if (x.path === y.path) throw new InputError(labText("equal_axes", { path: x.path }));
  const cells = x.cells * y.cells;
  if (cells > tables.limits.cells) throw new TooMuch(labText("too_many_cells", { cells, most: tables.limits.cells }));
  if (checked.contact.model !== "rigid") throw new InputError(labText("rigid_maps"));
  const pair = contradiction([y.path, x.path]);
  if (pair) throw new InputError(labText("two_axes", { one: pair[0], other: pair[1] }));
  const { contact, ...rest } = within(checked);
  return { ...rest, contact: { ...contact, max_events: Math.min(contact.max_events, MOST_EVENTS) } };
}

/**
 * Every cell as the kernel takes it; one whose values do not go together is marked.
 * @param {Checked} base
 * @param {{ x: Axis, y: Axis }} axes
 * @param {Mechanics} mechanics
 * @returns {MapCells}
 */
export function cellsOf(base, { x, y }, mechanics) {
  const across = middles(x);
  const upwards = middles(y);
  const count = across.length * upwards.length;
  const rows = new Float64Array(CELL.length * count);
  let place = 0;
  for (const high of upwards) {
    for (const wide of across) {
      const numbers = numbersOf(base, x.path, wide, y.path, high, mechanics);
      if (numbers) for (let field = 0; field < CELL.length; field++) rows[field * count + place] = numbers[CELL[field]];
      place++;
    }
  }
  return { count, rows };
}

/**
 * @param {Checked} base
 * @param {string} xPath
 * @param {number} x
 * @param {string} yPath
 * @param {number} y
 * @param {Mechanics} mechanics
 * @returns {Record<string, any> | null}
 */
function numbersOf(base, xPath, x, yPath, y, mechanics) {
  const values = new Map([
    [yPath, y],
    [xPath, x],
  ]);
  try {
    const found = given(withValues(base, values, mechanics));
    return {
      ...found,
      law: laws[found.impact_law],
      strike: found.painleve === "impact" ? 1 : 0,
      ideal: found.ideal ? 1 : 0,
      allowed: 1,
    };
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    return null;
  }
}

/**
 * The span over which a quantity is taken.
 * @param {string} what
 * @returns {string}
 */
export function spanOf(what) {
  if (Object.hasOwn(quantities, what)) return quantities[what].span;
  throw new InputError(`what = ${what} must be one of ${Object.keys(quantities).join(", ")}.`);
}

/**
 * A map as the page shows it.
 * @param {{ x: Axis, y: Axis, what: string }} asked
 * @param {MapValues} found
 */
export function mapReply({ x, y, what }, found) {
  const { label, unit, words } = quantities[what];
  const { values, names } = ordered(found, unit === "" ? words : null);
  const classes =
    unit === "" ? names.map((name) => ({ name, text: classText(name, what), color: classColor(name, what) })) : null;
  return { header: { x, y, what, label, unit, classes }, arrays: { values } };
}

/**
 * Sequences in the order of a legend, the short ones first; what is no code becomes nan.
 * @param {MapValues} found
 * @param {string[] | null} words of a coded quantity
 * @returns {{ values: Column, names: string[] }}
 */
function ordered({ values, sequences }, words) {
  if (!words) return { values: /** @type {Column} */ (values), names: [] };
  const names = sequences ? [...sequences].sort((a, b) => a.length - b.length || (a < b ? -1 : a > b ? 1 : 0)) : words;
  const codes = sequences?.map((name) => names.indexOf(name));
  const coded = Float64Array.from(values, (code) => (code >= 0 ? (codes?.[code] ?? code) : Number.NaN));
  return { values: coded, names };
}
