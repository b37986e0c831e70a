// The guided visit: what is asked, and what the computed motion answers. Nothing is known here before it is computed.

import { degrees, show } from "../common/numbers.ts";
import { choices, dial, sketch, type Guess } from "./predict.ts";

export interface Answer {
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

const inTurn = (angle: number) => degrees(angle - WHOLE * Math.floor(angle / WHOLE));

/** A quantity at equal steps of the first turn. */
export function overTurn(film: Film, column: string, steps = 72) {
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
    key: "littlewood",
    title: "visit.littlewoods_question",
    text: "visit.a_hoop_without_mass",
    question: "visit.what_do_you_think",
    queries: ["hoop.load_fraction=1&start.speed=0.1&duration=3"],
    guess: (onguess) =>
      choices(
        { roll: "visit.it_rolls_on", hop: "visit.it_hops_the_hoop", skim: "visit.the_weight_falls_freely" },
        onguess,
      ),
    until: ([film]) => {
      const [lost, struck] = [first(film, "skim"), first(film, "impact")];
      return lost ? lost.t + 0.7 * ((struck?.t ?? film.duration) - lost.t) : film.duration;
    },
    answer: ([film]) => {
      const lost = first(film, "skim") ?? first(film, "takeoff");
      return {
        truth: lost?.kind === "skim" ? "skim" : lost ? "hop" : "roll",
        text: "visit.at_angle_there_is",
        values: { angle: inTurn(lost?.angle ?? 0) },
      };
    },
    why: "visit.littlewood_said_that_the",
  },
  {
    key: "speed",
    title: "visit.a_ring_with_mass",
    text: "visit.now_a_quarter_of",
    question: "visit.draw_how_fast_the",
    queries: ["start.speed=0.1&duration=8"],
    guess: (onguess) => sketch({ label: "visit.speed_of_the_centre", unit: "m/s", most: 10 }, onguess),
    until: ([film]) => timeAt(film, WHOLE),
    answer: ([film]) => {
      const speeds = overTurn(film, "vx");
      return { truth: speeds, text: "visit.with_the_load_at", values: { speed: show(Math.max(...speeds), 2) } };
    },
    why: "visit.the_lowest_point_of",
  },
  {
    key: "slip",
    title: "visit.why_it_slips",
    text: "visit.a_harder_push_2",
    question: "visit.where_is_the_load",
    queries: ["start.speed=2.8"],
    guess: (onguess) => dial("visit.angle_of_the_load", onguess),
    until: ([film]) => first(film, "slip_start")?.t ?? film.duration,
    answer: ([film]) => {
      const slip = first(film, "slip_start") as MotionEvent;
      const force = film.at(slip.t).normal_force / (film.mass * film.gravity);
      return {
        truth: (slip.angle * 180) / Math.PI,
        text: "visit.it_begins_to_slip",
        values: { angle: inTurn(slip.angle), share: `${show(100 * force, 2)} %` },
      };
    },
    why: "visit.the_load_on_its",
  },
  {
    key: "hop",
    title: "visit.the_hop",
    text: "visit.a_little_faster_3",
    question: "visit.where_is_the_load_when",
    queries: [""],
    guess: (onguess) => dial("visit.angle_of_the_load_where", onguess),
    until: ([film]) => first(film, "takeoff")?.t ?? film.duration,
    answer: ([film]) => {
      const start = first(film, "takeoff") as MotionEvent;
      const pose = film.at(start.t - 1e-6);
      return {
        truth: (start.angle * 180) / Math.PI,
        text: "visit.it_takes_off_at",
        values: { angle: inTurn(start.angle), slip: show(Math.abs(pose.slip), 3) },
      };
    },
    why: "visit.a_rolling_hoop_would",
  },
  {
    key: "landing",
    title: "visit.the_landing",
    text: "visit.the_hoop_is_in",
    question: "visit.what_does_it_do",
    queries: [""],
    guess: (onguess) =>
      choices(
        {
          roll: "visit.it_rolls_at_once",
          skid: "visit.it_skids_the_rim",
          spin: "visit.it_spins_the_rim",
          bounce: "visit.it_bounces",
        },
        onguess,
      ),
    until: ([film]) => first(film, "impact")?.t ?? film.duration,
    answer: ([film]) => {
      const [up, down] = [first(film, "takeoff"), first(film, "impact")];
      const top = film.events.find((event) => event.kind === "apex");
      return {
        truth: AFTER[film.at((down?.t ?? 0) + 1e-6).mode],
        text: "visit.it_was_in_the",
        values: {
          time: show((down?.t ?? 0) - (up?.t ?? 0), 3),
          height: show(100 * (top?.height ?? 0), 3),
          angle: inTurn(down?.angle ?? 0),
        },
      };
    },
    why: "visit.an_impact_takes_no",
  },
  {
    key: "friction",
    title: "visit.more_friction_more_hop",
    text: "visit.three_hoops_get_the",
    question: "visit.which_of_them_hops",
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
        text: "visit.they_rise_by_low",
        values: { low, middle, high },
      };
    },
    why: "visit.on_ice_nothing_drives",
  },
  {
    key: "undecided",
    title: "visit.what_rigid_bodies_cannot",
    text: "visit.a_hoop_is_thrown",
    question: "visit.what_do_they_say",
    queries: [
      "plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
      "plane.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
    ],
    guess: (onguess) =>
      choices(
        { flight: "visit.it_flies_off", impact: "visit.an_impact_stops_the", both: "visit.both_agree_with_the" },
        onguess,
      ),
    until: (films) => Math.min(0.8, ...films.map((film) => film.duration)),
    answer: (films) => ({
      truth: films.every((film) => first(film, "painleve_indeterminate")) ? "both" : "flight",
      text: "visit.hoop_a_and_hoop",
    }),
    why: "visit.painleve_found_this_in",
  },
  { key: "yours", title: "visit.your_turn", text: "visit.take_the_hoop_turn", question: "", queries: [""] },
];
