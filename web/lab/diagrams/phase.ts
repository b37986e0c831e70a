// The (θ, θ̇) plane: which mode follows at each point without slip, and the motion's way through it.

import { disc, ring } from "../common/paint.ts";
import { hoopInk, faded, parsed } from "../common/colors.ts";
import { drawnAs, strokeThrough } from "./crowd.ts";
import { h, once, pen } from "../common/dom.ts";
import { clamp, modulo, scaled } from "../common/clamp.ts";
import { Diagram, LEFT, TOP, swatch } from "./diagram.ts";
import { placeOn, byFingers, zoomable } from "../common/pointer.ts";
import { name, t } from "../words/words.ts";
import { niceStep, DEGREE, tickText, ticks } from "../common/numbers.ts";
import { tables } from "../../model/tables.ts";
import { drawAxes } from "../common/axes.ts";

export class PhasePlane extends Diagram {
  window: number[] | null;
  pictures: { window: number[]; paradox: Column; picture: HTMLCanvasElement }[];
  reach: number;
  forwards: boolean;
  backwards: boolean;
  keyed: boolean;
  sharpening: AbortController;

  hatched = h("span", { hidden: true }, "phase.hatched", " ");
  asked = "";
  pinched = zoomable(this.body, {
    zoom: (factor, at) => this.box && this.zoomAbout(at ? this.point(at) : this.middle(), 1 / factor),
    home: () => this.home(),
    keys: true,
  });
  range: number[] = [0, 2 * Math.PI];
  soon = once(() => this.sharpen(), 140);

  constructor(
    readonly backend: Backend,
    public clock: Clock,
    public colors: Colors,
  ) {
    super({ class: "phase" }, "phase.title");
    const hint = byFingers() ? "phase.hint_touch" : "phase.hint_mouse";
    this.element.append(h("p", { class: "hint" }, "phase.colours", " ", this.hatched, hint));
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
    if (this.window) await this.sharpen();
  }

