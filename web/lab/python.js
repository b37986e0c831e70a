// What needs Python: motions that doubles do not decide, and some files. Its results come from the server of the page, or from
// the kernel of the notebook.

import { unpack } from "./packing.js";

const TRIES = 4; // of a server that says it is busy
const GONE = "The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";

/** @implements {Python} */
export class Server {
  /** @param {URL} base */
  constructor(base) {
    this.base = base;
  }

  /**
   * @param {object} body
   * @param {AbortSignal} [signal]
   */
  async motion(body, signal) {
    const asked = {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body),
      signal,
    };
    return unpack(await (await this.answered(new URL("lab/motion", this.base), asked)).arrayBuffer());
  }

  /**
   * @param {string} name
   * @param {string} query
   */
  async file(name, query) {
    return (await this.answered(new URL(`api/v1/files/${name}?${query}`, this.base))).blob();
  }

  /**
   * What the server answers; a busy one is asked again when it says so, and one that is gone is named in words.
   * @param {URL} place
   * @param {RequestInit} [asked]
   */
  async answered(place, asked) {
    for (let left = TRIES; ; left--) {
      const response = await fetch(place, asked).catch((error) => {
        throw error.name === "AbortError" ? error : new Error(GONE);
      });
      if (response.ok) return response;
      const again = Number(response.headers.get("Retry-After"));
      if (response.status !== 503 || !(again > 0) || left <= 1) {
        const said = await response.json().catch(() => ({}));
        throw new Error(said.detail ?? `The server answered ${response.status}.`);
      }
      await new Promise((resolve) => setTimeout(resolve, 1000 * Math.min(again, 10)));
      asked?.signal?.throwIfAborted();
    }
  }
}

const PATIENCE = 20_000; // milliseconds; files take longer
const FILE_PATIENCE = 300_000;

/**
 * The part of an anywidget model that is used.
 * @typedef {{
 *   get(name: string): any, set(name: string, value: unknown): void, save_changes(): void, send(message: object): void,
 *   on(name: string, listener: (...values: any[]) => void): void,
 *   off(name: string, listener: (...values: any[]) => void): void,
 * }} Model
 */

/** @implements {Python} */
export class NotebookKernel {
  /** @param {Model} model */
  constructor(model) {
    this.model = model;
    this.waiting = new Map();
    this.number = 0;
    // several views of one widget share its messages; each answers to its own
    this.view = Math.random().toString(36).slice(2);
    this.listen = (/** @type {any} */ message, /** @type {any[]} */ buffers) => this.answered(message, buffers);
    model.on("msg:custom", this.listen);
  }

  /**
   * @param {any} message
   * @param {any[]} buffers
   */
  answered(message, buffers) {
    const waits = message?.view === this.view && this.waiting.get(message.number);
    if (!waits) return;
    clearTimeout(waits.timer);
    this.waiting.delete(message.number);
    if (message.error) waits.reject(new Error(message.error));
    else waits.resolve(unpack(buffers[0]));
  }

  /**
   * @param {"motion" | "file" | "derivatives"} call
   * @param {object} body
   * @param {AbortSignal} [signal]
   * @returns {Promise<Reply>}
   */
  ask(call, body, signal) {
    const number = ++this.number;
    return new Promise((resolve, reject) => {
      // a saved notebook plays without a kernel, but its kernel makes no files
      const timer = setTimeout(
        () => {
          this.waiting.delete(number);
          reject(new Error("The notebook’s kernel does not answer; run the cell again."));
        },
        call === "file" ? FILE_PATIENCE : PATIENCE,
      );
      this.waiting.set(number, { resolve, reject, timer });
      signal?.addEventListener("abort", () => {
        clearTimeout(timer);
        this.waiting.delete(number);
        reject(new DOMException("superseded", "AbortError"));
      });
      this.model.send({ view: this.view, number, call, body });
    });
  }

  /**
   * @param {object} body
   * @param {AbortSignal} [signal]
   */
  motion(body, signal) {
    return this.ask("motion", body, signal);
  }

  /**
   * @param {string} name
   * @param {string} query
   */
  async file(name, query) {
    const { arrays } = await this.ask("file", { query, name });
    return new Blob([arrays.content]);
  }

  /** The module of derivatives, which only comes when it is asked for: it is larger than most notebooks. */
  async derivatives() {
    return (await this.ask("derivatives", {})).arrays.content;
  }

  close() {
    this.model.off("msg:custom", this.listen);
  }
}
