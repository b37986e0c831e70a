// One rule for all pictures that can be zoomed: wheel, two fingers, double click, keys.

import { focused, pinch } from "./pointer.ts";

/** Whether fingers zoom, not a wheel. */
export const byFingers = () => matchMedia("(hover: none)").matches;

const WHEEL = 0.0018;
const MOST = 200; // of one turn of the wheel
const [CLOSER, AWAY] = [1 / 0.6, 1 / 1.7];

/**
 * The page scrolls on under the wheel unless the picture has been clicked, until Escape, or with Ctrl. `rule.zoom`: a
 * factor above 1 comes closer to the place; `rule.home`: shows everything again; `rule.chosen`: what has the focus
 * when it is chosen; the element by default; `rule.keys`: whether +, − and 0 zoom it while it has the focus; returns
 * whether two fingers are down; what one finger does has to wait then.
 */
export function zoomable(
  element: HTMLElement,
  {
    zoom,
    home,
    chosen = () => element,
    keys = false,
  }: {
    zoom: (factor: number, at?: Point) => void;
    home: () => void;
    chosen?: () => HTMLElement | null;
    keys?: boolean;
  },
): () => boolean {
  element.addEventListener(
    "wheel",
    (event) => {
      if (!(event.ctrlKey || event.metaKey || focused(chosen()))) return;
      event.preventDefault();
      zoom(Math.exp(-Math.min(Math.max(event.deltaY, -MOST), MOST) * WHEEL), event);
    },
    { passive: false },
  );
  element.addEventListener("dblclick", home);
  if (keys) {
    element.addEventListener("keydown", (event) => {
      if (event.key === "+" || event.key === "=") zoom(CLOSER);
      else if (event.key === "-") zoom(AWAY);
      else if (event.key === "0") home();
      else if (event.key === "Escape") element.blur();
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }
  return pinch(element, zoom);
}
