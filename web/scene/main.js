// Plays a scene of hoops in space, in a page that holds all that it needs.

import { Camera } from "./camera.js";
import { unpacked } from "./data.js";
import { Picture } from "./picture.js";
import { Words } from "./words.js";

/** @type {(id: string) => any} */
const element = (id) => document.getElementById(id);

class Player {
  /** @param {SceneData} data */
  constructor(data) {
    this.data = data;
    this.last = data.count - 1;
    this.now = 0;
    /** @type {number | null} */
    this.before = null;
    /** @type {HTMLButtonElement} */
    this.button = element("play");
    /** @type {HTMLInputElement} */
    this.slider = element("time");
    /** @type {HTMLSelectElement} */
    this.rate = element("rate");
    /** @type {HTMLInputElement} */
    this.follow = element("follow");
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

  /**
   * A link that ends in #t=1.05 opens at that time.
   * @param {string} hash
   */
  open(hash) {
    const asked = /t=([\d.]+)/.exec(hash);
    if (!asked) return;
    const index = this.data.hoops[0].t.findIndex((t) => t >= Number(asked[1]));
    this.now = index < 0 ? this.last : index;
    this.slider.value = String(this.now);
    this.play(false);
  }

  /** @param {boolean} on */
  play(on) {
    this.playing = on;
    if (!on) this.now = Math.floor(this.now); // a still picture is that of its numbers
    this.button.textContent = on ? "Pause" : "Play";
  }

  toggle() {
    if (!this.playing && this.now >= this.last) this.now = 0;
    this.play(!this.playing);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (/** @type {Element} */ (event.target).tagName === "SELECT" || event.target === this.button) return;
    if (event.key === " ") {
      this.toggle();
      event.preventDefault();
    }
    const way = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!way || event.target === this.slider) return;
    this.play(false);
    this.now = Math.min(Math.max(Math.round(this.now) + way, 0), this.last);
  }

  /** @param {number} clock [ms] */
  tick(clock) {
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
  element("problem").textContent = /** @type {Error} */ (error).message;
  element("problem").style.display = "flex";
}
