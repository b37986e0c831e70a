// What happens in a motion, in the words of the player.

/** The name of a kind of event. @param {string} kind */
export const eventWord = (kind) => `event.${kind}`;

/**
 * Whether a flight begins here: also without a take-off, at the start or after a paradox.
 * @param {MotionEvent} event
 */
export const leaves = (event) =>
  event.kind === "takeoff" || (event.to === "H" && event.from !== "H" && event.kind !== "impact");
