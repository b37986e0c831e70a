// One hoop on its plane, drawn on a canvas or whatever takes the same strokes.

import { arrowHead, disc, fill, haloed, outlined, ring, stroke } from "../common/paint.ts";
import { SPEED_TEXTS } from "../common/colors.ts";
import { clamp } from "../common/clamp.ts";
import { niceStep, show, tickText } from "../common/numbers.ts";
import { strokeThrough } from "../diagrams/crowd.ts";

const SEGMENTS = 120;
const GAP = 12; // pixels between an arrow or a rim and a label
const NOWHERE = [Number.NaN, Number.NaN];
const KEYS = 64; // pixels that ticks, a force and the key need below the plane

/**
 * Where a label next to the tip of an arrow begins, so that it lies over no rim: within it where it fits, else outside.
 * `size`: of the label; `width`: of the picture. All in pixels.
 */
export function besideRim(x: number, y: number, size: number, [cx, cy]: number[], radius: number, width: number) {
  const chord = Math.sqrt(Math.max(radius ** 2 - (y - cy) ** 2, 0));
  const outside = cx + chord + GAP;
  if (!chord || x + GAP + size < cx + chord - GAP) return x + GAP;
  return outside + size < width ? outside : cx - chord - GAP - size;
}

export class Scene {
  top = 0; // of the hoop's part of the picture, in pixels
  covered: DOMRect[] = []; // where words lie over the picture

  look: Look;
  colors: Colors;
  pose: Pose;
  scale: number;
  focus: number[];
  place: number[];
  cosine = Math.cos(this.film.slope);
  sine = Math.sin(this.film.slope);

  constructor(
    readonly context: CanvasRenderingContext2D,
    public width: number,
    public height: number,
    public film: Film,
    time: number,
    public options: StageOptions,
    theme: Shades,
    zoom: number,
    shift: number[],
    readonly common: { top: number; radius: number; speed: number },
  ) {
    this.look = theme.look;
    this.colors = theme.inks;
    this.pose = film.at(time);
    const { look } = theme;
    const R = film.radius;
    const { left, right } = film.extent;
    const { top } = common;
    const room = 2 * common.radius + Math.min(top, 6 * common.radius);
    // the key lies in the ground of a picture that is not too small for it
    const low = (share: number) =>
      Math.min(share * height, height > 256 * look.px ? height - KEYS * look.px : Infinity);
    const close = Math.min((0.66 * height) / room, (0.36 * width) / common.radius);
    if (options.whole) {
      const span = (right - left) * this.cosine + 2.6 * R;
      const fall = (right - left) * Math.abs(this.sine) + 2.6 * R + top;
      this.scale = Math.min(width / span, (0.86 * height) / fall, close) * zoom;
      this.focus = [0.5 * (left + right), 0];
      this.place = [0.5 * width + shift[0], low(film.slope ? 0.62 : 0.8) + shift[1]];
    } else {
      this.scale = close * zoom;
      this.focus = [Number.isFinite(this.pose.x) ? this.pose.x : 0, 0];
      // on a narrow screen the readout needs the left side
      this.place = [(width < 520 ? 0.64 : 0.46) * width + shift[0], low(0.82) + shift[1]];
    }
  }

  /** Plane coordinates (along, away) to pixels; downhill is to the right. */
  point(along: number, away: number): [number, number] {
    const x = along - this.focus[0];
    const y = away - this.focus[1];
    return [
      this.place[0] + this.scale * (x * this.cosine + y * this.sine),
      this.place[1] - this.scale * (y * this.cosine - x * this.sine),
    ];
  }

  /** The point at a distance from the centre, towards the load; `pose`: of the hoop. */
  ray(distance: number, { x, height, angle }: Pick<Pose, "x" | "height" | "angle"> = this.pose) {
    return this.point(x + distance * Math.sin(angle), this.film.radius + height + distance * Math.cos(angle));
  }

