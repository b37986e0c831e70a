// The simple view, with which visitors begin: the hoop, three sliders, one diagram. Or everything, which is remembered.

import { h } from "../common/dom.ts";
import { recall, remember } from "./memory.ts";
import type { Shown } from "./address.ts";

const KEY = "hophoop-view";
const SIMPLE = new Set(["start.speed", "hoop.load_fraction", "plane.mu", "duration"]);

/** Whether a motion has settings that the simple view does not show. */
const beyond = ({ query }: Film) => [...new URLSearchParams(query).keys()].some((key) => !SIMPLE.has(key));

export class View {
  simple = false;
  /** Goes from one view to the other. */
  button = h("button.view", { hidden: !this.hosted, onclick: () => this.choose() });
  /** Says that not all that matters is seen. */
  more = h(
    "p.hint.beyond",
    { hidden: true },
    "shell.other_settings",
    " ",
    h("button.link", { onclick: () => this.choose() }, "shell.show_everything"),
  );

  /** `hosted`: whether the lab owns the page; embedded hoops show what their page asks for. */
  constructor(
    readonly root: HTMLElement,
    readonly hosted: boolean,
    readonly changed: () => void,
  ) {}

  /** Whether the visitor has asked for everything before. */
  get everything() {
    return recall(KEY) === "everything";
  }

  /** A link opens the view in which it was copied. */
  open({ everything }: Shown) {
    this.turn(this.hosted && !this.everything && !everything);
  }

  choose() {
    this.turn(!this.simple);
    remember(KEY, this.simple ? "simple" : "everything");
    this.changed();
    this.button.focus({ preventScroll: true });
  }

  turn(simple: boolean) {
    this.simple = simple;
    this.root.classList.toggle("simple", simple);
    this.button.replaceChildren(
      h("span.long", simple ? "shell.everything" : "shell.simple_view"),
      h("span.short", simple ? "shell.everything" : "shell.simple_short"),
    );
    // a slider in a closed group would not be seen
    for (const group of this.root.querySelectorAll<HTMLDetailsElement>("details.group")) {
      if (simple) {
        group.dataset.open = String(group.open);
        group.open = true;
      } else if (group.dataset.open) group.open = group.dataset.open === "true";
    }
  }

  show(films: Film[]) {
    this.more.hidden = !this.simple || !(films.length > 1 || films.some(beyond));
  }
}
