// Exact boundaries between the classes of a map: the squares between the middles of its cells, cut where the class changes.

const UNIT = 1024; // parts of a cell: a boundary is known to half of one
const SLIVER = UNIT / 16; // a third class that is narrower is left out
const DEPTH = 3; // halvings of a square in which more than two classes meet
const MOST = 0.3; // share of the squares above which boundaries are finer than cells
const WIDE = 2 ** 24; // to count places by one number

/** A place in parts of a cell. */
type Spot = [x: number, y: number];
type Square = [left: number, low: number, right: number, high: number];
/** Where the class changes along a side, and to which one. */
interface Cut {
  at: number;
  before: number;
  after: number;
}

export interface Boundaries {
  /** By class: polygons, [x, y, …] in cells from the lower left corner of the map. */
  areas: Map<number, number[][]>;
  /** From where to where: [x, y, x, y], in cells. */
  lines: number[][];
}

/** The classes at places in cells, one for each. */
export type Classes = (places: Spot[]) => Promise<number[]>;

/** `values`: a class for each cell, row by row; returns null where most neighbours differ. */
export async function boundariesOf(values: ArrayLike<number>, [wide, high]: Spot, classes: Classes) {
  return new Plane(values, wide, high, classes).cut();
}

class Plane {
  codes = new Map<number, number>();
  sides = new Map<string, Cut[]>();
  found: Boundaries = { areas: new Map(), lines: [] };

  constructor(
    readonly values: ArrayLike<number>,
    readonly wide: number,
    readonly high: number,
    readonly classes: Classes,
  ) {}

  async cut() {
    const [xs, ys] = [rails(this.wide), rails(this.high)];
    await this.know(xs.flatMap((x) => ys.map((y): Spot => [x, y])));
    const all = xs.slice(1).flatMap((x, i) => ys.slice(1).map((y, k): Square => [xs[i], ys[k], x, y]));
    let mixed = all.filter((square) => this.isMixed(square));
    if (mixed.length > MOST * all.length) return null;
    for (let depth = 0; mixed.length; depth++) {
      await this.divide(mixed);
      const crossed = mixed.filter(
        (square) => depth < DEPTH && this.around(square).filter(({ cut }) => cut).length > 2,
      );
      const kept = new Set(crossed);
      for (const square of mixed) if (!kept.has(square)) this.keep(square);
      const parts = crossed.flatMap(quarters);
      await this.know(parts.flatMap(corners));
      mixed = parts.filter((square) => this.isMixed(square));
      for (const square of parts) if (!this.isMixed(square)) this.fill(this.code(corners(square)[0]), corners(square));
    }
    return this.found;
  }

  /** nan, where there is no motion, is a class like others: −1. */
  code([x, y]: Spot): number {
    if (x % UNIT !== UNIT / 2 || y % UNIT !== UNIT / 2) return this.codes.get(x * WIDE + y) as number;
    const value = this.values[Math.floor(y / UNIT) * this.wide + Math.floor(x / UNIT)];
    return value >= 0 ? value : -1;
  }

  async know(spots: Spot[]) {
    const asked = new Map(
      spots.filter((s) => this.code(s) === undefined).map((spot) => [spot[0] * WIDE + spot[1], spot]),
    );
    if (!asked.size) return;
    const codes = await this.classes([...asked.values()].map(([x, y]): Spot => [x / UNIT, y / UNIT]));
    for (const [k, key] of [...asked.keys()].entries()) this.codes.set(key, codes[k]);
  }

  isMixed(square: Square) {
    const [first, ...rest] = corners(square).map((spot) => this.code(spot));
    return rest.some((code) => code !== first);
  }

