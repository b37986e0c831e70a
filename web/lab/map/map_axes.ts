// The two axes of a map: which parameters, from where to where, and where that is on the canvas.

import { type Axis, drawAxes, Frame, marksOf } from "../common/axes.ts";
import { clamp, scaled, within } from "../common/clamp.ts";
import { show, sizeOf, withUnit } from "../common/numbers.ts";
import { outlined, ring, stroke } from "../common/paint.ts";
import { t } from "../words/words.ts";

const LEFT = 62;
const NAME = 20; // of the axis upwards
const GAP = 10;
const UP = 40; // pixels from number to number upwards
export const AXES: AxisName[] = ["x", "y"];

export class MapAxes extends Frame {
  paths: Record<AxisName, string> = { x: "start.speed", y: "plane.mu" };
  known = new Map(this.all.map((axis) => [axis.path, axis]));
  windows: Record<AxisName, number[]> = { x: this.whole("x"), y: this.whole("y") };

  constructor(readonly all: AxisInfo[]) {
    super(LEFT, 12, 10, 36);
  }

  /** What is known of the parameter on an axis. */
  info(name: AxisName) {
    return this.known.get(this.paths[name]) as AxisInfo;
  }

  whole(name: AxisName) {
    return [...this.info(name).range];
  }

  home() {
    for (const name of AXES) this.windows[name] = this.whole(name);
  }

  /** Another parameter on an axis; one that is on the other axis changes places. */
  choose(name: AxisName, path: string) {
    const other = name === "x" ? "y" : "x";
    if (this.paths[other] === path) this.paths[other] = this.paths[name];
    this.paths[name] = path;
    this.home();
  }

  /** An axis as the server is asked for it. */
  asked(name: AxisName, cells: number) {
    const [from, to] = this.windows[name];
    return { path: this.paths[name], from, to, cells };
  }

  /** How far out an axis goes: as far as its parameter is allowed, and no further than is of use. */
  bounds(name: AxisName) {
    const { range, allowed } = this.info(name);
    const room = 2 * (range[1] - range[0]);
    return [Math.max(allowed[0], range[0] - room), Math.min(allowed[1], range[1] + room)];
  }

  /** Whether there is room to zoom so. */
  zoom(factor: number, center?: Place) {
    const next: Record<AxisName, number[]> = { x: [], y: [] };
    for (const name of AXES) {
      const [low, high] = this.windows[name];
      const middle = center?.[name] ?? 0.5 * (low + high);
      next[name] = within(scaled([low, high], middle, factor), this.bounds(name));
      // as deep as numbers go, and no further
      const size = Math.max(Math.abs(next[name][0]), Math.abs(next[name][1]), 1e-9);
      if (next[name][1] - next[name][0] < 400 * Number.EPSILON * size) return false;
    }
    if (AXES.every((name) => next[name].every((value, i) => value === this.windows[name][i]))) return false;
    this.windows = next;
    return true;
  }

  /** Move what is shown by a part of its width and height. `dx`: in pixels. */
  drag(from: Record<AxisName, number[]>, dx: number, dy: number) {
    const shift = (name: AxisName, part: number) =>
      within(
        from[name].map((value) => value + part * (from[name][1] - from[name][0])),
        this.bounds(name),
      );
    this.windows = { x: shift("x", -dx / this.box.width), y: shift("y", dy / this.box.height) };
  }

  /** Show what a link says, if it is on an axis that there is. */
  restore(asked: Record<AxisName, [string, number, number]>) {
    if (!AXES.every((name) => this.known.has(asked[name][0])) || asked.x[0] === asked.y[0]) return false;
    for (const name of AXES) this.paths[name] = asked[name][0];
    for (const name of AXES) this.windows[name] = within(asked[name].slice(1).map(Number), this.bounds(name));
    return true;
  }

  // Whether it shows all that it does at first.
  isHome() {
    return AXES.every((name) => this.windows[name].every((value, i) => value === this.whole(name)[i]));
  }

