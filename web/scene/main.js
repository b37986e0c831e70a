// Plays a scene of hoops with WebGL alone. World: X level, Y into the picture, Z up, metres.
const data = unpack(JSON.parse(document.getElementById("data").textContent));
const canvas = document.getElementById("scene");
const labels = document.getElementById("labels");
const gl = canvas.getContext("webgl", { antialias: true });
const STATIONS = 128, SECTIONS = 16, TUBE = 0.05, LOAD = 0.1, HEAVY = 0.05;
const SUN = unit([0.32, 0.75, -1.0]);
const R = data.radius;

function unpack(value) {
  if (Array.isArray(value)) return value.map(unpack);
  if (value === null || typeof value !== "object") return value;
  if (value.f32 !== undefined) {
    const bytes = Uint8Array.from(atob(value.f32), (letter) => letter.charCodeAt(0));
    return new Float32Array(bytes.buffer);
  }
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, unpack(each)]));
}

// --- vectors and matrices (columns first) ------------------------------------------------------

function unit(a) { const l = Math.hypot(...a) || 1; return a.map((x) => x / l); }
function dot(a, b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
function multiply(a, b) {
  const out = new Float32Array(16);
  for (let j = 0; j < 4; j++) for (let i = 0; i < 4; i++) {
    let sum = 0;
    for (let k = 0; k < 4; k++) sum += a[k * 4 + i] * b[j * 4 + k];
    out[j * 4 + i] = sum;
  }
  return out;
}
function frame(x, y, z, origin) {
  return new Float32Array([...x, 0, ...y, 0, ...z, 0, ...origin, 1]);
}
function moved(origin) { return frame([1, 0, 0], [0, 1, 0], [0, 0, 1], origin); }
function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2), d = 1 / (near - far);
  return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) * d, -1, 0, 0, 2 * far * near * d, 0]);
}
function lookAt(eye, target) {
  const z = unit([eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]]);
  const x = unit(cross([0, 0, 1], z)), y = cross(z, x);
  return new Float32Array([x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0,
    -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
}
function paint(color) { return [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16) / 255); }
function mix(a, b, share) { return a.map((x, i) => x + share * (b[i] - x)); }
function world(along, above, lane) {
  const c = Math.cos(data.slope), s = Math.sin(data.slope);
  return [along * c + above * s, lane, above * c - along * s];
}

// --- meshes ------------------------------------------------------------------------------------

function surface(rows, columns, point) {
  const points = [], normals = [], faces = [];
  for (let i = 0; i <= rows; i++) for (let j = 0; j <= columns; j++) {
    const [p, n] = point(i / rows, j / columns);
    points.push(...p); normals.push(...n);
  }
  for (let i = 0; i < rows; i++) for (let j = 0; j < columns; j++) {
    const a = i * (columns + 1) + j, b = a + columns + 1;
    faces.push(a, b, b + 1, a, b + 1, a + 1);
  }
  return { points, normals, faces };
}
function torus(radius) {
  return surface(STATIONS, SECTIONS, (u, v) => {
    const a = 2 * Math.PI * u, b = 2 * Math.PI * v, out = [Math.sin(a), 0, Math.cos(a)];
    const n = [Math.cos(b) * out[0], Math.sin(b), Math.cos(b) * out[2]];
    return [out.map((x, i) => radius * ((1 - TUBE) * x + TUBE * n[i])), n];
  });
}
function ball(radius) {
  return surface(28, 18, (u, v) => {
    const a = 2 * Math.PI * u, b = Math.PI * v;
    const n = [Math.cos(a) * Math.sin(b), Math.sin(a) * Math.sin(b), Math.cos(b)];
    return [n.map((x) => radius * x), n];
  });
}
function rod(narrow) { // along X, from 0 to 1, of radius 1; a cone if narrow
  return surface(1, 24, (u, v) => {
    const a = 2 * Math.PI * v, r = narrow ? 1 - u : 1;
    return [[u, r * Math.cos(a), r * Math.sin(a)], [narrow ? 0.4 : 0, Math.cos(a), Math.sin(a)]];
  });
}
function tube(way, radius, lane) { // a trace: five sides are enough for a thin line
  const n = way.length / 2, sides = 5;
  return surface(Math.max(n - 1, 1), sides, (u, v) => {
    const i = Math.min(Math.round(u * Math.max(n - 1, 1)), n - 1);
    const a = Math.max(i - 1, 0), b = Math.min(i + 1, n - 1);
    const along = unit([way[2 * b] - way[2 * a], way[2 * b + 1] - way[2 * a + 1]]);
    const angle = 2 * Math.PI * v, c = Math.cos(angle), s = Math.sin(angle);
    const normal = [-along[1] * c, s, along[0] * c];
    return [[way[2 * i] + radius * normal[0], lane + radius * s, way[2 * i + 1] + radius * normal[2]], normal];
  });
}

