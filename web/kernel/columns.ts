// A motion's states as a film shows them: at a steady rate, and at both sides of every event.

import { EVENT, layout, SAMPLE } from "./layout.ts";
import type { Computed, HoopModule } from "./module.ts";

const RATE = 150; // samples a second
const FEWEST = 240;
const MOST = 6000;
const [SPIN, SKID] = [1, 2]; // places of the words, and of the modes' letters

/** Columns of the module that a film shows as they are, and those that it sums. */
const PLAIN =
  "x height angle vx vy omega slip friction_force normal_force kinetic potential rolling_resistance utilization";
const SUMS = { friction_loss: ["friction", "impact_tangential"], normal_loss: ["impact_normal", "damping"] };
const COLUMNS = Object.entries({ ...Object.fromEntries(PLAIN.split(" ").map((name) => [name, [name]])), ...SUMS });

/** `module`: in which the motion was computed last; `window`: times from and to; the whole motion by default. */
export function columnsOf(module: HoopModule, computed: Computed, window?: [number, number]) {
  const { rows, count, duration } = computed;
  const [begin, end] = (window ?? [0, duration]).map((time) => Math.min(Math.max(time, 0), duration));
  const steps = Math.min(Math.max(Math.ceil((end - begin) * RATE), FEWEST), MOST);
  const width = layout.events.length;
  const places = new Set<number>();
  for (let k = 0; k <= steps && duration > 0; k++) places.add(k === steps ? end : begin + k * ((end - begin) / steps));
  const marks = new Set<number>();
  // the end of the last piece can lie a rounding beyond the duration
  for (let k = 0; k < count; k++) {
    const mark = Math.min(rows[k * width + EVENT.t], duration);
    if (mark >= begin && mark <= end) marks.add(mark);
  }
  for (const mark of marks) places.add(mark);
  let times = Float64Array.from(places).sort();
  if (steps === MOST) {
    for (const time of passes(times, module.states(computed, times, false))) places.add(time);
    times = Float64Array.from(places).sort();
  }
  const sides = Float64Array.from(marks)
    .filter((time) => time > 0)
    .sort();
  const after = module.states(computed, times, false);
  const before = module.states(computed, sides, true);
  return joined(times, after, sides, before);
}

/** About when the load passes the top or the bottom, where speeds and forces are extreme. */
function passes(times: Float64Array, states: Float64Array) {
  const width = layout.samples.length;
  const angle = (k: number) => states[k * width + SAMPLE.angle];
  const half = (k: number) => Math.floor(angle(k) / Math.PI);
  const found: number[] = [];
  for (let k = 0; k + 1 < times.length; k++) {
    if (half(k) === half(k + 1)) continue;
    const share = (Math.max(half(k), half(k + 1)) * Math.PI - angle(k)) / (angle(k + 1) - angle(k));
    found.push(times[k] + share * (times[k + 1] - times[k]));
  }
  return found;
}

export function joined(times: Float64Array, after: Float64Array, sides: Float64Array, before: Float64Array) {
  const size = times.length + sides.length;
  const width = layout.samples.length;
  const t = new Float64Array(size);
  const states = new Float64Array(size * width);
  let place = 0;
  let side = 0;
  for (let k = 0; k < times.length; k++) {
    if (side < sides.length && sides[side] <= times[k]) {
      t[place] = sides[side];
      states.set(before.subarray(side * width, (side + 1) * width), place * width);
      place++;
      side++;
    }
    t[place] = times[k];
    states.set(after.subarray(k * width, (k + 1) * width), place * width);
    place++;
  }
  const columns: Named<Column> = { t };
  for (const [name, parts] of COLUMNS) {
    // from −0, so that a sum of one part has all its bits
    const column = new Float64Array(size).fill(-0);
    for (const part of parts) {
      for (let k = 0; k < size; k++) column[k] += states[k * width + SAMPLE[part]];
    }
    columns[name] = column;
  }
  columns.mode = wordsOf(states, size, columns.omega);
  return columns;
}

// A slip's word follows the rotation; where the hoop does not turn, the one that comes.
function wordsOf(states: Float64Array, size: number, omega: Column) {
  const width = layout.samples.length;
  const words = new Float64Array(size);
  let turning = 0;
  for (let k = size - 1; k >= 0 && !turning; k--) turning = Math.sign(omega[k]) || 0;
  for (let k = size - 1; k >= 0; k--) {
    turning = Math.sign(omega[k]) || turning;
    const mode = states[k * width + SAMPLE.mode];
    const slip = mode === SPIN ? -1 : mode === SKID ? 1 : 0;
    words[k] = slip === 0 ? mode : slip * turning < 0 ? SPIN : SKID;
  }
  return words;
}