  /** Take the room of a canvas; the name of the axis upwards stands beside its longest number. `wide`: pixels of a text. */
  fit(width: number, height: number, wide: (text: string) => number = () => 0) {
    super.fit(width, height);
    const numbers = this.axis("y", this.box.height / UP).marks.map(({ text }) => wide(text));
    this.left = Math.max(LEFT, Math.ceil(NAME + GAP + Math.max(0, ...numbers)));
    super.fit(width, height);
  }

  /** The roundest number from `low` to `high` next to a value, in the unit that people read. */
  round(name: AxisName, [low, high]: number[], value: number) {
    const scale = sizeOf(this.info(name).unit);
    for (let step = 10 ** Math.ceil(Math.log10((high - low) / scale)); step > 0; step /= 10) {
      const round = scale * Number((step * Math.round(value / scale / step)).toPrecision(15));
      if (round >= low && round < high) return round;
      if (value + scale * step === value) break;
    }
    return value;
  }

  /** Whether the numbers on an axis would differ in digits only that have no room. */
  deep(name: AxisName) {
    const [low, high] = this.windows[name];
    return high - low < 5e-5 * Math.max(Math.abs(low), Math.abs(high));
  }

  /** A place in words. */
  said(place: Place) {
    const part = (name: AxisName) => {
      const info = this.info(name);
      // as many digits as tell a cell from the next
      const [low, high] = this.windows[name];
      const size = Math.max(Math.abs(low), Math.abs(high));
      const digits = clamp(Math.ceil(Math.log10(size / (high - low))) + 4, 4, 16);
      return `${t(`axis.${info.path}`)} = ${withUnit(show(place[name] / sizeOf(info.unit), digits), info.unit)}`;
    };
    return `${part("x")}, ${part("y")}`;
  }

  /** Frame, numbers and names. */
  draw(context: CanvasRenderingContext2D, look: Look) {
    const { width, height } = this.box;
    drawAxes(context, look, this, {
      across: this.axis("x", width / 80),
      up: this.axis("y", height / UP),
      middle: true,
    });
  }

  axis(name: AxisName, count: number): Axis {
    const info = this.info(name);
    const scale = 1 / sizeOf(info.unit);
    const [low, high] = this.windows[name].map((value) => value * scale);
    // far in, the labels show the distance from a rounded value that stands with the axis' name
    const deep = this.deep(name);
    const origin = deep ? Number((0.5 * (low + high)).toPrecision(12)) : 0;
    const offset = deep ? ` − ${String(origin).replace("-", "−")}` : "";
    return {
      marks: marksOf(
        [low - origin, high - origin],
        count,
        (value) => this[name]((value + origin) / scale),
        undefined,
        deep ? (value) => show(value, 3) : undefined,
      ),
      name: `${t(`axis.${info.path}`)}${offset}${info.unit ? ` [${info.unit}]` : ""}`,
    };
  }
}

/** The mark of a motion. */
export function cross(context: CanvasRenderingContext2D, x: number, y: number, ink: string, paper: string) {
  outlined(context, [paper, 4], [ink, 1.8], () => {
    ring(context, [x, y], 7);
    for (const way of [-1, 1]) {
      stroke(context, [x + 4 * way, y], [x + 13 * way, y]);
      stroke(context, [x, y + 4 * way], [x, y + 13 * way]);
    }
  });
}

const FREE = ["start.height", "start.vx", "start.vy", "start.omega"];

/**
 * What a map's axes make of the start: rolling, or in any state, whichever way the motion that is shown starts.
 * `paths`: of the axes.
 */
export function otherStart(scenario: Scenario, paths: string[]) {
  const rolling = "speed" in scenario.start;
  if (!rolling && paths.includes("start.speed")) return "map.start_rolling";
  if (rolling && paths.some((path) => FREE.includes(path))) {
    return "map.start_free";
  }
  return "";
}
