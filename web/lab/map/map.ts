// A map of motions over two parameters: it sharpens while one looks, zooms to any depth, and a click takes a motion.

import { scaledContext, h, once, say, selection } from "../common/dom.ts";
import { axisFont } from "../common/axes.ts";
import { focused, byFingers, follow, placeOn, zoomable } from "../common/pointer.ts";
import { AXES, cross, MapAxes, otherStart } from "./map_axes.ts";
import { cellAt, layerOf, legendOf, paint, stacked, textAt } from "./map_layers.ts";
import { messageOf } from "../words/words.ts";
import { clamp } from "../common/clamp.ts";
import type { Motions } from "../player/motions.ts";
import type { Story } from "../player/story.ts";

const LEVELS = [
  [24, 16],
  [72, 48],
  [216, 144],
  [432, 288],
];

export class MotionMap {
  film: Film;
  look: Look;
  asked: AbortController;
  stale: boolean;
  key_now: string;
  kind: string;
  level: number;
  pointed: Place | null = null;

  what = "sequence";
  layers: MapLayer[] = [];
  // only a map that is looked at is computed
  seen = false;
  axes = new MapAxes(this.setup.controls.map_axes);
  selects: Record<AxisName, HTMLSelectElement> = { x: this.pick("x"), y: this.pick("y") };
  quantity = selection(
    this.setup.map_quantities,
    (name) => `quantity.${name}`,
    (name) => {
      this.what = name;
      this.refresh();
    },
    { "aria-label": "map.quantity_label" },
  );
  canvas = h("canvas.plot-canvas");
  tip = h("div.tip", { hidden: true });
  body = h(
    "div.map-body",
    { tabindex: "0", role: "application", "aria-label": "map.instructions" },
    this.canvas,
    this.tip,
  );
  keys = h("div.map-keys");
  state = h("span.hint");
  element = h(
    "section.map",
    { "aria-label": "map.label" },
    h(
      "div.map-head",
      h("h2", "map.title"),
      h("label", "map.quantity", this.quantity),
      h("label", "map.across", this.selects.x),
      h("label", "map.up", this.selects.y),
      h(
        "span.buttons",
        h("button", { "aria-label": "map.zoom_in", onclick: () => this.zoom(0.5, this.aim()) }, "+"),
        h("button", { "aria-label": "map.zoom_out", onclick: () => this.zoom(2, this.aim()) }, "−"),
        h("button", { onclick: () => this.home() }, "map.zoom_home"),
      ),
      this.state,
    ),
    this.body,
    this.keys,
    h("p.hint", byFingers() ? "map.hint_touch" : "map.hint_mouse"),
  );
  soon = once(() => this.refresh(), 140);
  watch = new IntersectionObserver(([entry]) => {
    this.seen = entry.isIntersecting;
    if (this.seen && this.stale) this.refresh();
  });

  /** `moved`: called when it shows something else. */
  constructor(
    readonly setup: Setup,
    readonly backend: Backend,
    readonly clock: Clock,
    readonly motions: Motions,
    readonly story: Story,
    readonly moved: () => void,
  ) {
    takeHands(this);
    this.watch.observe(this.body);
    this.syncSelects();
  }

  pick(name: AxisName) {
    return selection(
      [...this.axes.known.keys()],
      (path) => `axis.${path}`,
      (path) => this.setAxis(name, path),
      { "data-axis": name },
    );
  }

  close() {
    this.asked?.abort();
    this.watch.disconnect();
  }

  syncSelects() {
    for (const name of AXES) this.selects[name].value = this.axes.paths[name];
  }

  setAxis(name: AxisName, path: string) {
    this.axes.choose(name, path);
    this.syncSelects();
    this.refresh();
  }

  home() {
    this.axes.home();
    this.refresh();
  }

  /** What the map depends on, apart from its own axes. */
  key_of(scenario: Scenario) {
    const rest: Named = structuredClone(scenario);
    for (const path of Object.values(this.axes.paths)) {
      const [section, name] = path.split(".");
      if (rest[section]) delete rest[section][name];
    }
    return JSON.stringify(rest);
  }

