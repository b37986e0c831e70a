// What a visitor says before the motion is shown: one of several answers, a mark on a circle, or a curve.

import { disc, ring, stroke } from "../common/paint.ts";
import { drawAxes, Frame, marksOf } from "../common/axes.ts";
import { scaledContext, h, theme } from "../common/dom.ts";
import { clamp, modulo } from "../common/clamp.ts";
import { follow, placeOn } from "../common/pointer.ts";

/** A guess: what stands on the page, and how good it was (from 0 to 100). */
export interface Guess {
  element: HTMLElement;
  judge: (truth: any) => number; // shows the truth beside the guess
  redraw?: () => void; // in other colours
}

/** Points for an angle: none at 90° off, all within a degree. */
export function anglePoints(guess: number, truth: number) {
  const off = Math.abs(modulo(guess - truth + 180, 360) - 180);
  return Math.round(100 * clamp(1 - (off - 1) / 89, 0, 1));
}

/** Points for a curve: by the mean distance, over the range of the true one. */
export function curvePoints(guess: number[], truth: number[]) {
  const range = Math.max(...truth) - Math.min(...truth, 0);
  const off = truth.reduce((sum, value, i) => sum + Math.abs(value - guess[i]), 0) / truth.length;
  return Math.round(100 * clamp(1 - (2 * off) / (range || 1), 0, 1));
}

let count = 0;

/** `options`: words by key. */
export function choices(options: Named<string>, onguess: () => void): Guess {
  const name = `hh-guess-${++count}`;
  const rows = Object.entries(options).map(([key, words]) => {
    const radio = h("input", { type: "radio", name, value: key, onchange: onguess });
    return { key, radio, row: h("label.guess-choice", radio, h("span", words)) };
  });
  return {
    element: h(
      "div.guess",
      { role: "radiogroup", "aria-label": "visit.guess" },
      rows.map(({ row }) => row),
    ),
    judge: (truth) => {
      const chosen = rows.find(({ radio }) => radio.checked)?.key;
      for (const { key, radio, row } of rows) {
        radio.disabled = true;
        const right = key === truth;
        if (right) row.append(h("b.guess-right", "✓"));
        row.classList.toggle("right", right);
      }
      return chosen === truth ? 100 : 0;
    },
  };
}

const SIZE = 168;
const RADIUS = 58;

/** `angle`: in degrees from the top, clockwise. */
const onCircle = (angle: number, radius = RADIUS) => {
  const way = (angle * Math.PI) / 180;
  return [SIZE / 2 + radius * Math.sin(way), SIZE / 2 - radius * Math.cos(way)];
};

/** A circle on a line, on which the place of the load is marked. */
export function dial(label: string, onguess: () => void): Guess {
  let angle = 0;
  let made = false;
  let truth: number | null = null;
  const canvas = h("canvas.dial-canvas");
  const element = h(
    "div.guess.dial",
    {
      role: "slider",
      tabindex: "0",
      "aria-label": label,
      "aria-valuemin": "0",
      "aria-valuemax": "360",
      "aria-valuenow": "0",
    },
    canvas,
  );
  const draw = () => {
    const { context } = scaledContext(canvas, element.clientWidth / SIZE || 1);
    const { ink, soft, accent } = theme(element);
    context.strokeStyle = context.fillStyle = soft;
    context.lineWidth = 1.5;
    stroke(context, [8, SIZE / 2 + RADIUS], [SIZE - 8, SIZE / 2 + RADIUS]);
    ring(context, [SIZE / 2, SIZE / 2], RADIUS, soft, 4);
    context.font = "11px system-ui, sans-serif";
    context.textAlign = "center";
    for (const mark of [0, 90, 180, 270]) {
      const [x, y] = onCircle(mark, RADIUS - 28);
      context.fillText(degrees(mark), x, y + 4);
    }
    if (truth !== null) {
      ring(context, onCircle(truth), 12, ink, 2);
      disc(context, onCircle(truth), 7, ink);
    }
    disc(context, onCircle(angle), 9, made ? accent : soft);
  };
  const turn = (to: number) => {
    if (truth !== null) return;
    angle = modulo(to, 360);
    made = true;
    element.ariaValueNow = String(Math.round(angle));
    element.ariaValueText = `${Math.round(angle)}°`;
    draw();
    onguess();
  };
  const toward = (event: PointerEvent) => {
    const [x, y] = placeOn(canvas, event, canvas.clientWidth / 2);
    turn((Math.atan2(x - 1, 1 - y) * 180) / Math.PI);
  };
  element.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    element.focus({ preventScroll: true });
    toward(event);
    follow(element, event, toward);
  });
  element.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -5, ArrowDown: -5, ArrowRight: 5, ArrowUp: 5, PageDown: -45, PageUp: 45 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    turn(angle + (event.shiftKey ? step / 5 : step));
  });
  requestAnimationFrame(draw);
  return {
    element,
    redraw: draw,
    judge: (found: number) => {
      truth = modulo(found, 360);
      draw();
      return anglePoints(angle, truth);
    },
  };
}

