// Dark or light: as the visitor has chosen, else as the system has it.

import { readable } from "../common/colors.ts";
import { theme } from "../common/dom.ts";
import { recall, remember } from "./memory.ts";

const KEY = "hophoop-theme";
const LINES = ["gravity_center", "airborne", "normal_force", "friction_force"] as const;

export class Theme {
  chosen: string | null = null;
  media = matchMedia("(prefers-color-scheme: dark)");
  listen = () => this.apply();
  look: Look;
  inks: Colors;

  /** `hosted`: whether the page is the lab's own. */
  constructor(
    readonly root: HTMLElement,
    public colors: Colors,
    readonly hosted: boolean,
    readonly changed: () => void,
  ) {
    this.media.addEventListener("change", this.listen);
    this.mark();
    this.read();
  }

  mark() {
    const paper = this.root.classList.contains("printing") && "light";
    const kept = this.hosted ? recall(KEY) : null;
    this.root.dataset.theme = paper || (this.chosen ?? kept ?? (this.media.matches ? "dark" : "light"));
    if (this.hosted) document.documentElement.style.colorScheme = this.root.dataset.theme;
  }

  // The colours that the style sheet gives now, and those of thin lines, which must stand out from the paper.
  read() {
    this.look = theme(this.root);
    this.inks = { ...this.colors };
    for (const name of LINES) this.inks[name] = readable(this.colors[name], this.look.dark);
  }

  apply() {
    this.mark();
    this.read();
    this.changed();
  }

  toggle() {
    this.chosen = this.root.dataset.theme === "dark" ? "light" : "dark";
    if (this.hosted) remember(KEY, this.chosen);
    this.apply();
  }

  close() {
    this.media.removeEventListener("change", this.listen);
  }
}
