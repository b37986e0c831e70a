// Numbers and ranges kept where they belong.

export const clamp = (value: number, least: number, most: number) => Math.min(Math.max(value, least), most);

/** What is left of a value after whole turns of a size. */
export const modulo = (value: number, size: number) => value - size * Math.floor(value / size);

/** The largest of 1, 2 and 5 times powers of ten up to a value. */
export function rounded(value: number) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ([5, 2].find((step) => step * power <= value * 1.000001) ?? 1);
}

/** The least and the greatest of some numbers. */
export function extent(values: Iterable<number>) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}

/** A range moved, and if it must be cut, so that it lies within bounds. */
export function within([low, high]: number[], [least, most]: number[]) {
  const size = Math.min(high - low, most - least);
  if (low < least) return [least, least + size];
  if (high > most) return [most - size, most];
  return [low, high];
}

/** A range that is `factor` times as wide about a value. */
export const scaled = ([low, high]: number[], center: number, factor: number) => [
  center - (center - low) * factor,
  center + (high - center) * factor,
];
