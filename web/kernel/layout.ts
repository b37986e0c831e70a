// What the module takes and gives, as Python writes it beside the module.

import layout from "../../src/hophoop/lab/wasm/layout.json" with { type: "json" };

export { layout };

const places = (names: readonly string[]) => Object.fromEntries(names.map((name, place) => [name, place]));

export const CELL: Record<string, number> = places(layout.cell);
export const HEAD: Record<string, number> = places(layout.heads);
export const EVENT: Record<string, number> = places(layout.events);
export const SAMPLE: Record<string, number> = places(layout.samples);
export const NUMBER: Record<string, number> = places(layout.numbers);
export const WORD: Record<string, number> = places(layout.words);

/** Numbers that a scenario has as words, or not at all. */
const CODED: Record<string, (given: Given) => number> = {
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
export function contactOf(contact: CompliantContact | null) {
  const values: Record<string, any> = contact
    ? {
        ...contact,
        law: layout.laws.indexOf(contact.law),
        friction_law: layout.friction_laws.indexOf(contact.friction),
      }
    : {};
  return Float64Array.from(layout.compliant, (name) => values[name] ?? Number.NaN);
}
