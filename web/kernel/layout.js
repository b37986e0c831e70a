// What the module takes and gives, as Python writes it beside the module.

import layout from "../../src/hophoop/lab/wasm/layout.json" with { type: "json" };

export { layout };

/** @param {readonly string[]} names */
const places = (names) => Object.fromEntries(names.map((name, place) => [name, place]));

/** @type {Record<string, number>} */
export const CELL = places(layout.cell);
/** @type {Record<string, number>} */
export const HEAD = places(layout.heads);
/** @type {Record<string, number>} */
export const EVENT = places(layout.events);
/** @type {Record<string, number>} */
export const SAMPLE = places(layout.samples);
/** @type {Record<string, number>} */
export const CHANGE = places(layout.changes);
/** @type {Record<string, number>} */
export const NUMBER = places(layout.numbers);
/** @type {Record<string, number>} */
export const WORD = places(layout.words);

/** Numbers that a scenario has as words, or not at all. @type {Record<string, (given: Given) => number>} */
const CODED = {
  law: ({ impact_law }) => layout.impact_laws.indexOf(impact_law),
  strike: ({ painleve }) => Number(painleve === "impact"),
  allowed: () => 1,
};

/** What stands in each row of a cell. @type {((given: any) => number)[]} */
export const READ = layout.cell.map((name) => CODED[name] ?? ((given) => Number(given[name] ?? 0)));

/**
 * A scenario's numbers in the order of the module's cells.
 * @param {Given} given
 */
export const cellOf = (given) => Float64Array.from(READ, (read) => read(given));

/**
 * A compliant contact's numbers in the order of `layout.compliant`; nan is what it chooses by itself, and all of a rigid one.
 * @param {GivenContact | null} contact
 */
export function contactOf(contact) {
  /** @type {Record<string, any>} */
  const values = contact
    ? {
        ...contact,
        law: layout.laws.indexOf(contact.law),
        friction_law: layout.friction_laws.indexOf(contact.friction),
      }
    : {};
  return Float64Array.from(layout.compliant, (name) => values[name] ?? Number.NaN);
}
