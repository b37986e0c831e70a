// What one answer of the page may cost, as lab/api/limits.py and lab/api/motion_map.py have it: refused before anything is computed.

import { holds, InputError, TooMuch } from "./check.ts";
import { stateOf } from "./given.ts";
import { contradiction } from "./paths.ts";
import { tables } from "./tables.ts";
import { general, written } from "./text.ts";

const { lab, limits } = tables;
const { allowed, events: MOST_EVENTS, flight_turns: FLIGHT_TURNS, quantities } = tables.map;
const TINY = 1e-300;

export type Axis = { path: string; from: number; to: number; cells: number };

/** A sentence of the lab's, with its values. */
export const labText = (name: string, values: Record<string, any> = {}): Phrase => ({
  key: `lab.${name}`,
  values: written(lab[name], values),
});

/** What the page says of a motion that doubles do not decide. */
export const doubtText = (time: number) => labText("doubt", { time: general(time, 4) });

/** The scenario with its events bounded; what is more than a page computes is refused. */
export function within(checked: Checked): Checked {
  const { duration, hoop, contact } = checked;
  if (duration > limits.duration) throw new TooMuch(labText("too_long", { duration, most: limits.duration }));
  const parts = hoop.parts?.length ?? 0;
  if (parts > limits.parts) throw new TooMuch(labText("too_many_parts", { parts, most: limits.parts }));
  const turns = turnsOf(costOf(checked));
  if (turns > limits.turns) throw new TooMuch(labText("too_many_turns", { duration, turns, most: limits.turns }));
  if (contact.model === "compliant") {
    const steps = stepsOf(checked, turns);
    if (steps > limits.steps) throw new TooMuch(labText("too_stiff", { steps: steps / 1e6, most: limits.steps / 1e6 }));
  }
  if (contact.max_events <= limits.events) return checked;
  return { ...checked, contact: { ...contact, max_events: limits.events } };
}

/** Refuse a film that Python would not draw. */
export function withinFilm({ duration }: Checked) {
  if (duration > limits.film) throw new TooMuch(labText("film_too_long", { duration, most: limits.film }));
}

/** What the number of turns follows from. */
function costOf({ duration, hoop: { radius }, plane: { gravity, slope }, start }: Checked): Record<string, number> {
  const { height, vx, vy, omega } = stateOf(start, radius);
  return { duration, radius, gravity, slope, height, vx, vy, omega };
}

/** About how often the hoop turns, or would turn if all its energy went into rolling: what computing it costs. */
function turnsOf({ duration, radius, gravity, slope, height, vx, vy, omega }: Record<string, number>) {
  const start = Math.abs(vx) + Math.abs(vy) + radius * Math.abs(omega) + 2 * Math.sqrt(gravity * (radius + height));
  const speed = 2 * start + 0.5 * gravity * Math.min(Math.abs(slope), 1) * duration;
  return (speed * duration) / (2 * Math.PI * radius);
}

/** Rough count of the steps of a compliant motion. */
function stepsOf(
  { duration, hoop: { radius, mass }, plane: { gravity }, contact: { stiffness } }: Checked,
  turns: number,
) {
  const second = Math.sqrt(radius / (gravity > 0 ? gravity : 1));
  const rate = 10 / second + (stiffness === null ? 0 : Math.sqrt(stiffness / mass));
  return 10 * duration * rate + 40 * turns;
}

// --- maps ----------------------------------------------------------------------------------------

/** The scenario of a map, whose events and revolutions are bounded. */
export function withinMap(checked: Checked, { x, y, what }: { x: Axis; y: Axis; what: string }): Checked {
  if (checked.contact.model !== "rigid") throw new InputError(labText("rigid_maps"));
  const { contact, ...rest } = within(checked);
  const base = { ...rest, contact: { ...contact, max_events: Math.min(contact.max_events, MOST_EVENTS) } };
  boundTurns(base, x, y, quantities[what].span);
  const pair = contradiction([y.path, x.path]);
  if (pair) throw new InputError(labText("two_axes", { one: pair[0], other: pair[1] }));
  return base;
}

function boundTurns(base: Checked, x: Axis, y: Axis, span: string) {
  const cost = costOf(base);
  const first = span === "first_revolution";
  const across = middles(x).filter((value) => mayHold(x.path, value));
  const upwards = middles(y).filter((value) => mayHold(y.path, value));
  let [total, worst] = [0, 0];
  for (const high of upwards) {
    for (const wide of across) {
      const cell = valued(valued(cost, y.path, high), x.path, wide);
      // a turn, and the flight after it; a longer flight costs no more
      const hop = () => Math.min((cell.vx * cell.vx) / (10 * cost.gravity * cost.radius + TINY), FLIGHT_TURNS);
      const turns = first ? 1 + hop() : turnsOf(cell);
      total += turns;
      worst = Math.max(worst, turns);
    }
  }
  if (!first && worst > limits.turns) throw new TooMuch(labText("cell_turns", { turns: worst, most: limits.turns }));
  if (total <= limits.map_turns) return;
  const cells = across.length * upwards.length;
  throw new TooMuch(labText("map_turns", { cells, turns: total, most: limits.map_turns }));
}

function valued(cost: Record<string, number>, path: string, value: number) {
  if (path === "start.speed") return { ...cost, vx: value, vy: 0, omega: 0 }; // the rim's own speed is part of the estimate
  const name = path.slice(path.lastIndexOf(".") + 1);
  return name in cost && name !== "height" ? { ...cost, [name]: value } : cost;
}

/** The middle of each cell of an axis. */
export const middles = ({ from, to, cells }: Axis) =>
  Array.from({ length: cells }, (_, k) => from + (k + 0.5) * ((to - from) / cells));

/** Whether a number of a scenario may have a value, by itself. */
function mayHold(path: string, value: number) {
  return !allowed[path] || holds(allowed[path], value);
}
