// The fingerprint of a motion: a hash of the bits of its events, as Python's Trajectory.fingerprint.

import { sha256 } from "@noble/hashes/sha2.js"; // crypto.subtle is missing in pages from a disk or a local network
import { EVENT, layout } from "./layout.ts";

const STATE = ["t", "x", "height", "angle", "vx", "vy", "omega", "slip"];
const DIGITS = 16;
const NAN = 0x7ff8000000000000n; // signs and payloads of nans depend on the machine

/** `rows`: of `layout.events`; `count`: of events. */
export function fingerprintOf(rows: Float64Array, count: number) {
  const text = new TextEncoder();
  const hash = sha256.create();
  const numbers = new DataView(new ArrayBuffer(8 * STATE.length));
  const bytes = new Uint8Array(numbers.buffer);
  for (let k = 0; k < count; k++) {
    const first = k * layout.events.length;
    hash.update(text.encode(layout.kinds[rows[first + EVENT.kind]]));
    STATE.forEach((name, place) => {
      const value = rows[first + EVENT[name]];
      if (Number.isNaN(value)) numbers.setBigUint64(8 * place, NAN, true);
      else numbers.setFloat64(8 * place, value + 0, true); // −0 + 0 is 0
    });
    hash.update(bytes);
  }
  const hex = Array.from(hash.digest(), (byte) => byte.toString(16).padStart(2, "0"));
  return hex.join("").slice(0, DIGITS);
}
