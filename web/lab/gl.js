// What drawing in space needs: programs, meshes, matrices. No library: the same file serves page and notebook.

export function makeProgram(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const places = { program, uniforms: {}, attributes: {} };
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
    const { name } = gl.getActiveUniform(program, i);
    places.uniforms[name] = gl.getUniformLocation(program, name);
  }
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); i++) {
    const { name } = gl.getActiveAttrib(program, i);
    places.attributes[name] = gl.getAttribLocation(program, name);
  }
  return places;
}

// Matrices are columns of four, as WebGL takes them.
export function product(a, b) {
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

export function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2);
  const d = 1 / (near - far);
  return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) * d, -1, 0, 0, 2 * far * near * d, 0]);
}

export function looking(eye, target) {
  const z = unit(minus(eye, target));
  const x = unit(cross([0, 1, 0], z));
  const y = cross(z, x);
  return new Float32Array([
    x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1,
  ]);
}

export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export function unit(a) {
  const size = Math.hypot(...a) || 1;
  return [a[0] / size, a[1] / size, a[2] / size];
}

// A matrix that puts the y axis of a mesh along a direction, with a length and a thickness.
export function along(from, direction, length, thickness) {
  const y = unit(direction);
  const x = unit(cross(y, Math.abs(y[2]) > 0.9 ? [1, 0, 0] : [0, 0, 1]));
  const z = cross(x, y);
  return new Float32Array([
    ...x.map((v) => v * thickness), 0, ...y.map((v) => v * length), 0, ...z.map((v) => v * thickness), 0, ...from, 1,
  ]);
}

export function mesh(gl, data, parts, indices) {
  const vertices = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, vertices);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
  const elements = indices && gl.createBuffer();
  if (indices) {
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(indices), gl.STATIC_DRAW);
  }
  const stride = 4 * Object.values(parts).reduce((sum, size) => sum + size, 0);
  return { vertices, elements, parts, stride, count: indices ? indices.length : (4 * data.length) / stride };
}

export function bind(gl, { attributes }, made) {
  gl.bindBuffer(gl.ARRAY_BUFFER, made.vertices);
  let offset = 0;
  for (const [name, size] of Object.entries(made.parts)) {
    const place = attributes[name];
    if (place !== undefined) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, made.stride, offset);
    }
    offset += 4 * size;
  }
  if (made.elements) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, made.elements);
}

function grid(columns, rows) {
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

// Ring and tube angles only: the shader bends them into the rim.
export function torusMesh(gl, around = 120, across = 14) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    for (let j = 0; j <= across; j++) data.push((2 * Math.PI * i) / around, (2 * Math.PI * j) / across);
  }
  return mesh(gl, data, { bend: 2 }, grid(around, across));
}

export function sphereMesh(gl, around = 28, rows = 18) {
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

// A cylinder or cone of length 1 and radius 1 along y.
export function coneMesh(gl, top, around = 20) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    const a = (2 * Math.PI * i) / around;
    const side = [Math.cos(a), 1 - top, Math.sin(a)];
    data.push(Math.cos(a), 0, Math.sin(a), ...side, top * Math.cos(a), 1, top * Math.sin(a), ...side);
  }
  return mesh(gl, data, { position: 3, normal: 3 }, grid(around, 1));
}
