// The kernel of a page without a server: the module in workers, and in the page itself what checking a scenario needs.

import { Refused } from "../words/texts.ts";
import { unpacked, type Packed } from "./packed.ts";
import { layout } from "./layout.ts";
import { HoopModule } from "./module.ts";

const LIMIT = 10_000; // milliseconds
const BLOCK = 256; // cells of a map that a worker gets at a time

/** Starts workers; the first one at once, so that its scripts load while the module does. */
function startOf(address: string | URL, type: WorkerType) {
  const start = () => new Worker(address, { type });
  let first: Worker | null = start();
  first.onerror = () => {
    first = null; // the next one reports what is wrong
  };
  return () => {
    const worker = first ?? start();
    first = null;
    return worker;
  };
}

/** A worker's script must be of the page itself; what it imports may be from elsewhere. */
function importing({ href }: URL) {
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(href)};`], { type: "text/javascript" }));
}

async function fetched(address: URL) {
  const response = await fetch(address);
  if (!response.ok) throw new Refused({ key: "kernel.not_loaded", values: { status: response.status } });
  const typed = response.headers.get("Content-Type") === "application/wasm";
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

const compiledOf = async (packed: Packed) => WebAssembly.compile(await unpacked(packed).arrayBuffer());

export class WorkerKernel {
  limit = LIMIT;
  fates: Promise<WorkerPool> | null = null;
  mechanics: HoopModule;
  motions: WorkerPool;
  maps: WorkerPool;

  /** `fatesModule`: fetches the module of fates. */
  constructor(
    compiled: WebAssembly.Module,
    readonly start: () => Worker,
    readonly fatesModule: () => Promise<WebAssembly.Module>,
  ) {
    this.mechanics = new HoopModule(compiled);
    this.motions = new WorkerPool(start, compiled, 2, LIMIT);
    const cores = navigator.hardwareConcurrency || 2;
    this.maps = new WorkerPool(start, compiled, Math.max(1, Math.min(cores - 1, 8)), LIMIT);
  }

  /** From the files beside the page. `base`: folder of kernel.js and hophoop.wasm. */
  static async load(base: URL | string) {
    const script = new URL(`kernel.js?${layout.module}`, base);
    const own = script.origin === globalThis.location?.origin;
    const start = startOf(own ? script : importing(script), "module");
    const compiled = await fetched(new URL(`hophoop.wasm?${layout.module}`, base));
    const fates = () => fetched(new URL(`hophoop-fates.wasm?${layout.fates_module}`, base));
    return new WorkerKernel(compiled, start, fates);
  }

  /**
   * From what travels in a notebook or a page. `packed`: the module; `script`: address of the worker's, which is no
   * module; `fates`: asks for the module of fates.
   */
  static async unpack(packed: Packed, script: string, fates: () => Promise<Packed>) {
    const start = startOf(script, "classic");
    return new WorkerKernel(await compiledOf(packed), start, async () => compiledOf(await fates()));
  }

  /** `signal`: stops what is no longer wanted. */
  async ask<Call extends keyof Calls>(
    call: Call,
    values: Parameters<Calls[Call]>,
    signal?: AbortSignal,
  ): Promise<ReturnType<Calls[Call]>> {
    if (call === "map") return (await this.map(...(values as Parameters<Calls["map"]>), signal)) as any;
    const pool = call === "fate" ? await this.apart() : this.motions;
    return pool.ask(call, values, signal);
  }

  /** The module of fates is fetched when it is first asked for, and again where that failed. */
  apart() {
    this.fates ??= this.fatesModule().then((compiled) => new WorkerPool(this.start, compiled, 1, LIMIT));
    return this.fates.catch(() => {
      this.fates = null;
      throw new Error("kernel.fates_not_loaded");
    });
  }

  async map({ count, rows }: MapCells, what: string, span: string, signal?: AbortSignal) {
    signal?.throwIfAborted();
    const fields = layout.cell.length;
    const values = new Float64Array(count).fill(Number.NaN);
    const sequences: string[] = [];
    // a block that takes too long ends the others
    const all = new AbortController();
    signal?.addEventListener("abort", () => all.abort());
    const block = async (first: number) => {
      const size = Math.min(BLOCK, count - first);
      const part = new Float64Array(fields * size);
      for (let field = 0; field < fields; field++) {
        part.set(rows.subarray(field * count + first, field * count + first + size), field * size);
      }
      const found = await this.maps.ask("map", [{ count: size, rows: part }, what, span], all.signal, [part.buffer]);
      const codes = found.sequences?.map((word: string) => {
        if (!sequences.includes(word)) sequences.push(word);
        return sequences.indexOf(word);
      });
      for (let k = 0; k < size; k++)
        values[first + k] = codes ? (codes[found.values[k]] ?? Number.NaN) : found.values[k];
    };
    const firsts = Array.from({ length: Math.ceil(count / BLOCK) }, (_, k) => k * BLOCK);
    await Promise.all(firsts.map(block)).catch((error) => {
      all.abort();
      throw error;
    });
    return what === "sequence" ? { values, sequences } : { values };
  }
}

// --- Workers that hold the module: one a call at a time, replaced where one is stopped in the middle of a call

class PoolWorker {
  number = 0;
  waiting: { resolve: (value: any) => void; reject: (error: Error) => void } | null = null;
  worker = this.begun();

  constructor(
    readonly start: () => Worker,
    readonly compiled: WebAssembly.Module,
  ) {}

  begun() {
    const worker = this.start();
    worker.onmessage = ({ data }) => {
      if (data.number !== this.number || !this.waiting) return;
      const { resolve, reject } = this.waiting;
      this.waiting = null;
      if (data.error) reject(new Error(data.error));
      else resolve(data.answer);
    };
    worker.onerror = (event) => this.fail(new Error(event.message || "kernel.not_started"));
    worker.postMessage({ compiled: this.compiled });
    return worker;
  }

  fail(error: Error) {
    this.waiting?.reject(error);
    this.waiting = null;
  }

  // What is computed now is given up at once, whatever it is.
  stop(error: Error) {
    this.worker.terminate();
    this.worker = this.begun();
    this.fail(error);
  }

  ask(call: string, values: any[], moved: Transferable[]) {
    this.number++;
    const asked = new Promise<any>((resolve, reject) => {
      this.waiting = { resolve, reject };
    });
    this.worker.postMessage({ number: this.number, call, values }, moved);
    return asked;
  }
}

class WorkerPool {
  idle: PoolWorker[] = [];
  started = 0;
  queue: ((worker: PoolWorker) => void)[] = [];

  /** `limit`: milliseconds that a call may take. */
  constructor(
    readonly start: () => Worker,
    readonly compiled: WebAssembly.Module,
    readonly size: number,
    readonly limit: number,
  ) {}

  free(): Promise<PoolWorker> {
    const there = this.idle.pop();
    if (there) return Promise.resolve(there);
    if (this.started < this.size) {
      this.started++;
      return Promise.resolve(new PoolWorker(this.start, this.compiled));
    }
    return new Promise((resolve) => this.queue.push(resolve));
  }

  release(worker: PoolWorker) {
    const next = this.queue.shift();
    if (next) next(worker);
    else this.idle.push(worker);
  }

  /** `moved`: buffers that the worker gets and the page gives away. */
  async ask(call: string, values: any[], signal?: AbortSignal, moved: Transferable[] = []) {
    signal?.throwIfAborted();
    const worker = await this.free();
    const stop = () => worker.stop(new DOMException("superseded", "AbortError"));
    const timer = setTimeout(
      () => worker.stop(new Refused({ key: "kernel.stopped", values: { time: this.limit / 1000 } })),
      this.limit,
    );
    try {
      signal?.throwIfAborted();
      signal?.addEventListener("abort", stop);
      return await worker.ask(call, values, moved);
    } finally {
      clearTimeout(timer);
      signal?.removeEventListener("abort", stop);
      this.release(worker);
    }
  }
}
