// Motions in space: those of the lab, and those that Python has written into a page.

import { rgb, bind, makeProgram, mesh } from "../../space/gl.ts";
import { Space } from "../../space/space.ts";
import { SPEED_COLORS } from "../common/colors.ts";
import { clamp } from "../common/clamp.ts";
import { follow, zoomable } from "../common/pointer.ts";

const HOME = { azimuth: 0.5, height: 0.22, distance: 5.2 };
const ANGLE = 0.75; // of the view
const LANE = 2.1; // radii between two hoops

type Tones = Pick<Look, "paper" | "ground" | "ink" | "dark">;
type Inks = Pick<Colors, "gravity_center" | "airborne" | "normal_force" | "friction_force"> &
  Partial<Pick<Colors, "modes">>;

/** What is drawn of a motion. */
export type Seen = Pick<Film, "radius" | "newton" | "eccentricity" | "slope" | "length" | "duration" | "extent"> &
  Pick<Film, "columns" | "at" | "index"> & { load?: number }; // how far the load is from the centre, where it is not at the rim

// Tiles that fade into the paper.
const FLOOR = [
  `attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,
  `precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`,
];

export class Stage3D {
  space = new Space(this.canvas, SPEED_COLORS);
  floor = makeProgram(this.space.gl, FLOOR);
  corners = mesh(this.space.gl, [-1, -1, 1, -1, -1, 1, 1, 1], { corner: 2 });
  turned = { ...HOME };
  moved: Vector = [0, 0, 0]; // what is looked at, from where it is by itself
  tile = 0; // length of a tile; half a radius by default
  metre = 1; // in pixels, at what is looked at
  lines = new WeakMap<WeakKey, any>();
  share = 1;
  pace = 16;
  before = 0;
  focus = 0;
  reach = 1;
  pinched = zoomable(this.canvas, {
    zoom: (factor) => this.zoomBy(factor),
    home: () => this.zoomBy(0),
    chosen: this.chosen,
  });

  /** `onview`: called when it is seen from elsewhere; `chosen`: what has the focus where the wheel zooms. */
  constructor(
    public canvas: HTMLCanvasElement,
    readonly onview: () => void,
    readonly chosen: () => HTMLElement | null = () => canvas.parentElement,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.drag(event));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  zoomBy(factor: number) {
    if (factor) this.turned.distance = clamp(this.turned.distance / factor, 1.6, 60);
    else Object.assign(this, { turned: { ...HOME }, moved: [0, 0, 0] });
    this.onview();
  }

  /** From where it is looked at: azimuth, height, distance; nothing where as usual. */
  from() {
    const { azimuth, height, distance } = this.turned;
    const from = [azimuth, height, distance];
    return String(from) === String(Object.values(HOME)) ? undefined : from;
  }

  look([azimuth, height, distance]: number[]) {
    this.turned = { azimuth, height: clamp(height, 0.02, 1.45), distance: clamp(distance, 1.6, 60) };
  }

  /** Turns the view; moves it with Shift or the right button. */
  drag(event: PointerEvent) {
    let before = event;
    follow(this.canvas, event, (now: PointerEvent) => {
      const [right, down] = [now.clientX - before.clientX, now.clientY - before.clientY];
      before = now;
      if (this.pinched()) return;
      const { azimuth, height } = this.turned;
      if (now.shiftKey || now.buttons === 2) {
        const way = [-right * Math.cos(azimuth), down, right * Math.sin(azimuth)];
        this.moved = this.moved.map((value, i) => value + way[i] / this.metre);
      } else {
        this.turned.azimuth = azimuth - right * 0.008;
        this.turned.height = clamp(height + down * 0.006, 0.02, 1.45);
      }
      this.onview();
    });
  }

  // Fewer pixels where the machine draws in software and falls behind.
  quality() {
    const now = performance.now();
    const took = now - (this.before || now);
    this.before = now;
    if (took > 0 && took < 200) this.pace = 0.9 * this.pace + 0.1 * took;
    if (this.pace > 26 && this.share > 0.5) {
      this.share = Math.max(this.share - 0.1, 0.5);
      this.pace = 16;
    }
    return this.share;
  }

  /**
   * `running`: a film that runs may lose sharpness, a still picture never. `wanted`: pixels of the picture for one of
   * the page; as many as the screen has by default.
   */
  draw(
    films: Seen[],
    time: number,
    options: Pick<StageOptions, "traces" | "forces" | "speed" | "whole">,
    { look, inks: colors }: { look: Tones; inks: Inks },
    running: boolean,
    wanted?: number,
  ) {
    const { canvas, space } = this;
    const ratio = wanted ?? Math.min(globalThis.devicePixelRatio || 1, 2) * (running ? this.quality() : 1);
    const box = canvas.getBoundingClientRect();
    canvas.width = Math.max(Math.round(box.width * ratio), 1);
    canvas.height = Math.max(Math.round(box.height * ratio), 1);
    const poses = films.map((film) => film.at(time));
    const R = films[0].radius;
    space.fastest = Math.max(...films.map((film) => film.extent.speed));
    const middle = poses.reduce((sum, { x }) => sum + x / poses.length, 0);
    this.focus = Number.isFinite(middle) ? middle : 0;
    const view = this.camera(films, poses[0], options.whole, box);
    space.begin({ background: rgb(look.paper), ...view });
    space.ground(() => this.drawFloor(R, look));
    const each = (paint: (film: Seen, pose: Pose, depth: number) => void) => {
      for (const [lane, film] of films.entries()) paint(film, poses[lane], this.depth(films, lane));
    };
    const tint = ({ mode }: Pose) => (options.speed || !colors.modes ? null : rgb(colors.modes[mode]));
    space.shadows(() => each((film, pose, depth) => this.drawHoop(film, pose, depth, null, look, colors, true)));
    each((film, pose, depth) => {
      this.drawHoop(film, pose, depth, tint(pose), look, colors, false);
      if (options.traces) this.drawTraces(film, options.whole ? film.duration : pose.t, depth, look, colors, ratio);
      if (options.forces) this.drawForces(film, pose, depth, colors);
    });
  }

  /** How far from the viewer a hoop is: the lanes lie about the middle. */
  depth(films: Seen[], lane: number) {
    return LANE * films[0].radius * (0.5 * (films.length - 1) - lane);
  }

  camera(films: Seen[], pose: Pose, whole: boolean, box: Box) {
    const { azimuth, height, distance } = this.turned;
    const [{ radius: R, slope, extent }] = films;
    const { left, right } = extent;
    const near = distance * R + this.depth(films, 0);
    const upright = Math.max(1, 0.8 * (box.height / box.width || 0)); // a narrow picture is seen from farther away
    const away = upright * (whole ? Math.max(near, 0.85 * (right - left) + 3 * R) : near);
    this.metre = box.height / (2 * away * Math.tan(0.5 * ANGLE));
    const [along, above] = [whole ? 0.5 * (left + right) - this.focus : 0, R + 0.45 * (pose.height || 0)];
    const cosine = Math.cos(slope);
    const sine = Math.sin(slope);
    const place = [along * cosine + above * sine, -along * sine + above * cosine, 0];
    const target = place.map((value, i) => value + this.moved[i]);
    const eye = [
      target[0] + away * Math.sin(azimuth) * Math.cos(height),
      target[1] + away * Math.sin(height),
      target[2] + away * Math.cos(azimuth) * Math.cos(height),
    ];
    this.reach = 12 * R + 3 * away;
    return { eye, target, slope, angle: ANGLE, near: 0.05 * R, far: 40 * R + 6 * away };
  }

  drawFloor(R: number, look: Tones) {
    const { space } = this;
    const light = rgb(look.ground);
    const dark = light.map((value) => value * (look.dark ? 0.82 : 0.94));
    const tile = this.tile || 0.5 * R;
    const shift = this.focus % (2 * tile);
    space.use(this.floor, { reach: this.reach, light, dark, far: rgb(look.paper), tile, shift });
    bind(space.gl, this.floor, this.corners);
    space.gl.drawArrays(space.gl.TRIANGLE_STRIP, 0, 4);
  }

  /** `plain`: the colour of the rim, where it is not that of its speed. */
  drawHoop(film: Seen, pose: Pose, depth: number, plain: Vector | null, look: Tones, colors: Inks, shadow: boolean) {
    const { space } = this;
    const R = film.radius;
    const tube = 0.045 * R;
    const center = [pose.x - this.focus, R + pose.height, depth];
    const { angle, vx, vy, omega } = pose;
    space.ring({ center, radius: R, tube, broad: 3.2 * tube, angle, velocity: [vx, vy], omega, plain }, shadow);
    const way = [Math.sin(pose.angle), Math.cos(pose.angle), 0];
    const at = (distance: number) => center.map((value, i) => value + distance * way[i]);
    const load = Math.min(film.load ?? R, R - tube);
    space.ball(at(load), 0.125 * R, look.dark ? [0.9, 0.91, 0.94] : [0.12, 0.13, 0.15], shadow);
    space.rod(center, way, load, 0.012 * R, [0.55, 0.57, 0.6], shadow);
    const inAir = pose.mode === "H";
    space.ball(at(film.eccentricity * R), 0.07 * R, rgb(inAir ? colors.airborne : colors.gravity_center), shadow);
  }

  drawForces(film: Seen, pose: Pose, depth: number, colors: Inks) {
    if (pose.mode === "H" || !(pose.normal_force > 0)) return;
    const R = film.radius;
    const from = [pose.x - this.focus, pose.height + 0.03 * R, depth + 0.2 * R];
    const length = (force: number) => clamp(film.newton * Math.abs(force), 0, 3.2 * R);
    const side = Math.sign(pose.friction_force);
    this.space.arrow(from, [0, 1, 0], length(pose.normal_force), R, rgb(colors.normal_force));
    this.space.arrow(from, [side, 0, 0], length(pose.friction_force), R, rgb(colors.friction_force));
  }

  /** Load and centre of gravity, built once a film; what lies ahead in time is left out when drawn. */
  linesOf(film: Seen, look: Tones, colors: Inks) {
    const kept = this.lines.get(film);
    if (kept?.dark === look.dark) return kept;
    const R = film.radius;
    const { x, height, angle, mode } = film.columns;
    const trace = (distance: number, tint: (i: number) => number[]) =>
      this.space.trace(
        film.length,
        (i: number) => [x[i] + distance * Math.sin(angle[i]), R + height[i] + distance * Math.cos(angle[i])],
        tint,
      );
    const [contact, air, ink] = [rgb(colors.gravity_center), rgb(colors.airborne), rgb(look.ink)];
    const made = {
      dark: look.dark,
      load: trace(film.load ?? R, () => ink),
      center: trace(film.eccentricity * R, (i: number) => (mode[i] === 3 ? air : contact)),
    };
    this.lines.set(film, made);
    return made;
  }

  drawTraces(film: Seen, until: number, depth: number, look: Tones, colors: Inks, ratio: number) {
    const { load, center } = this.linesOf(film, look, colors);
    const count = Math.min(film.index(until) + 2, film.length);
    const place = { shift: this.focus, depth };
    this.space.drawTrace(load, count, { width: ratio, ...place });
    this.space.drawTrace(center, count, { width: 1.6 * ratio, ...place });
  }
}
