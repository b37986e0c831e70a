// What ties the fields of a scenario together: in which ways they can be given; the kernel has the rules between numbers.

import { say } from "./check.js";
import { tables } from "./tables.js";

const { scenario } = tables;
/** By the kernel's codes. @type {(null | { sentence: string, values: Record<string, string>, known: any, number: string })[]} */
const RULES = scenario.rules;
const WAYS = ["load_fraction", "eccentricity", "inertia_ratio"];
const FRICTIONS = ["mu_static", "mu_kinetic"];
const FREE = ["height", "vx", "vy", "omega"];
/** Numbers beside which a hoop or a plane breaks only rules of its own. */
const ALONE = { mass: 1, inertia_ratio: 1, contact: null };

/**
 * The first rule that numbers break, in a sentence.
 * @param {any} given
 * @param {any} sections that the sentence may speak of
 * @param {Mechanics} mechanics
 * @returns {string | null}
 */
export function broken(given, sections, mechanics) {
  const [code, number] = mechanics.refused(given);
  const rule = RULES[code];
  if (!rule) return null;
  const values = Object.entries(rule.values).map(([name, path]) => {
    const [section, field] = path.split(".");
    return [name, sections[section][field]];
  });
  return say(rule.sentence, { ...rule.known, ...Object.fromEntries(values), [rule.number]: number });
}

/**
 * @param {string} section
 * @param {string} way
 * @param {Set<string>} given
 * @param {string[]} others
 */
function together(section, way, given, others) {
  const other = others.find((name) => given.has(name));
  return other ? say("together", { section, other, way }) : null;
}

/**
 * Complete the values of a section; what is wrong with them is said in a sentence.
 * @type {Record<string, (values: any, given: Set<string>, mechanics: Mechanics) => string | null>}
 */
export const COMPLETE = { hoop: completeHoop, plane: completePlane, start: completeStart, contact: completeContact };

/**
 * @param {CheckedHoop} hoop
 * @param {Set<string>} given
 * @param {Mechanics} mechanics
 */
function completeHoop(hoop, given, mechanics) {
  const named = WAYS.filter((name) => given.has(name) && /** @type {any} */ (hoop)[name] !== null);
  if (hoop.parts) {
    const said = hoop.parts.length ? together("hoop", "parts", given, [...named, "mass"]) : say("no_parts");
    if (said) return said;
    const { radius, parts } = hoop;
    const { reaches, ...sums } = mechanics.combine(radius, parts);
    const index = reaches.findIndex((reach) => reach > radius * (1 + scenario.touch));
    if (index >= 0) return say("beyond_the_rim", { index, shape: parts[index].shape, reach: reaches[index], radius });
    Object.assign(hoop, sums);
  } else if (hoop.load_fraction !== null || !named.length) {
    const said = together("hoop", "load_fraction", given, named.slice(Number(hoop.load_fraction !== null)));
    if (said) return said;
    // the fraction of a hoop of which nothing is said is its usual eccentricity
    hoop.load_fraction ??= /** @type {number} */ (scenario.models.Hoop.fields.eccentricity.default);
    hoop.eccentricity = hoop.load_fraction;
    hoop.inertia_ratio = mechanics.ideal(hoop.load_fraction);
  } else if (named.length === 1) {
    const missing = named[0] === "eccentricity" ? "inertia_ratio" : "eccentricity";
    return say("half_a_hoop", { missing, given: named[0] });
  }
  return broken({ ...ALONE, ...hoop, ideal: hoop.load_fraction !== null }, { hoop }, mechanics);
}

/**
 * @param {CheckedPlane} plane
 * @param {Set<string>} given
 * @param {Mechanics} mechanics
 */
function completePlane(plane, given, mechanics) {
  plane.apart = FRICTIONS.some((name) => given.has(name));
  if (plane.mu !== null) {
    const said = together("plane", "mu", given, FRICTIONS);
    if (said) return said;
    plane.mu_static = plane.mu_kinetic = plane.mu;
  } else if (plane.mu_static === plane.mu_kinetic) plane.mu = plane.mu_static;
  return broken({ ...ALONE, ...plane }, { plane }, mechanics);
}

/**
 * @param {CheckedStart} start
 * @param {Set<string>} given
 */
function completeStart(start, given) {
  if (start.speed === null) return start.omega === null ? say("no_omega") : null;
  start.vx = start.speed;
  start.omega = null;
  return together("start", "speed", given, FREE);
}

/** @param {CheckedContact} contact */
function completeContact({ damping = null, restitution = null }) {
  const both = damping !== null && restitution !== null;
  return both ? say("together", { section: "contact", other: "restitution", way: "damping" }) : null;
}
