// What happens in a motion, in the words of the player.

import { tables } from "../../model/tables.ts";

const KINDS: [string, { label: string }][] = Object.entries(tables.words.events);
export const EVENT_WORDS: Record<string, string> = Object.fromEntries(KINDS.map(([kind, { label }]) => [kind, label]));

/** Whether a flight begins here: also without a take-off, at the start or after a paradox. */
export const leaves = (event: MotionEvent) =>
  event.kind === "takeoff" || (event.to === "H" && event.from !== "H" && event.kind !== "impact");
