// A scenario from a dictionary, a link or changes to another, checked as Python checks it, and written as Python writes it.

import {
  findings,
  InputError,
  isTable,
  readFields,
  readValue,
  refuse,
  tagged,
  unknownKey,
  whole,
  type Findings,
} from "./check.ts";
import { given } from "./given.ts";
import { floats, replaced } from "./paths.ts";
import { queryText, readQuery } from "./query.ts";
import { Broken, completeContact, completeHoop, completePlane, completeStart, fitting, type Read } from "./rules.ts";
import { tables } from "./tables.ts";

const { scenario: knowledge } = tables;
/** Numbers of a plane that are not written where they have their default. */
const leftOut: Record<string, number> = knowledge.left_out;
const CONTACTS = { rigid: "Rigid", compliant: "Compliant" };

/**
 * Check the keys of a scenario. `keys`: as in a scenario file; numbers in SI units; `found`: how numbers are shown in
 * sentences.
 */
export function fromDict(keys: any, mechanics: Mechanics, found: Findings = findings()): Checked {
  const checked = read(keys, mechanics, found);
  if (!checked) throw new InputError(whole(found.said));
  return checked;
}

/** Returns null where something is wrong, which is then said in `found`. */
export function read(keys: any, mechanics: Mechanics, found: Findings): Checked | null {
  const { fields, place } = knowledge.models.Scenario;
  if (!isTable(keys)) {
    refuse(found, "", keys, "table");
    return null;
  }
  const unknown = Object.keys(keys).find((key) => !Object.hasOwn(fields, key));
  if (unknown !== undefined) {
    found.said.push(unknownKey(place, unknown, Object.keys(fields)));
    return null;
  }
  const checked = Object.fromEntries(
    Object.keys(fields).map((name) => {
      const data = Object.hasOwn(keys, name) ? keys[name] : knowledge.default[name];
      return [name, readSection(name, data, mechanics, found)];
    }),
  );
  return found.said.length ? null : kept(found, () => fitted(checked as any, mechanics));
}

/** One section of a scenario by itself, or its duration. */
function readSection(name: string, data: any, mechanics: Mechanics, found: Findings) {
  if (name === "hoop") return section("Hoop", data, name, found, (one) => completeHoop(one, mechanics));
  if (name === "plane") return section("Plane", data, name, found, completePlane);
  if (name === "start") return section("Start", data, name, found, completeStart);
  if (name !== "contact") return readValue(knowledge.models.Scenario.fields[name], data, name, found);
  const model = tagged(data, "model", CONTACTS, name, found, "rigid");
  return model && section(model, data, name, found, completeContact);
}

/** A scenario whose sections go together; throws what they break. */
export function fitted(checked: Checked, mechanics: Mechanics) {
  fitting(checked, mechanics, given);
  return checked;
}

function section<T>(model: string, data: any, path: string, found: Findings, complete: (read: Read) => T) {
  const fields = readFields(model, data, path, found);
  return fields && kept(found, () => complete(fields));
}

function kept<T>(found: Findings, make: () => T) {
  try {
    return make();
  } catch (error) {
    if (!(error instanceof Broken)) throw error;
    found.said.push(error.said);
    return null;
  }
}

export function fromQuery(query: string, mechanics: Mechanics) {
  return fromDict(
    readQuery(query),
    mechanics,
    findings(() => true),
  );
}

/** The same scenario but for some parameters, as Python's `with_values`. `values`: by path. */
export function withValues(checked: Checked, values: Map<string, any>, mechanics: Mechanics) {
  const keys = replaced(checked, toDict(checked), values, (name, data, float) =>
    readAlone(name, data, mechanics, float),
  );
  return fromDict(keys, mechanics, findings(floats([...values.keys()])));
}

/**
 * Sections with other values at some paths, whether or not they go with the others; null where they are not allowed.
 * `values`: by path.
 */
