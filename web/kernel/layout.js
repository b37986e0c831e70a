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

/**
 * A scenario's numbers in the order of the module's cells.
 * @param {Given} given
 */
export function cellOf(given) {
  const cell = new Float64Array(layout.cell.length);
  /** @type {Record<string, number>} */
  const values = {
    ...Object.fromEntries(Object.entries(given).filter(([, value]) => typeof value === "number")),
    law: layout.impact_laws.indexOf(given.impact_law),
    strike: Number(given.painleve === "impact"),
    ideal: Number(given.ideal),
    allowed: 1,
  };
  layout.cell.forEach((name, place) => {
    cell[place] = values[name] ?? 0;
  });
  return cell;
}

/**
 * A compliant contact's numbers in the order of `layout.compliant`; nan is what it chooses by itself.
 * @param {GivenContact} contact
 */
export function contactOf(contact) {
  /** @param {number | null} value */
  const number = (value) => value ?? Number.NaN;
  return Float64Array.of(
    layout.laws.indexOf(contact.law),
    layout.friction_laws.indexOf(contact.friction),
    number(contact.stiffness),
    number(contact.damping),
    number(contact.restitution),
    number(contact.slip_speed),
    number(contact.tangential_stiffness),
    number(contact.rtol),
  );
}
