// A table of keys checked against a model of Python's, field by field: values, or what is wrong with them.

import { number, tables } from "./tables.js";
import { fill, plain, shortened, shown } from "./text.js";

const { texts, scenario } = tables;
/** Farther from a known key is not meant by it: letters to take away, to add or to change. */
const MOST_WRONG = 2;

/** Bad input, said in one sentence. */
export class InputError extends Error {
  /** @param {string} message */
  constructor(message) {
    super(plain(message));
    this.name = "InputError";
  }
}

/** The request is valid, but asks for more than the lab computes at a time. */
export class TooMuch extends InputError {}

/**
 * A sentence of Python's, filled.
 * @param {string} name
 * @param {Record<string, any>} [values]
 */
export const say = (name, values = {}) => fill(texts[name], values);

/** @param {any} value */
export const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);

/**
 * What is wrong with one value.
 * @param {string} path
 * @param {any} value
 * @param {string} name of what would be allowed
 * @param {Record<string, any>} [values]
 */
export const finding = (path, value, name, values) =>
  say("finding", { path: path || texts.whole_scenario, shown: shown(value), allowed: say(name, values) });

/**
 * The fields of a model, or null where something is wrong with them.
 * @param {string} model
 * @param {any} data
 * @param {string} path
 * @param {string[]} found sentences about what is wrong
 * @returns {{ values: Record<string, any>, given: Set<string> } | null}
 */
export function readFields(model, data, path, found) {
  const { fields, place } = scenario.models[model];
  const said = isTable(data) ? unknownKey(place, data, Object.keys(fields)) : finding(path, data, "table");
  if (said) found.push(said);
  if (said) return null;
  const before = found.length;
  /** @type {Record<string, any>} */
  const values = {};
  for (const [name, field] of Object.entries(fields)) {
    if (Object.hasOwn(data, name)) values[name] = readValue(field, data[name], `${path}.${name}`, found);
    else if (field.required) found.push(say("missing", { path: `${path}.${name}` }));
    else values[name] = number(field.default);
  }
  return found.length === before ? { values, given: new Set(Object.keys(data)) } : null;
}

/**
 * The first key that is not known, in a sentence.
 * @param {string} place
 * @param {object} data
 * @param {string[]} known
 */
export function unknownKey(place, data, known) {
  const key = Object.keys(data).find((one) => !known.includes(one));
  if (key === undefined) return null;
  const [close] = known.toSorted((a, b) => distance(key, a) - distance(key, b));
  const near = distance(key, close) <= MOST_WRONG;
  const hint = near ? say("did_you_mean", { close }) : say("known_are", { known: known.join(", ") });
  return say("unknown_key", { path: `${place}${shortened(key)}`, hint });
}

/**
 * How many letters differ between two words.
 * @param {string} one
 * @param {string} other
 */
function distance(one, other) {
  let row = Array.from({ length: other.length + 1 }, (_, k) => k);
  for (const [i, letter] of [...one].entries()) {
    const next = [i + 1];
    for (let k = 0; k < other.length; k++) {
      next.push(Math.min(next[k] + 1, row[k + 1] + 1, row[k] + Number(letter !== other[k])));
    }
    row = next;
  }
  return row[other.length];
}

/**
 * @param {any} field
 * @param {any} value
 * @param {string} path
 * @param {string[]} found
 * @returns {any}
 */
export function readValue(field, value, path, found) {
  if (value === null && field.nullable) return null;
  if (field.kind === "parts") return readParts(value, path, found);
  const given = field.kind === "friction" && value === "inf" ? Infinity : value;
  const wrong = refusal(field, given);
  if (wrong) found.push(finding(path, value, ...wrong));
  return typeof given === "number" ? given + 0 : given; // no −0
}

/** @type {Record<string, (value: number, limit: number) => boolean>} */
const LIMITS = {
  greater_than: (value, limit) => value > limit,
  greater_than_equal: (value, limit) => value >= limit,
  less_than_equal: (value, limit) => value <= limit,
};

/**
 * @param {any} field
 * @param {any} value
 * @returns {[name: string, values?: any] | null} the sentence of what is allowed
 */
function refusal(field, value) {
  const { kind, options, limits = [], range } = field;
  if (kind === "word") return options.includes(value) ? null : ["literal_error", field];
  if (typeof value !== "number") return ["number"];
  if (kind === "friction" && !(value >= 0)) return ["friction"];
  if (kind === "whole" && !Number.isInteger(value)) return ["whole"];
  if (kind !== "friction" && !Number.isFinite(value)) return ["finite_number"];
  const passed = limits.find((/** @type {[string, number]} */ [name, limit]) => !LIMITS[name](value, limit));
  if (passed) return [passed[0], { limit: passed[1] }];
  return range && !holds(range, value) ? ["range", range] : null;
}

/**
 * @param {{ least: number, most: number, also?: any[] }} range
 * @param {number} value
 */
export const holds = ({ least, most, also = [] }, value) =>
  (least <= value && value <= most) || also.some((one) => number(one) === value);

/**
 * @param {any} value
 * @param {string} path
 * @param {string[]} found
 */
function readParts(value, path, found) {
  if (!Array.isArray(value)) found.push(finding(path, value, "list"));
  else return value.map((part, index) => readPart(part, `${path}.${index}`, found));
}

/**
 * @param {any} part
 * @param {string} path
 * @param {string[]} found
 */
function readPart(part, path, found) {
  const model = modelOf(part, "shape", scenario.parts, path, found);
  const read = model && readFields(model, part, path, found);
  if (!read) return null;
  const { inner_radius: inner, outer_radius: outer } = read.values;
  if (inner > outer) found.push(say("ring_radii", { inner, outer }));
  return read.values;
}

/**
 * Which of several models a table is.
 * @param {any} data
 * @param {string} key
 * @param {Record<string, string>} models by word
 * @param {string} path
 * @param {string[]} found
 * @param {string} [usual] where the key is missing
 * @returns {string | null}
 */
export function modelOf(data, key, models, path, found, usual) {
  const word = isTable(data) && Object.hasOwn(data, key) ? data[key] : usual;
  if (!isTable(data)) found.push(finding(path, data, "table"));
  else if (word === undefined) found.push(say("missing", { path: `${path}.${key}` }));
  else if (typeof word === "string" && Object.hasOwn(models, word)) return models[word];
  else {
    const expected = Object.keys(models)
      .map((name) => `'${name}'`)
      .join(" or ");
    found.push(finding(`${path}.${key}`, word, "literal_error", { expected }));
  }
  return null;
}

/**
 * The one sentence of all that was found.
 * @param {string[]} said
 */
export function whole(said) {
  const count = said.length - 1;
  if (!count) return said[0];
  return say(count === 1 ? "other_problem" : "other_problems", { first: said[0].replace(/\.$/, ""), count });
}
