// The lab: one or two motions, the clock, and everything that shows them.

import { recall, remember } from "./memory.ts";
import { Address, written, type Shown } from "./address.ts";
import { Computing, Notice } from "./notice.ts";
import { Clock, Opening } from "../player/clock.ts";
import { Controls } from "../controls/controls.ts";
import { once, say } from "../common/dom.ts";
import { Ending } from "../player/ending.ts";
import { Extras } from "./extras.ts";
import { Header, Hoops } from "./header.ts";
import { aboutDialog, helpDialog } from "./help.ts";
import { View } from "./view.ts";
import { listen, SingleKeys } from "./keys.ts";
import { layOut, prepareRoot } from "./page.ts";
import { MotionMap } from "../map/map.ts";
import { Motions } from "../player/motions.ts";
import { PhasePlane } from "../diagrams/phase.ts";
import { Plots } from "../diagrams/plots.ts";
import { Sameness } from "../backend/sameness.ts";
import { Share } from "./share.ts";
import { Stage } from "../player/stage.ts";
import { Story, Theory } from "../player/story.ts";
import { Theme } from "./theme.ts";
import { Timeline } from "../player/timeline.ts";
import { Transport } from "../player/transport.ts";
import { messageOf } from "../words/words.ts";

interface Options {
  own?: string; // where the lab owns the page and its keyboard: what the page's address begins with
  panels?: string[] | null; // what stands beside the player; everything by default
  onmotion?: (query: string) => void; // called when another motion is a step that can be undone
}

export type State = "holding" | "visiting" | "guessing";

const STEPS = "hophoop-steps";

export class Lab {
  requested = false; // a picture
  surrounding = false; // diagrams and words, which follow the picture
  taken: Preset | null = null;
  first: string[] = []; // the motions that were opened or chosen last, by their queries
  afterFrame: (() => void) | null = null;
  asked: AbortController | null = null;
  // how many pictures were drawn, and how long each took from the hand to the screen [ms]
  frames = 0;
  latencies: number[] = [];
  hosted = prepareRoot(this.root, this.options.own);
  known = this.setup.presets;
  sameness = new Sameness(this.setup.presets);
  address = this.hosted ? new Address(this, this.options.own as string) : null;
  clock = new Clock();
  notice = new Notice();
  computing = new Computing(this.backend.kernel.limit);
  motions = new Motions(this);
  theme = new Theme(this.root, this.setup.colors, this.hosted, () => this.show());
  stage = new Stage(this.setup.colors, () => {
    this.request();
    this.address?.soon();
  });
  timeline = new Timeline(this.clock);
  story = new Story(this.clock);
  transport = new Transport(this.clock, this.motions, this.stage, this.story, this.notice, (name) => this.toggle(name));
  ending = new Ending(this.backend, this.clock, this.motions, this.story);
  theory = new Theory();
  plots = new Plots(this.clock, this.setup.colors);
  phase = new PhasePlane(this.backend, this.clock, this.setup.colors);
  map = new MotionMap(this.setup, this.backend, this.clock, this.motions, this.story, () => this.address?.soon());
  controls = new Controls(this.motions, this.setup.controls, this.story.fingerprint);
  share = new Share(this);
  singleKeys = new SingleKeys(this.hosted);
  about = aboutDialog(this.setup.version, this.hosted);
  help = helpDialog(this.about, this.setup.colors, this.singleKeys.element);
  hoops = new Hoops((lane) => this.motions.choose(lane));
  view = new View(this.root, this.hosted, () => {
    this.show();
    this.address?.write("same");
  });
  header = new Header(this);
  extras = new Extras(this);
  opening = new Opening(this.clock, this.extras.grips.hint);
  page = layOut(this, this.options.panels ?? null);
  deaf = listen(this, this.hosted);
  later = once(() => this.fetchTheory(), 120);
  sizes = new ResizeObserver(() => this.show());
  // paper has another width than the screen; the browser measures it after this
  print = () => this.printing(true);
  printed = () => this.printing(false);

  constructor(
    readonly root: HTMLElement,
    readonly backend: Backend,
    readonly setup: Setup,
    readonly options: Options = {},
  ) {
    if (this.hosted && !location.search && !location.hash) this.extras.visit.offer();
    this.clock.changed = () => {
      this.request();
      if (!this.clock.playing) this.address?.soon();
    };
  }

