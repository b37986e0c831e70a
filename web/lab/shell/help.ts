// Keys and help.

import { h } from "../common/dom.ts";

const KEYS = [
  ["space", "play, pause"],
  ["← →", "one frame"],
  ["Shift ← →", "previous, next event"],
  ["h  l", "next flight, landing"],
  ["[ ]", "slower, faster"],
  ["Home End", "start, end"],
  ["t f c w", "traces, forces, rim speed, whole path"],
  ["a", "arrows: what a little more would do"],
  ["3", "in space"],
  ["+ − 0", "zoom, zoom back"],
  ["Esc", "leave a field, a menu, a picture that the wheel zooms"],
  ["z y  Ctrl Z", "undo, redo"],
  ["d", "dark, light"],
  ["p", "Python"],
];

// A letter stands for a mode in sequences; slip is named by what the rim does.
const MODES = [
  ["R", "roll", "the rim does not slide"],
  ["S", "spin", "slip: the rim turns too fast for the way it goes (slip −, for a hoop that rolls ahead)"],
  ["K", "skid", "slip: the rim slides ahead (slip +, for a hoop that rolls ahead)"],
  ["H", "flight", "the hop: from take-off to landing"],
  ["M", "skim", "a massless rim that touches without force"],
];
const MARKED = [
  ["▲ ▼", "take-off, landing"],
  ["•", "highest point"],
  ["↺", "turns back"],
  ["◆ ◇", "Painlevé’s paradox: no solution, several"],
  ["✖", "jam"],
  ["✚", "Kane: energy out of nothing"],
  ["≋", "bounces without number end"],
  ["◗ ■", "skimming begins, rest"],
];

const table = (title: string, rows: string[][], mark: (letter: string) => HTMLElement | false = () => false) =>
  h(
    "table",
    {},
    h("caption", {}, title),
    rows.map(([key, ...words]) =>
      h(
        "tr",
        {},
        h("th", { scope: "row" }, mark(key), key),
        words.map((word) => h("td", {}, word)),
      ),
    ),
  );

/** Where the documentation is, if the page was told. */
export const docs = () => document.querySelector<HTMLMetaElement>("meta[name=hophoop-docs]")?.content;

/** `hosted`: whether the lab owns the page, with its files beside the script. */
export function aboutDialog(version: string, hosted: boolean) {
  const base = docs();
  const link = (href: string, words: string) => h("a", { href, target: "_blank", rel: "noopener" }, words);
  const row = (name: string, ...words: (Node | string)[]) => [h("dt", {}, name), h("dd", {}, words)];
  const licences =
    hosted && link(new URL("licences.txt", import.meta.url).href, "Licences of all that the page contains");
  const dialog = h(
    "dialog",
    { class: "about", "aria-label": "About hophoop" },
    h("h2", {}, "About hophoop"),
    h("p", {}, "hophoop computes exactly how a hoop with a load on its rim rolls, slips, hops and lands."),
    h(
      "dl",
      {},
      row("Version", document.createTextNode(version)),
      row("Licence", document.createTextNode("MIT"), ...(licences ? [". ", licences] : [])),
      row(
        "Documentation",
        base ? link(base, "The documentation") : "docs/index.md in the source; this page: docs/lab.md",
      ),
      row("Commands", h("code", {}, document.createTextNode("hophoop --help"))),
    ),
    h("button", { type: "button", class: "close", onclick: () => dialog.close() }, "Close"),
  );
  return dialog;
}

/** `keys`: what switches single keys off. */
export function helpDialog(about: HTMLDialogElement, colors: Colors, keys: HTMLElement) {
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
    table("Modes", MODES, (letter) => h("i", { class: "dot", style: `background:${colors.modes[letter]}` })),
    table("Marks on the bar of time", MARKED),
    table("Keys", KEYS),
    keys,
    h("button", { type: "button", class: "link", onclick: () => about.showModal() }, "About hophoop"),
    h("button", { type: "button", class: "close", onclick: () => dialog.close() }, "Close"),
  );
  return dialog;
}
