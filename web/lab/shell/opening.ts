// The page opens in motion: one silent run, and a word at the load that it can be taken, until the first touch.

import { h } from "../common/dom.ts";
import type { Clock } from "../player/clock.ts";

const TOUCHES = ["pointerdown", "wheel"] as const;

export class Opening {
  hint = h("div", { class: "grip-hint", "aria-hidden": "true", hidden: true }, "Drag the load");
  touches = new AbortController();

  /** `place`: what the load is taken by. */
  constructor(
    readonly clock: Clock,
    readonly place: HTMLElement,
  ) {
    place.append(this.hint);
  }

  begin(player: HTMLElement) {
    const { signal } = this.touches;
    const touched = () => this.end();
    for (const kind of TOUCHES) player.addEventListener(kind, touched, { signal, capture: true, passive: true });
    addEventListener("keydown", touched, { signal, capture: true });
    this.hint.hidden = false;
    this.clock.run({ once: true });
  }

  end() {
    this.hint.hidden = true;
    this.touches.abort();
  }
}
