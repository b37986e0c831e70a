// What is asked for: a scenario or its link, with changes, within what a page computes.

import { findings, InputError, isTable, refuse, TooMuch, whole, type Findings } from "./check.ts";
import { contradiction } from "./paths.ts";
import { labText } from "./limits.ts";
import { readMap } from "./options.ts";
import { fromQuery, read, withValues } from "./scenario.ts";
import { tables } from "./tables.ts";
import { jsonText, Shown } from "./text.ts";

const { limits } = tables;

/** The scenario that is meant: where two changes say one thing, the later one counts. `found`: what is wrong so far. */
export function asked(
  { scenario, query = null, changes = [] }: { scenario?: any; query?: any; changes?: any },
  mechanics: Mechanics,
  found: Findings = findings(),
): Checked {
  let checked = null;
  if (scenario !== undefined && !isTable(scenario)) refuse(found, "scenario", scenario, "table");
  else if (scenario !== undefined) checked = read(scenario, mechanics, { ...found, above: "scenario." });
  if (query !== null && typeof query !== "string") refuse(found, "query", query, "word");
  if (!Array.isArray(changes)) refuse(found, "changes", changes, "list");
  else found.said.push(...changes.filter((change) => !isPair(change)).map(notPair));
  if (found.said.length) throw new InputError(whole(found.said));
  const pairs = changes.length;
  if (pairs > limits.changes) throw new TooMuch(labText("too_many_changes", { pairs, most: limits.changes }));
  if (query !== null || !checked) checked = fromQuery(query ?? "", mechanics);
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

/** The scenario, the axes and the quantity of a map. */
export function mapAsked(body: Record<string, any>, mechanics: Mechanics) {
  const found = findings();
  const { x, y, what } = readMap(body, found);
  const checked = asked(body, mechanics, found);
  if (x.path === y.path) throw new InputError(labText("equal_axes", { path: x.path }));
  const cells = x.cells * y.cells;
  if (cells > limits.cells) throw new TooMuch(labText("too_many_cells", { cells, most: limits.cells }));
  return { checked, x, y, what };
}

const isPair = (change: any) => Array.isArray(change) && change.length === 2 && typeof change[0] === "string";

const notPair = (change: any) => labText("not_a_pair", { change: new Shown(jsonText(change).slice(0, 60)) });
