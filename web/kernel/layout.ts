// What the module takes and gives, as Python writes it beside the module.

import layout from "../../src/hophoop/lab/wasm/layout.json" with { type: "json" };

export { layout };

const places = (names: readonly string[]) => Object.fromEntries(names.map((name, place) => [name, place]));

export const CELL: Record<string, number> = places(layout.cell);
export const HEAD: Record<string, number> = places(layout.heads);
export const EVENT: Record<string, number> = places(layout.events);
export const SAMPLE: Record<string, number> = places(layout.samples);
export const CHANGE: Record<string, number> = places(layout.changes);
export const NUMBER: Record<string, number> = places(layout.numbers);
export const WORD: Record<string, number> = places(layout.words);

/** A scenario's numbers in the order of the module's cells. */
export function cellOf(given: Given) {
  const cell = new Float64Array(layout.cell.length);
  const values: Record<string, number> = {
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

/** A compliant contact's numbers in the order of `layout.compliant`; nan is what it chooses by itself. */
export function contactOf(contact: GivenContact) {
  const number = (value: number | null) => value ?? Number.NaN;
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
