// Parameters by dotted path: other values in place of some, as Python's `with_replaced`.

import { InputError, isTable, say } from "./check.ts";
import { stateOf } from "./given.ts";
import { tables } from "./tables.ts";
import { pythonText, Shown } from "./text.ts";

const ENDS: Record<string, string[]> = tables.scenario.ends;
const ends = (path: string) => (Object.hasOwn(ENDS, path) ? ENDS[path] : []);

/** Returns section, and what stands behind its dot. */
function split(path: string): [string, string] {
  const dot = path.indexOf(".");
  return dot < 0 ? [path, ""] : [path.slice(0, dot), path.slice(dot + 1)];
}

/** Two of some paths that say the same thing in two ways. */
export function contradiction(known: string[]): [string, string] | null {
  for (const path of known) {
    const [section] = split(path);
    const ended = ends(path).map((key) => `${section}.${key}`);
    for (const other of known) {
      if (ended.some((end) => other === end || other.startsWith(`${end}.`))) return [path, other];
    }
  }
  return null;
}

/** What the page's own numbers may be called. */
const PATHS: Set<string> = new Set(tables.scenario.paths);

const WORDS: Set<string> = new Set(tables.map.words);
const PART = /^hoop\.parts\.\d+\.(\w+)$/;

/** Fields of a hoop's parts, by name. */
const PART_FIELDS: Record<string, { kind: string }> = Object.assign(
  Object.create(null),
  ...Object.values(tables.scenario.parts).map((name: any) => tables.scenario.models[name].fields),
);

/** A path that no scenario has, in a sentence. */
export function unknownPath(path: string): Phrase | null {
  if (PATHS.has(path) || (PART.exec(path)?.[1] ?? "") in PART_FIELDS) return null;
  return say("no_parameter", { path, known: [...PATHS].join(", ") });
}

/** Whether what stands at a known path is a number. */
export function isNumberPath(path: string) {
  const part = PART.exec(path);
  return part ? PART_FIELDS[part[1]].kind !== "word" : !WORDS.has(path);
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
 * Whether the number at a path is one of a scenario, which has a point, and not one that is just given. `given`:
 * paths.
 */
export const floats =
  (given: string[]): ((path: string) => boolean) =>
  (path) =>
    !given.some((one) => path === one || path.startsWith(one.endsWith(".") ? one : `${one}.`));

/**
 * Keys of a scenario with other values at some paths, ready to be checked. `data`: its keys, which are changed;
 * `values`: by path; `read`: a section by itself.
 */
export function replaced(
  checked: Checked,
  data: Record<string, any>,
  values: Map<string, any>,
  read: (section: string, keys: any, float: (path: string) => boolean) => any,
) {
  const paths = [...values.keys()];
  const pair = contradiction(paths);
  if (pair) {
    const [one, other] = pair;
    const [first, second] = pair.map((path) => new Shown(pythonText(values.get(path), false)));
    throw new InputError(say("two_ways", { one, other, one_value: first, other_value: second }));
  }
  const spelt = new Set();
  const float = floats(paths);
  for (const path of paths.sort((a, b) => rank(a) - rank(b))) {
    const value = structuredClone(values.get(path));
    const [section, rest] = split(path);
    if (rest === "") put(data, section, value);
    else if (path === "contact.model") data.contact = { model: value };
    else {
      if (!Object.hasOwn(data, section)) put(data, section, {});
      const table = data[section];
      if (!isTable(table)) throw new InputError(say("no_section_parts", { path, section }));
      if (!spelt.has(section) && ends(path).some((key) => Object.hasOwn(table, key))) {
        spelt.add(section);
        // as it was before single values in it are replaced
        const given = values.has(section) ? read(section, values.get(section), float) : (checked as any)[section];
        const other = speltOut(given, path, () => read("hoop", data.hoop, float));
        for (const [key, one] of Object.entries(other)) if (!values.has(`${section}.${key}`)) table[key] = one;
      }
      for (const key of ends(path)) delete table[key];
      putAt(table, rest.split("."), value, path);
    }
  }
  return data;
}

function put(table: any, key: string, value: any) {
  Object.defineProperty(table, key, { value, enumerable: true, configurable: true, writable: true });
}

/** The same section given the other way, where that keeps what the path does not name. `given`: the section. */
function speltOut(given: any, path: string, hoopToBe: () => CheckedHoop): Record<string, any> {
  const { mass, eccentricity, inertia_ratio } = given;
  if (path === "hoop.eccentricity" || path === "hoop.inertia_ratio") return { mass, eccentricity, inertia_ratio };
  if (path === "hoop.load_fraction") return { mass };
  if (path === "plane.mu_static" || path === "plane.mu_kinetic") {
    const written = (mu: number) => (mu === Infinity ? "inf" : mu);
    return { mu_static: written(given.mu_static), mu_kinetic: written(given.mu_kinetic) };
  }
  if (path.startsWith("start.") && path !== "start.speed") {
    // a rolling start, as the free one of the hoop as it will be
    const { height, vx, vy, omega } = stateOf(given, hoopToBe().radius);
    return { height, vx, vy, omega };
  }
  return {};
}

function putAt(table: any, steps: string[], value: any, path: string) {
  let node = table;
  const last = steps.pop() as string;
  const missing = (step: string) => new InputError(say("not_there", { path, step }));
  const inList = (step: string) => Array.isArray(node) && /^\d+$/.test(step) && Number(step) < node.length;
  for (const step of steps) {
    if (inList(step)) node = node[Number(step)];
    else if (isTable(node) && Object.hasOwn(node, step)) node = node[step];
    else throw missing(step);
  }
  if (isTable(node)) put(node, last, value);
  else if (inList(last)) node[Number(last)] = value;
  else throw missing(last);
}
