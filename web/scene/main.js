// Plays a scene of hoops in space, in a page that holds all that it needs.

import { Camera } from "./camera.js";
import { unpacked } from "./data.js";
import { Picture } from "./picture.js";
import { Words } from "./words.js";

const element = (id) => document.getElementById(id);

class Player {
  constructor(data) {
    this.data = data;
    this.last = data.count - 1;
    this.now = 0;
    this.before = null;
    this.button = element("play");
    this.slider = element("time");
    this.rate = element("rate");
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

  // A link that ends in #t=1.05 opens at that time.
  open(hash) {
    const asked = /t=([\d.]+)/.exec(hash);
    if (!asked) return;
    const index = this.data.hoops[0].t.findIndex((t) => t >= Number(asked[1]));
    this.now = index < 0 ? this.last : index;
    this.slider.value = String(this.now);
    this.play(false);
  }

  play(on) {
    this.playing = on;
    this.button.textContent = on ? "Pause" : "Play";
  }

  toggle() {
    if (!this.playing && this.now >= this.last) this.now = 0;
    this.play(!this.playing);
  }

  key(event) {
    if (event.target.tagName === "SELECT" || event.target === this.button) return;
    if (event.key === " ") {
      this.toggle();
      event.preventDefault();
    }
    const way = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!way || event.target === this.slider) return;
    this.play(false);
    this.now = Math.min(Math.max(Math.round(this.now) + way, 0), this.last);
  }

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
    this.words.show(this.now);
    requestAnimationFrame((next) => this.tick(next));
  }
}

try {
  new Player(unpacked(element("data").textContent));
} catch (error) {
  // mostly because there is no WebGL
  element("problem").textContent = error.message;
  element("problem").style.display = "flex";
}
