// Take-offs, impacts and jams: a ring that spreads as they happen, and a mark that stays on the plane.

import { between } from "./data.ts";

const FLASH = 0.5; // how long a ring spreads [s of film]
const SPREAD = 0.45; // how far, in radii of the hoop
const SIZE = 6;
const FONT = '"DejaVu Sans", system-ui, sans-serif';

/** `scale`: pixels of a metre. */
export function drawMarks(
  pen: CanvasRenderingContext2D,
  { space, data }: { space: any; data: SceneData },
  { hoop }: ScenePose,
  now: number,
  focus: number,
  scale: number,
  ratio: number,
) {
  const time = between(hoop.t, now);
  const depth = -hoop.lane + 0.35 * data.radius;
  pen.strokeStyle = data.theme.ink;
  pen.fillStyle = data.theme.ink;
  pen.font = `${12 * ratio}px ${FONT}`;
  let free = -Infinity; // where the next word may begin
  const past = hoop.marks.filter(([t]) => t <= time).sort((a, b) => a[1] - b[1]);
  for (const [t, along, kind, word] of past) {
    const spot = space.onScreen([along - focus, 0, depth]);
    if (!spot) continue;
    const [x, y] = spot;
    const age = (time - t) / data.rate[Math.floor(now)];
    if (age < FLASH) ring(pen, x, y, age / FLASH, hoop.radius * scale, ratio);
    sign(pen, kind, x, y + 12 * ratio, SIZE * ratio);
    const half = 0.5 * pen.measureText(word).width;
    if (x - half < free) continue;
    pen.fillText(word, x, y + 34 * ratio);
    free = x + half + 6 * ratio;
  }
}

/** `share`: of the time that it spreads. */
function ring(pen: CanvasRenderingContext2D, x: number, y: number, share: number, radius: number, ratio: number) {
  pen.globalAlpha = 1 - share;
  pen.lineWidth = (3 * (1 - share) + 0.6) * ratio;
  pen.beginPath();
  pen.arc(x, y, (0.08 + SPREAD * share) * radius, 0, 2 * Math.PI);
  pen.stroke();
  pen.globalAlpha = 1;
}

function sign(pen: CanvasRenderingContext2D, kind: string, x: number, y: number, size: number) {
  pen.beginPath();
  if (kind === "takeoff" || kind === "impact") {
    const up = kind === "takeoff" ? -size : size;
    pen.moveTo(x - size, y - up);
    pen.lineTo(x + size, y - up);
    pen.lineTo(x, y + up);
    pen.fill();
    return;
  }
  pen.lineWidth = 0.4 * size;
  for (const way of [-size, size]) {
    pen.moveTo(x - size, y - way);
    pen.lineTo(x + size, y + way);
  }
  pen.stroke();
}