const VERTEX = `
attribute vec3 point; attribute vec3 normal; attribute vec3 shade;
uniform mat4 view; uniform mat4 model; uniform vec3 color; uniform float shaded;
varying vec3 vNormal; varying vec3 vColor;
void main() {
  gl_Position = view * model * vec4(point, 1.0);
  vNormal = mat3(model[0].xyz, model[1].xyz, model[2].xyz) * normal;
  vColor = mix(color, shade, shaded);
}`;
const FRAGMENT = `
precision mediump float;
varying vec3 vNormal; varying vec3 vColor;
uniform vec3 sun; uniform vec3 eye; uniform float lit;
void main() {
  vec3 n = normalize(vNormal);
  float light = 0.45 + 0.4 * max(dot(n, -sun), 0.0) + 0.3 * abs(dot(n, eye));
  float gloss = 0.25 * pow(max(dot(n, normalize(eye - sun)), 0.0), 24.0);
  gl_FragColor = vec4(mix(vColor, vColor * light + gloss, lit), 1.0);
}`;

let program, places;
function build() {
  program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  places = {};
  for (const name of ["point", "normal", "shade"]) places[name] = gl.getAttribLocation(program, name);
  for (const name of ["view", "model", "color", "shaded", "sun", "eye", "lit"]) {
    places[name] = gl.getUniformLocation(program, name);
  }
}
const wide = gl?.getExtension("OES_element_index_uint");
function upload(mesh) {
  const buffer = (kind, values) => {
    const made = gl.createBuffer();
    gl.bindBuffer(kind, made);
    gl.bufferData(kind, values, gl.STATIC_DRAW);
    return made;
  };
  const Index = wide ? Uint32Array : Uint16Array;
  return {
    point: buffer(gl.ARRAY_BUFFER, new Float32Array(mesh.points)),
    normal: buffer(gl.ARRAY_BUFFER, new Float32Array(mesh.normals)),
    faces: buffer(gl.ELEMENT_ARRAY_BUFFER, new Index(mesh.faces)),
    count: mesh.faces.length,
    shade: mesh.shades ? buffer(gl.ARRAY_BUFFER, new Float32Array(mesh.shades)) : null,
  };
}
function draw(mesh, model, color, lit = 1, count = mesh.count, shaded = mesh.shade !== null) {
  for (const name of ["point", "normal", "shade"]) {
    if (mesh[name] && (name !== "shade" || shaded)) {
      gl.bindBuffer(gl.ARRAY_BUFFER, mesh[name]);
      gl.enableVertexAttribArray(places[name]);
      gl.vertexAttribPointer(places[name], 3, gl.FLOAT, false, 0, 0);
    } else {
      gl.disableVertexAttribArray(places[name]);
    }
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.faces);
  gl.uniformMatrix4fv(places.model, false, model);
  gl.uniform3fv(places.color, color);
  gl.uniform1f(places.shaded, shaded ? 1 : 0);
  gl.uniform1f(places.lit, lit);
  gl.drawElements(gl.TRIANGLES, count, wide ? gl.UNSIGNED_INT : gl.UNSIGNED_SHORT, 0);
}

