// Workers that hold the module: one a call at a time, replaced where one is stopped in the middle of a call.

import { Refused } from "../words/texts.ts";

/** An answer that took longer than anything asked for in a page may take. */
export class TooLong extends Refused {}

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

export class WorkerPool {
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
      () => worker.stop(new TooLong({ key: "kernel.stopped", values: { time: this.limit / 1000 } })),
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

  close() {
    for (const worker of this.idle) worker.worker.terminate();
  }
}
