// What fingers and mouse do: drag, pinch; and where the keys go.

import { clamp } from "./clamp.ts";

/** Also inside a shadow tree, where notebooks put widgets. */
export const focused = (element: HTMLElement | null) =>
  element !== null && (element.getRootNode() as Document | ShadowRoot).activeElement === element;

/** Where an event is on an element, in so many pixels. */
export function placeOn(element: Element, { clientX, clientY }: Point, pixels = 1) {
  const { left, top } = element.getBoundingClientRect();
  return [(clientX - left) / pixels, (clientY - top) / pixels];
}

/**
 * One press: `move` follows the finger, `end` gets the last event and whether the finger was lifted (or taken away).
 */
export function follow(
  element: HTMLElement,
  event: PointerEvent,
  move: (event: PointerEvent) => void,
  end: (event: PointerEvent, lifted: boolean) => void = () => {},
) {
  const leave = new AbortController();
  const { signal } = leave;
  const on = (kind: "pointermove" | "pointerup" | "pointercancel", action: (other: PointerEvent) => void) =>
    element.addEventListener(kind, (other) => other.pointerId === event.pointerId && action(other), { signal });
  const finish = (lifted: boolean) => (last: PointerEvent) => {
    leave.abort();
    end(last, lifted);
  };
  element.setPointerCapture(event.pointerId);
  on("pointermove", move);
  on("pointerup", finish(true));
  on("pointercancel", finish(false));
}

/**
 * Two fingers zoom: `zoom` gets the factor by which they have spread and the point between them. The function that
 * comes back tells whether two fingers are down; what one finger does has to wait then.
 */
function pinch(element: HTMLElement, zoom: (factor: number, at: Point) => void) {
  const fingers = new Map<number, PointerEvent>();
  let before: { span: number; clientX: number; clientY: number } | null = null;
  const measured = () => {
    const [a, b] = [...fingers.values()];
    return {
      span: Math.max(Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY), 1),
      clientX: 0.5 * (a.clientX + b.clientX),
      clientY: 0.5 * (a.clientY + b.clientY),
    };
  };
  element.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") return;
    fingers.set(event.pointerId, event);
    before = fingers.size === 2 ? measured() : null;
  });
  element.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    fingers.set(event.pointerId, event);
    if (fingers.size !== 2 || !before) return;
    const now = measured();
    zoom(now.span / before.span, now);
    before = now;
  });
  for (const kind of ["pointerup", "pointercancel"] as const) {
    element.addEventListener(kind, (event: PointerEvent) => {
      fingers.delete(event.pointerId);
      before = null;
    });
  }
  // the page neither scrolls nor zooms under two fingers
  const still = (event: TouchEvent) => event.touches.length > 1 && event.cancelable && event.preventDefault();
  element.addEventListener("touchmove", still, { passive: false });
  return () => fingers.size > 1;
}

// --- One rule for all pictures that can be zoomed: wheel, two fingers, double click, keys

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
) {
  element.addEventListener(
    "wheel",
    (event) => {
      if (!(event.ctrlKey || event.metaKey || focused(chosen()))) return;
      event.preventDefault();
      zoom(Math.exp(-clamp(event.deltaY, -MOST, MOST) * WHEEL), event);
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
