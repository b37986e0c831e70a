// What ties the fields of a scenario together: Python's validators of hoop, plane, start and contact.

import { Refused } from "../words/texts.js";
import { holds, rangeText, say } from "./check.js";
import { number, tables } from "./tables.js";

const { scenario } = tables;
const WAYS = ["load_fraction", "eccentricity", "inertia_ratio"];
const FRICTIONS = ["mu_static", "mu_kinetic"];
const FREE = ["height", "vx", "vy", "omega"];

/** A rule that is broken. */
export class Broken extends Refused {}

/**
 * @param {string} name
 * @param {Record<string, any>} [values]
 * @returns {never}
 */
function broken(name, values) {
  throw new Broken(say(name, values));
}

/**
 * @param {string} section
 * @param {string} way
 * @param {string[]} given
 */
function alone(section, way, given) {
  const other = given.find((name) => name !== way);
  if (other) broken("together", { section, other, way });
}

/** @typedef {{ values: Record<string, any>, given: Set<string> }} Read */

/**
 * @param {Read} read
 * @param {Mechanics} mechanics
 * @returns {CheckedHoop}
 */
export function completeHoop({ values, given }, mechanics) {
  const hoop = /** @type {any} */ ({ ...values });
  const named = WAYS.filter((name) => given.has(name) && values[name] !== null);
  if (hoop.parts !== null) {
    if (!hoop.parts.length) broken("no_parts");
    alone("hoop", "parts", [...named, ...(given.has("mass") ? ["mass"] : [])]);
    Object.assign(hoop, combined(hoop.radius, hoop.parts, mechanics));
  } else if (hoop.load_fraction !== null || !named.length) {
    alone("hoop", "load_fraction", named);
    // the fraction of a hoop of which nothing is said is its usual eccentricity
    hoop.load_fraction ??= scenario.models.Hoop.fields.eccentricity.default;
    hoop.eccentricity = hoop.load_fraction;
    hoop.inertia_ratio = mechanics.ideal(hoop.load_fraction);
  } else if (named.length === 1) {
    broken("half_a_hoop", {
      missing: named[0] === "eccentricity" ? "inertia_ratio" : "eccentricity",
      given: named[0],
    });
  }
  const { mass, inertia_ratio, load_fraction, eccentricity } = hoop;
  const ranges = scenario.ranges;
  if (!holds(ranges["hoop.mass"], mass)) broken("hoop_mass", { mass, words: rangeText(ranges["hoop.mass"]) });
  if (!holds(ranges["hoop.inertia_ratio"], inertia_ratio)) {
    const words = rangeText(ranges["hoop.inertia_ratio"]);
    broken(hoop.parts ? "parts_inertia" : "load_inertia", { load_fraction, inertia_ratio, words });
  }
  if (inertia_ratio === 0 && eccentricity !== 1) broken("massless_eccentricity", { eccentricity });
  return hoop;
}

/**
 * @param {number} radius
 * @param {WholePart[]} parts
 * @param {Mechanics} mechanics
 */
function combined(radius, parts, mechanics) {
  const { reaches, ...sums } = mechanics.combine(radius, parts);
  const index = reaches.findIndex((reach) => reach > radius * (1 + scenario.touch));
  if (index >= 0) broken("beyond_the_rim", { index, shape: parts[index].shape, reach: reaches[index], radius });
  return sums;
}

/**
 * @param {Read} read
 * @returns {CheckedPlane}
 */
export function completePlane({ values, given }) {
  const plane = /** @type {any} */ ({ ...values });
  plane.apart = FRICTIONS.some((name) => given.has(name));
  if (plane.mu !== null) {
    alone(
      "plane",
      "mu",
      FRICTIONS.filter((name) => given.has(name)),
    );
    plane.mu_static = plane.mu;
    plane.mu_kinetic = plane.mu;
  } else if (plane.mu_static === plane.mu_kinetic) plane.mu = plane.mu_static;
  const { mu_static, mu_kinetic, slope } = plane;
  if (mu_kinetic > mu_static) broken("kinetic_above_static", { mu_kinetic, mu_static });
  if (!(Math.abs(slope) < 0.5 * Math.PI)) broken("vertical", { slope });
  const range = scenario.ranges["plane.slope"];
  if (!holds(range, slope)) broken("slope", { slope, words: rangeText(range) });
  return plane;
}

/**
 * @param {Read} read
 * @returns {CheckedStart}
 */
export function completeStart({ values, given }) {
  const start = /** @type {any} */ ({ ...values });
  if (start.speed !== null) {
    alone(
      "start",
      "speed",
      FREE.filter((name) => given.has(name)),
    );
    start.vx = start.speed;
    start.omega = null;
  } else if (start.omega === null) broken("no_omega");
  return start;
}

/**
 * @param {Read} read
 * @returns {CheckedContact}
 */
export function completeContact({ values }) {
  const contact = /** @type {any} */ (values);
  if (contact.model === "compliant" && contact.damping !== null && contact.restitution !== null) {
    broken("together", { section: "contact", other: "restitution", way: "damping" });
  }
  return contact;
}

/**
 * What a hoop, a plane, a start and a contact must be to each other.
 * @param {Checked} checked
 * @param {Mechanics} mechanics
 * @param {(checked: Checked) => Given} given
 */
export function fitting(checked, mechanics, given) {
  const { hoop, plane, contact } = checked;
  const massless = hoop.inertia_ratio === 0;
  const compliant = contact.model === "compliant";
  if (massless && plane.slope !== 0) broken("massless_slope", { slope: plane.slope });
  const resistance = plane.rolling_resistance;
  if (resistance !== 0 && massless) broken("massless_resistance", { given: resistance });
  const most = resistance === 0 ? undefined : mechanics.resistance?.(hoop.eccentricity, hoop.inertia_ratio);
  if (most !== undefined && !(resistance < most)) broken("resistance", { given: resistance, most });
  if (massless && compliant) broken("massless_compliant");
  if (compliant && plane.mu_static === Infinity) broken("compliant_friction");
  if (compliant && mechanics.compliance) fittingContact(contact, mechanics.compliance(given(checked)));
}

/**
 * @param {CheckedContact} contact
 * @param {Compliance} compliance
 */
function fittingContact(contact, compliance) {
  for (const [name, { of: unit, ...range }] of Object.entries(scenario.relative)) {
    const value = contact[name];
    if (value === null) continue;
    const relative = /** @type {any} */ (compliance)[name];
    if (!holds(range, relative)) broken("relative_contact", { name, value, relative, unit, words: rangeText(range) });
  }
  const { depth } = compliance;
  const most = number(scenario.most_depth);
  // Python says None where the stiffness is the usual one
  if (depth > most) broken("too_soft", { stiffness: contact.stiffness, depth, most });
}
