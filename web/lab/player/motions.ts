// The one or two motions that are shown, what is being changed in them, and the steps back and forth.

import { Film } from "./film.ts";
import { Stopped } from "../shell/notice.ts";
import { History } from "../shell/history.ts";
import type { Asked } from "../backend/backend.ts";
import type { Lab } from "../shell/lab.ts";

/**
 * A motion, and what has been asked for since: only the latest value of each parameter waits while an answer is under
 * way.
 */
type Lane = {
  film: Film;
  busy?: boolean;
  pending?: Change[] | null;
  commit?: boolean;
  since?: number | null;
  what?: string;
  moved?: number;
  refining?: boolean;
  coarse?: Film;
};
export class Motions {
  history = new History();
  lanes: Lane[] = [];
  active = 0;
  going: Promise<any> = Promise.resolve();

  constructor(
    readonly lab: Pick<Lab, "address" | "backend" | "changed" | "computing" | "failed" | "noted" | "request" | "story">,
  ) {}

  /** A motion, which the visitor may give up where it takes long. */
  ask(asked: Asked) {
    return this.lab.computing.during((signal) => this.lab.backend.film(asked, signal));
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

  set(replies: FilmReply[]) {
    this.lanes = replies.map((reply) => ({ film: new Film(reply) }));
    this.active = Math.min(this.active, this.lanes.length - 1);
  }

  async load(queries: string[]) {
    this.set(await Promise.all(queries.map((query) => this.ask({ query }))));
  }

  /** Each move of a slider; `commit` when the hand lets go. */
  change(changes: Change[], commit: boolean) {
    const lane = this.lanes[this.active];
    lane.moved = performance.now();
    lane.since ??= lane.moved;
    lane.pending = [...(lane.pending ?? []).filter(([path]) => !changes.some(([other]) => other === path)), ...changes];
    lane.commit ||= commit;
    lane.what = changes.map(([path]) => path).join();
    if (commit) this.history.touch(lane.what, lane.moved);
    this.pump(lane);
  }

  async pump(lane: Lane) {
    if (lane.busy || !this.lanes.includes(lane)) return; // it may have been undone meanwhile
    if (!lane.pending) {
      if (lane.commit) {
        lane.commit = false;
        this.note(lane.what, lane.moved); // when the hand moved, not when the answer came
        this.lab.story.announce(this.films());
      }
      return;
    }
    const changes = lane.pending;
    const { since } = lane;
    lane.pending = null;
    lane.since = null;
    lane.busy = true;
    try {
      lane.film = new Film(await this.ask({ scenario: lane.film.scenario, changes }));
      if (this.lanes.includes(lane)) this.lab.changed(since);
    } catch (error) {
      if (error instanceof Stopped) lane.pending = null;
      if (this.lanes.includes(lane)) this.lab.failed(error, changes);
    } finally {
      lane.busy = false;
    }
    this.pump(lane);
  }

  /** Make films finer where one looks, if they are too long to be sent so densely. `ahead`: 0 where it is still. */
  refine(time: number, ahead: number) {
    for (const lane of this.lanes) {
      const { film } = lane;
      if (lane.refining || lane.coarse === film) continue;
      const window = film.wanted(time, ahead);
      if (!window) continue;
      lane.refining = true;
      this.lab.backend
        .samples(film.scenario, window)
        .then((columns) => {
          film.refine(columns);
          this.lab.request();
        })
        .catch(() => {
          lane.coarse = film; // it stays as it is, and plays on
        })
        .finally(() => {
          lane.refining = false;
        });
    }
  }

  // What the motions that are shown are known by.
  queries() {
    return this.films().map((film) => film.query);
  }

  /** `what`: what was changed, if one thing was; `when`: in milliseconds. */
  note(what?: string, when?: number) {
    this.lab.noted(this.history.note(this.queries(), what, when));
  }

  /** Another motion in place of the chosen one. */
  replace(reply: FilmReply) {
    // an answer that is still under way belongs to what was there before
    this.lanes[this.active] = { film: new Film(reply) };
    this.lab.changed();
    this.note();
  }

  /** One step back or on; it is kept where it cannot be shown. */
  travel(way: -1 | 1) {
    return this.inTurn(async () => {
      const queries = this.history.next(way);
      if (!queries) return;
      await this.load(queries);
      this.history.step(way);
      this.lab.changed();
      await this.lab.address?.travel(way);
      this.lab.noted("travelled");
    });
  }

  /** Show what the browser's own way back has brought. */
  arrive(queries: string[]) {
    return this.inTurn(async () => {
      await this.load(queries);
      this.history.arrive(this.queries());
      this.lab.changed();
      this.lab.noted("travelled");
    });
  }

  /** One way at a time, in the order in which they were asked for; whether it could be gone. */
  inTurn(go: () => Promise<void>) {
    this.going = this.going.then(go).then(
      () => true,
      (error) => {
        this.lab.failed(error);
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
    this.lab.changed();
    this.note();
  }

  choose(lane: number) {
    this.active = lane;
    this.lab.changed();
    this.lab.noted("same");
  }

  /** `view`: what else the link holds, as the part behind its #. */
  link(view = "") {
    const other = this.lanes.length > 1 ? `with=${encodeURIComponent(this.film(1).query)}` : "";
    const hash = [other, view].filter(Boolean).join("&");
    return this.lab.backend.link(this.film(0).query, hash && `#${hash}`);
  }
}
