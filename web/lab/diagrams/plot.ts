// One diagram: curves over time or angle, with modes behind them, a cursor that runs with the film, and zoom.

import { disc, haloed, stroke } from "../common/paint.ts";
import { axisFont, drawAxes, marksOf, named } from "../common/axes.ts";
import { faded, hoopInk, readable } from "../common/colors.ts";
import { type Crowd, drawnAs, strokeThrough } from "./crowd.ts";
import { h } from "../common/dom.ts";
import { clamp, extent, scaled } from "../common/clamp.ts";
import { Diagram, DASHES, swatch } from "./diagram.ts";
import { show } from "../common/numbers.ts";
import { follow, placeOn } from "../common/pointer.ts";
import { QUANTITIES } from "./quantities.ts";
import { name, t } from "../words/words.ts";

type Drawn = Curve & { film: Film; lane: number; number: number };

export class Plot extends Diagram {
  cut: { low: string; high: string } | null = null; // what the axis upwards leaves out
  picked: number[] | null;
  named: string;
  values: HTMLElement[];

  /** `curves(film)` gives [{name, color, dash, values}]; `shared` holds {axis, range} for all plots. */
  constructor(
    readonly definition: PlotDefinition,
    readonly shared: PlotShared,
  ) {
    super("section.plot", { "data-plot": definition.key }, definition.title);
    name(this.body, "aria-label", definition.title);
    this.body.addEventListener("pointerdown", (event) => this.press(event));
  }

  abscissa(film: Film) {
    return QUANTITIES[this.shared.axis].values(film);
  }

  fullRange() {
    if (this.shared.axis === "time") return [0, Math.max(...this.films.map((film) => film.duration), 1e-9)];
    const [low, high] = extent(this.films.flatMap((film) => [...this.abscissa(film)]));
    return high > low ? [low, high] : [low - 1, high + 1];
  }

  /** What it shows: enough for hands, and for the room of its legend, before any curve is drawn. */
  take(films: Film[], active: number, look: Look) {
    super.take(films, active, look);
    this.windows = { x: this.shared.range ?? this.fullRange(), y: this.windows?.y ?? [0, 1] };
    this.legend(this.shades(films[active], active), look.dark);
  }

  /** Curves and axes of what was taken; the cursor has its own canvas above. */
  draw(colors: Colors) {
    const { films, active } = this;
    const context = this.begin();
    const drawn = films.flatMap((film, lane) =>
      this.shades(film, lane)
        .map((curve, number) => ({ ...curve, film, lane, number }))
        .filter((curve, _, all) => this.compares(curve, lane, all.length)),
    );
    this.windows.y = this.definition.limits ?? this.findHeights(drawn);
    if (this.shared.axis === "time") this.bands(context, films[active], colors);
    grid(context, this);
    this.clip(context);
    const banded = drawn.map((curve) => this.curve(context, curve)).some(Boolean);
    const first = films.map((_, lane) => drawn.find((curve) => curve.lane === lane));
    if (films.length > 1) for (const curve of first) if (curve) this.letter(context, curve);
    const told = [this.cut && t("plot.cut", this.cut), banded && t("plot.band")].filter(Boolean);
    this.tell(context, told.join("; "));
    context.restore();
    this.describe(drawn);
  }

  /**
   * The curves as they are drawn: a dash for each quantity, in its colour; of two hoops in that of the hoop.
   */
  shades(film: Film, lane: number) {
    const { dark } = this.look;
    const two = this.films.length > 1;
    return this.definition
      .curves(film)
      .map(({ color, ...curve }, k) => ({
        ...curve,
        color: two ? hoopInk(lane, dark) : color && readable(color, dark),
        dash: DASHES[k % DASHES.length],
      }));
  }

  /** Whether it is drawn: of the hoop that is not chosen, of many curves only the total. */
  compares({ name }: Curve, lane: number, count: number) {
    return lane === this.active || count <= 2 || name === "curve.total";
  }

  findHeights(drawn: (Curve & { film: Film; lane: number })[]) {
    const seen: number[] = [];
    const [from, to] = this.windows.x;
    for (const { film, values } of drawn) {
      const across = this.abscissa(film);
      for (let i = 0; i < values.length; i++) {
        if (across[i] >= from && across[i] <= to && Number.isFinite(values[i])) seen.push(values[i]);
      }
    }
    const heights = heightsOf(seen);
    const [low, high] = extent([...seen, ...heights]);
    this.cut = low < heights[0] || high > heights[1] ? { low: show(low, 3), high: show(high, 3) } : null;
    return heights;
  }

