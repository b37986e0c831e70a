// The module in a worker: each message is a call, each answer is sent back under its number.

import { HoopModule } from "./module.js";

export { HoopModule };

/** @type {HoopModule | undefined} */
let module;

/** @param {any} answer */
function buffersOf(answer) {
  /** @type {Set<ArrayBuffer>} */
  const found = new Set();
  const look = (/** @type {any} */ value) => {
    if (ArrayBuffer.isView(value)) found.add(/** @type {ArrayBuffer} */ (value.buffer));
    else if (value && typeof value === "object" && !Array.isArray(value)) Object.values(value).forEach(look);
  };
  look(answer);
  return [...found];
}

/** @param {MessageEvent} event */
function answer({ data: { number, compiled, call, values } }) {
  try {
    if (compiled) {
      module = new HoopModule(compiled);
      return;
    }
    const found = /** @type {any} */ (module)[call](...values);
    self.postMessage({ number, answer: found }, { transfer: buffersOf(found) });
  } catch (error) {
    self.postMessage({ number, error: /** @type {Error} */ (error).message });
  }
}

// in Node, for tests, there is no `self`
if (typeof self !== "undefined" && typeof window === "undefined") self.addEventListener("message", answer);
