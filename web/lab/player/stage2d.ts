// The hoops on their planes, one below the other, as they are looked at.

import { hoopInk } from "../common/colors.ts";
import { scaledContext } from "../common/dom.ts";
import { clamp } from "../common/clamp.ts";
import { follow, zoomable } from "../common/pointer.ts";
import { Scene } from "./scene2d.ts";

export class Stage2D {
  zoom = 1;
  shift: number[] = [0, 0];
  /** The picture of each hoop as it was drawn last, for what lies over it. */
  views: Scene[] = [];
  /** The scale while the hoop is held: it must not slip out of the hand. */
  fixed: number | null = null;

  /** A moment of one hoop that is pointed at. */
  pointed: { time: number; lane: number } | null = null;
  /** Where words lie over the picture. */
  covered: DOMRect[] = [];
  /** Takes what is under the pointer, if there is anything to take. */
  grab: (event: PointerEvent) => boolean = () => false;
  /** What is drawn over a hoop's picture. */
  over: (scene: Scene, lane: number) => void = () => {};
  pinched = zoomable(this.canvas, {
    zoom: (factor) => this.zoomBy(factor),
    home: () => this.reset(),
    chosen: () => this.canvas.parentElement,
  });

  constructor(
    public canvas: HTMLCanvasElement,
    readonly onview: () => void,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.drag(event));
  }

  reset() {
    this.zoom = 1;
    this.shift = [0, 0];
    this.onview();
  }

  /** How far the picture is moved, in its own width and height. */
  pan(): [number, number] {
    const { width, height } = this.canvas.getBoundingClientRect();
    return [this.shift[0] / (width || 1), this.shift[1] / (height || 1)];
  }

  look(zoom = 1, [along, down]: [number, number] = [0, 0]) {
    const { width, height } = this.canvas.getBoundingClientRect();
    this.zoom = zoom;
    this.shift = [along * width, down * height];
  }

  zoomBy(factor: number) {
    this.zoom = clamp(this.zoom * factor, 0.05, 60);
    this.onview();
  }

  drag(event: PointerEvent) {
    if (this.grab(event)) return;
    const start = [event.clientX, event.clientY];
    const before = this.shift;
    follow(this.canvas, event, (moved: PointerEvent) => {
      if (this.pinched()) return;
      this.shift = [before[0] + moved.clientX - start[0], before[1] + moved.clientY - start[1]];
      this.onview();
    });
  }

  draw(films: Film[], time: number, options: StageOptions, look: Look, colors: Colors) {
    const { context, width, height } = scaledContext(this.canvas);
    if (width < 40 || height < 40) return; // not laid out yet
    this.views = this.paint(context, width, height, films, time, options, look, colors, this.covered);
  }

  /** The picture as it is looked at now, on any canvas. Returns one for each hoop. */
  paint(
    context: CanvasRenderingContext2D,
    width: number,
    height: number,
    films: Film[],
    time: number,
    options: StageOptions,
    look: Look,
    colors: Colors,
    covered: DOMRect[] = [],
  ): Scene[] {
    const each = height / films.length;
    // two hoops are drawn to one scale, in length and in colour
    const common = {
      top: Math.max(...films.map((film) => film.extent.top)),
      radius: Math.max(...films.map((film) => film.radius)),
      speed: Math.max(...films.map((film) => film.extent.speed)),
    };
    return films.map((film, i) => {
      context.save();
      context.beginPath();
      context.rect(0, i * each, width, each);
      context.clip();
      context.translate(0, i * each);
      const scene = new Scene(context, width, each, film, time, options, look, colors, this.zoom, this.shift, common);
      scene.top = i * each;
      scene.covered = covered;
      scene.scale = this.fixed ?? scene.scale;
      scene.draw();
      if (this.pointed?.lane === i) scene.ghost(film.at(this.pointed.time));
      this.over(scene, i);
      if (films.length > 1) {
        scene.mark("AB"[i], hoopInk(i, look.dark));
        context.fillStyle = hoopInk(i, look.dark);
        context.font = `700 ${17 * look.px}px ${look.font}`;
        context.textAlign = "left";
        context.fillText("AB"[i], 12, each - 12);
      }
      context.restore();
      if (i > 0) {
        context.fillStyle = look.line;
        context.fillRect(0, i * each - 0.5, width, 1);
      }
      return scene;
    });
  }
}