  /** Find where the class changes on the sides of squares, those of all at once. */
  async divide(squares: Square[]) {
    let parts: { cuts: Cut[]; spot: (at: number) => Spot; low: number; high: number }[] = [];
    for (const [left, low, right, high] of squares) {
      const across = (y: number) => ({ spot: (x: number): Spot => [x, y], low: left, high: right });
      const up = (x: number) => ({ spot: (y: number): Spot => [x, y], low, high });
      for (const side of [across(low), across(high), up(left), up(right)]) {
        const name = sideOf(side.spot(side.low), side.spot(side.high));
        if (this.sides.has(name)) continue;
        const cuts: Cut[] = [];
        this.sides.set(name, cuts);
        parts.push({ ...side, cuts });
      }
    }
    const differ = (a: Spot, b: Spot) => this.code(a) !== this.code(b);
    parts = parts.filter(({ spot, low, high }) => differ(spot(low), spot(high)));
    while (parts.length) {
      await this.know(parts.map(({ spot, low, high }) => spot((low + high) >> 1)));
      parts = parts.flatMap((part) => {
        const { cuts, spot, low, high } = part;
        if (high - low === 1) {
          cuts.push({ at: 0.5 * (low + high), before: this.code(spot(low)), after: this.code(spot(high)) });
          return [];
        }
        const middle = (low + high) >> 1;
        const halves = [
          { ...part, high: middle },
          { ...part, low: middle },
        ].filter((half) => differ(spot(half.low), spot(half.high)));
        return high - low > SLIVER ? halves : halves.slice(0, 1);
      });
    }
  }

  /** Corners and cuts along the sides of a square, to the left all the way, and the class that follows each. */
  around([left, low, right, high]: Square) {
    const ring: { spot: Spot; code: number; cut: boolean }[] = [];
    const go = (from: Spot, to: Spot) => {
      ring.push({ spot: from, code: this.code(from), cut: false });
      const back = from[0] > to[0] || from[1] > to[1];
      const cuts = [...(this.sides.get(back ? sideOf(to, from) : sideOf(from, to)) as Cut[])];
      cuts.sort((a, b) => (back ? b.at - a.at : a.at - b.at));
      for (const { at, before, after } of cuts) {
        ring.push({ spot: from[1] === to[1] ? [at, from[1]] : [from[0], at], code: back ? before : after, cut: true });
      }
    };
    go([left, low], [right, low]);
    go([right, low], [right, high]);
    go([right, high], [left, high]);
    go([left, high], [left, low]);
    return ring;
  }

  /** Fill a square from cut to cut, with lines from the cuts to their middle. */
  keep(square: Square) {
    const ring = this.around(square);
    const first = ring.findIndex(({ cut }) => cut);
    const turned = [...ring.slice(first), ...ring.slice(0, first)];
    const places = turned.flatMap(({ cut }, place) => (cut ? [place] : []));
    const mean = (k: 0 | 1) => places.reduce((sum, place) => sum + turned[place].spot[k], 0) / places.length;
    const middle: Spot = [mean(0), mean(1)];
    for (const [k, place] of places.entries()) {
      const next = places[k + 1] ?? turned.length;
      const run = turned.slice(place, next);
      const end = turned[next] ?? turned[0];
      this.fill(run[run.length - 1].code, [middle, ...run.map(({ spot }) => spot), end.spot]);
      this.found.lines.push([...turned[place].spot, ...middle].map((part) => part / UNIT));
    }
  }

  fill(code: number, spots: Spot[]) {
    const polygons = this.found.areas.get(code) ?? [];
    this.found.areas.set(code, polygons);
    polygons.push(spots.flat().map((part) => part / UNIT));
  }
}

/** The middles of cells, and almost the ends of the map: at a value's very limit there may be another class. */
const rails = (cells: number) => [1, ...Array.from({ length: cells }, (_, k) => (k + 0.5) * UNIT), cells * UNIT - 1];

const corners = ([left, low, right, high]: Square): Spot[] => [
  [left, low],
  [right, low],
  [right, high],
  [left, high],
];

function quarters([left, low, right, high]: Square): Square[] {
  const [x, y] = [(left + right) >> 1, (low + high) >> 1];
  return [
    [left, low, x, y],
    [x, low, right, y],
    [left, y, x, high],
    [x, y, right, high],
  ];
}

const sideOf = (from: Spot, to: Spot) => `${from} ${to}`;
