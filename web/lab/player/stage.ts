// The picture of the hoops, in the plane or in space, with what stands on it: readout, colours of speed, key.

import { SPEED_GRADIENT, hoopInk } from "../common/colors.ts";
import { fetched, h, scaledContext } from "../common/dom.ts";
import { degrees, length, show, withUnit } from "../common/numbers.ts";
import { local, name, t } from "../words/words.ts";
import { clamp } from "../common/clamp.ts";
import { follow, zoomable } from "../common/pointer.ts";
import { Scene } from "./scene2d.ts";
import type { Stage3D } from "./stage3d.ts";
import type { Shown } from "../shell/address.ts";
import type { Lab } from "../shell/lab.ts";

const OUTPUTS = [
  "player.hoop",
  "table.mode",
  "column.time",
  "column.angle",
  "curve.vx",
  "curve.rotation",
  "player.gap",
];

const dot = (color: string, words: string) => h("span", h("i.dot", { style: `background:${color}` }), words);

export class Stage {
  options: StageOptions = { traces: true, forces: true, speed: true, whole: false, three: false, ahead: false };
  plane = h("canvas.stage-canvas");
  space = h("canvas.stage-canvas", { hidden: true });
  flat = new Stage2D(this.plane, this.onview);
  deep: Stage3D | null = null; // made when it is first asked for
  outputs = OUTPUTS.map((name) => ({ name: h("dt", name), value: h("dd") }));
  fastest = h("span");
  legend = h(
    "div.legend",
    { "aria-hidden": "true" },
    h("i", { style: `background: ${SPEED_GRADIENT}` }),
    h("span", "0"),
    h("span", "player.rim_speed"),
    this.fastest,
  );
  readout = h(
    "dl.readout",
    { "aria-hidden": "true" },
    this.outputs.flatMap(({ name, value }) => [name, value]),
  );
  order = h("span", { hidden: true }, "player.order");
  keys = h(
    "div.stage-keys",
    { "aria-hidden": "true" },
    dot("var(--ink)", "player.load"),
    dot(this.colors.gravity_center, "player.center_of_gravity"),
    dot(this.colors.airborne, "player.in_flight"),
    this.order,
  );
  element = h(
    "div.stage",
    { role: "figure", "aria-label": "player.picture", tabindex: "0" },
    this.plane,
    this.space,
    this.readout,
    this.legend,
    this.keys,
  );

  /** `onview`: what to do when it is seen from elsewhere. */
  constructor(
    public colors: Colors,
    readonly onview: () => void,
  ) {
    this.outputs[1].value.className = "mode";
  }

  // The canvas that is seen now.
  canvas() {
    return this.options.three ? this.space : this.plane;
  }

  /** Where words lie over the picture. */
  covered() {
    return [this.readout, this.legend, this.keys]
      .filter((one) => one.checkVisibility())
      .map((one) => new DOMRect(one.offsetLeft, one.offsetTop, one.offsetWidth, one.offsetHeight));
  }

  draw(films: Film[], active: number, clock: Clock, theme: Shades) {
    const { options } = this;
    this.legend.hidden = !options.speed;
    this.order.hidden = !(options.three && films.length > 1);
    this.fastest.textContent = `≥ ${show(Math.max(...films.map((film) => film.extent.speed)), 2)} m/s`;
    if (options.three) {
      this.deep?.draw(films, clock.time, options, theme, clock.playing);
    } else {
      this.flat.pointed = clock.pointed === null ? null : { time: clock.pointed, lane: active };
      this.flat.covered = this.covered();
      this.flat.draw(films, clock.time, options, theme);
    }
    this.read(films, active, clock.time);
  }

  /**
   * The picture in space with other numbers of pixels, until it is drawn again. `ratio`: pixels for one of the page.
   */
  sharp(lab: Pick<Lab, "theme" | "films" | "clock">, ratio: number) {
    this.deep?.draw(lab.films(), lab.clock.time, this.options, lab.theme, false, ratio);
    return this.space;
  }

