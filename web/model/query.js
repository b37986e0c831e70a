// The query of a link, read and written.

import { InputError, say } from "./check.js";
import { tables } from "./tables.js";
import { floatOf, floatText } from "./text.js";

const MOST_FIELDS = 1000;

/**
 * The nested keys of a query; every number in it is one with a point.
 * @param {string} query
 * @returns {Record<string, any>}
 */
export function readQuery(query) {
  const text = query.startsWith("?") ? query.slice(1) : query;
  if (text && text.split("&").length > MOST_FIELDS) {
    throw new InputError(say("unreadable_query", { reason: "Max number of fields exceeded" }));
  }
  /** @type {Map<string, any>} */
  const data = new Map();
  // of a second question mark URLSearchParams would take another one off
  for (const [path, value] of new URLSearchParams(`&${text}`)) {
    const steps = path.split(".");
    const last = /** @type {string} */ (steps.pop());
    let node = data;
    for (const step of steps) {
      if (!node.has(step)) node.set(step, new Map());
      node = node.get(step);
      if (!(node instanceof Map)) {
        throw new InputError(say("value_above", { path, above: path.slice(0, path.lastIndexOf(".")) }));
      }
    }
    if (node.has(last)) throw new InputError(say("given_twice", { path }));
    node.set(last, floatOf(value) ?? value);
  }
  const hoop = data.get("hoop");
  const parts = hoop instanceof Map && hoop.get("parts");
  if (parts instanceof Map) hoop.set("parts", numbered(parts));
  return plainOf(data);
}

/** @param {Map<string, any>} parts */
function numbered(parts) {
  const names = Array.from({ length: parts.size }, (_, index) => String(index));
  const known = new Set(names);
  for (const name of parts.keys()) {
    if (!known.has(name)) throw new InputError(say("parts_out_of_order", { name }));
  }
  return names.map((name) => parts.get(name));
}

/**
 * @param {any} node
 * @returns {any}
 */
function plainOf(node) {
  if (Array.isArray(node)) return node.map(plainOf);
  if (!(node instanceof Map)) return node;
  return Object.fromEntries([...node].map(([key, value]) => [key, plainOf(value)]));
}

/**
 * `plane.mu=0.5&start.speed=3.1`, in the order of the keys.
 * @param {Record<string, any>} data
 */
export function queryText(data) {
  return leaves(data, "")
    .map(([path, value]) => `${path}=${valueText(path, value)}`)
    .join("&");
}

/**
 * @param {any} node
 * @param {string} path
 * @returns {[string, any][]}
 */
function leaves(node, path) {
  if (node === null || typeof node !== "object") return [[path, node]];
  return Object.entries(node).flatMap(([key, child]) => leaves(child, path ? `${path}.${key}` : key));
}

/**
 * @param {string} path
 * @param {any} value
 */
function valueText(path, value) {
  return writtenValue(path, value).replace("e+", "e").replace(/\.0$/, "");
}

/**
 * A value of a scenario as Python writes it: whole numbers without a point.
 * @param {string} path
 * @param {any} value
 */
export function writtenValue(path, value) {
  if (typeof value === "string") return value;
  return WHOLE.has(path.slice(path.lastIndexOf(".") + 1)) ? String(value) : floatText(value);
}

/** Names of the fields that are whole numbers. @type {Set<string>} */
const WHOLE = new Set(
  Object.values(tables.scenario.models).flatMap(({ fields }) =>
    Object.keys(fields).filter((name) => fields[name].kind === "whole"),
  ),
);
