// The keyboard of the player.

import { h } from "../common/dom.ts";
import { recall, remember } from "./memory.ts";
import type { Lab } from "./lab.ts";

const KEPT = "hophoop-single-keys";

/** What a key does. */
const actions = (lab: Lab, shift: boolean): Named<() => void> => ({
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
  a: () => lab.extras.more.turn(),
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

/** With Ctrl or Command: undo and redo, as everywhere. */
function withControl(lab: Lab, event: KeyboardEvent) {
  const key = event.key.toLowerCase();
  if (event.altKey || !(key === "z" || key === "y")) return;
  event.preventDefault();
  lab.travel(key === "y" || event.shiftKey ? 1 : -1);
}

// Closes a menu, or leaves the presentation; a field, a picture and a dialog see to themselves.
function leave(lab: Lab) {
  const { present } = lab.extras;
  const menu = [lab.share.menu, lab.extras.menu].find((one) => one.open);
  if (menu) {
    menu.open = false;
    menu.querySelector("summary")?.focus();
  } else if (present.on) present.turn(false);
}

// Whether single keys do something; some speak to their machine, or press keys by mistake.
export class SingleKeys {
  on = !this.hosted || recall(KEPT) !== "off";
  box = h("input", {
    type: "checkbox",
    checked: this.on,
    onchange: () => {
      this.on = this.box.checked;
      if (this.hosted) remember(KEPT, this.on ? "on" : "off");
    },
  });
  element = h("label.check", this.box, "keys.single_keys");

  /** `hosted`: whether the choice may be kept. */
  constructor(readonly hosted: boolean) {}
}

function pressed(lab: Lab, event: KeyboardEvent) {
  const target = event.target as Element;
  if (lab.root.querySelector("dialog[open]")) return;
  if (event.key === "Escape") {
    leave(lab);
    return;
  }
  if (target.matches?.("input:not([type=range], [type=checkbox]), textarea")) return;
  if (event.ctrlKey || event.metaKey) {
    withControl(lab, event);
    return;
  }
  if (event.altKey) return;
  // Space plays what has just been chosen; else a choice has its own keys
  if (target.matches?.("select") && !(event.key === " " && lab.header.fresh)) return;
  const sliding = target.matches?.("input[type=range]") && /^(Arrow|Home|End|Page)/.test(event.key);
  if (sliding || (event.key === " " && target.matches?.("button, summary, input[type=checkbox]"))) return;
  if (!lab.singleKeys.on && event.key !== " " && event.key.length === 1) return;
  const action = actions(lab, event.shiftKey)[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

/** Listen on the whole page where it is the lab's own, else inside the widget only. Returns what stops it. */
export function listen(lab: Lab, hosted: boolean) {
  const target = hosted ? document : lab.root;
  const listener = (event: Event) => {
    pressed(lab, event as KeyboardEvent);
    if (!hosted) event.stopPropagation(); // what is typed here is not meant for the notebook
  };
  target.addEventListener("keydown", listener);
  return () => target.removeEventListener("keydown", listener);
}
