// Hoops on a plane in space, for the page and for the films that turn.
//
// Coordinates are those of the plane: x along it, y away from it, z towards the viewer; the view tilts them. Places are
// given relative to what the camera looks at, since single precision has no digits left far out.

import {
  along,
  looking,
  minus,
  perspective,
  product,
  tilted,
  unit,
  bind,
  coneMesh,
  makeProgram,
  mesh,
  sphereMesh,
  torusMesh,
} from "./gl.ts";

const SHADE = `
  uniform vec3 sun, eye;
  vec3 shaded(vec3 color, vec3 normal) {
    vec3 n = normalize(normal);
    float light = 0.43 + 0.44 * max(dot(n, sun), 0.0) + 0.24 * abs(dot(n, eye));
    float gloss = 0.24 * pow(max(dot(n, normalize(eye + sun)), 0.0), 24.0);
    return color * light + vec3(gloss);
  }`;
const FLAT = `
  uniform vec3 slant;
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.0 ? p - p.y * slant : p;
  }`;
const SHADOW = "vec4(0.0, 0.0, 0.0, shadow)";
const SUN = [0.35, 0.85, 0.4]; // the way to the light
const DARK = 0.18; // of a shadow

const RIM = [
  `attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${FLAT}
   void main() {
     float phi = size.w + bend.x;
     vec2 outwards = vec2(sin(phi), cos(phi));
     vec3 p = center + vec3(outwards * (size.x - size.y + size.y * cos(bend.y)), size.z * sin(bend.y));
     n = vec3(outwards * cos(bend.y) / size.y, sin(bend.y) / size.z);
     vec2 v = motion.xy + motion.z * size.x * vec2(cos(phi), -sin(phi));
     speed = length(v) / most;
     gl_Position = view * vec4(flattened(p, shadow), 1.0);
   }`,
  `precision highp float;
   varying vec3 n; varying float speed;
   uniform sampler2D colors; uniform vec3 plain; uniform float colored, shadow;
   ${SHADE}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.0 ? ${SHADOW} : vec4(shaded(color, n), 1.0);
   }`,
];

const BODY = [
  `attribute vec3 position, normal;
   uniform mat4 view, model; uniform float shadow;
   varying vec3 n;
   ${FLAT}
   void main() {
     n = mat3(model) * normal;
     gl_Position = view * vec4(flattened((model * vec4(position, 1.0)).xyz, shadow), 1.0);
   }`,
  `precision highp float;
   varying vec3 n; uniform vec3 color; uniform float shadow;
   ${SHADE}
   void main() { gl_FragColor = shadow > 0.0 ? ${SHADOW} : vec4(shaded(color, n), 1.0); }`,
];

// Lines as wide as pixels: each point twice, pushed apart across the line on the screen.
const LINE = [
  `attribute vec3 position, next, tint; attribute float side;
   uniform mat4 view; uniform vec2 pixel; uniform float width, shift, depth;
   varying vec3 color;
   void main() {
     vec3 moved = vec3(-shift, 0.0, depth);
     vec4 a = view * vec4(position + moved, 1.0);
     vec4 b = view * vec4(next + moved, 1.0);
     vec2 way = (b.xy / b.w - a.xy / a.w) / pixel;
     float size = length(way);
     vec2 across = size > 1e-6 ? vec2(-way.y, way.x) / size : vec2(0.0, 1.0);
     a.xy += across * side * width * pixel * a.w;
     gl_Position = a;
     color = tint;
   }`,
  `precision highp float; varying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }`,
];

function contextOf(canvas: HTMLCanvasElement) {
  // the picture can be copied
  const gl = canvas.getContext("webgl", { antialias: true, stencil: true, preserveDrawingBuffer: true });
  if (!gl) throw new Error("This browser draws nothing in space (WebGL is missing).");
  return gl;
}

export class Space {
  eye: Vector = [0, 0, 1];
  fastest = 1;
  gl = contextOf(this.canvas);
  sun = unit(SUN);
  slant = [SUN[0] / SUN[1], 1, SUN[2] / SUN[1]];
  rim = makeProgram(this.gl, RIM);
  body = makeProgram(this.gl, BODY);
  line = makeProgram(this.gl, LINE);
  torus = torusMesh(this.gl);
  sphere = sphereMesh(this.gl);
  cylinder = coneMesh(this.gl, 1);
  cone = coneMesh(this.gl, 0);
  view: Matrix = tilted(0);

  /** `speeds`: the colours of the rim from rest to the fastest. */
  constructor(
    public canvas: HTMLCanvasElement,
    speeds: number[][],
  ) {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    const pixels = new Uint8Array(speeds.flatMap((color) => [...color, 255]));
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, speeds.length, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    for (const way of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, way, gl.LINEAR);
  }

