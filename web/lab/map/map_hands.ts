// Mouse, fingers and keys on a map: drag to move, a click or Enter takes a motion; it zooms as all pictures do.

import { clamp } from "../common/clamp.ts";
import { follow, placeOn } from "../common/pointer.ts";
import { zoomable } from "../common/zoom.ts";
import type { MotionMap } from "./map.ts";

const WAYS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const STEPS = 48; // of the arrow keys across a map

export function takeHands(map: MotionMap) {
  const { body } = map;
  let dragging = false;
  const pinched = zoomable(body, {
    zoom: (factor, at) => map.axes.box && map.zoom(1 / factor, at ? placeAt(map, at) : map.aim()),
    home: () => map.home(),
    keys: true,
  });
  body.addEventListener("pointerdown", (event) => press(map, event, pinched, (now) => (dragging = now)));
  body.addEventListener("pointermove", (event) => {
    if (map.axes.box && !dragging && event.pointerType !== "touch") hover(map, event);
  });
  body.addEventListener("pointerleave", () => (map.tip.hidden = true));
  body.addEventListener("keydown", (event) => key(map, event));
}

function placeAt(map: MotionMap, event: Point) {
  const [x, y] = placeOn(map.body, event, map.look.px);
  return map.axes.place(x, y);
}

function hover(map: MotionMap, event: PointerEvent) {
  map.tip.textContent = map.said(placeAt(map, event));
  map.tip.hidden = false;
  const [x, y] = placeOn(map.body, event);
  const { clientWidth, clientHeight } = map.body;
  map.tip.style.left = `${clamp(x, 150, Math.max(clientWidth - 150, 150))}px`;
  map.tip.style.bottom = `${clientHeight - y + 16}px`;
}

function press(map: MotionMap, event: PointerEvent, pinched: () => boolean, drags: (now: boolean) => void) {
  event.preventDefault();
  map.body.focus({ preventScroll: true });
  const start = [event.clientX, event.clientY];
  const from = { x: [...map.axes.windows.x], y: [...map.axes.windows.y] };
  map.pointed = placeAt(map, event);
  let dragged = false;
  let scrolls = false;
  let twoFingers = pinched();
  const move = (moved: PointerEvent) => {
    twoFingers ||= pinched();
    if (twoFingers) return;
    const [dx, dy] = [moved.clientX - start[0], moved.clientY - start[1]];
    if (scrolls || (Math.hypot(dx, dy) < 5 && !dragged)) return;
    // a finger that starts upwards or downwards scrolls the page
    scrolls = !dragged && event.pointerType === "touch" && Math.abs(dy) >= Math.abs(dx);
    if (scrolls) return;
    dragged = true;
    drags(true);
    map.tip.hidden = true;
    map.axes.drag(from, dx / map.look.px, dy / map.look.px);
    map.redraw();
    map.soon();
  };
  follow(map.body, event, move, (_last, lifted) => {
    if (lifted && !dragged && !scrolls && !twoFingers && map.pointed) map.take(map.pointed);
    drags(false);
  });
}

function key(map: MotionMap, event: KeyboardEvent) {
  const place = map.pointed ?? map.here() ?? map.axes.middle();
  map.pointed = place;
  if (WAYS[event.key]) {
    const [dx, dy] = WAYS[event.key];
    const { x, y } = map.axes.windows;
    map.pointed = {
      x: clamp(place.x + (dx * (x[1] - x[0])) / STEPS, x[0], x[1]),
      y: clamp(place.y + (dy * (y[1] - y[0])) / STEPS, y[0], y[1]),
    };
    map.state.textContent = map.said(map.pointed);
    map.lab.story.say(map.said(map.pointed));
  } else if (event.key === "Enter") map.take(place);
  else return;
  event.preventDefault();
  event.stopPropagation();
  map.redraw();
}
