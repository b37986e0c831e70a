// Answers without a server: numbers from the kernel in the page, everything else from the model beside it.

import * as model from "../../model/index.ts";
import type { Axis } from "../../model/limits.ts";

const REGION_COLUMNS = 360;
const REGION_ROWS = 240;

/** Files that need no Python. */
const OWN_FILES: Record<string, string> = {
  "motion.toml": "application/toml",
  "motion.csv": "text/csv; charset=utf-8",
  "motion.json": "application/json",
};
const SERVER_FILES = ["motion.nc", "motion.mp4", "motion.gif"];

export class LocalBackend implements Backend {
  base: URL | null;
  server: Backend | null;
  shares: boolean;
  files: string[];

  /** `beside`: the page's address, where there is one to share, and a server that makes what needs Python. */
  constructor(
    readonly kernel: Kernel,
    public mechanics: Mechanics,
    { base = null, server = null }: { base?: URL | null; server?: Backend | null } = {},
  ) {
    this.base = base;
    this.server = server;
    this.shares = base !== null;
    this.files = [...Object.keys(OWN_FILES), ...(server ? SERVER_FILES : [])];
  }

  async call(name: string, body: any, signal?: AbortSignal): Promise<Reply> {
    signal?.throwIfAborted();
    if (name === "setup") return { header: model.tables.setup, arrays: {} };
    const { checked, ...options } = model.requested(body, this.mechanics);
    if (name === "film") return this.film(checked, signal);
    if (name === "samples") {
      const given = model.given(model.within(checked));
      const { window } = options;
      return { header: { window }, arrays: await this.kernel.columns(given, signal, window) };
    }
    if (name === "code") {
      return { header: { python: model.pythonCode(checked), toml: model.toToml(checked) }, arrays: {} };
    }
    if (name === "theory") {
      const known = await this.kernel.thresholds(model.given(checked), signal);
      return { header: { thresholds: model.thresholds(checked, known) }, arrays: {} };
    }
    if (name === "regions") {
      const { window } = options;
      const given = model.given(checked);
      const arrays = await this.kernel.regions(given, window, REGION_COLUMNS, REGION_ROWS, signal);
      return { header: { window }, arrays };
    }
    if (name === "map") return this.map(checked, options as any, signal);
    throw new TypeError(`The page does not answer ${name}.`);
  }

  async film(checked: Checked, signal?: AbortSignal): Promise<Reply> {
    const given = model.given(model.within(checked));
    const { motion, columns } = this.kernel.film
      ? await this.kernel.film(given, signal)
      : { motion: await this.kernel.motion(given, signal), columns: await this.kernel.columns(given, signal) };
    // where the digits of doubles do not decide what happens, Python asks for more
    const { doubt } = motion;
    if (doubt !== null && this.server) return this.server.call("film", { query: model.toQuery(checked) }, signal);
    const omega = await this.turning(given, motion, signal);
    const header = model.headerOf(checked, motion, omega, this.mechanics);
    return { header: doubt === null ? header : { ...header, doubt: model.doubtText(doubt) }, arrays: columns };
  }

  /** How the hoop turns after events at which it slips and does not turn yet. */
  async turning(given: Given, { events }: ComputedMotion, signal?: AbortSignal): Promise<(number: number) => number> {
    const still = model.stills(events);
    if (!still.length) return () => 0;
    const times = Float64Array.from(still, (number) => model.halfway(events, number));
    const { omega } = await this.kernel.samples(given, times, signal);
    return (number) => omega[still.indexOf(number)];
  }

  /** What a little more of a parameter does to each event. Returns null where the parameter can be no other. */
  async changes(scenario: any, path: string, signal?: AbortSignal): Promise<SidedChanges | null> {
    if (!this.kernel.changes) throw new TypeError("This kernel has no derivatives.");
    const checked = model.within(model.asked({ scenario }, this.mechanics));
    const given = model.given(checked);
    if (given.contact) throw new model.InputError(model.labText("compliant_changes"));
    const found = model.ratesOf(checked, path);
    if (!found) return null;
    const { rates, smaller, larger } = found;
    const sides = await this.kernel.changes(given, rates, signal);
    return { count: sides.count, smaller: smaller ? sides.smaller : null, larger: larger ? sides.larger : null };
  }

  async map(
    checked: Checked,
    { x, y, what }: { x: Axis; y: Axis; what: string },
    signal?: AbortSignal,
  ): Promise<Reply> {
    const span = model.spanOf(what);
    const base = model.withinMap(checked, { x, y, what });
    const cells = await model.cellsOf(base, { x, y }, this.mechanics, signal);
    return model.mapReply({ x, y, what }, await this.kernel.map(cells, what, span, signal));
  }

  async file(name: string, query: string) {
    if (!(name in OWN_FILES)) {
      if (this.server) return this.server.file(name, query);
      throw new model.InputError({ key: "save.needs_python", values: { name } });
    }
    return new Blob([await this.fileText(name, query)], { type: OWN_FILES[name] });
  }

  async fileText(name: string, query: string) {
    const asked = model.asked({ query }, this.mechanics);
    if (name === "motion.toml") return model.toToml(asked);
    const checked = model.within(asked);
    const given = model.given(checked);
    const motion = await this.kernel.motion(given);
    if (motion.doubt !== null && this.server) return (await this.server.file(name, query)).text(); // as the film
    if (name === "motion.json") return model.resultText(checked, motion);
    const times = model.timesOf(motion.duration);
    return model.tableText(times, await this.kernel.samples(given, times));
  }

  link(query: string, hash: string) {
    return this.base && `${new URL(query ? `?${query}` : "", this.base)}${hash}`;
  }
}
