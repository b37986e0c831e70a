// The challenges beside the player: each motion that is shown is scored at once, and the best score is kept.

import { h, say } from "../common/dom.ts";
import { recall, remember } from "../shell/memory.ts";
import { spoken } from "../words/words.ts";
import { DEGREE, degrees, length } from "../common/numbers.ts";
import { first } from "./visit_steps.ts";
import type { Motions } from "../player/motions.ts";
import type { Stage } from "../player/stage.ts";

const KEY = "hophoop-best-";

const drawn = (points: number) => "★".repeat(stars(points)) + "☆".repeat(3 - stars(points));

export class Challenges {
  goal: Goal | null = null;
  solved = new Set<string>(); // challenges whose solution is shown, until they are begun again
  solutions = new Set<string>(); // that were shown, by their links

  tabs = new Map(
    GOALS.map((goal) => [
      goal.key,
      h("button", { "aria-pressed": "false", onclick: () => this.choose(goal) }, `challenge.${goal.key}`),
    ]),
  );
  text = h("p");
  meter = h("meter", { min: "0", max: "100", low: "40", high: "75", optimum: "100", "aria-label": "challenge.score" });
  result = h("p.challenge-result", { role: "status" });
  kept = h("p.hint");
  element = h(
    "section.challenges.card",
    { "aria-label": "menu.challenges", hidden: true },
    h(
      "header",
      h("h2", "menu.challenges"),
      h("button.quiet", { "aria-label": "challenge.leave", onclick: () => this.close() }, "×"),
    ),
    h("div.tabs", { role: "group", "aria-label": "challenge.choice" }, [...this.tabs.values()]),
    this.text,
    this.meter,
    this.result,
    this.kept,
    h(
      "div.buttons",
      h("button", { onclick: () => this.begin() }, "challenge.restart"),
      h("button", { onclick: () => this.solve() }, "challenge.show_best"),
    ),
  );

  constructor(
    readonly motions: Motions,
    readonly stage: Stage,
    readonly load: (query: string) => Promise<void>,
  ) {}

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
    say(this.text, `challenge.${goal.key}_task`);
    // what was done in the lab before may count already; a challenge begins with its own motion only when asked
    this.changed();
  }

  begin() {
    if (!this.goal) return;
    this.solved.delete(this.goal.key);
    this.load(this.goal.start);
  }

  /** A solution that is shown is not the visitor's: it does not count, and nothing that is made of it. */
  async solve() {
    const { goal } = this;
    if (!goal) return;
    this.solved.add(goal.key);
    await this.load(goal.best);
    this.solutions.add(this.motions.film().query);
  }

  /** Another motion is there: its score. A start that is still in the hand does not count. */
  changed() {
    const { goal } = this;
    if (!goal) return;
    const { points, text, values = {} } = goal.score(this.motions.film());
    const counts = !this.solved.has(goal.key) && !this.solutions.has(this.motions.film().query);
    this.meter.value = points;
    const key = counts ? "challenge.points" : "challenge.points_not_counted";
    const said = { key, values: { stars: drawn(points), count: points, what: { key: text, values } } };
    if (this.result.textContent !== spoken(said)) say(this.result, said);
    const kept = Number(recall(KEY + goal.key) ?? 0);
    const best = counts && !this.stage.options.ahead ? Math.max(kept, points) : kept;
    if (best > kept) remember(KEY + goal.key, String(best));
    say(this.kept, { key: "challenge.own_best", values: { count: best } });
  }
}

// --- The challenges: what counts, and how a computed motion is scored. Pure functions of the motion; no hand is in them

interface Score {
  points: number; // from 0 to 100
  text: string; // what was reached, with {places}
  values?: Named<string>;
}
interface Goal {
  key: string; // of its words
  start: string; // the motion to begin with
  best: string; // a motion that has 100 points
  score: (film: Film) => Score;
}

/**
 * The first rule that a motion breaks, in words; empty where it keeps all. `most`: the greatest speed at the start
 * [m/s].
 */