  /** Pixels, from the top left of the hoop's part of the picture, to plane coordinates: the reverse of `point`. */
  unpoint(right: number, down: number) {
    const x = (right - this.place[0]) / this.scale;
    const y = -(down - this.place[1]) / this.scale;
    return [this.focus[0] + x * this.cosine - y * this.sine, this.focus[1] + x * this.sine + y * this.cosine];
  }

  draw() {
    this.ground();
    const { traces, ahead, whole } = this.options;
    if (ahead || (traces && whole)) this.traces(this.film.duration, 0.45);
    if (traces && !ahead) this.traces(this.pose.t);
    this.hoop();
    if (this.options.forces) this.forces();
  }

  ground() {
    const { context, look, width, height } = this;
    const reach = (Math.hypot(width, height) * 1.2 + Math.abs(this.place[0]) + Math.abs(this.place[1])) / this.scale;
    const [x0, y0] = this.point(this.focus[0] - reach, 0);
    const [x1, y1] = this.point(this.focus[0] + reach, 0);
    const down = [-this.sine * 4000, this.cosine * 4000];
    context.fillStyle = look.ground;
    fill(context, [x0, y0], [x1, y1], [x1 + down[0], y1 + down[1]], [x0 + down[0], y0 + down[1]]);
    context.strokeStyle = look.soft;
    context.lineWidth = 1.5;
    stroke(context, [x0, y0], [x1, y1]);
    const step = niceStep(width / this.scale, width / (90 * look.px));
    context.fillStyle = look.soft;
    context.font = `${11 * look.px}px ${look.font}`;
    context.textAlign = "center";
    context.lineWidth = 1;
    const low = Math.ceil((this.focus[0] - reach) / step);
    const high = Math.min(Math.floor((this.focus[0] + reach) / step), low + 400);
    for (let k = low; k <= high; k++) {
      const [x, y] = this.point(k * step, 0);
      if (x < -40 || x > width + 40) continue;
      stroke(context, [x, y], [x - 6 * this.sine, y + 6 * this.cosine]);
      const text = `${tickText(k * step, step)} m`;
      const [middle, base] = [x - 18 * look.px * this.sine, y + 8 + 10 * look.px * this.cosine];
      const half = 0.5 * context.measureText(text).width;
      const free = ({ left, right, top, bottom }: DOMRect) =>
        middle + half < left ||
        middle - half > right ||
        base + this.top < top ||
        base + this.top - 11 * look.px > bottom;
      if (this.covered.every(free)) context.fillText(text, middle, base);
    }
  }

  /** `share`: of their ink. */
  traces(until: number, share = 1) {
    const { film, context, look, colors } = this;
    const R = film.radius;
    const path = (distance: number, color: string, width: number, wanted?: boolean) => {
      context.strokeStyle = color;
      context.lineWidth = width;
      context.lineJoin = "round";
      const [xs, ys]: number[][] = [[], []];
      const add = ([px, py]: number[]) => {
        xs.push(px);
        ys.push(py);
      };
      for (const piece of film.pieces()) {
        const { x, height, angle, mode } = piece.film.columns;
        for (let i = piece.from; i < piece.to && piece.film.t[i] <= until; i++) {
          const here = wanted === undefined || (mode[i] === 3) === wanted;
          add(here ? this.ray(distance, { x: x[i], height: height[i], angle: angle[i] }) : NOWHERE);
        }
      }
      if (until === this.pose.t && (wanted === undefined || (this.pose.mode === "H") === wanted)) {
        add(this.ray(distance));
      }
      strokeThrough(context, xs, ys);
    };
    context.globalAlpha = share;
    path(R, look.ink, 1.3);
    path(film.eccentricity * R, colors.gravity_center, 1.8, false);
    path(film.eccentricity * R, colors.airborne, 2.4, true);
    context.globalAlpha = 1;
  }

