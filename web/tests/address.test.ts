// What a link holds behind its #.

import assert from "node:assert/strict";
import { test } from "node:test";
import { readShown, type Shown, shownIn, written } from "../lab/shell/address.ts";

const SHOWN: Shown = {
  time: 1.25,
  zoom: 2,
  pan: [0.125, -0.3],
  from: [0.5, 0.31, 7],
  map: { what: "hop_height", x: ["start.speed", 1, 2.5], y: ["plane.mu", 0, 1] },
  options: { traces: true, forces: false, speed: true, whole: false, three: true },
};

test("a link holds time, view and map", () => {
  const text = written(SHOWN);
  assert.equal(
    text,
    "t=1.25&show=tc3&zoom=2&pan=0.125,-0.3&from=0.5,0.31,7&map=hop_height,start.speed,1,2.5,plane.mu,0,1",
  );
  assert.deepEqual(readShown(`with=x&${text}`), SHOWN);
});

test("a file holds its query behind the #, and opens the links of a folder", () => {
  for (const [query, view, ...addresses] of [
    [
      "start.speed=2",
      "t=1&with=a%3Db",
      "?start.speed=2#t=1&with=a%3Db",
      "?a=1#t=1&with=a%3Db?start.speed=2",
      "#?start.speed=2#t=1&with=a%3Db",
    ],
    ["", "t=1", "#t=1", "##t=1", "?a=1##t=1", "?a=1#t=1?"],
    ["duration=2", "", "?duration=2", "#?duration=2"],
  ]) {
    for (const address of addresses) assert.deepEqual(shownIn(new URL(address, "file:///")), { query, view }, address);
  }
});

test("wrong parts of a link are left out", () => {
  assert.deepEqual(readShown("t=-3&zoom=x&pan=1&from=1,a,2&map=a,b,1,0,c,0,1"), {});
  assert.deepEqual(readShown("zoom=1000&pan=99,-99"), { zoom: 60, pan: [20, -20] });
});
