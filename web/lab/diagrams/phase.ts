// The (θ, θ̇) plane: which mode follows at each point without slip, and the motion's way through it.

import { disc, ring, stroke } from "../common/paint.ts";
import { hoopInk, faded, parsed } from "../common/colors.ts";
import { drawnAs, strokeThrough } from "./crowd.ts";
import { cellPicture, h, once } from "../common/dom.ts";
import { clamp, modulo, scaled } from "../common/clamp.ts";
import { Diagram, swatch } from "./diagram.ts";
import { placeOn, byFingers } from "../common/pointer.ts";
import { name, t } from "../words/words.ts";
import { niceStep, DEGREE } from "../common/numbers.ts";
import { tables } from "../../model/tables.ts";
import { drawAxes, marksOf } from "../common/axes.ts";

export class PhasePlane extends Diagram {
  zoomed = false;
  pictures: { window: number[]; paradox: Column; picture: HTMLCanvasElement }[];
  reach: number;
  forwards: boolean;
  backwards: boolean;
  keyed: boolean;
  sharpening: AbortController;

  hatched = h("span", { hidden: true }, "phase.hatched", " ");
  asked = "";
  soon = once(() => this.sharpen(), 140);

  constructor(
    readonly backend: Backend,
    public clock: Clock,
    public colors: Colors,
  ) {
    super("section.phase", {}, "phase.title");
    const hint = byFingers() ? "phase.hint_touch" : "phase.hint_mouse";
    this.element.append(h("p.hint", "phase.colours", " ", this.hatched, hint));
    name(this.body, "aria-label", "phase.label");
    this.body.addEventListener("pointerdown", (event) => this.seek(event));
  }

  /** The regions belong to hoop and plane alone: they are asked for when those change, or the reach grows. */
  async fetch(scenario: Scenario, signal: AbortSignal | undefined) {
    const reach = this.reach;
    const key = JSON.stringify([scenario.hoop, scenario.plane, reach]);
    if (key !== this.asked) {
      const whole = await this.painted(scenario, [0, 2 * Math.PI, -reach, reach], signal);
      this.asked = key;
      this.pictures = [whole];
      this.redraw();
    }
    if (this.zoomed) await this.sharpen();
  }

  // The part that is zoomed into, as fine as the whole.
  async sharpen() {
    this.sharpening?.abort();
    if (!this.pictures || this.isWhole()) return;
    this.sharpening = new AbortController();
    try {
      const part = await this.painted(
        this.films[this.active].scenario,
        [...this.windows.x, ...this.windows.y] as [number, number, number, number],
        this.sharpening.signal,
      );
      this.pictures = [this.pictures[0], part];
      this.redraw();
    } catch (error) {
      if (error.name !== "AbortError") throw error;
    }
  }

  async painted(scenario: Scenario, window: [number, number, number, number], signal: AbortSignal | undefined) {
    const { modes, paradox } = await this.backend.regions(scenario, window, signal);
    // an answer may be on its way already when it is given up
    signal?.throwIfAborted();
    const columns = paradox.length / 2;
    const colors = [...letters].map((letter) => parsed(this.colors.modes[letter]));
    const colorOf = (cell: number) => colors[modes[cell]] ?? NO_ANSWER;
    return { window, paradox, picture: cellPicture(columns, modes.length / columns, colorOf) };
  }

  // How far up the diagram goes: past nearly all of the motion, to a round number.
  findReach() {
    let most = 0;
    for (const film of this.films ?? []) {
      const rates = Float64Array.from(film.columns.omega, Math.abs).filter(Number.isFinite).sort();
      most = Math.max(most, rates[Math.floor(0.99 * (rates.length - 1))] ?? 0);
    }
    const step = niceStep(Math.max(most, 1) * 1.15, 4);
    return Math.ceil((Math.max(most, 1) * 1.12) / step) * step;
  }

  home() {
    this.zoomed = false;
    const [low, high] = [this.backwards ? -this.reach : 0, (this.forwards ? 1 : 0.12) * this.reach];
    this.windows = { x: [0, 2 * Math.PI], y: [low, high] };
    this.wholeAgain();
    this.redraw();
  }

