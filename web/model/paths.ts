// Parameters by dotted path, such as plane.mu: other values in place of some, as Python's `with_replaced`.

import { stateOf } from "./given.ts";
import { tables } from "./tables.ts";

/** Keys that a path replaces. */
const ENDS = tables.scenario.ends;

/** Two of some paths that say the same thing in two ways. */
export function contradiction(known: string[]) {
  for (const path of known) {
    const ended = (ENDS[path] ?? []).map((key) => path.replace(/\..*/, `.${key}`));
    const other = known.find((one) => ended.includes(one));
    if (other !== undefined) return [path, other];
  }
  return null;
}

/** The order of replacements: a contact before its numbers, and a start, which may need the new hoop, at the end. */
const rank = (path: string) => (path === "contact.model" ? 0 : path.startsWith("start.") ? 2 : 1);

/**
 * Keys of a scenario with other values at some paths, ready to be checked. `data`: its keys, which are changed;
 * `values`: by path, of which no two contradict each other; `hoopOf`: reads the keys of a hoop.
 */
export function replaced(checked: Checked, data: Named, values: Map<string, any>, hoopOf: (keys: any) => CheckedHoop) {
  const spelt = new Set();
  for (const path of [...values.keys()].sort((a, b) => rank(a) - rank(b))) {
    const value = structuredClone(values.get(path));
    const [section, name] = path.split(".");
    if (name === undefined) data[section] = value;
    else if (path === "contact.model") data.contact = { model: value };
    else {
      const table = data[section];
      const ended = ENDS[path] ?? [];
      if (!spelt.has(section) && ended.some((key) => Object.hasOwn(table, key))) {
        spelt.add(section);
        const other = speltOut((checked as any)[section], path, () => hoopOf(data.hoop));
        for (const [key, one] of Object.entries(other)) if (!values.has(`${section}.${key}`)) table[key] = one;
      }
      for (const key of ended) delete table[key];
      table[name] = value;
    }
  }
  return data;
}

/** The same section given the other way, where that keeps what the path does not name. `given`: the section. */
function speltOut(given: any, path: string, hoopToBe: () => CheckedHoop): Named {
  const { mass, eccentricity, inertia_ratio, mu_static, mu_kinetic } = given;
  if (path === "hoop.load_fraction") return { mass };
  if (path === "hoop.eccentricity" || path === "hoop.inertia_ratio") return { mass, eccentricity, inertia_ratio };
  if (path === "plane.mu_static" || path === "plane.mu_kinetic") return { mu_static, mu_kinetic };
  if (!path.startsWith("start.") || path === "start.speed") return {};
  // a rolling start, as the free one of the hoop as it will be
  const { height, vx, vy, omega } = stateOf(given, hoopToBe().radius);
  return { height, vx, vy, omega };
}