export function broken(film: Film, most: number) {
  const { start, plane, contact, hoop } = film.scenario;
  if (contact.model !== "rigid") return "challenge.limit_contact";
  if (film.slope !== 0) return "challenge.limit_slope";
  if (Math.abs(film.gravity - 9.81) > 1e-9) return "challenge.limit_gravity";
  if ((plane.restitution ?? 0) !== 0) return "challenge.limit_restitution";
  if (film.radius !== 1 || hoop.parts) return "challenge.limit_radius";
  if (film.eccentricity > 0.9) return "challenge.limit_load_fraction";
  if (!("load_fraction" in hoop)) return "challenge.limit_hoop";
  if (!("speed" in start)) return "challenge.limit_rolling";
  if (Math.abs(start.speed ?? 3.1) > most + 1e-9)
    return most > 5 ? "challenge.limit_speed_10" : "challenge.limit_speed_3_1";
  if (film.scenario.duration > 6) return "challenge.limit_duration";
  return "";
}

/** How high each hop is, in order. */
export function heights(film: Film) {
  return film.events.filter(({ kind }) => kind === "apex").map(({ height }) => height);
}

/** No points, and why. */
const none = (text: string): Score => ({ points: 0, text });

/** Points for a height, of the best that is known. */
const rise = (height: number, best: number): Score => ({
  points: Math.min(Math.round((100 * height) / best), 100),
  text: "challenge.result_rise",
  values: { height: length(height) },
});

// of the best motions that a search has found, which stand below [m]
const HIGHEST = 1.596;
const HIGHEST_CLEAN = 0.37;
const LEAST = 0.05; // metres: a hop that can be seen

const GOALS: Goal[] = [
  {
    key: "highest",
    start: "",
    best: "hoop.load_fraction=0.9&plane.mu=0.29",
    score: (film) => {
      const rule = broken(film, 3.1);
      if (rule) return none(rule);
      const top = Math.max(0, ...heights(film));
      if (!top) return none("challenge.result_no_hop");
      return rise(top, HIGHEST);
    },
  },
  {
    key: "upright",
    start: "",
    best: "hoop.load_fraction=0.9&plane.mu=1.34&start.angle=0.7853981633974483&start.speed=5.69",
    score: (film) => {
      const up = first(film, "takeoff");
      const landing = first(film, "impact", up?.t);
      if (!up || !landing) return none("challenge.result_no_hop");
      const top = first(film, "apex", up.t);
      if (!top || top.height < LEAST) return none("challenge.result_low");
      const off = Math.abs(landing.angle - 2 * Math.PI * Math.round(landing.angle / (2 * Math.PI))) / DEGREE;
      const points = Math.max(0, Math.round(100 * (1 - (off - 0.5) / 89.5)));
      return {
        points: Math.min(points, 100),
        text: "challenge.result_landing",
        values: { off: degrees(off * DEGREE) },
      };
    },
  },
  {
    key: "clean",
    start: "start.angle=3.141592653589793&start.speed=8",
    best: "hoop.load_fraction=0.33&plane.mu=1.5&start.angle=3.141592653589793&start.speed=9.94",
    score: (film) => {
      const rule = broken(film, 10);
      if (rule) return none(rule);
      if (Math.abs(Math.abs(film.scenario.start.angle ?? 0) - Math.PI) > 0.5 * DEGREE) {
        return none("challenge.limit_load_angle");
      }
      if (film.values["plane.mu_kinetic"] > 1.5 || film.values["plane.mu_static"] > 1.5) {
        return none("challenge.limit_friction");
      }
      const up = first(film, "takeoff");
      if (!up) return none("challenge.result_no_hop");
      const before = film.phases.filter(({ from }) => from < up.t);
      if (before.some(({ mode }) => mode === "K")) return none("challenge.result_skids");
      if (before[0]?.mode !== "R") return none("challenge.limit_rolling");
      const top = first(film, "apex", up.t);
      if (!top) return none("challenge.result_no_hop");
      return rise(top.height, HIGHEST_CLEAN);
    },
  },
];

const stars = (points: number) => (points >= 95 ? 3 : points >= 75 ? 2 : points >= 40 ? 1 : 0);