  read(films: Film[], active: number, time: number) {
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

  describe(films: Film[]) {
    name(this.element, "aria-label", ["player.picture_description", ...films.flatMap((film) => [" ", film.summary])]);
  }

  /** In space, which has to come first, or in the plane. `draw`: what fails where the browser cannot. */
  async turn(draw: () => void) {
    const part = this.deep ? null : await fetched(import("./stage3d.ts"));
    const show = () => {
      this.plane.hidden = this.options.three;
      this.space.hidden = !this.options.three;
    };
    this.options.three = !this.options.three;
    show();
    try {
      if (part) this.deep ??= new part.Stage3D(this.space, this.onview);
      draw();
    } catch (error) {
      this.options.three = false;
      show();
      throw error;
    }
  }

  /** What is drawn, and from where it is looked at. */
  view(): Shown {
    const { options, flat, deep } = this;
    return { options, zoom: flat.zoom, pan: flat.pan(), from: deep?.from() };
  }

  /** `view`: of which some may be as it is. */
  restore({ options, zoom, pan, from }: Shown) {
    if (options) {
      const { three, ...others } = options;
      Object.assign(this.options, others);
    }
    this.flat.look(zoom, pan);
    if (from) this.deep?.look(from);
  }

  /** `factor`: 0 for the view as it was. */
  zoom(factor: number) {
    if (this.options.three) this.deep?.zoomBy(factor);
    else if (factor) this.flat.zoomBy(factor);
    else this.flat.reset();
  }
}

// --- The hoops on their planes, one below the other, as they are looked at

class Stage2D {
  zoom = 1;
  shift = [0, 0];
  /** The picture of each hoop as it was drawn last, for what lies over it. */
  views: Scene[] = [];
  /** The scale while the hoop is held: it must not slip out of the hand. */
  fixed: number | null = null;

  /** A moment of one hoop that is pointed at. */
  pointed: { time: number; lane: number } | null = null;
  /** Where words lie over the picture. */
  covered: DOMRect[] = [];
  /** Takes what is under the pointer, if there is anything to take. */
  grab: (event: PointerEvent) => boolean = () => false;
  /** What is drawn over a hoop's picture. */
  over: (scene: Scene, lane: number) => void = () => {};
  pinched = zoomable(this.canvas, {
    zoom: (factor) => this.zoomBy(factor),
    home: () => this.reset(),
    chosen: () => this.canvas.parentElement,
  });

  constructor(
    public canvas: HTMLCanvasElement,
    readonly onview: () => void,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.drag(event));
  }

  reset() {
    this.zoom = 1;
    this.shift = [0, 0];
    this.onview();
  }

  /** How far the picture is moved, in its own width and height. */
  pan(): [number, number] {
    const { width, height } = this.canvas.getBoundingClientRect();
    return [this.shift[0] / (width || 1), this.shift[1] / (height || 1)];
  }

  look(zoom = 1, [along, down]: [number, number] = [0, 0]) {
    const { width, height } = this.canvas.getBoundingClientRect();
    this.zoom = zoom;
    this.shift = [along * width, down * height];
  }

  zoomBy(factor: number) {
    this.zoom = clamp(this.zoom * factor, 0.05, 60);
    this.onview();
  }

  drag(event: PointerEvent) {
    if (this.grab(event)) return;
    const start = [event.clientX, event.clientY];
    const before = this.shift;
    follow(this.canvas, event, (moved: PointerEvent) => {
      if (this.pinched()) return;
      this.shift = [before[0] + moved.clientX - start[0], before[1] + moved.clientY - start[1]];
      this.onview();
    });
  }

  draw(films: Film[], time: number, options: StageOptions, theme: Shades) {
    const { context, width, height } = scaledContext(this.canvas);
    if (width < 40 || height < 40) return; // not laid out yet
    this.views = this.paint(context, width, height, films, time, options, theme, this.covered);
  }

  /** The picture as it is looked at now, on any canvas. Returns one for each hoop. */
  paint(
    context: CanvasRenderingContext2D,
    width: number,
    height: number,
    films: Film[],
    time: number,
    options: StageOptions,
    theme: Shades,
    covered: DOMRect[] = [],
  ) {
    const { look } = theme;
    const each = height / films.length;
    // two hoops are drawn to one scale, in length and in colour
    const common = {
      top: Math.max(...films.map((film) => film.extent.top)),
      radius: Math.max(...films.map((film) => film.radius)),
      speed: Math.max(...films.map((film) => film.extent.speed)),
    };
    return films.map((film, i) => {
      context.save();
      context.beginPath();
      context.rect(0, i * each, width, each);
      context.clip();
      context.translate(0, i * each);
      const scene = new Scene(context, width, each, film, time, options, theme, this.zoom, this.shift, common);
      scene.top = i * each;
      scene.covered = covered;
      scene.scale = this.fixed ?? scene.scale;
      scene.draw();
      if (this.pointed?.lane === i) scene.ghost(film.at(this.pointed.time));
      this.over(scene, i);
      if (films.length > 1) {
        scene.mark("AB"[i], hoopInk(i, look.dark));
        context.fillStyle = hoopInk(i, look.dark);
        context.font = `700 ${17 * look.px}px ${look.font}`;
        context.textAlign = "left";
        context.fillText("AB"[i], 12, each - 12);
      }
      context.restore();
      if (i > 0) {
        context.fillStyle = look.line;
        context.fillRect(0, i * each - 0.5, width, 1);
      }
      return scene;
    });
  }
}
