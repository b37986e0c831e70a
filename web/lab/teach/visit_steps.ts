// The guided visit: what is asked, and what the computed motion answers. Nothing is known here before it is computed.

import { modulo } from "../common/clamp.ts";
import { DEGREE, degrees, show } from "../common/numbers.ts";
import { choices, dial, sketch, type Guess } from "./predict.ts";

interface Answer {
  truth: any; // what the guess is compared with
  values?: Named<string>; // of what happened
}
/** Its title, text, question, answer and why are said by its key. */
export interface Step {
  key: string;
  queries: string[]; // the motion, or two
  guess?: (onguess: () => void) => Guess;
  until?: (films: Film[]) => number; // where the film stops [s]
  answer?: (films: Film[]) => Answer;
}

const WHOLE = 2 * Math.PI;

/** The first event of a kind, after a time. */
export const first = (film: Film, kind: EventKind, after = -1) =>
  film.events.find((event) => event.kind === kind && event.t > after);

const inTurn = (angle: number) => degrees(modulo(angle, WHOLE));

/** A quantity at equal steps of the first turn. */
function overTurn(film: Film, column: string, steps = 72) {
  const { angle } = film.columns;
  const values = film.columns[column];
  return Array.from({ length: steps + 1 }, (_, k) => {
    const i = angle.findIndex((value) => value >= angle[0] + (WHOLE * k) / steps);
    return values[i < 0 ? film.length - 1 : i];
  });
}

/** The time at which the hoop has turned so far. */
const timeAt = (film: Film, angle: number) =>
  film.t[film.columns.angle.findIndex((value) => value >= angle)] ?? film.duration;

const AFTER: Named<string> = { R: "roll", S: "spin", K: "skid", H: "bounce" };

export const STEPS: Step[] = [
  {
    key: "hop",
    queries: [""],
    guess: (onguess) => dial("visit.takeoff_angle", onguess),
    until: ([film]) => first(film, "takeoff")?.t ?? film.duration,
    answer: ([film]) => {
      const start = first(film, "takeoff") as MotionEvent;
      const pose = film.at(start.t - 1e-6);
      return {
        truth: start.angle / DEGREE,
        values: { angle: inTurn(start.angle), slip: show(Math.abs(pose.slip), 3) },
      };
    },
  },
  {
    key: "landing",
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
      const top = first(film, "apex");
      return {
        truth: AFTER[film.at((down?.t ?? 0) + 1e-6).mode],
        values: {
          time: show((down?.t ?? 0) - (up?.t ?? 0), 3),
          height: show(100 * (top?.height ?? 0), 3),
          angle: inTurn(down?.angle ?? 0),
        },
      };
    },
  },
  {
    key: "speed",
    queries: ["start.speed=0.1&duration=8"],
    guess: (onguess) => sketch({ label: "visit.curve_axis", unit: "m/s", most: 10 }, onguess),
    until: ([film]) => timeAt(film, WHOLE),
    answer: ([film]) => {
      const speeds = overTurn(film, "vx");
      return { truth: speeds, values: { speed: show(Math.max(...speeds), 2) } };
    },
  },
  {
    key: "slip",
    queries: ["start.speed=2.8"],
    guess: (onguess) => dial("visit.slip_angle", onguess),
    until: ([film]) => first(film, "slip_start")?.t ?? film.duration,
    answer: ([film]) => {
      const slip = first(film, "slip_start") as MotionEvent;
      const force = film.at(slip.t).normal_force / film.weight;
      return { truth: slip.angle / DEGREE, values: { angle: inTurn(slip.angle), share: `${show(100 * force, 2)} %` } };
    },
  },
  {
    key: "friction",
    queries: ["plane.mu=0.05", "plane.mu=0.2", ""],
    guess: (onguess) => choices({ 0: "μ = 0.05", 1: "μ = 0.2", 2: "μ = 1.0" }, onguess),
    until: (films) => 0.3 + Math.max(0, ...films.map((film) => first(film, "impact")?.t ?? 0)),
    answer: (films) => {
      const heights = films.map((film) =>
        Math.max(0, ...film.events.map(({ kind, height }) => (kind === "apex" ? height : 0))),
      );
      const [low, middle, high] = heights.map((height) => show(100 * height, 3));
      return { truth: String(heights.indexOf(Math.max(...heights))), values: { low, middle, high } };
    },
  },
  {
    key: "littlewood",
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
        values: { angle: inTurn(lost?.angle ?? 0) },
      };
    },
  },
  {
    key: "undecided",
    queries: [
      "plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
      "plane.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
    ],
    guess: (onguess) =>
      choices({ flight: "visit.option_flight", impact: "visit.option_impact", both: "visit.option_both" }, onguess),
    until: (films) => Math.min(0.8, ...films.map((film) => film.duration)),
    answer: (films) => ({ truth: films.every((film) => first(film, "painleve_indeterminate")) ? "both" : "flight" }),
  },
  { key: "yours", queries: [""] },
];
