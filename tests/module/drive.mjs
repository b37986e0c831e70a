// Runs the page's own kernel in Node: cells of scenarios in, events as JSON out.
import { readFileSync } from "node:fs";
import { createHash } from "node:crypto";

const [script, binary, file] = process.argv.slice(2);
const { HoopModule } = await import(script);
const module = new HoopModule(await WebAssembly.compile(readFileSync(binary)));
const asked = JSON.parse(readFileSync(file, "utf8"), (_, value) => (value === "inf" ? Infinity : value));
const hash = createHash("sha256");
const found = asked.map((given) => {
  const { motion, columns } = module.film(given);
  if (!given.contact) hash.update(module.compute(given).rows);
  return {
    motion,
    columns: Object.fromEntries(Object.entries(columns).map(([name, column]) => [name, [...column]])),
    thresholds: module.thresholds(given),
    chosen: given.contact && module.chosen(given),
  };
});
const time = performance.now();
const many = 2000;
for (let k = 0; k < many; k++) module.compute(asked[0]);
console.log(JSON.stringify({ found, hash: hash.digest("hex"), microseconds: ((performance.now() - time) / many) * 1e3 },
  (_, value) => (Number.isNaN(value) ? "nan" : value === Infinity ? "inf" : value)));
