// For a class: the player alone, large, on the whole screen, or in all of the page where there is no full screen.

import { iconButton } from "../common/dom.ts";
import type { Lab } from "./lab.ts";

export class Present {
  full = false;
  on = false;
  left = () => {
    if (!document.fullscreenElement && this.full) this.turn(false);
  };
  /** The way out, also for fingers. */
  leave = iconButton(document.createTextNode("×"), "menu.leave_presentation", () => this.turn(false), {
    class: "leave",
  });

  constructor(readonly lab: Pick<Lab, "extras" | "root" | "show">) {
    document.addEventListener("fullscreenchange", this.left);
  }

  async turn(on = !this.on) {
    const { root, extras } = this.lab;
    this.on = on;
    root.classList.toggle("presenting", on);
    extras.mark();
    this.lab.show();
    if (!on) {
      const { full } = this;
      this.full = false;
      if (full && document.fullscreenElement) await document.exitFullscreen().catch(() => {});
      return;
    }
    this.leave.focus({ preventScroll: true }); // what was pressed may be hidden now
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
