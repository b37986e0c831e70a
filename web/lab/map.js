// A map of motions over two parameters: it sharpens while one looks, zooms to any depth, and a click takes a motion.

import { fitted, focused, h, once, say } from "./dom.js";
import { AXES, cross, MapAxes } from "./map_axes.js";
import { takeHands } from "./map_hands.js";
import { otherStart } from "./map_words.js";
import { byFingers } from "./zoom.js";
import { layerOf, legendOf, stacked, textAt } from "./map_layers.js";
import { saidOf } from "./words.js";

const LEVELS = [
  [24, 16],
  [72, 48],
  [216, 144],
];

export class MotionMap {
  /** @type {Film} */
  film;
  /** @type {Look} */
  look;
  /** @type {AbortController} */
  asked;
  /** @type {boolean} */
  stale;
  /** @type {boolean} */
  computing;
  /** @type {string} */
  key_now;
  /** @type {string} */
  kind;
  /** @type {number} */
  level;
  /** @type {Place | null} */
  pointed = null;

  /**
   * @param {Backend} backend
   * @param {Setup} setup
   * @param {object} rest
   * @param {(changes: Change[]) => void} rest.take what a click on a motion does
   * @param {(text: string) => void} rest.say for a screen reader
   * @param {() => void} rest.changed another part of it is looked at
   */
  constructor(backend, setup, { take, say, changed }) {
    this.backend = backend;
    this.onmotion = take;
    this.say = say;
    this.changed = changed;
    const axes = setup.controls.map_axes;
    this.axes = new MapAxes(axes);
    this.what = "sequence";
    /** @type {MapLayer[]} */
    this.layers = [];
    this.canvas = h("canvas", { class: "plot-canvas" });
    this.tip = h("div", { class: "tip", hidden: true });
    this.body = h(
      "div",
      {
        class: "map-body",
        tabindex: "0",
        role: "application",
        "aria-label": "Map of motions. Arrow keys move the mark, Enter takes the motion, plus and minus zoom.",
      },
      this.canvas,
      this.tip,
    );
    this.keys = h("div", { class: "map-keys" });
    this.state = h("span", { class: "hint" });
    /** @type {(name: AxisName) => HTMLSelectElement} */
    const pick = (name) => {
      const select = h(
        "select",
        { "data-axis": name, onchange: () => this.setAxis(name, select.value) },
        axes.map(({ path, label }) => h("option", { value: path }, label)),
      );
      return select;
    };
    this.selects = { x: pick("x"), y: pick("y") };
    this.quantity = h(
      "select",
      {
        "aria-label": "What the map shows",
        onchange: () => {
          this.what = this.quantity.value;
          this.refresh();
        },
      },
      setup.map_quantities.map(([name, words]) => h("option", { value: name }, words)),
    );
    this.element = h(
      "section",
      { class: "map", "aria-label": "Map of motions" },
      h(
        "div",
        { class: "map-head" },
        h("h2", {}, "Map"),
        h("label", {}, "of", this.quantity),
        h("label", {}, "Across", this.selects.x),
        h("label", {}, "Up", this.selects.y),
        h(
          "span",
          { class: "buttons" },
          h("button", { type: "button", "aria-label": "Zoom into the map", onclick: () => this.zoom(0.5) }, "+"),
          h("button", { type: "button", "aria-label": "Zoom out of the map", onclick: () => this.zoom(2) }, "−"),
          h("button", { type: "button", onclick: () => this.home() }, "Whole map"),
        ),
        this.state,
      ),
      this.body,
      this.keys,
      h(
        "p",
        { class: "hint" },
        byFingers()
          ? "Click to take that motion into the player; two fingers zoom."
          : "Click to take that motion into the player; once clicked, or with Ctrl, the wheel zooms; drag to move; double-click for all.",
      ),
    );
    takeHands(this);
    this.soon = once(() => this.refresh(), 140);
    // only a map that is looked at is computed
    this.seen = false;
    this.watch = new IntersectionObserver(([entry]) => {
      this.seen = entry.isIntersecting;
      if (this.seen && this.stale) this.refresh();
    });
    this.watch.observe(this.body);
    this.syncSelects();
  }

  close() {
    this.asked?.abort();
    this.watch.disconnect();
  }

  syncSelects() {
    for (const name of AXES) this.selects[name].value = this.axes.paths[name];
  }

  /**
   * @param {AxisName} name
   * @param {string} path
   */
  setAxis(name, path) {
    this.axes.choose(name, path);
    this.syncSelects();
    this.refresh();
  }

