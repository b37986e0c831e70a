// The hoop in the visitor's hand: turn the load, roll or lift the hoop, tilt the plane, let go with the speed of the
// hand. What is held is a start; the coming motion is computed while the hand moves and begins when it lets go.

import { clamp } from "../common/clamp.ts";
import type { Scene } from "./scene2d.ts";

const FLICK = 0.09; // seconds before letting go that count for the speed
const GROUND = 0.03; // of a radius: so low the hoop stands on the plane
const LEVEL = Math.PI / 180; // a plane within this is level
const BESIDE = 0.02; // radians from the top
const STEEPEST = Math.PI / 4;
const TURN = 2 * Math.PI;

/** What is held: a start in the hand. */
export type Held = { angle: number; height: number; vx: number; vy: number; omega: number; slope: number };
export type Grip = "load" | "hoop" | "plane";

const wrapped = (angle: number) => angle - TURN * Math.round(angle / TURN);

/**
 * The hoop as keys take it: at rest, but with its speed at its start. A load that is turned by keys keeps the hoop's
 * speed, on the ground that of the start.
 */
export function taken(grip: Grip, film: Film, time: number): Held {
  const pose = film.at(time);
  const first = film.at(0);
  const place = { angle: wrapped(pose.angle), height: Math.max(pose.height, 0), slope: film.slope };
  if (grip !== "load" && time > 0) return { ...place, vx: 0, vy: 0, omega: 0 };
  const { vx, vy, omega } = grip === "load" && (pose.height > 0 || first.height > 0) ? pose : first;
  return { ...place, vx, vy, omega };
}

/** The greatest speed that a hand gives [m/s]: twice that of the deepest fall about the rim. */
export const fastest = (film: Film) => 2 * Math.sqrt(Math.max(film.gravity, 1) * film.radius);

/** A hand is not surer than this; links stay short. */
const round = (value: number) => Number(value.toFixed(4)) + 0;

/** What has to change in the scenario for what is held; on the ground the hoop starts rolling. */
export function changesFor(grip: Grip, held: Held, film: Film): Change[] {
  if (grip === "plane") return [["plane.slope", round(held.slope)]];
  // with the load exactly at the top a hoop at rest would stand there for ever
  const stands = !film.slope && !held.vx && !held.omega && !round(held.angle);
  const angle: Change = ["start.angle", stands ? BESIDE : round(held.angle)];
  if (held.height > 0) {
    return [
      angle,
      ["start.height", round(held.height)],
      ["start.vx", round(held.vx)],
      ["start.vy", round(held.vy)],
      ["start.omega", round(held.omega)],
    ];
  }
  const first = film.at(0);
  if (grip === "load" && first.height === 0 && held.vx === first.vx) return [angle];
  return [angle, ["start.speed", round(held.vx)]];
}

/** One pull by a pointer; places are in metres of the picture, along the plane and away from it. */
export class Pull {
  turned = 0; // since the hand came, over any number of turns
  trail: { t: number; along: number; away: number; turned: number }[] = [];
  moved = 0; // pixels, sideways
  before: Held;
  held: { vx: number; vy: number; omega: number; angle: number; height: number; slope: number };
  center: number[];
  foot: [number, number];
  from: { x: number; y: number; along: number; away: number; turn: number };

  constructor(
    readonly grip: Grip,
    public film: Film,
    time: number,
    public view: Scene,
    at: Point,
  ) {
    // the picture as it was when the hand came: it does not move under the hand
    this.before = taken(grip, film, time);
    this.held = { ...this.before, vx: 0, vy: 0, omega: 0 };
    const pose = film.at(time);
    this.center = [pose.x, film.radius + pose.height];
    this.foot = view.point(pose.x, 0);
    this.from = this.read(at);
  }

  read(at: Point) {
    const [along, away] = this.view.unpoint(at.clientX, at.clientY);
    const turn =
      this.grip === "plane"
        ? Math.atan2(at.clientY - this.foot[1], at.clientX - this.foot[0])
        : Math.atan2(along - this.center[0], away - this.center[1]);
    return { x: at.clientX, y: at.clientY, along, away, turn };
  }

  /** The hand is elsewhere. `now`: in milliseconds. */
  move(at: Point, now: number) {
    const here = this.read(at);
    const { radius } = this.film;
    this.turned += wrapped(here.turn - this.from.turn - this.turned);
    if (this.grip === "plane") {
      const slope = clamp(this.before.slope + this.turned, -STEEPEST, STEEPEST);
      this.held.slope = Math.abs(slope) < LEVEL ? 0 : slope;
    } else if (this.grip === "load") this.held.angle = wrapped(this.before.angle + this.turned);
    else {
      const height = this.before.height + here.away - this.from.away;
      this.held.height = height < GROUND * radius ? 0 : height;
      const along = here.along - this.from.along;
      // on the ground it rolls in the hand
      this.held.angle = wrapped(this.before.angle + (this.held.height > 0 ? 0 : along / radius));
      this.moved = here.x - this.from.x;
    }
    this.trail.push({ t: now / 1000, along: here.along, away: here.away, turned: this.turned });
    while (this.trail.length > 2 && this.trail[0].t < now / 1000 - FLICK) this.trail.shift();
    return this.held;
  }

  /** The hand lets go: the hoop goes on as the hand moved last. `now`: in milliseconds. */
  release(now: number) {
    const { held, trail, film } = this;
    const last = trail.at(-1);
    const first = trail[0];
    const passed = last && first ? last.t - first.t : 0;
    const still = !last || passed < 0.012 || now / 1000 - last.t > FLICK;
    const most = fastest(film);
    if (still || this.grip === "plane") return held;
    if (this.grip === "load") {
      const rim = clamp((film.radius * (last.turned - first.turned)) / passed, -most, most);
      held.omega = rim / film.radius;
      if (held.height === 0) held.vx = rim; // it starts rolling
    } else {
      held.vx = clamp((last.along - first.along) / passed, -most, most);
      held.vy = held.height > 0 ? clamp((last.away - first.away) / passed, -most, most) : 0;
    }
    return held;
  }
}

/** What a key does to what is held, or null where it does nothing; a finer step with Shift. */
export function keyed(grip: Grip, key: string, fine: boolean, held: Held, film: Film) {
  const side = { ArrowLeft: -1, ArrowRight: 1 }[key] ?? 0;
  const up = { ArrowDown: -1, ArrowUp: 1 }[key] ?? 0;
  if (!side && !up) return null;
  const step = fine ? 0.2 : 1;
  if (grip === "load") {
    const angle = wrapped(held.angle + (side || up) * 5 * LEVEL * step);
    return { ...held, angle };
  }
  if (grip === "plane") {
    const slope = clamp(held.slope + (side || -up) * LEVEL * step, -STEEPEST, STEEPEST);
    return { ...held, slope: Math.abs(slope) < 1e-9 ? 0 : slope };
  }
  const most = fastest(film);
  const height = clamp(held.height + up * 0.05 * step * film.radius, 0, 4 * film.radius);
  const vx = clamp(held.vx + side * 0.1 * step, -most, most);
  return { ...held, height: height < 1e-9 ? 0 : height, vx };
}
