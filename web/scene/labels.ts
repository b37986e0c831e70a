// What is written over the picture: metres on the plane, take-offs, impacts and jams, the letters of several hoops.

import { disc, fill, ring, stroke } from "../lab/common/paint.ts";
import type { Stage3D } from "../lab/player/stage3d.ts";
import type { Written } from "./main.ts";

const FLASH = 0.5; // how long a ring spreads [s of film]
const SPREAD = 0.45; // how far, in radii of the hoop
const SIZE = 6;
const FONT = '"DejaVu Sans", system-ui, sans-serif';
const FEWEST = 55; // pixels between two numbers

export class Labels {
  pen = this.canvas.getContext("2d") as CanvasRenderingContext2D;

  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly stage: Stage3D,
    readonly films: Written[],
    readonly data: SceneData,
  ) {}

  draw(now: number) {
    const { canvas, pen, films, data } = this;
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    pen.scale(ratio, ratio);
    pen.textAlign = "center";
    this.numbers();
    pen.fillStyle = pen.strokeStyle = data.theme.ink;
    for (const [lane, film] of films.entries()) this.marks(film, lane, now);
    for (const [lane, film] of films.entries()) this.tag(film, lane, now);
  }

  /** Where a point of the plane is on the screen. */
  spot(along: number, above: number, depth: number) {
    const { canvas, stage } = this;
    const place = stage.space.onScreen([along - stage.focus, above, depth]);
    return place && [place[0] * canvas.clientWidth, place[1] * canvas.clientHeight];
  }

  /** Metres beside the track, as many as there is room for. */
  numbers() {
    const { canvas, pen, stage, films, data } = this;
    const { clientWidth, clientHeight } = canvas;
    pen.fillStyle = data.theme.muted;
    pen.font = `13px ${FONT}`;
    const depth = stage.depth(films, 0) + 1.25 * films[0].radius;
    const middle = Math.round(stage.focus / data.grid);
    let last = -Infinity;
    for (let k = middle - 200; k <= middle + 200; k++) {
      const spot = this.spot(k * data.grid, 0, depth);
      if (!spot || spot[0] < 0 || spot[0] > clientWidth || spot[1] > clientHeight - 50) continue;
      if (Math.abs(spot[0] - last) < FEWEST) continue;
      pen.fillText(`${+(k * data.grid).toPrecision(6)} m`.replace("-", "−"), spot[0], spot[1] + 12);
      last = spot[0];
    }
  }

  /** A ring that spreads as it happens, and a mark that stays on the plane. */
  marks(film: Written, lane: number, now: number) {
    const { pen, stage, films, data } = this;
    const { t: time } = film.at(now);
    const depth = stage.depth(films, lane) + 0.35 * film.radius;
    pen.font = `12px ${FONT}`;
    let free = -Infinity; // where the next word may begin
    for (const [t, along, kind, word] of film.hoop.marks.filter(([t]) => t <= time).sort((a, b) => a[1] - b[1])) {
      const spot = this.spot(along, 0, depth);
      if (!spot) continue;
      const [x, y] = spot;
      const share = (time - t) / data.rate[Math.floor(now)] / FLASH;
      if (share < 1) this.flash(x, y, share, film.radius * stage.metre);
      this.sign(kind, x, y + 12);
      const half = 0.5 * pen.measureText(word).width;
      if (x - half < free) continue;
      pen.fillText(word, x, y + 34);
      free = x + half + 6;
    }
  }

  /** `share`: of the time that it spreads. */
  flash(x: number, y: number, share: number, radius: number) {
    const { pen } = this;
    pen.globalAlpha = 1 - share;
    pen.lineWidth = 3 * (1 - share) + 0.6;
    ring(pen, [x, y], (0.08 + SPREAD * share) * radius);
    pen.globalAlpha = 1;
  }

  sign(kind: string, x: number, y: number) {
    const { pen } = this;
    if (kind === "takeoff" || kind === "impact") {
      const up = kind === "takeoff" ? -SIZE : SIZE;
      fill(pen, [x - SIZE, y - up], [x + SIZE, y - up], [x, y + up]);
      return;
    }
    pen.lineWidth = 0.4 * SIZE;
    for (const way of [-SIZE, SIZE]) stroke(pen, [x - SIZE, y - way], [x + SIZE, y + way]);
  }

  /** The letter of a hoop at its centre, by which several are told apart. */
  tag(film: Written, lane: number, now: number) {
    const { pen, stage, films, data } = this;
    const { x, height } = film.at(now);
    const spot = film.hoop.tag && this.spot(x, film.radius + height, stage.depth(films, lane));
    if (!spot) return;
    disc(pen, spot, 10, data.theme.paper);
    pen.lineWidth = 1.2;
    pen.stroke();
    pen.fillStyle = data.theme.ink;
    pen.font = `bold 12px ${FONT}`;
    pen.fillText(film.hoop.tag, spot[0], spot[1] + 4.3);
  }
}
