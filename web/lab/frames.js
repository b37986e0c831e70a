// A computed motion: the packed reply of the server, and the state at any time in it.

import { clamp } from "./numbers.js";

const KINDS = { f8: Float64Array, f4: Float32Array, u1: Uint8Array };
export const MODE_LETTERS = "RSKHM";

export function unpack(buffer) {
  const view = buffer instanceof DataView ? buffer : ArrayBuffer.isView(buffer) ? buffer : new DataView(buffer);
  let bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  if (bytes.byteOffset % 8) bytes = bytes.slice(); // typed arrays start at multiples of their size
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const arrays = {};
  for (const { name, type, shape, place } of header.arrays) {
    const count = shape.reduce((product, size) => product * size, 1);
    arrays[name] = new KINDS[type](bytes.buffer, bytes.byteOffset + 4 + length + place, count);
  }
  return { header, arrays };
}

const STEADY = new Set(["x", "angle", "height"]);
const RATES = { x: "vx", angle: "omega", height: "vy" };

export class Film {
  constructor(reply) {
    Object.assign(this, reply.header);
    this.columns = reply.arrays;
    this.t = reply.arrays.t;
    this.length = this.t.length;
    this.radius = this.values["hoop.radius"];
    this.mass = this.values["hoop.mass"];
    this.eccentricity = this.values["hoop.eccentricity"];
    this.slope = this.scenario.plane.slope ?? 0;
    this.gravity = this.scenario.plane.gravity ?? 9.81;
    this.phases = this.findPhases();
    this.extent = this.findExtent();
    this.cache = new Map();
  }

  findPhases() {
    const { mode } = this.columns;
    const phases = [];
    for (let i = 0; i < this.length; i++) {
      const last = phases.at(-1);
      if (last && last.mode === MODE_LETTERS[mode[i]]) last.to = this.t[i];
      else phases.push({ mode: MODE_LETTERS[mode[i]], from: this.t[i], to: this.t[i] });
    }
    for (let i = 0; i + 1 < phases.length; i++) phases[i].to = phases[i + 1].from;
    return phases.filter((phase) => phase.to > phase.from || phases.length === 1);
  }

  findExtent() {
    const { x, height, vx, vy, omega } = this.columns;
    const extent = { left: Infinity, right: -Infinity, top: 0, speed: 0 };
    const speeds = [];
    for (let i = 0; i < this.length; i++) {
      if (Number.isFinite(x[i])) {
        extent.left = Math.min(extent.left, x[i]);
        extent.right = Math.max(extent.right, x[i]);
      }
      if (height[i] > extent.top) extent.top = height[i];
      const speed = Math.hypot(vx[i], vy[i]) + this.radius * Math.abs(omega[i]);
      if (Number.isFinite(speed)) speeds.push(speed);
    }
    // a spike that lasts an instant must not turn the rest of the ring into one colour
    speeds.sort((a, b) => a - b);
    extent.speed = speeds[Math.floor(0.95 * (speeds.length - 1))] || 1;
    return extent;
  }

  // Largest index with t[index] <= time: of two samples at an event, the one after it.
  index(time) {
    let low = 0;
    let high = this.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.t[middle] <= time) low = middle;
      else high = middle;
    }
    return low;
  }

  at(time) {
    const now = clamp(time, 0, this.duration);
    const i = this.index(now);
    const j = Math.min(i + 1, this.length - 1);
    const span = this.t[j] - this.t[i];
    const share = span > 0 ? (now - this.t[i]) / span : 0;
    const pose = { t: now, mode: MODE_LETTERS[this.columns.mode[i]] };
    for (const [name, column] of Object.entries(this.columns)) {
      if (name === "t" || name === "mode") continue;
      const a = column[i];
      const b = column[j];
      if (share === 0 || !Number.isFinite(b)) pose[name] = a;
      else if (STEADY.has(name)) {
        const rate = this.columns[RATES[name]];
        pose[name] = hermite(a, b, rate[i] * span, rate[j] * span, share);
      } else pose[name] = a + (b - a) * share;
    }
    return pose;
  }

  // A derived column, computed once.
  derived(name, make) {
    if (!this.cache.has(name)) this.cache.set(name, make(this.columns, this));
    return this.cache.get(name);
  }
}

// Cubic through both values with both rates: exact to drawing also at a tenth of the speed.
function hermite(a, b, da, db, s) {
  if (!Number.isFinite(da) || !Number.isFinite(db)) return a + (b - a) * s;
  const r = 1 - s;
  return r * r * (1 + 2 * s) * a + s * s * (3 - 2 * s) * b + s * r * (r * da - s * db);
}
