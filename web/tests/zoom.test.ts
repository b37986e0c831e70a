// Wheel, double click and keys on a picture that does not have the focus.

import assert from "node:assert/strict";
import { test } from "node:test";
import { zoomable } from "../lab/common/pointer.ts";

/** A picture, and what was asked of it. */
function picture(keys = false) {
  const element = new EventTarget() as any;
  const asked: number[] = [];
  Object.assign(element, { getRootNode: () => ({}), blur: () => asked.push(-1), style: {} });
  zoomable(element, { zoom: (factor) => asked.push(factor), home: () => asked.push(0), keys });
  const send = (kind: string, values = {}) => {
    const event = Object.assign(new Event(kind, { cancelable: true }), values);
    element.dispatchEvent(event);
    return event.defaultPrevented;
  };
  return { asked, send };
}

test("Ctrl zooms at once, and one turn of the wheel has a limit", () => {
  const { asked, send } = picture();
  send("wheel", { deltaY: 1e6, ctrlKey: true });
  send("wheel", { deltaY: 200, ctrlKey: true });
  assert.equal(asked[0], asked[1]);
  assert.ok(asked[0] < 1);
});

test("a double click shows all, keys zoom where they are wanted", () => {
  const { asked, send } = picture(true);
  send("dblclick");
  for (const key of ["+", "-", "0", "Escape"]) assert.equal(send("keydown", { key }), true);
  assert.equal(send("keydown", { key: "x" }), false);
  assert.ok(asked[1] > 1 && asked[2] < 1);
  assert.deepEqual([asked[0], asked[3], asked[4]], [0, 0, -1]);
  const other = picture();
  assert.equal(other.send("keydown", { key: "+" }), false);
});