  /** Which of two hoops it is: a ring within the rim and a letter in its colour. */
  mark(letter: string, color: string) {
    const { context, film, scale } = this;
    const [x, y] = this.ray(0);
    ring(context, [x, y], Math.max(film.radius * scale - clamp(0.07 * film.radius * scale, 2, 14) - 3, 2), color, 3);
    context.fillStyle = color;
    context.font = `700 ${17 * this.look.px}px ${this.look.font}`;
    context.textAlign = "center";
    context.fillText(letter, x - 14, y + 20);
  }

  /** Where the hoop is at another moment; at the edge of the picture, in which direction and how far. */
  ghost(pose: Pose) {
    const { context, film, look, width, scale } = this;
    const R = film.radius;
    const [x, y] = this.ray(0, pose);
    const radius = R * scale;
    context.strokeStyle = context.fillStyle = look.ink;
    context.lineWidth = 1.5;
    if (x > -0.5 * radius && x < width + 0.5 * radius) {
      const load = this.ray(R, pose);
      context.setLineDash([6, 5]);
      ring(context, [x, y], radius);
      stroke(context, [x, y], load);
      context.setLineDash([]);
      disc(context, load, clamp(0.1 * radius, 4, 16), look.paper);
      context.stroke();
      return;
    }
    const way = x < 0 ? -1 : 1;
    const tip = way < 0 ? 6 : width - 6;
    const high = clamp(y, 24, this.height - 24);
    fill(context, [tip, high], [tip - 14 * way, high - 9], [tip - 14 * way, high + 9]);
    context.font = `600 ${12 * look.px}px ${look.font}`;
    context.textAlign = way < 0 ? "left" : "right";
    const far = `${show(pose.x - this.focus[0], 3)} m`;
    haloed(context, far, [tip - 20 * way, high + 4 * look.px], look.ink, look.paper);
  }

  hoop() {
    const { film, pose, context, look, colors, scale } = this;
    const R = film.radius;
    const width = clamp(0.07 * R * scale, 2, 14);
    const inner = R - (0.5 * width) / scale;
    const center = this.ray(0);
    const rim = (angle: number) => this.ray(inner, { ...pose, angle });
    context.lineCap = "butt";
    // the slow end of the colours is dark as well
    if (look.dark) ring(context, center, inner * scale, look.soft, width + 2);
    if (this.options.speed) {
      const most = this.common.speed;
      context.lineWidth = width;
      const step = (2 * Math.PI) / SEGMENTS;
      for (let k = 0; k < SEGMENTS; k++) {
        const phi = pose.angle + k * step;
        const speed = Math.hypot(
          pose.vx + R * pose.omega * Math.cos(phi + 0.5 * step),
          pose.vy - R * pose.omega * Math.sin(phi + 0.5 * step),
        );
        context.strokeStyle = SPEED_TEXTS[clamp(Math.round((255 * speed) / most) || 0, 0, 255)];
        stroke(context, rim(phi - 0.04 * step), rim(phi + 1.04 * step));
      }
    } else ring(context, center, inner * scale, colors.modes[pose.mode], width);
    context.strokeStyle = look.soft;
    context.lineWidth = 1;
    stroke(context, center, rim(pose.angle));
    const dot = (place: number[], radius: number, fill: string, edge: string) => {
      disc(context, place, radius, fill);
      context.lineWidth = 1.5;
      context.strokeStyle = edge;
      context.stroke();
    };
    dot(center, 2.5, look.soft, look.soft);
    const parts = film.scenario.hoop.parts;
    if (parts) this.parts(parts);
    else dot(rim(pose.angle), clamp(0.1 * R * scale, 4, 16), look.ink, look.paper);
    const G = this.ray(film.eccentricity * R);
    dot(G, clamp(0.05 * R * scale, 3.5, 7), pose.mode === "H" ? colors.airborne : colors.gravity_center, look.paper);
  }