  home() {
    this.axes.home();
    this.refresh();
  }

  /**
   * What the map depends on, apart from its own axes.
   * @param {Scenario} scenario
   */
  key_of(scenario) {
    /** @type {Record<string, any>} */
    const rest = structuredClone(scenario);
    for (const path of Object.values(this.axes.paths)) {
      const [section, name] = path.split(".");
      if (rest[section]) delete rest[section][name];
    }
    return JSON.stringify(rest);
  }

  /**
   * The present motion has changed: move the mark, and compute again if the map is another one now.
   * @param {Film} film
   * @param {Look} look
   */
  mark(film, look) {
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
    const axis = (/** @type {AxisName} */ name) =>
      /** @type {[string, number, number]} */ ([paths[name], ...windows[name]]);
    return { what: this.what, x: axis("x"), y: axis("y") };
  }

  /** @param {NonNullable<ReturnType<MotionMap["shown"]>>} asked */
  restore(asked) {
    if (![...this.quantity.options].some(({ value }) => value === asked.what) || !this.axes.restore(asked)) return;
    this.quantity.value = this.what = asked.what;
    this.syncSelects();
  }

  async refresh() {
    if (!this.film) return;
    this.changed();
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
    const changes = base.contact.model === "rigid" ? [] : [["contact.model", "rigid"]];
    this.computing = true;
    // the coarse layers stay below as long as they show the same quantity of the same motion
    const kind = `${this.what} ${this.axes.paths.x} ${this.axes.paths.y} ${this.key_now}`;
    if (kind !== this.kind) this.layers = [];
    this.kind = kind;
    this.redraw();
    try {
      for (const [x, y] of LEVELS) {
        say(this.state, { key: "computing {count} motions …", values: { count: x * y } });
        const asked = { x: this.axes.asked("x", x), y: this.axes.asked("y", y) };
        const body = { scenario: base, changes, ...asked, what: this.what };
        const reply = await this.backend.call("map", body, signal);
        const layer = layerOf(reply);
        this.layers = stacked(this.layers, layer);
        this.keys.replaceChildren(...legendOf(layer));
        const other = otherStart(base, Object.values(this.axes.paths));
        const key = changes.length ? "{count} motions, with rigid contact" : "{count} motions";
        const done = { key, values: { count: x * y } };
        say(this.state, other ? [done, "; ", other] : done);
        this.redraw();
      }
      this.level = LEVELS.length;
    } catch (error) {
      if (/** @type {Error} */ (error).name === "AbortError") return;
      say(this.state, saidOf(error));
    }
    this.computing = false;
  }

  redraw() {
    if (!this.film) return;
    const { look } = this;
    const { context, width, height } = fitted(this.canvas);
    this.axes.fit(width, height);
    context.clearRect(0, 0, width, height);
    context.save();
    this.axes.clip(context);
    context.imageSmoothingEnabled = false;
    const { axes } = this;
    for (const layer of this.layers) {
      const [x0, x1] = layer.x.map((value) => axes.x(value));
      const [y0, y1] = layer.y.map((value) => axes.y(value));
      context.drawImage(layer.picture, x0, y1, x1 - x0, y0 - y1);
    }
    const here = this.here();
    if (here) cross(context, axes.x(here.x), axes.y(here.y), look.ink, look.paper);
    if (this.pointed && focused(this.body)) {
      cross(context, axes.x(this.pointed.x), axes.y(this.pointed.y), "#D55E00", look.paper);
    }
    context.restore();
    axes.draw(context, height, look);
  }

  // Where the present motion stands on the map.
  here() {
    const value = (/** @type {string} */ path) => {
      const [section, name] = path.split(".");
      return this.film.values[path] ?? /** @type {Record<string, any>} */ (this.film.scenario)[section]?.[name];
    };
    const place = { x: value(this.axes.paths.x), y: value(this.axes.paths.y) };
    return typeof place.x === "number" && typeof place.y === "number" ? place : null;
  }

  /**
   * A place and what it holds, in words.
   * @param {Place} place
   */
  said(place) {
    return `${this.axes.said(place)}: ${textAt(this.layers, place)}`;
  }

  /** @param {Place} place */
  take(place) {
    this.onmotion([
      [this.axes.paths.x, place.x],
      [this.axes.paths.y, place.y],
    ]);
  }

  /**
   * @param {number} factor
   * @param {Place} [center]
   */
  zoom(factor, center) {
    this.tip.hidden = true;
    if (!this.axes.zoom(factor, center)) return;
    this.redraw();
    this.soon();
  }
}
