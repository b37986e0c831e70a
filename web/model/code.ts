// A scenario as a TOML file and as the Python that computes its motion.

import { writtenValue } from "./query.ts";
import { equal, toDict, usualKeys } from "./scenario.ts";
import { tables } from "./tables.ts";
import { pythonText } from "./text.ts";

const { scenario: knowledge } = tables;
const COMMENT = 30; // column of a unit

function unitOf(section: string, key: string): string {
  for (const model of knowledge.sections[section] ?? ["Scenario"]) {
    const field = knowledge.models[model].fields[key];
    if (field) return field.unit;
  }
  return "";
}

function tomlValue(path: string, value: any) {
  if (value === "inf") return "inf";
  return typeof value === "string" ? JSON.stringify(value) : writtenValue(path, value);
}

function tomlLine(key: string, value: any, unit: string) {
  const line = `${key} = ${tomlValue(key, value)}`;
  return unit === "" || unit === "1" ? line : `${line.padEnd(COMMENT)} # ${unit}`;
}

/** The scenario as a TOML file with units as comments, as Python's `Scenario.to_toml`. */
export function toToml(checked: Checked) {
  const { duration, ...sections } = toDict(checked);
  const lines = [tomlLine("duration", duration, unitOf("", "duration"))];
  for (const [section, table] of Object.entries(sections)) {
    lines.push("", `[${section}]`);
    for (const [key, value] of Object.entries(table)) {
      if (!Array.isArray(value)) lines.push(tomlLine(key, value, unitOf(section, key)));
      else {
        lines.push(`${key} = [`);
        for (const part of value) {
          const inner = Object.entries(part).map(([name, one]) => `${name} = ${tomlValue(name, one)}`);
          lines.push(`  { ${inner.join(", ")} },`);
        }
        lines.push("]");
      }
    }
  }
  return `${lines.join("\n")}\n`;
}

/** Names of the classes. */
const CLASSES: Record<string, string> = { hoop: "Hoop", plane: "Plane", start: "Start" };
const USED = ["load_fraction", "mu"]; // what a reader will want to change is written out also where it is as usual

/** Python that makes the same motion; its variable `motion` is the Trajectory. */
export function pythonCode(checked: Checked) {
  const keys = toDict(checked);
  const contact = equal(keys.contact, knowledge.default.contact)
    ? ""
    : `    contact=${call("contact", keys.contact)},\n`;
  return [
    "import hophoop as hh\n\n",
    "motion = hh.simulate(\n",
    `    ${call("hoop", keys.hoop)},\n`,
    `    ${call("plane", keys.plane)},\n`,
    `    ${call("start", keys.start)},\n`,
    `    duration=${argument("duration", keys.duration)},\n`,
    contact,
    ")\n",
    "print(motion.sequence, motion.status)\n",
    "for event in motion.events:\n",
    '    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")\n',
  ].join("");
}

function call(section: string, { parts, ...keys }: Record<string, any>) {
  const rolling = section === "start" && "speed" in keys;
  const name = rolling ? "Start.rolling" : (CLASSES[section] ?? (keys.model === "rigid" ? "Rigid" : "Compliant"));
  const usual = rolling ? { angle: 0, x: 0 } : usualKeys(section, keys.model);
  const found = Object.entries(keys)
    .filter(([key, value]) => USED.includes(key) || (usual as any)[key] !== value)
    .map(([key, value]) => `${key}=${argument(key, value)}`);
  if (parts) found.push(`parts=[${parts.map(partCall).join(", ")}]`);
  return `hh.${name}(${found.join(", ")})`;
}

function partCall({ shape, ...keys }: Record<string, any>) {
  const found = Object.entries(keys).map(([key, value]) => `${key}=${argument(key, value)}`);
  return `hh.${knowledge.parts[shape]}(${found.join(", ")})`;
}

function argument(key: string, value: any) {
  if (value === "inf") return 'float("inf")';
  return typeof value === "string" ? pythonText(value) : writtenValue(key, value);
}
