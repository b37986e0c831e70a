// The kernel as WebAssembly, called at once and without waiting: in a worker, or where one motion is wanted now.

import { sha256 } from "@noble/hashes/sha2.js"; // crypto.subtle is missing in pages from a disk or a local network
import { cellOf, contactOf, EVENT, HEAD, layout, named, NUMBER, WORD } from "./layout.ts";
import { columnsOf, joined } from "./columns.ts";
import { hex } from "../model/text.ts";

const FIRST_EVENTS = 256;
const FIRST_SEGMENTS = 2048;
const FIRST_ROWS = 4096;
const ROWS = 256; // per second of a compliant motion, as most need: too few make it run twice
const MOST_STEPS = 200_000; // of a compliant motion: some seconds, and 100 MB
const BUFFER = layout.statuses.indexOf("buffer");
const KEPT = 2; // motions whose states can be asked for by turns
const PASSING = new Set(layout.passing);
const finite = (value: number) => (Number.isFinite(value) ? value : null);

/** What is left in memory of the motion that was computed last. */
export type Computed = ReturnType<HoopModule["compute"]>;

export class HoopModule {
  kept: { pieces: Uint8Array; place: number }[] = [];
  turn = 0;
  exports: any;
  memory: Memory;
  mostEvents = FIRST_EVENTS;
  mostSegments = FIRST_SEGMENTS;
  mostRows = FIRST_ROWS;

  constructor(compiled: WebAssembly.Module) {
    this.exports = new WebAssembly.Instance(compiled, {}).exports as any;
    this.exports._initialize?.();
    this.memory = new Memory(this.exports);
  }

  call(name: string, ...values: number[]) {
    const failed = this.exports[name](...values);
    if (failed) throw new Error(`The kernel ended ${name} with ${failed}.`);
  }

  /** Numbers that an entry writes where its last argument says. */
  answer(name: string, count: number, ...values: number[]) {
    const out = this.memory.room("answers", 8 * count);
    this.call(name, ...values, out);
    return [...this.memory.floats(out, count)];
  }

  cell(given: Given) {
    return this.memory.put("cell", cellOf(given));
  }

  contact({ contact }: Given) {
    return this.memory.put("contact", contactOf(contact));
  }

  // --- motions --------------------------------------------------------------------------------

  /** Computes a motion; its events stay in memory for what follows. */
  compute(given: Given) {
    const { memory } = this;
    const width = layout.events.length;
    for (;;) {
      const table = memory.room("table", 8 * width * this.mostEvents);
      const heads = memory.room("heads", 8 * layout.heads.length);
      const events = memory.room("events", layout.event_bytes * this.mostEvents);
      if (given.contact) this.computeCompliant(given, events, table, heads);
      else {
        const segments = memory.room("segments", layout.segment_bytes * this.mostSegments);
        this.call("motion", this.cell(given), events, this.mostEvents, segments, this.mostSegments, table, heads);
      }
      const head = memory.floats(heads, layout.heads.length).slice();
      const count = head[HEAD.events];
      const more = count === this.mostEvents && count < given.max_events;
      if (more) this.mostEvents *= 4;
      if (head[HEAD.status] === BUFFER && given.contact) this.mostRows = head[HEAD.segments];
      else if (head[HEAD.status] === BUFFER) this.mostSegments *= 4;
      else if (!more) {
        const rows = memory.floats(table, count * width).slice();
        return { given, head, rows, count, duration: head[HEAD.duration], segments: head[HEAD.segments] };
      }
    }
  }

  computeCompliant(given: Given, events: number, table: number, heads: number) {
    const guess = Math.min(FIRST_ROWS + ROWS * given.duration, MOST_STEPS);
    this.mostRows = Math.max(this.mostRows, Math.ceil(guess));
    const rows = this.memory.room("rows", layout.compliant_segment_bytes * this.mostRows);
    const asked = [this.cell(given), this.contact(given), events, this.mostEvents, MOST_STEPS];
    this.call("compliant_motion", ...asked, rows, this.mostRows, table, heads);
  }

  motion(given: Given): ComputedMotion {
    return motionOf(this.compute(given));
  }

