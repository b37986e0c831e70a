// A map as the page asks for it: the cells that the kernel computes, and what its numbers are called.

import { READ } from "../kernel/layout.ts";
import { given } from "./given.ts";
import { middles, type Axis } from "./request.ts";
import { sectionsWith } from "./scenario.ts";
import { tables } from "./tables.ts";
import { hex } from "./text.ts";

const BREATH = 8; // milliseconds after which the page may do something else
const ROW = 64; // cells between two looks at the clock
const { quantities } = tables.map;

type Axes = { x: Axis; y: Axis };

/**
 * Every cell as the kernel takes it, row by row. The kernel leaves out those that break a rule; where a value is not
 * allowed by itself, a cell is all zeros. The page breathes in between.
 */
export async function cellsOf(base: Checked, { x, y }: Axes, mechanics: Mechanics, signal?: AbortSignal) {
  const [columns, rows] = [middles(x), middles(y)];
  const withs = (...pairs: [string, number][]) => sectionsWith(base, new Map(pairs), mechanics);
  const apart = independent(base, x.path, y.path);
  const wide = remembered((value) => withs([x.path, value]));
  const high = remembered((value) => withs([y.path, value]));
  const count = columns.length * rows.length;
  const fields = new Float64Array(READ.length * count);
  let began = performance.now();
  for (let place = 0; place < count; place++) {
    const [across, upwards] = [columns[place % columns.length], rows[Math.floor(place / columns.length)]];
    if (place % ROW === 0 && performance.now() - began > BREATH) {
      await new Promise((resolve) => setTimeout(resolve));
      signal?.throwIfAborted();
      began = performance.now();
    }
    const one = apart ? wide(across) : withs([y.path, upwards], [x.path, across]);
    const other = apart ? high(upwards) : one;
    if (!one || !other) continue;
    const numbers = given({ ...base, ...one, ...other });
    for (let field = 0; field < READ.length; field++) fields[field * count + place] = READ[field](numbers);
  }
  return { count, rows: fields };
}

/** Each value's answer, found once. */
function remembered<T>(find: (value: number) => T) {
  const known = new Map<number, T>();
  return (value: number) => {
    if (!known.has(value)) known.set(value, find(value));
    return known.get(value) as T;
  };
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
export function mapReply({ x, y, what }: Axes & { what: string }, found: MapValues) {
  const { unit, words } = quantities[what];
  const label = `quantity.${what}`;
  const { values, names } = ordered(found, unit === "" ? words : null);
  const classes = unit === "" ? names.map((name) => classOf(name, what)) : null;
  return { header: { x, y, what, label, unit, classes }, arrays: { values } };
}

const classOf = (name: string, what: string): MapClass => ({
  name,
  text: classText(name, what),
  color: classColor(name, what),
});

/**
 * Sequences in the order of a legend, the short ones first; what is no code becomes nan. `words`: of a coded
 * quantity.
 */
function ordered({ values, sequences }: MapValues, words: string[] | null) {
  if (!words) return { values: values as Column, names: [] };
  const names = sequences ? [...sequences].sort((a, b) => a.length - b.length || (a < b ? -1 : 1)) : words;
  const codes = sequences?.map((name) => names.indexOf(name));
  const coded = Float64Array.from(values, (code) => (code >= 0 ? (codes?.[code] ?? code) : Number.NaN));
  return { values: coded, names };
}

// --- Colours and names of the classes of motions in maps: the page's side of vocabulary/colors.py, to the same digits

const { codes, families, massless, hops, rolls, other } = tables.classes;
const SEQUENCE = "sequence";

/** From 0 to 1: classes of one length and family differ a little, by their names. */
const driftOf = (name: string) => [...name].reduce((sum, letter) => (131 * sum + letter.charCodeAt(0)) % 997, 0) / 997;

/** `name`: a sequence, or a word of another quantity; returns as #RRGGBB. */
export function classColor(name: string, quantity: string): string {
  if (quantity !== SEQUENCE) return codes[quantity]?.[name] ?? other;
  const first = /[SK]/.exec(name)?.[0] ?? "R";
  const does = [name.startsWith("R") && "rolls", /[SK]/.test(name) && "slips"].filter(Boolean).join(", ");
  const contact = name.endsWith("H") ? hops : (families[first + name.slice(-1)] ?? rolls);
  const ink = name.includes("M") ? massless[does] : contact;
  const base = [1, 3, 5].map((place) => Number.parseInt(ink.slice(place, place + 2), 16) / 255);
  const middle = (base[0] + base[1] + base[2]) / 3;
  const depth = Math.min(name.length - 1, 9) / 9;
  const drift = 0.2 * driftOf(name);
  const light = 0.62 - 0.62 * Math.min(2 * depth, 1);
  const dark = Math.max(2 * depth - 1, 0) * 0.5;
  const shades = base.map((part) => {
    const mixed = (1 - drift) * part + drift * middle;
    return 255 * (mixed + (1 - mixed) * light) * (1 - dark);
  });
  return `#${hex(shades)}`;
}

/** A class in words. */
function classText(name: string, quantity: string): Message {
  if (quantity !== SEQUENCE) return `class.${name}`;
  const { letters: known, modes } = tables.words;
  const letters = [...name].map((letter) => (letter === "+" ? "…" : `mode.${modes[known.indexOf(letter)]}`));
  return letters.flatMap((letter, k) => (k ? [" → ", letter] : [letter]));
}
