// A map as the page asks for it: the cells that the kernel computes, and what its numbers are called.

import { classColor, classText } from "./classes.ts";
import { given } from "./given.ts";
import { middles, type Axis } from "./limits.ts";
import { Broken } from "./rules.ts";
import { fitted, sectionsWith } from "./scenario.ts";
import { tables } from "./tables.ts";

const BREATH = 8; // milliseconds after which the page may do something else
const { cell: CELL, laws, quantities } = tables.map;

/** Every cell as the kernel takes it; one whose values do not go together is marked. The page breathes in between. */
export async function cellsOf(
  base: Checked,
  { x, y }: { x: Axis; y: Axis },
  mechanics: Mechanics,
  signal?: AbortSignal,
): Promise<MapCells> {
  const across = middles(x);
  const upwards = middles(y);
  const cellAt = independent(base, x.path, y.path)
    ? joined(base, { x, y }, [across, upwards], mechanics)
    : (i: number, k: number) => {
        const values = new Map([
          [y.path, upwards[k]],
          [x.path, across[i]],
        ]);
        return sectionsWith(base, values, mechanics);
      };
  const count = across.length * upwards.length;
  const rows = new Float64Array(CELL.length * count);
  const cell = { ...base };
  let began = performance.now();
  for (let k = 0; k < upwards.length; k++) {
    if (performance.now() - began > BREATH) {
      await new Promise((resolve) => setTimeout(resolve));
      signal?.throwIfAborted();
      began = performance.now();
    }
    for (let i = 0; i < across.length; i++) {
      const sections = cellAt(i, k);
      const numbers = sections && numbersOf(Object.assign(cell, sections), mechanics);
      if (!numbers) continue;
      const place = k * across.length + i;
      for (let field = 0; field < CELL.length; field++) rows[field * count + place] = READ[field](numbers);
    }
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

/** The sections of a cell, each checked once for its value. */
function joined(
  base: Checked,
  { x, y }: { x: Axis; y: Axis },
  [across, upwards]: [number[], number[]],
  mechanics: Mechanics,
): (i: number, k: number) => Partial<Checked> | null {
  const wide = across.map((value) => sectionsWith(base, new Map([[x.path, value]]), mechanics));
  const high = upwards.map((value) => sectionsWith(base, new Map([[y.path, value]]), mechanics));
  return (i, k) => wide[i] && high[k] && { ...wide[i], ...high[k] };
}

/** What stands in each row of a cell. */
const READ: ((given: any) => number)[] = CELL.map((name: string) => {
  if (name === "law") return ({ impact_law }: Given) => laws[impact_law];
  if (name === "strike") return ({ painleve }: Given) => Number(painleve === "impact");
  if (name === "allowed") return () => 1;
  return (given: any) => Number(given[name]);
});

function numbersOf(cell: Checked, mechanics: Mechanics) {
  try {
    return given(fitted(cell, mechanics));
  } catch (error) {
    if (!(error instanceof Broken)) throw error;
    return null;
  }
}

/** The span over which a quantity is taken. */
export const spanOf = (what: string): string => quantities[what].span;

/** A map as the page shows it. */
export function mapReply({ x, y, what }: { x: Axis; y: Axis; what: string }, found: MapValues) {
  const { unit, words } = quantities[what];
  const label = `quantity.${what}`;
  const { values, names } = ordered(found, unit === "" ? words : null);
  const classes =
    unit === "" ? names.map((name) => ({ name, text: classText(name, what), color: classColor(name, what) })) : null;
  return { header: { x, y, what, label, unit, classes }, arrays: { values } };
}

/**
 * Sequences in the order of a legend, the short ones first; what is no code becomes nan. `words`: of a coded
 * quantity.
 */
function ordered({ values, sequences }: MapValues, words: string[] | null): { values: Column; names: string[] } {
  if (!words) return { values: values as Column, names: [] };
  const names = sequences ? [...sequences].sort((a, b) => a.length - b.length || (a < b ? -1 : a > b ? 1 : 0)) : words;
  const codes = sequences?.map((name) => names.indexOf(name));
  const coded = Float64Array.from(values, (code) => (code >= 0 ? (codes?.[code] ?? code) : Number.NaN));
  return { values: coded, names };
}