  /** A film's header and columns at once, and the pieces of which `instant` makes the state at any time. */
  film(given: Given) {
    const computed = this.compute(given);
    const [name, bytes] = given.contact ? ["rows", layout.compliant_segment_bytes] : ["segments", layout.segment_bytes];
    const place = this.memory.room(name, 8);
    const pieces = new Uint8Array(this.exports.memory.buffer, place, bytes * computed.segments).slice();
    return { motion: motionOf(computed), columns: columnsOf(this, computed), pieces };
  }

  /** A film's columns at one time, of a motion that was computed elsewhere. `pieces`: of the motion. */
  instant(given: Given, pieces: Uint8Array, time: number) {
    const segments = pieces.length / (given.contact ? layout.compliant_segment_bytes : layout.segment_bytes);
    this.cell(given);
    this.contact(given);
    const times = Float64Array.of(time);
    const states = this.states({ given, segments }, times, false, this.placeOf(pieces));
    const none = new Float64Array(0);
    return joined(times, states, none, none);
  }

  /** Where the pieces of a motion are in memory: they are copied once, not at every picture. */
  placeOf(pieces: Uint8Array) {
    const there = this.kept.find((one) => one.pieces === pieces);
    if (there) return there.place;
    const { turn } = this;
    this.turn = (turn + 1) % KEPT;
    const place = this.memory.room(`pieces ${turn}`, Math.max(pieces.length, 1));
    new Uint8Array(this.exports.memory.buffer, place, pieces.length).set(pieces);
    this.kept[turn] = { pieces, place };
    return place;
  }

  /** `window`: times from and to; the whole motion by default. */
  columns(given: Given, window?: [number, number]) {
    return columnsOf(this, this.compute(given), window);
  }

  samples(given: Given, times: Float64Array): Samples {
    const rows = this.states(this.compute(given), times, false);
    const width = layout.samples.length;
    return named(layout.samples, (place) => Float64Array.from(times, (_, k) => rows[k * width + place]));
  }

  /**
   * Rows of `layout.samples` of the motion that was computed last. `left`: just before an event; `place`: of its
   * pieces, where they are others than those computed last.
   */
  states(
    { given, segments }: Pick<Computed, "given" | "segments">,
    times: Float64Array,
    left: boolean,
    place?: number,
  ) {
    const { memory } = this;
    const size = times.length * layout.samples.length;
    const when = memory.put("times", times);
    const out = memory.room("states", 8 * Math.max(size, 1));
    const cell = memory.room("cell", 8);
    const ask = [segments, when, times.length, Number(left), out];
    if (given.contact) {
      this.call("compliant_samples", cell, memory.room("contact", 8), place ?? memory.room("rows", 8), ...ask);
    } else this.call("samples", cell, place ?? memory.room("segments", 8), ...ask);
    return memory.floats(out, size).slice();
  }

  // --- fates: an entry of the module of their own -------------------------------------------------

  /** What becomes of a rigid motion in the end, after at most so many passages of the bottom. */
  fate(given: Given, most: number): Fate {
    const values = this.answer("fate", layout.fate.length, this.cell(given), most);
    const found = named(layout.fate, (k) => values[k]);
    return { ...found, fate: layout.fates[found.fate] } as Fate;
  }

  // --- theory ---------------------------------------------------------------------------------

  thresholds(given: Given): TheoryNumbers {
    const speed = given.rolling && given.angle === 0 ? given.vx : Number.NaN;
    const values = this.answer("thresholds", layout.thresholds.length, this.cell(given), speed);
    const found = named(layout.thresholds, (k) => (Number.isNaN(values[k]) ? null : values[k]));
    const jams = ["jam_angle", "jam_angle_2", "jam_angle_3", "jam_angle_4"].map((name) => found[name]);
    return {
      ...(found as Record<ThresholdName, number | null>),
      jam_angles: jams.filter((angle) => angle !== null),
      massless_loss_by_friction: found.massless_loss_by_friction === 1,
    };
  }

  regions(given: Given, [left, right, bottom, top]: [number, number, number, number], columns: number, rows: number) {
    const { memory } = this;
    const modes = memory.room("modes", columns * rows);
    const sides = memory.room("sides", 2 * columns);
    this.call("regions", this.cell(given), left, right, bottom, top, columns, rows, modes, sides);
    const { buffer } = this.exports.memory;
    return {
      modes: new Uint8Array(buffer, modes, columns * rows).slice(),
      paradox: Float32Array.from(new Int8Array(buffer, sides, 2 * columns)),
    };
  }

