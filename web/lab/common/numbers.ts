// Numbers as a reader wants them, and round steps for axes.

import { raised, unitOf } from "../../model/text.ts";
import { clamp } from "./clamp.ts";
import { local } from "../words/words.ts";

/** A number as a reader wants it: so many significant digits, no trailing zeros, a real minus sign. */
export function show(value: number, digits = 4) {
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text: string;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    text = `${trimZeros(mantissa)}·10${raised(Number(exponent))}`;
  } else {
    text = trimZeros(value.toPrecision(digits));
    if (text.includes("e")) text = String(Math.round(value));
  }
  return local(text.replace("-", "−"));
}

function trimZeros(text: string) {
  return text.includes(".") && !text.includes("e") ? text.replace(/\.?0+$/, "") : text;
}

export const withUnit = (text: string, unit: string) => (unit ? (unit === "°" ? `${text}°` : `${text} ${unit}`) : text);

export const DEGREE = Math.PI / 180;

/** One of a field's unit, in that of the scenario. */
export const sizeOf = (unit: string) => (unit === "°" ? DEGREE : 1);

export const degrees = (angle: number) => local(`${(angle / DEGREE).toFixed(1)}°`.replace("-", "−"));

/** A length in the unit in which it reads well. */
export function length(metres: number) {
  const [scale, unit] = unitOf(metres);
  return withUnit(show(metres * scale, 3), unit);
}

/** Round steps for an axis: 1, 2 or 5 times a power of ten. */
export function niceStep(span: number, count: number) {
  const rough = span / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const share = rough / power;
  return (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1) * power;
}

/** Multiples of a step in a range. */
export function ticks(low: number, high: number, step: number) {
  const found: number[] = [];
  if (!(high > low) || !Number.isFinite(low + high)) return found;
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && found.length < 200; k++) {
    found.push(k * step);
  }
  return found;
}

/** Label of a tick with as many decimals as the step between ticks needs. */
export function tickText(value: number, step: number) {
  const decimals = clamp(-Math.floor(Math.log10(step) + 1e-9), 0, 15);
  const size = Math.max(Math.abs(value), step);
  if (size >= 1e6 || decimals > 12) return show(value, 3);
  return local((Math.abs(value) < step * 1e-6 ? 0 : value).toFixed(decimals).replace("-", "−"));
}
