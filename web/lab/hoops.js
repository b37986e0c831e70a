// Which of two hoops the controls change, and what there is to see in the motion that one started from.

import { h } from "./dom.js";

export class Hoops {
  /** @param {(lane: number) => void} choose */
  constructor(choose) {
    this.tabs = ["Hoop A", "Hoop B"].map((name, i) =>
      h("button", { type: "button", "aria-pressed": "false", onclick: () => choose(i) }, name),
    );
    this.bar = h(
      "div",
      { class: "tabs", role: "group", "aria-label": "Which hoop the controls change", hidden: true },
      this.tabs,
    );
    this.text = h("p", { class: "preset-text" });
    this.element = h("div", { class: "lanes" }, this.bar, this.text);
  }

  /**
   * @param {number} count
   * @param {number} active
   */
  show(count, active) {
    this.bar.hidden = count < 2;
    for (const [i, tab] of this.tabs.entries()) tab.setAttribute("aria-pressed", String(i === active));
  }
}
