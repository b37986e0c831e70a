// The query of a link, read and written.

import { InputError, isTable, say } from "./check.ts";
import { numberOf, numberText } from "./text.ts";

const MOST_FIELDS = 1000;

/** The nested keys of a query. */
export function readQuery(query: string): Named {
  const text = query.replace(/^\?/, "");
  if (text.split("&").length > MOST_FIELDS) {
    throw new InputError(say("unreadable_query", { reason: "Max number of fields exceeded" }));
  }
  const data = bare();
  // of a second question mark URLSearchParams would take another one off
  for (const [path, value] of new URLSearchParams(`&${text}`)) {
    const steps = path.split(".");
    const last = steps.pop() as string;
    let node = data;
    for (const step of steps) {
      node[step] ??= bare();
      node = node[step];
      if (typeof node !== "object")
        throw new InputError(say("value_above", { path, above: path.replace(/\.[^.]*$/, "") }));
    }
    if (last in node) throw new InputError(say("given_twice", { path }));
    node[last] = numberOf(value) ?? value;
  }
  const parts = data.hoop?.parts;
  if (isTable(parts)) data.hoop.parts = numbered(parts);
  return data;
}

/** Without a prototype: a link may name its keys as it likes. */
const bare = (): Named => Object.create(null);

function numbered(parts: Named) {
  const names = Object.keys(parts).map((_, index) => String(index));
  const other = Object.keys(parts).find((name) => !names.includes(name));
  if (other !== undefined) throw new InputError(say("parts_out_of_order", { name: other }));
  return names.map((name) => parts[name]);
}

/** `plane.mu=0.5&start.speed=3.1`, in the order of the keys. */
export function queryText(node: any, path = ""): string {
  if (typeof node === "string") return `${path}=${node}`;
  if (typeof node === "number") return `${path}=${numberText(node).replace("e+", "e")}`;
  return Object.entries(node)
    .map(([key, child]) => queryText(child, path ? `${path}.${key}` : key))
    .join("&");
}
