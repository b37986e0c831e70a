// What a whole motion says of itself.

import assert from "node:assert/strict";
import { test } from "node:test";
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
