// What is said to the visitor: a refusal beside the controls, and what has just been done.

import { h, say } from "../common/dom.ts";
import { messageOf } from "../words/words.ts";

const TOAST_TIME = 6000; // milliseconds

export class Notice {
  message = h("p.message", { role: "alert", hidden: true });
  toast = h("div.toast", { role: "status", hidden: true });
  timer = 0;

  /** `hint`: what can be done. */
  fail(error: Error, hint = "") {
    const said = messageOf(error);
    say(this.message, hint ? [said, " ", hint] : said);
    this.message.hidden = false;
    if (!this.seen()) this.say(said, this.message.isConnected);
  }

  // Whether the refusal stands where one looks.
  seen() {
    const { top, bottom, height } = this.message.getBoundingClientRect();
    return this.message.isConnected && height > 0 && top >= 0 && bottom <= innerHeight;
  }

  clear() {
    this.message.hidden = true;
  }

  /** `heard`: whether a screen reader has it already. */
  say(text: Message, heard = false) {
    this.toast.setAttribute("role", heard ? "presentation" : "status");
    say(this.toast, text);
    this.toast.hidden = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.toast.hidden = true;
    }, TOAST_TIME);
  }
}

// --- A motion that takes long: it is said that it is computed, with the time that it may take, and a button gives it up

const PATIENCE = 300; // milliseconds without a word
const TICK = 100;

/** The visitor has given it up. */
export class Stopped extends Error {}

export class Computing {
  used = { key: "shell.time_used", values: { time: this.limit / 1000 } };
  bar = h("progress", { "aria-label": this.used, title: this.used });
  stops = h("button", { onclick: () => this.stop() }, "shell.stop");
  element = h("div.computing", { role: "status", hidden: true }, "shell.computing", this.bar, this.stops);
  asked = new Set<AbortController>();
  began = 0;
  timer = 0;

  /** `limit`: milliseconds that the kernel may take. */
  constructor(readonly limit = Infinity) {}

  /** What is asked for, unless it is stopped. */
  async during<T>(ask: (signal: AbortSignal) => Promise<T>) {
    const asked = new AbortController();
    if (!this.asked.size) this.begin();
    this.asked.add(asked);
    try {
      return await ask(asked.signal);
    } catch (error) {
      throw asked.signal.aborted ? new Stopped("shell.stopped") : error;
    } finally {
      this.asked.delete(asked);
      if (!this.asked.size) this.close();
    }
  }

  begin() {
    this.began = performance.now();
    this.timer = setInterval(() => this.show(), TICK);
  }

  show() {
    const took = performance.now() - this.began;
    this.element.hidden = took < PATIENCE;
    // Python has limits of its own
    if (took < this.limit) this.bar.value = took / this.limit;
    else this.bar.removeAttribute("value");
  }

  stop() {
    for (const asked of this.asked) asked.abort();
  }

  close() {
    clearInterval(this.timer);
    this.element.hidden = true;
  }
}
