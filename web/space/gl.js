// What drawing in space needs of WebGL: programs and meshes.

/**
 * @param {WebGLRenderingContext} gl
 * @param {string} vertex
 * @param {string} fragment
 */
export function makeProgram(gl, vertex, fragment) {
  const program = gl.createProgram();
  /** @type {[number, string][]} */
  const sources = [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ];
  for (const [kind, text] of sources) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(String(gl.getShaderInfoLog(shader)));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(String(gl.getProgramInfoLog(program)));
  /** @type {Program} */
  const places = { program, uniforms: {}, attributes: {} };
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
    const { name } = /** @type {WebGLActiveInfo} */ (gl.getActiveUniform(program, i));
    places.uniforms[name] = gl.getUniformLocation(program, name);
  }
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); i++) {
    const { name } = /** @type {WebGLActiveInfo} */ (gl.getActiveAttrib(program, i));
    places.attributes[name] = gl.getAttribLocation(program, name);
  }
  return places;
}

/**
 * @param {WebGLRenderingContext} gl
 * @param {number[]} data
 * @param {Record<string, number>} parts name and size of what stands behind each other for a vertex
 * @param {number[]} [indices]
 * @returns {Mesh}
 */
export function mesh(gl, data, parts, indices) {
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

/**
 * @param {WebGLRenderingContext} gl
 * @param {Program} program
 * @param {Mesh} made
 */
export function bind(gl, program, made) {
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

/**
 * @param {number} columns
 * @param {number} rows
 */
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

/**
 * Ring and tube angles only: the shader bends them into the rim.
 * @param {WebGLRenderingContext} gl
 */
export function torusMesh(gl, around = 120, across = 14) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    for (let j = 0; j <= across; j++) data.push((2 * Math.PI * i) / around, (2 * Math.PI * j) / across);
  }
  return mesh(gl, data, { bend: 2 }, grid(around, across));
}

/** @param {WebGLRenderingContext} gl */
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

/**
 * A cylinder or cone of length 1 and radius 1 along y.
 * @param {WebGLRenderingContext} gl
 * @param {number} top
 */
export function coneMesh(gl, top, around = 20) {
  const data = [];
  for (let i = 0; i <= around; i++) {
    const a = (2 * Math.PI * i) / around;
    const side = [Math.cos(a), 1 - top, Math.sin(a)];
    data.push(Math.cos(a), 0, Math.sin(a), ...side, top * Math.cos(a), 1, top * Math.sin(a), ...side);
  }
  return mesh(gl, data, { position: 3, normal: 3 }, grid(around, 1));
}