  map({ count, rows }: MapCells, what: string, span: string): MapValues {
    const { memory } = this;
    const place = memory.put("cells", rows);
    const numbers = memory.room("numbers", 8 * count * layout.numbers.length);
    const words = memory.room("words", 4 * count * layout.words.length);
    const keys = memory.room("keys", 8 * count * layout.keys);
    const { angle, stop, timed } = (layout.spans as Named)[span];
    const wanted = (layout.wanted as Named<number>)[what];
    this.call("map_cells", place, count, angle ?? Number.NaN, stop, timed, wanted, numbers, words, keys);
    const { buffer } = this.exports.memory;
    if (what === "sequence") return sequencesOf(new BigUint64Array(buffer, keys, count * layout.keys), count);
    const column = (table: Float64Array | Int32Array, place: number) =>
      Float64Array.from({ length: count }, (_, k) => table[(k * table.length) / count + place]);
    if (what in WORD) return { values: column(new Int32Array(buffer, words, count * layout.words.length), WORD[what]) };
    return { values: column(memory.floats(numbers, count * layout.numbers.length), NUMBER[what]) };
  }

  // --- mechanics that checking a scenario needs -------------------------------------------------

  /** κ of a thin ring with a point load, as Python's `Hoop` has it. */
  ideal(loadFraction: number) {
    return this.answer("ideal_hoop", 1, loadFraction)[0];
  }

  /**
   * The first rule that a scenario breaks. Returns its place in the table of rules, 0 for none, and what its sentence
   * needs.
   */
  refused(given: Given) {
    const asked = [this.cell(given), this.contact(given), Number(!given.contact)];
    return this.answer("refused", 2, ...asked) as [number, number];
  }

  /** A hoop of parts, as Python's `combine`, and how far each part reaches from the centre [m]. */
  combine(radius: number, parts: Part[]) {
    const { memory } = this;
    const rows = memory.put("parts", parts.flatMap(rowOf));
    const out = memory.room("hoop", 8 * 3);
    const reaches = memory.room("reaches", 8 * parts.length);
    this.call("hoop_of_parts", radius, rows, parts.length, out, reaches);
    const [mass, eccentricity, inertia_ratio] = memory.floats(out, 3);
    return { mass, eccentricity, inertia_ratio, reaches: [...memory.floats(reaches, parts.length)] };
  }

  /** What a compliant contact chooses by itself, in SI units. */
  chosen(given: Given) {
    const values = this.answer("compliance", layout.chosen.length, this.cell(given), this.contact(given));
    return named(layout.chosen, (k) => values[k]);
  }
}

function rowOf(part: Part) {
  const kind = part.shape === "rod" ? `${part.direction}_rod` : part.shape;
  const shape = layout.shapes.indexOf(kind);
  if (part.shape === "ring") return [shape, part.mass, part.inner_radius, part.outer_radius, 0];
  if (part.shape === "disk") return [shape, part.mass, part.radius, 0, part.at];
  if (part.shape === "rod") return [shape, part.mass, part.length, 0, part.at];
  return [shape, part.mass, 0, 0, part.at];
}

// --- a motion as Python's to_dict has it -----------------------------------------------------------------------

const LOSSES = ["friction", "impact_normal", "impact_tangential", "rolling_resistance"];
const ENERGIES = ["kinetic", "potential", ...LOSSES, "residual"];
const STATE = ["x", "height", "angle", "vx", "vy", "omega"] as const;
// the words of the format by their codes; layout.json has them from the same tables as the types
const KINDS = layout.kinds as EventKind[];
const LETTERS = [...layout.letters] as ModeLetter[];
const STATUSES = layout.statuses as MotionStatus[];

