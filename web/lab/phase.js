// The (θ, θ̇) plane: which mode follows at each point without slip, and the motion's way through it.

import { faded, hoopInk, parsed } from "./colors.js";
import { fitted, h, once, pen } from "./dom.js";
import { clamp, niceStep, tickText, ticks } from "./numbers.js";
import { swatch } from "./plot.js";
import { zoomable, zoomHint } from "./zoom.js";
import { t } from "./words.js";

const LEFT = 52;
const RIGHT = 10;
const TOP = 8;
const BOTTOM = 30;
const LETTERS = "RSKHM?";

export class PhasePlane {
  /** @type {Film[]} */
  films;
  /** @type {number} */
  active;
  /** @type {Look} */
  look;
  /** @type {Box} */
  box;
  /** @type {number[] | null} */
  window;
  /** @type {{ window: number[], paradox: Column, picture: HTMLCanvasElement }[]} */
  pictures;
  /** @type {number} */
  reached;
  /** @type {boolean} */
  forwards;
  /** @type {boolean} */
  backwards;
  /** @type {boolean} */
  keyed;
  /** @type {AbortController} */
  sharpening;

  /**
   * @param {Backend} backend
   * @param {Clock} clock
   * @param {Colors} colors
   */
  constructor(backend, clock, colors) {
    this.backend = backend;
    this.clock = clock;
    this.colors = colors;
    this.canvas = h("canvas", { class: "plot-canvas" });
    this.over = h("canvas", { class: "plot-canvas plot-over" });
    this.keys = h("div", { class: "plot-keys" });
    this.body = h(
      "div",
      {
        class: "plot-body",
        role: "img",
        tabindex: "0",
        "aria-label": "Plane of angle and angular velocity with the regions of rolling, slip and flight",
      },
      this.canvas,
      this.over,
    );
    this.element = h(
      "section",
      { class: "phase" },
      h("header", {}, h("h3", {}, "Plane of θ and θ̇"), this.keys),
      this.body,
      h(
        "p",
        { class: "hint" },
        "Colours: the mode that follows contact without slip. Hatched: slip that meets Painlevé’s paradox.",
        " ",
        `Click to go there; ${zoomHint("")}.`,
      ),
    );
    this.body.addEventListener("pointerdown", (event) => this.seek(event));
    this.pinched = zoomable(this.body, {
      zoom: (factor, at) => this.box && this.zoomAbout(at ? this.point(at) : this.middle(), 1 / factor),
      home: () => this.home(),
      keys: true,
    });
    this.range = [0, 2 * Math.PI];
    this.asked = "";
    this.soon = once(() => this.sharpen(), 140);
  }

