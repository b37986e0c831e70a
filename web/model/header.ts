// What the player knows of a motion besides its frames: the page's side of lab/film.header.

import { given, stateOf } from "./given.ts";
import { toDict, toQuery } from "./scenario.ts";
import { tables } from "./tables.ts";
import { story, summary } from "./words.ts";

const MOST_EVENTS = 2000;

const written = (value: number | null) => (value === Infinity ? "inf" : value);

/**
 * The motion as the JSON of the file format, as Python's `Trajectory.to_dict`, but without a fingerprint where
 * doubles do not decide. `checked`: that it was computed for.
 */
export function resultOf(checked: Checked, { status, sequence, fingerprint, events, final, energy }: ComputedMotion) {
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

/** `checked`: what it is shown as; `omega`: how the hoop turns halfway from an event to the next. */
export function headerOf(
  checked: Checked,
  motion: ComputedMotion,
  omega: (number: number) => number,
  mechanics: Mechanics,
) {
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

/** Numbers as the sliders show them, whichever way the scenario is given. */
function valuesOf(checked: Checked): Record<string, any> {
  const { speed } = checked.start;
  const sections = {
    ...checked,
    start: { ...stateOf(checked.start, checked.hoop.radius), speed },
  } as any;
  const value = (path: string) => {
    const [section, name] = path.split(".");
    return written(sections[section][name]);
  };
  return Object.fromEntries(tables.shown.map((path: string) => [path, value(path)]));
}

function automatic(checked: Checked, mechanics: Mechanics): Record<string, number> {
  if (checked.contact.model === "rigid" || !mechanics.compliance) return {};
  const { stiffness, slip_speed } = mechanics.compliance(given(checked)).automatic;
  return {
    "contact.stiffness": stiffness,
    "contact.slip_speed": slip_speed,
    "contact.restitution": checked.plane.restitution,
  };
}
