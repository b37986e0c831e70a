// What the plane of angle and rate is drawn of: the regions of modes, Painlevé's paradox, the axes.

import { tables } from "../../model/tables.ts";
import { drawAxes } from "../common/axes.ts";
import { faded, parsed } from "../common/colors.ts";
import { h, pen } from "../common/dom.ts";
import { clamp } from "../common/clamp.ts";
import { DEGREE, niceStep, tickText, ticks } from "../common/numbers.ts";
import { LEFT, TOP } from "./diagram.ts";
import { t } from "../words/words.ts";
import type { PhasePlane } from "./phase.ts";

const { letters } = tables.words;

/** `codes`: by rows; `colors`: of the modes. */
export function pictureOf(codes: Column, columns: number, colors: Record<string, string>) {
  const rows = codes.length / columns;
  const picture = h("canvas", { width: columns, height: rows });
  const image = new ImageData(columns, rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const letter = letters[codes[row * columns + column]]; // none where the model has no answer
      const color = parsed(colors[letter] ?? "#6E6E6E");
      const place = 4 * ((rows - 1 - row) * columns + column);
      image.data.set([...color, 255], place);
    }
  }
  pen(picture).putImageData(image, 0, 0);
  return picture;
}

const BOTH = 2;

/** Where slip meets the paradox, for θ̇ < 0 and for θ̇ > 0: hatched one way for spin and the other for skid. */
export function hatch(context: CanvasRenderingContext2D, plane: PhasePlane, paradox: Column) {
  const columns = paradox.length / 2;
  const [top, middle, bottom] = [TOP, clamp(plane.y(0), TOP, TOP + plane.box.height), TOP + plane.box.height];
  context.strokeStyle = faded(plane.look.dark ? "#ffffff" : "#000000", 0.28);
  context.lineWidth = 1;
  for (const [first, up, down] of [
    [0, middle, bottom],
    [columns, top, middle],
  ]) {
    for (let from = 0; from < columns; from++) {
      const side = paradox[first + from];
      if (!side) continue;
      let to = from;
      while (to < columns && paradox[first + to] === side) to++;
      const left = plane.x((from * 2 * Math.PI) / columns);
      const right = plane.x((to * 2 * Math.PI) / columns);
      context.save();
      context.beginPath();
      context.rect(left, up, right - left, down - up);
      context.clip();
      context.beginPath();
      const { height } = plane.box;
      for (let c = -height; c < right - left + height; c += 7) {
        for (const rises of side === BOTH ? [true, false] : [side > 0]) {
          context.moveTo(left + c, rises ? bottom : top);
          context.lineTo(left + c + height, rises ? top : bottom);
        }
      }
      context.stroke();
      context.restore();
      from = to;
    }
  }
}

export function axes(context: CanvasRenderingContext2D, plane: PhasePlane) {
  const { look, box } = plane;
  const [low, high] = plane.range.map((angle) => angle / DEGREE);
  const step = high - low > 200 ? 45 : niceStep(high - low, 6);
  const angles = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9; k++) angles.push(k * step);
  const tall = niceStep(plane.top() - plane.bottom(), 5);
  drawAxes(
    context,
    look,
    { left: LEFT, top: TOP, box },
    {
      across: {
        marks: angles.map((angle) => ({ at: plane.x(angle * DEGREE), text: tickText(angle, step) })),
        name: t("phase.angle_axis"),
      },
      up: {
        marks: ticks(plane.bottom(), plane.top(), 5).map((rate) => ({ at: plane.y(rate), text: tickText(rate, tall) })),
        name: "θ̇ [rad/s]",
      },
    },
  );
}
