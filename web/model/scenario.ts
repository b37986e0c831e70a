// A scenario from a dictionary, a link or changes to another, checked as Python checks it, and written as keys and links.

import { finding, InputError, isTable, modelOf, readFields, readValue, unknownKey, whole } from "./check.ts";
import { given, stateOf } from "./given.ts";
import { replaced } from "./paths.ts";
import { queryText, readQuery } from "./query.ts";
import { broken, COMPLETE } from "./rules.ts";
import { tables } from "./tables.ts";

const { scenario: knowledge } = tables;
/** Numbers of a plane that are not written where they have their default. */
const leftOut: Named<number> = knowledge.left_out;
const CONTACTS = { rigid: "Rigid", compliant: "Compliant" };

/** Check the keys of a scenario. `keys`: as in a scenario file; numbers in SI units. */
export function fromDict(keys: any, mechanics: Mechanics): Checked {
  const { fields, place } = knowledge.models.Scenario;
  const wrong = isTable(keys) ? unknownKey(place, keys, Object.keys(fields)) : finding("", keys, "table");
  if (wrong) throw new InputError(wrong);
  const found: Phrase[] = [];
  const sections = Object.keys(fields).map((name) => {
    const data = Object.hasOwn(keys, name) ? keys[name] : knowledge.default[name];
    return [name, readSection(name, data, mechanics, found)];
  });
  const checked = Object.fromEntries(sections) as any;
  const said = found.length ? whole(found) : broken(given(checked), checked, mechanics);
  if (said) throw new InputError(said);
  return checked;
}

/** One section of a scenario by itself, or its duration. `found`: sentences about what is wrong. */
function readSection(name: string, data: any, mechanics: Mechanics, found: Phrase[]): any {
  if (name === "duration") return readValue(knowledge.models.Scenario.fields[name], data, name, found);
  const [model] =
    name === "contact" ? [modelOf(data, "model", CONTACTS, name, found, "rigid")] : knowledge.sections[name];
  const read = model ? readFields(model, data, name, found) : null;
  const said = read && COMPLETE[name](read.values, read.given, mechanics);
  if (said) found.push(said);
  return read?.values;
}

export const fromQuery = (query: string, mechanics: Mechanics) => fromDict(readQuery(query), mechanics);

/** The same scenario but for some parameters, as Python's `with_values`. `values`: by path. */
export const withValues = (checked: Checked, values: Map<string, any>, mechanics: Mechanics) =>
  fromDict(keysWith(checked, values, mechanics), mechanics);

/** `values`: by path. */
function keysWith(checked: Checked, values: Map<string, any>, mechanics: Mechanics) {
  return replaced(checked, toDict(checked), values, (keys) => {
    const found: Phrase[] = [];
    const hoop = readSection("hoop", keys, mechanics, found);
    if (found.length) throw new InputError(whole(found));
    return hoop;
  });
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
  const found: Phrase[] = [];
  try {
    const keys = keysWith(checked, values, mechanics);
    const names = new Set([...values.keys()].map((path) => path.split(".")[0]));
    const sections = [...names].map((name) => [name, readSection(name, keys[name], mechanics, found)]);
    return found.length ? null : Object.fromEntries(sections);
  } catch (error) {
    if (error instanceof InputError) return null;
    throw error;
  }
}

// --- written -----------------------------------------------------------------------------------

const written = (values: Named, names: string[]) =>
  Object.fromEntries(
    names
      .filter((name) => values[name] !== null)
      .map((name) => [name, values[name] === Infinity ? "inf" : values[name]]),
  );

const namesOf = (model: string) => Object.keys(knowledge.models[model].fields);

/** The keys of a scenario, as Python's `Scenario.to_dict`. */
export function toDict({ duration, hoop, plane, start, contact }: Checked): Scenario {
  const unwritten = plane.mu === null ? ["mu"] : ["mu_static", "mu_kinetic"];
  const usual = (name: string) => name in leftOut && (plane as any)[name] === leftOut[name];
  const goesOn = stateOf(start, hoop.radius).slip === start.slip;
  const free = ["x", "height", "angle", "vx", "vy", "omega", ...(goesOn ? ["slip", "mode"] : [])];
  return {
    duration,
    hoop: hoopKeys(hoop),
    plane: written(
      plane,
      namesOf("Plane").filter((name) => !unwritten.includes(name) && !usual(name)),
    ),
    start: written(start, start.speed === null ? free : ["x", "angle", "speed"]),
    contact: written(contact, namesOf(CONTACTS[contact.model])),
  };
}

function hoopKeys(hoop: CheckedHoop) {
  if (hoop.parts) {
    const parts = hoop.parts.map((part) => written(part, namesOf(knowledge.parts[part.shape])));
    return { radius: hoop.radius, parts: parts as Part[] };
  }
  const ways = hoop.load_fraction === null ? ["eccentricity", "inertia_ratio"] : ["load_fraction"];
  return written(hoop, ["radius", "mass", ...ways]);
}

/** What a section is where nothing is said of it. `model`: of a contact. */
export function usualKeys(name: string, model?: string): Named {
  if (name === "hoop" || name === "plane") return knowledge.default[name];
  const { fields } = knowledge.models[name === "start" ? "Start" : model === "compliant" ? "Compliant" : "Rigid"];
  return Object.fromEntries(Object.entries<any>(fields).map(([key, field]) => [key, field.default ?? undefined]));
}

/** The scenario as the query of a link, as Python's `Scenario.to_query`. */
export function toQuery(checked: Checked) {
  const brief: Named = {};
  for (const [name, value] of Object.entries(toDict(checked))) {
    if (equal(value, knowledge.default[name])) continue;
    const bare = isTable(value) ? usualKeys(name, value.model) : {};
    const entries = Object.entries(value).filter(([key, item]) => key === "model" || !equal(bare[key], item));
    // a section left out altogether would be read as the usual one
    brief[name] = isTable(value) && entries.length ? Object.fromEntries(entries) : value;
  }
  return queryText(brief);
}

export const equal = (one: any, other: any) => JSON.stringify(one) === JSON.stringify(other);
