// How the events of a motion change with a parameter: differences to motions with a little more and a little less of it.

import { layout } from "../../kernel/layout.ts";

const NAMES = ["t", "x", "height", "angle", "vx"] as const;
const NEAR = [1e-4, 1e-5, 1e-6]; // of a step: the first over which all events change evenly
const BENT = 1e-3; // relative: how far two differences of an even change are apart
const ROUNDING = 1e-12; // of a number, relative to the largest of its kind
const PASSING = new Set<string | undefined>(layout.passing);

export type Name = (typeof NAMES)[number];

/** How far away the parameter of a motion nearby is, and its events, up to the first that is another one. */
type Nearby = { offset: number; events: MotionEvent[] } | null;

/**
 * Of the events before the first that is another one nearby. `way`: 1 for a larger parameter, −1 for a smaller one;
 * `edge`: it can be no other on the other side; `sided`: it has other rates there.
 */
export type Rates = { events: Record<Name, number>[]; way: 1 | -1; edge: boolean; sided: boolean };

/**
 * `step`: by which the parameter is usually changed; `at`: gives the events of the motion whose parameter is so far
 * away, null where it is not allowed. Null where it can be no other.
 */
export async function ratesOf(
  shown: MotionEvent[],
  step: number,
  at: (offset: number) => Promise<MotionEvent[] | null>,
): Promise<Rates | null> {
  const nearby = async (offset: number): Promise<Nearby> => {
    const events = await at(offset);
    return events && { offset, events: alike(shown, events) };
  };
  const between = async (one: number, other: number) => slopes(shown, await nearby(one), await nearby(other));
  const [larger, smaller] = [await nearby(NEAR[0] * step), await nearby(-NEAR[0] * step)];
  if (!larger && !smaller) return null;
  const way = larger ? 1 : -1;
  const edge = !larger || !smaller;
  let events: Rates["events"] = [];
  for (const share of NEAR) {
    const size = way * share * step;
    const found = await between(size, edge ? 2 * size : -size);
    if (found.length > events.length) events = found;
    if (found.length === shown.length) break;
  }
  if (edge) return { events, way, edge, sided: false };
  // at a corner the change is even towards each side, as far as the events of both are the same
  const same = Math.min(larger.events.length, smaller.events.length);
  const ahead = events.length < same ? await between(NEAR[2] * step, 2 * NEAR[2] * step) : [];
  const sided = ahead.length > events.length;
  return { events: sided ? ahead.slice(0, same) : events, way, edge, sided };
}

/** The events of another motion that are those of the one that is shown; a top or a turn more is passed over. */
function alike(shown: MotionEvent[], others: MotionEvent[]) {
  const found: MotionEvent[] = [];
  let place = 0;
  for (const { kind, from, to } of shown) {
    while (others[place]?.kind !== kind && PASSING.has(others[place]?.kind)) place++;
    const other = others[place++];
    if (other?.kind !== kind || other.from !== from || other.to !== to) break;
    found.push(other);
  }
  return found;
}

/** The slopes of parabolas through the motion that is shown and two others, before the first event that is no parabola. */
function slopes(shown: MotionEvent[], one: Nearby, other: Nearby) {
  const found: Rates["events"] = [];
  if (!one || !other) return found;
  const [a, b] = [one.offset, other.offset];
  const sizes = NAMES.map((name) => Math.max(...shown.map((event) => Math.abs(event[name]))));
  for (const [k, event] of shown.slice(0, Math.min(one.events.length, other.events.length)).entries()) {
    let bent = false;
    const rates = NAMES.map((name, column) => {
      const near = (one.events[k][name] - event[name]) / a;
      const far = (other.events[k][name] - event[name]) / b;
      const most = BENT * Math.max(Math.abs(near), Math.abs(far)) + (ROUNDING * sizes[column]) / Math.abs(a);
      bent ||= Math.abs(near - far) > most;
      return [name, (near * b - far * a) / (b - a)];
    });
    if (bent) break;
    found.push(Object.fromEntries(rates));
  }
  return found;
}
