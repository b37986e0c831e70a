// The guided visit: at each step the visitor says what will happen, then the computed motion plays and answers.

import { h, say } from "../common/dom.ts";
import { Film } from "../player/film.ts";
import { recall, remember } from "../shell/memory.ts";
import { STEPS, type Step } from "./visit_steps.ts";
import { name } from "../words/words.ts";
import type { Lab } from "../shell/lab.ts";
import type { Guess } from "./predict.ts";

const KEY = "hophoop-visit";

export class Visit {
  step: Step | null = null;
  guess: Guess | null = null;
  /** All motions of the step; the player shows two of them at most. */
  films: Film[] = [];
  /** Points of the steps that have been guessed. */
  points = new Map<string, number>();
  play: HTMLButtonElement;
  skip: HTMLButtonElement;
  wait: HTMLElement;
  next: HTMLButtonElement;
  /** Whether the film was seen running. */
  running = false;
  /** Where the film stops by itself. */
  stop: number | null = null;
  /** Whether the film repeated before. */
  loop: boolean | null = null;
  /** Counts what has been asked for, so that an answer to an earlier step is not shown. */
  asked = 0;

  body = h("div.visit-body");
  said = h("div.visit-answer", { role: "status" });
  element = h("section.visit.card", { "aria-label": "menu.visit", hidden: true }, this.body, this.said);

  constructor(
    readonly lab: Pick<
      Lab,
      "changed" | "clock" | "extras" | "films" | "mark" | "motions" | "notice" | "opening" | "show" | "stage"
    >,
  ) {}

  /** Whether the visitor still guesses: then nothing may tell what will happen. */
  get guessing() {
    return Boolean(this.guess) && !this.said.textContent;
  }

  /** A first visit is offered, not forced. */
  offer() {
    if (recall(KEY)) return;
    this.element.hidden = false;
    say(this.said, "");
    this.body.replaceChildren(
      h(
        "div.buttons.offer",
        h("p", h("b", "visit.new_here"), " ", "visit.offer"),
        h("button.main", { onclick: () => this.start() }, "teach.start_visit"),
        h("button", { onclick: () => this.leave() }, "visit.decline"),
      ),
    );
  }

  start() {
    this.points.clear();
    this.go(0);
  }

  leave() {
    remember(KEY, "seen");
    this.asked += 1;
    this.step = this.guess = this.stop = null;
    this.element.hidden = true;
    this.unwind();
    this.lab.mark("visiting", false);
    this.veil();
    this.lab.show();
  }

  async go(number: number) {
    const step = STEPS[number];
    const asked = ++this.asked;
    this.lab.opening.end();
    const { lab } = this;
    lab.clock.play(false);
    lab.clock.time = 0;
    this.step = step;
    this.stop = null;
    this.guess = null;
    this.unwind();
    say(this.said, "");
    this.element.hidden = false;
    lab.mark("visiting", number < STEPS.length - 1);
    try {
      const replies = await Promise.all(step.queries.map((query) => lab.motions.ask({ query })));
      if (asked !== this.asked) return;
      this.films = replies.map((reply) => new Film(reply));
      lab.motions.active = 0;
      lab.motions.set(replies.slice(0, 2));
      this.guess = step.guess?.(() => this.guessed()) ?? null;
      this.veil();
      lab.changed();
      lab.motions.note();
      this.fill(number);
    } catch (error) {
      lab.notice.fail(error);
    }
  }

  /** What would tell the answer waits for the guess. */
  veil() {
    this.lab.mark("guessing", this.guessing);
    if (this.guessing) name(this.lab.stage.element, "aria-label", "visit.veiled");
  }

