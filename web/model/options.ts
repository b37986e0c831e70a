// What a map asks for besides a scenario: axes and a quantity, each refused in Python's own sentence.

import { readFields, refuse, refuseAs, type Findings } from "./check.ts";
import { labText } from "./limits.ts";
import { isNumberPath, unknownPath } from "./paths.ts";
import { tables } from "./tables.ts";

const { map } = tables;

export type Reader = (value: any, name: string, found: Findings) => any;

export function readMap(
  { x, y, what = "sequence" }: Record<string, any>,
  found: Findings,
): { x: any; y: any; what: string } {
  return { x: readAxis(x, "x", found), y: readAxis(y, "y", found), what: readQuantity(what, "what", found) as string };
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
