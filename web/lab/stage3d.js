// The same motion in space.

import { SPEED_COLORS, clamp, focused, follow, parsed, pinch } from "./dom.js";
import {
  along, bind, coneMesh, looking, makeProgram, mesh, perspective, product, sphereMesh, torusMesh,
} from "./gl.js";

const SHADE = `
  vec3 shaded(vec3 color, vec3 normal, vec3 eye) {
    vec3 n = normalize(normal);
    float light = 0.42 + 0.5 * max(dot(n, normalize(vec3(0.35, 0.85, 0.4))), 0.0) + 0.14 * max(dot(n, vec3(0.0, 0.0, 1.0)), 0.0);
    float shine = pow(max(dot(reflect(-normalize(vec3(0.35, 0.85, 0.4)), n), eye), 0.0), 24.0);
    return color * light + vec3(0.22 * shine);
  }`;
const FLAT = `
  vec3 flattened(vec3 p, float shadow) {
    return shadow > 0.5 ? vec3(p.x - p.y * 0.41, 0.004, p.z - p.y * 0.47) : p;
  }`;

const RIM = [
  `attribute vec2 bend;
   uniform mat4 view; uniform vec3 center; uniform vec4 size; uniform vec3 motion; uniform float most, shadow;
   varying vec3 n; varying float speed;
   ${FLAT}
   void main() {
     float phi = size.w + bend.x;
     vec2 out2 = vec2(sin(phi), cos(phi));
     vec3 p = center + vec3(out2 * (size.x - size.y + size.y * cos(bend.y)), size.z * sin(bend.y));
     n = vec3(out2 * cos(bend.y) / size.y, sin(bend.y) / size.z);
     vec2 v = motion.xy + motion.z * size.x * vec2(cos(phi), -sin(phi));
     speed = length(v) / most;
     gl_Position = view * vec4(flattened(p, shadow), 1.0);
   }`,
  `precision highp float;
   varying vec3 n; varying float speed;
   uniform sampler2D colors; uniform vec3 eye, plain; uniform float colored, shadow;
   ${SHADE}
   void main() {
     vec3 color = mix(plain, texture2D(colors, vec2(clamp(speed, 0.002, 0.998), 0.5)).rgb, colored);
     gl_FragColor = shadow > 0.5 ? vec4(0.0, 0.0, 0.0, 0.32) : vec4(shaded(color, n, eye), 1.0);
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
   varying vec3 n; uniform vec3 color, eye; uniform float shadow;
   ${SHADE}
   void main() { gl_FragColor = shadow > 0.5 ? vec4(0.0, 0.0, 0.0, 0.32) : vec4(shaded(color, n, eye), 1.0); }`,
];

