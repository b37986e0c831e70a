// What a whole motion says of itself, and where it is made finer.

import assert from "node:assert/strict";
import { test } from "node:test";
import { leaves } from "../lab/player/marks.ts";
import { Film } from "../lab/player/film.ts";

const film = (duration: number, speed: (t: number) => number) => {
  const t = Float64Array.from({ length: 6001 }, (_, i) => (i * duration) / 6000);
  const none = new Float64Array(t.length);
  const vx = Float64Array.from(t, speed);
  const columns = { t, x: none, height: none, vx, vy: none, omega: vx, angle: none, mode: new Uint8Array(t.length) };
  const header = {
    duration,
    values: { "hoop.radius": 1 },
    events: [],
    scenario: { plane: { slope: 0 } },
    summary: "",
    story: [],
    query: "",
  };
  return new Film({ header, arrays: columns } as any);
};

test("colours of a hoop that comes to rest after seconds reach to its speed at the start", () => {
  const { extent } = film(600, (t) => Math.max(0, 3 - 0.2 * t));
  assert.ok(extent.speed > 5 && extent.speed <= 6, String(extent.speed));
});

test("a spike of an instant is not the end of the colours", () => {
  const { extent } = film(5, (t) => (t > 2 && t < 2.01 ? 500 : 1));
  assert.equal(extent.speed, 2);
});

test("a long film is made finer where one looks, and a short one is not", () => {
  const whole = film(600, () => 2);
  assert.deepEqual(whole.wanted(300), [298, 306]);
  const t = Float64Array.from({ length: 901 }, (_, i) => 299 + i / 100);
  whole.refine({ t });
  assert.equal(whole.wanted(300), null);
  assert.deepEqual(whole.wanted(307, 4), [305, 317]);
  const [before, part, after] = whole.pieces();
  assert.deepEqual([before.film === whole, part.film === whole, after.film === whole], [true, false, true]);
  assert.ok(whole.t[before.to - 1] < 299 && 299 <= whole.t[before.to]);
  assert.ok(whole.t[after.from] > 308 && 308 >= whole.t[after.from - 1]);
  assert.equal(film(6, () => 2).wanted(3, 4), null);
});

test("a flight is found also where no take-off begins it", () => {
  const found = (kind: string, from: string | null, to: string) => leaves({ kind, from, to } as MotionEvent);
  assert.ok(found("takeoff", "S", "H") && found("jam", "K", "H") && found("start", null, "H"));
  assert.ok(!found("impact", "K", "H") && !found("apex", "H", "H") && !found("slip_start", "R", "K"));
});
