// The scene as Python has written it into the page, turned into coordinates of the plane.

const read: (value: any) => any = (value) => {
  if (Array.isArray(value)) return value.map(read);
  if (value === null || typeof value !== "object") return value;
  if (value.f32 !== undefined) {
    const bytes = Uint8Array.from(atob(value.f32), (letter) => letter.charCodeAt(0));
    return new Float32Array(bytes.buffer);
  }
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, read(each)]));
};

/** Pairs of a level and an upright part become parts along the plane and away from it. */
function onPlane(pairs: Float32Array, slope: number) {
  const [c, s] = [Math.cos(slope), Math.sin(slope)];
  const turned = new Float32Array(pairs.length);
  for (let i = 0; i < pairs.length; i += 2) {
    turned[i] = pairs[i] * c - pairs[i + 1] * s;
    turned[i + 1] = pairs[i] * s + pairs[i + 1] * c;
  }
  return turned;
}

export function unpacked(text: string): SceneData {
  const data: SceneData = read(JSON.parse(text));
  for (const hoop of data.hoops) {
    for (const name of ["center", "contact", "velocity"] as const) hoop[name] = onPlane(hoop[name], data.slope);
    if (hoop.traces === null) continue;
    for (const name of ["load", "heavy"] as const) hoop.traces[name] = onPlane(hoop.traces[name], data.slope);
  }
  return data;
}

/** A value between two frames; `width` values belong to each frame. */
export function between(values: ArrayLike<number>, now: number, width = 1, part = 0) {
  const i = Math.floor(now);
  const j = Math.min(i + 1, values.length / width - 1);
  const share = now - i;
  return values[i * width + part] * (1 - share) + values[j * width + part] * share;
}