  // Whether all is in sight that was computed for the whole.
  isWhole() {
    const { x, y } = this.windows;
    const wide = x[1] - x[0] >= 2 * Math.PI - 1e-9;
    return wide && (!this.zoomed || y[1] - y[0] >= 2 * this.reach - 1e-9);
  }

  // No finer part, nor one that is still being computed.
  wholeAgain() {
    this.sharpening?.abort();
    this.pictures?.splice(1);
  }

  zoom(factor: number, { x, y }: Place) {
    const { windows, reach } = this;
    this.zoomed = true;
    this.windows = {
      x: scaled(windows.x, x, factor).map((angle) => clamp(angle, 0, 2 * Math.PI)),
      y: scaled(windows.y, y, factor).map((rate) => clamp(rate, -reach, reach)),
    };
    if (this.isWhole()) this.wholeAgain();
    else this.soon();
    this.redraw();
  }

  draw(films: Film[], active: number, look: Look) {
    this.take(films, active, look);
    this.reach = this.findReach();
    const turns = (way: 1 | -1) => films.some((film) => film.columns.omega.some((value) => way * value > 0.3));
    this.backwards = turns(-1);
    this.forwards = turns(1) || !this.backwards;
    if (this.zoomed) this.redraw();
    else this.home();
  }

  redraw() {
    if (!this.films) return;
    const { colors, look } = this;
    const context = this.begin();
    this.clip(context);
    if (this.pictures) {
      context.imageSmoothingEnabled = false;
      for (const { picture, window } of this.pictures) {
        const [left, right, bottom, top] = window;
        const place = [this.x(left), this.y(top), this.x(right) - this.x(left), this.y(bottom) - this.y(top)];
        context.fillStyle = look.panel;
        context.fillRect(place[0], place[1], place[2], place[3]);
        context.globalAlpha = 0.35;
        context.drawImage(picture, place[0], place[1], place[2], place[3]);
        context.globalAlpha = 1;
      }
      const { paradox } = this.pictures[0];
      hatch(context, this, paradox);
      this.hatched.hidden = !paradox.some((side) => side !== 0);
    }
    for (const [lane, film] of this.films.entries()) this.way(context, film, lane);
    context.restore();
    axes(context, this);
    if (this.keyed !== look.dark) {
      this.keyed = look.dark;
      const names = Object.entries(colors.mode_names).filter(([letter]) => "RSKH".includes(letter));
      this.keys.replaceChildren(
        ...names.map(([letter, name]) => h("span.plot-key", swatch(colors.modes[letter]), name)),
      );
    }
    this.cursor(this.clock.time);
  }

  way(context: CanvasRenderingContext2D, film: Film, lane: number) {
    const { angle, omega } = film.columns;
    const turn = 2 * Math.PI;
    const [xs, ys]: number[][] = [[], []];
    const go = (th: number, rate: number) => {
      xs.push(this.x(th));
      ys.push(this.y(rate));
    };
    let last = Number.NaN;
    for (let i = 0; i < film.length; i++) {
      const lap = Math.floor(angle[i] / turn);
      if (lap !== last && Number.isFinite(lap + last)) {
        // leave on one side, come back on the other
        const out = lap > last ? turn : 0;
        go(out, omega[i]);
        go(Number.NaN, omega[i]);
        go(turn - out, omega[i]);
      }
      go(angle[i] - lap * turn, omega[i]);
      last = Number.isFinite(omega[i]) ? lap : Number.NaN;
    }
    const { broad, band } = drawnAs(xs, ys, this.edges());
    context.lineWidth = lane ? Math.min(broad, 1.2) : broad;
    context.setLineDash(lane ? [4, 3] : []);
    context.strokeStyle = this.films.length > 1 ? hoopInk(lane, this.look.dark) : this.look.ink;
    // where turns lie one over the other, all of them in a light tone
    context.globalAlpha = band ? 0.35 : 1;
    strokeThrough(context, xs, ys);
    context.globalAlpha = 1;
    context.setLineDash([]);
  }

