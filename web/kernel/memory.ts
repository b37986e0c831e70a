// The module's memory: room for numbers, and views of it that follow when it grows.

export class Memory {
  rooms: Map<string, { place: number; bytes: number }> = new Map();

  /** `exports`: of the module. */
  constructor(public exports: any) {}

  /** Room under a name, kept and made larger when more is wanted; its content is then lost. */
  room(name: string, bytes: number) {
    const there = this.rooms.get(name);
    if (there && there.bytes >= bytes) return there.place;
    if (there) this.exports.free(there.place);
    this.rooms.delete(name);
    const place = this.exports.malloc(bytes);
    if (!place) throw new RangeError("kernel.no_memory");
    this.rooms.set(name, { place, bytes });
    return place;
  }

  floats(place: number, count: number) {
    return new Float64Array(this.exports.memory.buffer, place, count);
  }

  put(name: string, values: ArrayLike<number>) {
    const place = this.room(name, 8 * Math.max(values.length, 1));
    this.floats(place, values.length).set(values);
    return place;
  }
}
