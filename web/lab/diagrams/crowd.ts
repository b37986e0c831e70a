// A curve that swings so often that its line would be a block: the range of its values in each column of pixels, and their mean.

import { clamp } from "../common/clamp.ts";

const LINE = 1.8; // usual breadth of a line, in pixels
const THIN = 0.8;
const FULL = 0.4; // share of its area that a line may cover
const SWING = 3; // pixels up and down, of which rounding and steps are less
const SWINGS = 6; // that a range is taken over, so that it does not beat with the columns
const [LEAST, MOST] = [3, 12]; // columns to each side

/** Of the values near a column. */
export interface Crowd {
  x: number; // of the column's left side
  low: number;
  high: number;
  mean: number;
}

/** What a curve does in a column. */
class Band {
  low = Infinity;
  high = -Infinity;
  sum = 0;
  weight = 0;

  take(from: number, to: number, part: number) {
    this.low = Math.min(this.low, from, to);
    this.high = Math.max(this.high, from, to);
    this.sum += 0.5 * (from + to) * part;
    this.weight += part;
  }
}

/**
 * How a curve is drawn: how broad its line is, and where a thin one would be a block, the band in its place, null for
 * columns without values. `xs`, `ys`: in pixels; what is not finite parts it; `box`: what is seen.
 */
export function drawnAs(xs: ArrayLike<number>, ys: ArrayLike<number>, box: DOMRectReadOnly) {
  const seen = (y: number) => clamp(y, box.top, box.bottom);
  const piles: Band[] = [];
  let length = 0;
  for (let i = 1; i < xs.length; i++) {
    const [k, j] = xs[i] < xs[i - 1] ? [i, i - 1] : [i - 1, i];
    const across = xs[j] - xs[k];
    if (!Number.isFinite(across + ys[k] + ys[j]) || xs[j] < box.left || xs[k] > box.right) continue;
    length += Math.hypot(across, seen(ys[j]) - seen(ys[k]));
    const height = (x: number) => ys[k] + ((ys[j] - ys[k]) * (x - xs[k])) / across;
    for (let x = Math.floor(Math.max(xs[k], box.left)); x <= Math.min(xs[j], box.right); x++) {
      const [from, to] = [Math.max(xs[k], x), Math.min(xs[j], x + 1)];
      piles[x] ??= new Band();
      if (across > 0) piles[x].take(height(from), height(to), to - from);
      else piles[x].take(ys[k], ys[j], 0);
    }
  }
  const known = piles.filter(Boolean);
  const [low, high] = [
    seen(Math.min(...known.map((pile) => pile.low))),
    seen(Math.max(...known.map((pile) => pile.high))),
  ];
  const broad = (FULL * known.length * (high - low + 4 * LINE)) / length;
  if (!(broad < THIN)) return { broad: Math.min(broad || LINE, LINE), band: null };
  return {
    broad: LINE,
    band: bandOf(piles, clamp(Math.ceil((0.5 * SWINGS * known.length) / swings(ys)), LEAST, MOST)),
  };
}

/** `reach`: columns to each side. */
function bandOf(piles: Band[], reach: number) {
  return Array.from(piles, (_, x): Crowd | null => {
    const near = piles.slice(Math.max(x - reach, 0), x + reach + 1).filter(Boolean);
    if (!near.length) return null;
    const total = (name: "sum" | "weight") => near.reduce((sum, pile) => sum + pile[name], 0);
    const low = Math.min(...near.map((pile) => pile.low));
    return { x, low, high: Math.max(...near.map((pile) => pile.high)), mean: total("sum") / total("weight") };
  });
}

/** How often a curve turns back, small steps aside. */
function swings(ys: ArrayLike<number>) {
  let [count, from, way] = [1, ys[0], 0];
  for (let i = 1; i < ys.length; i++) {
    if (!(Math.abs(ys[i] - from) > SWING) && (ys[i] - from) * way <= 0) continue;
    if ((ys[i] - from) * way <= 0) count++;
    [from, way] = [ys[i], Math.sign(ys[i] - from)];
  }
  return count;
}

/** Draw a line through places; what is not finite parts it. */
export function strokeThrough(context: CanvasRenderingContext2D, xs: ArrayLike<number>, ys: ArrayLike<number>) {
  context.beginPath();
  let joins = false;
  for (let i = 0; i < xs.length; i++) {
    const there = Number.isFinite(xs[i] + ys[i]);
    if (there && joins) context.lineTo(xs[i], ys[i]);
    else if (there) context.moveTo(xs[i], ys[i]);
    joins = there;
  }
  context.stroke();
}
