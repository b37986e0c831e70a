// The places where the hoop can be taken, over the picture: load, hoop and plane, by mouse, finger and keys. Each is a
// slider for the keyboard and for screen readers.

import { calm } from "./clock.ts";
import { h, once, say } from "../common/dom.ts";
import { changesFor, keyed, Pull, taken, type Grip, type Held } from "./grab.ts";
import { clamp } from "../common/clamp.ts";
import { DEGREE, degrees, length, show } from "../common/numbers.ts";
import { follow, placeOn } from "../common/pointer.ts";
import { t } from "../words/words.ts";
import type { Motions } from "./motions.ts";
import type { Notice } from "../shell/notice.ts";
import type { Stage } from "./stage.ts";
import type { Scene } from "./scene2d.ts";

const REST = 700; // milliseconds after the last key until the start counts as chosen
const SMALL = 44; // pixels, the least that a finger hits
const LOAD = 16; // pixels about the middle of the load that are not covered

const GRIPS: [Grip, string, string][] = [
  ["plane", "hand.slope", "hand.slope_title"],
  ["hoop", "hand.hoop", "hand.hoop_title"],
  ["load", "hand.load_angle", "hand.load_title"],
];

export class Grips {
  static Pull = Pull;
  pull: Pull | null = null;
  /** What the keys hold. */
  held: Held | null = null;
  /** The motion before the hand came, for Escape. */
  before: string | null = null;

  /** What a first visitor is told. */
  hint = h("div.grip-hint", { "aria-hidden": "true", hidden: true }, "hand.hint");
  places = new Map(GRIPS.map(([grip, label, title]) => [grip, this.place(grip, label, title)]));
  tip = h("output.grip-tip", { "aria-hidden": "true", hidden: true });
  element = h(
    "div.grips",
    { role: "group", "aria-label": "hand.group" },
    [...this.places.values()],
    this.tip,
    this.hint,
  );
  settle = once(() => this.chosen(false), REST);

  /** `mark`: whether a hand holds the hoop; `request`: another picture. */
  constructor(
    readonly clock: Clock,
    readonly motions: Motions,
    readonly stage: Stage,
    readonly notice: Notice,
    readonly mark: (held: boolean) => void,
    readonly request: () => void,
  ) {
    const { flat, plane } = stage;
    // fingers and wheel belong to the picture below, which zooms; what is taken of it is decided here
    flat.grab = (event) => this.take(event);
    plane.addEventListener("pointermove", (event) => this.hover(event));
    plane.addEventListener("pointerleave", () => this.hover(null));
    const still = (event: TouchEvent) => this.pull && event.cancelable && event.preventDefault();
    plane.addEventListener("touchmove", still, { passive: false });
  }

  place(grip: Grip, label: string, title: string) {
    return h(`div.grip.grip-${grip}`, {
      role: "slider",
      tabindex: "0",
      "aria-label": label,
      "aria-valuenow": "0",
      title,
      onkeydown: (event: KeyboardEvent) => this.key(grip, event),
      onblur: () => this.held && this.chosen(false),
    });
  }

  view() {
    return this.stage.flat.views[this.motions.active];
  }

  /** Where the hoop can be taken follows the picture. */
  draw() {
    const view = this.view();
    const seen = Boolean(view) && !this.stage.options.three;
    this.element.hidden = !seen;
    if (!seen) return;
    this.element.classList.toggle("running", this.clock.playing);
    const { film, scale } = view;
    const R = film.radius;
    const [center, load] = [view.ray(0), view.ray(R)];
    const plane = this.onPlane(view);
    // the load must be free to be taken also where the hoop is small
    const wide = clamp(1.1 * R * scale, SMALL, 190);
    const spots: [Grip, number[], number][] = [
      ["plane", plane, SMALL],
      ["hoop", center, wide],
      ["load", load, SMALL],
    ];
    for (const [grip, [x, y], size] of spots) {
      const place = this.places.get(grip) as HTMLElement;
      place.style.transform = `translate(${x - size / 2}px, ${view.top + y - size / 2}px)`;
      place.style.width = place.style.height = `${size}px`;
      place.hidden = x < 0 || y < 0 || x > view.width || y > view.height;
    }
    if (!this.hint.hidden) this.placeHint(load[0], view.top + load[1]);
    if (!this.clock.playing) this.tell(film);
  }

