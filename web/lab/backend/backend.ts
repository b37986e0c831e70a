// Where answers come from: numbers from the kernel, everything else from the model beside it.

import * as model from "../../model/index.ts";
import { ratesOf } from "../sensitivity/rates.ts";

const REGION_COLUMNS = 360;
const REGION_ROWS = 240;
const PASSAGES = 2000; // of the bottom, after which a fate is not decided

/** Files and their types. */
const FILES: Named<string> = {
  "motion.toml": "application/toml",
  "motion.csv": "text/csv; charset=utf-8",
  "motion.json": "application/json",
};

/** A scenario, or its link, and changes to it. */
export type Asked = { scenario?: any; query?: string; changes?: Change[] };

export class Backend {
  /** `base`: what links begin with, where there are any to share. */
  constructor(
    readonly kernel: Kernel,
    public mechanics: Mechanics,
    readonly base: string | null = null,
  ) {}

  checked(asked: Asked) {
    return model.asked(asked, this.mechanics);
  }

  /** The motion of a scenario for the player. `bounded`: whether it must be one that a page computes. */
  async film(asked: Asked, signal?: AbortSignal, bounded = true): Promise<FilmReply> {
    const checked = this.checked(asked);
    const given = model.given(bounded ? model.within(checked) : checked);
    const { motion, columns, pieces } = await this.kernel.ask("film", [given], signal);
    const { doubt } = motion;
    const omega = await this.turning(given, motion, signal);
    const header = model.headerOf(checked, motion, omega, this.mechanics);
    return {
      header: doubt === null ? header : { ...header, doubt: model.doubtText(doubt) },
      arrays: columns,
      exact: (time) => this.mechanics.instant(given, pieces, time),
    };
  }

  /** What a link says in spite of what is wrong in it. */
  readable(query: string) {
    return model.readable(query, this.mechanics);
  }

  /** A part of a motion, for a film that is too long to be as dense as it is seen. `window`: times from and to. */
  async samples(scenario: any, window: [number, number], signal?: AbortSignal) {
    const checked = this.checked({ scenario });
    return this.kernel.ask("columns", [model.given(model.within(checked)), window], signal);
  }

  /** How the hoop turns after events at which it slips and does not turn yet. */
  async turning(given: Given, { events }: ComputedMotion, signal?: AbortSignal): Promise<(number: number) => number> {
    const still = model.stills(events);
    if (!still.length) return () => 0;
    const times = Float64Array.from(still, (number) => model.halfway(events, number));
    const { omega } = await this.kernel.ask("samples", [given, times], signal);
    return (number) => omega[still.indexOf(number)];
  }

  /** The Python and the file of a scenario. */
  code(scenario: any) {
    const checked = this.checked({ scenario });
    return { python: model.pythonCode(checked), toml: model.toToml(checked) };
  }

  /** What theory says of the hoop of a scenario. */
  async theory(scenario: any, signal?: AbortSignal) {
    const checked = this.checked({ scenario });
    return model.thresholds(checked, await this.kernel.ask("thresholds", [model.given(checked)], signal));
  }

  /** The modes that follow in the (θ, θ̇) plane. `window`: of θ and of θ̇. */
  async regions(scenario: any, window: [number, number, number, number], signal?: AbortSignal) {
    const given = model.given(this.checked({ scenario }));
    return this.kernel.ask("regions", [given, window, REGION_COLUMNS, REGION_ROWS], signal);
  }

  /**
   * How the events of a motion change with a parameter, from motions nearby. `value`: of the parameter; `step`: of its
   * slider. Returns null where it can be no other.
   */
  async changes(
    { scenario, events }: Pick<Film, "scenario" | "events">,
    path: string,
    value: number,
    step: number,
    signal?: AbortSignal,
  ) {
    if (scenario.contact.model !== "rigid") throw new model.InputError(model.labText("compliant_changes"));
    const allowed = (offset: number) => {
      try {
        return model.within(this.checked({ scenario, changes: [[path, value + offset]] }));
      } catch (error) {
        if (error instanceof model.InputError) return null;
        throw error;
      }
    };
    return ratesOf(events, step, async (offset) => {
      const checked = allowed(offset);
      return checked && (await this.kernel.ask("motion", [model.given(checked)], signal)).events;
    });
  }

  /** What becomes of the motion in the end. */
  async fate(scenario: any, signal?: AbortSignal) {
    const given = model.given(this.checked({ scenario }));
    if (given.contact || !given.gravity) throw new model.InputError({ key: "ending.needs" });
    return this.kernel.ask("fate", [given, PASSAGES], signal);
  }

  /** A map over two parameters. */
  async map({ x, y, what, ...asked }: Asked & { x: any; y: any; what: string }, signal?: AbortSignal) {
    signal?.throwIfAborted();
    const base = model.withinMap(this.checked(asked), { x, y });
    const cells = await model.cellsOf(base, { x, y }, this.mechanics, signal);
    return model.mapReply({ x, y, what }, await this.kernel.ask("map", [cells, what, model.spanOf(what)], signal));
  }

  async file(name: string, query: string) {
    const asked = this.checked({ query });
    return new Blob([await this.fileText(name, asked)], { type: FILES[name] });
  }

  async fileText(name: string, asked: Checked) {
    if (name === "motion.toml") return model.toToml(asked);
    const checked = model.within(asked);
    const given = model.given(checked);
    const motion = await this.kernel.ask("motion", [given]);
    if (name === "motion.json") return model.resultText(checked, motion);
    const times = model.timesOf(motion.duration);
    return model.tableText(times, await this.kernel.ask("samples", [given, times]));
  }

  /** What a link says behind its base. */
  link(query: string, hash: string) {
    return `${query && `?${query}`}${hash}`;
  }
}
