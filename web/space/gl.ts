// What drawing in space needs of WebGL: programs and meshes.

import { parsed } from "../lab/common/colors.ts";

/** `sources`: of the vertex shader and of the fragment shader. */
export function makeProgram(gl: WebGLRenderingContext, sources: string[]) {
  const program = gl.createProgram();
  for (const [k, kind] of [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].entries()) {
    const shader = gl.createShader(kind) as WebGLShader;
    gl.shaderSource(shader, sources[k]);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(String(gl.getShaderInfoLog(shader)));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(String(gl.getProgramInfoLog(program)));
  const places: Program = { program, uniforms: {}, attributes: {} };
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
    const { name } = gl.getActiveUniform(program, i) as WebGLActiveInfo;
    places.uniforms[name] = gl.getUniformLocation(program, name);
  }
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); i++) {
    const { name } = gl.getActiveAttrib(program, i) as WebGLActiveInfo;
    places.attributes[name] = gl.getAttribLocation(program, name);
  }
  return places;
}

/** `parts`: name and size of what stands behind each other for a vertex. */
export function mesh(gl: WebGLRenderingContext, data: number[], parts: Named<number>, indices?: number[]) {
  const vertices = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
  const elements = indices ? gl.createBuffer() : null;
  if (indices) {
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(indices), gl.STATIC_DRAW);
  }
  const stride = 4 * Object.values(parts).reduce((sum, size) => sum + size, 0);
  return { vertices, elements, parts, stride, count: indices ? indices.length : (4 * data.length) / stride };
}

export function bind(gl: WebGLRenderingContext, program: Program, made: Mesh) {
  gl.bindBuffer(gl.ARRAY_BUFFER, made.vertices);
  let offset = 0;
  for (const [name, size] of Object.entries(made.parts)) {
    const place = program.attributes[name];
    if (place !== undefined) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, made.stride, offset);
    }
    offset += 4 * size;
  }
  if (made.elements) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, made.elements);
}

function grid(columns: number, rows: number) {
  const indices = [];
  for (let i = 0; i < columns; i++) {
    for (let j = 0; j < rows; j++) {
      const a = i * (rows + 1) + j;
      const b = a + rows + 1;
      indices.push(a, b, a + 1, b, b + 1, a + 1);
    }
  }
  return indices;
}

/** Ring and tube angles only: the shader bends them into the rim. */
export function torusMesh(gl: WebGLRenderingContext, around = 120, across = 14) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    for (let j = 0; j <= across; j++) data.push((2 * Math.PI * i) / around, (2 * Math.PI * j) / across);
  }
  return mesh(gl, data, { bend: 2 }, grid(around, across));
}

export function sphereMesh(gl: WebGLRenderingContext, around = 28, rows = 18) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    for (let j = 0; j <= rows; j++) {
      const [a, b] = [(2 * Math.PI * i) / around, (Math.PI * j) / rows];
      const point = [Math.sin(b) * Math.cos(a), Math.cos(b), Math.sin(b) * Math.sin(a)];
      data.push(...point, ...point);
    }
  }
  return mesh(gl, data, { position: 3, normal: 3 }, grid(around, rows));
}

/** A cylinder or cone of length 1 and radius 1 along y. */
export function coneMesh(gl: WebGLRenderingContext, top: number, around = 20) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    const a = (2 * Math.PI * i) / around;
    const side = [Math.cos(a), 1 - top, Math.sin(a)];
    data.push(Math.cos(a), 0, Math.sin(a), ...side, top * Math.cos(a), 1, top * Math.sin(a), ...side);
  }
  return mesh(gl, data, { position: 3, normal: 3 }, grid(around, 1));
}

// --- Vectors of three, matrices of four columns of four as WebGL takes them, and colours from 0 to 1

/** The matrix that does first what the second one does. */
export const product = (a: Matrix, b: Matrix): Matrix =>
  DOMMatrix.fromFloat32Array(a).multiply(DOMMatrix.fromFloat32Array(b)).toFloat32Array();

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
export const rgb = (color: string) => parsed(color).map((part) => part / 255);
