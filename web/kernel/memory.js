// The module's memory: room for numbers, and views of it that follow when it grows.

export class Memory {
  /** @param {any} exports of the module */
  constructor(exports) {
    this.exports = exports;
    /** @type {Map<string, {place: number, bytes: number}>} */
    this.rooms = new Map();
  }

  /**
   * Room under a name, kept and made larger when more is wanted; its content is then lost.
   * @param {string} name
   * @param {number} bytes
   */
  room(name, bytes) {
    const there = this.rooms.get(name);
    if (there && there.bytes >= bytes) return there.place;
    if (there) this.exports.free(there.place);
    this.rooms.delete(name);
    const place = this.exports.malloc(bytes);
    if (!place) throw new RangeError("There is not enough memory for this motion.");
    this.rooms.set(name, { place, bytes });
    return place;
  }

  /**
   * @param {number} place
   * @param {number} count
   */
  floats(place, count) {
    return new Float64Array(this.exports.memory.buffer, place, count);
  }

  /**
   * @param {string} name
   * @param {ArrayLike<number>} values
   */
  put(name, values) {
    const place = this.room(name, 8 * Math.max(values.length, 1));
    this.floats(place, values.length).set(values);
    return place;
  }
}
