// What is asked for: a scenario or its link, with changes, within what a page computes.

import { InputError, TooMuch } from "./check.ts";
import { labText } from "./limits.ts";
import { contradiction } from "./paths.ts";
import { fromDict, fromQuery, withValues } from "./scenario.ts";
import { tables } from "./tables.ts";

const { limits } = tables;

/** The scenario that is meant: where two changes say one thing, the later one counts. */
export function asked(
  { scenario, query, changes = [] }: { scenario?: any; query?: string; changes?: Change[] },
  mechanics: Mechanics,
): Checked {
  const start = scenario !== undefined && query === undefined;
  let checked = start ? fromDict(scenario, mechanics) : fromQuery(query ?? "", mechanics);
  let values: Map<string, any> = new Map();
  for (const [path, value] of changes) {
    if (contradiction([...values.keys(), path])) {
      checked = withValues(checked, values, mechanics);
      values = new Map();
    }
    values.set(path, value);
  }
  return values.size ? withValues(checked, values, mechanics) : checked;
}

/** The same with the other keys of a call. */
export function requested(
  { scenario, query, changes = [], ...options }: Record<string, any>,
  mechanics: Mechanics,
): Record<string, any> & { checked: Checked } {
  if (changes.length > limits.changes) {
    throw new TooMuch(labText("too_many_changes", { pairs: changes.length, most: limits.changes }));
  }
  const { x, y } = options;
  if (x && x.path === y.path) throw new InputError(labText("equal_axes", { path: x.path }));
  const cells = x ? x.cells * y.cells : 0;
  if (cells > limits.cells) throw new TooMuch(labText("too_many_cells", { cells, most: limits.cells }));
  return { ...options, checked: asked({ scenario, query, changes }, mechanics) };
}
