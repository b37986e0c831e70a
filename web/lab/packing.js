// JSON and arrays in one block of bytes, as Python packs them.

/** @type {Record<string, any>} */
const KINDS = { f8: Float64Array, f4: Float32Array, u1: Uint8Array };

/** @param {ArrayBuffer | ArrayBufferView} buffer */
export function unpack(buffer) {
  const view = buffer instanceof DataView ? buffer : ArrayBuffer.isView(buffer) ? buffer : new DataView(buffer);
  let bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  if (bytes.byteOffset % 8) bytes = bytes.slice(); // typed arrays start at multiples of their size
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  /** @type {Record<string, Column>} */
  const arrays = {};
  for (const { name, type, shape, place } of header.arrays) {
    const count = shape.reduce((/** @type {number} */ product, /** @type {number} */ size) => product * size, 1);
    arrays[name] = new KINDS[type](bytes.buffer, bytes.byteOffset + 4 + length + place, count);
  }
  return { header, arrays };
}
