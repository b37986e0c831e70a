// The axes of a diagram: their place, their ends, their numbers.

import { drawAxes, named } from "../common/axes.ts";
import { niceStep, tickText, ticks } from "../common/numbers.ts";
import { LEFT, TOP } from "./diagram.ts";
import { QUANTITIES } from "./quantities.ts";
import { t } from "../words/words.ts";
import type { Plot } from "./plot.ts";

/** From where to where an axis upwards goes for finite values. */
export function heightsOf(values: number[]) {
  if (!values.length) return [0, 1];
  const sorted = Float64Array.from(values).sort();
  let [low, high] = [sorted[0], sorted[sorted.length - 1]];
  // a force that grows without bound must not flatten all else
  const [almostLow, almostHigh] = [
    sorted[Math.floor(0.02 * sorted.length)],
    sorted[Math.ceil(0.98 * sorted.length) - 1],
  ];
  const usual = almostHigh - almostLow;
  // what almost always is zero is of interest where it is not
  if (usual > 1e-6 * (high - low)) {
    if (high > almostHigh + 4 * usual) high = almostHigh + 0.6 * usual;
    if (low < almostLow - 4 * usual) low = almostLow - 0.6 * usual;
  }
  low = Math.min(low, 0);
  high = Math.max(high, 0);
  const margin = 0.06 * (high - low) || 1;
  return [low < 0 ? low - margin : low, high + margin];
}

/** Axes with their numbers, and a line across for each height. */
export function grid(context: CanvasRenderingContext2D, plot: Plot) {
  const { look, box, heights, range } = plot;
  let tall = Math.max(box.height / 28, 4);
  // one number alone gives no scale
  while (ticks(heights[0], heights[1], tall).length < 3 && tall < 12) tall += 1;
  const step = niceStep(heights[1] - heights[0], tall);
  const wide = box.width / 70;
  const across = niceStep(range[1] - range[0], wide);
  const { name, unit } = QUANTITIES[plot.shared.axis];
  drawAxes(
    context,
    look,
    { left: LEFT, top: TOP, box },
    {
      up: {
        marks: ticks(heights[0], heights[1], tall).map((value) => ({
          at: plot.y(value),
          text: tickText(value, step),
          strong: Math.abs(value) < 1e-9 * step,
        })),
        name: t(plot.unit),
      },
      across: {
        marks: ticks(range[0], range[1], wide).map((value) => ({ at: plot.x(value), text: tickText(value, across) })),
        name: named(name, unit),
      },
      lines: true,
    },
  );
}
