// What the player knows of a motion besides its frames: the page's side of lab/film.header.

import { given, stateOf } from "./given.js";
import { toDict, toQuery } from "./scenario.js";
import { tables } from "./tables.js";
import { story, summary } from "./words.js";

const MOST_EVENTS = 2000;

/** @param {number | null} value */
const written = (value) => (value === Infinity ? "inf" : value);

/**
 * The motion as the JSON of the file format, as Python's `Trajectory.to_dict`, but without a fingerprint where doubles do not decide.
 * @param {Checked} checked that it was computed for
 * @param {ComputedMotion} motion
 */
export function resultOf(checked, { status, sequence, fingerprint, events, final, energy }) {
  const { schema, setup } = tables;
  return {
    schema,
    version: setup.version,
    scenario: toDict(checked),
    status,
    sequence,
    fingerprint,
    events,
    final,
    energy,
  };
}

/**
 * @param {Checked} checked what it is shown as
 * @param {ComputedMotion} motion
 * @param {(number: number) => number} omega how the hoop turns halfway from an event to the next
 * @param {Mechanics} mechanics
 */
export function headerOf(checked, motion, omega, mechanics) {
  const told = { events: motion.events, status: motion.status, omega };
  return {
    ...resultOf(checked, motion),
    events: motion.events.slice(0, MOST_EVENTS),
    query: toQuery(checked),
    duration: motion.duration,
    values: valuesOf(checked),
    // what is chosen by itself where the scenario leaves it open
    automatic: automatic(checked, mechanics),
    massless: checked.hoop.inertia_ratio === 0,
    summary: summary(told),
    story: story(told),
    shortened: motion.events.length > MOST_EVENTS,
  };
}

/**
 * Numbers as the sliders show them, whichever way the scenario is given.
 * @param {Checked} checked
 * @returns {Record<string, any>}
 */
function valuesOf(checked) {
  const { speed } = checked.start;
  const sections = /** @type {any} */ ({
    ...checked,
    start: { ...stateOf(checked.start, checked.hoop.radius), speed },
  });
  /** @param {string} path */
  const value = (path) => {
    const [section, name] = path.split(".");
    return written(sections[section][name]);
  };
  return Object.fromEntries(tables.shown.map((/** @type {string} */ path) => [path, value(path)]));
}

/**
 * @param {Checked} checked
 * @param {Mechanics} mechanics
 * @returns {Record<string, number>}
 */
function automatic(checked, mechanics) {
  if (checked.contact.model === "rigid" || !mechanics.compliance) return {};
  const { stiffness, slip_speed } = mechanics.compliance(given(checked)).automatic;
  return {
    "contact.stiffness": stiffness,
    "contact.slip_speed": slip_speed,
    "contact.restitution": checked.plane.restitution,
  };
}