  /**
   * The regions belong to hoop and plane alone: they are asked for when those change, or the reach grows.
   * @param {Scenario} scenario
   * @param {AbortSignal | undefined} signal
   */
  async fetch(scenario, signal) {
    const reach = this.reach();
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
        [...this.range, this.bottom(), this.top()],
        this.sharpening.signal,
      );
      this.pictures = [this.pictures[0], part];
      this.redraw();
    } catch (error) {
      if (/** @type {Error} */ (error).name !== "AbortError") throw error;
    }
  }

  /**
   * @param {Scenario} scenario
   * @param {number[]} window
   * @param {AbortSignal | undefined} signal
   */
  async painted(scenario, window, signal) {
    const { header, arrays } = await this.backend.call("regions", { scenario, window }, signal);
    // an answer may be on its way already when it is given up
    signal?.throwIfAborted();
    return {
      window: header.window,
      paradox: arrays.paradox,
      picture: this.paint(arrays.modes, arrays.paradox.length),
    };
  }

  reach() {
    return this.reached;
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
    return wide && (!this.window || this.window[1] - this.window[0] >= 2 * this.reach() - 1e-9);
  }

  // No finer part, nor one that is still being computed.
  wholeAgain() {
    this.sharpening?.abort();
    this.pictures?.splice(1);
  }

  /**
   * θ and θ̇ under a pointer.
   * @param {Point} event
   */
  point(event) {
    const box = this.body.getBoundingClientRect();
    const across = (event.clientX - box.left - LEFT) / this.box.width;
    const up = 1 - (event.clientY - box.top - TOP) / this.box.height;
    return [
      this.range[0] + across * (this.range[1] - this.range[0]),
      this.bottom() + up * (this.top() - this.bottom()),
    ];
  }

  middle() {
    return [0.5 * (this.range[0] + this.range[1]), 0.5 * (this.bottom() + this.top())];
  }

  /**
   * @param {number[]} center
   * @param {number} factor
   */
  zoomAbout([th, om], factor) {
    const low = Math.max(th - (th - this.range[0]) * factor, 0);
    const high = Math.min(th + (this.range[1] - th) * factor, 2 * Math.PI);
    const reach = this.reach();
    const down = Math.max(om - (om - this.bottom()) * factor, -reach);
    const up = Math.min(om + (this.top() - om) * factor, reach);
    this.range = [low, high];
    this.window = [down, up];
    if (this.isWhole()) this.wholeAgain();
    else this.soon();
    this.redraw();
  }

  bottom() {
    if (this.window) return this.window[0];
    return this.backwards ? -this.reach() : 0;
  }

  top() {
    return this.window ? this.window[1] : this.forwards ? this.reach() : 0.12 * this.reach();
  }

  /**
   * @param {Film[]} films
   * @param {number} active
   * @param {Look} look
   */
  draw(films, active, look) {
    this.films = films;
    this.active = active;
    this.look = look;
    this.reached = this.findReach();
    this.forwards = films.some((film) => film.columns.omega.some((value) => value > 0.3));
    this.backwards = films.some((film) => film.columns.omega.some((value) => value < -0.3));
    if (!this.forwards && !this.backwards) this.forwards = true;
    this.redraw();
  }

  /** @param {number} th */
  x(th) {
    return LEFT + ((th - this.range[0]) / (this.range[1] - this.range[0])) * this.box.width;
  }

  /** @param {number} rate */
  y(rate) {
    return TOP + (1 - (rate - this.bottom()) / (this.top() - this.bottom())) * this.box.height;
  }

  /**
   * @param {Column} codes by rows
   * @param {number} columns
   */
  paint(codes, columns) {
    const rows = codes.length / columns;
    const { modes } = this.colors;
    const picture = h("canvas", { width: columns, height: rows });
    const image = new ImageData(columns, rows);
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const letter = LETTERS[codes[row * columns + column]];
        const color = parsed(modes[letter] ?? "#6E6E6E");
        const place = 4 * ((rows - 1 - row) * columns + column);
        image.data.set([...color, 255], place);
      }
    }
    pen(picture).putImageData(image, 0, 0);
    return picture;
  }

  redraw() {
    if (!this.films) return;
    const { colors, look } = this;
    const { context, width, height } = fitted(this.canvas);
    this.box = { width: width - LEFT - RIGHT, height: height - TOP - BOTTOM };
    context.clearRect(0, 0, width, height);
    context.save();
    context.beginPath();
    context.rect(LEFT, TOP, this.box.width, this.box.height);
    context.clip();
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
      this.hatch(context);
    }
    for (const [lane, film] of this.films.entries()) this.way(context, film, lane);
    context.restore();
    this.axes(context, width, height);
    if (this.keyed !== look.dark) {
      this.keyed = look.dark;
      const names = Object.entries(colors.mode_names).filter(([letter]) => "RSKH".includes(letter));
      this.keys.replaceChildren(
        ...names.map(([letter, name]) => h("span", { class: "plot-key" }, swatch(colors.modes[letter]), name)),
      );
    }
    this.cursor(this.clock.time);
  }

  /**
   * Columns in which slip meets the paradox, hatched one way for spin and the other for skid.
   * @param {CanvasRenderingContext2D} context
   */
  hatch(context) {
    const { paradox } = this.pictures[0];
    const columns = paradox.length;
    context.strokeStyle = faded(this.look.dark ? "#ffffff" : "#000000", 0.28);
    context.lineWidth = 1;
    for (let from = 0; from < columns; from++) {
      if (!paradox[from]) continue;
      let to = from;
      while (to < columns && paradox[to] === paradox[from]) to++;
      const left = this.x((from * 2 * Math.PI) / columns);
      const right = this.x((to * 2 * Math.PI) / columns);
      context.save();
      context.beginPath();
      context.rect(left, TOP, right - left, this.box.height);
      context.clip();
      context.beginPath();
      const way = paradox[from];
      for (let c = -this.box.height; c < right - left + this.box.height; c += 7) {
        context.moveTo(left + c, way > 0 ? TOP + this.box.height : TOP);
        context.lineTo(left + c + this.box.height, way > 0 ? TOP : TOP + this.box.height);
      }
      context.stroke();
      context.restore();
      from = to;
    }
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Film} film
   * @param {number} lane
   */
  way(context, film, lane) {
    const { angle, omega, mode } = film.columns;
    const turn = 2 * Math.PI;
    context.lineWidth = lane ? 1.2 : 1.8;
    context.setLineDash(lane ? [4, 3] : []);
    context.strokeStyle = this.films.length > 1 ? hoopInk(lane, this.look.dark) : this.look.ink;
    context.beginPath();
    let last = null;
    for (let i = 0; i < film.length; i++) {
      if (!Number.isFinite(omega[i])) {
        last = null;
        continue;
      }
      const lap = Math.floor(angle[i] / turn);
      const th = angle[i] - lap * turn;
      if (last === null) context.moveTo(this.x(th), this.y(omega[i]));
      else if (lap !== last.lap) {
        // leave on one side, come back on the other
        const out = lap > last.lap ? turn : 0;
        context.lineTo(this.x(out), this.y(omega[i]));
        context.moveTo(this.x(turn - out), this.y(omega[i]));
        context.lineTo(this.x(th), this.y(omega[i]));
      } else context.lineTo(this.x(th), this.y(omega[i]));
      last = { lap, mode: mode[i] };
    }
    context.stroke();
    context.setLineDash([]);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   * @param {number} height
   */
  axes(context, width, height) {
    const { look } = this;
    context.font = `11px ${look.font}`;
    context.strokeStyle = look.soft;
    context.fillStyle = look.soft;
    context.lineWidth = 1;
    context.strokeRect(LEFT + 0.5, TOP + 0.5, this.box.width - 1, this.box.height - 1);
    context.textAlign = "center";
    const low = (this.range[0] * 180) / Math.PI;
    const high = (this.range[1] * 180) / Math.PI;
    const step = high - low > 200 ? 45 : niceStep(high - low, 6);
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9; k++) {
      const x = this.x((k * step * Math.PI) / 180);
      context.beginPath();
      context.moveTo(x, TOP + this.box.height);
      context.lineTo(x, TOP + this.box.height + 4);
      context.stroke();
      context.fillText(tickText(k * step, step), x, TOP + this.box.height + 15);
    }
    context.textAlign = "right";
    context.fillText(t("angle θ within a turn [°]"), width - RIGHT, height - 3);
    context.textBaseline = "middle";
    const span = this.top() - this.bottom();
    for (const value of ticks(this.bottom(), this.top(), 5)) {
      context.fillText(tickText(value, niceStep(span, 5)), LEFT - 6, this.y(value));
    }
    context.textBaseline = "alphabetic";
    context.save();
    context.translate(11, TOP + 0.5 * this.box.height);
    context.rotate(-Math.PI / 2);
    context.textAlign = "center";
    context.fillText("θ̇ [rad/s]", 0, 0);
    context.restore();
  }

  /** @param {number} time */
  cursor(time) {
    if (!this.films || !this.box) return;
    const { context, width, height } = fitted(this.over);
    context.clearRect(0, 0, width, height);
    this.films.forEach((film, lane) => {
      const pose = film.at(time);
      const turn = 2 * Math.PI;
      const th = pose.angle - Math.floor(pose.angle / turn) * turn;
      const x = this.x(th);
      const y = this.y(pose.omega);
      if (!(x >= LEFT && x <= LEFT + this.box.width && y >= TOP && y <= TOP + this.box.height)) return;
      context.beginPath();
      context.arc(x, y, lane ? 4 : 5.5, 0, 2 * Math.PI);
      context.fillStyle = this.colors.modes[pose.mode];
      context.fill();
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

  /**
   * The moment of the motion that passes nearest to where the finger points.
   * @param {PointerEvent} event
   */
  seek(event) {
    const box = this.body.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    if (this.pinched()) return;
    const film = this.films[this.active];
    const { angle, omega } = film.columns;
    const turn = 2 * Math.PI;
    let best = { distance: Infinity, t: 0 };
    for (let i = 0; i < film.length; i++) {
      const th = angle[i] - Math.floor(angle[i] / turn) * turn;
      const distance = Math.hypot(this.x(th) - px, this.y(omega[i]) - py);
      if (distance < best.distance) best = { distance, t: film.t[i] };
    }
    if (best.distance < 40) this.clock.seek(clamp(best.t, 0, film.duration));
  }
}
