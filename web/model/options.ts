// What is asked for besides a scenario: windows, axes and a quantity, each refused in Python's own sentence.

import { readFields, refuse, refuseAs, say, unknownKey, type Findings } from "./check.ts";
import { labText } from "./limits.ts";
import { isNumberPath, unknownPath } from "./paths.ts";
import { tables } from "./tables.ts";

const { calls, regions, map } = tables;

export type Reader = (value: any, name: string, found: Findings) => any;

const OPTIONS: Record<string, Record<string, { read: Reader; usual?: any }>> = {
  samples: { window: { read: readTimes } },
  regions: { window: { read: readWindow, usual: regions.usual } },
  map: { x: { read: readAxis }, y: { read: readAxis }, what: { read: readQuantity, usual: "sequence" } },
};

/** A key that a call does not take, in a sentence. */
export function strange(name: string, body: Record<string, any>): Phrase | null {
  const takes = calls[name];
  const other = Object.keys(body).find((key) => !takes.includes(key));
  return other === undefined ? null : unknownKey("", other, takes);
}

/** `name`: of the call. */
export function readOptions(name: string, body: Record<string, any>, found: Findings): Record<string, any> {
  const options: Record<string, any> = {};
  for (const [key, { read, usual }] of Object.entries(OPTIONS[name] ?? {})) {
    if (Object.hasOwn(body, key)) options[key] = read(body[key], key, found);
    else if (usual === undefined) found.said.push(say("missing", { path: key }));
    else options[key] = usual;
  }
  return options;
}

/** So many numbers. */
function readNumbers(value: any, name: string, found: Findings, count: number, allowed: Phrase) {
  if (!Array.isArray(value) || value.length !== count) return refuseAs(found, name, value, allowed);
  const before = found.said.length;
  value.forEach((one, place) => {
    if (typeof one !== "number") refuse(found, `${name}.${place}`, one, "number");
    else if (!Number.isFinite(one)) refuse(found, `${name}.${place}`, one, "finite_number");
  });
  return found.said.length === before ? value : null;
}

function readTimes(value: any, name: string, found: Findings) {
  const times = readNumbers(value, name, found, 2, labText("times"));
  if (times && !(times[0] >= 0 && times[0] < times[1])) refuseAs(found, name, value, labText("times"));
  return times;
}

function readWindow(value: any, name: string, found: Findings) {
  const window = readNumbers(value, name, found, 4, labText("window"));
  if (!window) return null;
  const [left, right, bottom, top] = window;
  const small = window.every((one: number) => Math.abs(one) < regions.widest);
  if (!(left < right && bottom < top && small)) refuseAs(found, name, value, labText("window"));
  return window;
}

function readAxis(value: any, name: string, found: Findings) {
  return readFields("Axis", value, name, found, { number_path: readPath })?.values ?? null;
}

function readPath(path: any, name: string, found: Findings) {
  if (typeof path !== "string") return refuse(found, name, path, "word");
  const unknown = unknownPath(path);
  if (unknown) found.said.push(unknown);
  else if (!isNumberPath(path)) refuseAs(found, name, path, labText("number_path"));
  return path;
}

function readQuantity(what: any, name: string, found: Findings) {
  if (typeof what !== "string") return refuse(found, name, what, "word");
  const known = Object.keys(map.quantities);
  if (!known.includes(what)) refuseAs(found, name, what, labText("one_of", { known: known.join(", ") }));
  return what;
}
