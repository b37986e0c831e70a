// The head of the page: examples, steps back and forth, a second hoop, all or little, sharing, dark or light, help.

import { h, iconButton as button } from "../common/dom.ts";
import { icon } from "../common/icons.ts";
import type { History } from "./history.ts";

/** In words, or as a picture where there is little room. */
const worded = (words: string, name: Parameters<typeof icon>[0]) =>
  h("span", {}, h("span", { class: "long" }, words), h("span", { class: "short" }, icon(name)));

export interface Actions {
  take: (preset: Preset) => void;
  undo: () => void;
  redo: () => void;
  reset: () => void;
  compare: () => void;
  theme: () => void;
  help: () => void;
}

export class Header {
  fresh = false; // a motion has just been chosen: Space plays it and does not open the list
  presets: HTMLSelectElement;
  undo: HTMLButtonElement;
  redo: HTMLButtonElement;
  reset: HTMLButtonElement;
  compare: HTMLButtonElement;
  right: HTMLDivElement;
  element: HTMLElement;

  /** `share`: the menu of what can be shared and saved; `view`: what switches to everything and back. */
  constructor(presets: Preset[], share: HTMLElement, view: HTMLElement, actions: Actions) {
    const options = (more: boolean) =>
      presets.filter((preset) => preset.more === more).map(({ key, title }) => h("option", { value: key }, title));
    this.presets = h(
      "select",
      {
        class: "presets",
        "aria-label": "header.examples",
        onchange: () => {
          const preset = presets.find(({ key }) => key === this.presets.value);
          this.fresh = preset !== undefined;
          if (preset) actions.take(preset);
        },
        onblur: () => {
          this.fresh = false;
        },
        onpointerdown: () => {
          this.fresh = false;
        },
      },
      h("option", { value: "" }, "header.examples_prompt"),
      options(false),
      h("optgroup", { label: "examples.more" }, options(true)),
    );
    this.undo = button(icon("undo"), "header.undo", actions.undo);
    this.redo = button(icon("redo"), "header.redo", actions.redo);
    this.reset = button(worded("header.reset", "reset"), "header.reset_title", actions.reset);
    this.compare = button(worded("header.compare", "two"), "header.compare_title", actions.compare);
    this.compare.classList.add("full");
    this.right = h(
      "div",
      { class: "buttons right" },
      share,
      button(icon("theme"), "header.theme", actions.theme),
      button("?", "header.help", actions.help),
    );
    this.element = h(
      "header",
      { class: "top" },
      h(
        "h1",
        {},
        h("span", { class: "logo", "aria-hidden": "true" }),
        h("span", {}, "hophoop", h("span", { class: "long" }, " ", "header.lab")),
      ),
      this.presets,
      h("div", { class: "buttons" }, this.undo, this.redo, this.reset, this.compare, view),
      this.right,
    );
  }

  /** `reset`: whether there is something to set back. */
  show(history: History, two: boolean, reset: boolean) {
    this.undo.disabled = !history.past.length;
    this.redo.disabled = !history.future.length;
    this.reset.disabled = !reset;
    this.compare.setAttribute("aria-pressed", String(two));
  }
}