// --- the scene ---------------------------------------------------------------------------------

const theme = data.theme, ground = paint(theme.ground), ink = paint(theme.ink);
const lanes = Math.max(...data.hoops.map((hoop) => Math.abs(hoop.lane)));
const half = lanes + 1.1 * R;
const normal = world(0, 1, 0);
let plane, track, bars, shaft, head;

function sheet(low, high, near, far, lift) {
  const corners = [[low, near], [high, near], [high, far], [low, far]].map(([s, y]) => world(s, lift * R, y));
  return { points: corners.flat(), normals: [0, 1, 2, 3].flatMap(() => normal), faces: [0, 1, 2, 0, 2, 3] };
}
function marks() {
  const first = Math.ceil((data.along[0] - 6 * R) / data.grid), found = [];
  for (let k = first; k * data.grid <= data.along[1] + 6 * R && found.length < 2000; k++) found.push(k);
  return found;
}
function populate() {
  const low = data.along[0] - 40 * R, high = data.along[1] + 40 * R;
  plane = upload(sheet(low, high, -40 * R, 40 * R, -0.014));
  track = upload(sheet(low, high, -half, half, -0.009));
  const lines = { points: [], normals: [], faces: [] };
  for (const k of marks()) {
    const part = sheet(k * data.grid - 0.008 * R, k * data.grid + 0.008 * R, -half, half, -0.006);
    lines.faces.push(...part.faces.map((i) => i + lines.points.length / 3));
    lines.points.push(...part.points);
    lines.normals.push(...part.normals);
  }
  bars = upload(lines);
  shaft = upload(rod(false));
  head = upload(rod(true));
  for (const hoop of data.hoops) {
    const ring = torus(hoop.radius);
    ring.shades = new Float32Array(ring.points.length);
    hoop.shades = ring.shades;
    hoop.ring = upload(ring);
    hoop.ballMesh = upload(ball(LOAD * hoop.radius));
    hoop.beadMesh = upload(ball(HEAVY * hoop.radius));
    if (hoop.traces === null) continue;
    hoop.loadTrace = upload(tube(hoop.traces.load, 0.011 * R, hoop.lane));
    const heavy = tube(hoop.traces.heavy, 0.016 * R, hoop.lane);
    const [calm, red] = [paint(data.colors.center), paint(data.colors.airborne)];
    heavy.shades = hoop.traces.airborne.flatMap((flies) => Array(6).fill(flies ? red : calm).flat());
    hoop.heavyTrace = upload(heavy);
  }
}

// --- camera ------------------------------------------------------------------------------------

const HOME = { turn: -0.35, rise: 0.2, away: 7 * R + 2 * lanes + 1.5 * data.height, shift: [0, 0, 0] };
let view = { ...HOME, shift: [...HOME.shift] }, target = null;

function cameraAt(now) {
  const follow = document.getElementById("follow").checked;
  const middle = 0.5 * (data.along[0] + data.along[1]);
  const wanted = follow
    ? data.hoops.reduce((sum, hoop) => sum + at(hoop.center, now, 2, 0) / data.hoops.length, 0) / Math.cos(data.slope)
    : middle;
  // the film's camera lags a little behind: what moves by fits and starts is followed calmly
  target = target === null ? wanted : target + (wanted - target) * 0.12;
  const spot = world(target, 0.95 * R, 0).map((x, i) => x + view.shift[i]);
  const c = Math.cos(view.rise);
  const away = [Math.sin(view.turn) * c, -Math.cos(view.turn) * c, Math.sin(view.rise)];
  return { eye: spot.map((x, i) => x + view.away * away[i]), spot, away };
}

// --- one instant -------------------------------------------------------------------------------

