// The bar of time: modes as coloured stretches, events as marks, and the hand that scrubs.

import { writing } from "./colors.js";
import { fitted, h } from "./dom.js";
import { clamp, niceStep, show, tickText, ticks } from "./numbers.js";
import { follow } from "./pointer.js";

/** @type {Record<string, string>} */
const MARKS = {
  takeoff: "▲",
  impact: "▼",
  apex: "•",
  jam: "✖",
  kane_gain: "✚",
  bounce_limit: "≋",
  turn: "↺",
  rest: "■",
  painleve_inconsistent: "◆",
  painleve_indeterminate: "◇",
  skim: "◗",
};

/** @type {Record<string, string>} */
export const EVENT_WORDS = {
  start: "start",
  slip_start: "slip begins",
  stick: "slip ends",
  slip_reversal: "slip turns round",
  takeoff: "take-off",
  impact: "landing",
  turn: "turns back",
  apex: "highest point",
  bounce_limit: "bounces end",
  painleve_inconsistent: "Painlevé: no solution",
  painleve_indeterminate: "Painlevé: several solutions",
  jam: "jam",
  kane_gain: "energy gain (Kane)",
  skim: "skimming begins",
  rest: "at rest",
  end: "end",
};

export class Timeline {
  /** @type {Film[]} */
  films;

  /** @param {Clock} clock */
  constructor(clock) {
    this.clock = clock;
    this.canvas = h("canvas", { class: "timeline-canvas" });
    this.tip = h("div", { class: "tip", hidden: true });
    this.element = h(
      "div",
      {
        class: "timeline",
        role: "slider",
        tabindex: "0",
        "aria-label": "Time",
        "aria-valuemin": "0",
        "aria-orientation": "horizontal",
      },
      this.canvas,
      this.tip,
    );
    this.element.addEventListener("pointerdown", (event) => this.scrub(event));
    this.element.addEventListener("pointermove", (event) => this.hover(event));
    this.element.addEventListener("pointerleave", () => (this.tip.hidden = true));
  }

  /** @param {PointerEvent} event */
  timeAt(event) {
    const box = this.canvas.getBoundingClientRect();
    return clamp((event.clientX - box.left) / box.width, 0, 1) * this.clock.duration;
  }

  /** @param {PointerEvent} event */
  scrub(event) {
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    const resume = this.clock.playing;
    this.clock.playing = false;
    const move = (/** @type {PointerEvent} */ moved) => this.clock.seek(this.timeAt(moved));
    move(event);
    follow(this.element, event, move, () => resume && this.clock.play(true));
  }

  /** @param {PointerEvent} event */
  hover(event) {
    const time = this.timeAt(event);
    const near = this.nearest(time, 8);
    const said = near
      ? `${EVENT_WORDS[near.kind] ?? near.kind} · ${show(near.t, 5)} s · ${show((near.angle * 180) / Math.PI, 4)}°`
      : `${show(time, 4)} s`;
    this.tip.textContent = said;
    this.tip.hidden = false;
    const box = this.canvas.getBoundingClientRect();
    this.tip.style.left = `${clamp(event.clientX - box.left, 70, box.width - 70)}px`;
  }

  /**
   * @param {number} time
   * @param {number} pixels
   */
  nearest(time, pixels) {
    const reach = (pixels * this.clock.duration) / (this.canvas.getBoundingClientRect().width || 1);
    let best = null;
    for (const film of this.films ?? []) {
      for (const event of film.events) {
        if (event.kind === "end") continue;
        const distance = Math.abs(event.t - time);
        if (distance <= reach && (!best || distance < Math.abs(best.t - time))) best = event;
      }
    }
    return best;
  }

  /**
   * @param {Film[]} films
   * @param {Look} look
   * @param {Colors} colors
   */
  draw(films, look, colors) {
    this.films = films;
    const { context, width, height } = fitted(this.canvas);
    const duration = this.clock.duration || 1;
    const place = (/** @type {number} */ t) => (t / duration) * width;
    context.clearRect(0, 0, width, height);
    const above = 15; // room for the marks of each hoop
    const band = (height - 15) / films.length - above;
    films.forEach((film, i) => {
      const y = above + i * (above + band);
      for (const phase of film.phases) {
        const from = place(phase.from);
        const wide = Math.max(place(phase.to) - from, 0.6);
        const color = colors.modes[phase.mode];
        context.fillStyle = color;
        context.fillRect(from, y, wide, band - 2);
        this.named(context, colors.mode_names[phase.mode], from, wide, y, band - 2, color, look);
      }
      if (film.duration < duration) {
        context.fillStyle = look.line;
        context.fillRect(place(film.duration), y, width, band - 2);
      }
      this.marks(context, film, place, y, width, look);
      if (films.length > 1) {
        context.fillStyle = look.soft;
        context.font = `600 11px ${look.font}`;
        context.textAlign = "left";
        context.fillText("AB"[i], 1, y - 4);
      }
    });
    const step = niceStep(duration, width / 60);
    context.fillStyle = look.soft;
    context.font = `10.5px ${look.font}`;
    for (const t of ticks(0, duration, width / 60)) {
      context.textAlign = t === 0 ? "left" : place(t) > width - 14 ? "right" : "center";
      context.fillText(tickText(t, step) + (t === 0 ? " s" : ""), place(t), height - 3);
    }
    const x = clamp(place(this.clock.time), 6, width - 6);
    const now = clamp(place(this.clock.time), 1, width - 1);
    context.fillStyle = look.ink;
    context.fillRect(now - 1, above - 4, 2, height - above - 9);
    context.beginPath();
    context.moveTo(x - 6, above - 10);
    context.lineTo(x + 6, above - 10);
    context.lineTo(now, above - 1);
    context.fill();
    this.element.setAttribute("aria-valuemax", duration.toFixed(3));
    this.element.setAttribute("aria-valuenow", this.clock.time.toFixed(3));
    this.element.setAttribute("aria-valuetext", `${show(this.clock.time, 4)} seconds`);
  }

  /**
   * The word of a mode inside its stretch, where it fits.
   * @param {CanvasRenderingContext2D} context
   * @param {string} word
   * @param {number} from
   * @param {number} wide
   * @param {number} y
   * @param {number} high
   * @param {string} color
   * @param {Look} look
   */
  named(context, word, from, wide, y, high, color, look) {
    context.font = `11px ${look.font}`;
    if (high < 13 || context.measureText(word).width + 8 > wide) return;
    context.fillStyle = writing(color);
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(word, from + 0.5 * wide, y + 0.5 * high + 1);
    context.textBaseline = "alphabetic";
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Film} film
   * @param {(t: number) => number} place
   * @param {number} top
   * @param {number} width
   * @param {Look} look
   */
  marks(context, film, place, top, width, look) {
    context.font = `11px ${look.font}`;
    context.textAlign = "center";
    let last = -Infinity;
    for (const event of film.events) {
      const mark = MARKS[event.kind];
      const x = place(event.t);
      if (event.kind !== "start" && event.kind !== "end") {
        context.fillStyle = look.panel;
        context.fillRect(x - 0.5, top, 1, 5);
      }
      if (!mark || x - last < 8) continue;
      last = x;
      context.fillStyle = look.ink;
      context.fillText(mark, clamp(x, 6, width - 6), top - 4);
    }
  }
}
