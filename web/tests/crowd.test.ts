// What a diagram draws where many samples fall on one column of pixels.

import assert from "node:assert/strict";
import { test } from "node:test";
import { type Crowd, crowded, crowdsOf } from "../lab/diagrams/crowd.ts";

test("a quick swing over few pixels is a band with its mean", () => {
  const xs = Array.from({ length: 4000 }, (_, i) => i / 100);
  const crowds = crowdsOf(
    xs,
    xs.map((_, i) => 50 + 40 * Math.sin((2 * Math.PI * i) / 100)),
  );
  assert.ok(crowded(crowds));
  assert.equal(crowds.length, 40);
  for (const crowd of crowds as Crowd[]) {
    assert.equal(crowd.count, 100);
    assert.ok(Math.abs(crowd.low - 10) < 0.1 && Math.abs(crowd.high - 90) < 0.1);
    assert.ok(Math.abs(crowd.middle - 50) < 1e-9);
  }
});

test("few samples stay a line", () => {
  const xs = Array.from({ length: 100 }, (_, i) => 2 * i);
  assert.ok(!crowded(crowdsOf(xs, xs)));
});

test("what is not finite parts a curve", () => {
  const crowds = crowdsOf([0.1, 0.2, 1.5, 1.6, 2.1], [1, 3, Number.NaN, Number.NaN, 5]);
  assert.deepEqual(crowds, [
    { x: 0, low: 1, high: 3, middle: 2, count: 2 },
    null,
    { x: 2, low: 5, high: 5, middle: 5, count: 1 },
  ]);
});
