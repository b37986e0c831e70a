// Small helpers: elements, numbers, colours.

export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "class") element.className = value;
    else if (name in element && name !== "list" && typeof value !== "string") element[name] = value;
    else element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat()) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child.nodeType ? child : document.createTextNode(String(child)));
  }
  return element;
}

// Also inside a shadow tree, where notebooks put widgets.
export const focused = (element) => element.getRootNode().activeElement === element;

export const clamp = (value, least, most) => Math.min(Math.max(value, least), most);

// A number as a reader wants it: so many significant digits, no trailing zeros, a real minus sign.
export function show(value, digits = 4) {
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    text = `${trimZeros(mantissa)}·10${superscript(Number(exponent))}`;
  } else {
    text = trimZeros(value.toPrecision(digits));
    if (text.includes("e")) text = String(Math.round(value));
  }
  return text.replace("-", "−");
}

function trimZeros(text) {
  return text.includes(".") && !text.includes("e") ? text.replace(/\.?0+$/, "") : text;
}

function superscript(number) {
  const signs = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
  return [...String(number)].map((sign) => signs[sign]).join("");
}

export const withUnit = (text, unit) => (unit ? (unit === "°" ? `${text}°` : `${text} ${unit}`) : text);

export const degrees = (angle) => `${((angle * 180) / Math.PI).toFixed(1)}°`.replace("-", "−");

// A length in the unit in which it reads well.
export function length(metres) {
  const size = Math.abs(metres);
  const [scale, unit] = size >= 0.995 ? [1, "m"] : size >= 0.00995 ? [100, "cm"] : [1000, "mm"];
  return withUnit(show(metres * scale, 3), unit);
}

// Round steps for an axis: 1, 2 or 5 times a power of ten.
export function niceStep(span, count) {
  const rough = span / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const share = rough / power;
  return (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1) * power;
}

export function ticks(low, high, count) {
  if (!(high > low) || !Number.isFinite(low) || !Number.isFinite(high)) return [];
  const step = niceStep(high - low, count);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && found.length < 200; k++) {
    found.push(k * step);
  }
  return found;
}

// Label of a tick with as many decimals as the step between ticks needs.
export function tickText(value, step) {
  const decimals = clamp(-Math.floor(Math.log10(step) + 1e-9), 0, 15);
  const size = Math.max(Math.abs(value), step);
  if (size >= 1e6 || decimals > 12) return show(value, 3);
  return (Math.abs(value) < step * 1e-6 ? 0 : value).toFixed(decimals).replace("-", "−");
}

// A canvas as large as its box, in device pixels; returns its 2D context scaled to CSS pixels.
export function fitted(canvas) {
  const box = canvas.getBoundingClientRect();
  const ratio = Math.min(globalThis.devicePixelRatio || 1, 2.5);
  const width = Math.max(Math.round(box.width * ratio), 1);
  const height = Math.max(Math.round(box.height * ratio), 1);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, width: width / ratio, height: height / ratio };
}

