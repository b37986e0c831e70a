// A motion as Python has written it into the page, in the terms of the player: frames to be shown, and the path to be drawn.

import type { Seen } from "../lab/player/stage3d.ts";

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
