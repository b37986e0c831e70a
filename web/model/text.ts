// Numbers and texts as Python writes them, and its templates filled.

const LONGEST = 60; // characters of a value that a sentence shows
const DIGITS = 100; // the most that JavaScript gives

/** A text that stands in a sentence as it is. */
export class Shown {
  constructor(public text: string) {}
}

/** A number as Python's `repr(float)`. */
export function floatText(value: number) {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  const sign = value < 0 || Object.is(value, -0) ? "-" : "";
  const [mantissa, power] = Math.abs(value).toExponential().split("e");
  const digits = mantissa.replace(".", "");
  const place = Number(power);
  if (place < -4 || place >= 16) return `${sign}${mantissa}e${powerText(place)}`;
  return sign + (place < 0 ? `0.${"0".repeat(-place - 1)}${digits}` : pointed(digits, place + 1));
}

/** `whole`: how many stand before the point. */
function pointed(digits: string, whole: number) {
  const long = digits.padEnd(whole, "0");
  return `${long.slice(0, whole)}.${long.slice(whole) || "0"}`;
}

const powerText = (power: number) => `${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;

/**
 * So many significant digits, an exact half to even as Python rounds it: digits without a point, and the power of the
 * first. `size`: at least 0.
 */
function rounded(size: number, count: number): [string, number] {
  const [mantissa, power] = size.toExponential(count - 1).split("e");
  const digits = mantissa.replace(".", "");
  const all = size.toExponential(DIGITS).split("e")[0].replace(".", "");
  const half = all[count] === "5" && /^0*$/.test(all.slice(count + 1));
  // at a half JavaScript rounds up
  if (half && Number(all[count - 1]) % 2 === 0) {
    return [all.slice(0, count), Number(size.toExponential(DIGITS).split("e")[1])];
  }
  return [digits, Number(power)];
}

function special(value: number) {
  return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

const signOf = (value: number) => (value < 0 || Object.is(value, -0) ? "-" : "");

/** Python's format 'g': so many significant digits, no zeros at the end. */
export function general(value: number, count = 6) {
  if (!Number.isFinite(value)) return special(value);
  const sign = signOf(value);
  if (value === 0) return `${sign}0`;
  const [digits, power] = rounded(Math.abs(value), count);
  const short = digits.replace(/0+$/, "") || "0";
  if (power < -4 || power >= count) {
    return `${sign}${short[0]}${short.length > 1 ? `.${short.slice(1)}` : ""}e${powerText(power)}`;
  }
  if (power < 0) return `${sign}0.${"0".repeat(-power - 1)}${short}`;
  const [whole, rest] = pointed(digits, power + 1).split(".");
  const tail = rest.replace(/0+$/, "");
  return `${sign}${whole}${tail && `.${tail}`}`;
}

/** Python's format 'e'. */
function exponential(value: number, decimals: number) {
  if (!Number.isFinite(value)) return special(value);
  const [digits, power] = value === 0 ? ["0".repeat(decimals + 1), 0] : rounded(Math.abs(value), decimals + 1);
  const tail = digits.slice(1);
  return `${signOf(value)}${digits[0]}${tail && `.${tail}`}e${powerText(power)}`;
}

/** Python's format 'f'. */
export function fixed(value: number, decimals: number) {
  if (!Number.isFinite(value)) return special(value);
  const size = Math.abs(value);
  // beyond that every double is a whole number, which JavaScript would write with a power
  if (size >= 1e21) return `${signOf(value)}${BigInt(size)}${decimals ? `.${"0".repeat(decimals)}` : ""}`;
  const text = size.toFixed(decimals);
  const all = size.toFixed(DIGITS);
  const tail = all.slice(all.indexOf(".") + 1 + decimals);
  const cut = all.slice(0, all.indexOf(".") + (decimals ? 1 + decimals : 0));
  if (/^50*$/.test(tail) && Number(cut.at(-1)) % 2 === 0) return signOf(value) + cut;
  return signOf(value) + text;
}

/** The values of a template of Python's as texts: of `{name}`, `{name!r}`, `{name:.3g}`. What is said already stays. */
export function written(template: string, values: Record<string, any>): Values {
  const one = (value: any, [, , quoted, digits, kind]: string[]) => {
    if (value?.key || typeof value === "function") return value;
    if (value instanceof Shown) return plain(value.text);
    if (quoted) return pythonText(value);
    if (kind === "g") return general(value, digits === "" ? 6 : Number(digits) || 1);
    if (kind === "e") return exponential(value, Number(digits));
    if (kind === "f") return fixed(value, Number(digits));
    return typeof value === "number" ? value : plain(String(value));
  };
  const places = [...template.matchAll(/\{(\w+)(!r)?(?::\.?(\d*)([gef]))?\}/g)];
  return Object.fromEntries(places.map((place) => [place[1], one(values[place[1]], place)]));
}

/**
 * A value as Python's `repr`. `value`: of JSON; `float`: whether a number without a fraction is one with a point, as
 * in a link, or whole, as JSON writes it.
 */
export function pythonText(value: any, float = true): string {
  if (value === null || value === undefined) return "None";
  if (value === true) return "True";
  if (value === false) return "False";
  if (typeof value === "number") return float ? floatText(value) : numberText(value);
  if (typeof value === "string") return quotedText(value);
  if (Array.isArray(value)) return `[${value.map((item) => pythonText(item, float)).join(", ")}]`;
  const pairs = Object.entries(value).map(([key, item]) => `${quotedText(key)}: ${pythonText(item, float)}`);
  return `{${pairs.join(", ")}}`;
}

/** A number as Python shows what it reads from the JSON that a page writes. */
function numberText(value: number) {
  const text = Object.is(value, -0) ? "0" : String(value);
  return /^-?\d+$/.test(text) ? text : floatText(value);
}

/** A value as Python's `json.dumps`. `value`: of JSON. */
export function jsonText(value: any): string {
  if (typeof value === "number") return numberText(value);
  if (typeof value === "string") {
    return JSON.stringify(value).replace(/[\u007f-\uffff]/g, (sign) => `\\u${hex(sign.charCodeAt(0), 4)}`);
  }
  if (Array.isArray(value)) return `[${value.map(jsonText).join(", ")}]`;
  if (value && typeof value === "object") {
    return `{${Object.entries(value)
      .map(([key, item]) => `${jsonText(key)}: ${jsonText(item)}`)
      .join(", ")}}`;
  }
  return String(value);
}

const hex = (code: number, width: number) => code.toString(16).padStart(width, "0");

// As Python's str.isprintable: no control, format, private or unassigned signs, and of the blanks only the plain one.
const UNPRINTABLE = /[\p{C}\p{Zl}\p{Zp}\p{Zs}]/u;

const printable = (sign: string) => sign === " " || !UNPRINTABLE.test(sign);

function escaped(sign: string) {
  if (sign === "\n") return "\\n";
  if (sign === "\r") return "\\r";
  if (sign === "\t") return "\\t";
  const code = sign.codePointAt(0) as number;
  if (code < 0x100) return `\\x${hex(code, 2)}`;
  return code < 0x10000 ? `\\u${hex(code, 4)}` : `\\U${hex(code, 8)}`;
}

function quotedText(text: string) {
  const quote = text.includes("'") && !text.includes('"') ? '"' : "'";
  const signs = [...text].map((sign) => {
    if (sign === quote || sign === "\\") return `\\${sign}`;
    return printable(sign) ? sign : escaped(sign);
  });
  return quote + signs.join("") + quote;
}

/** A text that is safe to show: what is no printable sign stands as its escape. */
export const plain = (text: string) => [...text].map((sign) => (printable(sign) ? sign : escaped(sign))).join("");

export function shortened(text: string) {
  const signs = [...text];
  return signs.length <= LONGEST ? text : `${signs.slice(0, LONGEST - 3).join("")}...`;
}

// What Python's float() reads.
const BLANKS = "[\\s\\x1c-\\x1f\\x85]*";
const FLOAT = new RegExp(
  `^${BLANKS}([+-]?)(?:(inf(?:inity)?|nan)|((?:\\d+(?:_\\d+)*\\.?(?:\\d+(?:_\\d+)*)?|\\.\\d+(?:_\\d+)*)(?:e[+-]?\\d+(?:_\\d+)*)?))${BLANKS}$`,
  "i",
);

/** The number that Python's `float(text)` gives, or undefined. */
export function floatOf(text: string) {
  const match = FLOAT.exec(text);
  if (!match || text.includes("\ufeff")) return undefined;
  const [, sign, word, digits] = match;
  const size = word ? (word[0].toLowerCase() === "n" ? Number.NaN : Infinity) : Number(digits.replaceAll("_", ""));
  return sign === "-" ? -size : size;
}
