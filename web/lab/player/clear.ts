// Where a hint is put on the picture: next to what it is about, and clear of what else is there.

/** The edges of a box, in pixels. */
export type Edges = { left: number; right: number; top: number; bottom: number };

const GAP = 4; // pixels

/**
 * The middle of a box of a size: where it is wanted, else at the nearest place that is free. `inside`: what it must
 * not leave; `taken`: what it must not cover.
 */
export function clearPlace([x, y]: number[], size: Box, inside: Edges, taken: Edges[]): [number, number] {
  const [half, tall] = [size.width / 2, size.height / 2];
  const within = (value: number, least: number, most: number) => Math.max(least, Math.min(value, most));
  const across = [x, ...taken.flatMap(({ left, right }) => [right + half + GAP, left - half - GAP])];
  const up = [y, ...taken.flatMap(({ top, bottom }) => [bottom + tall + GAP, top - tall - GAP])];
  const places = across
    .flatMap((one) => up.map((other) => [one, other]))
    .map(([one, other]): [number, number] => [
      within(one, inside.left + half, inside.right - half),
      within(other, inside.top + tall, inside.bottom - tall),
    ]);
  const free = places.filter(
    ([one, other]) =>
      !taken.some(
        ({ left, right, top, bottom }) =>
          one - half < right && left < one + half && other - tall < bottom && top < other + tall,
      ),
  );
  const far = ([one, other]: number[]) => Math.hypot(one - x, other - y);
  return free.sort((a, b) => far(a) - far(b))[0] ?? places[0];
}
