// What ties the fields of a scenario together: in which ways they can be given; the kernel has the rules between numbers.

import { rangeText, say } from "./check.ts";
import { tables } from "./tables.ts";

const { scenario } = tables;
const WAYS = ["load_fraction", "eccentricity", "inertia_ratio"];
const FRICTIONS = ["mu_static", "mu_kinetic"];
const FREE = ["height", "vx", "vy", "omega"];
/** Numbers beside which a hoop or a plane breaks only rules of its own. */
const ALONE = { mass: 1, inertia_ratio: 1, contact: null };

/** The first rule that numbers break, in a sentence. `sections`: that the sentence may speak of. */
export function broken(given: any, sections: any, mechanics: Mechanics) {
  const [code, number] = mechanics.refused(given);
  const rule = scenario.rules[code];
  if (!rule) return null;
  const values = Object.entries(rule.values).map(([name, path]) => {
    const [section, field] = path.split(".");
    return [name, sections[section][field]];
  });
  const { words, ...known } = rule.known;
  if (words) known.words = rangeText(words);
  return say(rule.sentence, { ...known, ...Object.fromEntries(values), [rule.number]: number });
}

function together(section: string, way: string, given: Set<string>, others: string[]) {
  const other = others.find((name) => given.has(name));
  return other ? say("together", { section, other, way }) : null;
}

/** Complete the values of a section; what is wrong with them is said in a sentence. */
export const COMPLETE: Named<(values: any, given: Set<string>, mechanics: Mechanics) => Phrase | null> = {
  hoop: completeHoop,
  plane: completePlane,
  start: completeStart,
  contact: completeContact,
};

function completeHoop(hoop: CheckedHoop, given: Set<string>, mechanics: Mechanics) {
  const named = WAYS.filter((name) => given.has(name) && (hoop as any)[name] !== null);
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
    hoop.load_fraction ??= scenario.models.Hoop.fields.eccentricity.default as number;
    hoop.eccentricity = hoop.load_fraction;
    hoop.inertia_ratio = mechanics.ideal(hoop.load_fraction);
  } else if (named.length === 1) {
    const missing = named[0] === "eccentricity" ? "inertia_ratio" : "eccentricity";
    return say("half_a_hoop", { missing, given: named[0] });
  }
  return broken({ ...ALONE, ...hoop, ideal: hoop.load_fraction !== null }, { hoop }, mechanics);
}

function completePlane(plane: CheckedPlane, given: Set<string>, mechanics: Mechanics) {
  if (plane.mu !== null) {
    const said = together("plane", "mu", given, FRICTIONS);
    if (said) return said;
    plane.mu_static = plane.mu_kinetic = plane.mu;
  } else if (plane.mu_static === plane.mu_kinetic) plane.mu = plane.mu_static;
  return broken({ ...ALONE, ...plane }, { plane }, mechanics);
}

function completeStart(start: CheckedStart, given: Set<string>) {
  if (start.speed === null) return start.omega === null ? say("no_omega") : null;
  start.vx = start.speed;
  start.omega = null;
  return together("start", "speed", given, FREE);
}

function completeContact({ damping = null, restitution = null }: CheckedContact) {
  const both = damping !== null && restitution !== null;
  return both ? say("together", { section: "contact", other: "restitution", way: "damping" }) : null;
}
