// Numbers and texts as sentences and files show them, and templates filled.

const LONGEST = 60; // characters of a value that a sentence shows
export const NUMBER = /^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i;
const NO_DIGITS = /^\s*([+-]?)(inf|infinity|nan)\s*$/i;

/** With the fewest digits that give the same double. */
export function numberText(value: number) {
  if (Number.isNaN(value)) return "nan";
  return String(value).replace("Infinity", "inf");
}

/** The same with a point, where numbers without one are of another kind. */
export const floatText = (value: number) => numberText(value).replace(/^-?\d+$/, "$&.0");

/** So many significant digits, no zeros at the end. */
export function general(value: number, count = 6) {
  if (!Number.isFinite(value)) return numberText(value);
  const small = value !== 0 && Math.abs(value) < 1e-4;
  const [digits, ...power] = (small ? value.toExponential(count - 1) : value.toPrecision(count)).split("e");
  return [digits.includes(".") ? digits.replace(/\.?0+$/, "") : digits, ...power].join("e");
}

/** Numbers up to 255 as two digits each. */
export const hex = (parts: Iterable<number>) =>
  Array.from(parts, (part) => Math.round(part).toString(16).padStart(2, "0")).join("");

/** How many units of which a length reads well a metre has, and the unit. */
export function unitOf(metres: number): [number, string] {
  const size = Math.abs(metres);
  return size >= 0.995 ? [1, "m"] : size >= 0.00995 ? [100, "cm"] : [1000, "mm"];
}

/** A power of ten as it is written. */
export const raised = (power: number) =>
  [...String(power)].map((sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)])).join("");

export const fixed = (value: number, decimals: number) =>
  Number.isFinite(value) ? value.toFixed(decimals) : numberText(value);

const FORMATS: Named<(value: number, digits: number) => string> = {
  g: (value, digits) => general(value, digits || 6),
  e: (value, digits) => value.toExponential(digits),
  f: fixed,
};

/** The values of a template of Python's as texts: of `{name}`, `{name!r}`, `{name:.3g}`. What is said already stays. */
export function written(template: string, values: Named): Values {
  const places = template.matchAll(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g);
  const texts = [...places].map(([, name, quoted, digits, kind]): [string, Message] => {
    const value = values[name];
    if (kind) return [name, FORMATS[kind](value, Number(digits))];
    if (value?.key || Array.isArray(value) || typeof value === "number") return [name, quoted ? shown(value) : value];
    return [name, plain(quoted ? shown(value) : String(value))];
  });
  return Object.fromEntries(texts);
}

/** A value as a sentence shows it. */
export function shown(value: any) {
  if (typeof value === "number") return numberText(value);
  if (typeof value === "string") return shortened(`'${value}'`);
  return value === null || value === undefined ? "None" : shortened(JSON.stringify(value));
}

/** A text that is safe to show: what is no printable sign stands as its escape. */
export const plain = (text: string) =>
  text.replace(/[\p{C}\p{Zl}\p{Zp}]/gu, (sign) => `\\u{${sign.codePointAt(0)?.toString(16)}}`);

export function shortened(text: string) {
  const signs = [...text];
  return signs.length <= LONGEST ? text : `${signs.slice(0, LONGEST - 3).join("")}...`;
}

/** The number of a text, or undefined. */
export function numberOf(text: string) {
  if (NUMBER.test(text)) return Number(text);
  const [, sign, word] = NO_DIGITS.exec(text) ?? [];
  if (!word) return undefined;
  return word[0].toLowerCase() === "n" ? Number.NaN : sign === "-" ? -Infinity : Infinity;
}
