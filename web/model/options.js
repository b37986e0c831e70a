// What is asked for besides a scenario: windows, axes and a quantity, each refused in Python's own sentence.

import { readFields, refuse, refuseAs, say, unknownKey } from "./check.js";
import { labText } from "./limits.js";
import { isNumberPath, unknownPath } from "./paths.js";
import { tables } from "./tables.js";

const { calls, regions, map } = tables;

/** @typedef {import("./check.js").Findings} Findings */
/** @typedef {(value: any, name: string, found: Findings) => any} Reader */

/** @type {Record<string, Record<string, { read: Reader, usual?: any }>>} */
const OPTIONS = {
  samples: { window: { read: readTimes } },
  regions: { window: { read: readWindow, usual: regions.usual } },
  map: { x: { read: readAxis }, y: { read: readAxis }, what: { read: readQuantity, usual: "sequence" } },
};

/**
 * A key that a call does not take, in a sentence.
 * @param {string} name
 * @param {Record<string, any>} body
 * @returns {Phrase | null}
 */
export function strange(name, body) {
  const takes = calls[name];
  const other = Object.keys(body).find((key) => !takes.includes(key));
  return other === undefined ? null : unknownKey("", other, takes);
}

/**
 * @param {string} name of the call
 * @param {Record<string, any>} body
 * @param {Findings} found
 * @returns {Record<string, any>}
 */
export function readOptions(name, body, found) {
  /** @type {Record<string, any>} */
  const options = {};
  for (const [key, { read, usual }] of Object.entries(OPTIONS[name] ?? {})) {
    if (Object.hasOwn(body, key)) options[key] = read(body[key], key, found);
    else if (usual === undefined) found.said.push(say("missing", { path: key }));
    else options[key] = usual;
  }
  return options;
}

/**
 * So many numbers.
 * @param {any} value
 * @param {string} name
 * @param {Findings} found
 * @param {number} count
 * @param {Phrase} allowed
 */
function readNumbers(value, name, found, count, allowed) {
  if (!Array.isArray(value) || value.length !== count) return refuseAs(found, name, value, allowed);
  const before = found.said.length;
  value.forEach((one, place) => {
    if (typeof one !== "number") refuse(found, `${name}.${place}`, one, "number");
    else if (!Number.isFinite(one)) refuse(found, `${name}.${place}`, one, "finite_number");
  });
  return found.said.length === before ? value : null;
}

/** @type {Reader} */
function readTimes(value, name, found) {
  const times = readNumbers(value, name, found, 2, labText("times"));
  if (times && !(times[0] >= 0 && times[0] < times[1])) refuseAs(found, name, value, labText("times"));
  return times;
}

/** @type {Reader} */
function readWindow(value, name, found) {
  const window = readNumbers(value, name, found, 4, labText("window"));
  if (!window) return null;
  const [left, right, bottom, top] = window;
  const small = window.every((/** @type {number} */ one) => Math.abs(one) < regions.widest);
  if (!(left < right && bottom < top && small)) refuseAs(found, name, value, labText("window"));
  return window;
}

/** @type {Reader} */
function readAxis(value, name, found) {
  return readFields("Axis", value, name, found, { number_path: readPath })?.values ?? null;
}

/** @type {Reader} */
function readPath(path, name, found) {
  if (typeof path !== "string") return refuse(found, name, path, "word");
  const unknown = unknownPath(path);
  if (unknown) found.said.push(unknown);
  else if (!isNumberPath(path)) refuseAs(found, name, path, labText("number_path"));
  return path;
}

/** @type {Reader} */
function readQuantity(what, name, found) {
  if (typeof what !== "string") return refuse(found, name, what, "word");
  const known = Object.keys(map.quantities);
  if (!known.includes(what)) refuseAs(found, name, what, labText("one_of", { known: known.join(", ") }));
  return what;
}
