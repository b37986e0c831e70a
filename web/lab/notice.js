// What is said to the visitor: a refusal beside the controls, and what has just been done.

import { h } from "./dom.js";

const TOAST_TIME = 4000; // milliseconds

export class Notice {
  constructor() {
    this.message = h("p", { class: "message", role: "alert", hidden: true });
    this.toast = h("div", { class: "toast", role: "status", hidden: true });
    this.timer = 0;
  }

  /** @param {Error} error */
  fail(error) {
    this.message.textContent = error.message;
    this.message.hidden = false;
    if (!this.message.isConnected) this.say(error.message);
  }

  clear() {
    this.message.hidden = true;
  }

  /** @param {string} text */
  say(text) {
    this.toast.textContent = text;
    this.toast.hidden = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.toast.hidden = true;
    }, TOAST_TIME);
  }
}
