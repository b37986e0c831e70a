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

test("between samples a film follows a cubic, and none of its points is beyond an event", () => {
  const turned = (t: number) => (t < 2 ? Math.sin(3 * t) : Math.cos(3 * t));
  const found = film(300, turned);
  const event = found.index(2);
  found.t[event] = 2; // on both sides of it
  found.columns.vx[event] = Math.sin(6);
  found.t[event + 1] = 2;
  found.columns.vx[event + 1] = Math.cos(6);
  for (const time of [0.01, 1.23, 1.96, 1.99, 2.03, 2.07, 7.77]) {
    const { vx, digits } = found.at(time);
    assert.ok(Math.abs(vx - turned(time)) < 4e-4, `${time}: ${vx} for ${turned(time)}`);
    assert.equal(digits, 2);
  }
});

test("the size of friction is right where its sign changes", () => {
  const found = film(300, () => 1);
  const force = Float64Array.from(found.t, (t) => Math.sin(t));
  Object.assign(found.columns, { friction_force: force, utilization: force.map(Math.abs) });
  const [value] = found.moment(3.16).columns.utilization;
  assert.ok(Math.abs(value - Math.abs(Math.sin(3.16))) < 1e-6, String(value));
});

test("a spike of an instant is not the end of the colours", () => {
  const { extent } = film(5, (t) => (t > 2 && t < 2.01 ? 500 : 1));
  assert.equal(extent.speed, 2);
});
