// What is asked for: a scenario or its link, with changes, within what a page computes.

import { findings, InputError, isTable, refuse, TooMuch, whole } from "./check.ts";
import { contradiction } from "./paths.ts";
import { labText } from "./limits.ts";
import { readOptions, strange } from "./options.ts";
import { fromQuery, read, withValues } from "./scenario.ts";
import { tables } from "./tables.ts";
import { jsonText, Shown } from "./text.ts";

const { limits } = tables;

/**
 * What a call asks for: the scenario that is meant – where two changes say one thing, the later one counts – and its
 * options. `name`: of the call.
 */
export function requested(
  name: string,
  body: Record<string, any>,
  mechanics: Mechanics,
): Record<string, any> & { checked: Checked } {
  const unknown = strange(name, body);
  if (unknown) throw new InputError(unknown);
  const { scenario, query = null, changes = [] } = body;
  const found = findings();
  let checked = null;
  if (scenario !== undefined && !isTable(scenario)) refuse(found, "scenario", scenario, "table");
  else if (scenario !== undefined) checked = read(scenario, mechanics, { ...found, above: "scenario." });
  if (query !== null && typeof query !== "string") refuse(found, "query", query, "word");
  if (!Array.isArray(changes)) refuse(found, "changes", changes, "list");
  else found.said.push(...changes.filter((change) => !isPair(change)).map(notPair));
  const options = readOptions(name, body, found);
  if (found.said.length) throw new InputError(whole(found.said));
  bounded(changes.length, options);
  if (query !== null || !checked) checked = fromQuery(query ?? "", mechanics);
  let values = new Map();
  for (const [path, value] of changes) {
    if (contradiction([...values.keys(), path])) {
      checked = withValues(checked, values, mechanics);
      values = new Map();
    }
    values.set(path, value);
  }
  return { ...options, checked: values.size ? withValues(checked, values, mechanics) : checked };
}

/** The scenario that is meant. */
export const asked = (body: { scenario?: any; query?: any; changes?: any }, mechanics: Mechanics): Checked =>
  requested("film", body, mechanics).checked;

/** Refuse what is more than the lab reads. */
function bounded(pairs: number, { x, y }: Record<string, any>) {
  if (pairs > limits.changes) throw new TooMuch(labText("too_many_changes", { pairs, most: limits.changes }));
  if (!x) return;
  if (x.path === y.path) throw new InputError(labText("equal_axes", { path: x.path }));
  const cells = x.cells * y.cells;
  if (cells > limits.cells) throw new TooMuch(labText("too_many_cells", { cells, most: limits.cells }));
}

const isPair = (change: any) => Array.isArray(change) && change.length === 2 && typeof change[0] === "string";

const notPair = (change: any) => labText("not_a_pair", { change: new Shown(jsonText(change).slice(0, 60)) });
