// How curves are told apart: dashes, and the sample of a curve beside its name.

import { h } from "../common/dom.ts";

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
