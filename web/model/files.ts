// Files that need no Python: the scenario, the events and the states, in the formats of the library.

import { resultOf } from "./header.ts";
import { tables } from "./tables.ts";
import { numberText } from "./text.ts";

const { rate, variables } = tables.table;
const { letters } = tables.words;

/** The motion as a result file. */
export const resultText = (checked: Checked, motion: ComputedMotion) =>
  JSON.stringify(resultOf(checked, motion), null, 1);

/** When a table has its rows: as Python's `motion.times`. */
export function timesOf(duration: number) {
  const count = Math.min(Math.max(Math.floor(duration * rate) + 1, 2), tables.limits.samples);
  const step = duration / (count - 1);
  return Float64Array.from({ length: count }, (_, k) => (k === count - 1 ? duration : k * step));
}

/** States over time as CSV, one row for each; the unit stands in each column's heading. */
export function tableText(times: Float64Array, samples: Samples) {
  const names = Object.keys(variables);
  const heads = names.map((name) => (variables[name] === "1" ? name : `${name} [${variables[name]}]`));
  const { kinetic, potential } = samples;
  const columns: Samples = { ...samples, total: Float64Array.from(kinetic, (energy, k) => energy + potential[k]) };
  const lines = [["t [s]", ...heads].join(",")];
  for (const [k, t] of times.entries()) {
    const row = names.map((name) => (name === "mode" ? letters[columns.mode[k]] : numberText(columns[name][k])));
    lines.push([numberText(t), ...row].join(","));
  }
  return `${lines.join("\r\n")}\r\n`;
}
