// The bar of time: modes as coloured stretches, events as marks, the hand that scrubs; it zooms as all pictures do.

import { fill, outlined } from "../common/paint.ts";
import { hoopInk, writing } from "../common/colors.ts";
import { marksOf } from "../common/axes.ts";
import { scaledContext, h } from "../common/dom.ts";
import { eventWord, placed, stretches } from "./marks.ts";
import { clamp, scaled, within } from "../common/clamp.ts";
import { DEGREE, show } from "../common/numbers.ts";
import { follow, placeOn, zoomable } from "../common/pointer.ts";
import { t } from "../words/words.ts";

export class Timeline {
  films: Film[];
  said: string;

  /** the part of the motion that is seen; all of it by default */
  window: number[] | null = null;
  canvas = h("canvas.timeline-canvas");
  tip = h("div.tip", { hidden: true });
  element = h(
    "div.timeline",
    {
      role: "slider",
      tabindex: "0",
      "aria-label": "player.time",
      "aria-valuemin": "0",
      "aria-orientation": "horizontal",
    },
    this.canvas,
    this.tip,
  );
  pinched = zoomable(this.element, {
    zoom: (factor, at) => this.zoom(1 / factor, at ? this.timeAt(at) : this.clock.time),
    home: () => this.zoom(Infinity, 0),
    keys: true,
  });

  constructor(public clock: Clock) {
    this.element.addEventListener("pointerdown", (event) => this.scrub(event));
    this.element.addEventListener("pointermove", (event) => this.hover(event));
    this.element.addEventListener("pointerleave", () => (this.tip.hidden = true));
  }

  // The times at both ends of the bar.
  ends() {
    const whole = [0, this.clock.duration || 1];
    if (!this.window || this.window[1] - this.window[0] >= whole[1]) return whole;
    return within(this.window, whole);
  }

  /** `factor`: of the time that is seen. */
  zoom(factor: number, center: number) {
    const [from, to] = this.ends();
    const least = 1e-6 * this.clock.duration;
    const window = scaled([from, to], center, Math.max(factor, least / (to - from)));
    const whole = window[1] - window[0] >= this.clock.duration;
    this.window = whole ? null : within(window, [0, this.clock.duration]);
    this.clock.changed();
  }

  // Where it is zoomed in, it follows the time.
  keep() {
    if (!this.window) return;
    const [from, to] = this.ends();
    const { time, duration } = this.clock;
    if (time >= from && time <= to) return;
    const size = to - from;
    this.window = within(time > to ? [time - 0.1 * size, time + 0.9 * size] : [time - 0.5 * size, time + 0.5 * size], [
      0,
      duration,
    ]);
  }

  timeAt(event: Point) {
    const [from, to] = this.ends();
    return from + clamp(placeOn(this.canvas, event)[0] / this.canvas.clientWidth, 0, 1) * (to - from);
  }

  scrub(event: PointerEvent) {
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    const resume = this.clock.playing;
    this.clock.playing = false;
    const move = (moved: PointerEvent) => !this.pinched() && this.clock.seek(this.timeAt(moved));
    move(event);
    follow(this.element, event, move, () => resume && this.clock.play(true));
  }

  hover(event: PointerEvent) {
    const time = this.timeAt(event);
    const near = this.nearest(time, 8);
    const said = near
      ? `${t(eventWord(near.kind))} · ${show(near.t, 5)} s · ${show(near.angle / DEGREE, 4)}°`
      : `${show(time, 4)} s`;
    this.tip.textContent = said;
    this.tip.hidden = false;
    this.tip.style.left = `${clamp(placeOn(this.canvas, event)[0], 70, this.canvas.clientWidth - 70)}px`;
  }

  nearest(time: number, pixels: number) {
    const [from, to] = this.ends();
    const reach = (pixels * (to - from)) / (this.canvas.clientWidth || 1);
    const away = (event: MotionEvent) => Math.abs(event.t - time);
    const events = (this.films ?? []).flatMap((film) => film.events);
    const near = events.filter((event) => event.kind !== "end" && away(event) <= reach);
    return near.sort((a, b) => away(a) - away(b)).at(0);
  }

