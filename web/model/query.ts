// The query of a link, read and written.

import { InputError, say } from "./check.ts";
import { numberOf, numberText } from "./text.ts";

const MOST_FIELDS = 1000;

/** The nested keys of a query. */
export function readQuery(query: string): Record<string, any> {
  const text = query.replace(/^\?/, "");
  if (text.split("&").length > MOST_FIELDS) {
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
      if (!(node instanceof Map))
        throw new InputError(say("value_above", { path, above: path.replace(/\.[^.]*$/, "") }));
    }
    if (node.has(last)) throw new InputError(say("given_twice", { path }));
    node.set(last, numberOf(value) ?? value);
  }
  const hoop = data.get("hoop");
  const parts = hoop instanceof Map && hoop.get("parts");
  if (parts instanceof Map) hoop.set("parts", numbered(parts));
  return plainOf(data);
}

function numbered(parts: Map<string, any>) {
  const names = Array.from({ length: parts.size }, (_, index) => String(index));
  const other = [...parts.keys()].find((name) => !names.includes(name));
  if (other !== undefined) throw new InputError(say("parts_out_of_order", { name: other }));
  return names.map((name) => parts.get(name));
}

function plainOf(node: any): any {
  if (Array.isArray(node)) return node.map(plainOf);
  if (!(node instanceof Map)) return node;
  return Object.fromEntries([...node].map(([key, value]) => [key, plainOf(value)]));
}

/** `plane.mu=0.5&start.speed=3.1`, in the order of the keys. */
export function queryText(node: any, path = ""): string {
  if (typeof node === "string") return `${path}=${node}`;
  if (typeof node === "number") return `${path}=${numberText(node).replace("e+", "e")}`;
  return Object.entries(node)
    .map(([key, child]) => queryText(child, path ? `${path}.${key}` : key))
    .join("&");
}