function at(values, now, width, part) {
  const i = Math.min(Math.floor(now), data.count - 1), j = Math.min(i + 1, data.count - 1), s = now - i;
  return values[i * width + part] * (1 - s) + values[j * width + part] * s;
}
function flattened() {
  const along = dot(normal, SUN), columns = [];
  for (let j = 0; j < 3; j++) columns.push([0, 1, 2].map((i) => (i === j ? 1 : 0) - SUN[i] * normal[j] / along));
  return frame(...columns, normal.map((x) => 0.002 * R * x));
}
function color(hoop, now) {
  const vx = at(hoop.velocity, now, 2, 0), vy = at(hoop.velocity, now, 2, 1);
  const turning = hoop.radius * at(hoop.omega, now, 1, 0);
  const top = data.map.length - 1;
  for (let i = 0; i <= STATIONS; i++) {
    const phi = 2 * Math.PI * i / STATIONS - data.slope;
    const speed = Math.hypot(vx + turning * Math.cos(phi), vy - turning * Math.sin(phi));
    const place = Math.min(Math.max(speed / data.topSpeed, 0), 1) * top, k = Math.min(Math.floor(place), top - 1);
    for (let part = 0; part < 3; part++) {
      const value = data.map[k][part] + (place - k) * (data.map[k + 1][part] - data.map[k][part]);
      for (let j = 0; j <= SECTIONS; j++) hoop.shades[3 * (i * (SECTIONS + 1) + j) + part] = value / 255;
    }
  }
  gl.bindBuffer(gl.ARRAY_BUFFER, hoop.ring.shade);
  gl.bufferSubData(gl.ARRAY_BUFFER, 0, hoop.shades);
}
function arrow(tail, along, length, paintOf) {
  if (Math.abs(length) < 0.02 * R) return;
  const x = along.map((part) => part * Math.sign(length)), y = [0, 1, 0], z = cross(x, y);
  const whole = Math.abs(length), point = Math.min(0.2 * R, whole), thick = 0.03 * R;
  const times = (a, s) => a.map((part) => part * s);
  const neck = tail.map((part, i) => part + x[i] * (whole - point));
  if (whole > point) draw(shaft, frame(times(x, whole - point), times(y, thick), times(z, thick), tail), paintOf);
  const broad = Math.min(2.4 * thick, 0.6 * point);
  draw(head, frame(times(x, point), times(y, broad), times(z, broad), neck), paintOf);
}
function show(now) {
  const ratio = window.devicePixelRatio || 1;
  const w = Math.round(canvas.clientWidth * ratio), h = Math.round(canvas.clientHeight * ratio);
  for (const each of [canvas, labels]) if (each.width !== w || each.height !== h) { each.width = w; each.height = h; }
  gl.viewport(0, 0, w, h);
  const camera = cameraAt(now);
  const angle = w > h ? 0.56 : 0.9;
  const matrix = multiply(perspective(angle, w / h, 0.05 * view.away, 12 * view.away + 60 * R),
    lookAt(camera.eye, camera.spot));
  gl.clearColor(...paint(theme.background), 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.uniformMatrix4fv(places.view, false, matrix);
  gl.uniform3fv(places.sun, SUN);
  gl.uniform3fv(places.eye, unit(camera.away));
  const still = moved([0, 0, 0]);
  draw(plane, still, ground, 0);
  draw(track, still, mix(ground, ink, 0.06), 0);
  draw(bars, still, mix(ground, ink, 0.25), 0);
  const flat = flattened(), shade = mix(ground, [0, 0, 0], 0.38);
  for (const hoop of data.hoops) {
    const center = [at(hoop.center, now, 2, 0), hoop.lane, at(hoop.center, now, 2, 1)];
    const turned = at(hoop.angle, now, 1, 0) + data.slope, arm = [Math.sin(turned), 0, Math.cos(turned)];
    const on = (reach) => center.map((x, i) => x + reach * arm[i]);
    const load = moved(on(hoop.load)), ring = moved(center);
    const airborne = hoop.mode[Math.floor(now)] === "H";
    color(hoop, now);
    draw(hoop.ring, multiply(flat, ring), shade, 0, hoop.ring.count, false);
    draw(hoop.ballMesh, multiply(flat, load), shade, 0);
    draw(hoop.ring, ring, ink);
    draw(hoop.ballMesh, load, paint(theme.load));
    draw(hoop.beadMesh, moved(on(hoop.heavy)), paint(airborne ? data.colors.airborne : data.colors.center));
    if (hoop.traces !== null) {
      const t = at(hoop.t, now, 1, 0), times = hoop.traces.t;
      let past = times.findIndex((each) => each > t);
      if (past < 0) past = times.length;
      const faces = Math.max(past - 1, 0) * 5 * 6;
      draw(hoop.loadTrace, still, paint(theme.load), 0.3, Math.min(faces, hoop.loadTrace.count));
      draw(hoop.heavyTrace, still, ink, 0.3, Math.min(faces, hoop.heavyTrace.count));
    }
    if (data.newton > 0) {
      const tail = [at(hoop.contact, now, 2, 0), hoop.lane - (TUBE + 0.04) * hoop.radius, at(hoop.contact, now, 2, 1)];
      const k = Math.floor(now); // forces jump; they are not drawn in between
      arrow(tail, normal, data.newton * hoop.normalForce[k], paint(data.colors.normal));
      arrow(tail, world(1, 0, 0), data.newton * hoop.frictionForce[k], paint(data.colors.friction));
    }
  }
  number(matrix, w, h, ratio);
  say(now);
}
function number(matrix, w, h, ratio) {
  const pen = labels.getContext("2d");
  pen.clearRect(0, 0, w, h);
  pen.fillStyle = theme.muted;
  pen.textAlign = "center";
  pen.font = `${13 * ratio}px "DejaVu Sans", system-ui, sans-serif`;
  let last = -1e9;
  for (const k of marks()) {
    const p = [...world(k * data.grid, 0, -half - 0.15 * R), 1], q = [0, 0, 0, 0];
    for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++) q[i] += matrix[j * 4 + i] * p[j];
    if (q[3] <= 0) continue;
    const x = (q[0] / q[3] * 0.5 + 0.5) * w, y = (0.5 - q[1] / q[3] * 0.5) * h;
    if (x < 0 || x > w || y < 0 || y > h - 50 * ratio || Math.abs(x - last) < 55 * ratio) continue;
    pen.fillText(`${+(k * data.grid).toPrecision(6)} m`.replace("-", "−"), x, y + 12 * ratio);
    last = x;
  }
}

