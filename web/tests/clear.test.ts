// The place of a hint on the picture.

import assert from "node:assert/strict";
import { test } from "node:test";
import { clearPlace } from "../lab/player/grips.ts";

const INSIDE = { left: 0, right: 390, top: 0, bottom: 200 };
const SIZE = { width: 100, height: 26 };
const NUMBERS = { left: 10, right: 160, top: 2, bottom: 114 };
const LEGEND = { left: 210, right: 384, top: 0, bottom: 30 };

test("a hint is where it is wanted, if that is free", () => {
  assert.deepEqual(clearPlace([220, 80], SIZE, INSIDE, [NUMBERS, LEGEND]), [220, 80]);
});

test("it goes to the nearest place beside what is there", () => {
  assert.deepEqual(clearPlace([200, 80], SIZE, INSIDE, [NUMBERS, LEGEND]), [214, 80]);
  assert.deepEqual(clearPlace([80, 100], SIZE, INSIDE, [NUMBERS, LEGEND]), [80, 131]);
  assert.deepEqual(clearPlace([300, 20], SIZE, INSIDE, [NUMBERS, LEGEND]), [300, 47]);
});
