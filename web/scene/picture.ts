// One instant of the scene.

import { moved, rgb } from "../space/algebra.ts";
import { Space, sheet, sheets } from "../space/space.ts";
import { between } from "./data.ts";
import { drawMarks } from "./marks.ts";

const TUBE = 0.05;
const LOAD = 0.1;
const HEAVY = 0.05;
const SUN = [-0.32, 1, 0.75];
const SHADOW = 0.38;
const NUMBER_FONT = '"DejaVu Sans", system-ui, sans-serif';

const mixed: (a: Vector, b: Vector, share: number) => Vector = (a, b, share) =>
  a.map((value, i) => value + share * (b[i] - value));

export class Picture {
  space = new Space(this.canvas, this.data.map, SUN, SHADOW);
  metre = 1;
  half: number;
  marks: number[];
  floor: { plane: Mesh; track: Mesh; bars: Mesh };
  traces: ({ load: Mesh; heavy: Mesh } | null)[];

  constructor(
    public canvas: HTMLCanvasElement,
    readonly labels: HTMLCanvasElement,
    readonly data: SceneData,
  ) {
    this.space.fastest = data.topSpeed;
    this.half = Math.max(...data.hoops.map((hoop) => Math.abs(hoop.lane))) + 1.1 * data.radius; // of the track
    const first = Math.ceil((data.along[0] - 6 * data.radius) / data.grid);
    const last = Math.min(Math.floor((data.along[1] + 6 * data.radius) / data.grid), first + 1999);
    this.marks = Array.from({ length: Math.max(last - first + 1, 0) }, (_, k) => (first + k) * data.grid);
    this.floor = this.floorMeshes();
    this.traces = data.hoops.map((hoop) => hoop.traces && this.traceMeshes(hoop.traces));
  }

  floorMeshes() {
    const { data, half, space } = this;
    const R = data.radius;
    const reach = [data.along[0] - 40 * R, data.along[1] + 40 * R];
    const across = [half, -half];
    return {
      plane: sheets(space.gl, [sheet(reach, [40 * R, -40 * R])]),
      track: sheets(space.gl, [sheet(reach, across)]),
      bars: sheets(
        space.gl,
        this.marks.map((x) => sheet([x - 0.008 * R, x + 0.008 * R], across)),
      ),
    };
  }

  traceMeshes({ load, heavy, airborne }: SceneTraces) {
    const { theme, colors } = this.data;
    const ink = rgb(theme.load);
    const [contact, air] = [rgb(colors.center), rgb(colors.airborne)];
    const made: (way: Float32Array, tint: (i: number) => Vector) => Mesh = (way, tint) =>
      this.space.trace(way.length / 2, (i) => [way[2 * i], way[2 * i + 1]], tint);
    return { load: made(load, () => ink), heavy: made(heavy, (i) => (airborne[i] ? air : contact)) };
  }

  draw(now: number, camera: Camera) {
    const { canvas, labels, data, space } = this;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    for (const each of [canvas, labels]) {
      if (each.width !== width || each.height !== height) Object.assign(each, { width, height });
    }
    const focus = camera.focus(now);
    const view = camera.view(width > height);
    space.begin({ background: rgb(data.theme.background), ...view });
    space.ground(() => this.drawFloor(focus));
    const hoops = data.hoops.map((hoop) => this.pose(hoop, now, focus));
    space.shadows(() => {
      for (const hoop of hoops) this.drawHoop(hoop, true);
    });
    // pixels of one metre at the point that is looked at
    const scale = height / (2 * camera.away * Math.tan(0.5 * view.angle));
    for (const [i, hoop] of hoops.entries()) {
      this.drawHoop(hoop, false);
      this.drawTraces(data.hoops[i], this.traces[i], now, focus, scale, camera.away);
      if (data.newton) this.drawForces(data.hoops[i], data.newton[Math.floor(now)], now, focus);
    }
    const pen = labels.getContext("2d") as CanvasRenderingContext2D;
    pen.clearRect(0, 0, labels.width, labels.height);
    pen.textAlign = "center";
    this.drawNumbers(pen, focus, ratio);
    for (const hoop of hoops) drawMarks(pen, this, hoop, now, focus, scale, ratio);
    for (const { hoop, center } of hoops) this.drawTag(pen, hoop.tag, center, ratio);
    this.metre = scale / ratio; // in pixels of the page
  }