// --- words, controls ---------------------------------------------------------------------------

const rows = [];
function furnish() {
  document.body.style.background = theme.background;
  document.body.style.color = theme.ink;
  for (const hoop of data.hoops) {
    const row = document.createElement("div");
    row.className = "row";
    row.innerHTML = '<span class="mode"><span class="dot"></span><span class="word"></span></span>' +
      '<span class="t"></span><span class="angle"></span><span class="label"></span>';
    row.querySelector(".label").textContent = hoop.label;
    document.getElementById("words").append(row);
    rows.push(row);
  }
  const stops = data.map.map((c) => `rgb(${c.join(",")})`).join(",");
  document.getElementById("bar").style.background = `linear-gradient(to right, ${stops})`;
  const power = 10 ** Math.floor(Math.log10(data.topSpeed / 3));
  const step = [5, 2, 1].map((x) => x * power).find((x) => x <= data.topSpeed / 3 * 1.000001);
  for (let value = 0; value <= data.topSpeed; value += step) {
    const tick = document.createElement("span");
    tick.textContent = +value.toPrecision(6);
    tick.style.left = `${100 * value / data.topSpeed}%`;
    document.getElementById("ticks").append(tick);
  }
  const key = [];
  if (data.hoops.some((hoop) => hoop.traces !== null)) {
    key.push([theme.load, "load"], [data.colors.center, "centre of gravity"], [data.colors.airborne, "airborne"]);
  }
  if (data.newton > 0) key.push([data.colors.normal, "normal force"], [data.colors.friction, "friction"]);
  for (const [tint, word] of key) {
    const line = document.createElement("span"), swatch = document.createElement("i");
    swatch.style.borderColor = tint;
    line.append(swatch, word);
    document.getElementById("lines").append(line);
  }
}
function say(now) {
  data.hoops.forEach((hoop, i) => {
    const [word, tint] = data.modes[hoop.mode[Math.floor(now)]], row = rows[i];
    row.querySelector(".dot").style.background = tint;
    row.querySelector(".word").textContent = word;
    row.querySelector(".t").textContent = `t = ${at(hoop.t, now, 1, 0).toFixed(3)} s`;
    const degrees = (at(hoop.angle, now, 1, 0) * 180 / Math.PI).toFixed(1);
    row.querySelector(".angle").textContent = `θ = ${degrees}°`.replace("-", "−");
  });
}

