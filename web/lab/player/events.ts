// What happens in a motion, in the words of the player.

/** The name of a kind of event. */
export const eventWord = (kind: string) => `event.${kind}`;

/** Whether a flight begins here: also without a take-off, at the start or after a paradox. */
export const leaves = (event: MotionEvent) =>
  event.kind === "takeoff" || (event.to === "H" && event.from !== "H" && event.kind !== "impact");
