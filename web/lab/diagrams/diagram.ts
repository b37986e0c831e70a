// What diagrams and the plane of angle and rate have in common: two canvases, the lower for curves and the upper for the cursor.

import { h, pen, scaledContext } from "../common/dom.ts";

// What axes need beside the box of curves.
export const LEFT = 52;
export const RIGHT = 10;
export const TOP = 8;
export const BOTTOM = 30;

export class Diagram {
  films: Film[];
  active: number;
  look: Look;
  box: Box;

  canvas = h("canvas", { class: "plot-canvas" });
  over = h("canvas", { class: "plot-canvas plot-over" });
  keys = h("div", { class: "plot-keys" });
  body = h("div", { class: "plot-body", tabindex: "0", role: "figure" }, this.canvas, this.over);
  element: HTMLElement;

  constructor(attributes: Record<string, string>, title: string) {
    this.element = h("section", attributes, h("header", {}, h("h2", {}, title), this.keys), this.body);
  }

  /** The lower canvas, empty. */
  begin() {
    const { context, width, height } = scaledContext(this.canvas, this.look.px);
    this.box = { width: width - LEFT - RIGHT, height: height - TOP - BOTTOM };
    return context;
  }

  /** What is drawn from here to `restore` stays in the box. */
  clip(context: CanvasRenderingContext2D) {
    const { left, top, width, height } = this.frame();
    context.save();
    context.beginPath();
    context.rect(left, top, width, height);
    context.clip();
  }

  frame() {
    return new DOMRect(LEFT, TOP, this.box.width, this.box.height);
  }

  /** The upper canvas, empty; on paper it would hide the lower one, which takes its place. */
  beginOver() {
    if (this.over.closest(".printing")) return pen(this.canvas);
    return scaledContext(this.over, this.look.px).context;
  }
}

// --- How curves are told apart: dashes, and the sample of a curve beside its name

export const DASHES: Record<NonNullable<Curve["dash"]>, number[]> = {
  solid: [],
  dash: [6, 4],
  dot: [2, 3],
  long: [14, 4],
  mixed: [8, 3, 2, 3],
};

export function swatch(color: string | undefined, dash: Curve["dash"] = "solid") {
  const element = h("i", { class: "swatch", "aria-hidden": "true" });
  element.style.borderTopColor = color ?? "var(--ink)";
  element.style.borderTopStyle = { solid: "solid", dash: "dashed", dot: "dotted", long: "none", mixed: "none" }[dash];
  if (dash === "long" || dash === "mixed") {
    // what no border can draw
    let at = 0;
    const parts = DASHES[dash].map((size, k) => {
      at += size;
      return `${k % 2 ? "transparent" : (color ?? "var(--ink)")} ${at - size}px ${at}px`;
    });
    const background = `repeating-linear-gradient(90deg, ${parts.join(", ")})`;
    Object.assign(element.style, { height: "2.5px", width: "28px", background });
  }
  return element;
}
