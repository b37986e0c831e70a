// The axes of a diagram: their place, their ends, their numbers.

import { niceStep, tickText, ticks } from "../common/numbers.ts";
import { QUANTITIES } from "./quantities.ts";
import { t } from "../words/words.ts";
import type { Plot } from "./plot.ts";

// What axes need beside the box of curves.
export const LEFT = 52;
export const RIGHT = 10;
export const TOP = 8;
export const BOTTOM = 30;

/**
 * From where to where an axis upwards goes for values. `values`: finite ones; `symmetric`: whether zero is in the
 * middle.
 */
export function heightsOf(values: number[], symmetric: boolean) {
  if (!values.length) return [0, 1];
  const sorted = Float64Array.from(values).sort();
  let [low, high] = [sorted[0], sorted[sorted.length - 1]];
  // a force that grows without bound must not flatten all else
  const [almostLow, almostHigh] = [
    sorted[Math.floor(0.02 * sorted.length)],
    sorted[Math.ceil(0.98 * sorted.length) - 1],
  ];
  const usual = Math.max(almostHigh - almostLow, 1e-12);
  if (high > almostHigh + 4 * usual) high = almostHigh + 0.6 * usual;
  if (low < almostLow - 4 * usual) low = almostLow - 0.6 * usual;
  low = Math.min(low, 0);
  high = Math.max(high, 0);
  if (symmetric) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  const margin = 0.06 * (high - low) || 1;
  return [low < 0 ? low - margin : low, high + margin];
}

/** Axes with their numbers, and a line across for each height. */
export function grid(context: CanvasRenderingContext2D, plot: Plot, width: number, height: number) {
  const { look, box, heights, range } = plot;
  context.font = `11px ${look.font}`;
  context.strokeStyle = look.line;
  context.fillStyle = look.soft;
  context.lineWidth = 1;
  let tall = Math.max(box.height / 28, 4);
  // one number alone gives no scale
  while (ticks(heights[0], heights[1], tall).length < 3 && tall < 12) tall += 1;
  const step = niceStep(heights[1] - heights[0], tall);
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of ticks(heights[0], heights[1], tall)) {
    const y = Math.round(plot.y(value)) + 0.5;
    context.globalAlpha = Math.abs(value) < 1e-9 * step ? 1 : 0.55;
    context.beginPath();
    context.moveTo(LEFT, y);
    context.lineTo(width - RIGHT, y);
    context.stroke();
    context.globalAlpha = 1;
    context.fillText(tickText(value, step), LEFT - 6, y);
  }
  const wide = box.width / 70;
  const across = niceStep(range[1] - range[0], wide);
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  const { name, unit: inUnit } = QUANTITIES[plot.shared.axis];
  const unit = inUnit ? `${t(name)} [${inUnit}]` : t(name);
  for (const value of ticks(range[0], range[1], wide)) {
    const x = plot.x(value);
    context.beginPath();
    context.moveTo(x, TOP + box.height);
    context.lineTo(x, TOP + box.height + 4);
    context.stroke();
    context.fillText(tickText(value, across), x, TOP + box.height + 15);
  }
  context.textAlign = "right";
  context.fillText(unit, width - RIGHT, height - 3);
  context.save();
  context.translate(11, TOP + 0.5 * box.height);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText(t(plot.unit), 0, 0);
  context.restore();
}