let now = 0, playing = true, before = null;
const slider = document.getElementById("time"), button = document.getElementById("play");
slider.max = data.count - 1;
function play(on) {
  playing = on;
  button.textContent = on ? "Pause" : "Play";
}
button.onclick = () => { if (!playing && now >= data.count - 1) now = 0; play(!playing); };
slider.oninput = () => { now = Number(slider.value); play(false); };
document.getElementById("reset").onclick = () => { view = { ...HOME, shift: [...HOME.shift] }; };
document.addEventListener("keydown", (event) => {
  if (event.target.tagName === "SELECT" || event.target === button) return;
  if (event.key === " ") { button.onclick(); event.preventDefault(); }
  const steps = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (steps && event.target !== slider) {
    play(false);
    now = Math.min(Math.max(Math.round(now) + steps, 0), data.count - 1);
  }
});

const fingers = new Map();
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, event);
});
for (const name of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(name, (event) => fingers.delete(event.pointerId));
}
canvas.addEventListener("pointermove", (event) => {
  const old = fingers.get(event.pointerId);
  if (!old) return;
  const dx = event.clientX - old.clientX, dy = event.clientY - old.clientY;
  if (fingers.size === 2) {
    const [other] = [...fingers.values()].filter((each) => each.pointerId !== event.pointerId);
    const span = (a) => Math.hypot(a.clientX - other.clientX, a.clientY - other.clientY);
    closer(span(old) / Math.max(span(event), 1));
  } else if (event.shiftKey || event.buttons === 2) {
    const scale = view.away / canvas.clientHeight;
    view.shift[0] -= dx * scale * Math.cos(view.turn);
    view.shift[1] -= dx * scale * Math.sin(view.turn);
    view.shift[2] += dy * scale;
  } else {
    view.turn -= dx * 0.008;
    view.rise = Math.min(Math.max(view.rise + dy * 0.006, 0.02), 1.5);
  }
  fingers.set(event.pointerId, event);
});
function closer(factor) { view.away = Math.min(Math.max(view.away * factor, 2 * R), 200 * R); }
canvas.addEventListener("wheel", (event) => { closer(Math.exp(event.deltaY * 0.001)); event.preventDefault(); },
  { passive: false });
canvas.addEventListener("contextmenu", (event) => event.preventDefault());

function tick(clock) {
  if (playing && before !== null) {
    now += (clock - before) / 1000 * data.fps * Number(document.getElementById("rate").value);
    if (now >= data.count - 1) { now = data.count - 1; play(false); }
    slider.value = now;
  }
  before = clock;
  show(now);
  requestAnimationFrame(tick);
}

if (!gl) {
  document.getElementById("problem").style.display = "flex";
} else {
  build();
  populate();
  furnish();
  // a link that ends in #t=1.05 opens at that time
  const asked = /t=([\d.]+)/.exec(location.hash);
  if (asked) {
    const index = data.hoops[0].t.findIndex((t) => t >= Number(asked[1]));
    now = index < 0 ? data.count - 1 : index;
    slider.value = now;
    play(false);
  }
  requestAnimationFrame(tick);
}
