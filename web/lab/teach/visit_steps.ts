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
    title: "Littlewood’s question",
    text:
      "A hoop without mass has a weight on its rim. With the weight at the top it gets the smallest push and rolls. " +
      "J. E. Littlewood asked in 1953 what happens when the weight is level with the centre.",
    question: "What do you think?",
    queries: ["hoop.load_fraction=1&start.speed=0.1&duration=3"],
    guess: (onguess) =>
      choices(
        [
          ["roll", "It rolls on."],
          ["hop", "It hops: the hoop leaves the plane."],
          ["skim", "The weight falls freely, and the hoop skims the plane below it."],
        ],
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
        text: "At {angle} there is no contact force any more.",
        values: { angle: inTurn(lost?.angle ?? 0) },
      };
    },
    why:
      "Littlewood said that the hoop hops. But the contact force is zero, not upwards: the weight falls freely, and a " +
      "rim without mass follows it along the plane. To hop, a hoop needs some mass in its rim.",
  },
  {
    key: "speed",
    title: "A ring with mass",
    text: "Now a quarter of the mass is in the ring. Again the load is at the top, and the hoop gets the smallest push.",
    question: "Draw how fast the hoop’s centre goes during the first turn.",
    queries: ["start.speed=0.1&duration=8"],
    guess: (onguess) => sketch({ label: "Speed of the centre", unit: "m/s", most: 10 }, onguess),
    until: ([film]) => timeAt(film, WHOLE),
    answer: ([film]) => {
      const speeds = overTurn(film, "vx");
      return {
        truth: speeds,
        text: "With the load at the bottom the centre has {speed} m/s.",
        values: { speed: show(Math.max(...speeds), 2) },
      };
    },
    why:
      "The lowest point of a rolling hoop is at rest. There the load has no kinetic energy, and the light ring has all " +
      "that the heavy load has lost: it is faster than a stone that falls from the same height.",
  },
  {
    key: "slip",
    title: "Why it slips",
    text: "A harder push: 2.8 m/s at the top. Rolling needs friction, and friction has a limit: it is at most μ N.",
    question: "Where is the load when friction gives way for the first time? Turn the mark.",
    queries: ["start.speed=2.8"],
    guess: (onguess) => dial("Angle of the load where it begins to slip", onguess),
    until: ([film]) => first(film, "slip_start")?.t ?? film.duration,
    answer: ([film]) => {
      const slip = first(film, "slip_start") as MotionEvent;
      const force = film.at(slip.t).normal_force / (film.mass * film.gravity);
      return {
        truth: (slip.angle * 180) / Math.PI,
        text: "It begins to slip at {angle}. There the plane carries only {share} of the weight.",
        values: { angle: inTurn(slip.angle), share: `${show(100 * force, 2)} %` },
      };
    },
    why:
      "The load on its way down and round presses little on the plane, so that N is small, while the ring has to be " +
      "made faster: that takes friction. Watch the diagram ‘Use of friction’: it comes to 1.",
  },
  {
    key: "hop",
    title: "The hop",
    text: "A little faster, 3.1 m/s. This time the hoop leaves the plane, before the first turn is over.",
    question: "Where is the load when the hoop takes off? Turn the mark.",
    queries: [""],
    guess: (onguess) => dial("Angle of the load where it takes off", onguess),
    until: ([film]) => first(film, "takeoff")?.t ?? film.duration,
    answer: ([film]) => {
      const start = first(film, "takeoff") as MotionEvent;
      const pose = film.at(start.t - 1e-6);
      return {
        truth: (start.angle * 180) / Math.PI,
        text: "It takes off at {angle}, while its rim slips at {slip} m/s.",
        values: { angle: inTurn(start.angle), slip: show(Math.abs(pose.slip), 3) },
      };
    },
    why:
      "A rolling hoop would be braked by the plane while the load comes up. Friction is too weak for that: the rim " +
      "spins, the hoop goes on turning fast, and the load pulls it off the plane before it is at the top.",
  },
  {
    key: "landing",
    title: "The landing",
    text: "The hoop is in the air. Its centre of gravity goes on a parabola, and it turns evenly.",
    question: "What does it do just after it has landed?",
    queries: [""],
    guess: (onguess) =>
      choices(
        [
          ["roll", "It rolls at once."],
          ["skid", "It skids: the rim slides ahead."],
          ["spin", "It spins: the rim turns too fast."],
          ["bounce", "It bounces."],
        ],
        onguess,
      ),
    until: ([film]) => first(film, "impact")?.t ?? film.duration,
    answer: ([film]) => {
      const [up, down] = [first(film, "takeoff"), first(film, "impact")];
      const top = film.events.find((event) => event.kind === "apex");
      return {
        truth: AFTER[film.at((down?.t ?? 0) + 1e-6).mode],
        text: "It was in the air for {time} s and rose by {height} cm; it lands with the load at {angle}.",
        values: {
          time: show((down?.t ?? 0) - (up?.t ?? 0), 3),
          height: show(100 * (top?.height ?? 0), 3),
          angle: inTurn(down?.angle ?? 0),
        },
      };
    },
    why:
      "An impact takes no time, but its friction is as strong as its push: here it is enough to stop all slip. With " +
      "less friction, or more restitution, the landing would be another one. Try it afterwards.",
  },
  {
    key: "friction",
    title: "More friction, more hop?",
    text: "Three hoops get the same push of 3.1 m/s, on planes with friction 0.05, 0.2 and 1.0.",
    question: "Which of them hops highest?",
    queries: ["plane.mu=0.05", "plane.mu=0.2", ""],
    guess: (onguess) =>
      choices(
        [
          ["0", "μ = 0.05"],
          ["1", "μ = 0.2"],
          ["2", "μ = 1.0"],
        ],
        onguess,
      ),
    until: (films) => 0.3 + Math.max(0, ...films.map((film) => first(film, "impact")?.t ?? 0)),
    answer: (films) => {
      const heights = films.map((film) =>
        Math.max(0, ...film.events.map(({ kind, height }) => (kind === "apex" ? height : 0))),
      );
      const [low, middle, high] = heights.map((height) => show(100 * height, 3));
      return {
        truth: String(heights.indexOf(Math.max(...heights))),
        text: "They rise by {low} cm, {middle} cm and {high} cm. (The first two are A and B.)",
        values: { low, middle, high },
      };
    },
    why:
      "On ice nothing drives the rotation; with endless friction nothing slips. The hop needs both: enough friction to " +
      "turn the hoop fast on the way down, and not so much that it is braked on the way up.",
  },
  {
    key: "undecided",
    title: "What rigid bodies cannot decide",
    text:
      "A hoop is thrown so that it slides fast over a rough plane. The laws of rigid bodies with dry friction have " +
      "to say what happens next.",
    question: "What do they say?",
    queries: [
      "plane.mu=1.2&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
      "plane.mu=1.2&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=3",
    ],
    guess: (onguess) =>
      choices(
        [
          ["flight", "It flies off."],
          ["impact", "An impact stops the slide at once."],
          ["both", "Both agree with the laws."],
        ],
        onguess,
      ),
    until: (films) => Math.min(0.8, ...films.map((film) => film.duration)),
    answer: (films) => ({
      truth: films.every((film) => first(film, "painleve_indeterminate")) ? "both" : "flight",
      text: "Hoop A and hoop B start alike, and both motions obey every law.",
    }),
    why:
      "Painlevé found this in 1895. For a rigid body the laws have two answers here, in other states none. Real bodies " +
      "yield a little, and that decides: choose the compliant contact under ‘Contact’.",
  },
  {
    key: "yours",
    title: "Your turn",
    text:
      "Take the hoop: turn the load, lift the hoop and let it drop, flick it, tilt the plane. Or accept a challenge, " +
      "and see how your scores are computed from the motion itself.",
    question: "",
    queries: [""],
  },
];
