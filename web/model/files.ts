// Files that need no Python: the scenario, the events and the states, in the formats of the library.

import { resultOf } from "./header.ts";
import { tables } from "./tables.ts";
import { numberText, floatText } from "./text.ts";
import { equal, toDict, usualKeys } from "./scenario.ts";

const { rate, variables } = tables.table;
const { letters } = tables.words;

/** The motion as a result file. */
export const resultText = (checked: Checked, motion: ComputedMotion) =>
  JSON.stringify(resultOf(checked, motion), null, 1);

/** When a table has its rows: as Python's `motion.times`. */
export function timesOf(duration: number) {
  const count = Math.min(Math.max(Math.floor(duration * rate) + 1, 2), tables.limits.samples);
  const step = duration / (count - 1);
  return Float64Array.from({ length: count }, (_, k) => (k === count - 1 ? duration : k * step));
}

/** States over time as CSV, one row for each; the unit stands in each column's heading. */
export function tableText(times: Float64Array, samples: Samples) {
  const names = Object.keys(variables);
  const heads = names.map((name) => (variables[name] === "1" ? name : `${name} [${variables[name]}]`));
  const { kinetic, potential } = samples;
  const columns: Samples = { ...samples, total: Float64Array.from(kinetic, (energy, k) => energy + potential[k]) };
  const lines = [["t [s]", ...heads].join(",")];
  for (const [k, t] of times.entries()) {
    const row = names.map((name) => (name === "mode" ? letters[columns.mode[k]] : numberText(columns[name][k])));
    lines.push([numberText(t), ...row].join(","));
  }
  return `${lines.join("\r\n")}\r\n`;
}

// --- A scenario as a TOML file and as the Python that computes its motion

const { scenario: knowledge } = tables;
const COMMENT = 30; // column of a unit
/** Of all fields by name: their units and kinds do not depend on the model. */
const FIELDS: Named<FieldTable> = {};
for (const { fields } of Object.values(knowledge.models)) Object.assign(FIELDS, fields);

function valueText(key: string, value: any) {
  if (typeof value === "string") return JSON.stringify(value);
  return FIELDS[key]?.kind === "whole" ? String(value) : floatText(value);
}

function tomlLine(section: string, key: string, value: any) {
  if (Array.isArray(value)) {
    const pairs = (part: object) => Object.entries(part).map(([name, one]) => `${name} = ${tomlValue(name, one)}`);
    return [`${key} = [`, ...value.map((part) => `  { ${pairs(part).join(", ")} },`), "]"].join("\n");
  }
  const line = `${key} = ${tomlValue(key, value)}`;
  const fields = (knowledge.sections[section] ?? ["Scenario"]).map((name) => knowledge.models[name].fields);
  const unit = fields.find((one) => key in one)?.[key].unit ?? "";
  return unit === "" || unit === "1" ? line : `${line.padEnd(COMMENT)} # ${unit}`;
}

const tomlValue = (key: string, value: any) => (value === "inf" ? "inf" : valueText(key, value));

/** The scenario as a TOML file with units as comments, as Python's `Scenario.to_toml`. */
export function toToml(checked: Checked) {
  const { duration, ...sections } = toDict(checked);
  const lines = [tomlLine("", "duration", duration)];
  for (const [section, table] of Object.entries(sections)) {
    lines.push("", `[${section}]`, ...Object.entries(table).map(([key, value]) => tomlLine(section, key, value)));
  }
  return `${lines.join("\n")}\n`;
}

/** Names of the classes. */
const CLASSES: Named<string> = { hoop: "Hoop", plane: "Plane", start: "Start" };
const USED = ["load_fraction", "mu"]; // what a reader will want to change is written out also where it is as usual

/** Python that makes the same motion; its variable `motion` is the Trajectory. */
export function pythonCode(checked: Checked) {
  const { duration, contact, ...sections } = toDict(checked);
  const calls = Object.entries(sections).map(([name, keys]) => sectionCall(name, keys));
  if (!equal(contact, knowledge.default.contact)) calls.push(`contact=${sectionCall("contact", contact)}`);
  calls.splice(3, 0, `duration=${floatText(duration)}`);
  return `import hophoop as hh

motion = hh.simulate(
${calls.map((line) => `    ${line},\n`).join("")})
print(motion.sequence, motion.status)
for event in motion.events:
    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")
`;
}

function sectionCall(section: string, { parts, ...keys }: Named) {
  const rolling = section === "start" && "speed" in keys;
  const name = rolling ? "Start.rolling" : (CLASSES[section] ?? (keys.model === "rigid" ? "Rigid" : "Compliant"));
  const usual = rolling ? { angle: 0, x: 0 } : usualKeys(section, keys.model);
  const told = Object.entries(keys).filter(([key, value]) => USED.includes(key) || (usual as any)[key] !== value);
  const more = parts ? [`parts=[${parts.map(partCall).join(", ")}]`] : [];
  return `hh.${name}(${[...told.map(argument), ...more].join(", ")})`;
}

const partCall = ({ shape, ...keys }: Named) =>
  `hh.${knowledge.parts[shape]}(${Object.entries(keys).map(argument).join(", ")})`;

const argument = ([key, value]: [string, any]) => `${key}=${value === "inf" ? 'float("inf")' : valueText(key, value)}`;
