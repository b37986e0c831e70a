// Boundaries between the classes of a map, from classes at any place.

import assert from "node:assert/strict";
import { test } from "node:test";
import { type Boundaries, boundariesOf } from "../lab/map/boundaries.ts";

type Class = (x: number, y: number) => number;

/** What is found for a class at each place in cells, nan where there is none. */
async function found(size: [number, number], classOf: Class) {
  const [wide, high] = size;
  const values = Array.from({ length: wide * high }, (_, k) => classOf((k % wide) + 0.5, Math.floor(k / wide) + 0.5));
  const code = (value: number) => (value >= 0 ? value : -1);
  const shapes = await boundariesOf(values, size, async (places) => places.map(([x, y]) => code(classOf(x, y))));
  return shapes as Boundaries;
}

/** Twice the area to the left of a polygon's sides. */
function doubleArea(polygon: number[]) {
  let sum = 0;
  for (let k = 0; k < polygon.length; k += 2) {
    const [x, y, u, v] = [0, 1, 2, 3].map((step) => polygon[(k + step) % polygon.length]);
    sum += x * v - u * y;
  }
  return sum;
}

test("a circle is found to a thousandth of a cell, where sides of squares cross it", async () => {
  const radius = 7.3;
  const shapes = await found([24, 20], (x, y) => Number(Math.hypot(x - 11.9, y - 10.2) < radius));
  assert.ok(shapes.lines.length > 80);
  const errors = shapes.lines.map(([x, y]) => Math.abs(Math.hypot(x - 11.9, y - 10.2) - radius));
  assert.ok(Math.max(...errors) < 1e-3);
  const ends = shapes.lines.map(([, , x, y]) => Math.abs(Math.hypot(x - 11.9, y - 10.2) - radius));
  assert.ok(Math.max(...ends) < 0.04); // the middle of a chord
});

test("areas are on the right side, and fill the squares that are cut", async () => {
  const shapes = await found([16, 16], (x, y) => Number(y > 0.31 * x + 4.2));
  for (const [code, polygons] of shapes.areas) {
    for (const polygon of polygons) {
      assert.ok(doubleArea(polygon) > 0);
      for (let k = 0; k < polygon.length; k += 2) {
        const above = polygon[k + 1] - (0.31 * polygon[k] + 4.2);
        assert.ok(code === 1 ? above > -1e-3 : above < 1e-3);
      }
    }
  }
  const total = [...shapes.areas.values()].flat().reduce((sum, polygon) => sum + 0.5 * doubleArea(polygon), 0);
  assert.ok(Math.abs(total - Math.round(total)) < 0.01 && total > 16);
});

test("three classes meet in a point, to a part of a cell", async () => {
  const shapes = await found([12, 12], (x, y) => (y < 5.4 ? 0 : x < 6.8 ? 1 : 2));
  assert.deepEqual([...shapes.areas.keys()].sort(), [0, 1, 2]);
  const near = shapes.lines.map(([x, y]) => Math.hypot(x - 6.8, y - 5.4));
  assert.ok(Math.min(...near) < 0.15);
  for (const [x, y, u, v] of shapes.lines) {
    // lines lie on the boundaries but within a part of a cell of the point
    const far = (a: number, b: number) => Math.min(Math.abs(b - 5.4), b > 5.3 ? Math.abs(a - 6.8) : Infinity);
    if (Math.hypot(x - 6.8, y - 5.4) > 0.3) assert.ok(Math.max(far(x, y), far(u, v)) < 1e-3);
  }
});

test("a narrow class between two that the cells show has both its boundaries", async () => {
  const shapes = await found([10, 10], (x) => (x < 4.7 ? 0 : x < 4.95 ? 1 : 2));
  const across = new Set(shapes.lines.map(([x]) => Math.round(100 * x)));
  assert.deepEqual([...across].sort(), [470, 495]);
});

test("where there is no motion is a class of its own, and lines reach the ends of the map", async () => {
  const shapes = await found([8, 8], (x, y) => (x + 0.01 * y < 3.2 ? Number.NaN : 5));
  assert.deepEqual([...shapes.areas.keys()].sort(), [-1, 5]);
  const heights = shapes.lines.map(([, y]) => y);
  assert.ok(Math.min(...heights) < 0.01 && Math.max(...heights) > 7.99);
});

test("classes as fine as the cells, and a single class, have no lines", async () => {
  assert.equal(await found([16, 16], (x, y) => Math.floor(7919 * Math.abs(Math.sin(12.9 * x + 78.2 * y))) % 5), null);
  assert.deepEqual(await found([16, 16], () => 3), { areas: new Map(), lines: [] });
});