  /** The first motions, by their links. `shown`: what else the link says. */
  async open(queries: string[], shown: Shown = {}) {
    this.root.dataset.opening = "true";
    await this.motions.load(queries).finally(() => delete this.root.dataset.opening);
    this.clock.duration = Math.max(...this.films().map((film) => film.duration));
    this.sameness.expect(this.films(), shown.fingerprints ?? []);
    this.view.open(shown);
    this.restore(shown);
    this.begin();
    // who has chosen to see everything knows the page
    if (this.hosted && shown.time === undefined && !this.view.everything) this.opening.begin(this.page.player);
  }

  // The motions are there.
  begin() {
    this.first = this.motions.queries();
    this.show();
    const steps = this.hosted ? recall(STEPS, "sessionStorage") : null;
    this.motions.note();
    if (steps) {
      this.motions.history.restore(steps);
      this.noted("same");
    }
    this.sizes.observe(this.stage.element);
    addEventListener("beforeprint", this.print);
    addEventListener("afterprint", this.printed);
    this.root.dataset.ready = "true";
  }

  close() {
    this.clock.playing = false;
    this.asked?.abort();
    this.extras.close();
    this.opening.end();
    this.computing.stop();
    this.map.close();
    this.theme.close();
    this.address?.close();
    this.page.sticky?.close();
    this.sizes.disconnect();
    removeEventListener("beforeprint", this.print);
    removeEventListener("afterprint", this.printed);
    this.deaf();
  }

  // --- motions -------------------------------------------------------------------------------

  film(lane = this.motions.active) {
    return this.motions.film(lane);
  }

  films() {
    return this.motions.films();
  }

  changed(since: number | null = null) {
    this.notice.clear();
    if (since === null) this.controls.accept();
    this.show(since);
  }

  /** A refusal is said at its field; what is shown stays as it was. */
  failed(error: Error, changes: Change[] = []) {
    if (!this.controls.refuse(changes, messageOf(error))) {
      this.notice.fail(error);
      this.controls.restore();
    }
    this.showPreset();
  }

  noted(step: "same" | "step" | "again" | "travelled") {
    this.header.show();
    this.address?.write(step);
    if (this.hosted) remember(STEPS, this.motions.history.written(), "sessionStorage");
    this.options.onmotion?.(this.film().query);
  }

  /**
   * What a link to what is shown says behind its base: the motions, the time, the view, the map. `fingerprints`: of
   * the motions, to be compared where the link is opened.
   */
  link(fingerprints = this.sameness.expected(this.films())) {
    const { clock, stage, map, extras, view } = this;
    const { on, path } = extras.more;
    const shown = {
      time: clock.time,
      ...stage.view(),
      more: on ? path : undefined,
      map: map.shown(),
      everything: this.hosted && !view.simple,
      fingerprints,
    };
    return this.motions.link(written(shown));
  }

  /** `shown`: what a link says of it. */
  restore({ time, map, options, more, ...view }: Shown) {
    const turned = options?.three ? this.toggle("three") : Promise.resolve();
    this.stage.restore({ options, ...view });
    turned.then(() => this.stage.restore(view)); // from where it is looked at
    if (map) this.map.restore(map);
    if (more) this.extras.more.turn(true, more);
    if (time) this.clock.seek(time);
  }

  // The name of what is shown, and what there is to see in it, where it is one of the motions to start from.
  showPreset() {
    const { query } = this.film();
    const preset = this.known.find((one) => one.query === query);
    this.header.presets.value = preset?.key ?? "";
    say(this.hoops.text, preset ? `example.${preset.key}.text` : "");
  }

  async take(preset: Preset) {
    this.taken = preset;
    try {
      const reply = await this.motions.ask({ query: preset.query });
      if (this.taken !== preset) return; // another was chosen meanwhile
      this.first = [preset.query];
      this.clock.time = 0;
      this.motions.replace(reply);
      this.story.announce(this.films());
    } catch (error) {
      this.failed(error);
    }
  }