export function sectionsWith(
  checked: Checked,
  values: Map<string, any>,
  mechanics: Mechanics,
): Partial<Checked> | null {
  const found = findings();
  try {
    const keys = replaced(checked, toDict(checked), values, (name, data, float) =>
      readAlone(name, data, mechanics, float),
    );
    const names = new Set([...values.keys()].map((path) => path.split(".")[0]));
    const sections = [...names].map((name) => [name, readSection(name, keys[name], mechanics, found)]);
    return found.said.length ? null : Object.fromEntries(sections);
  } catch (error) {
    if (error instanceof InputError) return null;
    throw error;
  }
}

/** A section by itself; throws what is wrong with it. */
function readAlone(name: string, data: any, mechanics: Mechanics, float: (path: string) => boolean) {
  const found = findings(float);
  const one = readSection(name, data, mechanics, found);
  if (found.said.length) throw new InputError(whole(found.said));
  return one;
}

// --- written -----------------------------------------------------------------------------------

const plainValue = (value: any) => (value === Infinity ? "inf" : value);

const written = (values: Record<string, any>, names: string[]) =>
  Object.fromEntries(names.filter((name) => values[name] !== null).map((name) => [name, plainValue(values[name])]));

const namesOf = (model: string) => Object.keys(knowledge.models[model].fields);

/** The keys of a scenario, as Python's `Scenario.to_dict`. */
export function toDict({ duration, hoop, plane, start, contact }: Checked): Scenario {
  return {
    duration,
    hoop: hoopKeys(hoop),
    plane: planeKeys(plane),
    start: startKeys(start),
    contact: written(contact, namesOf(contact.model === "rigid" ? "Rigid" : "Compliant")),
  };
}

function hoopKeys(hoop: CheckedHoop) {
  if (hoop.parts) {
    const parts = hoop.parts.map((part) => written(part, namesOf(knowledge.parts[part.shape])));
    return { radius: hoop.radius, parts: parts as unknown as Part[] };
  }
  const ways = hoop.load_fraction === null ? ["eccentricity", "inertia_ratio"] : ["load_fraction"];
  return written(hoop, ["radius", "mass", ...ways]);
}

function planeKeys(plane: CheckedPlane) {
  const out = plane.apart ? ["mu"] : ["mu_static", "mu_kinetic"];
  const numbers: Record<string, any> = plane;
  out.push(...Object.keys(leftOut).filter((name) => numbers[name] === leftOut[name]));
  return written(
    plane,
    namesOf("Plane").filter((name) => !out.includes(name)),
  );
}

function startKeys(start: CheckedStart) {
  return written(start, start.speed === null ? ["x", "height", "angle", "vx", "vy", "omega"] : ["x", "angle", "speed"]);
}

/** What a model is where nothing is said of it. `name`: of the section; `model`: of a contact. */
export function usualKeys(name: string, model?: string): Record<string, any> {
  const { Hoop, Start } = knowledge.models;
  if (name === "hoop") {
    const { radius, mass, eccentricity } = Hoop.fields;
    return { radius: radius.default, mass: mass.default, load_fraction: eccentricity.default };
  }
  if (name === "plane") return knowledge.default.plane;
  if (name === "start") return { ...defaults(Start), speed: undefined };
  return defaults(knowledge.models[model === "compliant" ? "Compliant" : "Rigid"]);
}

const defaults = ({ fields }: any) =>
  Object.fromEntries(Object.entries<any>(fields).map(([name, field]) => [name, field.default ?? undefined]));

/** The scenario as the query of a link, as Python's `Scenario.to_query`. */
export function toQuery(checked: Checked) {
  const brief: Record<string, any> = {};
  for (const [name, value] of Object.entries(toDict(checked))) {
    const usual = knowledge.default[name];
    if (equal(value, usual)) continue;
    if (!isTable(value)) {
      brief[name] = value;
      continue;
    }
    const bare = usualKeys(name, (value as any).model);
    const entries = Object.entries(value).filter(([key, item]) => key === "model" || !equal(bare[key], item));
    // a section left out altogether would be read as the usual one
    brief[name] = entries.length ? Object.fromEntries(entries) : value;
  }
  return queryText(brief);
}

export function equal(one: any, other: any): boolean {
  if (one === other) return true;
  if (one === null || other === null || typeof one !== "object" || typeof other !== "object") return false;
  const keys = Object.keys(one);
  return keys.length === Object.keys(other).length && keys.every((key) => equal(one[key], other[key]));
}
