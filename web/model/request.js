// What is asked for: a scenario or its link, with changes, within what a page computes.

import { findings, InputError, isTable, refuse, TooMuch, whole } from "./check.js";
import { contradiction } from "./paths.js";
import { fromQuery, read, withValues } from "./scenario.js";
import { tables } from "./tables.js";
import { fill, jsonText, Shown } from "./text.js";

const { lab, limits } = tables;

/**
 * A sentence of the lab's, filled.
 * @param {string} name
 * @param {Record<string, any>} [values]
 */
export const labText = (name, values = {}) => fill(lab[name], values);

/**
 * The scenario that is meant; where two changes say one thing, the later one counts.
 * @param {{ scenario?: any, query?: any, changes?: any }} body
 * @param {Mechanics} mechanics
 * @returns {Checked}
 */
export function asked({ scenario, query = null, changes = [] }, mechanics) {
  const found = findings();
  let checked = null;
  if (scenario !== undefined && !isTable(scenario)) refuse(found, "scenario", scenario, "table");
  else if (scenario !== undefined) checked = read(scenario, mechanics, { ...found, above: "scenario." });
  if (query !== null && typeof query !== "string") refuse(found, "query", query, "word");
  if (!Array.isArray(changes)) refuse(found, "changes", changes, "list");
  else found.said.push(...changes.filter((change) => !isPair(change)).map(notPair));
  if (found.said.length) throw new InputError(whole(found.said));
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

/** @param {any} change */
const isPair = (change) => Array.isArray(change) && change.length === 2 && typeof change[0] === "string";

/** @param {any} change */
const notPair = (change) => labText("not_a_pair", { change: new Shown(jsonText(change).slice(0, 60)) });

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
  if (contact.max_events <= limits.events) return checked;
  return { ...checked, contact: { ...contact, max_events: limits.events } };
}