  /** Show the motion of a link from its start, at rest. */
  async load(query: string, first = [query]) {
    this.first = first;
    try {
      const reply = await this.motions.ask({ query });
      this.clock.play(false);
      this.clock.time = 0;
      this.motions.replace(reply);
    } catch (error) {
      this.notice.fail(error);
    }
  }

  reset() {
    return this.load(this.firstQuery(), this.first);
  }

  /** A state of the whole page, which the style sheet knows. */
  mark(state: State, on: boolean) {
    this.root.classList.toggle(state, on);
  }

  marked(state: State) {
    return this.root.classList.contains(state);
  }

  travel(way: -1 | 1) {
    return this.motions.travel(way);
  }

  // --- showing -------------------------------------------------------------------------------

  /** All that depends on the motion; `since` is when the hand moved that asked for it. */
  show(since: number | null = null) {
    const { motions, clock } = this;
    const films = this.films();
    if (!films.length) return;
    const two = films.length > 1;
    this.page.arrange();
    this.theme.read();
    clock.duration = Math.max(...films.map((film) => film.duration));
    clock.time = Math.min(clock.time, clock.duration);
    this.root.classList.toggle("two", two);
    this.header.show();
    this.hoops.show(films.length, motions.active);
    this.drawStage();
    this.controls.show(this.film(), this.motions.waiting());
    this.view.show(films);
    this.showPreset();
    if (since !== null) {
      requestAnimationFrame(() => setTimeout(() => this.latencies.push(performance.now() - since), 0));
    }
    // the picture first; diagrams and words follow once it is on the screen
    if (!this.surrounding) {
      this.surrounding = true;
      requestAnimationFrame(() => setTimeout(() => this.showSurroundings(), 0));
    }
  }

  /** All pictures again, for the width of a sheet of paper or of the screen. */
  printing(on: boolean) {
    this.root.classList.toggle("printing", on);
    this.theme.mark();
    this.plots.whole = on;
    this.show();
    this.showSurroundings();
  }

  showSurroundings() {
    this.surrounding = false;
    const films = this.films();
    const { active } = this.motions;
    const { look, colors } = this.theme;
    this.plots.draw(films, active, look);
    this.phase.draw(films, active, look);
    this.story.draw(films, active, colors, this.sameness.of(films[active]));
    this.drawTime();
    this.map.mark(this.film(), look);
    this.stage.describe(films);
    this.ending.changed();
    this.extras.changed();
    this.later();
  }

  drawStage() {
    this.stage.draw(this.films(), this.motions.active, this.clock, this.theme);
  }

  drawTime() {
    const { time } = this.clock;
    if (this.surrounding) return;
    this.timeline.draw(this.films(), this.theme.look, this.theme.colors);
    this.plots.cursor(time);
    this.phase.cursor(time);
    this.story.cursor(time);
    this.transport.show();
  }

  request() {
    if (this.requested) return;
    this.requested = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now: number) {
    this.requested = false;
    if (!this.motions.lanes.length) return;
    this.clock.tick(now);
    this.motions.refine(this.clock.time, this.clock.playing ? 2 * this.clock.speed : 0);
    this.drawStage();
    this.drawTime();
    this.extras.frame();
    this.afterFrame?.();
    this.frames += 1;
    if (this.clock.playing) this.request();
  }

  // What theory says of the chosen hoop; a newer question gives up the older.
  async fetchTheory() {
    const { scenario } = this.film();
    this.asked?.abort();
    this.asked = new AbortController();
    const { signal } = this.asked;
    try {
      this.theory.draw(await this.backend.theory(scenario, signal), this.motions.name());
      await this.phase.fetch(scenario, signal);
    } catch (error) {
      if (error.name !== "AbortError") this.theory.draw([{ label: "–", text: messageOf(error) }]);
    }
  }

  /** The motion to which Reset sets the chosen hoop back. */
  firstQuery() {
    return this.first[this.motions.active] ?? this.first[0];
  }

  /** Draw it, or leave it out. */
  async toggle(name: keyof StageOptions) {
    const { options } = this.stage;
    if (name !== "three") options[name] = !options[name];
    else await this.stage.turn(() => this.drawStage()).catch((error) => this.notice.say(messageOf(error)));
    this.transport.show();
    this.address?.soon();
    this.request();
  }
}
