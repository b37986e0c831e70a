// Arrows in the picture: from where the rim touches, or comes closest, at each event to where it would with a little more.

import { arrowHead, disc, haloed, outlined, stroke } from "../common/paint.ts";
import { counts, type Changes } from "../sensitivity/changes.ts";
import { MARKS } from "./marks.ts";
import type { Scene } from "./scene2d.ts";

const WANTED = 0.7; // of the radius: how long the arrow of usual length is drawn
const LEAST = 34; // pixels, where the hoop is small
const MOST = 3; // times as long as usual: longer ones are drawn broken
const COUNT = 400; // events
const ROWS = 8; // more arrows than that over each other are left out
const ROW = 13; // pixels between arrows that would lie over each other

export type Arrow = { kind: string; x: number; y: number; dx: number; dy: number };

export function arrowsOf(changes: Changes): Arrow[] {
  const { events, count } = changes;
  return events
    .slice(0, Math.min(count, COUNT))
    .map(({ kind, x, height }, k) => ({ kind, x, y: height, dx: changes.of(k, "x"), dy: changes.of(k, "height") }));
}

/**
 * How many times as long as the change arrows are drawn: 1, 2 or 5 times a power of ten, so that usual ones are seen
 * well. `scale`: pixels for a metre.
 */
export function magnified(arrows: Arrow[], radius: number, scale: number) {
  const lengths = arrows
    .map(({ dx, dy }) => Math.hypot(dx, dy))
    .filter((length) => Number.isFinite(length) && counts(length, radius))
    .sort((a, b) => a - b);
  if (!lengths.length) return 0;
  const rough = Math.max(WANTED * radius, LEAST / scale) / lengths[Math.floor(lengths.length / 2)];
  if (rough <= 1) return 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const share = rough / power;
  return (share >= 5 ? 5 : share >= 2 ? 2 : 1) * power;
}

export function drawArrows(scene: Scene, arrows: Arrow[], factor: number) {
  const taken: { low: number; high: number; base: number }[] = [];
  const most = MOST * Math.max(WANTED * scene.film.radius, LEAST / scene.scale);
  for (const { kind, x, y, dx, dy } of arrows) {
    const known = Number.isFinite(dx) && Number.isFinite(dy);
    const length = known ? factor * Math.hypot(dx, dy) : 0;
    const cut = length > most ? most / length : 1;
    const way = known ? [cut * factor * dx, cut * factor * dy] : [0, 0];
    const from = scene.point(x, y);
    const to = scene.point(x + way[0], y + way[1]);
    if (Math.max(from[0], to[0]) < -20 || Math.min(from[0], to[0]) > scene.width + 20) continue;
    const [low, high] = [Math.min(from[0], to[0]) - 12, Math.max(from[0], to[0]) + 12];
    let base = from[1];
    while (taken.some((other) => Math.abs(other.base - base) < ROW - 1 && other.low < high && other.high > low))
      base -= ROW;
    if (from[1] - base > ROWS * ROW) continue;
    taken.push({ low, high, base });
    const lift = base - from[1];
    change(scene, from, [to[0], to[1] + lift], lift, { known, broken: cut < 1, mark: MARKS[kind] ?? "" });
  }
}

/** `lift`: how far it is moved up, in pixels. */
function change(
  { context, look }: Scene,
  from: number[],
  to: number[],
  lift: number,
  { known, broken, mark }: { known: boolean; broken: boolean; mark: string },
) {
  const begin = [from[0], from[1] + lift];
  const length = Math.hypot(to[0] - begin[0], to[1] - begin[1]);
  const [ux, uy] = length > 0 ? [(to[0] - begin[0]) / length, (to[1] - begin[1]) / length] : [1, 0];
  const head = Math.min(9, length);
  context.lineCap = "round";
  outlined(context, [look.paper, 6.5], [look.ink, 2.5], (wide) => {
    if (lift) {
      context.lineWidth = wide > 3 ? 3 : 1;
      stroke(context, from, begin);
    }
    context.lineWidth = wide;
    context.setLineDash(broken ? [5, 6] : []);
    stroke(context, begin, [to[0] - ux * head, to[1] - uy * head]);
    context.setLineDash([]);
    disc(context, begin, wide > 3 ? 5.5 : 3.5);
    if (length < 1) return;
    arrowHead(context, to, [ux, uy], head);
    context.lineWidth = wide > 3 ? 4 : 1;
    context.closePath();
    context.stroke();
  });
  context.lineCap = "butt";
  const label = known ? mark : "?";
  if (!label) return;
  context.font = `600 ${11 * look.px}px ${look.font}`;
  context.textAlign = "center";
  haloed(context, label, [begin[0], begin[1] - 7], look.ink, look.paper);
}
