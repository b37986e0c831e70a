// What a map asks for besides a scenario: axes and a quantity, each refused in Python's own sentence.

import { readFields, refuse, refuseAs } from "./check.js";
import { labText } from "./limits.js";
import { isNumberPath, unknownPath } from "./paths.js";
import { tables } from "./tables.js";

const { map } = tables;

/** @typedef {import("./check.js").Findings} Findings */
/** @typedef {(value: any, name: string, found: Findings) => any} Reader */

/**
 * @param {Record<string, any>} body
 * @param {Findings} found
 * @returns {{ x: any, y: any, what: string }}
 */
export function readMap({ x, y, what = "sequence" }, found) {
  return { x: readAxis(x, "x", found), y: readAxis(y, "y", found), what: readQuantity(what, "what", found) };
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
