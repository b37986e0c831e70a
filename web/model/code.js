// A scenario as a TOML file and as the Python that computes its motion.

import { equal, toDict, usualKeys } from "./scenario.js";
import { tables } from "./tables.js";
import { floatText } from "./text.js";

const { scenario: knowledge } = tables;
const COMMENT = 30; // column of a unit
/** Of all fields by name: their units and kinds do not depend on the model. @type {Record<string, any>} */
const FIELDS = {};
for (const { fields } of Object.values(knowledge.models)) Object.assign(FIELDS, fields);

/**
 * @param {string} key
 * @param {any} value
 */
function valueText(key, value) {
  if (typeof value === "string") return JSON.stringify(value);
  return FIELDS[key]?.kind === "whole" ? String(value) : floatText(value);
}

/**
 * @param {string} section
 * @param {string} key
 * @param {any} value
 */
function tomlLine(section, key, value) {
  if (Array.isArray(value)) {
    const pairs = (/** @type {object} */ part) =>
      Object.entries(part).map(([name, one]) => `${name} = ${tomlValue(name, one)}`);
    return [`${key} = [`, ...value.map((part) => `  { ${pairs(part).join(", ")} },`), "]"].join("\n");
  }
  const line = `${key} = ${tomlValue(key, value)}`;
  const fields = (knowledge.sections[section] ?? ["Scenario"]).map(
    (/** @type {string} */ name) => knowledge.models[name].fields,
  );
  const unit = fields.find((/** @type {any} */ one) => key in one)[key].unit;
  return unit === "" || unit === "1" ? line : `${line.padEnd(COMMENT)} # ${unit}`;
}

/**
 * @param {string} key
 * @param {any} value
 */
const tomlValue = (key, value) => (value === "inf" ? "inf" : valueText(key, value));

/**
 * The scenario as a TOML file with units as comments, as Python's `Scenario.to_toml`.
 * @param {Checked} checked
 */
export function toToml(checked) {
  const { duration, ...sections } = toDict(checked);
  const lines = [tomlLine("", "duration", duration)];
  for (const [section, table] of Object.entries(sections)) {
    lines.push("", `[${section}]`, ...Object.entries(table).map(([key, value]) => tomlLine(section, key, value)));
  }
  return `${lines.join("\n")}\n`;
}

/** Names of the classes. @type {Record<string, string>} */
const CLASSES = { hoop: "Hoop", plane: "Plane", start: "Start" };
const USED = ["load_fraction", "mu"]; // what a reader will want to change is written out also where it is as usual

/**
 * Python that makes the same motion; its variable `motion` is the Trajectory.
 * @param {Checked} checked
 */
export function pythonCode(checked) {
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

/**
 * @param {string} section
 * @param {Record<string, any>} keys
 */
function sectionCall(section, { parts, ...keys }) {
  const rolling = section === "start" && "speed" in keys;
  const name = rolling ? "Start.rolling" : (CLASSES[section] ?? (keys.model === "rigid" ? "Rigid" : "Compliant"));
  const usual = rolling ? { angle: 0, x: 0 } : usualKeys(section, keys.model);
  const told = Object.entries(keys).filter(
    ([key, value]) => USED.includes(key) || /** @type {any} */ (usual)[key] !== value,
  );
  const more = parts ? [`parts=[${parts.map(partCall).join(", ")}]`] : [];
  return `hh.${name}(${[...told.map(argument), ...more].join(", ")})`;
}

/** @param {Record<string, any>} part */
const partCall = ({ shape, ...keys }) =>
  `hh.${knowledge.parts[shape]}(${Object.entries(keys).map(argument).join(", ")})`;

/** @param {[string, any]} pair */
const argument = ([key, value]) => `${key}=${value === "inf" ? 'float("inf")' : valueText(key, value)}`;
