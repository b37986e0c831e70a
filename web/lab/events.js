// What happens in a motion, in the words of the player.

/** @type {Record<string, string>} */
export const EVENT_WORDS = {
  start: "start",
  slip_start: "slip begins",
  stick: "slip ends",
  slip_reversal: "slip turns round",
  takeoff: "take-off",
  impact: "landing",
  turn: "turns back",
  apex: "highest point",
  bounce_limit: "bounces end",
  painleve_inconsistent: "Painlevé: no solution",
  painleve_indeterminate: "Painlevé: several solutions",
  jam: "jam",
  kane_gain: "energy gain (Kane)",
  skim: "skimming begins",
  rest: "at rest",
  end: "end",
};

/**
 * Whether a flight begins here: also without a take-off, at the start or after a paradox.
 * @param {MotionEvent} event
 */
export const leaves = (event) =>
  event.kind === "takeoff" || (event.to === "H" && event.from !== "H" && event.kind !== "impact");
