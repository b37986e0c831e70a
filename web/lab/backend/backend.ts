// Where answers come from: the server of the page, or the notebook's kernel. Both take the same calls.

import { unpack } from "./packing.ts";
import { Refused } from "../words/words.ts";

const TRIES = 4; // of a server that says it is busy
const GONE = "The server does not answer. What is here goes on playing; changes need `hophoop lab` to run again.";

export class HttpBackend {
  shares = true;

  constructor(readonly base: URL) {}

  async call(name: string, body: object, signal?: AbortSignal) {
    const asked = {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body),
      signal,
    };
    const response = await this.answered(new URL(`lab/${name}`, this.base), asked);
    return unpack(await response.arrayBuffer());
  }

  /** What the server answers; a busy one is asked again when it says so, and one that is gone is named in words. */
  async answered(place: URL, asked?: RequestInit) {
    for (let left = TRIES; ; left--) {
      const response = await fetch(place, asked).catch((error) => {
        throw error.name === "AbortError" ? error : new Error(GONE);
      });
      if (response.ok) return response;
      const again = Number(response.headers.get("Retry-After"));
      if (response.status !== 503 || !(again > 0) || left <= 1) {
        const said = await response.json().catch(() => ({}));
        throw said.detail
          ? new Error(said.detail)
          : new Refused({ key: "The server answered {status}.", values: { status: response.status } });
      }
      await new Promise((resolve) => setTimeout(resolve, 1000 * Math.min(again, 10)));
      asked?.signal?.throwIfAborted();
    }
  }

  async file(name: string, query: string) {
    return (await this.answered(new URL(`api/v1/files/${name}?${query}`, this.base))).blob();
  }

  link(query: string, hash: string) {
    return `${new URL(query ? `?${query}` : "", this.base)}${hash}`;
  }
}

const PATIENCE = 20_000; // milliseconds; files take longer
const FILE_PATIENCE = 300_000;

// Messages to the kernel behind an anywidget model.
/** The part of an anywidget model that is used. */
export type Model = {
  get(name: string): any;
  set(name: string, value: unknown): void;
  save_changes(): void;
  send(message: object): void;
  on(name: string, listener: (...values: any[]) => void): void;
  off(name: string, listener: (...values: any[]) => void): void;
};

export class KernelBackend {
  shares = false;
  waiting: Map<any, any> = new Map();
  number = 0;
  // several views of one widget share its messages; each answers to its own
  view = Math.random().toString(36).slice(2);
  listen: (message: any, buffers: any[]) => void;

  constructor(readonly model: Model) {
    this.listen = (message: any, buffers: any[]) => this.answered(message, buffers);
    model.on("msg:custom", this.listen);
  }

  answered(message: any, buffers: any[]) {
    const waits = message?.view === this.view && this.waiting.get(message.number);
    if (!waits) return;
    clearTimeout(waits.timer);
    this.waiting.delete(message.number);
    if (message.error) waits.reject(new Error(message.error));
    else waits.resolve(unpack(buffers[0]));
  }

  call(name: string, body: object, signal?: AbortSignal) {
    const number = ++this.number;
    return new Promise<any>((resolve, reject) => {
      // a saved notebook plays without a kernel, but cannot compute
      const timer = setTimeout(
        () => {
          this.waiting.delete(number);
          reject(new Error("The notebook’s kernel does not answer; run the cell again."));
        },
        name === "file" ? FILE_PATIENCE : PATIENCE,
      );
      this.waiting.set(number, { resolve, reject, timer });
      signal?.addEventListener("abort", () => {
        clearTimeout(timer);
        this.waiting.delete(number);
        reject(new DOMException("superseded", "AbortError"));
      });
      this.model.send({ view: this.view, number, call: name, body });
    });
  }

  async file(name: string, query: string) {
    const { arrays } = await this.call("file", { query, name });
    return new Blob([arrays.content]);
  }

  link() {
    return null;
  }

  close() {
    this.model.off("msg:custom", this.listen);
  }
}
