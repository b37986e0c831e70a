// Files that need Python, from the server of the page or from the kernel of the notebook.

import { Refused } from "../words/words.ts";

const GONE = "backend.server_silent";
const NO_MATCH = "server.no_match";
/** What is said of an answer that is none, by its status. */
const REFUSALS: Record<number, string> = {
  403: "server.not_from_here",
  404: NO_MATCH,
  408: "server.late",
  413: "server.too_much",
  415: NO_MATCH,
  422: NO_MATCH,
  500: "server.failed",
  501: "server.missing_extra",
  503: "server.busy",
};

function refused(status: number, values: Values) {
  const key = REFUSALS[status] ?? "backend.server_status";
  return new Refused({ key, values: { status, ...values } });
}

export class Server implements Python {
  constructor(readonly base: URL) {}

  async file(name: string, scenario: Scenario) {
    const asked = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(scenario) };
    const response = await fetch(new URL(`files/${name}`, this.base), asked).catch(() => {
      throw new Error(GONE);
    });
    if (response.ok) return response.blob();
    const { install = "" } = await response.json().catch(() => ({}));
    throw refused(response.status, { install, count: Number(response.headers.get("Retry-After")) || 1 });
  }
}

const PATIENCE = 20_000; // milliseconds; files take longer
const FILE_PATIENCE = 300_000;

/** The part of an anywidget model that is used. */
export type Model = {
  get(name: string): any;
  set(name: string, value: unknown): void;
  save_changes(): void;
  send(message: object): void;
  on(name: string, listener: (...values: any[]) => void): void;
  off(name: string, listener: (...values: any[]) => void): void;
};

export class NotebookKernel implements Python {
  waiting: Map<any, any> = new Map();
  number = 0;
  // several views of one widget share its messages; each answers to its own
  view = Math.random().toString(36).slice(2);
  listen: (message: any, buffers: any[]) => void = (message: any, buffers: any[]) => this.answered(message, buffers);

  constructor(readonly model: Model) {
    model.on("msg:custom", this.listen);
  }

  answered(message: any, buffers: DataView<ArrayBuffer>[]) {
    const waits = message?.view === this.view && this.waiting.get(message.number);
    if (!waits) return;
    clearTimeout(waits.timer);
    this.waiting.delete(message.number);
    if (message.status) waits.reject(refused(message.status, { install: message.install ?? "" }));
    else waits.resolve(buffers[0]);
  }

  ask(call: "file" | "derivatives", body: object): Promise<DataView<ArrayBuffer>> {
    const number = ++this.number;
    return new Promise((resolve, reject) => {
      // a saved notebook plays without a kernel, but its kernel makes no files
      const timer = setTimeout(
        () => {
          this.waiting.delete(number);
          reject(new Error("backend.notebook_silent"));
        },
        call === "file" ? FILE_PATIENCE : PATIENCE,
      );
      this.waiting.set(number, { resolve, reject, timer });
      this.model.send({ view: this.view, number, call, body });
    });
  }

  async file(name: string, scenario: Scenario) {
    return new Blob([await this.ask("file", { scenario, name })]);
  }

  /** The module of derivatives, which only comes when it is asked for: it is larger than most notebooks. */
  derivatives() {
    return this.ask("derivatives", {});
  }

  close() {
    this.model.off("msg:custom", this.listen);
  }
}
