// The keyboard of the player.

/** @typedef {import("./lab.js").Lab} Lab */

/**
 * What a key does.
 * @param {Lab} lab
 * @param {boolean} shift
 * @returns {Record<string, () => void>}
 */
const actions = (lab, shift) => ({
  " ": () => lab.clock.play(),
  ArrowLeft: () => (shift ? lab.transport.jump(-1) : lab.transport.nudge(-1)),
  ArrowRight: () => (shift ? lab.transport.jump(1) : lab.transport.nudge(1)),
  Home: () => lab.clock.seek(0),
  End: () => lab.clock.seek(lab.clock.duration),
  h: () => lab.transport.jump(1, "takeoff"),
  l: () => lab.transport.jump(1, "impact"),
  "[": () => lab.clock.faster(-1),
  "]": () => lab.clock.faster(1),
  t: () => lab.toggle("traces"),
  f: () => lab.toggle("forces"),
  c: () => lab.toggle("speed"),
  w: () => lab.toggle("whole"),
  3: () => lab.toggle("three"),
  "+": () => lab.stage.zoom(1.25),
  "=": () => lab.stage.zoom(1.25),
  "-": () => lab.stage.zoom(0.8),
  0: () => lab.stage.zoom(0),
  z: () => lab.travel(-1),
  y: () => lab.travel(1),
  d: () => lab.theme.toggle(),
  p: () => lab.share.code(),
  "?": () => lab.help.showModal(),
});

/**
 * @param {Lab} lab
 * @param {KeyboardEvent} event
 */
function pressed(lab, event) {
  const target = /** @type {Element} */ (event.target);
  if (event.ctrlKey || event.metaKey || event.altKey || lab.root.querySelector("dialog[open]")) return;
  if (target.matches?.("input:not([type=range]), textarea, select")) return;
  const sliding = target.matches?.("input[type=range]") && /^(Arrow|Home|End|Page)/.test(event.key);
  if (sliding || (event.key === " " && target.matches?.("button, summary"))) return;
  const action = actions(lab, event.shiftKey)[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

/**
 * Listen on the whole page where it is the lab's own, else inside the widget only.
 * @param {Lab} lab
 * @param {boolean} hosted
 * @returns {() => void} what stops it
 */
export function listen(lab, hosted) {
  const target = hosted ? document : lab.root;
  const listener = /** @param {Event} event */ (event) => {
    pressed(lab, /** @type {KeyboardEvent} */ (event));
    if (!hosted) event.stopPropagation(); // what is typed here is not meant for the notebook
  };
  target.addEventListener("keydown", listener);
  return () => target.removeEventListener("keydown", listener);
}
