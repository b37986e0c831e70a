// The head of the page: examples, steps back and forth, a second hoop, all or little, sharing, dark or light, help.

import { h, iconButton as button } from "../common/dom.ts";
import { icon } from "../common/icons.ts";
import type { Lab } from "./lab.ts";

/** In words, or as a picture where there is little room. */
const worded = (words: string, name: Parameters<typeof icon>[0]) =>
  h("span", h("span.long", words), h("span.short", icon(name)));

export class Header {
  fresh = false; // a motion has just been chosen: Space plays it and does not open the list
  presets = h(
    "select.presets",
    {
      "aria-label": "header.examples",
      onchange: () => this.take(),
      onblur: () => (this.fresh = false),
      onpointerdown: () => (this.fresh = false),
    },
    h("option", { value: "" }, "header.examples_prompt"),
    this.options(false),
    h("optgroup", { label: "examples.more" }, this.options(true)),
  );
  undo = button(icon("undo"), "header.undo", () => this.lab.travel(-1));
  redo = button(icon("redo"), "header.redo", () => this.lab.travel(1));
  reset = button(worded("header.reset", "reset"), "header.reset_title", () => this.lab.reset());
  compare = button(worded("header.compare", "two"), "header.compare_title", () => this.lab.motions.compare(), {
    class: "full",
  });
  right = h(
    "div.buttons.right",
    this.lab.share.menu,
    button(icon("theme"), "header.theme", () => this.lab.theme.toggle()),
    button("?", "header.help", () => this.lab.help.showModal()),
  );
  element = h(
    "header.top",
    h("h1", h("span.logo", { "aria-hidden": "true" }), h("span", "hophoop", h("span.long", " ", "header.lab"))),
    this.presets,
    h("div.buttons", this.lab.view.button, this.undo, this.redo, this.reset, this.compare),
    this.right,
  );

  constructor(
    readonly lab: Pick<
      Lab,
      "firstQuery" | "help" | "known" | "motions" | "reset" | "share" | "take" | "theme" | "travel" | "view"
    >,
  ) {}

  options(more: boolean) {
    const presets = this.lab.known.filter((preset) => preset.more === more);
    return presets.map(({ key }) => h("option", { value: key }, `example.${key}`));
  }

  take() {
    const preset = this.lab.known.find(({ key }) => key === this.presets.value);
    this.fresh = Boolean(preset);
    if (preset) this.lab.take(preset);
  }

  show() {
    const { motions } = this.lab;
    this.undo.disabled = !motions.history.past.length;
    this.redo.disabled = !motions.history.future.length;
    this.reset.disabled = motions.film().query === this.lab.firstQuery();
    this.compare.ariaPressed = String(motions.lanes.length > 1);
  }
}

// --- Which of two hoops the controls change, and what there is to see in the motion that one started from

export class Hoops {
  tabs = ["hoops.a", "hoops.b"].map((name, i) =>
    h("button", { "aria-pressed": "false", onclick: () => this.choose(i) }, name),
  );
  bar = h("div.tabs", { role: "group", "aria-label": "hoops.choice", hidden: true }, this.tabs);
  text = h("p.preset-text");
  element = h("div.lanes", this.bar, this.text);

  constructor(readonly choose: (lane: number) => void) {}

  show(count: number, active: number) {
    this.bar.hidden = count < 2;
    for (const [i, tab] of this.tabs.entries()) tab.ariaPressed = String(i === active);
  }
}
