// A table of keys checked against a model of Python's, field by field: values, or what is wrong with them.

import { number, tables } from "./tables.ts";
import { listed, Refused, spoken } from "../words/texts.ts";
import { general, shortened, shown, written } from "./text.ts";

const { texts, scenario } = tables;
/** Farther from a known key is not meant by it: letters to take away, to add or to change. */
const MOST_WRONG = 2;

/** Bad input, said in one sentence. */
export class InputError extends Refused {
  name = "InputError";
}

/** A sentence of Python's, with its values. */
export const say = (name: string, values: Named = {}): Phrase => ({
  key: `refusal.${name}`,
  values: written(texts[name], values),
});

export const isTable = (value: any) => value !== null && typeof value === "object" && !Array.isArray(value);

/** What is wrong with one value. `name`: of what would be allowed. */
export const finding = (path: string, value: any, name: string, values?: Named) =>
  say("finding", { path: path || say("whole_scenario"), shown: shown(value), allowed: say(name, values) });

/** The fields of a model, or null where something is wrong with them. `found`: sentences about what is wrong. */
export function readFields(model: string, data: any, path: string, found: Phrase[]) {
  const { fields, place } = scenario.models[model];
  const said = isTable(data) ? unknownKey(place, data, Object.keys(fields)) : finding(path, data, "table");
  if (said) found.push(said);
  if (said) return null;
  const before = found.length;
  const values: Named = {};
  for (const [name, field] of Object.entries(fields)) {
    if (Object.hasOwn(data, name)) values[name] = readValue(field, data[name], `${path}.${name}`, found);
    else if (field.required) found.push(say("missing", { path: `${path}.${name}` }));
    else values[name] = number(field.default);
  }
  return found.length === before ? { values, given: new Set(Object.keys(data)) } : null;
}

/** The first key that is not known, in a sentence. */
export function unknownKey(place: string, data: object, known: string[]) {
  const key = Object.keys(data).find((one) => !known.includes(one));
  if (key === undefined) return null;
  const [close] = [...known].sort((a, b) => distance(key, a) - distance(key, b));
  const hint =
    distance(key, close) <= MOST_WRONG
      ? say("did_you_mean", { close: place + close })
      : say("known_are", { known: known.join(", ") });
  return say("unknown_key", { path: `${place}${shortened(key)}`, hint });
}

/** How many letters differ between two words. */
function distance(one: string, other: string) {
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

export function readValue(field: FieldTable, value: any, path: string, found: Phrase[]): any {
  if (value === null && field.nullable) return null;
  if (field.kind === "parts") return readParts(value, path, found);
  const given = field.kind === "friction" && value === "inf" ? Infinity : value;
  const wrong = refusal(field, given);
  if (wrong) found.push(finding(path, value, ...wrong));
  return typeof given === "number" ? given + 0 : given; // no −0
}

/** Returns the sentence of what is allowed. */
function refusal({ kind, unit, options = [], range }: FieldTable, value: any): [name: string, values?: any] | null {
  if (kind === "word") return options.includes(value) ? null : ["literal_error", { expected: oneOf(options) }];
  if (typeof value !== "number") return ["number"];
  if (kind === "whole" && !Number.isInteger(value)) return ["whole"];
  if (kind !== "friction" && !Number.isFinite(value)) return ["finite_number"];
  return range && !holds(range, value) ? ["range", { words: rangeText({ ...range, unit }) }] : null;
}

/** A range in words. */
export function rangeText({ least, most, unit = "", also = [] }: RangeTable): Phrase {
  const name = `${also.includes(0) ? "zero_or_" : ""}from_to${also.includes("inf") ? "_or_inf" : ""}`;
  const ending = unit && unit !== "1" ? ` ${unit}` : "";
  return { key: `range.${name}`, values: { least: general(least), most: `${general(most)}${ending}` } };
}

/** One of several words. */
function oneOf(words: string[]): Message {
  const quoted = words.map((word) => `'${word}'`);
  if (quoted.length === 1) return quoted;
  return { key: "list.or", values: { some: listed(quoted.slice(0, -1)), last: quoted[quoted.length - 1] } };
}

export const holds = ({ least, most, also = [] }: RangeTable, value: number) =>
  (least <= value && value <= most) || also.some((one) => number(one) === value);

function readParts(value: any, path: string, found: Phrase[]) {
  if (!Array.isArray(value)) found.push(finding(path, value, "list"));
  else return value.map((part, index) => readPart(part, `${path}.${index}`, found));
}

function readPart(part: any, path: string, found: Phrase[]) {
  const model = modelOf(part, "shape", scenario.parts, path, found);
  const read = model && readFields(model, part, path, found);
  if (!read) return null;
  const { inner_radius: inner, outer_radius: outer } = read.values;
  if (inner > outer) found.push(say("ring_radii", { inner, outer }));
  return read.values;
}

/** Which of several models a table is. `models`: by word; `usual`: where the key is missing. */
export function modelOf(data: any, key: string, models: Named<string>, path: string, found: Phrase[], usual?: string) {
  const word = isTable(data) && Object.hasOwn(data, key) ? data[key] : usual;
  if (!isTable(data)) found.push(finding(path, data, "table"));
  else if (word === undefined) found.push(say("missing", { path: `${path}.${key}` }));
  else if (typeof word === "string" && Object.hasOwn(models, word)) return models[word];
  else {
    found.push(finding(`${path}.${key}`, word, "literal_error", { expected: oneOf(Object.keys(models)) }));
  }
  return null;
}

/** The one sentence of all that was found. */
export function whole(said: Phrase[]): Phrase {
  const count = said.length - 1;
  if (!count) return said[0];
  const first = () => spoken(said[0]).replace(/[.。]$/, "");
  return { key: "refusal.other_problems", values: { first, count } };
}
