// What a little more of a parameter does: the rates of events, as changes with a step, and in words.

import { layout } from "../../kernel/layout.ts";
import { eventWord, MARKS } from "../player/marks.ts";
import { DEGREE, show, withUnit } from "../common/numbers.ts";
import { listed } from "../words/words.ts";
import { rounded } from "../common/clamp.ts";
import { arrowHead, disc, haloed, outlined, stroke } from "../common/paint.ts";
import type { Name, Rates } from "./rates.ts";
import type { Scene } from "../player/scene2d.ts";

const PASSING = new Set(layout.passing);
const MOST_HOPS = 3;
const ROUNDING = 1e-7; // relative to what it changes: less is none

/** Flights, by the numbers of the events that they begin with, are highest at and end with; −1 where there is none. */
function hopsOf(events: MotionEvent[]) {
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
  rate(event: number, name: Name) {
    return this.rates.events[event]?.[name] ?? Number.NaN;
  }

  of(event: number, name: Name) {
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

export type Unit = "s" | "m" | "m/s" | "°";

/** An amount without its sign, in the unit in which it reads well. */
function amount(value: number, unit: Unit) {
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
export function signed(value: number, unit: Unit) {
  if (!Number.isFinite(value)) return "–";
  if (!counts(value, 1)) return "0";
  return `${value > 0 ? "+" : "−"}${amount(value, unit)}`;
}

/** Words for each change that there is. */
function listOf(changes: [value: number, unit: Unit, more: string, less: string][]) {
  const parts = changes
    .filter(([value]) => Number.isFinite(value) && counts(value, 1))
    .map(([value, unit, more, less]) => ({ key: value > 0 ? more : less, values: { amount: amount(value, unit) } }));
  return parts.length ? listed(parts) : null;
}

const ALONG = ["m", "sensitivity.further_right", "sensitivity.further_left"] as const;
const LATER = ["s", "sensitivity.later", "sensitivity.earlier"] as const;

/** What changes, in a sentence or a few. */
export function sentences(changes: Changes) {
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

// --- Arrows in the picture: from where the rim touches, or comes closest, at each event to where it would with a little more

const WANTED = 0.7; // of the radius: how long the arrow of usual length is drawn
const LEAST = 34; // pixels, where the hoop is small
const MOST = 3; // times as long as usual: longer ones are drawn broken
const COUNT = 400; // events
const ROWS = 8; // more arrows than that over each other are left out
const ROW = 13; // pixels between arrows that would lie over each other

export type Arrow = { kind: string; x: number; y: number; dx: number; dy: number };

export function arrowsOf(changes: Changes) {
  const { events, count } = changes;
  return events
    .slice(0, Math.min(count, COUNT))
    .map(({ kind, x, height }, k) => ({ kind, x, y: height, dx: changes.of(k, "x"), dy: changes.of(k, "height") }));
}

/**
 * How many times as long as the change arrows are drawn: 1, 2 or 5 times a power of ten, so that usual ones are seen
 * well. `scale`: pixels for a metre.
 */
export function magnified(arrows: Arrow[], radius: number, scale: number) {
  const lengths = arrows
    .map(({ dx, dy }) => Math.hypot(dx, dy))
    .filter((length) => Number.isFinite(length) && counts(length, radius))
    .sort((a, b) => a - b);
  if (!lengths.length) return 0;
  const rough = Math.max(WANTED * radius, LEAST / scale) / lengths[Math.floor(lengths.length / 2)];
  return rough <= 1 ? 1 : rounded(rough);
}

export function drawArrows(scene: Scene, arrows: Arrow[], factor: number) {
  const taken: { low: number; high: number; base: number }[] = [];
  const most = MOST * Math.max(WANTED * scene.film.radius, LEAST / scene.scale);
  for (const { kind, x, y, dx, dy } of arrows) {
    const known = Number.isFinite(dx) && Number.isFinite(dy);
    const length = known ? factor * Math.hypot(dx, dy) : 0;
    const cut = length > most ? most / length : 1;
    const way = known ? [cut * factor * dx, cut * factor * dy] : [0, 0];
    const from = scene.point(x, y);
    const to = scene.point(x + way[0], y + way[1]);
    if (Math.max(from[0], to[0]) < -20 || Math.min(from[0], to[0]) > scene.width + 20) continue;
    const [low, high] = [Math.min(from[0], to[0]) - 12, Math.max(from[0], to[0]) + 12];
    let base = from[1];
    while (taken.some((other) => Math.abs(other.base - base) < ROW - 1 && other.low < high && other.high > low))
      base -= ROW;
    if (from[1] - base > ROWS * ROW) continue;
    taken.push({ low, high, base });
    const lift = base - from[1];
    change(scene, from, [to[0], to[1] + lift], lift, { known, broken: cut < 1, mark: MARKS[kind] ?? "" });
  }
}

/** `lift`: how far it is moved up, in pixels. */
function change(
  { context, look }: Scene,
  from: number[],
  to: number[],
  lift: number,
  { known, broken, mark }: { known: boolean; broken: boolean; mark: string },
) {
  const begin = [from[0], from[1] + lift];
  const length = Math.hypot(to[0] - begin[0], to[1] - begin[1]);
  const [ux, uy] = length > 0 ? [(to[0] - begin[0]) / length, (to[1] - begin[1]) / length] : [1, 0];
  const head = Math.min(9, length);
  context.lineCap = "round";
  outlined(context, [look.paper, 6.5], [look.ink, 2.5], (wide) => {
    if (lift) {
      context.lineWidth = wide > 3 ? 3 : 1;
      stroke(context, from, begin);
    }
    context.lineWidth = wide;
    context.setLineDash(broken ? [5, 6] : []);
    stroke(context, begin, [to[0] - ux * head, to[1] - uy * head]);
    context.setLineDash([]);
    disc(context, begin, wide > 3 ? 5.5 : 3.5);
    if (length < 1) return;
    arrowHead(context, to, [ux, uy], head);
    context.lineWidth = wide > 3 ? 4 : 1;
    context.closePath();
    context.stroke();
  });
  context.lineCap = "butt";
  const label = known ? mark : "?";
  if (!label) return;
  context.font = `600 ${11 * look.px}px ${look.font}`;
  context.textAlign = "center";
  haloed(context, label, [begin[0], begin[1] - 7], look.ink, look.paper);
}
