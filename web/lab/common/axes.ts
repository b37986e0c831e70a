// All pictures with numbers: where they are, what they show, and their axes in a frame or with lines across.

import { clamp } from "./clamp.ts";
import { niceStep, tickText, ticks } from "./numbers.ts";
import { stroke } from "./paint.ts";
import { t } from "../words/words.ts";

/** Where a picture is on its canvas, in pixels, and from where to where it goes across and upwards. */
export class Frame {
  box: Box;
  windows: Record<AxisName, number[]>;

  constructor(
    public left: number,
    readonly right: number,
    readonly top: number,
    readonly bottom: number,
  ) {}

  /** Take the room of a canvas. */
  fit(width: number, height: number) {
    this.box = { width: width - this.left - this.right, height: height - this.top - this.bottom };
  }

  x(value: number) {
    const [low, high] = this.windows.x;
    return this.left + ((value - low) / (high - low)) * this.box.width;
  }

  y(value: number) {
    const [low, high] = this.windows.y;
    return this.top + (1 - (value - low) / (high - low)) * this.box.height;
  }

  /** The place under a point of the canvas. */
  place([x, y]: number[]): Place {
    const at = ([low, high]: number[], share: number) => low + clamp(share, 0, 1) * (high - low);
    return {
      x: at(this.windows.x, (x - this.left) / this.box.width),
      y: at(this.windows.y, 1 - (y - this.top) / this.box.height),
    };
  }

  /** The middle of what is shown. */
  middle(): Place {
    const { x, y } = this.windows;
    return { x: 0.5 * (x[0] + x[1]), y: 0.5 * (y[0] + y[1]) };
  }

  edges() {
    return new DOMRect(this.left, this.top, this.box.width, this.box.height);
  }

  /** What is drawn from here to `restore` stays inside. */
  clip(context: CanvasRenderingContext2D) {
    context.save();
    context.beginPath();
    context.rect(this.left, this.top, this.box.width, this.box.height);
    context.clip();
  }
}

export interface Axis {
  marks: { at: number; text: string; strong?: boolean }[]; // in pixels
  name: string;
}

/** Round numbers of an axis. `at`: where one is; `step`: from one to the next; `text`: that of one. */
export function marksOf(
  [low, high]: number[],
  count: number,
  at: (value: number) => number,
  step = niceStep(high - low, count),
  text = tickText,
) {
  const strong = (value: number) => Math.abs(value) < 1e-9 * step;
  return ticks(low, high, step).map((value) => ({ at: at(value), text: text(value, step), strong: strong(value) }));
}

export const axisFont = ({ font }: Look) => `11px ${font}`;

/** `lines`: a line across for each mark upwards; a frame around all otherwise; `middle`: the name across is in the middle. */
export function drawAxes(
  context: CanvasRenderingContext2D,
  look: Look,
  { left, top, box }: Frame,
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
