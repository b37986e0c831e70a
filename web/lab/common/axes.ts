// The axes of all pictures with numbers: marks and names across and upwards, in a frame or with lines across.

import { stroke } from "./paint.ts";
import { t } from "../words/words.ts";

/** Where the picture is on its canvas, in pixels. */
export interface Place {
  left: number;
  top: number;
  box: Box;
}

export interface Axis {
  marks: { at: number; text: string; strong?: boolean }[]; // in pixels
  name: string;
}

export const axisFont = ({ font }: Look) => `11px ${font}`;

/** `lines`: a line across for each mark upwards; a frame around all otherwise; `middle`: the name across is in the middle. */
export function drawAxes(
  context: CanvasRenderingContext2D,
  look: Look,
  { left, top, box }: Place,
  { across, up, lines = false, middle = false }: { across: Axis; up: Axis; lines?: boolean; middle?: boolean },
) {
  const bottom = top + box.height;
  const right = left + box.width;
  context.save();
  context.font = axisFont(look);
  context.strokeStyle = lines ? look.line : look.soft;
  context.fillStyle = look.soft;
  context.lineWidth = 1;
  if (!lines) context.strokeRect(left + 0.5, top + 0.5, box.width - 1, box.height - 1);
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const { at, text, strong } of up.marks) {
    if (lines) {
      context.globalAlpha = strong ? 1 : 0.55;
      stroke(context, [left, Math.round(at) + 0.5], [right, Math.round(at) + 0.5]);
      context.globalAlpha = 1;
    }
    context.fillText(text, left - 6, at);
  }
  context.textBaseline = "alphabetic";
  context.textAlign = "center";
  for (const { at, text } of across.marks) {
    stroke(context, [at, bottom], [at, bottom + 4]);
    context.fillText(text, at, bottom + 15);
  }
  if (middle) context.fillText(across.name, left + 0.5 * box.width, bottom + 30);
  else {
    context.textAlign = "right";
    context.fillText(across.name, right, bottom + 27);
  }
  context.translate(11, top + 0.5 * box.height);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText(up.name, 0, 0);
  context.restore();
}

/** A name with its unit, in the visitor's language. */
export const named = (name: string, unit: string) => (unit ? `${t(name)} [${unit}]` : t(name));
