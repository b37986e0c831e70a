// The one or two motions that are shown, what is being changed in them, and the steps back and forth.

import { Film } from "./film.js";
import { History } from "./history.js";

/**
 * A motion, and what has been asked for since: only the latest value of each parameter waits while an answer is under way.
 * @typedef {{
 *   film: Film, busy?: boolean, pending?: Change[] | null, commit?: boolean, since?: number | null, what?: string,
 *   moved?: number,
 *   refining?: boolean, coarse?: Film,
 * }} Lane
 *
 * @typedef {object} Listener
 * @property {(since?: number | null) => void} shown another motion is there; `since` is when the hand moved that asked for it
 * @property {() => void} refined a film has become finer
 * @property {() => void} settled a change is complete
 * @property {(step: "same" | "step" | "again" | "travelled") => void} noted what is shown is a step that can be undone, or was one
 * @property {(way: -1 | 1) => Promise<void>} travelled it has gone back or on by a step
 * @property {(error: Error, changes?: Change[]) => void} failed
 */

export class Motions {
  /**
   * @param {Backend} backend
   * @param {Listener} listener
   */
  constructor(backend, listener) {
    this.backend = backend;
    this.listener = listener;
    this.history = new History();
    /** @type {Lane[]} */
    this.lanes = [];
    this.active = 0;
    /** @type {Promise<any>} */
    this.going = Promise.resolve();
  }

  film(lane = this.active) {
    return this.lanes[lane].film;
  }

  films() {
    return this.lanes.map((lane) => lane.film);
  }

  // What has been asked of the chosen hoop since its motion was computed: these controls are ahead of it.
  waiting() {
    return new Set((this.lanes[this.active].pending ?? []).map(([path]) => path));
  }

  // The name of the chosen hoop where there are two.
  name() {
    return this.lanes.length > 1 ? "AB"[this.active] : "";
  }

  /** @param {Reply[]} replies */
  set(replies) {
    this.lanes = replies.map((reply) => ({ film: new Film(reply) }));
    this.active = Math.min(this.active, this.lanes.length - 1);
  }

  /** @param {string[]} queries */
  async load(queries) {
    this.set(await Promise.all(queries.map((query) => this.backend.film({ query }))));
  }

  /**
   * Each move of a slider; `commit` when the hand lets go.
   * @param {Change[]} changes
   * @param {boolean} commit
   */
  change(changes, commit) {
    const lane = this.lanes[this.active];
    lane.moved = performance.now();
    lane.since ??= lane.moved;
    lane.pending = [...(lane.pending ?? []).filter(([path]) => !changes.some(([other]) => other === path)), ...changes];
    lane.commit ||= commit;
    lane.what = changes.map(([path]) => path).join();
    if (commit) this.history.touch(lane.what, lane.moved);
    this.pump(lane);
  }

  /** @param {Lane} lane */
  async pump(lane) {
    if (lane.busy || !this.lanes.includes(lane)) return; // it may have been undone meanwhile
    if (!lane.pending) {
      if (lane.commit) this.settle(lane);
      return;
    }
    const changes = lane.pending;
    const { since } = lane;
    lane.pending = null;
    lane.since = null;
    lane.busy = true;
    try {
      lane.film = new Film(await this.backend.film({ scenario: lane.film.scenario, changes }));
      if (this.lanes.includes(lane)) this.listener.shown(since);
    } catch (error) {
      if (this.lanes.includes(lane)) this.listener.failed(/** @type {Error} */ (error), changes);
    } finally {
      lane.busy = false;
    }
    this.pump(lane);
  }

  /**
   * Make films finer where one looks, if they are too long to be sent so densely.
   * @param {number} time
   * @param {number} ahead
   */
  refine(time, ahead) {
    for (const lane of this.lanes) {
      const { film } = lane;
      const window = lane.refining || lane.coarse === film ? null : film.wanted(time, ahead);
      if (!window) continue;
      lane.refining = true;
      this.backend
        .samples(film.scenario, window)
        .then((columns) => {
          film.refine(columns);
          this.listener.refined();
        })
        .catch(() => {
          lane.coarse = film; // it stays as it is, and plays on
        })
        .finally(() => {
          lane.refining = false;
        });
    }
  }

  /** @param {Lane} lane */
  settle(lane) {
    lane.commit = false;
    // when the hand moved, not when the answer came
    this.note(lane.what, lane.moved);
    this.listener.settled();
  }

  // What the motions that are shown are known by.
  queries() {
    return this.films().map((film) => film.query);
  }

  /**
   * @param {string} [what] what was changed, if one thing was
   * @param {number} [when] in milliseconds
   */
  note(what, when) {
    this.listener.noted(this.history.note(this.queries(), what, when));
  }

  /**
   * Another motion in place of the chosen one.
   * @param {Reply} reply
   */
  replace(reply) {
    // an answer that is still under way belongs to what was there before
    this.lanes[this.active] = { film: new Film(reply) };
    this.listener.shown();
    this.note();
  }

  /**
   * One step back or on; it is kept where it cannot be shown.
   * @param {-1 | 1} way
   */
  travel(way) {
    return this.inTurn(async () => {
      const queries = this.history.next(way);
      if (!queries) return;
      await this.load(queries);
      this.history.step(way);
      await this.listener.travelled(way);
      this.listener.shown();
      this.listener.noted("travelled");
    });
  }

  /**
   * Show what the browser's own way back has brought.
   * @param {string[]} queries
   */
  arrive(queries) {
    return this.inTurn(async () => {
      await this.load(queries);
      this.history.arrive(this.queries());
      this.listener.shown();
      this.listener.noted("travelled");
    });
  }

  /**
   * One way at a time, in the order in which they were asked for; whether it could be gone.
   * @param {() => Promise<void>} go
   * @returns {Promise<boolean>}
   */
  inTurn(go) {
    this.going = this.going.then(go).then(
      () => true,
      (error) => {
        this.listener.failed(error);
        return false;
      },
    );
    return this.going;
  }

  // A second hoop like the first, or the chosen one alone.
  compare() {
    if (this.lanes.length === 1) {
      this.lanes.push({ film: this.lanes[0].film });
      this.active = 1;
    } else {
      this.lanes.splice(1 - this.active, 1);
      this.active = 0;
    }
    this.listener.shown();
    this.note();
  }

  /** @param {number} lane */
  choose(lane) {
    this.active = lane;
    this.listener.shown();
    this.listener.noted("same");
  }

  /** @param {string} [view] what else the link holds, as the part behind its # */
  link(view = "") {
    const other = this.lanes.length > 1 ? `with=${encodeURIComponent(this.film(1).query)}` : "";
    const hash = [other, view].filter(Boolean).join("&");
    return this.backend.link(this.film(0).query, hash && `#${hash}`);
  }
}