export function parsed(color) {
  const value = Number.parseInt(color.slice(1, 7), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

// Dark or light writing, whichever is easier to read on the colour.
export const writing = (color) => (luminance(color) > 0.2 ? "#111111" : "#ffffff");

export const faded = (color, opacity) => `rgba(${parsed(color).join(",")},${opacity})`;

const channel = (value) => {
  const share = value / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
};

function luminance(color) {
  const [r, g, b] = parsed(color).map(channel);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

// The colour, lightened until a line of it stands out from dark paper; black gives way to ink.
export function readable(color, dark) {
  if (!dark || !/^#[0-9a-f]{6}$/i.test(color)) return color;
  if (luminance(color) < 0.002) return "#eceef2";
  let lighter = color;
  for (let share = 0; luminance(lighter) < 0.2 && share < 1; share += 0.05) {
    lighter = `#${parsed(color)
      .map((value) => Math.round(value + (255 - value) * share).toString(16).padStart(2, "0"))
      .join("")}`;
  }
  return lighter;
}

// Small pictures for the buttons of the player; no font needs to have them.
const ICONS = {
  play: "M5 3l9 5.5L5 14z",
  pause: "M4 3h3.4v11H4zM9.6 3H13v11H9.6z",
  start: "M3 3h2v11H3zM14 3v11L6 8.5z",
  back: "M11.5 3.5v10L4.5 8.5z",
  on: "M5.5 3.5v10l7-5z",
  previous: "M8.5 3.5v10l-6-5zM15 3.5v10l-6-5z",
  next: "M2 3.5v10l6-5zM8.5 3.5v10l6-5z",
  undo: "M6 2.5L2 6.5l4 4V8h4.2a2.3 2.3 0 0 1 0 4.6H6v2h4.2a4.3 4.3 0 0 0 0-8.6H6z",
  redo: "M11 2.5l4 4-4 4V8H6.8a2.3 2.3 0 0 0 0 4.6H11v2H6.8a4.3 4.3 0 0 1 0-8.6H11z",
  two: "M4.3 5a3.6 3.6 0 1 0 .01 0zM12.7 5a3.6 3.6 0 1 0 .01 0z",
  theme: "M8.5 2a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2v9a4.5 4.5 0 0 1 0-9z",
};

export function icon(name) {
  const space = "http://www.w3.org/2000/svg";
  const picture = document.createElementNS(space, "svg");
  picture.setAttribute("viewBox", "0 0 17 17");
  picture.setAttribute("aria-hidden", "true");
  picture.setAttribute("class", "icon");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", ICONS[name]);
  picture.append(path);
  return picture;
}

// Viridis, from nine of its colours.
const VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];

function viridis() {
  const colors = [];
  for (let k = 0; k < 256; k++) {
    const place = (k / 255) * (VIRIDIS.length - 1);
    const low = Math.min(Math.floor(place), VIRIDIS.length - 2);
    const one = parsed(VIRIDIS[low]);
    const two = parsed(VIRIDIS[low + 1]);
    colors.push(one.map((value, i) => Math.round(value + (two[i] - value) * (place - low))));
  }
  return colors;
}

export const SPEED_COLORS = viridis();
export const SPEED_TEXTS = SPEED_COLORS.map((color) => `rgb(${color.join(",")})`);

export function theme(element) {
  const style = getComputedStyle(element);
  const read = (name) => style.getPropertyValue(name).trim();
  return {
    ink: read("--ink"),
    soft: read("--soft"),
    line: read("--line"),
    paper: read("--paper"),
    panel: read("--panel"),
    ground: read("--ground"),
    font: read("--font"),
    dark: read("--dark") === "1",
  };
}

// One press: `move` follows the finger, `end` gets the last event and whether the finger was lifted (or taken away).
export function follow(element, event, move, end = () => {}) {
  const leave = new AbortController();
  const { signal } = leave;
  const on = (kind, action) =>
    element.addEventListener(kind, (other) => other.pointerId === event.pointerId && action(other), { signal });
  const finish = (lifted) => (last) => {
    leave.abort();
    end(last, lifted);
  };
  element.setPointerCapture(event.pointerId);
  on("pointermove", move);
  on("pointerup", finish(true));
  on("pointercancel", finish(false));
}

// Two fingers zoom: `zoom` gets the factor by which they have spread and the point between them. The function that
// comes back tells whether two fingers are down; what one finger does has to wait then.
export function pinch(element, zoom) {
  const fingers = new Map();
  let before = null;
  const measured = () => {
    const [a, b] = [...fingers.values()];
    return {
      span: Math.max(Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY), 1),
      clientX: 0.5 * (a.clientX + b.clientX),
      clientY: 0.5 * (a.clientY + b.clientY),
    };
  };
  element.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") return;
    fingers.set(event.pointerId, event);
    before = fingers.size === 2 ? measured() : null;
  });
  element.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    fingers.set(event.pointerId, event);
    if (fingers.size !== 2 || !before) return;
    const now = measured();
    zoom(now.span / before.span, now);
    before = now;
  });
  for (const kind of ["pointerup", "pointercancel"]) {
    element.addEventListener(kind, (event) => {
      fingers.delete(event.pointerId);
      before = null;
    });
  }
  // the page neither scrolls nor zooms under two fingers
  const still = (event) => event.touches.length > 1 && event.cancelable && event.preventDefault();
  element.addEventListener("touchmove", still, { passive: false });
  return () => fingers.size > 1;
}

export function saveBlob(blob, name) {
  const link = h("a", { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function once(callback, wait) {
  let timer = 0;
  return (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => callback(...values), wait);
  };
}
