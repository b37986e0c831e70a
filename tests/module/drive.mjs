// Runs the page's own kernel in Node: cells of scenarios in, motions and films as JSON out.
import { readFileSync } from "node:fs";

const [script, binary, file] = process.argv.slice(2);
const { HoopModule } = await import(script);
const module = new HoopModule(await WebAssembly.compile(readFileSync(binary)));
const asked = JSON.parse(readFileSync(file, "utf8"), (_, value) => (value === "inf" ? Infinity : value));
const found = asked.map((given) => {
  const { motion, columns } = module.film(given);
  return {
    motion,
    columns: Object.fromEntries(Object.entries(columns).map(([name, column]) => [name, [...column]])),
    chosen: given.contact && module.chosen(given),
  };
});
console.log(JSON.stringify(found, (_, value) => (Number.isNaN(value) ? "nan" : value === Infinity ? "inf" : value)));
