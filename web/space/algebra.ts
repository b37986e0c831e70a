// Vectors of three, matrices of four columns of four as WebGL takes them, and colours from 0 to 1.

export function product(a: Matrix, b: Matrix) {
  const out = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
      out[4 * column + row] = sum;
    }
  }
  return out;
}

export function perspective(angle: number, aspect: number, near: number, far: number) {
  const f = 1 / Math.tan(angle / 2);
  const d = 1 / (near - far);
  return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) * d, -1, 0, 0, 2 * far * near * d, 0]);
}

export function looking(eye: number[], target: number[]) {
  const z = unit(minus(eye, target));
  const x = unit(cross([0, 1, 0], z));
  const y = cross(z, x);
  return new Float32Array([
    x[0],
    y[0],
    z[0],
    0,
    x[1],
    y[1],
    z[1],
    0,
    x[2],
    y[2],
    z[2],
    0,
    -dot(x, eye),
    -dot(y, eye),
    -dot(z, eye),
    1,
  ]);
}

export const minus = (a: number[], b: number[]) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a: number[], b: number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: number[], b: number[]) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export function unit(a: number[]) {
  const size = Math.hypot(...a) || 1;
  return [a[0] / size, a[1] / size, a[2] / size];
}

/** A matrix that puts the y axis of a mesh along a direction, with a length and a thickness. */
export function along(from: number[], direction: number[], length: number, thickness: number) {
  const y = unit(direction);
  const x = unit(cross(y, Math.abs(y[2]) > 0.9 ? [1, 0, 0] : [0, 0, 1]));
  const z = cross(x, y);
  return new Float32Array([
    ...x.map((v) => v * thickness),
    0,
    ...y.map((v) => v * length),
    0,
    ...z.map((v) => v * thickness),
    0,
    ...from,
    1,
  ]);
}

/** What turns coordinates of the plane (along it, away from it) into level ones; downhill is to the right. */
export function tilted(slope: number) {
  const [cosine, sine] = [Math.cos(slope), Math.sin(slope)];
  return new Float32Array([cosine, -sine, 0, 0, sine, cosine, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
}

/** '#rrggbb' as three shares. */
export function rgb(color: string) {
  const value = Number.parseInt(color.slice(1, 7), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
