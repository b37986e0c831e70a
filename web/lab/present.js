// For a class: the player alone, large, on the whole screen.

/**
 * @param {import("./lab.js").Lab} lab
 * @param {HTMLElement} toggle
 */
export class Present {
  /** @param {import("./lab.js").Lab} lab */
  constructor(lab) {
    this.lab = lab;
    this.left = () => {
      if (!document.fullscreenElement && this.full) this.turn(false);
    };
    document.addEventListener("fullscreenchange", this.left);
    this.full = false;
    this.on = false;
    /** @type {() => void} */
    this.onchange = () => {};
  }

  /** @param {boolean} [on] */
  async turn(on = !this.on) {
    const { root } = this.lab;
    this.on = on;
    root.classList.toggle("presenting", on);
    this.onchange();
    this.lab.show();
    if (!on) {
      const full = this.full;
      this.full = false;
      if (full && document.fullscreenElement) await document.exitFullscreen().catch(() => {});
      return;
    }
    try {
      await root.requestFullscreen?.();
      this.full = Boolean(document.fullscreenElement);
    } catch {
      // a page in a frame may not; large it is all the same
    }
  }

  close() {
    document.removeEventListener("fullscreenchange", this.left);
  }
}
