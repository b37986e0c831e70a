// The kernel of a page without a server: the module in workers, and in the page itself what checking a scenario needs.

import { Crew } from "./crew.js";
import { layout } from "./layout.js";
import { HoopModule } from "./module.js";

const LIMIT = 10_000; // milliseconds
const UNLOADED =
  "The part of the page that computes this could not be loaded; choose it again when there is a network.";
const BLOCK = 256; // cells of a map that a worker gets at a time

/**
 * @param {string} script
 * @returns {() => Worker}
 */
function ofText(script) {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  return () => new Worker(address, { type: "module" });
}

/**
 * @param {URL} address
 * @returns {Promise<WebAssembly.Module>}
 */
async function fetched(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`The kernel is not there: ${address.pathname} gives ${response.status}.`);
  const typed = response.headers.get("Content-Type") === "application/wasm";
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/**
 * @param {ArrayBufferView<ArrayBuffer>} packed
 * @returns {Promise<WebAssembly.Module>}
 */
async function unpacked(packed) {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

/** @implements {Kernel} */
export class WorkerKernel {
  /**
   * @param {WebAssembly.Module} compiled
   * @param {() => Worker} start
   * @param {() => Promise<WebAssembly.Module>} derivatives fetches their module
   */
  constructor(compiled, start, derivatives) {
    this.start = start;
    this.derivatives = derivatives;
    /** @type {Promise<Crew> | null} */
    this.rates = null;
    this.mechanics = new HoopModule(compiled);
    this.motions = new Crew(start, compiled, 2, LIMIT);
    const cores = navigator.hardwareConcurrency || 2;
    this.maps = new Crew(start, compiled, Math.max(1, Math.min(cores - 1, 8)), LIMIT);
  }

  /**
   * From the files beside the page.
   * @param {URL | string} base folder of kernel.js and hophoop.wasm
   */
  static async load(base) {
    const compiled = await fetched(new URL(`hophoop.wasm?${layout.module}`, base));
    const derivatives = () => fetched(new URL(`hophoop-derivatives.wasm?${layout.derivatives}`, base));
    const script = new URL(`kernel.js?${layout.module}`, base);
    if (script.origin === globalThis.location?.origin) {
      return new WorkerKernel(compiled, () => new Worker(script, { type: "module" }), derivatives);
    }
    // a page elsewhere embeds this one: a worker's script must be its own
    return new WorkerKernel(compiled, ofText(await (await fetch(script)).text()), derivatives);
  }

  /**
   * From what travels with a notebook.
   * @param {ArrayBufferView<ArrayBuffer>} packed the module, compressed by gzip
   * @param {string} script of the worker
   * @param {() => Promise<ArrayBufferView<ArrayBuffer>>} derivatives asks for their module, compressed as well
   */
  static async unpack(packed, script, derivatives) {
    return new WorkerKernel(await unpacked(packed), ofText(script), async () => unpacked(await derivatives()));
  }

  /**
   * @param {Given} given
   * @param {AbortSignal} [signal]
   */
  motion(given, signal) {
    return this.motions.ask("motion", [given], signal);
  }

  /**
   * @param {Given} given
   * @param {AbortSignal} [signal]
   */
  film(given, signal) {
    return this.motions.ask("film", [given], signal);
  }

  /**
   * @param {Given} given
   * @param {AbortSignal} [signal]
   * @param {[number, number]} [window] times from and to; the whole motion by default
   */
  columns(given, signal, window) {
    return this.motions.ask("columns", [given, window], signal);
  }

  /**
   * @param {Given} given
   * @param {Float64Array} times
   * @param {AbortSignal} [signal]
   */
  samples(given, times, signal) {
    return this.motions.ask("samples", [given, times], signal);
  }

  /**
   * Its module is fetched when it is first asked for, and again where that failed.
   * @param {Given} given
   * @param {Float64Array} rates
   * @param {AbortSignal} [signal]
   * @returns {Promise<MotionChanges>}
   */
  async changes(given, rates, signal) {
    this.rates ??= this.derivatives().then((compiled) => new Crew(this.start, compiled, 1, LIMIT));
    const crew = await this.rates.catch(() => {
      this.rates = null;
      throw new Error(UNLOADED);
    });
    return crew.ask("changes", [given, rates], signal);
  }

  /**
   * @param {Given} given
   * @param {AbortSignal} [signal]
   */
  thresholds(given, signal) {
    return this.motions.ask("thresholds", [given], signal);
  }

  /**
   * @param {Given} given
   * @param {[number, number, number, number]} window
   * @param {number} columns
   * @param {number} rows
   * @param {AbortSignal} [signal]
   */
  regions(given, window, columns, rows, signal) {
    return this.motions.ask("regions", [given, window, columns, rows], signal);
  }

  /**
   * @param {MapCells} cells
   * @param {string} what
   * @param {string} span
   * @param {AbortSignal} [signal]
   * @returns {Promise<MapValues>}
   */
  async map({ count, rows }, what, span, signal) {
    const fields = layout.cell.length;
    const values = new Float64Array(count).fill(Number.NaN);
    /** @type {string[]} */
    const sequences = [];
    const block = async (/** @type {number} */ first) => {
      const size = Math.min(BLOCK, count - first);
      const part = new Float64Array(fields * size);
      for (let field = 0; field < fields; field++) {
        part.set(rows.subarray(field * count + first, field * count + first + size), field * size);
      }
      const found = await this.maps.ask("map", [{ count: size, rows: part }, what, span], signal, [part.buffer]);
      const codes = found.sequences?.map((/** @type {string} */ word) => {
        if (!sequences.includes(word)) sequences.push(word);
        return sequences.indexOf(word);
      });
      for (let k = 0; k < size; k++)
        values[first + k] = codes ? (codes[found.values[k]] ?? Number.NaN) : found.values[k];
    };
    const firsts = Array.from({ length: Math.ceil(count / BLOCK) }, (_, k) => k * BLOCK);
    await Promise.all(firsts.map(block));
    return what === "sequence" ? { values, sequences } : { values };
  }

  close() {
    this.motions.close();
    this.maps.close();
    this.rates?.then((crew) => crew.close()).catch(() => {});
  }
}
