// The player stays in sight: smaller, once its own place is scrolled away.

import { h } from "../common/dom.ts";

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
export function keepInSight(player: HTMLElement, changed: () => void): { edge: HTMLElement; close: () => void } {
  const edge = h("div", { class: "edge", "aria-hidden": "true" });
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
