// What the player knows of a motion besides its frames.

import { given, stateOf } from "./given.ts";
import { toDict, toQuery } from "./scenario.ts";
import { tables } from "./tables.ts";
import { story, summary } from "./words.ts";

const MOST_EVENTS = 2000;

/** The motion as the JSON of the file format, as Python's `Trajectory.to_dict`. `checked`: that it was computed for. */
export function resultOf(
  checked: Checked,
  { status, sequence, fingerprint, events, final, energy }: Omit<ComputedMotion, "doubt">,
) {
  const { schema, setup } = tables;
  const scenario = toDict(checked);
  return { schema, version: setup.version, scenario, status, sequence, fingerprint, events, final, energy };
}

/** `checked`: what it is shown as; `omega`: how the hoop turns halfway from an event to the next. */
export function headerOf(
  checked: Checked,
  motion: Omit<ComputedMotion, "doubt">,
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
    summary: summary(told),
    story: story(told),
    shortened: motion.events.length > MOST_EVENTS,
  };
}

/** Numbers as the sliders show them, whichever way the scenario is given. */
function valuesOf({ hoop, plane, start }: Checked): Named {
  const sections = { hoop, plane, start: { ...stateOf(start, hoop.radius), speed: start.speed } } as any;
  const values = tables.shown.map((path: string) => {
    const [section, name] = path.split(".");
    const value = sections[section][name];
    return [path, value === Infinity ? "inf" : value];
  });
  return Object.fromEntries(values);
}

function automatic(checked: Checked, mechanics: Mechanics) {
  if (checked.contact.model === "rigid") return {};
  const { stiffness, slip_speed } = mechanics.chosen(given(checked));
  const { restitution } = checked.plane;
  return { "contact.stiffness": stiffness, "contact.slip_speed": slip_speed, "contact.restitution": restitution };
}
