// The bits of motions, from what the page's kernel leaves in the module's memory: in Node, and as text in a browser.

/** Of each motion its heads, the kernel's records of its events and, where it lasts, states at `count` equal times. */
export async function bits(module, { asked, count, eventBytes }) {
  const parts = [];
  for (const given of asked) {
    const computed = module.compute(given);
    const { place } = module.memory.rooms.get("events");
    const events = new Uint8Array(module.exports.memory.buffer, place, eventBytes * computed.count).slice();
    const rows = computed.duration > 0 ? count : 0;
    const times = Float64Array.from({ length: rows }, (_, k) => (computed.duration * k) / (count - 1));
    const states = times.length ? module.states(computed, times, false) : times;
    for (const numbers of [computed.head, events, states])
      parts.push(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength));
  }
  const bytes = new Uint8Array(await new Blob(parts).arrayBuffer());
  let text = "";
  for (let k = 0; k < bytes.length; k += 0x8000) text += String.fromCharCode(...bytes.subarray(k, k + 0x8000));
  return btoa(text);
}