  fill(number: number) {
    const step = STEPS[number];
    this.play = h("button.main", { disabled: Boolean(this.guess), onclick: () => this.show() }, "visit.play");
    this.running = false;
    this.wait = h("span.hint.visit-wait", "visit.guess_first");
    this.skip = h(
      "button",
      { hidden: true, onclick: () => this.stop !== null && this.lab.clock.seek(this.stop) },
      "visit.skip",
    );
    const last = number === STEPS.length - 1;
    const said = (part: string) => `visit.${step.key}.${part}`;
    const heading = h("h2", { tabindex: "-1" }, said("title"));
    this.next = h("button", { onclick: () => this.go(number + 1) }, "visit.next");
    this.body.replaceChildren(
      h(
        "header",
        h("span.visit-count", { key: "visit.step", values: { number: number + 1, all: STEPS.length } }),
        h("progress", { max: String(STEPS.length), value: String(number + 1), "aria-hidden": "true" }),
        h("button.quiet", { "aria-label": "visit.leave", onclick: () => this.leave() }, "×"),
      ),
      heading,
      h("p", said("text")),
      ...(this.guess ? [h("p.visit-question", said("question")), this.guess.element] : []),
      h(
        "div.buttons",
        number > 0 && h("button", { onclick: () => this.go(number - 1) }, "visit.back"),
        this.guess && this.play,
        this.guess && this.skip,
        last ? h("button.main", { onclick: () => this.challenge() }, "menu.challenges") : this.next,
        last && h("button", { onclick: () => this.leave() }, "visit.done"),
        this.guess && this.wait,
      ),
    );
    if (last && this.points.size) this.total();
    heading.focus({ preventScroll: true });
  }

  guessed() {
    if (this.play) this.play.disabled = false;
    this.wait.hidden = true;
  }

  /** The film runs to the moment that answers, then the answer is said; meanwhile it can be halted, and skipped. */
  show() {
    const { lab, step } = this;
    if (!step || !this.guess) return;
    if (this.stop !== null) {
      lab.clock.play();
      return;
    }
    this.stop = step.until?.(lab.films()) ?? lab.clock.duration;
    this.loop ??= lab.clock.loop;
    lab.clock.loop = false;
    lab.clock.seek(0);
    lab.clock.run({ to: this.stop });
    this.frame();
  }

  /** The film repeats again, if it did. */
  unwind() {
    if (this.loop !== null) this.lab.clock.loop = this.loop;
    this.loop = null;
  }

  /** Called with each picture. */
  frame() {
    const { clock } = this.lab;
    if (this.stop === null) return;
    this.skip.hidden = false;
    if (this.running !== clock.playing) {
      this.running = clock.playing;
      say(this.play, this.running ? "visit.pause" : "visit.play");
    }
    if (clock.time < this.stop - 1e-9) return;
    clock.playing = false;
    const at = this.stop;
    this.stop = null;
    this.unwind();
    clock.seek(at);
    this.judge();
  }

  judge() {
    const { step, guess } = this;
    if (!step?.answer || !guess) return;
    const { truth, values = {} } = step.answer(this.films);
    const points = guess.judge(truth);
    this.points.set(step.key, points);
    this.play.hidden = this.skip.hidden = true;
    this.said.replaceChildren(
      h("p", h("b", points ? { key: "visit.points", values: { points } } : "visit.wrong"), " ", {
        key: `visit.${step.key}.answer`,
        values,
      }),
      h("p", `visit.${step.key}.why`),
    );
    this.veil();
    this.next.classList.add("main");
    this.lab.show();
    this.said.scrollIntoView({ block: "nearest" });
  }

  total() {
    const sum = [...this.points.values()].reduce((one, other) => one + other, 0);
    this.said.replaceChildren(h("p", { key: "visit.total", values: { sum, most: 100 * this.points.size } }));
  }

  challenge() {
    this.leave();
    this.lab.extras.challenges.open();
  }

  /** Another motion is there, or other colours. A question about a motion that is not shown any more ends the visit. */
  changed() {
    this.guess?.redraw?.();
    if (!this.guessing) return;
    if (this.lab.films().every(({ query }, k) => query === this.films[k]?.query)) this.veil();
    else this.leave();
  }
}