  /**
   * An empty picture of the canvas' size, and the camera: `eye` and `target` are level, `angle` is that of the view.
   */
  begin({ background, eye, target, slope, angle, near, far }: View & { background: Vector }) {
    const { gl, canvas } = this;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(background[0], background[1], background[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const lens = perspective(angle, canvas.width / canvas.height, near, far);
    this.view = product(product(lens, looking(eye, target)), tilted(slope));
    this.eye = unit(minus(eye, target));
  }

  use(program: Program, values: Named<number | Vector | Matrix>) {
    const { gl } = this;
    gl.useProgram(program.program);
    const all: Named = { view: this.view, sun: this.sun, eye: this.eye, slant: this.slant, ...values };
    for (const [name, value] of Object.entries(all)) {
      const place = program.uniforms[name];
      if (place === undefined) continue;
      if (typeof value === "number") gl.uniform1f(place, value);
      else if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
      else gl[`uniform${value.length}fv` as "uniform3fv"](place, value);
    }
  }

  /** What lies on the plane is painted over each other in its order, and hides only what is below the plane. */
  ground(paint: () => void) {
    const { gl } = this;
    gl.depthFunc(gl.ALWAYS);
    paint();
    gl.depthFunc(gl.LESS);
  }

  /** Each point of the floor is darkened once, however many things stand above it. */
  shadows(paint: () => void) {
    const { gl } = this;
    gl.enable(gl.BLEND);
    // the picture stays opaque
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.depthFunc(gl.ALWAYS);
    gl.depthMask(false);
    paint();
    gl.depthMask(true);
    gl.depthFunc(gl.LESS);
    gl.disable(gl.STENCIL_TEST);
    gl.disable(gl.BLEND);
  }

  solid(shape: Mesh, model: Matrix, color: Vector, shadow = false) {
    const { gl } = this;
    this.use(this.body, { model, color, shadow: shadow ? DARK : 0 });
    bind(gl, this.body, shape);
    gl.drawElements(gl.TRIANGLES, shape.count, gl.UNSIGNED_SHORT, 0);
  }

  ball(place: Vector, radius: number, color: Vector, shadow: boolean) {
    this.solid(this.sphere, along(place, [0, 1, 0], radius, radius), color, shadow);
  }

  /**
   * `tube` and `broad` are half the rim's thickness and half its breadth; `plain` is its colour where speed has none.
   */
  ring({ center, radius, tube, broad, angle, velocity, omega, plain = null }: Ring, shadow: boolean) {
    const { gl } = this;
    this.use(this.rim, {
      center,
      size: [radius, tube, broad, angle],
      motion: [...velocity, omega],
      most: this.fastest,
      shadow: shadow ? DARK : 0,
      plain: plain ?? [0, 0, 0],
      colored: plain ? 0 : 1,
    });
    bind(gl, this.rim, this.torus);
    gl.drawElements(gl.TRIANGLES, this.torus.count, gl.UNSIGNED_SHORT, 0);
  }

  rod(from: Vector, way: Vector, length: number, radius: number, color: Vector, shadow = false) {
    this.solid(this.cylinder, along(from, way, length, radius), color, shadow);
  }

  /** A force at a hoop of radius `R`, `length` long along `way`. */
  arrow(from: Vector, way: Vector, length: number, R: number, color: Vector) {
    if (!(length > 0.02 * R)) return;
    const head = Math.min(0.18 * R, length);
    const tip = from.map((value, i) => value + way[i] * (length - head));
    if (length > head) this.rod(from, way, length - head, 0.029 * R, color);
    this.solid(this.cone, along(tip, way, head, Math.min(0.075 * R, 0.6 * head)), color);
  }

  /** A line through points of the plane, each with its colour. */
  trace(count: number, point: (i: number) => number[], tint: (i: number) => Vector) {
    const data = [];
    for (let i = 0; i < count; i++) {
      const here = point(i);
      let next = point(Math.min(i + 1, count - 1));
      if (Math.hypot(next[0] - here[0], next[1] - here[1]) < 1e-9 && i > 0) {
        const before = point(i - 1);
        next = here.map((value, k) => 2 * value - before[k]);
      }
      for (const side of [-1, 1]) data.push(...here, 0, ...next, 0, ...tint(i), side);
    }
    return mesh(this.gl, data, { position: 3, next: 3, tint: 3, side: 1 });
  }

  /** So many points of a trace, moved back by `shift` and into its lane, `width` pixels to each side. */
  drawTrace(made: Mesh, count: number, place: { width: number; shift: number; depth: number }) {
    const { gl, canvas } = this;
    this.use(this.line, { pixel: [2 / canvas.width, 2 / canvas.height], ...place });
    bind(gl, this.line, made);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 2 * count);
  }

  /** Where a point is in the picture, as shares of its width and height from its upper left; null behind the camera. */
  onScreen([x, y, z]: Vector) {
    const m = this.view;
    const [a, b, w] = [0, 1, 3].map((row) => m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]);
    return w > 0 ? [0.5 + (0.5 * a) / w, 0.5 - (0.5 * b) / w] : null;
  }
}