  pose(hoop: SceneHoop, now: number, focus: number): ScenePose {
    const turned = between(hoop.angle, now);
    const way = [Math.sin(turned), Math.cos(turned), 0];
    const center = [between(hoop.center, now, 2) - focus, between(hoop.center, now, 2, 1), -hoop.lane];
    return {
      hoop,
      center,
      angle: turned,
      velocity: [between(hoop.velocity, now, 2), between(hoop.velocity, now, 2, 1)],
      omega: between(hoop.omega, now),
      airborne: hoop.mode[Math.floor(now)] === this.data.flight,
      at: (distance: number) => center.map((value, i) => value + distance * way[i]),
    };
  }

  drawFloor(focus: number) {
    const { theme } = this.data;
    const [ground, ink] = [rgb(theme.ground), rgb(theme.ink)];
    const place = moved([-focus, 0, 0]);
    this.space.solid(this.floor.plane, place, ground, { lit: false });
    this.space.solid(this.floor.track, place, mixed(ground, ink, 0.06), { lit: false });
    this.space.solid(this.floor.bars, place, mixed(ground, ink, 0.25), { lit: false });
  }

  drawHoop({ hoop, center, angle, velocity, omega, airborne, at }: ScenePose, shadow: boolean) {
    const { space, data } = this;
    const { radius } = hoop;
    space.ring({ center, radius, tube: TUBE * radius, broad: TUBE * radius, angle, velocity, omega }, shadow);
    space.ball(at(hoop.load), LOAD * radius, rgb(data.theme.load), shadow);
    const color = airborne ? data.colors.airborne : data.colors.center;
    if (!shadow) space.ball(at(hoop.heavy), HEAVY * radius, rgb(color), shadow);
  }

  drawTraces(
    hoop: SceneHoop,
    made: { load: Mesh; heavy: Mesh } | null,
    now: number,
    focus: number,
    scale: number,
    distance: number,
  ) {
    if (made === null || hoop.traces === null) return;
    const time = between(hoop.t, now);
    const later = hoop.traces.t.findIndex((each) => each > time);
    const count = later < 0 ? hoop.traces.t.length : later;
    const R = this.data.radius;
    const place = { distance, shift: focus, depth: -hoop.lane };
    this.space.drawTrace(made.load, count, { width: 0.011 * R * scale, ...place });
    this.space.drawTrace(made.heavy, count, { width: 0.016 * R * scale, ...place });
  }

  /** Forces jump; they are not drawn in between. `newton`: length of a newton's arrow. */
  drawForces(hoop: SceneHoop, newton: number, now: number, focus: number) {
    const { data, space } = this;
    const k = Math.floor(now);
    const front = -hoop.lane + (TUBE + 0.04) * hoop.radius;
    const from = [between(hoop.contact, now, 2) - focus, between(hoop.contact, now, 2, 1), front];
    const [normal, friction] = [hoop.normalForce[k], hoop.frictionForce[k]].map((force) => newton * force);
    space.arrow(from, [0, Math.sign(normal), 0], Math.abs(normal), data.radius, rgb(data.colors.normal));
    space.arrow(from, [Math.sign(friction), 0, 0], Math.abs(friction), data.radius, rgb(data.colors.friction));
  }

  /** The letter of a hoop at its centre, by which several are told apart. */
  drawTag(pen: CanvasRenderingContext2D, tag: string, center: Vector, ratio: number) {
    const spot = tag && this.space.onScreen(center);
    if (!spot) return;
    const { theme } = this.data;
    pen.beginPath();
    pen.arc(spot[0], spot[1], 10 * ratio, 0, 2 * Math.PI);
    pen.fillStyle = theme.background;
    pen.fill();
    pen.strokeStyle = theme.ink;
    pen.lineWidth = 1.2 * ratio;
    pen.stroke();
    pen.fillStyle = theme.ink;
    pen.font = `bold ${12 * ratio}px ${NUMBER_FONT}`;
    pen.fillText(tag, spot[0], spot[1] + 4.3 * ratio);
  }

  /** Metres beside the track, as many as there is room for. */
  drawNumbers(pen: CanvasRenderingContext2D, focus: number, ratio: number) {
    const { labels, data, half } = this;
    pen.fillStyle = data.theme.muted;
    pen.font = `${13 * ratio}px ${NUMBER_FONT}`;
    let last = -1e9;
    for (const mark of this.marks) {
      const place = this.space.onScreen([mark - focus, 0, half + 0.15 * data.radius]);
      if (!place) continue;
      const [x, y] = place;
      const room = x >= 0 && x <= labels.width && y >= 0 && y <= labels.height - 50 * ratio;
      if (!room || Math.abs(x - last) < 55 * ratio) continue;
      pen.fillText(`${+mark.toPrecision(6)} m`.replace("-", "−"), x, y + 12 * ratio);
      last = x;
    }
  }
}
