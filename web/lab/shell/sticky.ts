// The player stays in sight: smaller, once its own place is scrolled away.

import { h } from "../common/dom.ts";

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
    document.documentElement.style.scrollPaddingTop = stuck ? `${player.offsetHeight}px` : "";
    changed();
  });
  watch.observe(edge);
  return { edge, close: () => watch.disconnect() };
}
