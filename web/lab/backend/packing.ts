// JSON and arrays in one block of bytes, as Python packs them.

const KINDS: Record<string, any> = { f8: Float64Array, f4: Float32Array, u1: Uint8Array };

export function unpack(buffer: ArrayBuffer | ArrayBufferView) {
  const view = buffer instanceof DataView ? buffer : ArrayBuffer.isView(buffer) ? buffer : new DataView(buffer);
  let bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  if (bytes.byteOffset % 8) bytes = bytes.slice(); // typed arrays start at multiples of their size
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const arrays: Record<string, Column> = {};
  for (const { name, type, shape, place } of header.arrays) {
    const count = shape.reduce((product: number, size: number) => product * size, 1);
    arrays[name] = new KINDS[type](bytes.buffer, bytes.byteOffset + 4 + length + place, count);
  }
  return { header, arrays };
}
