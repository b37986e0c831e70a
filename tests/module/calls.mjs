// The page's kernel in Node, as its workers have it: `node calls.mjs kernel.js module < asked > answered`. Asked and
// answered are lists in JSON, of calls with their arguments, and of what they give.

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { bits } from "./bits.mjs";

const [script, binary] = process.argv.slice(2);
const { HoopModule } = await import(pathToFileURL(script).href);
const module = new HoopModule(new WebAssembly.Module(readFileSync(binary))); // it imports nothing

const asked = JSON.parse(readFileSync(0, "utf-8"), (_, value) => (value === "inf" ? Infinity : value));
const answered = [];
for (const [call, ...given] of asked) answered.push(call === "bits" ? await bits(module, ...given) : module[call](...given));

const written = (_, value) =>
  ArrayBuffer.isView(value) ? [...value] : typeof value === "number" && !Number.isFinite(value) ? String(value) : value;
process.stdout.write(JSON.stringify(answered, written));
