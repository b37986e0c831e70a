// A label of a force lies over no rim.

import assert from "node:assert/strict";
import { test } from "node:test";
import { besideRim } from "../lab/player/scene2d.ts";

const [center, radius, width] = [[200, 100], 60, 500];

test("a label that fits is within the rim, next to its arrow", () => {
  assert.equal(besideRim(200, 100, 30, center, 90, width), 212);
});

test("a longer one is outside, on the side that has room", () => {
  for (const y of [50, 80, 100, 130]) {
    const right = besideRim(200, y, 66, center, radius, width);
    assert.ok(Math.hypot(right - 200, y - 100) > radius, `${y}`);
    const left = besideRim(200, y, 66, center, radius, 310);
    assert.ok(Math.hypot(left + 66 - 200, y - 100) > radius && left < 200, `${y}`);
  }
});

test("above the rim it stays next to its arrow", () => {
  assert.equal(besideRim(200, 20, 66, center, radius, width), 212);
});
