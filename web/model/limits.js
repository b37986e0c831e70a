// What one answer of the page may cost, as lab/limits.py and lab/motion_map.py have it: refused before anything is computed.

import { holds, InputError, TooMuch } from "./check.js";
import { stateOf } from "./given.js";
import { contradiction } from "./paths.js";
import { tables } from "./tables.js";
import { general, written } from "./text.js";

const { lab, limits } = tables;
const { allowed, events: MOST_EVENTS, flight_turns: FLIGHT_TURNS, quantities } = tables.map;
const TINY = 1e-300;

/** @typedef {{ path: string, from: number, to: number, cells: number }} Axis */

/**
 * A sentence of the lab's, with its values.
 * @param {string} name
 * @param {Record<string, any>} [values]
 * @returns {Phrase}
 */
export const labText = (name, values = {}) => ({ key: `lab.${name}`, values: written(lab[name], values) });

/**
 * What the page says of a motion that doubles do not decide.
 * @param {number} time
 */
export const doubtText = (time) => labText("doubt", { time: general(time, 4) });

/**
 * The scenario with its events bounded; what is more than a page computes is refused.
 * @param {Checked} checked
 * @returns {Checked}
 */
export function within(checked) {
  const { duration, hoop, contact } = checked;
  if (duration > limits.duration) throw new TooMuch(labText("too_long", { duration, most: limits.duration }));
  const parts = hoop.parts?.length ?? 0;
  if (parts > limits.parts) throw new TooMuch(labText("too_many_parts", { parts, most: limits.parts }));
  const turns = turnsOf(costOf(checked));
  if (turns > limits.turns) throw new TooMuch(labText("too_many_turns", { duration, turns, most: limits.turns }));
  if (contact.model === "compliant") {
    const steps = stepsOf(checked, turns);
    if (steps > limits.steps) throw new TooMuch(labText("too_stiff", { steps, most: limits.steps }));
  }
  if (contact.max_events <= limits.events) return checked;
  return { ...checked, contact: { ...contact, max_events: limits.events } };
}

/**
 * What the number of turns follows from.
 * @param {Checked} checked
 * @returns {Record<string, number>}
 */
function costOf({ duration, hoop: { radius }, plane: { gravity, slope }, start }) {
  const { height, vx, vy, omega } = stateOf(start, radius);
  return { duration, radius, gravity, slope, height, vx, vy, omega };
}

/**
 * About how often the hoop turns, or would turn if all its energy went into rolling: what computing it costs.
 * @param {Record<string, number>} cost
 */
function turnsOf({ duration, radius, gravity, slope, height, vx, vy, omega }) {
  const start = Math.abs(vx) + Math.abs(vy) + radius * Math.abs(omega) + 2 * Math.sqrt(gravity * (radius + height));
  const speed = 2 * start + 0.5 * gravity * Math.min(Math.abs(slope), 1) * duration;
  return (speed * duration) / (2 * Math.PI * radius);
}

/**
 * Rough count of the steps of a compliant motion.
 * @param {Checked} checked
 * @param {number} turns
 */
function stepsOf({ duration, hoop: { radius, mass }, plane: { gravity }, contact: { stiffness } }, turns) {
  const second = Math.sqrt(radius / (gravity > 0 ? gravity : 1));
  const rate = 10 / second + (stiffness === null ? 0 : Math.sqrt(stiffness / mass));
  return 10 * duration * rate + 40 * turns;
}

// --- maps ----------------------------------------------------------------------------------------

/**
 * The scenario of a map, whose events and revolutions are bounded.
 * @param {Checked} checked
 * @param {{ x: Axis, y: Axis, what: string }} asked
 * @returns {Checked}
 */
export function withinMap(checked, { x, y, what }) {
  if (checked.contact.model !== "rigid") throw new InputError(labText("rigid_maps"));
  const { contact, ...rest } = within(checked);
  const base = { ...rest, contact: { ...contact, max_events: Math.min(contact.max_events, MOST_EVENTS) } };
  boundTurns(base, x, y, quantities[what].span);
  const pair = contradiction([y.path, x.path]);
  if (pair) throw new InputError(labText("two_axes", { one: pair[0], other: pair[1] }));
  return base;
}

/**
 * @param {Checked} base
 * @param {Axis} x
 * @param {Axis} y
 * @param {string} span
 */
function boundTurns(base, x, y, span) {
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

/**
 * @param {Record<string, number>} cost
 * @param {string} path
 * @param {number} value
 */
function valued(cost, path, value) {
  if (path === "start.speed") return { ...cost, vx: value, vy: 0, omega: 0 }; // the rim's own speed is part of the estimate
  const name = path.slice(path.lastIndexOf(".") + 1);
  return name in cost && name !== "height" ? { ...cost, [name]: value } : cost;
}

/**
 * The middle of each cell of an axis.
 * @param {Axis} axis
 */
export const middles = ({ from, to, cells }) =>
  Array.from({ length: cells }, (_, k) => from + (k + 0.5) * ((to - from) / cells));

/**
 * Whether a number of a scenario may have a value, by itself.
 * @param {string} path
 * @param {number} value
 */
function mayHold(path, value) {
  const range = allowed[path.startsWith("plane.mu") ? "plane.mu" : path];
  return !range || holds(range, value);
}
