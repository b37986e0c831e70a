// The page opens in motion: one silent run, and a word at the load that it can be taken, until the first touch.

import type { Clock } from "../player/clock.ts";

const TOUCHES = ["pointerdown", "wheel"] as const;

export class Opening {
  touches = new AbortController();

  constructor(
    readonly clock: Clock,
    readonly hint: HTMLElement,
  ) {}

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
