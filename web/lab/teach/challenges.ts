// The challenges beside the player: each motion that is shown is scored at once, and the best score is kept.

import { h, say } from "../common/dom.ts";
import { GOALS, stars, type Goal } from "./goals.ts";
import { recall, remember } from "../shell/memory.ts";
import { spoken } from "../words/words.ts";
import type { Lab } from "../shell/lab.ts";

const KEY = "hophoop-best-";

const drawn = (points: number) => "★".repeat(stars(points)) + "☆".repeat(3 - stars(points));

export class Challenges {
  goal: Goal | null = null;
  solved = new Set<string>(); // challenges whose solution is shown, until they are begun again
  solutions = new Set<string>(); // that were shown, by their links

  tabs = new Map(
    GOALS.map((goal) => [
      goal.key,
      h("button", { "aria-pressed": "false", onclick: () => this.choose(goal) }, goal.title),
    ]),
  );
  text = h("p", {});
  meter = h("meter", { min: "0", max: "100", low: "40", high: "75", optimum: "100", "aria-label": "challenge.score" });
  result = h("p", { class: "challenge-result", role: "status" });
  kept = h("p", { class: "hint" });
  element = h(
    "section",
    { class: "challenges card", "aria-label": "menu.challenges", hidden: true },
    h(
      "header",
      {},
      h("h2", {}, "menu.challenges"),
      h("button", { class: "quiet", "aria-label": "challenge.leave", onclick: () => this.close() }, "×"),
    ),
    h("div", { class: "tabs", role: "group", "aria-label": "challenge.choice" }, [...this.tabs.values()]),
    this.text,
    this.meter,
    this.result,
    this.kept,
    h(
      "div",
      { class: "buttons" },
      h("button", { onclick: () => this.begin() }, "challenge.restart"),
      h("button", { onclick: () => this.solve() }, "challenge.show_best"),
    ),
  );

  constructor(readonly lab: Pick<Lab, "film" | "load" | "stage">) {}

  open() {
    this.element.hidden = false;
    this.choose(this.goal ?? GOALS[0]);
    this.element.scrollIntoView({ block: "nearest" });
    this.tabs.get((this.goal as Goal).key)?.focus({ preventScroll: true });
  }

  close() {
    this.goal = null;
    this.element.hidden = true;
  }

  choose(goal: Goal) {
    this.goal = goal;
    for (const [key, tab] of this.tabs) tab.ariaPressed = String(key === goal.key);
    say(this.text, goal.text);
    // what was done in the lab before may count already; a challenge begins with its own motion only when asked
    this.changed();
  }

  begin() {
    if (!this.goal) return;
    this.solved.delete(this.goal.key);
    this.lab.load(this.goal.start);
  }

  /** A solution that is shown is not the visitor's: it does not count, and nothing that is made of it. */
  async solve() {
    const { goal } = this;
    if (!goal) return;
    this.solved.add(goal.key);
    await this.lab.load(goal.best);
    this.solutions.add(this.lab.film().query);
  }

  /** Another motion is there: its score. A start that is still in the hand does not count. */
  changed() {
    const { goal } = this;
    if (!goal) return;
    const { points, text, values = {} } = goal.score(this.lab.film());
    const counts = !this.solved.has(goal.key) && !this.solutions.has(this.lab.film().query);
    this.meter.value = points;
    const key = counts ? "challenge.points" : "challenge.points_not_counted";
    const said = { key, values: { stars: drawn(points), count: points, what: { key: text, values } } };
    if (this.result.textContent !== spoken(said)) say(this.result, said);
    const kept = Number(recall(KEY + goal.key) ?? 0);
    const best = counts && !this.lab.stage.options.ahead ? Math.max(kept, points) : kept;
    if (best > kept) remember(KEY + goal.key, String(best));
    say(this.kept, { key: "challenge.own_best", values: { count: best } });
  }
}
