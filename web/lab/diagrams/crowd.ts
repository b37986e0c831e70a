// Curves with more samples than pixels: from where to where they go in each column of pixels.

/** Of neighbouring samples in one column. */
export interface Crowd {
  x: number; // of the column
  low: number;
  high: number;
  middle: number; // the mean
  count: number;
}

const MANY = 4; // samples in a column of which a line shows nothing but a block

/** `xs`, `ys`: in pixels; what is not finite parts columns, and gives null. */
export function crowdsOf(xs: ArrayLike<number>, ys: ArrayLike<number>) {
  const crowds: (Crowd | null)[] = [];
  let last = null as Crowd | null;
  for (let i = 0; i < xs.length; i++) {
    const x = Math.floor(xs[i]);
    const y = ys[i];
    if (!Number.isFinite(x + y)) {
      if (last) crowds.push(null);
      last = null;
    } else if (last && last.x === x) {
      last.low = Math.min(last.low, y);
      last.high = Math.max(last.high, y);
      last.middle += (y - last.middle) / ++last.count;
    } else {
      last = { x, low: y, high: y, middle: y, count: 1 };
      crowds.push(last);
    }
  }
  return crowds;
}

/** Whether a line through all samples would be a block. */
export function crowded(crowds: (Crowd | null)[]) {
  const columns = crowds.filter((crowd) => crowd !== null);
  return columns.filter(({ count }) => count >= MANY).length > 0.5 * columns.length;
}
