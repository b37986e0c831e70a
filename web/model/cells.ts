// A map as the page asks for it: the cells that the kernel computes, and what its numbers are called.

import { READ } from "../kernel/layout.ts";
import { classColor, classText } from "./classes.ts";
import { given } from "./given.ts";
import { middles, type Axis } from "./limits.ts";
import { sectionsWith } from "./scenario.ts";
import { tables } from "./tables.ts";

const BREATH = 8; // milliseconds after which the page may do something else
const { quantities } = tables.map;

/**
 * Every cell as the kernel takes it, which leaves out those that break a rule; where a value is not allowed by
 * itself, a cell is all zeros. The page breathes in between.
 */
export async function cellsOf(
  base: Checked,
  { x, y }: { x: Axis; y: Axis },
  mechanics: Mechanics,
  signal?: AbortSignal,
): Promise<MapCells> {
  const [across, upwards] = [middles(x), middles(y)];
  const withs = (...pairs: [string, number][]) => sectionsWith(base, new Map(pairs), mechanics);
  const apart = independent(base, x.path, y.path);
  const wide = apart && across.map((value) => withs([x.path, value]));
  const high = apart && upwards.map((value) => withs([y.path, value]));
  const count = across.length * upwards.length;
  const rows = new Float64Array(READ.length * count);
  let began = performance.now();
  for (let place = 0; place < count; place++) {
    const i = place % across.length;
    const k = (place - i) / across.length;
    if (i === 0 && performance.now() - began > BREATH) {
      await new Promise((resolve) => setTimeout(resolve));
      signal?.throwIfAborted();
      began = performance.now();
    }
    const one = wide ? wide[i] : withs([y.path, upwards[k]], [x.path, across[i]]);
    const other = high ? high[k] : one;
    if (!one || !other) continue;
    const numbers = given({ ...base, ...one, ...other });
    for (let field = 0; field < READ.length; field++) rows[field * count + place] = READ[field](numbers);
  }
  return { count, rows };
}

/** Whether the values of two axes are checked apart: in sections of their own, of which none takes from the other. */
function independent({ start }: Checked, one: string, other: string) {
  const sections = [one, other].map((path) => path.split(".")[0]);
  if (sections[0] === sections[1]) return false;
  // a rolling start that becomes a free one turns as its hoop rolls
  const free = [one, other].some((path) => path.startsWith("start.") && path !== "start.speed");
  return !(sections.includes("hoop") && free && start.speed !== null);
}

/** The span over which a quantity is taken. */
export const spanOf = (what: string): string => quantities[what].span;

/** A map as the page shows it. */
export function mapReply({ x, y, what }: { x: Axis; y: Axis; what: string }, found: MapValues) {
  const { unit, words } = quantities[what];
  const label = `quantity.${what}`;
  const { values, names } = ordered(found, unit === "" ? words : null);
  const classOf = (name: string) => ({
    name,
    text: classText(name, what),
    color: classColor(name, what),
  });
  return { header: { x, y, what, label, unit, classes: unit === "" ? names.map(classOf) : null }, arrays: { values } };
}

/**
 * Sequences in the order of a legend, the short ones first; what is no code becomes nan. `words`: of a coded
 * quantity.
 */
function ordered({ values, sequences }: MapValues, words: string[] | null): { values: Column; names: string[] } {
  if (!words) return { values: values as Column, names: [] };
  const names = sequences ? [...sequences].sort((a, b) => a.length - b.length || (a < b ? -1 : 1)) : words;
  const codes = sequences?.map((name) => names.indexOf(name));
  const coded = Float64Array.from(values, (code) => (code >= 0 ? (codes?.[code] ?? code) : Number.NaN));
  return { values: coded, names };
}
