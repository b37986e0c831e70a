// What diagrams and the plane of angle and rate have in common: two canvases, the lower for curves and the upper for the cursor.

import { Frame } from "../common/axes.ts";
import { h, pen, scaledContext } from "../common/dom.ts";
import { placeOn, zoomable } from "../common/pointer.ts";

export abstract class Diagram extends Frame {
  films: Film[];
  active: number;
  look: Look;

  canvas = h("canvas.plot-canvas");
  over = h("canvas.plot-canvas.plot-over");
  keys = h("div.plot-keys");
  body = h("div.plot-body", { tabindex: "0", role: "figure" }, this.canvas, this.over);
  element: HTMLElement;
  pinched = zoomable(this.body, {
    zoom: (factor, at) => this.films && this.zoom(1 / factor, at ? this.placeAt(at) : this.middle()),
    home: () => this.home(),
    keys: true,
  });

  constructor(name: `section.${string}`, attributes: Named<string>, title: string) {
    super(52, 10, 8, 30);
    this.element = h(name, attributes, h("header", h("h2", title), this.keys), this.body);
  }

  /** `factor`: of what is seen. */
  abstract zoom(factor: number, center: Place): void;

  abstract home(): void;

  placeAt(event: Point) {
    const { px } = this.look;
    this.fit(this.body.clientWidth / px, this.body.clientHeight / px); // it may not be drawn yet
    return this.place(placeOn(this.body, event, px));
  }

  /** What it shows. */
  take(films: Film[], active: number, look: Look) {
    Object.assign(this, { films, active, look });
  }

  /** The lower canvas, empty. */
  begin() {
    const { context, width, height } = scaledContext(this.canvas, this.look.px);
    this.fit(width, height);
    return context;
  }

  /** The upper canvas, empty; on paper it would hide the lower one, which takes its place. */
  beginOver() {
    if (this.over.closest(".printing")) return pen(this.canvas);
    return scaledContext(this.over, this.look.px).context;
  }
}

// --- How curves are told apart: dashes, and the sample of a curve beside its name

export const DASHES = [[], [6, 4], [2, 3], [14, 4], [8, 3, 2, 3]];

export function swatch(color = "var(--ink)", dash: number[] = []) {
  let at = 0;
  const parts = (dash.length ? dash : [28]).map((size, k) => {
    at += size;
    return `${k % 2 ? "transparent" : color} ${at - size}px ${at}px`;
  });
  return h("i.swatch", { style: `background: repeating-linear-gradient(90deg, ${parts})`, "aria-hidden": "true" });
}
