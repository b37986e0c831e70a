// The picture of the hoops, in the plane or in space, with what stands on it: readout, colours of speed, key.

import { SPEED_TEXTS } from "./colors.js";
import { h } from "./dom.js";
import { degrees, length, show, withUnit } from "./numbers.js";
import { Stage2D } from "./stage2d.js";
import { Stage3D } from "./stage3d.js";
import { local, name, t } from "./words.js";

const OUTPUTS = ["hoop", "mode", "time", "angle", "v", "R θ̇", "gap"];

export class Stage {
  /**
   * @param {Colors} colors
   * @param {() => void} onview what to do when it is seen from elsewhere
   */
  constructor(colors, onview) {
    this.colors = colors;
    this.onview = onview;
    /** @type {StageOptions} */
    this.options = { traces: true, forces: true, speed: true, whole: false, three: false, ahead: false };
    this.plane = h("canvas", { class: "stage-canvas" });
    this.space = h("canvas", { class: "stage-canvas", hidden: true });
    this.flat = new Stage2D(this.plane, onview);
    /** @type {Stage3D | null} */
    this.deep = null; // made when it is first asked for
    this.outputs = OUTPUTS.map((name) => ({ name: h("dt", {}, name), value: h("dd", {}) }));
    this.outputs[1].value.className = "mode";
    this.fastest = h("span", {});
    this.legend = h(
      "div",
      { class: "legend", "aria-hidden": "true" },
      h("i", { style: `background: linear-gradient(90deg, ${SPEED_TEXTS.filter((_, k) => k % 15 === 0).join(",")})` }),
      h("span", {}, "0"),
      h("span", {}, "rim speed"),
      this.fastest,
    );
    /** @type {(color: string, words: string) => HTMLElement} */
    const dot = (color, words) => h("span", {}, h("i", { class: "dot", style: `background:${color}` }), words);
    this.order = h("span", { hidden: true }, "A in front, B behind");
    this.element = h(
      "div",
      { class: "stage", role: "img", "aria-label": "The hoop", tabindex: "0" },
      this.plane,
      this.space,
      h(
        "dl",
        { class: "readout", "aria-hidden": "true" },
        this.outputs.flatMap(({ name, value }) => [name, value]),
      ),
      this.legend,
      h(
        "div",
        { class: "stage-keys", "aria-hidden": "true" },
        dot("var(--ink)", "load"),
        dot(colors.gravity_center, "centre of gravity"),
        dot(colors.airborne, "the same in flight"),
        this.order,
      ),
    );
  }

  // The canvas that is seen now.
  canvas() {
    return this.options.three ? this.space : this.plane;
  }

  /**
   * @param {Film[]} films
   * @param {number} active
   * @param {Clock} clock
   * @param {{ look: Look, inks: Colors }} theme
   */
  draw(films, active, clock, { look, inks }) {
    const { options } = this;
    this.legend.hidden = !options.speed;
    this.order.hidden = !(options.three && films.length > 1);
    this.fastest.textContent = `≥ ${show(Math.max(...films.map((film) => film.extent.speed)), 2)} m/s`;
    if (options.three) {
      this.deep ??= new Stage3D(this.space, this.onview);
      this.deep.draw(films, clock.time, options, look, inks, clock.playing);
    } else this.flat.draw(films, clock.time, options, look, inks);
    this.read(films, active, clock.time);
  }

  /**
   * The picture in space with other numbers of pixels, until it is drawn again.
   * @param {import("./lab.js").Lab} lab
   * @param {number} ratio pixels for one of the page
   */
  sharp(lab, ratio) {
    const { look, inks } = lab.theme;
    this.deep?.draw(lab.films(), lab.clock.time, this.options, look, inks, false, ratio);
    return this.space;
  }

  /**
   * @param {Film[]} films
   * @param {number} active
   * @param {number} time
   */
  read(films, active, time) {
    const film = films[active];
    const pose = film.at(time);
    const values = [
      films.length > 1 ? "AB"[active] : "",
      t(this.colors.mode_names[pose.mode]),
      local(`${pose.t.toFixed(3)} s`),
      degrees(pose.angle),
      withUnit(show(pose.vx, 3), "m/s"),
      withUnit(show(pose.omega * film.radius, 3), "m/s"),
      pose.height > 0 ? length(pose.height) : "0",
    ];
    for (const [i, text] of values.entries()) {
      const { value } = this.outputs[i];
      if (value.textContent !== text) value.textContent = text;
    }
    const [hoop, mode] = this.outputs;
    hoop.value.hidden = hoop.name.hidden = films.length < 2;
    mode.value.style.setProperty("--mode", this.colors.modes[pose.mode]);
  }

  /** @param {Film[]} films */
  describe(films) {
    name(this.element, "aria-label", ["The hoop.", ...films.flatMap((film) => [" ", film.summary])]);
  }

  /**
   * In space or in the plane.
   * @param {() => void} draw what fails where the browser cannot
   */
  turn(draw) {
    const show = () => {
      this.plane.hidden = this.options.three;
      this.space.hidden = !this.options.three;
    };
    this.options.three = !this.options.three;
    show();
    try {
      draw();
    } catch (error) {
      this.options.three = false;
      show();
      throw error;
    }
  }

  /**
   * What is drawn, and from where it is looked at.
   * @returns {import("./address.js").Shown}
   */
  view() {
    const { options, flat, deep } = this;
    return { options, zoom: flat.zoom, pan: flat.pan(), from: deep?.from() };
  }

  /** @param {import("./address.js").Shown} view of which some may be as it is */
  restore({ options, zoom, pan, from }) {
    if (options) {
      const { three, ...others } = options;
      Object.assign(this.options, others);
    }
    this.flat.look(zoom, pan);
    if (from) this.deep?.look(from);
  }

  /** @param {number} factor 0 for the view as it was */
  zoom(factor) {
    if (this.options.three) this.deep?.zoomBy(factor);
    else if (factor) this.flat.zoomBy(factor);
    else this.flat.reset();
  }
}
