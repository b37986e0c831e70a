// Where everything stands on the page.

import { h } from "../common/dom.ts";
import { keepInSight } from "./sticky.ts";
import type { Lab } from "./lab.ts";

/** `hosted`: whether the lab owns the page. */
export function prepareRoot(root: HTMLElement, hosted: boolean) {
  root.classList.add("hophoop");
  root.dir = "ltr"; // numbers with their signs and units, also within a page in right-to-left writing
  if (hosted) return;
  root.classList.add("embedded");
  // Jupyter would take the same keys to delete cells and to restart the kernel
  root.dataset.lmSuppressShortcuts = "true";
  root.dataset.pSuppressShortcuts = "true";
}

/**
 * `panels`: what stands beside the player; everything by default; returns the player, and what keeps it in sight where
 * the lab owns the page.
 */
export function layOut(lab: Lab, panels: string[] | null) {
  const { root, notice, hosted, extras, transport, header } = lab;
  const want = (name: string) => !panels || panels.includes(name);
  const cards = [extras.visit.element, extras.challenges.element];
  const side = h(
    "aside",
    { class: "side", "aria-label": "page.parameters" },
    ...cards,
    lab.hoops.element,
    notice.message,
    lab.controls.element,
    lab.view.more,
  );
  transport.row.append(extras.more.switch);
  transport.row.before(extras.tools);
  header.right.prepend(extras.menu, extras.languages);
  const player = h(
    "div",
    { class: "player" },
    extras.present.leave,
    extras.grips.element,
    lab.stage.element,
    lab.timeline.element,
    transport.element,
  );
  const sticky = hosted ? keepInSight(player, () => lab.request()) : null;
  lab.story.element.append(lab.ending.element);
  const middle = h(
    "div",
    { class: "middle" },
    sticky?.edge,
    !want("controls") && cards,
    player,
    extras.more.element,
    extras.table.element,
    h("div", { class: "words" }, lab.story.element, want("theory") && lab.theory.element),
    want("map") && lab.map.element,
  );
  const why = h("div", { class: "why" }, want("plots") && lab.plots.element, want("plots") && lab.phase.element);
  root.replaceChildren(
    h(
      "div",
      { class: "page" },
      hosted && skipTo(lab.timeline.element),
      header.element,
      h("div", { class: "columns" }, want("controls") && side, middle, why),
    ),
    notice.toast,
    lab.computing.element,
    lab.share.dialog,
    lab.help,
    lab.about,
    extras.teach,
  );
  // a menu closes where one presses elsewhere
  root.addEventListener("pointerdown", ({ target }) => {
    for (const menu of [lab.share.menu, extras.menu]) if (!menu.contains(target as Node)) menu.open = false;
  });
  root.classList.toggle("no-controls", !want("controls"));
  root.classList.toggle("alone", panels?.includes("player") ?? false);
  return { player, sticky };
}

function skipTo(player: HTMLElement) {
  player.id = "hh-player";
  const skip = h("a", { class: "skip button", href: "#hh-player" }, "page.skip");
  skip.onclick = (event) => {
    event.preventDefault(); // what stands behind the # of the address is the lab's own
    player.focus();
  };
  return skip;
}