  bands(context: CanvasRenderingContext2D, film: Film, colors: Colors) {
    const { left, right, top, height } = this.edges();
    for (const phase of film.phases) {
      const [from, to] = [phase.from, phase.to].map((time) => clamp(this.x(time), left, right));
      context.fillStyle = faded(colors.modes[phase.mode], 0.14);
      context.fillRect(from, top, to - from, height);
    }
  }

  curve(context: CanvasRenderingContext2D, { film, color, dash, number }: Drawn) {
    const [xs, ys]: number[][] = [[], []];
    for (const piece of film.pieces()) {
      const across = this.abscissa(piece.film);
      const { values } = this.definition.curves(piece.film)[number];
      for (let i = piece.from; i < piece.to; i++) {
        xs.push(this.x(across[i]));
        ys.push(clamp(this.y(values[i]), -1e4, 1e4));
      }
    }
    context.strokeStyle = context.fillStyle = color ?? this.look.ink;
    const { broad, band } = drawnAs(xs, ys, this.edges());
    if (band) this.band(context, band);
    context.lineWidth = broad;
    context.setLineDash(dash ?? []);
    if (band) {
      strokeThrough(
        context,
        band.map((_, x) => x + 0.5),
        band.map((crowd) => crowd?.mean ?? Number.NaN),
      );
    } else strokeThrough(context, xs, ys);
    context.setLineDash([]);
    return band !== null;
  }

  /** A range in a light tone, with its ends. */
  band(context: CanvasRenderingContext2D, band: (Crowd | null)[]) {
    context.globalAlpha = 0.22;
    for (const crowd of band) if (crowd) context.fillRect(crowd.x, crowd.low, 1, crowd.high - crowd.low);
    context.globalAlpha = 0.7;
    context.lineWidth = 0.8;
    const places = band.map((_, x) => x + 0.5);
    for (const end of ["low", "high"] as const) {
      const ends = band.map((crowd) => crowd?.[end] ?? Number.NaN);
      strokeThrough(context, places, ends);
    }
    context.globalAlpha = 1;
  }

  /** Which of two hoops a curve is of. */
  letter(context: CanvasRenderingContext2D, { film, lane, values, color }: Drawn) {
    const across = this.abscissa(film);
    const [from, to] = this.windows.x;
    const place = from + (lane ? 0.84 : 0.7) * (to - from);
    const i = across.findIndex((value) => value >= place);
    if (i < 0 || !Number.isFinite(values[i])) return;
    const { top, bottom } = this.edges();
    const [x, y] = [this.x(across[i]), clamp(this.y(values[i]) - 8, top + 10, bottom - 4)];
    context.font = `700 12px ${this.look.font}`;
    context.textAlign = "center";
    haloed(context, "AB"[lane], [x, y], color ?? this.look.ink, this.look.panel);
  }

  /** A word at the top of the axis. */
  tell(context: CanvasRenderingContext2D, text: string) {
    context.font = axisFont(this.look);
    context.textAlign = "left";
    haloed(context, text, [this.left + 6, this.top + 11], this.look.ink, this.look.panel);
  }

  legend(curves: Curve[], dark: boolean) {
    const names = curves.map((curve) => curve.name + curve.color + curve.dash).join() + dark;
    if (this.named !== names) {
      this.named = names;
      this.values = curves.map(() => h("span.value"));
      this.keys.replaceChildren(
        ...curves.map((curve, i) =>
          h("span.plot-key", swatch(curve.color, curve.dash), curve.name, " ", this.values[i]),
        ),
      );
    }
  }

  describe(drawn: (Curve & { film: Film; lane: number })[]) {
    const parts = drawn.slice(0, 6).map(({ name, values, lane }) => {
      const [low, high] = extent(values);
      const which = this.films.length > 1 ? `${"AB"[lane]}: ` : "";
      // what rounding leaves of a zero is zero
      const size = 1e-12 * Math.max(-low, high);
      const tidy = (value: number) => show(Math.abs(value) < size ? 0 : value, 3);
      const found = { name: t(name), low: tidy(low), high: tidy(high) };
      return high >= low ? `${which}${t("diagram.extent", found)}` : "";
    });
    const { title, unit } = this.definition;
    const head = t("diagram.description", { title: t(title), unit: t(unit) });
    this.body.setAttribute("aria-label", `${head} ${parts.filter(Boolean).join("; ")}.`);
  }

