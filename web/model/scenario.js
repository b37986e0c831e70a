// A scenario from a dictionary, a link or changes to another, checked as Python checks it, and written as Python writes it.

import { findings, InputError, isTable, readFields, readValue, refuse, tagged, unknownKey, whole } from "./check.js";
import { given } from "./given.js";
import { floats, replaced } from "./paths.js";
import { queryText, readQuery } from "./query.js";
import { Broken, completeContact, completeHoop, completePlane, completeStart, fitting } from "./rules.js";
import { tables } from "./tables.js";

const { scenario: knowledge } = tables;
/** Numbers of a plane that are not written where they have their default. @type {Record<string, number>} */
const leftOut = knowledge.left_out;
const CONTACTS = { rigid: "Rigid", compliant: "Compliant" };

/**
 * Check the keys of a scenario.
 * @param {any} keys as in a scenario file; numbers in SI units
 * @param {Mechanics} mechanics
 * @param {import("./check.js").Findings} [found] how numbers are shown in sentences
 * @returns {Checked}
 */
export function fromDict(keys, mechanics, found = findings()) {
  const checked = read(keys, mechanics, found);
  if (!checked) throw new InputError(whole(found.said));
  return checked;
}

/**
 * @param {any} keys
 * @param {Mechanics} mechanics
 * @param {import("./check.js").Findings} found
 * @returns {Checked | null} null where something is wrong, which is then said in `found`
 */
export function read(keys, mechanics, found) {
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
  return found.said.length ? null : kept(found, () => fitted(/** @type {any} */ (checked), mechanics));
}

/**
 * One section of a scenario by itself, or its duration.
 * @param {string} name
 * @param {any} data
 * @param {Mechanics} mechanics
 * @param {import("./check.js").Findings} found
 */
function readSection(name, data, mechanics, found) {
  if (name === "hoop") return section("Hoop", data, name, found, (one) => completeHoop(one, mechanics));
  if (name === "plane") return section("Plane", data, name, found, completePlane);
  if (name === "start") return section("Start", data, name, found, completeStart);
  if (name !== "contact") return readValue(knowledge.models.Scenario.fields[name], data, name, found);
  const model = tagged(data, "model", CONTACTS, name, found, "rigid");
  return model && section(model, data, name, found, completeContact);
}

/**
 * A scenario whose sections go together; throws what they break.
 * @param {Checked} checked
 * @param {Mechanics} mechanics
 */
export function fitted(checked, mechanics) {
  fitting(checked, mechanics, given);
  return checked;
}

/**
 * @template T
 * @param {string} model
 * @param {any} data
 * @param {string} path
 * @param {import("./check.js").Findings} found
 * @param {(read: import("./rules.js").Read) => T} complete
 */
function section(model, data, path, found, complete) {
  const fields = readFields(model, data, path, found);
  return fields && kept(found, () => complete(fields));
}

/**
 * @template T
 * @param {import("./check.js").Findings} found
 * @param {() => T} make
 */
function kept(found, make) {
  try {
    return make();
  } catch (error) {
    if (!(error instanceof Broken)) throw error;
    found.said.push(error.said);
    return null;
  }
}

/**
 * @param {string} query
 * @param {Mechanics} mechanics
 */
export function fromQuery(query, mechanics) {
  return fromDict(
    readQuery(query),
    mechanics,
    findings(() => true),
  );
}

/**
 * The same scenario but for some parameters, as Python's `with_values`.
 * @param {Checked} checked
 * @param {Map<string, any>} values by path
 * @param {Mechanics} mechanics
 */
export function withValues(checked, values, mechanics) {
  const keys = replaced(checked, toDict(checked), values, (name, data, float) =>
    readAlone(name, data, mechanics, float),
  );
  return fromDict(keys, mechanics, findings(floats([...values.keys()])));
}

/**
 * Sections with other values at some paths, whether or not they go with the others; null where they are not allowed.
 * @param {Checked} checked
 * @param {Map<string, any>} values by path
 * @param {Mechanics} mechanics
 * @returns {Partial<Checked> | null}
 */
