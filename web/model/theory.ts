// What theory says about the hoop of a scenario, as the page lists it: the page's side of lab/thresholds.py.

import { tables } from "./tables.ts";
import { fill, general } from "./text.ts";
import { degrees } from "./words.ts";

const { theory: THEORY } = tables.words;

export type Threshold = { key: string; label: string; value: number | null; unit: string; text: string };

export function thresholds({ hoop, plane }: Checked, known: TheoryNumbers): Threshold[] {
  const found: Threshold[] = [];
  const add: (key: string, value: number | null, unit: string, say: (value: number) => string) => void = (
    key,
    value,
    unit,
    say,
  ) => {
    if (value === null) return;
    found.push({ key, label: THEORY[key], value: Number.isFinite(value) ? value : null, unit, text: say(value) });
  };
  const paradox = () => add("painleve", known.painleve_friction, "1", (mu) => painleve(mu, known, plane));
  if (plane.gravity <= 0) {
    paradox();
    return found;
  }
  if (hoop.inertia_ratio === 0) {
    const why = known.massless_loss_by_friction ? THEORY.loss_by_friction : THEORY.loss_of_contact;
    add("loss", known.massless_loss_angle, "rad", (angle) => fill(why, { where: degrees(angle) }));
    return found;
  }
  if (plane.slope >= 0) {
    const { would_slip, would_hop, would_hop_at_once, any_push, any_speed } = THEORY;
    add("first_slip", known.first_slip_speed, "m/s", (speed) => above(speed, would_slip, any_push));
    add("first_hop", known.first_hop_speed, "m/s", (speed) => above(speed, would_hop, any_push));
    add("immediate_hop", known.immediate_hop_speed, "m/s", (speed) => above(speed, would_hop_at_once, any_speed));
  } else {
    // uphill the speed changes with every turn: there is no one speed from which on it happens in the first
    found.push({ key: "uphill", label: THEORY.uphill, value: null, unit: "", text: THEORY.no_threshold });
  }
  add("needed_friction", known.needed_friction, "1", (mu) => needed(mu, plane));
  paradox();
  const places = known.jam_angles.map(degrees).join(", ");
  add("jam", known.jam_angles[0] ?? null, "rad", () => fill(THEORY.jam_at, { places }));
  if (hoop.eccentricity > 0) {
    add("rest", known.stable_angle, "rad", (angle) => fill(THEORY.rest_at, { where: degrees(angle) }));
  }
  return found;
}

function above(speed: number, would: string, always: string) {
  if (speed < tables.words.least_speed) return fill(always, { would });
  return Number.isFinite(speed) ? fill(THEORY.above, { would, speed: general(speed, 4) }) : THEORY.no_speed;
}

function needed(mu: number, { mu_static }: CheckedPlane) {
  if (!Number.isFinite(mu)) return THEORY.no_friction;
  return fill(mu <= mu_static ? THEORY.friction_enough : THEORY.friction_short, { mu: general(mu, 3) });
}

function painleve(mu: number, { painleve_angle: angle }: TheoryNumbers, { mu_kinetic }: CheckedPlane) {
  if (angle === null) return THEORY.never;
  const text = mu <= mu_kinetic ? THEORY.paradox_here : THEORY.paradox_not_here;
  return fill(text, { mu: general(mu, 3), where: degrees(angle) });
}