  /** A hoop of real parts: each where it sits on the line from C to the load. */
  parts(parts: Part[]) {
    const { film, context, look, scale } = this;
    const moment = parts.reduce((sum, part) => sum + part.mass * (part.at ?? 0), 0);
    const way = moment < 0 ? -1 : 1;
    context.strokeStyle = look.ink;
    for (const part of parts) {
      const at = way * (part.at ?? 0);
      const place = this.ray(at);
      context.fillStyle = look.ink;
      context.lineWidth = 1;
      context.beginPath();
      if (part.shape === "ring") {
        context.globalAlpha = 0.22;
        context.arc(...place, part.outer_radius * scale, 0, 2 * Math.PI);
        context.arc(...place, part.inner_radius * scale, 0, 2 * Math.PI, true);
        context.fill();
        context.globalAlpha = 1;
      } else if (part.shape === "rod") {
        const half = 0.5 * part.length;
        context.lineWidth = 4;
        stroke(context, this.ray(at - half), this.ray(at + half));
      } else {
        const radius = part.shape === "disk" ? part.radius * scale : clamp(0.08 * film.radius * scale, 3, 12);
        context.globalAlpha = part.shape === "disk" ? 0.55 : 1;
        disc(context, place, radius);
        context.globalAlpha = 1;
      }
    }
  }

  forces() {
    const { film, pose, colors } = this;
    // to scale up to four weights; a longer arrow would leave the picture and is drawn broken
    const size = (force: number) => film.newton * force;
    if (pose.mode === "H" || !(pose.normal_force > 0)) return;
    const foot = [pose.x, pose.height];
    const { normal_force: N, friction_force: F } = pose;
    this.arrow(foot, [0, size(N)], colors.normal_force, `N = ${show(N, 3)} N`, false);
    this.arrow(foot, [size(F), 0], colors.friction_force, `F = ${show(F, 3)} N`, true);
  }

  /** The label of N stands beside its tip, that of F below the plane: they never meet. */
  arrow([x, y]: number[], [dx, dy]: number[], color: string, label: string, below: boolean) {
    const { context, look, width } = this;
    const most = 2.2 * this.film.radius;
    const cut = Math.abs(dx) > most || Math.abs(dy) > most;
    [dx, dy] = [clamp(dx, -most, most), clamp(dy, -most, most)];
    const from = this.point(x, y);
    const to = this.point(x + dx, y + dy);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (length < 2) return;
    const ux = (to[0] - from[0]) / length;
    const uy = (to[1] - from[1]) / length;
    const head = Math.min(11, length);
    const neck = [to[0] - ux * head, to[1] - uy * head];
    outlined(context, [look.paper, 6], [color, 3], () => stroke(context, from, neck));
    arrowHead(context, to, [ux, uy], head);
    if (cut) {
      const [x, y] = [from[0] + 0.55 * ux * length, from[1] + 0.55 * uy * length];
      context.strokeStyle = look.paper;
      context.lineWidth = 2;
      for (const way of [-3, 3]) {
        const [back, on] = [way - 3, way + 3];
        stroke(context, [x + ux * back - uy * 7, y + uy * back + ux * 7], [x + ux * on + uy * 7, y + uy * on - ux * 7]);
      }
    }
    context.font = `600 ${12 * look.px}px ${look.font}`;
    const size = context.measureText(label).width;
    context.textAlign = "left";
    const high = clamp(to[1] + 4, 16, from[1] - 0.36 * this.film.radius * this.scale);
    const rim = this.ray(0);
    const place = below
      ? [from[0] - 0.5 * size - 32 * look.px * this.sine, from[1] + 32 * look.px * this.cosine]
      : [besideRim(to[0], high - 4, size, rim, this.film.radius * this.scale, width), high];
    place[0] = clamp(place[0], 4, width - size - 4);
    haloed(context, label, place, color, below ? look.ground : look.paper);
  }
}
