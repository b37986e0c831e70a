// Dark or light: as the visitor has chosen, else as the system has it.

import { readable } from "./colors.js";
import { theme } from "./dom.js";
import { recall, remember } from "./memory.js";

const KEY = "hophoop-theme";
const LINES = /** @type {const} */ (["gravity_center", "airborne", "normal_force", "friction_force"]);

export class Theme {
  /**
   * @param {HTMLElement} root
   * @param {Colors} colors
   * @param {boolean} hosted whether the page is the lab's own
   * @param {() => void} changed
   */
  constructor(root, colors, hosted, changed) {
    this.root = root;
    this.colors = colors;
    this.hosted = hosted;
    this.changed = changed;
    /** @type {string | null} */
    this.chosen = null;
    this.media = matchMedia("(prefers-color-scheme: dark)");
    this.listen = () => this.apply();
    this.media.addEventListener("change", this.listen);
    this.mark();
    /** @type {Look} */
    this.look = theme(root);
    this.inks = { ...colors };
    this.read();
  }

  mark() {
    const kept = this.hosted ? recall(KEY) : null;
    this.root.dataset.theme = this.chosen ?? kept ?? (this.media.matches ? "dark" : "light");
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
