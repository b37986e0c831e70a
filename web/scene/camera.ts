// Where the scene is seen from: it turns, comes closer and moves under mouse and fingers, and follows the hoops.

import { clamp } from "../lab/common/clamp.ts";
import { follow, pinch } from "../lab/common/pointer.ts";
import { between } from "./data.ts";

export class Camera {
  turn: number;
  rise: number;
  away: number;
  shift: number[];
  along: number | null;

  home: { turn: number; rise: number; away: number; shift: number[] };

  constructor(
    canvas: HTMLCanvasElement,
    readonly data: SceneData,
    readonly follows: () => boolean,
  ) {
    // whether it is to follow now
    const lanes = Math.max(...data.hoops.map((hoop) => Math.abs(hoop.lane)));
    this.home = { turn: -0.35, rise: 0.2, away: 7 * data.radius + 2 * lanes + 1.5 * data.height, shift: [0, 0, 0] };
    this.reset();
    this.along = null;
    this.listen(canvas);
  }

  reset() {
    Object.assign(this, this.home, { shift: [...this.home.shift] });
  }

  closer(factor: number) {
    const R = this.data.radius;
    this.away = clamp(this.away * factor, 2 * R, 200 * R);
  }

  /** What is looked at, along the plane: it lags a little behind, so that fits and starts are followed calmly. */
  focus(now: number) {
    const { hoops, along } = this.data;
    const wanted = this.follows()
      ? hoops.reduce((sum, hoop) => sum + between(hoop.center, now, 2) / hoops.length, 0)
      : 0.5 * (along[0] + along[1]);
    this.along = this.along === null ? wanted : this.along + (wanted - this.along) * 0.12;
    return this.along;
  }

  /** Level places, relative to the point of the plane that is looked at. */
  view(wide: boolean): View {
    const { radius: R, slope } = this.data;
    const above = 0.95 * R;
    const target = [above * Math.sin(slope), above * Math.cos(slope), 0].map((value, i) => value + this.shift[i]);
    const level = Math.cos(this.rise);
    const way = [Math.sin(this.turn) * level, Math.sin(this.rise), Math.cos(this.turn) * level];
    return {
      eye: target.map((value, i) => value + this.away * way[i]),
      target,
      slope,
      angle: wide ? 0.56 : 0.9,
      near: 0.05 * this.away,
      far: 12 * this.away + 60 * R,
    };
  }

  listen(canvas: HTMLCanvasElement) {
    const pinched = pinch(canvas, (factor) => this.closer(1 / factor));
    canvas.addEventListener("pointerdown", (event) => {
      let before = event;
      follow(canvas, event, (now) => {
        if (!pinched()) this.drag(canvas, now, now.clientX - before.clientX, now.clientY - before.clientY);
        before = now;
      });
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        this.closer(Math.exp(event.deltaY * 0.001));
        event.preventDefault();
      },
      { passive: false },
    );
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  drag(canvas: HTMLCanvasElement, { shiftKey, buttons }: PointerEvent, dx: number, dy: number) {
    if (shiftKey || buttons === 2) {
      const scale = this.away / canvas.clientHeight;
      this.shift[0] -= dx * scale * Math.cos(this.turn);
      this.shift[1] += dy * scale;
      this.shift[2] += dx * scale * Math.sin(this.turn);
    } else {
      this.turn -= dx * 0.008;
      this.rise = clamp(this.rise + dy * 0.006, 0.02, 1.5);
    }
  }
}