export function sectionsWith(checked, values, mechanics) {
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

/**
 * A section by itself; throws what is wrong with it.
 * @param {string} name
 * @param {any} data
 * @param {Mechanics} mechanics
 * @param {(path: string) => boolean} float
 */
function readAlone(name, data, mechanics, float) {
  const found = findings(float);
  const one = readSection(name, data, mechanics, found);
  if (found.said.length) throw new InputError(whole(found.said));
  return one;
}

// --- written -----------------------------------------------------------------------------------

/** @param {any} value */
const plainValue = (value) => (value === Infinity ? "inf" : value);

/**
 * @param {Record<string, any>} values
 * @param {string[]} names
 */
const written = (values, names) =>
  Object.fromEntries(names.filter((name) => values[name] !== null).map((name) => [name, plainValue(values[name])]));

/** @param {string} model */
const namesOf = (model) => Object.keys(knowledge.models[model].fields);

/**
 * The keys of a scenario, as Python's `Scenario.to_dict`.
 * @param {Checked} checked
 * @returns {Scenario}
 */
export function toDict({ duration, hoop, plane, start, contact }) {
  return {
    duration,
    hoop: hoopKeys(hoop),
    plane: planeKeys(plane),
    start: startKeys(start),
    contact: written(contact, namesOf(contact.model === "rigid" ? "Rigid" : "Compliant")),
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

/** @param {CheckedPlane} plane */
function planeKeys(plane) {
  const out = plane.apart ? ["mu"] : ["mu_static", "mu_kinetic"];
  /** @type {Record<string, any>} */
  const numbers = plane;
  out.push(...Object.keys(leftOut).filter((name) => numbers[name] === leftOut[name]));
  return written(
    plane,
    namesOf("Plane").filter((name) => !out.includes(name)),
  );
}

/** @param {CheckedStart} start */
function startKeys(start) {
  return written(start, start.speed === null ? ["x", "height", "angle", "vx", "vy", "omega"] : ["x", "angle", "speed"]);
}

/**
 * What a model is where nothing is said of it.
 * @param {string} name of the section
 * @param {string} [model] of a contact
 * @returns {Record<string, any>}
 */
export function usualKeys(name, model) {
  const { Hoop, Start } = knowledge.models;
  if (name === "hoop") {
    const { radius, mass, eccentricity } = Hoop.fields;
    return { radius: radius.default, mass: mass.default, load_fraction: eccentricity.default };
  }
  if (name === "plane") return knowledge.default.plane;
  if (name === "start") return { ...defaults(Start), speed: undefined };
  return defaults(knowledge.models[model === "compliant" ? "Compliant" : "Rigid"]);
}

/** @param {any} model */
const defaults = ({ fields }) =>
  Object.fromEntries(Object.entries(fields).map(([name, field]) => [name, field.default ?? undefined]));

/**
 * The scenario as the query of a link, as Python's `Scenario.to_query`.
 * @param {Checked} checked
 */
export function toQuery(checked) {
  /** @type {Record<string, any>} */
  const brief = {};
  for (const [name, value] of Object.entries(toDict(checked))) {
    const usual = knowledge.default[name];
    if (equal(value, usual)) continue;
    if (!isTable(value)) {
      brief[name] = value;
      continue;
    }
    const bare = usualKeys(name, /** @type {any} */ (value).model);
    const entries = Object.entries(value).filter(([key, item]) => key === "model" || !equal(bare[key], item));
    // a section left out altogether would be read as the usual one
    brief[name] = entries.length ? Object.fromEntries(entries) : value;
  }
  return queryText(brief);
}

/**
 * @param {any} one
 * @param {any} other
 * @returns {boolean}
 */
export function equal(one, other) {
  if (one === other) return true;
  if (one === null || other === null || typeof one !== "object" || typeof other !== "object") return false;
  const keys = Object.keys(one);
  return keys.length === Object.keys(other).length && keys.every((key) => equal(one[key], other[key]));
}
