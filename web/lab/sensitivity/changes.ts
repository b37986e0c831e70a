// What a little more of a parameter does: the rates of events, as changes with a step, and in words.

import { layout } from "../../kernel/layout.ts";
import { eventWord } from "../player/marks.ts";
import { DEGREE, show, withUnit } from "../common/numbers.ts";
import { listed } from "../words/words.ts";
import type { Rates } from "./rates.ts";

const PASSING = new Set(layout.passing);
const MOST_HOPS = 3;
const ROUNDING = 1e-7; // relative to what it changes: less is none

/** Flights, by the numbers of the events that they begin with, are highest at and end with; −1 where there is none. */
export function hopsOf(events: MotionEvent[]): { begin: number; top: number; end: number }[] {
  const hops = [];
  let begin = -1;
  let top = -1;
  for (const [k, { kind, from, to, t: time, height }] of events.entries()) {
    if (begin >= 0 && kind === "apex" && (top < 0 || height > events[top].height)) top = k;
    if (PASSING.has(kind)) continue;
    if (begin >= 0 && from === "H" && time > events[begin].t) {
      hops.push({ begin, top, end: kind === "end" ? -1 : k });
      begin = top = -1;
    }
    if (to === "H" && kind !== "end") [begin, top] = [k, -1];
  }
  return hops;
}

/** The changes of a motion with a step of one parameter. */
export class Changes {
  events: MotionEvent[];
  radius: number;
  /** How many events have rates: from the next one on, others follow. */
  count = this.rates.events.length;
  /** The step that is possible: downwards where the parameter can be no larger. */
  step = this.rates.way * this.more;

  /** `more`: a step of the parameter, upwards. */
  constructor(
    film: Film,
    readonly rates: Rates,
    readonly more: number,
  ) {
    this.events = film.events;
    this.radius = film.radius;
  }

  /** The rate of an event's number with the parameter. */
  rate(event: number, name: keyof Rates["events"][number]) {
    return this.rates.events[event]?.[name] ?? Number.NaN;
  }

  of(event: number, name: keyof Rates["events"][number]) {
    return this.step * this.rate(event, name);
  }

  hops() {
    return hopsOf(this.events.slice(0, this.count)).map(({ begin, top, end }) => {
      const between = (name: "x" | "t") => this.of(end, name) - this.of(begin, name);
      return {
        begin,
        end,
        height: this.of(top < 0 ? begin : top, "height"),
        distance: between("x"),
        duration: between("t"),
      };
    });
  }
}

/** An amount without its sign, in the unit in which it reads well. */
function amount(value: number, unit: "s" | "m" | "m/s" | "°") {
  const size = Math.abs(value);
  if (unit === "°") return withUnit(show(size / DEGREE, 3), "°");
  const small = size < 0.0995;
  const tiny = size < 0.9995e-4;
  const [scale, prefix] = !small ? [1, ""] : tiny ? [1e6, "µ"] : [1e3, "m"];
  return unit === "m/s" ? withUnit(show(size, 3), unit) : withUnit(show(scale * size, 3), `${prefix}${unit}`);
}

/** Whether it is more than rounding. `size`: of what it changes. */
export const counts = (value: number, size: number) => Math.abs(value) > ROUNDING * Math.max(size, 1e-3);

/** An amount with its sign. */
export function signed(value: number, unit: "s" | "m" | "m/s" | "°") {
  if (!Number.isFinite(value)) return "–";
  if (!counts(value, 1)) return "0";
  return `${value > 0 ? "+" : "−"}${amount(value, unit)}`;
}

/** Words for each change that there is. */
function listOf(changes: [value: number, unit: "s" | "m" | "m/s" | "°", more: string, less: string][]) {
  const parts = changes
    .filter(([value]) => Number.isFinite(value) && counts(value, 1))
    .map(([value, unit, more, less]) => ({ key: value > 0 ? more : less, values: { amount: amount(value, unit) } }));
  return parts.length ? listed(parts) : null;
}

const ALONG = ["m", "sensitivity.further_right", "sensitivity.further_left"] as const;
const LATER = ["s", "sensitivity.later", "sensitivity.earlier"] as const;

/** What changes, in a sentence or a few. */
export function sentences(changes: Changes): Message[] {
  const { events, count } = changes;
  const said: Message[] = [];
  const hops = changes.hops();
  for (const [k, { begin, end, height, distance, duration }] of hops.slice(0, MOST_HOPS).entries()) {
    const way = end >= 0 && events[end].x < events[begin].x ? -distance : distance;
    const list = listOf([
      [height, "m", "sensitivity.higher", "sensitivity.lower"],
      [way, "m", "sensitivity.longer", "sensitivity.shorter"],
      [duration, "s", "sensitivity.flight_longer", "sensitivity.flight_shorter"],
      [changes.of(begin, "t"), "s", "sensitivity.starts_later", "sensitivity.starts_earlier"],
    ]);
    if (list)
      said.push(
        hops.length > 1
          ? { key: "sensitivity.of_hop_number", values: { number: k + 1, list } }
          : { key: "sensitivity.of_hop", values: { list } },
      );
  }
  const first = hops.length ? -1 : events.findIndex(({ kind }, k) => k < count && kind !== "start" && kind !== "end");
  if (first >= 0) {
    const list = listOf([
      [changes.of(first, "t"), ...LATER],
      [changes.of(first, "x"), ...ALONG],
    ]);
    if (list) said.push({ key: "sensitivity.of_first_event", values: { what: eventWord(events[first].kind), list } });
  }
  const last = count - 1;
  if (last > 0 && events[last].kind === "end") {
    const faster = Math.sign(events[last].vx) * changes.of(last, "vx");
    const list = listOf([
      [changes.of(last, "x"), ...ALONG],
      [faster, "m/s", "sensitivity.faster", "sensitivity.slower"],
    ]);
    if (list) said.push({ key: "sensitivity.of_end", values: { time: show(events[last].t, 4), list } });
  }
  return said;
}
