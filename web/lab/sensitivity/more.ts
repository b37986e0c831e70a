// What a little more of a parameter would do: arrows in the picture, and what changes in words and numbers.

import { Changes, sentences, signed, arrowsOf, drawArrows, magnified, type Arrow, type Unit } from "./changes.ts";
import { h, headed, once, say } from "../common/dom.ts";
import { eventWord } from "../player/marks.ts";
import { show, sizeOf, withUnit } from "../common/numbers.ts";
import { messageOf } from "../words/words.ts";
import type { Lab } from "../shell/lab.ts";

const WAIT = 100; // milliseconds
const FIRST = "plane.mu";
const LEFT_OUT = /^(contact\.|duration$)/;
const MOST = 200; // events in the table

export class More {
  on = false;
  path = FIRST;
  changes: Changes | null = null;
  arrows: Arrow[] = [];
  factor = 0;
  three = false;
  asked: AbortController | null = null;
  /** What the shown numbers belong to. */
  known = "";
  /** What is offered. */
  paths = "";
  /** Whether a screen reader is told what comes. */
  speak = false;
  later = once(() => this.fetch(), WAIT);
  switch = h(
    "button.switch",
    { title: "sensitivity.title_key", "aria-pressed": "false", onclick: () => this.turn() },
    "sensitivity.arrows",
  );
  picked = h("select", { onchange: () => this.pick(this.picked.value) });
  step = h("span.more-step");
  take = h("button", { onclick: () => this.apply() }, "sensitivity.apply");
  said = h("ul.more-said");
  reason = h("p.more-reason", { hidden: true });
  scale = h("p.hint");
  body = h("tbody");
  rows = h(
    "details.more-events",
    h("summary", "sensitivity.table_caption"),
    h(
      "div.table-scroll",
      { tabindex: "0", role: "region", "aria-label": "sensitivity.table" },
      h(
        "table",
        headed(
          "sensitivity.event",
          "column.time",
          "sensitivity.position",
          "sensitivity.height",
          "sensitivity.load_angle",
        ),
        this.body,
      ),
    ),
  );
  element = h(
    "section.table.more",
    { "aria-label": "sensitivity.title", hidden: true },
    h("header", h("h2", "sensitivity.title"), h("button", { onclick: () => this.turn(false) }, "table.close")),
    h("div.more-asked", h("label", h("span", "sensitivity.step"), this.picked), this.step, this.take),
    this.said,
    this.reason,
    this.rows,
    this.scale,
  );

  constructor(
    readonly lab: Pick<
      Lab,
      "address" | "backend" | "clock" | "controls" | "film" | "marked" | "motions" | "request" | "stage" | "story"
    >,
  ) {
    lab.stage.flat.over = (scene, lane) => {
      const guessing = lab.marked("guessing"); // what comes is to be guessed
      if (!this.on || guessing || lane !== lab.motions.active) return;
      const factor = magnified(this.arrows, scene.film.radius, scene.scale);
      if (factor || this.arrows.some(({ dx }) => Number.isNaN(dx))) drawArrows(scene, this.arrows, factor || 1);
      if (factor !== this.factor) {
        this.factor = factor;
        this.tellScale();
      }
    };
  }

  /** `path`: of the parameter. */
  turn(on: boolean = !this.on, path: string = this.path) {
    this.on = on;
    this.path = path;
    this.element.hidden = !on;
    this.switch.ariaPressed = String(on);
    this.known = "";
    if (on) this.changed(true);
    else this.forget();
    if (this.lab.motions.lanes.length) this.lab.address?.soon();
    this.lab.request();
  }

  pick(path: string) {
    this.path = path;
    this.known = "";
    this.changed(true);
    this.lab.address?.soon();
  }

  /** The sliders that the motion has. */
  offered() {
    const all = [...this.lab.controls.sliders.values()];
    return all.filter(({ info, element }) => !element.hidden && !LEFT_OUT.test(info.path)).map(({ info }) => info);
  }

  // The parameter, its value in SI units and a step of it; nothing where it has no value.
  parameter() {
    const info = this.offered().find(({ path }) => path === this.path);
    if (!info) return null;
    const value = this.lab.film().value(info.path);
    return { info, value: Number(value === "inf" ? Infinity : value), step: info.step * sizeOf(info.unit) };
  }

  /** Another motion is there, another parameter, or another language. */
  changed(speak = false) {
    if (!this.on) return;
    this.speak ||= speak;
    if (!this.lab.motions.lanes.length) return; // the first motion is still computed, and comes here when it is there
    this.offer();
    const { query } = this.lab.film();
    if (this.known === `${this.path} ${query}`) this.tell();
    else {
      this.forget();
      this.later();
    }
  }

