// The query of a link, read and written.

import { InputError, say } from "./check.ts";
import { tables } from "./tables.ts";
import { floatOf, floatText } from "./text.ts";

const MOST_FIELDS = 1000;

/** The nested keys of a query; every number in it is one with a point. */
export function readQuery(query: string): Record<string, any> {
  const text = query.startsWith("?") ? query.slice(1) : query;
  if (text && text.split("&").length > MOST_FIELDS) {
    throw new InputError(say("unreadable_query", { reason: "Max number of fields exceeded" }));
  }
  const data: Map<string, any> = new Map();
  // of a second question mark URLSearchParams would take another one off
  for (const [path, value] of new URLSearchParams(`&${text}`)) {
    const steps = path.split(".");
    const last = steps.pop() as string;
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

function numbered(parts: Map<string, any>) {
  const names = Array.from({ length: parts.size }, (_, index) => String(index));
  const known = new Set(names);
  for (const name of parts.keys()) {
    if (!known.has(name)) throw new InputError(say("parts_out_of_order", { name }));
  }
  return names.map((name) => parts.get(name));
}

function plainOf(node: any): any {
  if (Array.isArray(node)) return node.map(plainOf);
  if (!(node instanceof Map)) return node;
  return Object.fromEntries([...node].map(([key, value]) => [key, plainOf(value)]));
}

/** `plane.mu=0.5&start.speed=3.1`, in the order of the keys. */
export function queryText(data: Record<string, any>) {
  return leaves(data, "")
    .map(([path, value]) => `${path}=${valueText(path, value)}`)
    .join("&");
}

function leaves(node: any, path: string): [string, any][] {
  if (node === null || typeof node !== "object") return [[path, node]];
  return Object.entries(node).flatMap(([key, child]) => leaves(child, path ? `${path}.${key}` : key));
}

function valueText(path: string, value: any) {
  return writtenValue(path, value).replace("e+", "e").replace(/\.0$/, "");
}

/** A value of a scenario as Python writes it: whole numbers without a point. */
export function writtenValue(path: string, value: any) {
  if (typeof value === "string") return value;
  return WHOLE.has(path.slice(path.lastIndexOf(".") + 1)) ? String(value) : floatText(value);
}

/** Names of the fields that are whole numbers. */
const WHOLE: Set<string> = new Set(
  Object.values<any>(tables.scenario.models).flatMap(({ fields }) =>
    Object.keys(fields).filter((name) => fields[name].kind === "whole"),
  ),
);
