// The time that is shown, and how it runs.

import { clamp } from "../common/clamp.ts";

export const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];

/** Whether the visitor wants nothing to move by itself. */
export const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Clock {
  time = 0;
  duration = 1;
  speed = 1;
  playing = false;
  loop = !calm();
  /** Whether it goes back to the start after this run, and stays there. */
  once = false;
  /** A time that is pointed at, without going there. */
  pointed: number | null = null;
  last: number | null = null;
  /** Called when it is elsewhere, or runs otherwise. */
  changed = () => {};

  /** The film runs by itself, and only where nothing speaks against it; else it goes to where it would end. */
  run({ to = this.time, once = false } = {}) {
    if (calm()) this.seek(to);
    else {
      this.play(true);
      this.once = once;
    }
  }

  seek(time: number) {
    this.time = clamp(time, 0, this.duration);
    this.changed();
  }

  point(time: number | null) {
    this.pointed = time;
    this.changed();
  }

  play(playing = !this.playing) {
    this.playing = playing;
    this.once = false;
    this.last = null;
    if (playing && this.time >= this.duration) this.time = 0;
    this.changed();
  }

  faster(way: -1 | 1) {
    const place = SPEEDS.indexOf(this.speed);
    this.speed = SPEEDS[clamp(place + way, 0, SPEEDS.length - 1)];
    this.changed();
  }

  /** Called once a frame; whether the time has moved. */
  tick(now: number) {
    if (!this.playing) return false;
    // after a pause of the tab the film goes on where it was
    const passed = this.last === null ? 0 : Math.min(now - this.last, 100) / 1000;
    this.last = now;
    this.time += passed * this.speed;
    if (this.time >= this.duration) {
      if (this.loop && !this.once && this.duration > 0) this.time %= this.duration;
      else {
        this.time = this.once ? 0 : this.duration;
        this.playing = false;
        this.changed();
      }
    }
    return true;
  }
}

// --- The page opens in motion: one silent run, and a word at the load that it can be taken, until the first touch

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
