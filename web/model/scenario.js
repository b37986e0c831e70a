// A scenario from a dictionary, a link or changes to another, checked as Python checks it, and written as keys and links.

import { finding, InputError, isTable, modelOf, readFields, readValue, unknownKey, whole } from "./check.js";
import { given } from "./given.js";
import { replaced } from "./paths.js";
import { queryText, readQuery } from "./query.js";
import { broken, COMPLETE } from "./rules.js";
import { tables } from "./tables.js";

const { scenario: knowledge } = tables;
/** Numbers of a plane that are not written where they have their default. @type {Record<string, number>} */
const leftOut = knowledge.left_out;
const CONTACTS = { rigid: "Rigid", compliant: "Compliant" };

/**
 * Check the keys of a scenario.
 * @param {any} keys as in a scenario file; numbers in SI units
 * @param {Mechanics} mechanics
 * @returns {Checked}
 */
export function fromDict(keys, mechanics) {
  const { fields, place } = knowledge.models.Scenario;
  const wrong = isTable(keys) ? unknownKey(place, keys, Object.keys(fields)) : finding("", keys, "table");
  if (wrong) throw new InputError(wrong);
  /** @type {string[]} */
  const found = [];
  const sections = Object.keys(fields).map((name) => {
    const data = Object.hasOwn(keys, name) ? keys[name] : knowledge.default[name];
    return [name, readSection(name, data, mechanics, found)];
  });
  const checked = /** @type {any} */ (Object.fromEntries(sections));
  const said = found.length ? whole(found) : broken(given(checked), checked, mechanics);
  if (said) throw new InputError(said);
  return checked;
}

/**
 * One section of a scenario by itself, or its duration.
 * @param {string} name
 * @param {any} data
 * @param {Mechanics} mechanics
 * @param {string[]} found sentences about what is wrong
 * @returns {any}
 */
function readSection(name, data, mechanics, found) {
  if (name === "duration") return readValue(knowledge.models.Scenario.fields[name], data, name, found);
  const [model] =
    name === "contact" ? [modelOf(data, "model", CONTACTS, name, found, "rigid")] : knowledge.sections[name];
  const read = model && readFields(model, data, name, found);
  const said = read && COMPLETE[name](read.values, read.given, mechanics);
  if (said) found.push(said);
  return read?.values;
}

/**
 * @param {string} query
 * @param {Mechanics} mechanics
 */
export const fromQuery = (query, mechanics) => fromDict(readQuery(query), mechanics);

/**
 * The same scenario but for some parameters, as Python's `with_values`.
 * @param {Checked} checked
 * @param {Map<string, any>} values by path
 * @param {Mechanics} mechanics
 */
export const withValues = (checked, values, mechanics) => fromDict(keysWith(checked, values, mechanics), mechanics);

/**
 * @param {Checked} checked
 * @param {Map<string, any>} values by path
 * @param {Mechanics} mechanics
 */
function keysWith(checked, values, mechanics) {
  return replaced(checked, toDict(checked), values, (name, data) => {
    /** @type {string[]} */
    const found = [];
    const one = readSection(name, data, mechanics, found);
    if (found.length) throw new InputError(whole(found));
    return one;
  });
}

/**
 * Sections with other values at some paths, whether or not they go with the others; null where they are not allowed.
 * @param {Checked} checked
 * @param {Map<string, any>} values by path
 * @param {Mechanics} mechanics
 * @returns {Partial<Checked> | null}
 */
export function sectionsWith(checked, values, mechanics) {
  /** @type {string[]} */
  const found = [];
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

/**
 * @param {Record<string, any>} values
 * @param {string[]} names
 */
const written = (values, names) =>
  Object.fromEntries(
    names
      .filter((name) => values[name] !== null)
      .map((name) => [name, values[name] === Infinity ? "inf" : values[name]]),
  );

/** @param {string} model */
const namesOf = (model) => Object.keys(knowledge.models[model].fields);

/**
 * The keys of a scenario, as Python's `Scenario.to_dict`.
 * @param {Checked} checked
 * @returns {Scenario}
 */
export function toDict({ duration, hoop, plane, start, contact }) {
  const unwritten = plane.apart ? ["mu"] : ["mu_static", "mu_kinetic"];
  const usual = (/** @type {string} */ name) => name in leftOut && /** @type {any} */ (plane)[name] === leftOut[name];
  const free = ["x", "height", "angle", "vx", "vy", "omega"];
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

/** @param {CheckedHoop} hoop */
function hoopKeys(hoop) {
  if (hoop.parts) {
    const parts = hoop.parts.map((part) => written(part, namesOf(knowledge.parts[part.shape])));
    return { radius: hoop.radius, parts: /** @type {Part[]} */ (/** @type {unknown} */ (parts)) };
  }
  const ways = hoop.load_fraction === null ? ["eccentricity", "inertia_ratio"] : ["load_fraction"];
  return written(hoop, ["radius", "mass", ...ways]);
}

/**
 * What a section is where nothing is said of it.
 * @param {string} name
 * @param {string} [model] of a contact
 * @returns {Record<string, any>}
 */
export function usualKeys(name, model) {
  if (name === "hoop" || name === "plane") return knowledge.default[name];
  const { fields } = knowledge.models[name === "start" ? "Start" : model === "compliant" ? "Compliant" : "Rigid"];
  return Object.fromEntries(Object.entries(fields).map(([key, field]) => [key, field.default ?? undefined]));
}

/**
 * The scenario as the query of a link, as Python's `Scenario.to_query`.
 * @param {Checked} checked
 */
export function toQuery(checked) {
  /** @type {Record<string, any>} */
  const brief = {};
  for (const [name, value] of Object.entries(toDict(checked))) {
    if (equal(value, knowledge.default[name])) continue;
    const bare = isTable(value) ? usualKeys(name, value.model) : {};
    const entries = Object.entries(value).filter(([key, item]) => key === "model" || !equal(bare[key], item));
    // a section left out altogether would be read as the usual one
    brief[name] = isTable(value) && entries.length ? Object.fromEntries(entries) : value;
  }
  return queryText(brief);
}

/**
 * @param {any} one
 * @param {any} other
 */
export const equal = (one, other) => JSON.stringify(one) === JSON.stringify(other);