/** As Trajectory.to_dict has it. */
function motionOf({ given, head, rows, count, duration }: Computed): ComputedMotion {
  const width = layout.events.length;
  const events = Array.from({ length: count }, (_, k) => eventOf(rows.subarray(k * width, (k + 1) * width)));
  const last = events[count - 1];
  const energy = Object.fromEntries(
    [...ENERGIES, ...(given.contact ? ["spring", "damping"] : [])].map((name) => [name, head[HEAD[name]]]),
  );
  return {
    status: STATUSES[head[HEAD.status]],
    sequence: sequenceOf(events),
    fingerprint: fingerprintOf(rows, count),
    duration,
    events,
    final: { t: last.t, mode: last.to, ...stateOf((name) => last[name]) },
    energy,
    doubt: finite(head[HEAD.doubt]),
  };
}

type State = Pick<MotionEvent, (typeof STATE)[number]>;

const stateOf = (at: (name: keyof State) => number) =>
  Object.fromEntries(STATE.map((name) => [name, at(name)])) as State;

function eventOf(row: Float64Array): MotionEvent {
  const kind = KINDS[row[EVENT.kind]];
  const from = row[EVENT.from_mode];
  const before = (name: keyof MotionEvent["before"]) => finite(row[EVENT[`before_${name}`]]);
  const event: MotionEvent = {
    t: row[EVENT.t],
    kind,
    from: from < 0 ? null : LETTERS[from],
    to: LETTERS[row[EVENT.to_mode]],
    ...stateOf((name) => row[EVENT[name]]),
    before: { vx: before("vx"), vy: before("vy"), omega: before("omega") },
    impulse: { normal: row[EVENT.impulse_normal], tangential: row[EVENT.impulse_tangential] },
  };
  if (row[EVENT.collision] === 0) event.collision = false;
  if (kind === "kane_gain") event.gain = row[EVENT.gain];
  if (row[EVENT.stable] >= 0) event.stable = row[EVENT.stable] === 1;
  return event;
}

function sequenceOf(events: MotionEvent[]) {
  const marks = events.filter((event, k) => k === events.length - 1 || !PASSING.has(event.kind));
  const letters = marks.slice(0, -1).map((event, k) => (marks[k + 1].t > event.t ? event.to : ""));
  return letters.join("") || (events.at(-1)?.to ?? "");
}

// --- The module's memory: room for numbers, and views of it that follow when it grows

class Memory {
  rooms = new Map<string, { place: number; bytes: number }>();

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

// --- Sequences of modes, unpacked from the numbers into which the kernel packs them

function sequencesOf(keys: BigUint64Array, count: number): MapValues {
  const words = Array.from({ length: count }, (_, k) =>
    unpacked(keys.subarray(k * layout.keys, (k + 1) * layout.keys)),
  );
  const sequences = [...new Set(words)].filter(Boolean);
  // without a word it is not allowed
  return { values: Float64Array.from(words, (word) => (word ? sequences.indexOf(word) : Number.NaN)), sequences };
}

function unpacked(keys: BigUint64Array) {
  let word = "";
  for (const key of keys) {
    let rest = key;
    for (let place = 0; place < layout.letters_a_key && rest; place++) {
      const letter = Number(rest & 7n);
      rest >>= 3n;
      if (letter) word += letter === layout.more ? "+" : layout.letters[letter - 1];
    }
  }
  return word;
}

// --- The fingerprint of a motion: a hash of the bits of its events, as Python's Trajectory.fingerprint

const HASHED = ["t", "x", "height", "angle", "vx", "vy", "omega", "slip"];
const DIGITS = 16;
const NAN = 0x7ff8000000000000n; // signs and payloads of nans depend on the machine

/** `rows`: of `layout.events`; `count`: of events. */
export function fingerprintOf(rows: Float64Array, count: number) {
  const text = new TextEncoder();
  const hash = sha256.create();
  const numbers = new DataView(new ArrayBuffer(8 * HASHED.length));
  const bytes = new Uint8Array(numbers.buffer);
  for (let k = 0; k < count; k++) {
    const first = k * layout.events.length;
    hash.update(text.encode(layout.kinds[rows[first + EVENT.kind]]));
    HASHED.forEach((name, place) => {
      const value = rows[first + EVENT[name]];
      if (Number.isNaN(value)) numbers.setBigUint64(8 * place, NAN, true);
      else numbers.setFloat64(8 * place, value + 0, true); // −0 + 0 is 0
    });
    hash.update(bytes);
  }
  return hex(hash.digest()).slice(0, DIGITS);
}
