// Parameters by dotted path: other values in place of some, as Python's `with_replaced`.

import { InputError, isTable, say } from "./check.ts";
import { stateOf } from "./given.ts";
import { tables } from "./tables.ts";

/** Keys that a path replaces. */
const ENDS: Map<string, string[]> = new Map(Object.entries(tables.scenario.ends));

/** Returns section, and what stands behind its dot. */
function split(path: string): [string, string] {
  const [section, ...rest] = path.split(".");
  return [section, rest.join(".")];
}

/** Two of some paths that say the same thing in two ways. */
export function contradiction(known: string[]): [string, string] | null {
  for (const path of known) {
    const ended = (ENDS.get(path) ?? []).map((key) => `${split(path)[0]}.${key}`);
    const other = known.find((one) => ended.some((end) => one === end || one.startsWith(`${end}.`)));
    if (other !== undefined) return [path, other];
  }
  return null;
}

/**
 * Where a value comes in the order of replacements: a start that is spelt out needs the new hoop; wholes come before
 * parts.
 */
function rank(path: string) {
  const [section, rest] = split(path);
  const depth = rest === "" ? 0 : path === "contact.model" || path === "hoop.parts" ? 1 : 2;
  return (section === "start" ? 10 : 0) + depth;
}

/**
 * Keys of a scenario with other values at some paths, ready to be checked. `data`: its keys, which are changed;
 * `values`: by path; `read`: a section by itself.
 */
export function replaced(
  checked: Checked,
  data: Record<string, any>,
  values: Map<string, any>,
  read: (section: string, keys: any) => any,
) {
  const paths = [...values.keys()];
  const pair = contradiction(paths);
  if (pair) {
    const [one, other] = pair;
    throw new InputError(say("two_ways", { one, other, one_value: values.get(one), other_value: values.get(other) }));
  }
  const spelt = new Set();
  for (const path of paths.sort((a, b) => rank(a) - rank(b))) {
    const value = structuredClone(values.get(path));
    const [section, rest] = split(path);
    if (rest === "") put(data, section, value);
    else if (path === "contact.model") data.contact = { model: value };
    else {
      if (!Object.hasOwn(data, section)) put(data, section, {});
      const table = data[section];
      if (!isTable(table)) throw new InputError(say("no_section_parts", { path, section }));
      const ended = ENDS.get(path) ?? [];
      if (!spelt.has(section) && ended.some((key) => Object.hasOwn(table, key))) {
        spelt.add(section);
        // as it was before single values in it are replaced
        const given = values.has(section) ? read(section, values.get(section)) : (checked as any)[section];
        const other = speltOut(given, path, () => read("hoop", data.hoop));
        for (const [key, one] of Object.entries(other)) if (!values.has(`${section}.${key}`)) table[key] = one;
      }
      for (const key of ended) delete table[key];
      putAt(table, rest.split("."), value, path);
    }
  }
  return data;
}

/** A key of its own, whatever its name. */
const put = (table: any, key: string, value: any) =>
  Object.defineProperty(table, key, { value, enumerable: true, configurable: true, writable: true });

/** The same section given the other way, where that keeps what the path does not name. `given`: the section. */
function speltOut(given: any, path: string, hoopToBe: () => CheckedHoop): Record<string, any> {
  const { mass, eccentricity, inertia_ratio, mu_static, mu_kinetic } = given;
  if (path === "hoop.load_fraction") return { mass };
  if (path === "hoop.eccentricity" || path === "hoop.inertia_ratio") return { mass, eccentricity, inertia_ratio };
  if (path === "plane.mu_static" || path === "plane.mu_kinetic") return { mu_static, mu_kinetic };
  if (!path.startsWith("start.") || path === "start.speed") return {};
  // a rolling start, as the free one of the hoop as it will be
  const { height, vx, vy, omega } = stateOf(given, hoopToBe().radius);
  return { height, vx, vy, omega };
}

function putAt(table: any, steps: string[], value: any, path: string) {
  let node = table;
  for (const [k, step] of steps.entries()) {
    const last = k === steps.length - 1;
    const inList = Array.isArray(node) && /^\d+$/.test(step) && Number(step) < node.length;
    if (!inList && !(isTable(node) && (last || Object.hasOwn(node, step)))) {
      throw new InputError(say("not_there", { path, step }));
    }
    if (last) put(node, step, value);
    else node = node[step];
  }
}
