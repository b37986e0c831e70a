// What a diagram draws of a curve that swings often.

import assert from "node:assert/strict";
import { test } from "node:test";
import { type Crowd, drawnAs } from "../lab/diagrams/crowd.ts";

const BOX = { left: 0, top: 0, right: 200, bottom: 100 } as DOMRectReadOnly;

/** A swing about the height 50, over 200 columns of pixels. */
function swing(period: number, height = 40, each = 0.05) {
  const xs = Array.from({ length: 200 / each }, (_, i) => each * i);
  return [xs, xs.map((x) => 50 + height * Math.sin((2 * Math.PI * x) / period))];
}

test("a quick swing is a band from end to end with its mean", () => {
  const [xs, ys] = swing(1.7);
  const { band } = drawnAs(xs, ys, BOX);
  assert.equal(band?.length, 200);
  for (const crowd of band as Crowd[]) {
    assert.ok(Math.abs(crowd.low - 10) < 0.5 && Math.abs(crowd.high - 90) < 0.5);
    assert.ok(Math.abs(crowd.mean - 50) < 8);
  }
});

test("the mean is over time, however the samples lie", () => {
  // for three quarters of the time 20, with few samples, and 80 with many
  const places = Array.from({ length: 100 }, (_, k) =>
    [0, 1.5, 1.5, 1.6, 1.7, 1.8, 1.9, 2].map((x) => 2 * k + x),
  ).flat();
  const { band } = drawnAs(
    places,
    places.map((_, i) => (i % 8 < 2 ? 20 : 80)),
    BOX,
  );
  const mean = band?.[100]?.mean ?? Number.NaN;
  assert.ok(Math.abs(mean - 35) < 3);
});

test("a slow swing is a line, thinner where it is denser", () => {
  const [slow, dense] = [60, 6].map((period) => drawnAs(...(swing(period) as [number[], number[]]), BOX));
  assert.equal(slow.band ?? dense.band, null);
  assert.equal(slow.broad, 1.8);
  assert.ok(dense.broad < 1.7 && dense.broad > 0.8);
});

test("a line that is flat, or rises, stays a line however many samples it has", () => {
  const [xs] = swing(1, 0, 0.01);
  for (const slope of [0, 0.4]) {
    const { broad, band } = drawnAs(
      xs,
      xs.map((x) => 10 + slope * x),
      BOX,
    );
    assert.deepEqual([broad, band], [1.8, null]);
  }
});

test("what is not finite is left out, and columns without values are gaps", () => {
  const [xs, ys] = swing(1.7);
  const { band } = drawnAs(
    xs,
    ys.map((y, i) => (xs[i] > 80 && xs[i] < 120 ? Number.NaN : y)),
    BOX,
  );
  assert.deepEqual(
    [60, 100, 140].map((x) => band?.[x] === null),
    [false, true, false],
  );
});

test("values beyond the box do not hide that a swing within it is a block", () => {
  const [xs, ys] = swing(1.7);
  assert.ok(
    drawnAs(
      xs,
      ys.map((y, i) => (i === 7 ? -1e4 : y)),
      BOX,
    ).band,
  );
});
