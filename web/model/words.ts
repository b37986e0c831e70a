// A motion told in words, from its events: the page's side of lab/words.py, with the same sentences.

import { tables } from "./tables.ts";
import { fill, fixed, general } from "./text.ts";

const { letters, modes, verbs, events: kinds, statuses, story: STORY, summary: SUMMARY } = tables.words;
const MOST_TOLD = 400;
const [, SPIN, SKID, FLIGHT, SKIM] = modes;
const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A motion to be told: its events, how it ended, and how it turns at a time between them. */
export type Told = { events: MotionEvent[]; status: string; omega: (number: number) => number };

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
export function story(motion: Told, most = MOST_TOLD): Sentence[] {
  const told: Sentence[] = [];
  let leftOut = 0;
  const many = manyBounces(motion.events);
  for (const [number, event] of motion.events.entries()) {
    const bounces = many.get(number);
    if (bounces === 0) continue;
    const text = bounces === undefined ? say(motion, number, event) : fill(STORY.more_bounces, { count: bounces });
    if (!text) continue;
    if (told.length >= most) {
      leftOut++;
      continue;
    }
    told.push({ t: event.t, event: number, mode: letters[modes.indexOf(wordAfter(motion, number))], text });
  }
  if (leftOut) told.push({ ...told[told.length - 1], text: fill(STORY.left_out, { count: leftOut }) });
  return told;
}

const bounces = (event: MotionEvent) => event.kind === "impact" && event.to === "H" && event.collision !== false;

// Where bounces follow each other: at the first that is not told by itself, how many there are; at the others 0.
function manyBounces(events: MotionEvent[], told = 3, least = 6) {
  const found: Map<number, number> = new Map();
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
export function summary(motion: Told, most = 6) {
  const phrases: string[] = [];
  let changes = 0;
  const many = manyBounces(motion.events, 1);
  for (const [number, event] of motion.events.entries()) {
    const more = many.get(number);
    if (more !== undefined) {
      if (more) phrases.push(fill(SUMMARY.more_bounces, { count: more }));
      continue;
    }
    if (event.kind === "start" || !phrases.length) {
      phrases.push(verbs[wordAfter(motion, number)]);
      continue;
    }
    const phrase = phraseOf(motion, number, event);
    if (!phrase) continue;
    changes++;
    if (changes <= most) phrases.push(fill(SUMMARY.change, { phrase, where: degrees(event.angle) }));
  }
  const rest = changes > most ? fill(SUMMARY.more_changes, { count: changes - most }) : "";
  const text = phrases.join(", ").replaceAll(", and ", " and ") + rest;
  const values = { phrases: text.slice(0, 1).toUpperCase() + text.slice(1), ending: statuses[motion.status] };
  return fill(SUMMARY.sentence, values).trim();
}

function phraseOf(motion: Told, number: number, event: MotionEvent): string {
  if (event.collision === false) return SUMMARY.without_collision;
  if (bounces(event)) return SUMMARY.bounces;
  if (["slip_start", "slip_reversal"].includes(event.kind) || turnsInSlip(event))
    return verbs[wordAfter(motion, number)];
  const { verb, summed_up } = kinds[event.kind];
  return summed_up ? verb : "";
}

function say(motion: Told, number: number, event: MotionEvent): string {
  const word = wordAfter(motion, number);
  const values: Record<string, any> = {
    where: degrees(event.angle),
    verb: verbs[word],
    kind: event.kind.replaceAll("_", " "),
  };
  const name = nameOf(motion.events, number, word, values);
  return fill(STORY[name] ?? STORY.other, values);
}

/** Which sentence tells an event; what it needs besides is added to the values. */
function nameOf(events: MotionEvent[], number: number, word: string, values: Record<string, any>) {
  const event = events[number];
  const { kind } = event;
  if (kind === "start") {
    values.speed = inWords(event.vx);
    values.started = fill(
      word === FLIGHT ? STORY.started_flight : word === SKIM ? STORY.started_skim : STORY.started,
      values,
    );
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
  if (kind === "kane_gain") values.gain = inWords(event.gain);
  return kind === "rest" && event.stable === false ? "rest_unstable" : kind;
}

function takeoff(events: MotionEvent[], number: number, values: Record<string, any>) {
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
function wordAfter(motion: Told, number: number): string {
  const event = motion.events[number];
  return modeWord(event.to, isStill(motion.events, number) ? motion.omega(number) : event.omega);
}

/** What the hoop does: in slip it spins where the rim turns too fast for the way it goes, else it skids. */
export function modeWord(letter: string, omega: number): string {
  if (letter === "S") return omega > 0 ? SPIN : SKID;
  if (letter === "K") return omega < 0 ? SPIN : SKID;
  return modes[letters.indexOf(letter)];
}

/** What was a spin is then a skid, or the reverse. */
const turnsInSlip = (event: MotionEvent) => event.kind === "turn" && (event.to === "S" || event.to === "K");

/** An angle in degrees with one decimal. */
export const degrees = (angle: number) => `${fixed(angle * (180 / Math.PI), 1)}°`.replaceAll("-", "−");

function length(value: number) {
  if (value >= 0.995) return `${inWords(value)} m`;
  return value >= 0.00995 ? `${inWords(value * 100)} cm` : `${inWords(value * 1000)} mm`;
}

/** Three digits, a real minus sign, powers of ten as they are written. */
function inWords(value: number | null) {
  if (value === null || Number.isNaN(value)) return "?";
  const [mantissa, power] = general(value, 3).split("e");
  const raised = power === undefined ? "" : `·10${raisedText(Number(power))}`;
  return `${mantissa}${raised}`.replaceAll("-", "−");
}

const raisedText = (power: number) =>
  [...String(power)].map((sign) => (sign === "-" ? "⁻" : RAISED[Number(sign)])).join("");
