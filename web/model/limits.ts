// What one answer of the page may cost, as lab/limits.py has it; what takes longer than 10 s is stopped by the worker.

import { InputError, TooMuch } from "./check.ts";
import { contradiction } from "./paths.ts";
import { tables } from "./tables.ts";
import { general, written } from "./text.ts";

const { lab, limits } = tables;

export type Axis = { path: string; from: number; to: number; cells: number };

/** A sentence of the lab's, with its values. */
export const labText = (name: keyof typeof lab, values: Record<string, any> = {}): Phrase => ({
  key: `lab.${name}`,
  values: written(lab[name], values),
});

/** What the page says of a motion that doubles do not decide. */
export const doubtText = (time: number) => labText("doubt", { time: general(time, 4) });

/** The scenario with its events bounded; what is more than a page computes is refused. */
export function within(checked: Checked, events = limits.events): Checked {
  const { duration, hoop, contact } = checked;
  if (duration > limits.duration) throw new TooMuch(labText("too_long", { duration, most: limits.duration }));
  const parts = hoop.parts?.length ?? 0;
  if (parts > limits.parts) throw new TooMuch(labText("too_many_parts", { parts, most: limits.parts }));
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