  spot({ angle, omega }: Pick<Pose, "angle" | "omega">) {
    return [this.x(modulo(angle, 2 * Math.PI)), this.y(omega)];
  }

  cursor(time: number) {
    if (!this.films || !this.box) return;
    const context = this.beginOver();
    const { pointed } = this.clock;
    if (pointed !== null) {
      const [x, y] = this.spot(this.films[this.active].at(pointed));
      for (const radius of [6, 10]) ring(context, [x, y], radius, this.look.ink, 1.5);
    }
    this.films.forEach((film, lane) => {
      const pose = film.at(time);
      const [x, y] = this.spot(pose);
      const { left, right, top, bottom } = this.edges();
      if (!(x >= left && x <= right && y >= top && y <= bottom)) return;
      disc(context, [x, y], lane ? 4 : 5.5, this.colors.modes[pose.mode]);
      context.lineWidth = 2;
      context.strokeStyle = this.films.length > 1 ? hoopInk(lane, this.look.dark) : this.look.ink;
      context.stroke();
      if (this.films.length < 2) return;
      context.font = `700 12px ${this.look.font}`;
      context.textAlign = "left";
      context.fillStyle = context.strokeStyle;
      context.fillText("AB"[lane], x + 8, y - 6);
    });
  }

  /** The moment of the motion that passes nearest to where the finger points. */
  seek(event: PointerEvent) {
    const [px, py] = placeOn(this.body, event, this.look.px);
    if (this.pinched()) return;
    const film = this.films[this.active];
    const { angle, omega } = film.columns;
    let best = { distance: Infinity, t: 0 };
    for (let i = 0; i < film.length; i++) {
      const [x, y] = this.spot({ angle: angle[i], omega: omega[i] });
      const distance = Math.hypot(x - px, y - py);
      if (distance < best.distance) best = { distance, t: film.t[i] };
    }
    if (best.distance < 40) this.clock.seek(clamp(best.t, 0, film.duration));
  }
}

// --- What the plane of angle and rate is drawn of: the regions of modes, Painlevé's paradox, the axes

const { letters } = tables.words;

const NO_ANSWER = parsed("#6e6e6e"); // of the model
const BOTH = 2;

/** Where slip meets the paradox, for θ̇ < 0 and then for θ̇ > 0: hatched one way for spin and the other for skid. */
function hatch(context: CanvasRenderingContext2D, plane: PhasePlane, paradox: Column) {
  const columns = paradox.length / 2;
  const { left, right, top, bottom, height } = plane.edges();
  const middle = clamp(plane.y(0), top, bottom);
  const wide = plane.x((2 * Math.PI) / columns) - plane.x(0);
  context.strokeStyle = faded(plane.look.dark ? "#ffffff" : "#000000", 0.28);
  context.lineWidth = 1;
  for (const rises of [true, false]) {
    context.save();
    context.beginPath();
    for (const [k, side] of paradox.entries()) {
      if (!side || (side !== BOTH && side > 0 !== rises)) continue;
      const [up, down] = k < columns ? [middle, bottom] : [top, middle];
      context.rect(plane.x(0) + (k % columns) * wide, up, wide, down - up);
    }
    context.clip();
    const ends = rises ? [bottom, top] : [top, bottom];
    for (let x = left - height; x < right; x += 7) stroke(context, [x, ends[0]], [x + height, ends[1]]);
    context.restore();
  }
}

function axes(context: CanvasRenderingContext2D, plane: PhasePlane) {
  const { x, y } = plane.windows;
  const angles = x.map((angle) => angle / DEGREE);
  const step = angles[1] - angles[0] > 200 ? 45 : undefined;
  drawAxes(context, plane.look, plane, {
    across: { marks: marksOf(angles, 6, (angle) => plane.x(angle * DEGREE), step), name: t("phase.angle_axis") },
    up: { marks: marksOf(y, 5, (rate) => plane.y(rate)), name: "θ̇ [rad/s]" },
  });
}
