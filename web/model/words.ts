// A motion in words, from its events.

import { tables } from "./tables.ts";
import { listed } from "../words/texts.ts";
import { fixed, general, raised, unitOf } from "./text.ts";

const { letters, modes, summed_up: SUMMED_UP } = tables.words;
const MOST_TOLD = 400;
const [, SPIN, SKID, FLIGHT, SKIM] = modes;

/** A motion to be told: its events, how it ended, and how it turns at a time between them. */
type Told = { events: MotionEvent[]; status: MotionStatus; omega: (number: number) => number };

/**
 * Whether the hoop slips but does not turn yet: the word for what follows is that of how it turns halfway to the next
 * event.
 */
function isStill(events: MotionEvent[], number: number) {
  const { omega, to } = events[number];
  return omega === 0 && (to === "S" || to === "K") && number + 1 < events.length;
}

/** Numbers of the events after which it has to be asked how the hoop turns. */
export const stills = (events: MotionEvent[]) => [...events.keys()].filter((number) => isStill(events, number));

/** The time halfway from an event to the next. */
export const halfway = (events: MotionEvent[], number: number) => 0.5 * (events[number].t + events[number + 1].t);

/** The motion as a list of sentences. */
export function story(motion: Told, most = MOST_TOLD) {
  const told: Sentence[] = [];
  let leftOut = 0;
  const many = manyBounces(motion.events);
  for (const [number, event] of motion.events.entries()) {
    const bounces = many.get(number);
    if (bounces === 0) continue;
    if (event.kind === "end") continue;
    const text =
      bounces === undefined ? say(motion, number, event) : { key: "story.more_bounces", values: { count: bounces } };
    if (told.length >= most) {
      leftOut++;
      continue;
    }
    told.push({ t: event.t, mode: letters[modes.indexOf(wordAfter(motion, number))], text });
  }
  if (leftOut) told.push({ ...told[told.length - 1], text: { key: "story.left_out", values: { count: leftOut } } });
  return told;
}

const bounces = (event: MotionEvent) => event.kind === "impact" && event.to === "H" && event.collision !== false;

// Where bounces follow each other: at the first that is not told by itself, how many there are; at the others 0.
function manyBounces(events: MotionEvent[], told = 3, least = 6) {
  const found = new Map<number, number>();
  let run: number[] = [];
  for (let number = 0; number <= events.length; number++) {
    const event = events[number];
    if (event && (bounces(event) || (run.length && event.kind === "apex"))) {
      run.push(number);
      continue;
    }
    const impacts = run.filter((at) => events[at].kind === "impact");
    if (impacts.length >= least) {
      for (const at of run.slice(run.indexOf(impacts[told]))) found.set(at, 0);
      found.set(impacts[told], impacts.length - told);
    }
    run = [];
  }
  return found;
}

/** The motion in one sentence. */
export function summary(motion: Told, most = 6): Phrase {
  const phrases: Message[] = [];
  let changes = 0;
  const many = manyBounces(motion.events, 1);
  for (const [number, event] of motion.events.entries()) {
    const more = many.get(number);
    if (more !== undefined) {
      if (more) phrases.push({ key: "summary.more_times", values: { what: phrases.pop() ?? "", count: more } });
      continue;
    }
    if (event.kind === "start" || !phrases.length) {
      phrases.push(`verb.${wordAfter(motion, number)}`);
      continue;
    }
    const key = phraseOf(motion, number, event);
    if (!key) continue;
    changes++;
    if (changes <= most) phrases.push({ key, values: { where: degrees(event.angle) } });
  }
  if (changes > most) phrases.push({ key: "summary.more_changes", values: { count: changes - most } });
  const ending = `status.${motion.status}`;
  if (motion.status === "completed") return { key: "summary.whole", values: { phrases: listed(phrases) } };
  return { key: "summary.with_ending", values: { phrases: listed(phrases), ending } };
}

function phraseOf(motion: Told, number: number, event: MotionEvent) {
  if (event.collision === false) return "summary.without_collision";
  if (bounces(event)) return "summary.bounces";
  if (["slip_start", "slip_reversal"].includes(event.kind) || turnsInSlip(event))
    return `summary.${wordAfter(motion, number)}`;
  return SUMMED_UP.includes(event.kind) ? `summary.${event.kind}` : "";
}

function say(motion: Told, number: number, event: MotionEvent): Phrase {
  const word = wordAfter(motion, number);
  const values: Values = { where: degrees(event.angle), verb: `verb.${word}` };
  return { key: `story.${nameOf(motion.events, number, word, values)}`, values };
}

/** Which sentence tells an event; what it needs besides is added to the values. */
function nameOf(events: MotionEvent[], number: number, word: string, values: Values) {
  const event = events[number];
  const { kind } = event;
  if (kind === "start") {
    values.speed = inWords(event.vx);
    if (word === FLIGHT || word === SKIM) return `start_${word}`;
  }
  if (kind === "slip_start" && word === SPIN) return "slip_start_spin";
  if (kind === "takeoff") return takeoff(events, number, values);
  if (kind === "impact") {
    values.speed = inWords(event.before.vy === null ? null : Math.abs(event.before.vy));
    if (event.collision === false) return "impact_without_collision";
    return event.to === "H" ? "impact_bounce" : kind;
  }
  if (kind === "turn" && turnsInSlip(event)) return "turn_in_slip";
  if (kind === "apex") values.gap = length(event.height);
  if (kind === "kane_gain") values.gain = inWords(event.gain ?? null);
  return kind === "rest" && event.stable === false ? "rest_unstable" : kind;
}

function takeoff(events: MotionEvent[], number: number, values: Values) {
  const { t } = events[number];
  let top = 0;
  for (let at = number; at < events.length; at++) {
    top = Math.max(top, events[at].height);
    if (at === number || events[at].kind !== "impact") continue;
    for (let also = at + 1; also < events.length && events[also].t <= events[at].t; also++) {
      top = Math.max(top, events[also].height);
    }
    if (!top) break;
    values.top = length(top);
    values.time = inWords(events[at].t - t);
    return "takeoff_and_landing";
  }
  return "takeoff";
}

/** The word for the mode that follows an event. */
function wordAfter(motion: Told, number: number) {
  const event = motion.events[number];
  return modeWord(event.to, isStill(motion.events, number) ? motion.omega(number) : event.omega);
}

/** What the hoop does: in slip it spins where the rim turns too fast for the way it goes, else it skids. */
function modeWord(letter: string, omega: number) {
  if (letter === "S") return omega > 0 ? SPIN : SKID;
  if (letter === "K") return omega < 0 ? SPIN : SKID;
  return modes[letters.indexOf(letter)];
}

/** What was a spin is then a skid, or the reverse. */
const turnsInSlip = (event: MotionEvent) => event.kind === "turn" && (event.to === "S" || event.to === "K");

/** An angle in degrees with one decimal. */
export const degrees = (angle: number) => `${fixed(angle * (180 / Math.PI), 1)}°`.replaceAll("-", "−");

function length(value: number) {
  const [scale, unit] = unitOf(value);
  return `${inWords(value * scale)} ${unit}`;
}

/** Three digits, a real minus sign, powers of ten as they are written. */
function inWords(value: number | null) {
  if (value === null || Number.isNaN(value)) return "?";
  const [mantissa, power] = general(value, 3).split("e");
  return (power === undefined ? mantissa : `${mantissa}·10${raised(Number(power))}`).replaceAll("-", "−");
}
