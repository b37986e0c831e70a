// What is asked for: a scenario or its link, with changes, within what a page computes.

import { InputError } from "./check.ts";
import { contradiction } from "./paths.ts";
import { fromDict, fromQuery, withValues } from "./scenario.ts";
import { tables } from "./tables.ts";
import { general, written } from "./text.ts";

/** The scenario that is meant: where two changes say one thing, the later one counts. */
export function asked(
  { scenario, query, changes = [] }: { scenario?: any; query?: string; changes?: Change[] },
  mechanics: Mechanics,
): Checked {
  const start = scenario !== undefined && query === undefined;
  let checked = start ? fromDict(scenario, mechanics) : fromQuery(query ?? "", mechanics);
  let values = new Map<string, any>();
  for (const [path, value] of changes) {
    if (contradiction([...values.keys(), path])) {
      checked = withValues(checked, values, mechanics);
      values = new Map();
    }
    values.set(path, value);
  }
  return values.size ? withValues(checked, values, mechanics) : checked;
}

// --- What one answer of the page may cost, as lab/limits.py has it; what takes longer than 10 s is stopped by the worker

const { lab, limits } = tables;

export type Axis = { path: string; from: number; to: number; cells: number };

/** A sentence of the lab's, with its values. */
export const labText = (name: keyof typeof lab, values: Named = {}): Phrase => ({
  key: `lab.${name}`,
  values: written(lab[name], values),
});

/** What the page says of a motion that doubles do not decide. */
export const doubtText = (time: number) => labText("doubt", { time: general(time, 4) });

/** The scenario with its events bounded; what is more than a page computes is refused. */
export function within(checked: Checked, events = limits.events): Checked {
  const { duration, hoop, contact } = checked;
  if (duration > limits.duration) throw new InputError(labText("too_long", { duration, most: limits.duration }));
  const parts = hoop.parts?.length ?? 0;
  if (parts > limits.parts) throw new InputError(labText("too_many_parts", { parts, most: limits.parts }));
  if (contact.max_events <= events) return checked;
  return { ...checked, contact: { ...contact, max_events: events } };
}

/** The scenario of a map, whose events are bounded. */
export function withinMap(checked: Checked, { x, y }: { x: Axis; y: Axis }): Checked {
  if (checked.contact.model !== "rigid") throw new InputError(labText("rigid_maps"));
  const pair = contradiction([y.path, x.path]);
  if (pair) throw new InputError(labText("two_axes", { one: pair[0], other: pair[1] }));
  return within(checked, limits.cell_events);
}

/** The middle of each cell of an axis. */
export const middles = ({ from, to, cells }: Axis) =>
  Array.from({ length: cells }, (_, k) => from + (k + 0.5) * ((to - from) / cells));

// --- What a link still says where something in it is wrong: parameters of others are ignored, and the rest of it is kept

const OWN = new Set(Object.keys(tables.scenario.models.Scenario.fields));
const MOST = 40; // parameters of a link that is searched for those that are right

const nameOf = (pair: string) => new URLSearchParams(`&${pair}`).keys().next().value ?? "";

// Mail programs and networks add such as fbclid or utm_source; the names of a scenario have a dot.
const isForeign = (pair: string) => !nameOf(pair).includes(".") && !OWN.has(nameOf(pair));

/** Returns the link that can be shown, the names of others in it, and what is wrong with the rest. */
export function readable(query: string, mechanics: Mechanics) {
  const pairs = query.replace(/^\?/, "").split("&").filter(Boolean);
  const own = pairs.filter((pair) => !isForeign(pair));
  const foreign = pairs.filter(isForeign).map(nameOf);
  const refusal = (some: string[]) => {
    try {
      within(asked({ query: some.join("&") }, mechanics));
      return null;
    } catch (error) {
      if (error instanceof InputError) return error;
      throw error;
    }
  };
  const error = refusal(own);
  const right = error ? rightOf(own, (some) => !refusal(some)) : own;
  return { query: right.join("&"), foreign: [...new Set(foreign)], error };
}

/** As many parameters as go together, looked for in each section by itself. */
function rightOf(pairs: string[], holds: (pairs: string[]) => boolean) {
  if (pairs.length > MOST) return [];
  const sections = new Map<string, string[]>();
  for (const pair of pairs) {
    const section = nameOf(pair).split(".")[0];
    sections.set(section, [...(sections.get(section) ?? []), pair]);
  }
  let right: string[] = [];
  for (const section of sections.values()) {
    const wider = [...right, ...most(section, holds)];
    if (holds(wider)) right = wider;
  }
  return right;
}

/** The section without its wrong parameter, or without its wrong two; nothing of it where there are more. */
function most(pairs: string[], holds: (pairs: string[]) => boolean) {
  const without = (...places: number[]) => pairs.filter((_, place) => !places.includes(place));
  const tries = [
    pairs,
    ...pairs.map((_, i) => without(i)),
    ...pairs.flatMap((_, i) => pairs.map((_, j) => without(i, j))),
  ];
  return tries.find(holds) ?? [];
}