  /** Above the load, clear of the load itself and of the numbers on the picture. */
  placeHint(x: number, y: number) {
    const { stage } = this;
    const { offsetWidth, offsetHeight } = stage.element;
    const taken = [...stage.covered(), new DOMRect(x - LOAD, y - LOAD, 2 * LOAD, 2 * LOAD)];
    const size = this.hint.getBoundingClientRect();
    const [left, top] = clearPlace([x, y - SMALL], size, new DOMRect(0, 0, offsetWidth, offsetHeight), taken);
    this.hint.style.transform = `translate(${left}px, ${top}px) translate(-50%, -50%)`;
  }

  onPlane(view: Scene) {
    const foot = view.point(view.pose.x, 0);
    const right = Math.min(foot[0] + Math.max(1.9 * view.film.radius * view.scale, 90), view.width - 30);
    const along = (right - foot[0]) / (view.scale * Math.max(view.cosine, 0.2));
    return view.point(view.pose.x + along, 0);
  }

  /** The values for a screen reader: those of the start that is held or shown. */
  tell(film: Film) {
    const held = this.pull?.held ?? this.held ?? taken("hoop", film, this.clock.time);
    const state = t("hand.state", { height: length(held.height), speed: show(held.vx, 3) });
    const said: Record<Grip, [string, number, number, number]> = {
      load: [degrees(held.angle), held.angle / DEGREE, -180, 180],
      hoop: [state, held.height, 0, 4 * film.radius],
      plane: [degrees(held.slope), held.slope / DEGREE, -45, 45],
    };
    for (const [grip, place] of this.places) {
      const [text, ...numbers] = said[grip];
      if (place.ariaValueText === text) continue;
      const [now, least, most] = numbers.map((number) => String(Number(number.toPrecision(4))));
      Object.assign(place, { ariaValueText: text, ariaValueNow: now, ariaValueMin: least, ariaValueMax: most });
    }
  }

  /** Which part of the hoop is under the pointer. */
  under(event: Point) {
    if (this.element.hidden) return null;
    let found: Grip | null = null;
    // the last of those that lie over each other is on top
    for (const [grip, place] of this.places) {
      const { left, top, width } = place.getBoundingClientRect();
      const away = Math.hypot(event.clientX - left - width / 2, event.clientY - top - width / 2);
      if (!place.hidden && away <= width / 2) found = grip;
    }
    return found;
  }

  hover(event: PointerEvent | null) {
    if (this.pull) return;
    const grip = event && event.pointerType !== "touch" ? this.under(event) : null;
    for (const [name, place] of this.places) place.classList.toggle("near", name === grip);
    this.stage.plane.style.cursor = grip ? "grab" : "";
  }

  /** Returns whether the hoop is taken, not the picture. */
  take(event: PointerEvent): boolean {
    const grip = this.under(event);
    if (!grip || event.button > 0 || this.pull) return false;
    const { flat, plane } = this.stage;
    const place = this.places.get(grip) as HTMLElement;
    const view = this.view();
    const inside = (other: PointerEvent): Point => {
      const [clientX, y] = placeOn(plane, other);
      return { clientX, clientY: y - view.top };
    };
    const pull = new Pull(grip, this.motions.film(), this.clock.time, view, inside(event));
    const shift = [...flat.shift];
    let [moved, left] = [false, false];
    this.pull = pull;
    place.classList.add("held");
    const leave = () => {
      left = true;
      watching.abort();
      place.classList.remove("held");
      flat.fixed = null;
      this.pull = null;
      if (moved) this.comeBack(shift);
    };
    const watching = new AbortController();
    const press = (key: KeyboardEvent) => {
      if (key.key !== "Escape") return;
      key.stopPropagation();
      leave();
      if (moved) this.back();
    };
    addEventListener("keydown", press, { capture: true, signal: watching.signal });
    follow(
      plane,
      event,
      (other) => {
        if (left) return;
        if (flat.pinched()) {
          // a second finger zooms instead
          leave();
          if (moved) this.back();
          return;
        }
        if (!moved && Math.hypot(other.clientX - event.clientX, other.clientY - event.clientY) < 3) return;
        if (!moved) {
          flat.fixed = view.scale;
          this.hold();
          this.begin();
        }
        moved = true;
        pull.move(inside(other), other.timeStamp);
        flat.shift = [shift[0] + pull.moved, shift[1]];
        this.change(grip, pull.held, false);
        this.show(grip, pull.held);
      },
      (last, lifted) => {
        if (left) return;
        leave();
        if (!moved) return;
        if (!lifted) this.back();
        else {
          this.change(grip, pull.release(last.timeStamp), true);
          this.end(true);
        }
      },
    );
    return true;
  }

