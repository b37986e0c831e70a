// What fingers and mouse do: drag, pinch.

/**
 * One press: `move` follows the finger, `end` gets the last event and whether the finger was lifted (or taken away).
 * @param {HTMLElement} element
 * @param {PointerEvent} event
 * @param {(event: PointerEvent) => void} move
 * @param {(event: PointerEvent, lifted: boolean) => void} end
 */
export function follow(element, event, move, end = () => {}) {
  const leave = new AbortController();
  const { signal } = leave;
  /** @type {(kind: "pointermove" | "pointerup" | "pointercancel", action: (other: PointerEvent) => void) => void} */
  const on = (kind, action) =>
    element.addEventListener(kind, (other) => other.pointerId === event.pointerId && action(other), { signal });
  const finish = (/** @type {boolean} */ lifted) => (/** @type {PointerEvent} */ last) => {
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
 * @param {HTMLElement} element
 * @param {(factor: number, at: Point) => void} zoom
 */
export function pinch(element, zoom) {
  /** @type {Map<number, PointerEvent>} */
  const fingers = new Map();
  /** @type {{ span: number, clientX: number, clientY: number } | null} */
  let before = null;
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
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) {
    element.addEventListener(kind, (/** @type {PointerEvent} */ event) => {
      fingers.delete(event.pointerId);
      before = null;
    });
  }
  // the page neither scrolls nor zooms under two fingers
  const still = (/** @type {TouchEvent} */ event) =>
    event.touches.length > 1 && event.cancelable && event.preventDefault();
  element.addEventListener("touchmove", still, { passive: false });
  return () => fingers.size > 1;
}
