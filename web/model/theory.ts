// What theory says about the hoop of a scenario, as the page lists it.

import { tables } from "./tables.ts";
import { general } from "./text.ts";
import { listed } from "../words/texts.ts";
import { degrees } from "./words.ts";

type Threshold = { key: string; label: Message; value: number | null; text: Message };

export function thresholds({ hoop, plane }: Checked, known: TheoryNumbers) {
  const found: Threshold[] = [];
  const add = (key: string, value: number | null, say: (value: number) => Message) => {
    if (value === null) return;
    found.push({ key, label: `theory.${key}`, value: Number.isFinite(value) ? value : null, text: say(value) });
  };
  const paradox = () => add("painleve", known.painleve_friction, (mu) => painleve(mu, known, plane));
  if (plane.gravity <= 0) {
    paradox();
    return found;
  }
  if (hoop.inertia_ratio === 0) {
    const why = known.massless_loss_by_friction ? "theory.loss_by_friction" : "theory.loss_of_contact";
    add("loss", known.massless_loss_angle, (angle) => at(why, angle));
    return found;
  }
  if (plane.slope >= 0) {
    add("first_slip", known.first_slip_speed, (speed) => above(speed, "would_slip"));
    add("first_hop", known.first_hop_speed, (speed) => above(speed, "would_hop"));
    add("immediate_hop", known.immediate_hop_speed, (speed) => above(speed, "would_hop_at_once"));
  } else {
    // uphill the speed changes with every turn: there is no one speed from which on it happens in the first
    found.push({ key: "uphill", label: "theory.uphill", value: null, text: "theory.no_threshold" });
  }
  add("needed_friction", known.needed_friction, (mu) => needed(mu, plane));
  paradox();
  const places = listed(known.jam_angles.map(degrees));
  add("jam", known.jam_angles[0] ?? null, () => ({ key: "theory.jam_at", values: { places } }));
  if (hoop.eccentricity > 0) {
    add("rest", known.stable_angle, (angle) => at("theory.rest_at", angle));
  }
  return found;
}

const at = (key: string, angle: number): Phrase => ({ key, values: { where: degrees(angle) } });

function above(speed: number, would: string): Message {
  if (speed < tables.words.least_speed) return `theory.${would}.always`;
  if (!Number.isFinite(speed)) return "theory.no_speed";
  return { key: `theory.${would}.above`, values: { speed: general(speed, 4) } };
}

function needed(mu: number, { mu_static }: CheckedPlane) {
  if (!Number.isFinite(mu)) return "theory.no_friction";
  return { key: mu <= mu_static ? "theory.friction_enough" : "theory.friction_short", values: { mu: general(mu, 3) } };
}

function painleve(mu: number, { painleve_angle: angle }: TheoryNumbers, { mu_kinetic }: CheckedPlane) {
  if (angle === null) return "theory.never";
  const key = mu <= mu_kinetic ? "theory.paradox_here" : "theory.paradox_not_here";
  return { key, values: { mu: general(mu, 3), where: degrees(angle) } };
}
