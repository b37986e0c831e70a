// The guided visit: what is asked, and what the computed motion answers. Nothing is known here before it is computed.

import { modulo } from "../common/clamp.ts";
import { DEGREE, degrees, show } from "../common/numbers.ts";
import { choices, dial, sketch, type Guess } from "./predict.ts";

interface Answer {
  truth: any; // what the guess is compared with
  text: string; // what happened, with {places}
  values?: Record<string, string>;
}
export interface Step {
  key: string;
  title: string;
  text: string;
  question: string;
  queries: string[]; // the motion, or two
  guess?: (onguess: () => void) => Guess;
  until?: (films: Film[]) => number; // where the film stops [s]
  answer?: (films: Film[]) => Answer;
  why?: string;
}

const WHOLE = 2 * Math.PI;

const first = (film: Film, kind: string) => film.events.find((event) => event.kind === kind);

const inTurn = (angle: number) => degrees(modulo(angle, WHOLE));

/** A quantity at equal steps of the first turn. */
function overTurn(film: Film, column: string, steps = 72) {
  const { angle } = film.columns;
  const values = film.columns[column];
  const found = [];
  let i = 0;
  for (let k = 0; k <= steps; k++) {
    const wanted = film.columns.angle[0] + (WHOLE * k) / steps;
    while (i + 1 < film.length && angle[i + 1] < wanted) i += 1;
    const j = Math.min(i + 1, film.length - 1);
    const share = angle[j] > angle[i] ? Math.min((wanted - angle[i]) / (angle[j] - angle[i]), 1) : 0;
    found.push(values[i] + share * (values[j] - values[i]));
  }
  return found;
}

/** The time at which the hoop has turned so far. */
const timeAt = (film: Film, angle: number) =>
  film.t[film.columns.angle.findIndex((value) => value >= angle)] ?? film.duration;

const AFTER: Record<string, string> = { R: "roll", S: "spin", K: "skid", H: "bounce" };

export const STEPS: Step[] = [
  {
    key: "hop",
    title: "visit.title_takeoff",
    text: "visit.ask_takeoff",
    question: "visit.mark_takeoff",
    queries: [""],
    guess: (onguess) => dial("visit.takeoff_angle", onguess),
    until: ([film]) => first(film, "takeoff")?.t ?? film.duration,
    answer: ([film]) => {
      const start = first(film, "takeoff") as MotionEvent;
      const pose = film.at(start.t - 1e-6);
      return {
        truth: start.angle / DEGREE,
        text: "visit.answer_takeoff",
        values: { angle: inTurn(start.angle), slip: show(Math.abs(pose.slip), 3) },
      };
    },
    why: "visit.answer_landing",
  },
  {
    key: "landing",
    title: "visit.title_landing",
    text: "visit.explain_takeoff",
    question: "visit.choose_landing",
    queries: [""],
    guess: (onguess) =>
      choices(
        {
          roll: "visit.option_roll_at_once",
          skid: "visit.option_skid",
          spin: "visit.option_spin",
          bounce: "visit.option_bounce",
        },
        onguess,
      ),
    until: ([film]) => first(film, "impact")?.t ?? film.duration,
    answer: ([film]) => {
      const [up, down] = [first(film, "takeoff"), first(film, "impact")];
      const top = film.events.find((event) => event.kind === "apex");
      return {
        truth: AFTER[film.at((down?.t ?? 0) + 1e-6).mode],
        text: "visit.ask_landing",
        values: {
          time: show((down?.t ?? 0) - (up?.t ?? 0), 3),
          height: show(100 * (top?.height ?? 0), 3),
          angle: inTurn(down?.angle ?? 0),
        },
      };
    },
    why: "visit.explain_landing",
  },
  {
    key: "speed",
    title: "visit.title_ring",
    text: "visit.ask_ring",
    question: "visit.draw_speed",
    queries: ["start.speed=0.1&duration=8"],
    guess: (onguess) => sketch({ label: "visit.curve_axis", unit: "m/s", most: 10 }, onguess),
    until: ([film]) => timeAt(film, WHOLE),
    answer: ([film]) => {
      const speeds = overTurn(film, "vx");
      return { truth: speeds, text: "visit.answer_ring", values: { speed: show(Math.max(...speeds), 2) } };
    },
    why: "visit.explain_ring",
  },
  {
    key: "slip",
    title: "visit.title_slip",
    text: "visit.ask_slip",
    question: "visit.mark_slip",
    queries: ["start.speed=2.8"],
    guess: (onguess) => dial("visit.slip_angle", onguess),
    until: ([film]) => first(film, "slip_start")?.t ?? film.duration,
    answer: ([film]) => {
      const slip = first(film, "slip_start") as MotionEvent;
      const force = film.at(slip.t).normal_force / film.weight;
      return {
        truth: slip.angle / DEGREE,
        text: "visit.answer_slip",
        values: { angle: inTurn(slip.angle), share: `${show(100 * force, 2)} %` },
      };
    },
    why: "visit.explain_slip",
  },
  {
    key: "friction",
    title: "visit.title_friction",
    text: "visit.ask_friction",
    question: "visit.choose_friction",
    queries: ["plane.mu=0.05", "plane.mu=0.2", ""],
    guess: (onguess) => choices({ 0: "μ = 0.05", 1: "μ = 0.2", 2: "μ = 1.0" }, onguess),
    until: (films) => 0.3 + Math.max(0, ...films.map((film) => first(film, "impact")?.t ?? 0)),
    answer: (films) => {
      const heights = films.map((film) =>
        Math.max(0, ...film.events.map(({ kind, height }) => (kind === "apex" ? height : 0))),
      );
      const [low, middle, high] = heights.map((height) => show(100 * height, 3));
      return {
        truth: String(heights.indexOf(Math.max(...heights))),
        text: "visit.answer_friction",
        values: { low, middle, high },
      };
    },
    why: "visit.explain_friction",
  },
  {
    key: "littlewood",
    title: "visit.title_littlewood",
    text: "visit.ask_littlewood",
    question: "visit.choose",
    queries: ["hoop.load_fraction=1&start.speed=0.1&duration=3"],
    guess: (onguess) =>
      choices({ roll: "visit.option_roll_on", hop: "visit.option_hop", skim: "visit.option_skim" }, onguess),
    until: ([film]) => {
      const [lost, struck] = [first(film, "skim"), first(film, "impact")];
      return lost ? lost.t + 0.7 * ((struck?.t ?? film.duration) - lost.t) : film.duration;
    },
    answer: ([film]) => {
      const lost = first(film, "skim") ?? first(film, "takeoff");
      return {
        truth: lost?.kind === "skim" ? "skim" : lost ? "hop" : "roll",
        text: "visit.answer_littlewood",
        values: { angle: inTurn(lost?.angle ?? 0) },
      };
    },
    why: "visit.explain_littlewood",
  },
  {
    key: "undecided",
    title: "visit.title_painleve",
    text: "visit.ask_painleve",
    question: "visit.choose_laws",
    queries: [
      "plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
      "plane.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
    ],
    guess: (onguess) =>
      choices({ flight: "visit.option_flight", impact: "visit.option_impact", both: "visit.option_both" }, onguess),
    until: (films) => Math.min(0.8, ...films.map((film) => film.duration)),
    answer: (films) => ({
      truth: films.every((film) => first(film, "painleve_indeterminate")) ? "both" : "flight",
      text: "visit.answer_painleve",
    }),
    why: "visit.explain_painleve",
  },
  { key: "yours", title: "visit.title_own", text: "visit.explain_own", question: "", queries: [""] },
];