  // The part that is zoomed into, as fine as the whole.
  async sharpen() {
    this.sharpening?.abort();
    if (!this.pictures || this.isWhole()) return;
    this.sharpening = new AbortController();
    try {
      const part = await this.painted(
        this.films[this.active].scenario,
        [...this.range, this.bottom(), this.top()] as [number, number, number, number],
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
    return { window, paradox, picture: pictureOf(modes, paradox.length / 2, this.colors.modes) };
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
    this.range = [0, 2 * Math.PI];
    this.window = null;
    this.wholeAgain();
    this.redraw();
  }

  // Whether all is in sight that was computed for the whole.
  isWhole() {
    const [low, high] = this.range;
    const wide = high - low >= 2 * Math.PI - 1e-9;
    return wide && (!this.window || this.window[1] - this.window[0] >= 2 * this.reach - 1e-9);
  }

  // No finer part, nor one that is still being computed.
  wholeAgain() {
    this.sharpening?.abort();
    this.pictures?.splice(1);
  }

  /** θ and θ̇ under a pointer. */
  point(event: Point) {
    const [x, y] = placeOn(this.body, event, this.look.px);
    const [across, up] = [(x - LEFT) / this.box.width, 1 - (y - TOP) / this.box.height];
    return [
      this.range[0] + across * (this.range[1] - this.range[0]),
      this.bottom() + up * (this.top() - this.bottom()),
    ];
  }

  middle() {
    return [0.5 * (this.range[0] + this.range[1]), 0.5 * (this.bottom() + this.top())];
  }

  zoomAbout([th, om]: number[], factor: number) {
    const reach = this.reach;
    const window = scaled([this.bottom(), this.top()], om, factor);
    this.range = scaled(this.range, th, factor).map((angle) => clamp(angle, 0, 2 * Math.PI));
    this.window = window.map((rate) => clamp(rate, -reach, reach));
    if (this.isWhole()) this.wholeAgain();
    else this.soon();
    this.redraw();
  }

  bottom() {
    if (this.window) return this.window[0];
    return this.backwards ? -this.reach : 0;
  }

  top() {
    return this.window ? this.window[1] : this.forwards ? this.reach : 0.12 * this.reach;
  }

  draw(films: Film[], active: number, look: Look) {
    this.films = films;
    this.active = active;
    this.look = look;
    this.reach = this.findReach();
    this.forwards = films.some((film) => film.columns.omega.some((value) => value > 0.3));
    this.backwards = films.some((film) => film.columns.omega.some((value) => value < -0.3));
    if (!this.forwards && !this.backwards) this.forwards = true;
    this.redraw();
  }

  x(th: number) {
    return LEFT + ((th - this.range[0]) / (this.range[1] - this.range[0])) * this.box.width;
  }

  y(rate: number) {
    return TOP + (1 - (rate - this.bottom()) / (this.top() - this.bottom())) * this.box.height;
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
        ...names.map(([letter, name]) => h("span", { class: "plot-key" }, swatch(colors.modes[letter]), name)),
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
    const { broad, band } = drawnAs(xs, ys, this.frame());
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
      context.strokeStyle = this.look.ink;
      context.lineWidth = 1.5;
      for (const radius of [6, 10]) ring(context, [x, y], radius);
    }
    this.films.forEach((film, lane) => {
      const pose = film.at(time);
      const [x, y] = this.spot(pose);
      if (!(x >= LEFT && x <= LEFT + this.box.width && y >= TOP && y <= TOP + this.box.height)) return;
      context.fillStyle = this.colors.modes[pose.mode];
      disc(context, [x, y], lane ? 4 : 5.5);
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

/** `codes`: by rows; `colors`: of the modes. */
function pictureOf(codes: Column, columns: number, colors: Record<string, string>) {
  const rows = codes.length / columns;
  const picture = h("canvas", { width: columns, height: rows });
  const image = new ImageData(columns, rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const letter = letters[codes[row * columns + column]]; // none where the model has no answer
      const color = parsed(colors[letter] ?? "#6E6E6E");
      const place = 4 * ((rows - 1 - row) * columns + column);
      image.data.set([...color, 255], place);
    }
  }
  pen(picture).putImageData(image, 0, 0);
  return picture;
}

const BOTH = 2;

/** Where slip meets the paradox, for θ̇ < 0 and for θ̇ > 0: hatched one way for spin and the other for skid. */
function hatch(context: CanvasRenderingContext2D, plane: PhasePlane, paradox: Column) {
  const columns = paradox.length / 2;
  const [top, middle, bottom] = [TOP, clamp(plane.y(0), TOP, TOP + plane.box.height), TOP + plane.box.height];
  context.strokeStyle = faded(plane.look.dark ? "#ffffff" : "#000000", 0.28);
  context.lineWidth = 1;
  for (const [first, up, down] of [
    [0, middle, bottom],
    [columns, top, middle],
  ]) {
    for (let from = 0; from < columns; from++) {
      const side = paradox[first + from];
      if (!side) continue;
      let to = from;
      while (to < columns && paradox[first + to] === side) to++;
      const left = plane.x((from * 2 * Math.PI) / columns);
      const right = plane.x((to * 2 * Math.PI) / columns);
      context.save();
      context.beginPath();
      context.rect(left, up, right - left, down - up);
      context.clip();
      context.beginPath();
      const { height } = plane.box;
      for (let c = -height; c < right - left + height; c += 7) {
        for (const rises of side === BOTH ? [true, false] : [side > 0]) {
          context.moveTo(left + c, rises ? bottom : top);
          context.lineTo(left + c + height, rises ? top : bottom);
        }
      }
      context.stroke();
      context.restore();
      from = to;
    }
  }
}

export function axes(context: CanvasRenderingContext2D, plane: PhasePlane) {
  const { look, box } = plane;
  const [low, high] = plane.range.map((angle) => angle / DEGREE);
  const step = high - low > 200 ? 45 : niceStep(high - low, 6);
  const angles = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9; k++) angles.push(k * step);
  const tall = niceStep(plane.top() - plane.bottom(), 5);
  drawAxes(
    context,
    look,
    { left: LEFT, top: TOP, box },
    {
      across: {
        marks: angles.map((angle) => ({ at: plane.x(angle * DEGREE), text: tickText(angle, step) })),
        name: t("phase.angle_axis"),
      },
      up: {
        marks: ticks(plane.bottom(), plane.top(), 5).map((rate) => ({ at: plane.y(rate), text: tickText(rate, tall) })),
        name: "θ̇ [rad/s]",
      },
    },
  );
}
