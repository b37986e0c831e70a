// How good a guess is.

import assert from "node:assert/strict";
import { test } from "node:test";
import { anglePoints, curvePoints } from "../lab/teach/predict.ts";

test("an angle has all points within a degree and none from 90° on", () => {
  assert.deepEqual(
    [0, 1, 90, 180, 271].map((guess) => anglePoints(guess, 0)),
    [100, 100, 0, 0, 1],
  );
  assert.equal(anglePoints(-350, 370), 100);
});

test("a curve has its points by the mean distance over the range of the true one", () => {
  const truth = [0, 1, 2, 3, 4];
  assert.equal(curvePoints(truth, truth), 100);
  assert.equal(
    curvePoints(
      truth.map((value) => value + 1),
      truth,
    ),
    50,
  );
  assert.equal(curvePoints([9, 9, 9, 9, 9], truth), 0);
  assert.equal(curvePoints([0, 0], [0, 0]), 100);
});
