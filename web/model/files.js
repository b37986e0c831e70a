// Files that need no Python: the scenario, the events and the states, in the formats of the library.

import { resultOf } from "./header.js";
import { tables } from "./tables.js";
import { numberText } from "./text.js";

const { rate, variables } = tables.table;
const { letters } = tables.words;

/**
 * The motion as a result file.
 * @param {Checked} checked
 * @param {ComputedMotion} motion
 */
export const resultText = (checked, motion) => JSON.stringify(resultOf(checked, motion), null, 1);

/**
 * When a table has its rows: as Python's `motion.times`.
 * @param {number} duration
 */
export function timesOf(duration) {
  const count = Math.min(Math.max(Math.floor(duration * rate) + 1, 2), tables.limits.samples);
  const step = duration / (count - 1);
  return Float64Array.from({ length: count }, (_, k) => (k === count - 1 ? duration : k * step));
}

/**
 * States over time as CSV, one row for each; the unit stands in each column's heading.
 * @param {Float64Array} times
 * @param {Samples} samples
 */
export function tableText(times, samples) {
  const names = Object.keys(variables);
  const heads = names.map((name) => (variables[name] === "1" ? name : `${name} [${variables[name]}]`));
  const { kinetic, potential } = samples;
  /** @type {Samples} */
  const columns = { ...samples, total: Float64Array.from(kinetic, (energy, k) => energy + potential[k]) };
  const lines = [["t [s]", ...heads].join(",")];
  for (const [k, t] of times.entries()) {
    const row = names.map((name) => (name === "mode" ? letters[columns.mode[k]] : numberText(columns[name][k])));
    lines.push([numberText(t), ...row].join(","));
  }
  return `${lines.join("\r\n")}\r\n`;
}
