// Marks and stretches of the bar of time.

import assert from "node:assert/strict";
import { test } from "node:test";
import { placed, stretches } from "../lab/player/marks.ts";

test("a rare mark is not hidden by a usual one at the same instant", () => {
  const events = [
    { kind: "impact", x: 100 },
    { kind: "kane_gain", x: 100 },
    { kind: "apex", x: 300 },
  ];
  const found = placed(events);
  assert.deepEqual(
    found.map(({ mark }) => mark),
    ["✚", "▼", "•"],
  );
  assert.equal(found[0].x, 100);
  assert.ok(found[1].x - found[0].x >= 8);
});

test("a crowd of marks stays apart", () => {
  const kinds = ["takeoff", "apex", "impact"];
  const events = Array.from({ length: 900 }, (_, k) => ({ kind: kinds[k % 3], x: 0.7 * k }));
  const found = placed([...events, { kind: "jam", x: 333.3 }]);
  assert.ok(found.some(({ mark }) => mark === "✖"));
  assert.ok(found.length > 30);
  for (let k = 1; k < found.length; k++) assert.ok(found[k].x - found[k - 1].x >= 8);
});

test("an unknown kind of event has no mark", () => {
  assert.deepEqual(placed([{ kind: "unknown", x: 1 }]), []);
});

test("stretches shorter than a pixel show the mode that lasts longest", () => {
  // 1,000 hops of 0.9 s with slips of 0.1 s on 100 pixels
  const phases = Array.from({ length: 1000 }, (_, t) => [
    { mode: "H", from: t, to: t + 0.9 },
    { mode: "K", from: t + 0.9, to: t + 1 },
  ]).flat();
  assert.deepEqual(
    stretches(phases, (t) => t / 10, 100),
    [{ mode: "H", from: 0, wide: 100 }],
  );
});

test("long stretches are where they belong", () => {
  const phases = [
    { mode: "R", from: 0, to: 2.55 },
    { mode: "K", from: 2.55, to: 4 },
    { mode: "R", from: 4, to: 10 },
  ];
  const found = stretches(phases, (t) => 10 * t, 100);
  assert.equal(found.map(({ mode }) => mode).join(""), "RKR");
  for (const [k, from] of [0, 25.5, 40].entries()) assert.ok(Math.abs(found[k].from - from) <= 1);
  assert.ok(Math.abs(found.reduce((sum, { wide }) => sum + wide, 0) - 100) < 1e-6);
});