const POINTS = 9;
const STEP = 360 / (POINTS - 1); // degrees from one to the next
const degrees = (angle: number) => `${angle}°`;

/** A curve over one turn that is drawn by hand: points that are pulled up and down. */
export function sketch(
  { label, unit, most }: { label: string; unit: string; most: number },
  onguess: () => void,
): Guess {
  const values: number[] = Array(POINTS).fill(most / 4);
  let truth: number[] | null = null;
  const canvas = h("canvas.sketch-canvas");
  const handles = values.map((value, i) =>
    h("span.sketch-point", {
      role: "slider",
      tabindex: "0",
      "aria-label": { key: "visit.angle_value", values: { what: label, angle: degrees(STEP * i) } },
      "aria-orientation": "vertical",
      "aria-valuemin": "0",
      "aria-valuemax": String(most),
      "aria-valuenow": value.toPrecision(3),
      onkeydown: (event: KeyboardEvent) => {
        const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
        if (!way) return;
        event.preventDefault();
        event.stopPropagation();
        put(i, values[i] + (way * most) / (event.shiftKey ? 100 : 20));
      },
    }),
  );
  const element = h("div.guess.sketch", { role: "group", "aria-label": "visit.curve_label" }, canvas, handles);
  // degrees across
  const frame = new Frame(34, 12, 12, 26);
  frame.windows = { x: [0, 360], y: [0, most] };
  let px = 1;
  const draw = () => {
    const look = theme(element);
    px = look.px;
    const { context, width, height } = scaledContext(canvas, px);
    frame.fit(width, height);
    const angles = marksOf([0, 360], 4, (angle) => frame.x(angle), 90, degrees);
    const up = { marks: marksOf([0, most], 2, (value) => frame.y(value), most / 2), name: unit };
    drawAxes(context, look, frame, { across: { marks: angles, name: "" }, up, lines: true });
    context.strokeStyle = look.line;
    for (const { at } of angles) stroke(context, [at, frame.y(0)], [at, frame.y(most)]);
    const line = (heights: number[], color: string, dash: number[]) => {
      const step = 360 / (heights.length - 1);
      context.strokeStyle = color;
      context.lineWidth = 2.5;
      context.setLineDash(dash);
      stroke(context, ...heights.map((value, i) => [frame.x(step * i), frame.y(clamp(value, 0, most))]));
      context.setLineDash([]);
    };
    line(values, look.accent, [6, 4]);
    if (truth) line(truth, look.ink, []);
    handles.forEach((handle, i) => {
      handle.style.transform = `translate(${px * frame.x(STEP * i)}px, ${px * frame.y(values[i])}px)`;
    });
  };
  const put = (i: number, value: number) => {
    if (truth) return;
    values[i] = clamp(value, 0, most);
    handles[i].ariaValueNow = values[i].toPrecision(3);
    handles[i].ariaValueText = `${values[i].toPrecision(2)} ${unit}`;
    draw();
    onguess();
  };
  let last: number | null = null;
  const pull = (event: PointerEvent) => {
    const { x, y: value } = frame.place(placeOn(canvas, event, px));
    const i = Math.round(x / STEP);
    // a quick hand passes over points
    const from = last ?? i;
    const before = values[from];
    for (let k = Math.min(from, i); k <= Math.max(from, i); k++) {
      put(k, from === i ? value : before + ((value - before) * (k - from)) / (i - from));
    }
    last = i;
  };
  element.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    last = null;
    pull(event);
    follow(element, event, pull);
  });
  requestAnimationFrame(draw);
  return {
    element,
    redraw: draw,
    judge: (found: number[]) => {
      truth = found;
      draw();
      const step = (found.length - 1) / (POINTS - 1);
      return curvePoints(
        values,
        values.map((_, i) => found[Math.round(i * step)]),
      );
    },
  };
}
