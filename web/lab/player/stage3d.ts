// The same motion in space.

import { rgb } from "../../space/algebra.ts";
import { bind, makeProgram, mesh } from "../../space/gl.ts";
import { Space } from "../../space/space.ts";
import { SPEED_COLORS } from "../common/colors.ts";
import { clamp } from "../common/clamp.ts";
import { follow } from "../common/pointer.ts";
import { zoomable } from "../common/zoom.ts";

const SUN = [0.35, 0.85, 0.4];
const SHADOW = 0.18;
const HOME = { azimuth: 0.5, height: 0.22, distance: 5.2 };

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
  space = new Space(this.canvas, SPEED_COLORS, SUN, SHADOW, { keep: true });
  floor = makeProgram(this.space.gl, FLOOR[0], FLOOR[1]);
  corners = mesh(this.space.gl, [-1, -1, 1, -1, -1, 1, 1, 1], { corner: 2 });
  turned = { ...HOME };
  lines: WeakMap<WeakKey, any> = new WeakMap();
  share = 1;
  pace = 16;
  before = 0;
  focus = 0;
  reach = 1;
  pinched = zoomable(this.canvas, {
    zoom: (factor) => this.zoomBy(factor),
    home: () => this.zoomBy(0),
    chosen: () => this.canvas.parentElement,
  });

  constructor(
    public canvas: HTMLCanvasElement,
    readonly onview: () => void,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.drag(event));
  }

  zoomBy(factor: number) {
    if (factor) this.turned.distance = clamp(this.turned.distance / factor, 1.6, 60);
    else this.turned = { ...HOME };
    this.onview();
  }

  /** From where it is looked at: azimuth, height, distance; nothing where as usual. */
  from(): number[] | undefined {
    const { azimuth, height, distance } = this.turned;
    const usual = azimuth === HOME.azimuth && height === HOME.height && distance === HOME.distance;
    return usual ? undefined : [azimuth, height, distance];
  }

  look([azimuth, height, distance]: number[]) {
    this.turned = {
      azimuth: clamp(azimuth, -1.5, 1.5),
      height: clamp(height, 0.02, 1.45),
      distance: clamp(distance, 1.6, 60),
    };
  }

  drag(event: PointerEvent) {
    const start = { ...this.turned, x: event.clientX, y: event.clientY };
    follow(this.canvas, event, (moved: PointerEvent) => {
      if (this.pinched()) return;
      this.turned.azimuth = clamp(start.azimuth - (moved.clientX - start.x) * 0.008, -1.5, 1.5);
      this.turned.height = clamp(start.height + (moved.clientY - start.y) * 0.006, 0.02, 1.45);
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
    films: Film[],
    time: number,
    options: StageOptions,
    look: Look,
    colors: Colors,
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
    this.focus = Number.isFinite(poses[0].x) ? poses[0].x : 0;
    space.begin({ background: rgb(look.paper), ...this.camera(films[0], poses[0], R, options) });
    space.ground(() => this.drawFloor(R, look));
    const each = (paint: (film: Film, pose: Pose, depth: number) => void) => {
      for (const [lane, film] of films.entries()) paint(film, poses[lane], -2.1 * R * lane);
    };
    space.shadows(() => each((film, pose, depth) => this.drawHoop(film, pose, depth, options, look, colors, true)));
    each((film, pose, depth) => {
      this.drawHoop(film, pose, depth, options, look, colors, false);
      if (options.traces) this.drawTraces(film, options.whole ? film.duration : pose.t, depth, look, colors, ratio);
      if (options.forces) this.drawForces(film, pose, depth, colors);
    });
  }

  camera(film: Film, pose: Pose, R: number, options: StageOptions) {
    const { azimuth, height, distance } = this.turned;
    const { left, right } = film.extent;
    const away = options.whole ? Math.max(distance * R, 0.85 * (right - left) + 3 * R) : distance * R;
    const [along, above] = [options.whole ? 0.5 * (left + right) - this.focus : 0, R + 0.45 * (pose.height || 0)];
    const cosine = Math.cos(film.slope);
    const sine = Math.sin(film.slope);
    const target = [along * cosine + above * sine, -along * sine + above * cosine, 0];
    const eye = [
      target[0] + away * Math.sin(azimuth) * Math.cos(height),
      target[1] + away * Math.sin(height),
      away * Math.cos(azimuth) * Math.cos(height),
    ];
    this.reach = 12 * R + 3 * away;
    return { eye, target, slope: film.slope, angle: 0.75, near: 0.05 * R, far: 40 * R + 6 * away };
  }

  drawFloor(R: number, look: Look) {
    const { space } = this;
    const light = rgb(look.ground);
    const dark = light.map((value) => value * (look.dark ? 0.82 : 0.94));
    const tile = 0.5 * R;
    const shift = this.focus % (2 * tile);
    space.use(this.floor, { reach: this.reach, light, dark, far: rgb(look.paper), tile, shift });
    bind(space.gl, this.floor, this.corners);
    space.gl.drawArrays(space.gl.TRIANGLE_STRIP, 0, 4);
  }

  drawHoop(film: Film, pose: Pose, depth: number, options: StageOptions, look: Look, colors: Colors, shadow: boolean) {
    const { space } = this;
    const R = film.radius;
    const tube = 0.045 * R;
    const center = [pose.x - this.focus, R + pose.height, depth];
    space.ring(
      {
        center,
        radius: R,
        tube,
        broad: 3.2 * tube,
        angle: pose.angle,
        velocity: [pose.vx, pose.vy],
        omega: pose.omega,
        plain: options.speed ? null : rgb(colors.modes[pose.mode]),
      },
      shadow,
    );
    const way = [Math.sin(pose.angle), Math.cos(pose.angle), 0];
    const at = (distance: number) => center.map((value, i) => value + distance * way[i]);
    space.ball(at(R - tube), 0.125 * R, look.dark ? [0.9, 0.91, 0.94] : [0.12, 0.13, 0.15], shadow);
    space.rod(center, way, R - tube, 0.012 * R, [0.55, 0.57, 0.6], shadow);
    const inAir = pose.mode === "H";
    space.ball(at(film.eccentricity * R), 0.07 * R, rgb(inAir ? colors.airborne : colors.gravity_center), shadow);
  }

  drawForces(film: Film, pose: Pose, depth: number, colors: Colors) {
    if (pose.mode === "H" || !(pose.normal_force > 0)) return;
    const R = film.radius;
    const weight = film.mass * (film.gravity || 9.81);
    const from = [pose.x - this.focus, pose.height + 0.03 * R, depth + 0.2 * R];
    const length = (force: number) => clamp((0.55 * R * Math.abs(force)) / weight, 0, 3.2 * R);
    const side = Math.sign(pose.friction_force);
    this.space.arrow(from, [0, 1, 0], length(pose.normal_force), R, rgb(colors.normal_force));
    this.space.arrow(from, [side, 0, 0], length(pose.friction_force), R, rgb(colors.friction_force));
  }

  /** Load and centre of gravity, built once a film; what lies ahead in time is left out when drawn. */
  linesOf(film: Film, look: Look, colors: Colors) {
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
      load: trace(R, () => ink),
      center: trace(film.eccentricity * R, (i: number) => (mode[i] === 3 ? air : contact)),
    };
    this.lines.set(film, made);
    return made;
  }

  drawTraces(film: Film, until: number, depth: number, look: Look, colors: Colors, ratio: number) {
    const { load, center } = this.linesOf(film, look, colors);
    const count = Math.min(film.index(until) + 2, film.length);
    const place = { shift: this.focus, depth };
    this.space.drawTrace(load, count, { width: ratio, ...place });
    this.space.drawTrace(center, count, { width: 1.6 * ratio, ...place });
  }
}