  cursor(time: number) {
    if (!this.box) return; // not drawn yet
    const { left, right, top, bottom, height } = this.edges();
    const context = this.beginOver();
    this.films.forEach((film, lane) => {
      const now = film.moment(time);
      const x = this.x(this.abscissa(now)[0]);
      const inside = x >= left - 1 && x <= right + 1;
      if (inside) {
        context.strokeStyle = this.look.soft;
        context.lineWidth = 1;
        stroke(context, [x, top], [x, bottom]);
      }
      this.shades(now, lane).forEach((curve, k, all) => {
        if (!this.compares(curve, lane, all.length)) return;
        const value = curve.values[0];
        if (lane === this.active && this.values?.[k]) this.values[k].textContent = show(value, 3);
        const y = this.y(value);
        if (!inside || !(y >= top - 1 && y <= bottom + 1)) return;
        disc(context, [x, y], 3.2, curve.color ?? this.look.ink);
      });
    });
    const { pointed } = this.shared.clock;
    if (pointed !== null && this.shared.axis === "time") {
      context.strokeStyle = this.look.ink;
      context.setLineDash([4, 3]);
      context.strokeRect(this.x(pointed), top, 0, height);
      context.setLineDash([]);
    }
    if (this.picked) {
      const [a, b] = this.picked;
      context.fillStyle = faded("#0072B2", 0.2);
      context.fillRect(Math.min(a, b), top, Math.abs(b - a), height);
    }
  }

  press(event: PointerEvent) {
    if (!this.films) return;
    const [start] = placeOn(this.body, event, this.look.px);
    const from = this.placeAt(event).x;
    let twoFingers = this.pinched();
    const move = (moved: PointerEvent) => {
      twoFingers ||= this.pinched();
      if (twoFingers) return;
      const [now] = placeOn(this.body, moved, this.look.px);
      this.picked = event.pointerType === "mouse" && Math.abs(now - start) > 5 ? [start, now] : null;
      if (event.pointerType !== "mouse") this.seek(this.placeAt(moved).x);
      this.cursor(this.shared.clock.time);
    };
    follow(this.body, event, move, (last, lifted) => {
      const to = this.placeAt(last).x;
      const { picked } = this;
      this.picked = null;
      if (picked && lifted) this.zoomTo(from < to ? [from, to] : [to, from]);
      else if (picked) this.cursor(this.shared.clock.time);
      else if (lifted && !twoFingers) this.seek(event.pointerType === "mouse" ? from : to);
    });
  }

  seek(value: number) {
    if (this.shared.axis === "time") return this.shared.clock.seek(value);
    // the time at which the angle is passed first after the present time, else at all
    const film = this.films[this.active];
    const across = this.abscissa(film);
    let best = 0;
    for (let i = 0; i < across.length; i++) {
      if (Math.abs(across[i] - value) < Math.abs(across[best] - value)) best = i;
    }
    return this.shared.clock.seek(film.t[best]);
  }

  zoom(factor: number, { x }: Place) {
    const full = this.fullRange();
    const [low, high] = scaled(this.windows.x, x, factor).map((value) => clamp(value, full[0], full[1]));
    this.zoomTo(low === full[0] && high === full[1] ? null : [low, high]);
  }

  home() {
    this.zoomTo(null);
  }

  zoomTo(range: number[] | null) {
    this.shared.range = range && range[1] - range[0] > 1e-9 ? range : null;
    this.shared.changed();
  }
}

// --- The axes of a diagram: their place, their ends, their numbers

/** From where to where an axis upwards goes for finite values. */
function heightsOf(values: number[]) {
  if (!values.length) return [0, 1];
  const sorted = Float64Array.from(values).sort();
  let [low, high] = [sorted[0], sorted[sorted.length - 1]];
  // a force that grows without bound must not flatten all else
  const [almostLow, almostHigh] = [
    sorted[Math.floor(0.02 * sorted.length)],
    sorted[Math.ceil(0.98 * sorted.length) - 1],
  ];
  const usual = almostHigh - almostLow;
  // what almost always is zero is of interest where it is not
  if (usual > 1e-6 * (high - low)) {
    if (high > almostHigh + 4 * usual) high = almostHigh + 0.6 * usual;
    if (low < almostLow - 4 * usual) low = almostLow - 0.6 * usual;
  }
  low = Math.min(low, 0);
  high = Math.max(high, 0);
  const margin = 0.06 * (high - low) || 1;
  return [low < 0 ? low - margin : low, high + margin];
}

/** Axes with their numbers, and a line across for each height. */
function grid(context: CanvasRenderingContext2D, plot: Plot) {
  const { width, height } = plot.box;
  const { x, y } = plot.windows;
  let tall = Math.max(height / 28, 4);
  const heights = () => marksOf(y, tall, (value) => plot.y(value));
  // one number alone gives no scale
  while (heights().length < 3 && tall < 12) tall += 1;
  const { name, unit } = QUANTITIES[plot.shared.axis];
  drawAxes(context, plot.look, plot, {
    up: { marks: heights(), name: t(plot.definition.unit) },
    across: { marks: marksOf(x, width / 70, (value) => plot.x(value)), name: named(name, unit) },
    lines: true,
  });
}
