// Workers that hold the module: one a call at a time, replaced where one is stopped in the middle of a call.

import { Refused } from "../words/texts.js";

/** An answer that took longer than anything asked for in a page may take. */
export class TooLong extends Refused {}

class Hand {
  /**
   * @param {() => Worker} start
   * @param {WebAssembly.Module} compiled
   */
  constructor(start, compiled) {
    this.start = start;
    this.compiled = compiled;
    this.number = 0;
    /** @type {{resolve: (value: any) => void, reject: (error: Error) => void} | null} */
    this.waiting = null;
    this.worker = this.begun();
  }

  begun() {
    const worker = this.start();
    worker.onmessage = ({ data }) => {
      if (data.number !== this.number || !this.waiting) return;
      const { resolve, reject } = this.waiting;
      this.waiting = null;
      if (data.error) reject(new Error(data.error));
      else resolve(data.answer);
    };
    worker.onerror = (event) => this.fail(new Error(event.message || "The kernel could not be started."));
    worker.postMessage({ compiled: this.compiled });
    return worker;
  }

  /** @param {Error} error */
  fail(error) {
    this.waiting?.reject(error);
    this.waiting = null;
  }

  // What is computed now is given up at once, whatever it is.
  /** @param {Error} error */
  stop(error) {
    this.worker.terminate();
    this.worker = this.begun();
    this.fail(error);
  }

  /**
   * @param {string} call
   * @param {any[]} values
   * @param {Transferable[]} moved
   */
  ask(call, values, moved) {
    this.number++;
    const asked = new Promise((resolve, reject) => {
      this.waiting = { resolve, reject };
    });
    this.worker.postMessage({ number: this.number, call, values }, moved);
    return asked;
  }
}

export class Crew {
  /**
   * @param {() => Worker} start
   * @param {WebAssembly.Module} compiled
   * @param {number} size
   * @param {number} limit milliseconds that a call may take
   */
  constructor(start, compiled, size, limit) {
    this.start = start;
    this.compiled = compiled;
    this.size = size;
    this.limit = limit;
    /** @type {Hand[]} */
    this.idle = [];
    this.hired = 0;
    /** @type {((hand: Hand) => void)[]} */
    this.queue = [];
  }

  /** @returns {Promise<Hand>} */
  hand() {
    const there = this.idle.pop();
    if (there) return Promise.resolve(there);
    if (this.hired < this.size) {
      this.hired++;
      return Promise.resolve(new Hand(this.start, this.compiled));
    }
    return new Promise((resolve) => this.queue.push(resolve));
  }

  /** @param {Hand} hand */
  release(hand) {
    const next = this.queue.shift();
    if (next) next(hand);
    else this.idle.push(hand);
  }

  /**
   * @param {string} call
   * @param {any[]} values
   * @param {AbortSignal} [signal]
   * @param {Transferable[]} [moved] buffers that the worker gets and the page gives away
   */
  async ask(call, values, signal, moved = []) {
    signal?.throwIfAborted();
    const hand = await this.hand();
    const stop = () => hand.stop(new DOMException("superseded", "AbortError"));
    const timer = setTimeout(
      () => hand.stop(new TooLong({ key: "This takes longer than {time} s, and was stopped.", values: { time: this.limit / 1000 } })),
      this.limit,
    );
    try {
      signal?.throwIfAborted();
      signal?.addEventListener("abort", stop);
      return await hand.ask(call, values, moved);
    } finally {
      clearTimeout(timer);
      signal?.removeEventListener("abort", stop);
      this.release(hand);
    }
  }

  close() {
    for (const hand of this.idle) hand.worker.terminate();
  }
}
