// Which of two hoops the controls change, and what there is to see in the motion that one started from.

import { h } from "../common/dom.ts";

export class Hoops {
  tabs: HTMLButtonElement[];
  bar: HTMLDivElement;
  element: HTMLDivElement;
  text = h("p", { class: "preset-text" });

  constructor(choose: (lane: number) => void) {
    this.tabs = ["hoops.a", "hoops.b"].map((name, i) =>
      h("button", { "aria-pressed": "false", onclick: () => choose(i) }, name),
    );
    this.bar = h("div", { class: "tabs", role: "group", "aria-label": "hoops.choice", hidden: true }, this.tabs);
    this.element = h("div", { class: "lanes" }, this.bar, this.text);
  }

  show(count: number, active: number) {
    this.bar.hidden = count < 2;
    for (const [i, tab] of this.tabs.entries()) tab.ariaPressed = String(i === active);
  }
}
