// A table of keys checked against a model of Python's, field by field: values, or what is wrong with them.

import { closest } from "./close.ts";
import { number, tables } from "./tables.ts";
import { listed, Refused, spoken } from "../words/texts.ts";
import { general, pythonText, shortened, written } from "./text.ts";

const { texts, scenario } = tables;

/** Bad input, said in one sentence. */
export class InputError extends Refused {
  name = "InputError";
}

/** The request is valid, but asks for more than the lab computes at a time. */
export class TooMuch extends InputError {}

/** A sentence with its values. */
export const say = (name: string, values: Record<string, any> = {}): Phrase => ({
  key: `refusal.${name}`,
  values: written(texts[name], values),
});

export const isTable = (value: any) => value !== null && typeof value === "object" && !Array.isArray(value);

/** What was found, and how numbers were given. */
export interface Findings {
  said: Phrase[]; // one sentence each
  above: string; // path under which the scenario stands, with its dot
  float: (path: string) => boolean; // whether numbers there are always shown with a point
}

export function findings(float: (path: string) => boolean = () => false, above = "") {
  return { said: [], above, float } as Findings;
}

export function refuse(found: Findings, path: string, value: any, kind: string, values?: Record<string, any>) {
  refuseAs(found, path, value, say(kind, values));
}

/** `allowed`: what would be, in words. */
export function refuseAs(found: Findings, path: string, value: any, allowed: Phrase) {
  const shown = typeof value === "bigint" ? String(value) : pythonText(value, found.float(path));
  const where = found.above + path || say("whole_scenario");
  found.said.push(say("finding", { path: where, shown: shortened(shown), allowed }));
}

/** A range in words. */
export function rangeText({ least, most, unit = "", also = [] }: Range): Phrase {
  const name = `${also.some((one) => number(one) === 0) ? "zero_or_" : ""}from_to${also.includes("inf") ? "_or_inf" : ""}`;
  return { key: `range.${name}`, values: { least: general(least), most: `${general(most)}${unit && ` ${unit}`}` } };
}

/** One of several words. */
function oneOf(words: string[]): Said {
  const quoted = words.map((word) => `'${word}'`);
  if (quoted.length === 1) return quoted[0];
  return { key: "list.or", values: { some: listed(quoted.slice(0, -1)), last: quoted[quoted.length - 1] } };
}

/** The fields of a model, or null where something is wrong with them. `own`: readers of further kinds of fields. */
export function readFields(
  model: string,
  data: any,
  path: string,
  found: Findings,
  own: Record<string, (value: any, path: string, found: Findings) => any> = {},
): { values: Record<string, any>; given: Set<string> } | null {
  const { fields, place } = scenario.models[model];
  if (!isTable(data)) {
    refuse(found, path, data, "table");
    return null;
  }
  for (const key of Object.keys(data)) {
    if (Object.hasOwn(fields, key)) continue;
    found.said.push(unknownKey(place, key, Object.keys(fields)));
    return null;
  }
  const before = found.said.length;
  const values: Record<string, any> = {};
  for (const [name, field] of Object.entries<any>(fields)) {
    if (field.kind === "section") continue;
    const read = own[field.kind];
    if (Object.hasOwn(data, name) && read) values[name] = read(data[name], `${path}.${name}`, found);
    else if (Object.hasOwn(data, name)) values[name] = readValue(field, data[name], `${path}.${name}`, found);
    else if (field.required) found.said.push(say("missing", { path: `${found.above}${path}.${name}` }));
    else values[name] = number(field.default);
  }
  return found.said.length === before ? { values, given: new Set(Object.keys(data)) } : null;
}

export function unknownKey(place: string, key: string, known: string[]) {
  const close = closest(key, known);
  const hint = close ? say("did_you_mean", { close }) : say("known_are", { known: known.join(", ") });
  return say("unknown_key", { path: `${place}${shortened(key)}`, hint });
}

export function readValue(field: any, value: any, path: string, found: Findings): any {
  if (value === null && field.nullable) return null;
  if (field.kind === "parts") return readParts(value, path, found);
  if (field.kind === "word") {
    if (!field.options.includes(value)) refuse(found, path, value, "literal_error", { expected: oneOf(field.options) });
    return value;
  }
  const infinite = field.kind === "friction";
  const given = infinite && value === "inf" ? Infinity : value;
  if (typeof given !== "number") return refuse(found, path, value, "number");
  if (infinite && !(given >= 0)) return refuse(found, path, value, "friction");
  if (field.kind === "whole" && !Number.isInteger(given)) return refuse(found, path, value, "whole");
  if (!infinite && !Number.isFinite(given)) return refuse(found, path, value, "finite_number");
  for (const [kind, limit] of field.limits ?? []) {
    if (within(kind, given, limit)) continue;
    return refuse(found, path, field.kind === "whole" ? BigInt(given) : value, kind, { limit });
  }
  if (field.range && !holds(field.range, given))
    return refuse(found, path, value, "range", { words: rangeText(field.range) });
  return given + 0; // no −0
}

function within(kind: string, value: number, limit: number) {
  if (kind === "greater_than") return value > limit;
  if (kind === "greater_than_equal") return value >= limit;
  return kind === "less_than" ? value < limit : value <= limit;
}

export type Range = { least: number; most: number; unit?: string; also?: any[] };

export const holds = ({ least, most, also = [] }: Range, value: number) =>
  (least <= value && value <= most) || also.some((one) => number(one) === value);

function readParts(value: any, path: string, found: Findings) {
  if (!Array.isArray(value)) return refuse(found, path, value, "list");
  return value.map((part, index) => readPart(part, `${path}.${index}`, found));
}

function readPart(part: any, path: string, found: Findings) {
  const model = tagged(part, "shape", scenario.parts, path, found);
  const read = model && readFields(model, part, path, found);
  if (!read) return null;
  const { inner_radius: inner, outer_radius: outer } = read.values;
  if (inner > outer) found.said.push(say("ring_radii", { inner, outer }));
  return read.values;
}

/** Which of several models a table is. `models`: by word; `usual`: where the key is missing. */
export function tagged(
  data: any,
  key: string,
  models: Record<string, string>,
  path: string,
  found: Findings,
  usual?: string,
): string | null {
  if (!isTable(data)) {
    refuse(found, path, data, "table");
    return null;
  }
  const word = Object.hasOwn(data, key) ? data[key] : usual;
  if (word === undefined || (word === null && usual)) {
    found.said.push(say("missing", { path: `${found.above}${path}.${key}` }));
    return null;
  }
  if (typeof word === "string" && Object.hasOwn(models, word)) return models[word];
  const said = typeof word === "string" ? word : pythonText(word, found.float(`${path}.${key}`));
  const allowed = say("literal_error", { expected: oneOf(Object.keys(models)) });
  const values = { path: `${found.above}${path}.${key}`, shown: shortened(pythonText(said)), allowed };
  found.said.push(say("finding", values));
  return null;
}

/** The one sentence of all that was found. */
export function whole(said: Phrase[]): Phrase {
  const count = said.length - 1;
  if (!count) return said[0];
  const first = () => spoken(said[0]).replace(/[.。]$/, "");
  return { key: "refusal.other_problems", values: { first, count } };
}
