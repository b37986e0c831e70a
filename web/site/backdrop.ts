// The film of a fit under the hoop of the lab: added to the page by `hophoop lab FIT --film VIDEO`, and by nothing else.

import type { Lab } from "../lab/shell/lab.ts";

type Corner = [number, number];

// The matrix that takes the corners of a rectangle, from the top left clockwise, to four points.
function onto(width: number, height: number, [a, b, c, d]: Corner[]) {
  const [x1, y1, x2, y2] = [b[0] - c[0], b[1] - c[1], d[0] - c[0], d[1] - c[1]];
  const [x3, y3] = [a[0] - b[0] + c[0] - d[0], a[1] - b[1] + c[1] - d[1]];
  const whole = x1 * y2 - x2 * y1;
  const g = (x3 * y2 - x2 * y3) / whole;
  const h = (x1 * y3 - x3 * y1) / whole;
  const across = [b[0] - a[0] + g * b[0], b[1] - a[1] + g * b[1], g].map((value) => value / width);
  const down = [d[0] - a[0] + h * d[0], d[1] - a[1] + h * d[1], h].map((value) => value / height);
  return [across[0], across[1], 0, across[2], down[0], down[1], 0, down[2], 0, 0, 1, 0, a[0], a[1], 0, 1];
}

const place: { size: Corner; start: number; corners: Corner[] } = await (await fetch("film.json")).json();
const [width, height] = place.size;
const film = document.createElement("video");
Object.assign(film, {
  src: URL.createObjectURL(await (await fetch("film.mp4")).blob()), // whole, so that every moment can be sought
  muted: true,
  playsInline: true,
  preload: "auto",
  className: "backdrop",
  width,
  height,
});
film.style.cssText =
  "position: absolute; inset: 0 auto auto 0; max-width: none; transform-origin: 0 0; z-index: -1; pointer-events: none";

function follow() {
  requestAnimationFrame(follow);
  const lab = (globalThis as { hophoopLab?: Lab }).hophoopLab;
  const stage = lab?.stage;
  const scene = stage?.flat.views[0];
  if (!lab || !stage || !scene) return;
  if (!film.isConnected) {
    Object.assign(stage.element.style, { isolation: "isolate", overflow: "hidden" });
    stage.plane.style.opacity = "0.7"; // the ground that is drawn covers the one that was filmed
    stage.element.prepend(film);
  }
  film.hidden = stage.options.three || lab.films().length > 1;
  const corners = place.corners.map(([along, away]) => scene.point(along, away));
  film.style.transform = `matrix3d(${onto(width, height, corners).join(",")})`;
  const wanted = place.start + lab.clock.time;
  film.style.visibility = wanted > film.duration ? "hidden" : "visible";
  if (!film.seeking && Math.abs(film.currentTime - wanted) > 0.002) film.currentTime = wanted;
}
follow();
