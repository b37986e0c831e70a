// The axes of a map, and what it says of its starts.

import assert from "node:assert/strict";
import { test } from "node:test";
import { within } from "../lab/common/clamp.ts";
import { AXES, MapAxes, otherStart } from "../lab/map/map_axes.ts";
import { tables } from "../model/tables.ts";

const axes = () => new MapAxes(tables.setup.controls.map_axes);

test("a map stays where its parameters are allowed", () => {
  const map = axes();
  map.fit(600, 400);
  const inside = () => {
    assert.ok(map.windows.y[0] >= 0); // friction
    for (const name of AXES) {
      const [low, high] = map.windows[name];
      const [least, most] = map.info(name).allowed;
      assert.ok(least <= low && low < high && high <= most, `${name}: ${low} to ${high}`);
    }
  };
  for (let k = 0; k < 30; k++) {
    map.zoom(2);
    inside();
  }
  for (const way of [-2000, 2000]) {
    map.drag(map.windows, way, -way);
    inside();
  }
});

test("a map is dragged with the hand", () => {
  const map = axes();
  map.fit(600, 400);
  map.windows = { x: [1, 2], y: [0.4, 0.6] };
  map.drag(map.windows, 0.25 * map.box.width, 0.25 * map.box.height);
  assert.deepEqual(map.windows.x, [0.75, 1.75]);
  assert.ok(Math.abs(map.windows.y[0] - 0.45) < 1e-12); // what is higher comes down
});

test("a range is moved into its bounds, and cut if it must be", () => {
  assert.deepEqual(within([-1, 2], [0, 10]), [0, 3]);
  assert.deepEqual(within([8, 12], [0, 10]), [6, 10]);
  assert.deepEqual(within([-5, 50], [0, 10]), [0, 10]);
});

test("the name of an axis has room beside its longest number", () => {
  const wide = (text: string) => 6.5 * text.length;
  for (const part of [1, 1e-5, 1e-13]) {
    const map = axes();
    map.windows.y = [0.3, 0.3 + part];
    map.fit(600, 400, wide);
    const longest = Math.max(...map.axis("y", 9).marks.map(({ text }) => wide(text)));
    assert.ok(map.left - 6 - longest > 18); // the numbers end 6 pixels beside the axis; the name takes 18
  }
});

test("a map says when its starts are others", () => {
  const said = (start: object, path: string) => otherStart({ start } as Scenario, [path, "plane.mu"]);
  assert.equal(said({ vx: 1, omega: 2 }, "start.speed"), "map.start_rolling");
  assert.equal(said({ vx: 1, omega: 2 }, "start.vx"), "");
  assert.equal(said({ speed: 3.1 }, "start.speed"), "");
  assert.equal(said({ speed: 3.1 }, "start.vx"), "map.start_free");
});
