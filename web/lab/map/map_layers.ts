// The computed parts of a map, the finer over the coarser: pictures, legend, and what a place holds.

import { parsed, SPEED_COLORS, SPEED_GRADIENT } from "../common/colors.ts";
import { cellPicture, h } from "../common/dom.ts";
import { clamp, extent } from "../common/clamp.ts";
import { DEGREE, show, withUnit } from "../common/numbers.ts";
import { spoken, t } from "../words/words.ts";
import type { MapAxes } from "./map_axes.ts";

const MOST = 12; // layers that are kept
// Quantities whose colours begin at zero.
const FROM_ZERO = ["hop_height", "flight_time", "energy_lost", "greatest_utilization"];

/** How a quantity's numbers are shown: by which factor, in which unit. */
function units(header: MapHeader): [number, string] {
  if (header.unit === "rad") return [1 / DEGREE, "°"];
  return [1, header.unit === "1" ? "" : header.unit];
}

/** The least and the greatest number, for the ends of the colours. */
function limits({ classes, what }: MapHeader, values: Float32Array) {
  const [low, high] = extent(classes ? [] : values);
  return [FROM_ZERO.includes(what) ? Math.min(low, 0) : low, high];
}

/** A reply as a picture of one pixel a cell. */
export function layerOf({ header, arrays }: Reply<MapHeader>) {
  const values: Float32Array = arrays.values;
  const { x, y, classes } = header;
  const [low, high] = limits(header, values);
  const palette = classes?.map(({ color }) => parsed(color));
  const picture = cellPicture(x.cells, y.cells, (cell) => {
    const value = values[cell];
    if (!Number.isFinite(value)) return null;
    if (!palette) return SPEED_COLORS[clamp(Math.round((255 * (value - low)) / (high - low || 1)), 0, 255)];
    // a class ends where a neighbour is another: a darker edge tells pale ones apart
    const [right, above] = [cell + 1, cell + x.cells];
    const edge = (right % x.cells && values[right] !== value) || (above < values.length && values[above] !== value);
    return edge ? palette[value].map((part) => 0.72 * part) : palette[value];
  });
  return { picture, header, values, x: [x.from, x.to], y: [y.from, y.to], low, high };
}

/** One layer on a canvas. */
export function paint(context: CanvasRenderingContext2D, { picture, x, y }: MapLayer, axes: MapAxes) {
  const [x0, x1] = x.map((value) => axes.x(value));
  const [y0, y1] = y.map((value) => axes.y(value));
  context.drawImage(picture, x0, y1, x1 - x0, y0 - y1);
}

/** A layer over others, without those that it covers whole. */
export function stacked(layers: MapLayer[], layer: MapLayer) {
  const inside = (a: number[], b: number[]) => a[0] >= b[0] - 1e-300 && a[1] <= b[1] + 1e-300;
  const kept = layers.filter((old) => !(inside(old.x, layer.x) && inside(old.y, layer.y)));
  return [...kept, layer].slice(-MOST);
}

/** What the colours of a layer mean. */
export function legendOf({ header, low, high, values }: MapLayer): (HTMLElement | string)[] {
  const { classes } = header;
  if (!classes) {
    const [scale, unit] = units(header);
    return [
      h("span", header.label, ": ", high >= low ? show(low * scale, 3) : "map.none", " "),
      h("span.bar", { style: `background: ${SPEED_GRADIENT}` }),
      h("span", high >= low ? withUnit(show(high * scale, 3), unit) : ""),
      values.some((value) => !Number.isFinite(value)) ? h("span", h("i.blank"), "map.none") : "",
    ];
  }
  const counts = new Map();
  for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
  const order = [...counts].filter(([code]) => code >= 0).sort((a, b) => b[1] - a[1]);
  return [
    ...order.slice(0, 10).map(([code]) => {
      const { color, text } = classes[code];
      return h("span", h("i", { style: `background:${color}`, "aria-hidden": "true" }), text);
    }),
    order.length > 10 ? h("span", { key: "map.more_classes", values: { count: order.length - 10 } }) : "",
    classes.some(({ name }) => header.what === "sequence" && /[SK]/.test(name))
      ? h("span.hint", "map.forward_names")
      : "",
  ];
}

/** The finest layer that covers a place, and the cell there. */
function covering(layers: MapLayer[], place: Place) {
  for (const layer of [...layers].reverse()) {
    const [column, row] = (["x", "y"] as const).map((name) => {
      const { from, to, cells } = layer.header[name];
      return Math.floor(((place[name] - from) / (to - from)) * cells);
    });
    const { x, y } = layer.header;
    if (column >= 0 && row >= 0 && column < x.cells && row < y.cells) return { layer, column, row };
  }
  return null;
}

/** From where to where the cell of a place goes. */
export function cellAt(layers: MapLayer[], place: Place) {
  const found = covering(layers, place);
  if (!found) return null;
  const ends = ({ from, to, cells }: MapHeader["x"], k: number) =>
    [k, k + 1].map((end) => from + (end / cells) * (to - from));
  const { x, y } = found.layer.header;
  return { x: ends(x, found.column), y: ends(y, found.row) };
}

/** What a place holds, in words. */
export function textAt(layers: MapLayer[], place: Place) {
  const found = covering(layers, place);
  if (!found) return "…";
  const { header, values } = found.layer;
  const value = values[found.row * header.x.cells + found.column];
  if (header.classes) return spoken(header.classes[value]?.text ?? "map.not_allowed");
  const [scale, unit] = units(header);
  return Number.isFinite(value) ? withUnit(show(value * scale, 4), unit) : t("map.none");
}
