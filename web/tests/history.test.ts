// Steps back and forth.

import assert from "node:assert/strict";
import { test } from "node:test";
import { History } from "../lab/shell/history.ts";

test("keys in a row are one step also if answers are slow", () => {
  // each key within a second after the one before, the motion of the last of them four seconds after the first
  const history = new History();
  history.note(["a"]);
  assert.equal(history.note(["b"], "start.speed", 100), "step");
  for (let when = 900; when <= 4500; when += 900) history.touch("start.speed", when);
  assert.equal(history.note(["c"], "start.speed", 4500), "again");
  for (const when of [4600, 5700]) history.touch("start.speed", when);
  assert.equal(history.note(["d"], "start.speed", 5700), "step");
});

test("a step is kept until it is shown", () => {
  const history = new History();
  for (const query of "abc") history.note([query]);
  assert.deepEqual(history.next(-1), ["b"]);
  assert.deepEqual([history.past, history.now], [[["a"], ["b"]], ["c"]]);
  history.step(-1);
  history.arrive(["c"]);
  assert.deepEqual([history.past, history.now, history.future], [[["a"], ["b"]], ["c"], []]);
  history.arrive(["a"]);
  assert.deepEqual([history.past, history.now, history.future], [[], ["a"], [["c"], ["b"]]]);
  history.arrive(["elsewhere"]);
  assert.deepEqual([history.past, history.now, history.future], [[], ["elsewhere"], []]);
});

test("a new step ends the steps that were taken back", () => {
  const history = new History();
  for (const query of "abc") history.note([query]);
  history.step(-1);
  history.note(["d"]);
  assert.equal(history.next(1), null);
  assert.deepEqual(history.next(-1), ["b"]);
  assert.ok(history.holds(["d"]));
});
