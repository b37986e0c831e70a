// What is said to the visitor: a refusal beside the controls, and what has just been done.

import { h, say } from "../common/dom.ts";
import { messageOf, spokenText } from "../words/words.ts";

const TOAST_TIME = 6000; // milliseconds

export class Notice {
  message = h("p", { class: "message", role: "alert", hidden: true });
  toast = h("div", { class: "toast", role: "status", hidden: true });
  timer = 0;

  /** `hint`: what can be done. */
  fail(error: Error, hint = "") {
    const said = messageOf(error);
    this.message.replaceChildren(...[said, ...(hint ? [" ", hint] : [])].map(spokenText));
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
