// Where everything stands on the page.

import { h } from "../common/dom.ts";
import type { Lab } from "./lab.ts";

/** Returns whether the lab owns the page. `own`: what the address of such a page begins with. */
export function prepareRoot(root: HTMLElement, own?: string) {
  root.classList.add("hophoop");
  root.dir = "ltr"; // numbers with their signs and units, also within a page in right-to-left writing
  if (own !== undefined) return true;
  root.classList.add("embedded");
  // Jupyter would take the same keys to delete cells and to restart the kernel
  root.dataset.lmSuppressShortcuts = "true";
  root.dataset.pSuppressShortcuts = "true";
  return false;
}

/**
 * `panels`: what stands beside the player; everything by default. Returns the player, what keeps it in sight where the
 * lab owns the page, and what puts all parts in the order in which they are seen, which is that of Tab.
 */
export function layOut(lab: Lab, panels: string[] | null) {
  const { root, notice, hosted, extras, transport, header } = lab;
  const want = (name: string) => !panels || panels.includes(name);
  const visit = extras.visit.element;
  const cards = [visit, extras.challenges.element];
  const side = h(
    "aside.side",
    { "aria-label": "page.parameters" },
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
    "div.player",
    extras.present.leave,
    extras.grips.element,
    lab.stage.element,
    lab.timeline.element,
    transport.element,
  );
  const sticky = hosted ? keepInSight(player, () => lab.request()) : null;
  lab.story.element.append(lab.ending.element);
  const middle = h(
    "div.middle",
    sticky?.edge,
    !want("controls") && cards,
    player,
    extras.more.element,
    extras.table.element,
  );
  const words = h("div.words", lab.story.element, want("theory") && lab.theory.element);
  const why = h("div.why", want("plots") && lab.plots.element, want("plots") && lab.phase.element);
  const columns = h("div.columns", middle);
  root.replaceChildren(
    h("div.page", hosted && skipTo(lab.timeline.element), header.element, columns),
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
  let order = "";
  const arrange = () => {
    const { simple } = lab.view;
    const single = getComputedStyle(columns).display === "flex";
    if (order === `${simple} ${single}`) return;
    order = `${simple} ${single}`;
    // the speed comes first there, and what is offered after what is there
    if (simple) lab.controls.element.prepend(lab.controls.start);
    else lab.controls.element.lastElementChild?.before(lab.controls.start);
    if (want("controls")) {
      if (simple) side.append(visit);
      else side.prepend(visit);
      if (single) middle.append(side);
      else columns.prepend(side);
    }
    if (!single) columns.append(why);
    middle.append(
      ...(!single ? [words] : simple ? [why, words] : [words, why]),
      ...(want("map") ? [lab.map.element] : []),
    );
  };
  arrange();
  return { player, sticky, arrange };
}

function skipTo(player: HTMLElement) {
  player.id = "hh-player";
  const skip = h("a.skip.button", { href: "#hh-player" }, "page.skip");
  skip.onclick = (event) => {
    event.preventDefault(); // what stands behind the # of the address is the lab's own
    player.focus();
  };
  return skip;
}

// --- The player stays in sight: smaller, once its own place is scrolled away

const WAIT = 1000; // milliseconds
const GAP = 8; // pixels between the player and what is scrolled to
let sought: HTMLElement | null = null;

/** Scroll to a part of the page, below the player, which may become small meanwhile. */
export function bring(element: HTMLElement) {
  sought = element;
  element.scrollIntoView();
  setTimeout(() => {
    sought = null;
  }, WAIT);
}

/** Returns what stands before the player and tells where it would be. */
function keepInSight(player: HTMLElement, changed: () => void) {
  const edge = h("div.edge", { "aria-hidden": "true" });
  const watch = new IntersectionObserver(([entry]) => {
    const stuck = !entry.isIntersecting && entry.boundingClientRect.top < 0;
    if (stuck === player.classList.contains("stuck")) return;
    const before = player.offsetHeight;
    player.style.marginBottom = "";
    player.classList.toggle("stuck", stuck);
    // what stands below keeps its place, or the page would jump to and fro
    if (stuck) player.style.marginBottom = `${before - player.offsetHeight}px`;
    document.documentElement.style.scrollPaddingTop = stuck ? `${player.offsetHeight + GAP}px` : "";
    sought?.scrollIntoView();
    changed();
  });
  watch.observe(edge);
  return { edge, close: () => watch.disconnect() };
}
