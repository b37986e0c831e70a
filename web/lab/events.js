// What happens in a motion, in the words of the player.

import { tables } from "../model/tables.js";

/** @type {[string, { label: string }][]} */
const KINDS = Object.entries(tables.words.events);
/** @type {Record<string, string>} */
export const EVENT_WORDS = Object.fromEntries(KINDS.map(([kind, { label }]) => [kind, label]));

/**
 * Whether a flight begins here: also without a take-off, at the start or after a paradox.
 * @param {MotionEvent} event
 */
export const leaves = (event) =>
  event.kind === "takeoff" || (event.to === "H" && event.from !== "H" && event.kind !== "impact");