  draw(films: Film[], look: Look, colors: Colors) {
    this.films = films;
    const { context, width, height } = scaledContext(this.canvas, look.px);
    this.keep();
    const [begin, end] = this.ends();
    const place = (t: number) => ((t - begin) / (end - begin)) * width;
    const above = 15; // room for the marks of each hoop
    const band = (height - 15) / films.length - above;
    films.forEach((film, i) => {
      const y = above + i * (above + band);
      context.font = `11px ${look.font}`;
      context.textAlign = "center";
      context.textBaseline = "middle";
      for (const { mode, from, wide } of stretches(film.phases, place, width)) {
        const [color, word] = [colors.modes[mode], t(colors.mode_names[mode])];
        context.fillStyle = color;
        context.fillRect(from, y, wide, band - 2);
        if (band < 15 || context.measureText(word).width + 8 > wide) continue;
        context.fillStyle = writing(color);
        context.fillText(word, from + 0.5 * wide, y + 0.5 * band);
      }
      context.textBaseline = "alphabetic";
      if (film.duration < end) {
        context.fillStyle = look.line;
        context.fillRect(Math.max(place(film.duration), 0), y, width, band - 2);
      }
      this.marks(context, film, place, y, width, look);
      if (films.length > 1) {
        context.fillStyle = hoopInk(i, look.dark);
        context.font = `700 12px ${look.font}`;
        context.textAlign = "right";
        context.fillText("AB"[i], width - 1, y - 4);
      }
    });
    context.fillStyle = look.soft;
    context.font = `10.5px ${look.font}`;
    for (const [k, { at, text }] of marksOf([begin, end], width / 60, place).entries()) {
      context.textAlign = at < 14 ? "left" : at > width - 14 ? "right" : "center";
      context.fillText(k ? text : `${text} s`, at, height - 3);
    }
    const { pointed } = this.clock;
    if (pointed !== null && pointed >= begin && pointed <= end) {
      const at = clamp(place(pointed), 2, width - 2);
      outlined(context, [look.paper, 5], [look.ink, 1], (wide) => {
        context.fillRect(at - 0.5 * wide, above - 4, wide, height - above - 9);
        context.fillRect(at - 5 - 0.5 * wide, above - 4, 10 + wide, wide);
      });
    }
    const x = clamp(place(this.clock.time), 6, width - 6);
    const now = clamp(place(this.clock.time), 1, width - 1);
    context.fillStyle = look.ink;
    context.fillRect(now - 1, above - 4, 2, height - above - 9);
    fill(context, [x - 6, above - 10], [x + 6, above - 10], [now, above - 1]);
    this.tell(films, colors);
  }

  /** The time and the mode for a screen reader; while the film runs, only when the mode changes. */
  tell(films: Film[], colors: Colors) {
    const { time, duration, playing } = this.clock;
    const modes = films.map((film, i) => {
      const word = t(colors.mode_names[film.at(time).mode]);
      return films.length > 1 ? `${"AB"[i]} ${word}` : word;
    });
    const said = modes.join(", ");
    if (playing && said === this.said) return;
    this.said = said;
    this.element.ariaValueMax = duration.toFixed(3);
    this.element.ariaValueNow = time.toFixed(3);
    this.element.ariaValueText = t("player.time_value", { time: show(time, 4), what: said });
  }

  marks(
    context: CanvasRenderingContext2D,
    film: Film,
    place: (t: number) => number,
    top: number,
    width: number,
    look: Look,
  ) {
    const seen = film.events
      .filter(({ kind }) => kind !== "start" && kind !== "end")
      .map(({ kind, t }) => ({ kind, x: place(t) }))
      .filter(({ x }) => x >= -1 && x <= width + 1);
    context.fillStyle = look.panel;
    // lines between phases, unless there would be nothing but lines
    if (seen.length < width / 6) for (const { x } of seen) context.fillRect(x - 0.5, top, 1, 5);
    context.fillStyle = look.ink;
    for (const { mark, x } of placed(seen)) context.fillText(mark, clamp(x, 6, width - 6), top - 4);
  }
}
