// Plays a scene of hoops in space, in a page that holds all that it needs.

import { Camera } from "./camera.ts";
import { unpacked } from "./data.ts";
import { Picture } from "./picture.ts";
import { Words } from "./words.ts";

const element: (id: string) => any = (id) => document.getElementById(id);

class Player {
  last = this.data.count - 1;
  now = 0;
  before: number | null = null;
  button: HTMLButtonElement = element("play");
  slider: HTMLInputElement = element("time");
  rate: HTMLSelectElement = element("rate");
  follow: HTMLInputElement = element("follow");
  picture: Picture;
  camera: Camera;
  words: Words;
  playing: boolean | undefined;

  constructor(readonly data: SceneData) {
    const canvas = element("scene");
    this.picture = new Picture(canvas, element("labels"), data);
    this.camera = new Camera(canvas, data, () => this.follow.checked);
    this.words = new Words(data);
    this.slider.max = String(this.last);
    this.button.onclick = () => this.toggle();
    this.slider.oninput = () => {
      this.now = Number(this.slider.value);
      this.play(false);
    };
    element("reset").onclick = () => this.camera.reset();
    document.addEventListener("keydown", (event) => this.key(event));
    this.play(true);
    this.open(location.hash);
    requestAnimationFrame((clock) => this.tick(clock));
  }

  /** A link that ends in #t=1.05 opens at that time. */
  open(hash: string) {
    const asked = /t=([\d.]+)/.exec(hash);
    if (!asked) return;
    const index = this.data.hoops[0].t.findIndex((t) => t >= Number(asked[1]));
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
    this.picture.draw(this.now, this.camera);
    this.words.show(this.now, this.picture.metre);
    requestAnimationFrame((next) => this.tick(next));
  }
}

try {
  new Player(unpacked(element("data").textContent));
} catch (error) {
  // mostly because there is no WebGL
  element("problem").textContent = (error as Error).message;
  element("problem").style.display = "flex";
}
