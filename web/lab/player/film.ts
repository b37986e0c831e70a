// A computed motion, and the state at any time in it.

import { tables } from "../../model/tables.ts";
import { clamp, extent } from "../common/clamp.ts";

const MODE_LETTERS: string = tables.words.letters;

const COARSE = 1 / 60; // seconds between samples from which on a film is made finer where one looks
const STRETCH = 10; // seconds of a film that have one scale of rim speeds
const PART = 8; // seconds that are made finer at a time

export class Film {
  /** the film of one instant that was asked for last */
  latest: Film | null = null;
  cache = new Map<string, Column>();
  /** the part that is looked at, if the whole is coarse */
  part: Film | null = null;
  scenario: Scenario;
  query: string;
  duration: number;
  status: MotionStatus;
  sequence: string;
  /** hash of the bits of all events */
  fingerprint: string;
  events: MotionEvent[];
  values: Named;
  automatic: Named<number>;
  /** what happens, in one sentence */
  summary: Message;
  story: Sentence[];
  shortened: boolean;
  /** that more digits would have to decide what comes, if they would */
  doubt: Message;
  columns: Named<Column>;
  /** the columns at any time */
  exact: FilmReply["exact"];
  t: Float64Array;
  length: number;
  radius: number;
  mass: number;
  eccentricity: number;
  slope: number;
  gravity: number;
  phases: Phase[];
  extent: { left: number; right: number; top: number; speed: number };
  weight: number; // where there is none, that on Earth [N]
  newton: number; // length of its arrow [m]

  constructor(reply: FilmReply) {
    Object.assign(this, { doubt: "" }, reply.header);
    this.columns = reply.arrays;
    this.exact = reply.exact;
    this.t = reply.arrays.t;
    this.length = this.t.length;
    this.radius = this.values["hoop.radius"];
    this.mass = this.values["hoop.mass"];
    this.eccentricity = this.values["hoop.eccentricity"];
    this.slope = this.scenario.plane.slope ?? 0;
    this.gravity = this.scenario.plane.gravity ?? 9.81;
    this.weight = this.mass * (this.gravity || 9.81);
    this.newton = (0.55 * this.radius) / this.weight;
    this.phases = this.findPhases();
    this.extent = this.findExtent();
  }

  /**
   * The part of a coarse film that should be made finer now, if any. `ahead`: how far the film runs until an answer
   * is there; returns times from and to.
   */
  wanted(time: number, ahead = 0): [number, number] | null {
    if (this.duration < COARSE * this.length) return null;
    const now = clamp(time, 0, this.duration);
    const then = Math.min(now + ahead, this.duration);
    if (this.part && now >= this.part.t[0] && then <= this.part.t[this.part.length - 1]) return null;
    const from = Math.max(now - 0.25 * PART, 0);
    return [from, Math.min(from + PART + ahead, this.duration)];
  }

  /** Take the finer part. */
  refine(columns: Named) {
    this.part = this.with(columns);
    this.latest = null;
  }

  /** The same motion at other times. */
  with(columns: Named): Film {
    const { t } = columns;
    const own = { columns, t, length: t.length, cache: new Map(), part: null, latest: null };
    return Object.assign(Object.create(this), own);
  }

  /** What holds a time: the finer part where it does, else the whole. */
  holding(time: number): Film {
    const { part } = this;
    return part && time >= part.t[0] && time <= part.t[part.length - 1] ? part : this;
  }

  /** Of a parameter: as the sliders show it, or as the scenario has it. */
  value(path: string) {
    return this.values[path] ?? path.split(".").reduce((node: any, key) => node?.[key], this.scenario);
  }

  findPhases() {
    const { mode } = this.columns;
    const phases: Phase[] = [];
    for (let i = 0; i < this.length; i++) {
      const last = phases.at(-1);
      if (last && last.mode === MODE_LETTERS[mode[i]]) last.to = this.t[i];
      else phases.push({ mode: MODE_LETTERS[mode[i]], from: this.t[i], to: this.t[i] });
    }
    for (let i = 0; i + 1 < phases.length; i++) phases[i].to = phases[i + 1].from;
    return phases.filter((phase) => phase.to > phase.from || phases.length === 1);
  }

  findExtent() {
    const { x, height, vx, vy, omega } = this.columns;
    const [left, right] = extent(x);
    const [, top] = extent([0, ...height]);
    const speeds: number[][] = []; // of each stretch
    for (let i = 0; i < this.length; i++) {
      const speed = Math.hypot(vx[i], vy[i]) + this.radius * Math.abs(omega[i]);
      const stretch = Math.floor(this.t[i] / STRETCH);
      speeds[stretch] ??= [];
      if (Number.isFinite(speed)) speeds[stretch].push(speed);
    }
    // a spike that lasts an instant must not turn the rest of the ring into one colour, nor a long rest the start
    const usual = (some: number[]) => some.sort((a, b) => a - b)[Math.floor(0.95 * (some.length - 1))];
    return { left, right, top, speed: Math.max(0, ...speeds.filter((some) => some?.length).map(usual)) || 1 };
  }

  /** Largest index with t[index] <= time: of two samples at an event, the one after it. */
  index(time: number) {
    let low = 0;
    let high = this.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.t[middle] <= time) low = middle;
      else high = middle;
    }
    return low;
  }

  /** Samples in order of time: those of the whole, with the finer part in its place. */
  pieces() {
    const { part } = this;
    if (!part) return [{ film: this, from: 0, to: this.length }];
    const [begin, end] = [part.t[0], part.t[part.length - 1]];
    let from = this.index(begin);
    while (from > 0 && this.t[from] >= begin) from--;
    const first = this.t[from] >= begin ? 0 : from + 1;
    return [
      { film: this, from: 0, to: first },
      { film: part, from: 0, to: part.length },
      { film: this, from: this.index(end) + 1, to: this.length },
    ];
  }

  /** The film of one instant: each column has its value at a time. */
  moment(time: number): Film {
    const now = clamp(time, 0, this.duration);
    if (this.latest?.t[0] === now) return this.latest;
    const film = this.holding(now);
    this.latest = this.with({ ...this.exact(now), mode: [film.columns.mode[film.index(now)]] });
    return this.latest;
  }

  at(time: number): Pose {
    const { columns } = this.moment(time);
    const values = Object.fromEntries(Object.entries(columns).map(([name, [value]]) => [name, value]));
    return { ...values, mode: MODE_LETTERS[columns.mode[0]] } as any;
  }

  /** A derived column, computed once. */
  derived(name: string, make: (columns: Named<Column>) => Column): Column {
    const found = this.cache.get(name) ?? make(this.columns);
    this.cache.set(name, found);
    return found;
  }
}
