// The motions that were shown before and after this one, as links.

const MOST = 500;

export class History {
  constructor() {
    /** @type {string[][]} */
    this.past = [];
    /** @type {string[][]} */
    this.future = [];
    /** @type {string[] | null} */
    this.now = null;
  }

  /**
   * What is shown now is a step, unless it is what was shown before.
   * @param {string[]} queries
   */
  note(queries) {
    if (this.now && JSON.stringify(this.now) !== JSON.stringify(queries)) {
      this.past.push(this.now);
      if (this.past.length > MOST) this.past.shift();
      this.future = [];
    }
    this.now = queries;
  }

  /**
   * One step back (-1) or on (1): what is to be shown, if there is anything.
   * @param {-1 | 1} way
   */
  step(way) {
    const [from, to] = way < 0 ? [this.past, this.future] : [this.future, this.past];
    const queries = from.pop();
    if (!queries || !this.now) return null;
    to.push(this.now);
    this.now = queries;
    return queries;
  }
}
