// Plays a scene of hoops in space, in a page that holds all that it needs.

import { Stage3D } from "../lab/player/stage3d.ts";
import { Labels } from "./labels.ts";
import { Words } from "./words.ts";
import type { Seen } from "../lab/player/stage3d.ts";

const element: (id: string) => any = (id) => document.getElementById(id);

class Player {
  films = this.data.hoops.map((hoop) => new Written(hoop, this.data));
  last = this.data.rate.length - 1;
  now = 0;
  before: number | null = null;
  button: HTMLButtonElement = element("play");
  slider: HTMLInputElement = element("time");
  rate: HTMLSelectElement = element("rate");
  follow: HTMLInputElement = element("follow");
  // the page is the picture: the wheel is always its own
  stage = new Stage3D(
    element("scene"),
    () => {},
    () => document.activeElement as HTMLElement,
  );
  labels = new Labels(element("labels"), this.stage, this.films, this.data);
  words = new Words(this.data);
  playing: boolean | undefined;

  constructor(readonly data: SceneData) {
    this.stage.tile = data.grid;
    this.slider.max = String(this.last);
    this.button.onclick = () => this.toggle();
    this.slider.oninput = () => {
      this.now = Number(this.slider.value);
      this.play(false);
    };
    element("reset").onclick = () => this.stage.zoomBy(0);
    document.addEventListener("keydown", (event) => this.key(event));
    this.play(true);
    this.open(location.hash);
    requestAnimationFrame((clock) => this.tick(clock));
  }

  /** A link that ends in #t=1.05 opens at that time. */
  open(hash: string) {
    const asked = /t=([\d.]+)/.exec(hash);
    if (!asked) return;
    const index = this.data.hoops[0].frames.t.findIndex((t) => t >= Number(asked[1]));
    this.now = index < 0 ? this.last : index;
    this.slider.value = String(this.now);
    this.play(false);
  }

  play(on: boolean) {
    this.playing = on;
    if (!on) this.now = Math.floor(this.now); // a still picture is that of its numbers
    this.button.textContent = on ? "Pause" : "Play";
  }

  toggle() {
    if (!this.playing && this.now >= this.last) this.now = 0;
    this.play(!this.playing);
  }

  key(event: KeyboardEvent) {
    if ((event.target as Element).tagName === "SELECT" || event.target === this.button) return;
    if (event.key === " ") {
      this.toggle();
      event.preventDefault();
    }
    const way = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!way || event.target === this.slider) return;
    this.play(false);
    this.now = Math.min(Math.max(Math.round(this.now) + way, 0), this.last);
  }

  /** `clock`: [ms]. */
  tick(clock: number) {
    if (this.playing && this.before !== null) {
      this.now += ((clock - this.before) / 1000) * this.data.fps * Number(this.rate.value);
      if (this.now >= this.last) {
        this.now = this.last;
        this.play(false);
      }
      this.slider.value = String(this.now);
    }
    this.before = clock;
    this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  draw() {
    const { data, films, stage, now } = this;
    const traces = data.hoops.some(({ path }) => path !== null);
    const options = { traces, forces: data.newton !== null, speed: true, whole: !this.follow.checked };
    stage.draw(films, now, options, { look: data.theme, inks: data.colors }, this.playing ?? false);
    this.labels.draw(now);
    this.words.show(now, stage.metre);
  }
}

// --- A motion as Python has written it into the page, in the terms of the player: frames to be shown, and the path to be drawn

const LETTERS = "RSKHM";

/** Arrays of 32 bits are written as base64. */
const read: (value: any) => any = (value) => {
  if (Array.isArray(value) || value === null || typeof value !== "object") return value;
  if (value.f32 === undefined) return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, read(each)]));
  return new Float32Array(Uint8Array.from(atob(value.f32), (letter) => letter.charCodeAt(0)).buffer);
};

export function unpacked(text: string): SceneData {
  const data = read(JSON.parse(text));
  return { ...data, hoops: data.hoops.map(read) };
}

export class Written implements Seen {
  radius = this.hoop.radius;
  eccentricity = this.hoop.eccentricity;
  load = this.hoop.load;
  newton = this.data.newton ?? 0;
  slope = this.data.slope;
  extent = { ...this.data.extent, top: 0 };
  columns = this.hoop.path ?? this.hoop.frames;
  t = this.columns.t;
  length = this.t.length;
  duration = this.t[this.length - 1];

  constructor(
    readonly hoop: SceneHoop,
    readonly data: SceneData,
  ) {}

  /** The last point of the path until a time. */
  index(time: number) {
    return Math.max(
      this.t.findLastIndex((t) => t <= time),
      0,
    );
  }

  /** The state between two frames; modes and forces jump. */
  at(now: number): Pose {
    const { frames } = this.hoop;
    const k = Math.floor(now);
    const next = Math.min(k + 1, frames.t.length - 1);
    const between = (column: Column) => column[k] + (now - k) * (column[next] - column[k]);
    const state = Object.fromEntries(Object.entries(frames).map(([name, column]) => [name, between(column)]));
    const forces = { normal_force: frames.normal_force[k], friction_force: frames.friction_force[k] };
    return { ...state, ...forces, mode: LETTERS[frames.mode[k]] } as Pose;
  }
}

try {
  new Player(unpacked(element("data").textContent));
} catch (error) {
  // mostly because there is no WebGL
  element("problem").textContent = error.message;
  element("problem").style.display = "flex";
}
