// The module in a worker: each message is a call, each answer is sent back under its number.

import { HoopModule } from "./module.ts";

export { HoopModule };

let module: HoopModule | undefined;

function buffersOf(answer: any) {
  const found = new Set<ArrayBuffer>();
  const look = (value: any) => {
    if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
    else if (value && typeof value === "object" && !Array.isArray(value)) Object.values(value).forEach(look);
  };
  look(answer);
  return [...found];
}

function answer({ data: { number, compiled, call, values } }: MessageEvent) {
  try {
    if (compiled) {
      module = new HoopModule(compiled);
      return;
    }
    const found = (module as any)[call](...values);
    self.postMessage({ number, answer: found }, { transfer: buffersOf(found) });
  } catch (error) {
    self.postMessage({ number, error: error.message });
  }
}

// in Node, for tests, there is no `self`
if (typeof self !== "undefined" && typeof window === "undefined") self.addEventListener("message", answer);
