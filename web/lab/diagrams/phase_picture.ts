// What the plane of angle and rate is drawn of: the regions of modes, Painlevé's paradox, the axes.

import { tables } from "../../model/tables.ts";
import { faded, parsed } from "../common/colors.ts";
import { h, pen } from "../common/dom.ts";
import { niceStep, tickText, ticks } from "../common/numbers.ts";
import { LEFT, RIGHT, TOP } from "./plot_axes.ts";
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

/** Columns in which slip meets the paradox, hatched one way for spin and the other for skid. */
export function hatch(context: CanvasRenderingContext2D, plane: PhasePlane, paradox: Column) {
  const columns = paradox.length;
  context.strokeStyle = faded(plane.look.dark ? "#ffffff" : "#000000", 0.28);
  context.lineWidth = 1;
  for (let from = 0; from < columns; from++) {
    if (!paradox[from]) continue;
    let to = from;
    while (to < columns && paradox[to] === paradox[from]) to++;
    const left = plane.x((from * 2 * Math.PI) / columns);
    const right = plane.x((to * 2 * Math.PI) / columns);
    context.save();
    context.beginPath();
    context.rect(left, TOP, right - left, plane.box.height);
    context.clip();
    context.beginPath();
    const way = paradox[from];
    for (let c = -plane.box.height; c < right - left + plane.box.height; c += 7) {
      context.moveTo(left + c, way > 0 ? TOP + plane.box.height : TOP);
      context.lineTo(left + c + plane.box.height, way > 0 ? TOP : TOP + plane.box.height);
    }
    context.stroke();
    context.restore();
    from = to;
  }
}

export function axes(context: CanvasRenderingContext2D, plane: PhasePlane, width: number, height: number) {
  const { look } = plane;
  context.font = `11px ${look.font}`;
  context.strokeStyle = look.soft;
  context.fillStyle = look.soft;
  context.lineWidth = 1;
  context.strokeRect(LEFT + 0.5, TOP + 0.5, plane.box.width - 1, plane.box.height - 1);
  context.textAlign = "center";
  const low = (plane.range[0] * 180) / Math.PI;
  const high = (plane.range[1] * 180) / Math.PI;
  const step = high - low > 200 ? 45 : niceStep(high - low, 6);
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9; k++) {
    const x = plane.x((k * step * Math.PI) / 180);
    context.beginPath();
    context.moveTo(x, TOP + plane.box.height);
    context.lineTo(x, TOP + plane.box.height + 4);
    context.stroke();
    context.fillText(tickText(k * step, step), x, TOP + plane.box.height + 15);
  }
  context.textAlign = "right";
  context.fillText(t("angle θ within a turn [°]"), width - RIGHT, height - 3);
  context.textBaseline = "middle";
  const span = plane.top() - plane.bottom();
  for (const value of ticks(plane.bottom(), plane.top(), 5)) {
    context.fillText(tickText(value, niceStep(span, 5)), LEFT - 6, plane.y(value));
  }
  context.textBaseline = "alphabetic";
  context.save();
  context.translate(11, TOP + 0.5 * plane.box.height);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText("θ̇ [rad/s]", 0, 0);
  context.restore();
}