const GROUND = [
  `attribute vec2 corner; uniform mat4 view; uniform float reach; varying vec2 p;
   void main() { p = corner * reach; gl_Position = view * vec4(p.x, 0.0, p.y, 1.0); }`,
  `precision highp float;
   varying vec2 p; uniform vec3 light, dark, far; uniform float reach, shift, tile;
   void main() {
     vec2 q = vec2(p.x + shift, p.y) / tile;
     float even = mod(floor(q.x) + floor(q.y), 2.0);
     float away = smoothstep(0.25, 1.0, length(p) / reach);
     gl_FragColor = vec4(mix(mix(dark, light, even), far, away), 1.0);
   }`,
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

const rgb = (color) => parsed(color).map((value) => value / 255);

export class Stage3D {
  constructor(canvas, onview) {
    this.canvas = canvas;
    this.onview = onview;
    const gl = canvas.getContext("webgl", { antialias: true, stencil: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("This browser draws nothing in space (WebGL is missing).");
    this.gl = gl;
    this.rim = makeProgram(gl, ...RIM);
    this.body = makeProgram(gl, ...BODY);
    this.ground = makeProgram(gl, ...GROUND);
    this.line = makeProgram(gl, ...LINE);
    this.torus = torusMesh(gl);
    this.ball = sphereMesh(gl);
    this.rod = coneMesh(gl, 1);
    this.cone = coneMesh(gl, 0);
    this.floor = mesh(gl, [-1, -1, 1, -1, -1, 1, 1, 1], { corner: 2 });
    this.colors = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.colors);
    const pixels = new Uint8Array(SPEED_COLORS.flatMap((color) => [...color, 255]));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    for (const name of ["TEXTURE_WRAP_S", "TEXTURE_WRAP_T"]) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.CLAMP_TO_EDGE);
    for (const name of ["TEXTURE_MIN_FILTER", "TEXTURE_MAG_FILTER"]) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.LINEAR);
    this.turned = { azimuth: 0.5, height: 0.22, distance: 5.2 };
    this.lines = new WeakMap();
    this.share = 1;
    canvas.addEventListener("pointerdown", (event) => this.drag(event));
    canvas.addEventListener("wheel", (event) => {
      if (!(event.ctrlKey || event.shiftKey || focused(canvas.parentElement))) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-(event.deltaY || event.deltaX) * 0.0015));
    }, { passive: false });
    this.pinched = pinch(canvas, (factor) => this.zoomBy(factor));
  }

  zoomBy(factor) {
    if (factor) this.turned.distance = clamp(this.turned.distance / factor, 1.6, 60);
    else Object.assign(this.turned, { azimuth: 0.5, height: 0.22, distance: 5.2 });
    this.onview();
  }

  drag(event) {
    const start = { ...this.turned, x: event.clientX, y: event.clientY };
    follow(this.canvas, event, (moved) => {
      if (this.pinched()) return;
      this.turned.azimuth = clamp(start.azimuth - (moved.clientX - start.x) * 0.008, -1.5, 1.5);
      this.turned.height = clamp(start.height + (moved.clientY - start.y) * 0.006, 0.02, 1.45);
      this.onview();
    });
  }

  // Fewer pixels where the machine draws in software and falls behind.
  quality() {
    const now = performance.now();
    const took = now - (this.before ?? now);
    this.before = now;
    if (took > 0 && took < 200) this.pace = 0.9 * (this.pace ?? 16) + 0.1 * took;
    if (this.pace > 26 && this.share > 0.5) {
      this.share = Math.max(this.share - 0.1, 0.5);
      this.pace = 16;
    }
    return this.share;
  }

  // `running`: a film that runs may lose sharpness, a still picture never.
  draw(films, time, options, look, colors, running) {
    const { gl, canvas } = this;
    const ratio = Math.min(globalThis.devicePixelRatio || 1, 2) * (running ? this.quality() : 1);
    const box = canvas.getBoundingClientRect();
    canvas.width = Math.max(Math.round(box.width * ratio), 1);
    canvas.height = Math.max(Math.round(box.height * ratio), 1);
    gl.viewport(0, 0, canvas.width, canvas.height);
    const far = rgb(look.paper);
    gl.clearColor(...far, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const lead = films[0];
    const pose = lead.at(time);
    const R = lead.radius;
    this.fastest = Math.max(...films.map((film) => film.extent.speed));
    this.focus = Number.isFinite(pose.x) ? pose.x : 0;
    this.camera(lead, pose, R, options);
    this.drawGround(R, look, far);
    const poses = films.map((film) => film.at(time));
    const depth = (lane) => -2.1 * R * lane;
    this.shadows(() => {
      for (const [lane, film] of films.entries()) this.drawHoop(film, poses[lane], depth(lane), options, look, colors, 1);
    });
    films.forEach((film, lane) => {
      this.drawHoop(film, poses[lane], depth(lane), options, look, colors, 0);
      if (options.traces) this.drawTraces(film, poses[lane], depth(lane), look, colors, ratio);
      if (options.forces) this.drawForces(film, poses[lane], depth(lane), colors);
    });
  }

  camera(film, pose, R, options) {
    const { canvas } = this;
    const { azimuth, height, distance } = this.turned;
    const { left, right } = film.extent;
    const far = options.whole ? Math.max(distance * R, 0.85 * (right - left) + 3 * R) : distance * R;
    // lengths in units of R keep the depth buffer's digits for any hoop
    const target = [options.whole ? 0.5 * (left + right) - this.focus : 0, R + 0.45 * (pose.height || 0), 0];
    const cosine = Math.cos(film.slope);
    const sine = Math.sin(film.slope);
    const tilt = new Float32Array([cosine, -sine, 0, 0, sine, cosine, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    const middle = [target[0] * cosine + target[1] * sine, -target[0] * sine + target[1] * cosine, 0];
    const eye = [
      middle[0] + far * Math.sin(azimuth) * Math.cos(height),
      middle[1] + far * Math.sin(height),
      far * Math.cos(azimuth) * Math.cos(height),
    ];
    const lens = perspective(0.75, canvas.width / canvas.height, 0.05 * R, 40 * R + 6 * far);
    this.view = product(product(lens, looking(eye, middle)), tilt);
    const toward = [eye[0] - middle[0], eye[1] - middle[1], eye[2]];
    const size = Math.hypot(...toward);
    this.eye = toward.map((value) => value / size);
    this.reach = 12 * R + 3 * far;
  }

  use(program, values) {
    const { gl } = this;
    gl.useProgram(program.program);
    for (const [name, value] of Object.entries(values)) {
      const place = program.uniforms[name];
      if (place === undefined) continue;
      if (typeof value === "number") gl.uniform1f(place, value);
      else if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
      else gl[`uniform${value.length}f`](place, ...value);
    }
  }

  drawGround(R, look, far) {
    const { gl } = this;
    const base = rgb(look.ground);
    const darker = base.map((value) => value * (look.dark ? 0.82 : 0.94));
    const tile = 0.5 * R;
    this.use(this.ground, {
      view: this.view, reach: this.reach, light: base, dark: darker, far, tile, shift: this.focus % (2 * tile),
    });
    bind(gl, this.ground, this.floor);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  // Each point of the floor is darkened once, however many things stand above it.
  shadows(paint) {
    const { gl } = this;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.depthMask(false);
    paint();
    gl.depthMask(true);
    gl.disable(gl.STENCIL_TEST);
    gl.disable(gl.BLEND);
  }

  solid(shape, model, color, shadow) {
    const { gl } = this;
    this.use(this.body, { view: this.view, model, color, eye: this.eye, shadow });
    bind(gl, this.body, shape);
    gl.drawElements(gl.TRIANGLES, shape.count, gl.UNSIGNED_SHORT, 0);
  }

  drawHoop(film, pose, depth, options, look, colors, shadow) {
    const { gl } = this;
    const R = film.radius;
    const tube = 0.045 * R;
    const center = [pose.x - this.focus, R + pose.height, depth];
    this.use(this.rim, {
      view: this.view, center, size: [R, tube, 3.2 * tube, pose.angle], motion: [pose.vx, pose.vy, pose.omega],
      most: this.fastest, shadow, eye: this.eye, plain: rgb(colors.modes[pose.mode]), colored: options.speed ? 1 : 0,
    });
    bind(gl, this.rim, this.torus);
    gl.drawElements(gl.TRIANGLES, this.torus.count, gl.UNSIGNED_SHORT, 0);
    const at = (distance) => [
      center[0] + distance * Math.sin(pose.angle), center[1] + distance * Math.cos(pose.angle), depth,
    ];
    const ball = (place, radius, color) => this.solid(this.ball, along(place, [0, 1, 0], radius, radius), color, shadow);
    ball(at(R - tube), 0.125 * R, look.dark ? [0.9, 0.91, 0.94] : [0.12, 0.13, 0.15]);
    const way = [Math.sin(pose.angle), Math.cos(pose.angle), 0];
    this.solid(this.rod, along(center, way, R - tube, 0.012 * R), [0.55, 0.57, 0.6], shadow);
    const airborne = pose.mode === "H";
    ball(at(film.eccentricity * R), 0.07 * R, rgb(airborne ? colors.airborne : colors.gravity_center));
  }

  drawForces(film, pose, depth, colors) {
    if (pose.mode === "H" || !(pose.normal_force > 0)) return;
    const R = film.radius;
    const weight = film.mass * (film.gravity || 9.81);
    const front = depth + 0.2 * R;
    const arrow = (way, force, color) => {
      const length = clamp((0.55 * R * Math.abs(force)) / weight, 0, 3.2 * R);
      if (length < 0.03 * R) return;
      const head = Math.min(0.16 * R, length);
      const from = [pose.x - this.focus, pose.height + 0.03 * R, front];
      const tip = from.map((value, i) => value + way[i] * (length - head));
      this.solid(this.rod, along(from, way, length - head, 0.028 * R), color, 0);
      this.solid(this.cone, along(tip, way, head, 0.075 * R), color, 0);
    };
    arrow([0, 1, 0], pose.normal_force, rgb(colors.normal_force));
    arrow([Math.sign(pose.friction_force), 0, 0], pose.friction_force, rgb(colors.friction_force));
  }

  // Load and centre of gravity, built once a film; what lies ahead in time is left out when drawn.
  linesOf(film, look, colors) {
    const kept = this.lines.get(film);
    if (kept?.dark === look.dark) return kept;
    const { gl } = this;
    const R = film.radius;
    const { x, height, angle, mode } = film.columns;
    const build = (distance, tint) => {
      const point = (i) => [x[i] + distance * Math.sin(angle[i]), R + height[i] + distance * Math.cos(angle[i]), 0];
      const data = [];
      for (let i = 0; i < film.length; i++) {
        const here = point(i);
        let next = point(Math.min(i + 1, film.length - 1));
        if (Math.hypot(next[0] - here[0], next[1] - here[1]) < 1e-9 && i > 0) {
          const before = point(i - 1);
          next = here.map((value, k) => 2 * value - before[k]);
        }
        for (const side of [-1, 1]) data.push(...here, ...next, ...tint(mode[i]), side);
      }
      return mesh(gl, data, { position: 3, next: 3, tint: 3, side: 1 });
    };
    const [contact, air, ink] = [rgb(colors.gravity_center), rgb(colors.airborne), rgb(look.ink)];
    const made = {
      dark: look.dark,
      load: build(R, () => ink),
      center: build(film.eccentricity * R, (code) => (code === 3 ? air : contact)),
    };
    this.lines.set(film, made);
    return made;
  }

  drawTraces(film, pose, depth, look, colors, ratio) {
    const { gl, canvas } = this;
    const { load, center } = this.linesOf(film, look, colors);
    const count = 2 * Math.min(film.index(pose.t) + 2, film.length);
    for (const [made, width] of [[load, 1], [center, 1.6]]) {
      this.use(this.line, {
        view: this.view, pixel: [2 / canvas.width, 2 / canvas.height], width: width * ratio, shift: this.focus, depth,
      });
      bind(gl, this.line, made);
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, count);
    }
  }
}