  offer() {
    const infos = this.offered();
    if (!infos.some(({ path }) => path === this.path)) {
      this.path = infos.find(({ path }) => path.startsWith(FIRST))?.path ?? infos[0].path;
    }
    const paths = infos.map(({ path }) => path).join();
    if (paths !== this.paths) {
      this.paths = paths;
      const option = ({ path, symbol }: SliderInfo) => h("option", { value: path }, `parameter.${path}`, " ", symbol);
      this.picked.replaceChildren(...infos.map(option));
    }
    this.picked.value = this.path;
  }

  forget() {
    this.asked?.abort();
    this.changes = null;
    this.arrows = [];
    this.factor = 0;
  }

  async fetch() {
    if (!this.on) return;
    const { lab, path } = this;
    const film = lab.film();
    const found = this.parameter();
    this.asked?.abort();
    this.asked = new AbortController();
    const { signal } = this.asked;
    this.known = `${path} ${film.query}`;
    if (!found || !Number.isFinite(found.value)) return this.refuse("sensitivity.infinite");
    try {
      const rates = await lab.backend.changes(film, path, found.value, found.step, signal);
      if (signal.aborted || lab.film() !== film) return undefined;
      if (!rates) return this.refuse("reason.edge");
      this.changes = new Changes(film, rates, found.step);
      this.arrows = arrowsOf(this.changes);
      this.factor = 0; // until they are drawn
      this.tell();
    } catch (error) {
      if (error.name !== "AbortError" && !signal.aborted) this.refuse(messageOf(error));
    }
    lab.request();
    return undefined;
  }

  /** No numbers: why. */
  refuse(words: Message) {
    this.forget();
    this.take.disabled = true;
    for (const place of [this.step, this.said, this.body]) place.replaceChildren();
    this.rows.hidden = this.scale.hidden = true;
    this.reason.hidden = false;
    say(this.reason, words);
    if (this.speak) this.lab.story.say(words);
    this.speak = false;
    this.lab.request();
  }

  tell() {
    const { changes } = this;
    const found = this.parameter();
    if (!changes || !found) return;
    const { info, value } = found;
    const written = (one: number) => withUnit(show(one / sizeOf(info.unit), 5), info.unit);
    const than = `${written(value)} → ${written(value + changes.step)}`;
    this.step.textContent = than;
    this.take.disabled = false;
    this.rows.hidden = this.scale.hidden = false;
    const said = sentences(changes);
    if (!said.length && changes.count === changes.events.length) said.push("sensitivity.nothing");
    this.said.replaceChildren(...said.map((sentence) => h("li", [sentence])));
    const why = this.why(changes);
    this.reason.hidden = !why;
    say(this.reason, why);
    this.fill(changes);
    this.tellScale();
    if (this.speak)
      this.lab.story.say([
        `parameter.${info.path}`,
        ` ${than}.`,
        ...[...said, why].flatMap((sentence) => (sentence ? [" ", sentence] : [])),
      ]);
    this.speak = false;
  }

  /** Another picture is on the screen. */
  frame() {
    const { three } = this.lab.stage.options;
    if (this.on && three !== this.three && this.changes) this.tellScale();
    this.three = three;
  }

  // How arrows are drawn, which depends on how large the hoop is.
  tellScale() {
    const { three } = this.lab.stage.options;
    const drawn = three
      ? "sensitivity.not_in_space"
      : { key: "sensitivity.scale", values: { factor: show(this.factor, 3) } };
    say(this.scale, three || this.factor ? drawn : "");
  }

  /** From where on there are other events, or why the rates hold to one side only. */
  why({ events, count, rates: { edge, sided } }: Changes): Message {
    if (count < events.length) {
      const { kind, t: time } = events[count];
      return { key: "sensitivity.ends", values: { what: eventWord(kind), time: show(time, 4) } };
    }
    if (!edge && !sided) return "";
    return { key: "sensitivity.one_sided", values: { reason: edge ? "reason.edge" : "reason.sided" } };
  }

  fill(changes: Changes) {
    const cell = (value: number, unit: Unit, rate: number) => {
      const text = signed(value, unit);
      const mark = text[0] === "+" ? "▲ " : text[0] === "−" ? "▼ " : "";
      return h("td", { "data-rate": String(rate) }, mark && h("span", { "aria-hidden": "true" }, mark), text);
    };
    const units = [
      ["t", "s"],
      ["x", "m"],
      ["height", "m"],
      ["angle", "°"],
    ] as const;
    this.body.replaceChildren(
      ...changes.events.slice(0, Math.min(changes.count, MOST)).map(({ kind, t: time }, k) =>
        h(
          "tr",
          { onclick: () => this.lab.clock.seek(time) },
          h("th", { scope: "row" }, eventWord(kind), h("small", ` ${show(time, 4)} s`)),
          units.map(([name, unit]) => cell(changes.of(k, name), unit, changes.rate(k, name))),
        ),
      ),
    );
  }

  // The step, so that one sees whether it was told right.
  apply() {
    const found = this.parameter();
    if (!found || !this.changes) return;
    const value = Number((found.value + this.changes.step).toPrecision(12));
    this.lab.motions.change([[this.path, value]], true);
  }
}
