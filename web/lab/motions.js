// The one or two motions that are shown, what is being changed in them, and the steps back and forth.

import { Film } from "./film.js";
import { History } from "./history.js";

/**
 * A motion, and what has been asked for since: only the latest value of each parameter waits while an answer is under way.
 * @typedef {{
 *   film: Film, busy?: boolean, pending?: Change[] | null, commit?: boolean, since?: number | null,
 * }} Lane
 *
 * @typedef {object} Listener
 * @property {(since?: number | null) => void} shown another motion is there; `since` is when the hand moved that asked for it
 * @property {() => void} settled a change is complete
 * @property {() => void} noted what is shown is a step that can be undone, or one that was
 * @property {(error: Error) => void} failed
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
  }

  film(lane = this.active) {
    return this.lanes[lane].film;
  }

  films() {
    return this.lanes.map((lane) => lane.film);
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
    this.set(await Promise.all(queries.map((query) => this.backend.call("film", { query }))));
  }

  /**
   * Each move of a slider; `commit` when the hand lets go.
   * @param {Change[]} changes
   * @param {boolean} commit
   */
  change(changes, commit) {
    const lane = this.lanes[this.active];
    lane.since ??= performance.now();
    lane.pending = [...(lane.pending ?? []).filter(([path]) => !changes.some(([other]) => other === path)), ...changes];
    lane.commit ||= commit;
    this.pump(lane);
  }

  /** @param {Lane} lane */
  async pump(lane) {
    if (lane.busy) return;
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
      lane.film = new Film(await this.backend.call("film", { scenario: lane.film.scenario, changes }));
      this.listener.shown(since);
    } catch (error) {
      this.listener.failed(/** @type {Error} */ (error));
    } finally {
      lane.busy = false;
    }
    this.pump(lane);
  }

  /** @param {Lane} lane */
  settle(lane) {
    lane.commit = false;
    this.note();
    this.listener.settled();
  }

  note() {
    this.history.note(this.films().map((film) => film.query));
    this.listener.noted();
  }

  /**
   * Another motion in place of the chosen one.
   * @param {Reply} reply
   */
  replace(reply) {
    this.lanes[this.active].film = new Film(reply);
    this.listener.shown();
    this.note();
  }

  /** @param {-1 | 1} way */
  async travel(way) {
    const queries = this.history.step(way);
    if (!queries) return;
    await this.load(queries);
    this.listener.shown();
    this.listener.noted();
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
    this.listener.noted();
  }

  link() {
    const other = this.lanes.length > 1 ? `#with=${encodeURIComponent(this.film(1).query)}` : "";
    return this.backend.link(this.film(0).query, other);
  }
}