  /** The present motion has changed: move the mark, and compute again if the map is another one now. */
  mark(film: Film, look: Look) {
    this.film = film;
    this.look = look;
    const key = this.key_of(film.scenario);
    if (key !== this.key_now) {
      this.key_now = key;
      this.soon();
    }
    this.redraw();
  }

  // What a link says of it; nothing as long as it is as at first.
  shown() {
    const { paths, windows } = this.axes;
    if (this.what === "sequence" && this.axes.isHome() && paths.x === "start.speed" && paths.y === "plane.mu") return;
    const axis = (name: AxisName) => [paths[name], ...windows[name]] as [string, number, number];
    return { what: this.what, x: axis("x"), y: axis("y") };
  }

  restore(asked: NonNullable<ReturnType<MotionMap["shown"]>>) {
    if (![...this.quantity.options].some(({ value }) => value === asked.what) || !this.axes.restore(asked)) return;
    this.quantity.value = this.what = asked.what;
    this.syncSelects();
  }

  async refresh() {
    if (!this.film) return;
    this.moved();
    if (!this.seen) {
      this.stale = true;
      return;
    }
    this.stale = false;
    this.asked?.abort();
    this.asked = new AbortController();
    const { signal } = this.asked;
    const base = this.film.scenario;
    // maps know rigid contact only
    const changes: Change[] = base.contact.model === "rigid" ? [] : [["contact.model", "rigid"]];
    // the coarse layers stay below as long as they show the same quantity of the same motion
    const kind = `${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;
    if (kind !== this.kind) this.layers = [];
    this.kind = kind;
    this.tip.hidden = true; // it holds what was here before
    this.redraw();
    try {
      for (const [level, [x, y]] of LEVELS.entries()) {
        say(this.state, { key: "map.computing", values: { count: x * y } });
        const asked = { x: this.axes.asked("x", x), y: this.axes.asked("y", y) };
        const body = { scenario: base, changes, ...asked, what: this.what };
        const reply = await this.backend.map(body, signal);
        const layer = layerOf(reply);
        this.layers = stacked(this.layers, layer);
        this.keys.replaceChildren(...legendOf(layer));
        const other = otherStart(base, Object.values(this.axes.paths));
        const key = changes.length ? "map.count_rigid" : "map.count";
        const done = { key, values: { count: x * y } };
        say(this.state, other ? [done, "; ", other] : done);
        this.redraw();
        this.level = level + 1;
      }
    } catch (error) {
      if (error.name === "AbortError") return;
      say(this.state, messageOf(error));
    }
  }

  redraw() {
    if (!this.film) return;
    const { look } = this;
    const { context, width, height } = scaledContext(this.canvas, look.px);
    context.font = axisFont(look);
    this.axes.fit(width, height, (text) => context.measureText(text).width);
    this.axes.clip(context);
    context.imageSmoothingEnabled = false;
    const { axes } = this;
    for (const layer of this.layers) paint(context, layer, axes);
    const here = this.here();
    if (here) cross(context, axes.x(here.x), axes.y(here.y), look.ink, look.paper);
    if (this.pointed && focused(this.body)) {
      cross(context, axes.x(this.pointed.x), axes.y(this.pointed.y), "#D55E00", look.paper);
    }
    context.restore();
    axes.draw(context, look);
  }

  /** About what buttons and keys zoom: the mark, where it is in sight. */
  aim() {
    const place = (focused(this.body) && this.pointed) || this.here();
    const { windows } = this.axes;
    const seen = place && AXES.every((name) => place[name] >= windows[name][0] && place[name] <= windows[name][1]);
    return seen ? place : undefined;
  }

  // Where the present motion stands on the map.
  here() {
    const { paths } = this.axes;
    const place = { x: this.film.value(paths.x), y: this.film.value(paths.y) };
    return typeof place.x === "number" && typeof place.y === "number" ? place : null;
  }

  /** A place and what it holds, in words. */
  said(place: Place) {
    return `${this.axes.said(place)}: ${textAt(this.layers, place)}`;
  }

  /** Take the motion of a cell, with the roundest values that are within it. */
  take(place: Place) {
    const cell = cellAt(this.layers, place);
    const value = (name: AxisName) => (cell ? this.axes.round(name, cell[name], place[name]) : place[name]);
    this.clock.time = 0;
    this.motions.change(
      AXES.map((name) => [this.axes.paths[name], value(name)]),
      true,
    );
  }

  zoom(factor: number, center?: Place) {
    this.tip.hidden = true;
    if (!this.axes.zoom(factor, center)) return;
    this.redraw();
    this.soon();
  }
}

// --- Mouse, fingers and keys on a map: drag to move, a click or Enter takes a motion; it zooms as all pictures do

const WAYS: Named<[number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const STEPS = 48; // of the arrow keys across a map

function takeHands(map: MotionMap) {
  const { body } = map;
  let dragging = false;
  const pinched = zoomable(body, {
    zoom: (factor, at) => map.axes.box && map.zoom(1 / factor, at ? placeAt(map, at) : map.aim()),
    home: () => map.home(),
    keys: true,
  });
  body.addEventListener("pointerdown", (event) => press(map, event, pinched, (now) => (dragging = now)));
  body.addEventListener("pointermove", (event) => {
    if (map.axes.box && !dragging && event.pointerType !== "touch") hover(map, event);
  });
  body.addEventListener("pointerleave", () => (map.tip.hidden = true));
  body.addEventListener("keydown", (event) => key(map, event));
}

function placeAt(map: MotionMap, event: Point) {
  return map.axes.place(placeOn(map.body, event, map.look.px));
}

function hover(map: MotionMap, event: PointerEvent) {
  map.tip.textContent = map.said(placeAt(map, event));
  map.tip.hidden = false;
  const [x, y] = placeOn(map.body, event);
  const { clientWidth, clientHeight } = map.body;
  map.tip.style.left = `${clamp(x, 150, Math.max(clientWidth - 150, 150))}px`;
  map.tip.style.bottom = `${clientHeight - y + 16}px`;
}

function press(map: MotionMap, event: PointerEvent, pinched: () => boolean, drags: (now: boolean) => void) {
  event.preventDefault();
  map.body.focus({ preventScroll: true });
  const start = [event.clientX, event.clientY];
  const from = { x: [...map.axes.windows.x], y: [...map.axes.windows.y] };
  map.pointed = placeAt(map, event);
  let dragged = false;
  let scrolls = false;
  let twoFingers = pinched();
  const move = (moved: PointerEvent) => {
    twoFingers ||= pinched();
    if (twoFingers) return;
    const [dx, dy] = [moved.clientX - start[0], moved.clientY - start[1]];
    if (scrolls || (Math.hypot(dx, dy) < 5 && !dragged)) return;
    // a finger that starts upwards or downwards scrolls the page
    scrolls = !dragged && event.pointerType === "touch" && Math.abs(dy) >= Math.abs(dx);
    if (scrolls) return;
    dragged = true;
    drags(true);
    map.tip.hidden = true;
    map.axes.drag(from, dx / map.look.px, dy / map.look.px);
    map.redraw();
    map.soon();
  };
  follow(map.body, event, move, (_last, lifted) => {
    if (lifted && !dragged && !scrolls && !twoFingers && map.pointed) map.take(map.pointed);
    drags(false);
  });
}

function key(map: MotionMap, event: KeyboardEvent) {
  const place = map.pointed ?? map.here() ?? map.axes.middle();
  map.pointed = place;
  if (WAYS[event.key]) {
    const [dx, dy] = WAYS[event.key];
    const { x, y } = map.axes.windows;
    map.pointed = {
      x: clamp(place.x + (dx * (x[1] - x[0])) / STEPS, x[0], x[1]),
      y: clamp(place.y + (dy * (y[1] - y[0])) / STEPS, y[0], y[1]),
    };
    map.state.textContent = map.said(map.pointed);
    map.story.say(map.said(map.pointed));
  } else if (event.key === "Enter") map.take(place);
  else return;
  event.preventDefault();
  event.stopPropagation();
  map.redraw();
}
