// What is asked for: a scenario or its link, with changes, within what a page computes.

import { InputError, TooMuch } from "./check.js";
import { labText } from "./limits.js";
import { contradiction } from "./paths.js";
import { fromDict, fromQuery, withValues } from "./scenario.js";
import { tables } from "./tables.js";

const { limits } = tables;

/**
 * The scenario that is meant: where two changes say one thing, the later one counts.
 * @param {{ scenario?: any, query?: string, changes?: Change[] }} body
 * @param {Mechanics} mechanics
 * @returns {Checked}
 */
export function asked({ scenario, query, changes = [] }, mechanics) {
  if (changes.length > limits.changes) {
    throw new TooMuch(labText("too_many_changes", { pairs: changes.length, most: limits.changes }));
  }
  const start = scenario !== undefined && query === undefined;
  let checked = start ? fromDict(scenario, mechanics) : fromQuery(query ?? "", mechanics);
  /** @type {Map<string, any>} */
  let values = new Map();
  for (const [path, value] of changes) {
    if (contradiction([...values.keys(), path])) {
      checked = withValues(checked, values, mechanics);
      values = new Map();
    }
    values.set(path, value);
  }
  return values.size ? withValues(checked, values, mechanics) : checked;
}

/**
 * The same with the other keys of a call.
 * @param {Record<string, any>} body
 * @param {Mechanics} mechanics
 * @returns {Record<string, any> & { checked: Checked }}
 */
export function requested({ scenario, query, changes, ...options }, mechanics) {
  const { x, y } = options;
  if (x && x.path === y.path) throw new InputError(labText("equal_axes", { path: x.path }));
  const cells = x ? x.cells * y.cells : 0;
  if (cells > limits.cells) throw new TooMuch(labText("too_many_cells", { cells, most: limits.cells }));
  return { ...options, checked: asked({ scenario, query, changes }, mechanics) };
}
