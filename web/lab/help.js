// Keys and help.

import { h } from "./dom.js";

const KEYS = [
  ["space", "play, pause"],
  ["← →", "one frame"],
  ["Shift ← →", "previous, next event"],
  ["h  l", "next hop, landing"],
  ["[ ]", "slower, faster"],
  ["Home End", "start, end"],
  ["t f c w", "traces, forces, rim speed, whole path"],
  ["3", "in space"],
  ["+ − 0", "zoom, zoom back"],
  ["z y", "undo, redo"],
  ["d", "dark, light"],
  ["p", "Python"],
];

/** @param {string} version */
export function helpDialog(version) {
  const dialog = h(
    "dialog",
    { class: "help", "aria-label": "Keys and help" },
    h("h2", {}, "The hoop"),
    h(
      "p",
      {},
      "A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: " +
        "so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.",
    ),
    h(
      "table",
      {},
      h("caption", {}, "Keys"),
      KEYS.map(([key, what]) => h("tr", {}, h("th", { scope: "row" }, key), h("td", {}, what))),
    ),
    h("p", { class: "hint" }, `hophoop ${version}`),
    h("button", { type: "button", class: "close", onclick: () => dialog.close() }, "Close"),
  );
  return dialog;
}
