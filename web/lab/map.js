// A map of motions over two parameters: it sharpens while one looks, zooms to any depth, and a click takes a motion.

import { SPEED_COLORS, parsed } from "./colors.js";
import { fitted, focused, h, once, pen } from "./dom.js";
import { clamp, niceStep, show, tickText, ticks, withUnit } from "./numbers.js";
import { follow, pinch } from "./pointer.js";

const [LEFT, LEFT_DEEP] = [62, 92]; // the numbers far in are longer
const RIGHT = 12;
const TOP = 10;
const BOTTOM = 36;
const LEVELS = [
  [24, 16],
  [72, 48],
  [216, 144],
];
const DEGREE = Math.PI / 180;
/** @type {AxisName[]} */
const AXES = ["x", "y"];

export class MotionMap {
  /** @type {Film} */
  film;
  /** @type {Look} */
  look;
  /** @type {Box} */
  box;
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
  /** @type {boolean} */
  dragging;
  /** @type {Place | null} */
  pointed = null;

  /**
   * @param {Backend} backend
   * @param {Setup} setup
   * @param {(changes: Change[]) => void} take what a click on a motion does
   */
  constructor(backend, setup, take) {
    this.backend = backend;
    this.onmotion = take;
    const { map_axes: axes } = setup.controls;
    this.known = new Map(axes.map((axis) => [axis.path, axis]));
    this.what = "sequence";
    /** @type {Record<AxisName, string>} */
    this.paths = { x: "start.speed", y: "plane.mu" };
    /** @type {Record<AxisName, number[]>} */
    this.windows = { x: [...this.axisOf("start.speed").range], y: [...this.axisOf("plane.mu").range] };
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
    this.state = h("span", { class: "hint", role: "status" });
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
        "Click to take that motion into the player; wheel or two fingers to zoom, drag to move.",
      ),
    );
    this.body.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.body.addEventListener("pointerdown", (event) => this.press(event));
    this.body.addEventListener("pointermove", (event) => this.hover(event));
    this.body.addEventListener("pointerleave", () => (this.tip.hidden = true));
    this.body.addEventListener("dblclick", () => this.zoom(0.35, this.pointed ?? undefined));
    this.body.addEventListener("keydown", (event) => this.key(event));
    this.pinched = pinch(this.body, (factor, at) => this.box && this.zoom(1 / factor, this.place(at)));
    this.left = LEFT;
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

  /**
   * What is known of the parameter on an axis.
   * @param {string} path
   */
  axisOf(path) {
    return /** @type {AxisInfo} */ (this.known.get(path));
  }

  syncSelects() {
    for (const name of AXES) this.selects[name].value = this.paths[name];
  }

  /**
   * @param {AxisName} name
   * @param {string} path
   */
  setAxis(name, path) {
    const other = name === "x" ? "y" : "x";
    if (this.paths[other] === path) {
      this.paths[other] = this.paths[name];
      this.windows[other] = [...this.windows[name]];
    }
    this.paths[name] = path;
    this.windows[name] = [...this.axisOf(path).range];
    this.syncSelects();
    this.home();
  }

  home() {
    for (const name of AXES) this.windows[name] = [...this.axisOf(this.paths[name]).range];
    this.refresh();
  }

  /**
   * What the map depends on, apart from its own axes.
   * @param {Scenario} scenario
   */
  key_of(scenario) {
    /** @type {Record<string, any>} */
    const rest = structuredClone(scenario);
    for (const path of Object.values(this.paths)) {
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

  async refresh() {
    if (!this.film) return;
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
    const kind = `${this.what} ${this.paths.x} ${this.paths.y} ${this.key_now}`;
    if (kind !== this.kind) this.layers = [];
    this.kind = kind;
    this.redraw();
    try {
      for (const [x, y] of LEVELS) {
        this.state.textContent = `computing ${x * y} motions …`;
        const body = { scenario: base, changes, x: this.axis("x", x), y: this.axis("y", y), what: this.what };
        const reply = await this.backend.call("map", body, signal);
        this.add(reply);
        this.state.textContent = `${x * y} motions${changes.length ? ", with rigid contact" : ""}`;
        this.redraw();
      }
      this.level = LEVELS.length;
    } catch (error) {
      const { name, message } = /** @type {Error} */ (error);
      if (name === "AbortError") return;
      this.state.textContent = message;
    }
    this.computing = false;
  }

  /**
   * @param {AxisName} name
   * @param {number} cells
   */
  axis(name, cells) {
    const [from, to] = this.windows[name];
    return { path: this.paths[name], from, to, cells };
  }

  /**
   * @param {Reply} reply
   */
  add({ header, arrays }) {
    /** @type {{ values: Float32Array }} */
    const { values } = /** @type {any} */ (arrays);
    const { x, y, classes } = /** @type {MapHeader} */ (header);
    const image = new ImageData(x.cells, y.cells);
    let [low, high] = [Infinity, -Infinity];
    if (!classes) {
      for (const value of values) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
      if (["hop_height", "flight_time", "energy_lost", "greatest_utilization"].includes(header.what))
        low = Math.min(low, 0);
    }
    const palette = classes?.map(({ color }) => parsed(color));
    for (let row = 0; row < y.cells; row++) {
      for (let column = 0; column < x.cells; column++) {
        const value = values[row * x.cells + column];
        const place = 4 * ((y.cells - 1 - row) * x.cells + column);
        if (!Number.isFinite(value)) continue;
        // a class ends where a neighbour is another: a darker edge tells pale ones apart
        const edge =
          palette &&
          ((column + 1 < x.cells && values[row * x.cells + column + 1] !== value) ||
            (row + 1 < y.cells && values[(row + 1) * x.cells + column] !== value));
        const color = palette
          ? palette[value].map((part) => (edge ? 0.72 * part : part))
          : SPEED_COLORS[clamp(Math.round((255 * (value - low)) / (high - low || 1)), 0, 255)];
        image.data.set([...color, 255], place);
      }
    }
    const picture = h("canvas", { width: x.cells, height: y.cells });
    pen(picture).putImageData(image, 0, 0);
    const layer = { picture, header, values, x: [x.from, x.to], y: [y.from, y.to], low, high };
    // layers that the new one covers whole are done with
    const inside = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
      a[0] >= b[0] - 1e-300 && a[1] <= b[1] + 1e-300;
    this.layers = this.layers.filter((old) => !(inside(old.x, layer.x) && inside(old.y, layer.y)));
    this.layers.push(layer);
    if (this.layers.length > 12) this.layers.shift();
    this.legend(layer);
  }

  /**
   * @param {MapLayer} layer
   */
  legend({ header, low, high, values }) {
    if (!header.classes) {
      const bar = h("canvas", { width: 120, height: 10, style: "width:120px;height:10px" });
      const context = pen(bar);
      for (let k = 0; k < 120; k++) {
        context.fillStyle = `rgb(${SPEED_COLORS[Math.floor((255 * k) / 119)].join(",")})`;
        context.fillRect(k, 0, 1, 10);
      }
      const scale = header.unit === "rad" ? 1 / DEGREE : 1;
      const unit = header.unit === "rad" ? "°" : header.unit === "1" ? "" : header.unit;
      this.keys.replaceChildren(
        h("span", {}, `${header.label}: ${high >= low ? show(low * scale, 3) : "none"} `),
        bar,
        h("span", {}, high >= low ? withUnit(show(high * scale, 3), unit) : ""),
        values.some((value) => !Number.isFinite(value)) ? h("span", {}, h("i", { class: "blank" }), "none") : "",
      );
      return;
    }
    const counts = new Map();
    for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
    const order = [...counts].filter(([code]) => code >= 0).sort((a, b) => b[1] - a[1]);
    const { classes } = header;
    this.keys.replaceChildren(
      ...order.slice(0, 10).map(([code]) => {
        const { color, text } = classes[code];
        return h("span", {}, h("i", { style: `background:${color}`, "aria-hidden": "true" }), text);
      }),
      order.length > 10 ? h("span", {}, `and ${order.length - 10} more`) : "",
    );
  }

  /** @param {number} value */
  x(value) {
    const [low, high] = this.windows.x;
    return this.left + ((value - low) / (high - low)) * this.box.width;
  }

  /** @param {number} value */
  y(value) {
    const [low, high] = this.windows.y;
    return TOP + (1 - (value - low) / (high - low)) * this.box.height;
  }

  redraw() {
    if (!this.film) return;
    const { look } = this;
    const { context, width, height } = fitted(this.canvas);
    this.left = this.deep("y") ? LEFT_DEEP : LEFT;
    this.box = { width: width - this.left - RIGHT, height: height - TOP - BOTTOM };
    context.clearRect(0, 0, width, height);
    context.save();
    context.beginPath();
    context.rect(this.left, TOP, this.box.width, this.box.height);
    context.clip();
    context.imageSmoothingEnabled = false;
    for (const layer of this.layers) {
      const [x0, x1] = layer.x.map((value) => this.x(value));
      const [y0, y1] = layer.y.map((value) => this.y(value));
      context.drawImage(layer.picture, x0, y1, x1 - x0, y0 - y1);
    }
    const here = this.here();
    if (here) this.cross(context, this.x(here.x), this.y(here.y), look.ink, look.paper);
    if (this.pointed && focused(this.body)) {
      this.cross(context, this.x(this.pointed.x), this.y(this.pointed.y), "#D55E00", look.paper);
    }
    context.restore();
    this.frame(context, height, look);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} x
   * @param {number} y
   * @param {string} ink
   * @param {string} paper
   */
  cross(context, x, y, ink, paper) {
    for (const [color, line] of /** @type {[string, number][]} */ ([
      [paper, 4],
      [ink, 1.8],
    ])) {
      context.strokeStyle = color;
      context.lineWidth = line;
      context.beginPath();
      context.arc(x, y, 7, 0, 2 * Math.PI);
      context.moveTo(x - 13, y);
      context.lineTo(x - 4, y);
      context.moveTo(x + 4, y);
      context.lineTo(x + 13, y);
      context.moveTo(x, y - 13);
      context.lineTo(x, y - 4);
      context.moveTo(x, y + 4);
      context.lineTo(x, y + 13);
      context.stroke();
    }
  }

  // Where the present motion stands on the map.
  here() {
    const value = (/** @type {string} */ path) => {
      const [section, name] = path.split(".");
      return this.film.values[path] ?? /** @type {Record<string, any>} */ (this.film.scenario)[section]?.[name];
    };
    const place = { x: value(this.paths.x), y: value(this.paths.y) };
    return typeof place.x === "number" && typeof place.y === "number" ? place : null;
  }

  /**
   * Whether the numbers on an axis would differ in digits only that have no room.
   * @param {AxisName} name
   */
  deep(name) {
    const [low, high] = this.windows[name];
    return high - low < 5e-5 * Math.max(Math.abs(low), Math.abs(high));
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} height
   * @param {Look} look
   */
  frame(context, height, look) {
    context.strokeStyle = look.soft;
    context.fillStyle = look.soft;
    context.lineWidth = 1;
    context.strokeRect(this.left + 0.5, TOP + 0.5, this.box.width - 1, this.box.height - 1);
    context.font = `11px ${look.font}`;
    for (const name of AXES) {
      const info = this.axisOf(this.paths[name]);
      const scale = info.degrees ? 1 / DEGREE : 1;
      const [low, high] = this.windows[name].map((value) => value * scale);
      const count = name === "x" ? this.box.width / 80 : this.box.height / 40;
      const step = niceStep(high - low, count);
      // far in, the labels show the distance from a rounded value that stands with the axis' name
      const deep = this.deep(name);
      const origin = deep ? Number((0.5 * (low + high)).toPrecision(12)) : 0;
      const all = deep ? ticks(low - origin, high - origin, count).map((v) => v + origin) : ticks(low, high, count);
      for (const value of all) {
        const text = deep ? show(value - origin, 3) : tickText(value, step);
        if (name === "x") {
          context.textAlign = "center";
          context.fillText(text, this.x(value / scale), TOP + this.box.height + 14);
        } else {
          context.textAlign = "right";
          context.textBaseline = "middle";
          context.fillText(text, this.left - 5, this.y(value / scale));
          context.textBaseline = "alphabetic";
        }
      }
      const offset = deep ? ` − ${String(origin).replace("-", "−")}` : "";
      const label = `${info.label}${offset}${info.unit ? ` [${info.unit}]` : ""}`;
      context.save();
      context.textAlign = "center";
      if (name === "x") context.translate(this.left + 0.5 * this.box.width, height - 5);
      else {
        context.translate(12, TOP + 0.5 * this.box.height);
        context.rotate(-Math.PI / 2);
      }
      context.fillText(label, 0, 0);
      context.restore();
    }
  }

  // --- hands ---------------------------------------------------------------------------------

  /**
   * @param {Point} event
   */
  place(event) {
    const box = this.body.getBoundingClientRect();
    const across = (event.clientX - box.left - this.left) / this.box.width;
    const up = 1 - (event.clientY - box.top - TOP) / this.box.height;
    const at = (/** @type {number[]} */ [low, high], /** @type {number} */ share) =>
      low + clamp(share, 0, 1) * (high - low);
    return { x: at(this.windows.x, across), y: at(this.windows.y, up) };
  }

  /** @param {Place} place */
  value(place) {
    for (const layer of [...this.layers].reverse()) {
      const { x, y } = layer.header;
      const column = Math.floor(((place.x - x.from) / (x.to - x.from)) * x.cells);
      const row = Math.floor(((place.y - y.from) / (y.to - y.from)) * y.cells);
      if (column < 0 || row < 0 || column >= x.cells || row >= y.cells) continue;
      const value = layer.values[row * x.cells + column];
      if (layer.header.classes) return layer.header.classes[value]?.text ?? "not allowed";
      const angle = layer.header.unit === "rad";
      const unit = angle ? "°" : layer.header.unit === "1" ? "" : layer.header.unit;
      return Number.isFinite(value) ? withUnit(show(angle ? value / DEGREE : value, 4), unit) : "none";
    }
    return "…";
  }

  /** @param {Place} place */
  said(place) {
    const part = (/** @type {AxisName} */ name) => {
      const info = this.axisOf(this.paths[name]);
      // as many digits as tell a cell from the next
      const [low, high] = this.windows[name];
      const size = Math.max(Math.abs(low), Math.abs(high));
      const digits = clamp(Math.ceil(Math.log10(size / (high - low))) + 4, 4, 16);
      return `${info.label} = ${withUnit(show(info.degrees ? place[name] / DEGREE : place[name], digits), info.unit)}`;
    };
    return `${part("x")}, ${part("y")}: ${this.value(place)}`;
  }

  /** @param {PointerEvent} event */
  hover(event) {
    if (!this.box || this.dragging || event.pointerType === "touch") return;
    const place = this.place(event);
    this.tip.textContent = this.said(place);
    this.tip.hidden = false;
    const box = this.body.getBoundingClientRect();
    this.tip.style.left = `${clamp(event.clientX - box.left, 150, Math.max(box.width - 150, 150))}px`;
    this.tip.style.bottom = `${box.bottom - event.clientY + 16}px`;
  }

  /** @param {PointerEvent} event */
  press(event) {
    event.preventDefault();
    this.body.focus({ preventScroll: true });
    const start = [event.clientX, event.clientY];
    const from = { x: [...this.windows.x], y: [...this.windows.y] };
    this.pointed = this.place(event);
    let twoFingers = this.pinched();
    const move = (/** @type {PointerEvent} */ moved) => {
      twoFingers ||= this.pinched();
      if (twoFingers) return;
      const [dx, dy] = [moved.clientX - start[0], moved.clientY - start[1]];
      if (Math.hypot(dx, dy) < 5 && !this.dragging) return;
      this.dragging = true;
      this.tip.hidden = true;
      const shift = (/** @type {AxisName} */ name, /** @type {number} */ part) =>
        from[name].map((value) => value + part * (from[name][1] - from[name][0]));
      this.windows.x = shift("x", -dx / this.box.width);
      this.windows.y = shift("y", dy / this.box.height);
      this.redraw();
      this.soon();
    };
    follow(this.body, event, move, (_last, lifted) => {
      if (lifted && !this.dragging && !twoFingers && this.pointed) this.take(this.pointed);
      this.dragging = false;
    });
  }

  /** @param {Place} place */
  take(place) {
    this.onmotion([
      [this.paths.x, place.x],
      [this.paths.y, place.y],
    ]);
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    if (!this.box) return;
    event.preventDefault();
    this.zoom(Math.exp(clamp(event.deltaY, -200, 200) * 0.0022), this.place(event));
  }

  /**
   * @param {number} factor
   * @param {Place} [center]
   */
  zoom(factor, center) {
    this.tip.hidden = true;
    /** @type {Record<AxisName, number[]>} */
    const next = { x: [], y: [] };
    for (const name of AXES) {
      const [low, high] = this.windows[name];
      const middle = center?.[name] ?? 0.5 * (low + high);
      next[name] = [middle - (middle - low) * factor, middle + (high - middle) * factor];
      // as deep as numbers go, and no further
      const size = Math.max(Math.abs(next[name][0]), Math.abs(next[name][1]), 1e-9);
      if (next[name][1] - next[name][0] < 400 * Number.EPSILON * size) return;
      const { range } = this.axisOf(this.paths[name]);
      if (next[name][1] - next[name][0] > 4 * (range[1] - range[0])) return;
    }
    this.windows = next;
    this.redraw();
    this.soon();
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    /** @type {Record<string, [number, number]>} */
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const middle = (/** @type {AxisName} */ name) => 0.5 * (this.windows[name][0] + this.windows[name][1]);
    this.pointed ??= this.here() ?? { x: middle("x"), y: middle("y") };
    if (ways[event.key]) {
      const [dx, dy] = ways[event.key];
      const step = (/** @type {AxisName} */ name, /** @type {number} */ way) =>
        (way * (this.windows[name][1] - this.windows[name][0])) / 48;
      this.pointed = { x: this.pointed.x + step("x", dx), y: this.pointed.y + step("y", dy) };
      this.state.textContent = this.said(this.pointed);
    } else if (event.key === "Enter") this.take(this.pointed);
    else if (event.key === "+" || event.key === "=") this.zoom(0.6, this.pointed);
    else if (event.key === "-") this.zoom(1.7, this.pointed);
    else if (event.key === "0") this.home();
    else return;
    event.preventDefault();
    event.stopPropagation();
    this.redraw();
  }
}