  key(grip: Grip, event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape" && this.held) this.back();
    else if (event.key === "Enter") this.chosen(true);
    else {
      this.held ??= taken(grip, this.motions.film(), this.clock.time);
      const next = keyed(grip, event.key, event.shiftKey, this.held, this.motions.film());
      if (!next) return;
      if (this.before === null) {
        this.hold();
        this.begin();
      }
      this.held = next;
      this.change(grip, next, false);
      this.show(grip, next);
      this.settle();
    }
    event.preventDefault();
    event.stopPropagation();
  }

  hold() {
    this.clock.play(false);
    this.before = this.motions.film().query;
  }

  begin() {
    this.stage.options.ahead = true;
    this.clock.seek(0);
    this.mark(true);
  }

  change(grip: Grip, held: Held, commit: boolean) {
    this.motions.change(changesFor(grip, held, this.motions.film()), commit);
  }

  show(grip: Grip, held: Held) {
    const words = {
      load: `θ = ${degrees(held.angle)}`,
      hoop: held.height > 0 ? `y = ${length(held.height)}` : `θ = ${degrees(held.angle)}`,
      plane: `β = ${degrees(held.slope)}`,
    };
    say(this.tip, held.vx && this.held ? `${words[grip]}, v = ${show(held.vx, 3)} m/s` : words[grip]);
    this.tip.hidden = false;
  }

  /** The keys have chosen a start. */
  chosen(play: boolean) {
    if (this.held && this.before !== null) this.motions.change([], true);
    this.end(play);
  }

  end(play: boolean) {
    this.held = null;
    this.before = null;
    this.tip.hidden = true;
    this.stage.options.ahead = false;
    this.mark(false);
    if (play) this.clock.seek(0);
    if (play) this.clock.run();
    this.request();
  }

  /** As it was before the hand came. */
  async back() {
    const { before } = this;
    this.end(false);
    if (before === null) return;
    const lane = this.motions.lanes[this.motions.active];
    lane.pending = null;
    // what is under way must not come after it
    while (lane.busy) await new Promise((resolve) => requestAnimationFrame(resolve));
    try {
      this.motions.replace(await this.motions.ask({ query: before }));
    } catch (error) {
      this.notice.fail(error);
    }
  }

  /** The picture follows the hoop again. */
  comeBack(home: number[]) {
    const { flat } = this.stage;
    const still = calm();
    const step = () => {
      if (this.pull) return;
      const left = flat.shift[0] - home[0];
      flat.shift = Math.abs(left) < 1 || still ? [...home] : [home[0] + 0.82 * left, home[1]];
      this.request();
      if (flat.shift[0] !== home[0]) requestAnimationFrame(step);
    };
    step();
  }
}

// --- Where a hint is put on the picture: next to what it is about, and clear of what else is there

/** The edges of a box, in pixels. */
type Edges = { left: number; right: number; top: number; bottom: number };

const GAP = 4; // pixels

/**
 * The middle of a box of a size: where it is wanted, else at the nearest place that is free. `inside`: what it must
 * not leave; `taken`: what it must not cover.
 */
export function clearPlace([x, y]: number[], size: Box, inside: Edges, taken: Edges[]) {
  const [half, tall] = [size.width / 2, size.height / 2];
  const across = [x, ...taken.flatMap(({ left, right }) => [right + half + GAP, left - half - GAP])];
  const up = [y, ...taken.flatMap(({ top, bottom }) => [bottom + tall + GAP, top - tall - GAP])];
  const places = across
    .flatMap((one) => up.map((other) => [one, other]))
    .map(([one, other]): [number, number] => [
      clamp(one, inside.left + half, inside.right - half),
      clamp(other, inside.top + tall, inside.bottom - tall),
    ]);
  const free = places.filter(
    ([one, other]) =>
      !taken.some(
        ({ left, right, top, bottom }) =>
          one - half < right && left < one + half && other - tall < bottom && top < other + tall,
      ),
  );
  const far = ([one, other]: number[]) => Math.hypot(one - x, other - y);
  return free.sort((a, b) => far(a) - far(b))[0] ?? places[0];
}
