// What the module takes and gives, as Python writes it beside the module.

import layout from "../../src/hophoop/lab/wasm/layout.json" with { type: "json" };

export { layout };

/** Values by names, of which each is found by its place. */
export const named = <Value>(names: readonly string[], of: (place: number) => Value): Named<Value> =>
  Object.fromEntries(names.map((name, place) => [name, of(place)]));

const places = (names: readonly string[]) => named(names, (place) => place);

export const HEAD = places(layout.heads);
export const EVENT = places(layout.events);
export const SAMPLE = places(layout.samples);
export const NUMBER = places(layout.numbers);
export const WORD = places(layout.words);

/** Numbers that a scenario has as words, or not at all. */
const CODED: Named<(given: Given) => number> = {
  law: ({ impact_law }) => layout.impact_laws.indexOf(impact_law),
  painleve_impact: ({ painleve }) => Number(painleve === "impact"),
  mode: ({ mode }) => (mode ? layout.letters.indexOf(mode) : -1), // selected by the rule
  allowed: () => 1,
};

/** What stands in each row of a cell. */
export const READ: ((given: any) => number)[] = layout.cell.map(
  (name) => CODED[name] ?? ((given) => Number(given[name] ?? 0)),
);

/** A scenario's numbers in the order of the module's cells. */
export const cellOf = (given: Given) => Float64Array.from(READ, (read) => read(given));

/**
 * A compliant contact's numbers in the order of `layout.compliant`; nan is what it chooses by itself, and all of a
 * rigid one.
 */
export function contactOf(contact: Named | null) {
  const values: Named = contact
    ? {
        ...contact,
        law: layout.laws.indexOf(contact.law),
        friction_law: layout.friction_laws.indexOf(contact.friction),
      }
    : {};
  return Float64Array.from(layout.compliant, (name) => values[name] ?? Number.NaN);
}
