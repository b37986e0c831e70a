// What ties the fields of a scenario together: Python's validators of hoop, plane, start and contact.

import { Refused } from "../words/texts.ts";
import { holds, rangeText, say } from "./check.ts";
import { number, tables } from "./tables.ts";

const { scenario } = tables;
const WAYS = ["load_fraction", "eccentricity", "inertia_ratio"];
const FRICTIONS = ["mu_static", "mu_kinetic"];
const FREE = ["height", "vx", "vy", "omega"];

/** A rule that is broken. */
export class Broken extends Refused {}

function broken(name: string, values?: Record<string, any>): never {
  throw new Broken(say(name, values));
}

function alone(section: string, way: string, given: string[]) {
  const other = given.find((name) => name !== way);
  if (other) broken("together", { section, other, way });
}

export type Read = { values: Record<string, any>; given: Set<string> };

export function completeHoop({ values, given }: Read, mechanics: Mechanics): CheckedHoop {
  const hoop = { ...values } as any;
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

function combined(radius: number, parts: WholePart[], mechanics: Mechanics) {
  const { reaches, ...sums } = mechanics.combine(radius, parts);
  const index = reaches.findIndex((reach) => reach > radius * (1 + scenario.touch));
  if (index >= 0) broken("beyond_the_rim", { index, shape: parts[index].shape, reach: reaches[index], radius });
  return sums;
}

export function completePlane({ values, given }: Read): CheckedPlane {
  const plane = { ...values } as any;
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

export function completeStart({ values, given }: Read): CheckedStart {
  const start = { ...values } as any;
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

export function completeContact({ values }: Read): CheckedContact {
  const contact = values as any;
  if (contact.model === "compliant" && contact.damping !== null && contact.restitution !== null) {
    broken("together", { section: "contact", other: "restitution", way: "damping" });
  }
  return contact;
}

/** What a hoop, a plane, a start and a contact must be to each other. */
export function fitting(checked: Checked, mechanics: Mechanics, given: (checked: Checked) => Given) {
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

function fittingContact(contact: CheckedContact, compliance: Compliance) {
  for (const [name, { of: unit, ...range }] of Object.entries<any>(scenario.relative)) {
    const value = contact[name];
    if (value === null) continue;
    const relative = (compliance as any)[name];
    if (!holds(range, relative)) broken("relative_contact", { name, value, relative, unit, words: rangeText(range) });
  }
  const { depth } = compliance;
  const most = number(scenario.most_depth);
  // Python says None where the stiffness is the usual one
  if (depth > most) broken("too_soft", { stiffness: contact.stiffness, depth, most });
}
