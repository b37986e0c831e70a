// What a map shows that is not the motion in the player, in words.

const FREE = ["start.height", "start.vx", "start.vy", "start.omega"];

/**
 * What a map's axes make of the start: rolling, or in any state, whichever way the motion that is shown starts.
 * `paths`: of the axes.
 */
export function otherStart(scenario: Scenario, paths: string[]) {
  const rolling = "speed" in scenario.start;
  if (!rolling && paths.includes("start.speed")) return "map.start_rolling";
  if (rolling && paths.some((path) => FREE.includes(path))) {
    return "map.start_free";
  }
  return "";
}
