// Events in words, and as marks and stretches of the bar of time, so that many of them stay readable.

import { tables } from "../../model/tables.ts";

/** by kind, the rarest first. */
export const MARKS: Named<string> = tables.words.signs;
const RANK = Object.keys(MARKS);

/**
 * Which marks there is room for: the rarer before the usual ones, those at one place side by side, and at the end of
 * each crowd how many are left out. `events`: places in pixels; `room`: between two marks; returns in order of place.
 */
export function placed(events: { kind: string; x: number }[], room = 11) {
  const known = events.filter(({ kind }) => kind in MARKS);
  const order = [...known].sort((a, b) => RANK.indexOf(a.kind) - RANK.indexOf(b.kind) || a.x - b.x);
  const shown: { mark: string; x: number; rare: boolean; hidden: number }[] = [];
  for (const { kind, x } of order) {
    const rare = RANK.indexOf(kind) < RANK.indexOf("takeoff");
    const near = shown.filter((other) => Math.abs(other.x - x) < room);
    if (!near.length) shown.push({ mark: MARKS[kind], x, rare, hidden: 0 });
    // what happens at the same instant as something rare stands beside it
    else if (
      near.length === 1 &&
      near[0].rare &&
      !shown.some((other) => Math.abs(other.x - (near[0].x + room)) < room - 1e-9)
    ) {
      if (near[0].mark !== MARKS[kind]) shown.push({ mark: MARKS[kind], x: near[0].x + room, rare: false, hidden: 0 });
    } else near[0].hidden += 1;
  }
  return shown.sort((a, b) => a.x - b.x).map(({ mark, x }) => ({ mark, x }));
}

/**
 * Stretches of one colour; where phases are shorter than a pixel, each pixel has the mode that lasts longest in it.
 * `phases`: in order of time; `place`: in pixels.
 */
export function stretches(phases: Phase[], place: (t: number) => number, width: number) {
  const found: { mode: string; from: number; wide: number }[] = [];
  let crowd = new Map<string, number>(); // how long each mode lasts in the pixel that is being filled
  let pixel = -1;
  const add = (mode: string, from: number, wide: number) => {
    const last = found.at(-1);
    if (last && last.mode === mode && Math.abs(last.from + last.wide - from) < 1e-6) last.wide += wide;
    else found.push({ mode, from, wide });
  };
  const empty = () => {
    if (crowd.size) add([...crowd].reduce((a, b) => (b[1] > a[1] ? b : a))[0], pixel, 1);
    crowd = new Map();
  };
  for (const { mode, from, to } of phases) {
    const [left, right] = [Math.max(place(from), 0), Math.min(place(to), width)];
    if (!(right > left)) continue;
    for (let at = left; at < right - 1e-9; ) {
      if (Math.floor(at + 1e-9) !== pixel || !crowd.size) {
        empty();
        pixel = Math.floor(at + 1e-9);
        if (right - at >= 1 && Math.abs(at - pixel) < 1e-6) {
          const whole = Math.floor(right - at + 1e-9);
          add(mode, pixel, whole);
          at = pixel + whole;
          continue;
        }
      }
      const end = Math.min(right, pixel + 1);
      crowd.set(mode, (crowd.get(mode) ?? 0) + end - at);
      at = end;
    }
  }
  empty();
  return found;
}

/** The name of a kind of event. */
export const eventWord = (kind: string) => `event.${kind}`;

/** Whether a flight begins here: also without a take-off, at the start or after a paradox. */
export const leaves = (event: MotionEvent) =>
  event.kind === "takeoff" || (event.to === "H" && event.from !== "H" && event.kind !== "impact");
