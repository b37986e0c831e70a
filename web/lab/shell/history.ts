// The motions that were shown before and after this one, as links.

const MOST = 500;
const KEPT = 100; // of them when the page is loaded again
const TOGETHER = 1000; // milliseconds between two changes of the same thing that are one step

export class History {
  past: string[][] = [];
  future: string[][] = [];
  now: string[] | null = null;
  what = "";
  when = -Infinity;

  /**
   * What is shown now is a step, unless it is what was shown before; keys pressed in a row on one control are one
   * step. `what`: what was changed, if one thing was; `when`: in milliseconds; returns whether it is a step of its
   * own, or the last one with another value.
   */
  note(queries: string[], what = "", when = performance.now()) {
    const before = this.now;
    this.now = queries;
    if (before === null || same(before, queries)) return "same";
    const again = what !== "" && what === this.what && when - this.when < TOGETHER && this.past.length > 0;
    this.what = what;
    this.when = when;
    this.future = [];
    if (again) return "again";
    this.past.push(before);
    if (this.past.length > MOST) this.past.shift();
    return "step";
  }

  /**
   * A hand has changed something, which is noted when its motion is there: a slow machine makes no steps of keys in a
   * row. `when`: in milliseconds.
   */
  touch(what: string, when: number) {
    if (what === this.what && when - this.when < TOGETHER) this.when = when;
  }

  /** The last steps as a text, for the same page when it is loaded again. */
  written() {
    return JSON.stringify({ past: this.past.slice(-KEPT), now: this.now, future: this.future.slice(-KEPT) });
  }

  /** The steps before and after what is shown now, where a text has them. */
  restore(text: string | null) {
    if (!text || !this.now) return;
    const { past, now, future } = JSON.parse(text);
    if (now && same(now, this.now)) Object.assign(this, { past, future });
  }

  /** Whether what is shown is the step that was noted last. */
  holds(queries: string[]) {
    return this.now !== null && same(this.now, queries);
  }

  /** What is to be shown one step back (-1) or on (1), if there is anything; `step` takes it once it is shown. */
  next(way: -1 | 1) {
    return (way < 0 ? this.past : this.future).at(-1) ?? null;
  }

  step(way: -1 | 1) {
    const [from, to] = way < 0 ? [this.past, this.future] : [this.future, this.past];
    const queries = from.pop();
    if (!queries || !this.now) return;
    to.push(this.now);
    this.now = queries;
    this.what = "";
  }

  /** Go to what the browser's own buttons have brought; what is not known here begins anew. */
  arrive(queries: string[]) {
    if (this.now && same(this.now, queries)) return;
    for (const way of [-1, 1] as const) {
      const list = way < 0 ? this.past : this.future;
      const steps = list.length - list.findLastIndex((other) => same(other, queries));
      if (steps > list.length) continue;
      for (let k = 0; k < steps; k++) this.step(way);
      return;
    }
    Object.assign(this, { past: [], future: [], now: queries, what: "" });
  }
}

const same = (a: string[], b: string[]) => JSON.stringify(a) === JSON.stringify(b);
