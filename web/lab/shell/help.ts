// Keys and help.

import { closing, h, rowOf } from "../common/dom.ts";
import { tables } from "../../model/tables.ts";
import { MARKS } from "../player/marks.ts";

const KEYS = [
  ["keys.key_space", "keys.play"],
  ["← →", "keys.frame"],
  ["keys.key_shift", "keys.events"],
  ["h  l", "keys.next_flight"],
  ["[ ]", "keys.speed"],
  ["keys.key_home_end", "keys.ends"],
  ["t f c w", "keys.layers"],
  ["a", "keys.arrows"],
  ["3", "keys.in_space"],
  ["+ − 0", "keys.zoom"],
  ["keys.key_escape", "keys.leave"],
  ["keys.key_undo", "keys.undo"],
  ["d", "keys.theme"],
  ["p", "keys.python"],
];

// A letter stands for a mode in sequences; slip is named by what the rim does.
const { letters, modes } = tables.words;
const MODES = modes.map((word, k) => [letters[k], `mode.${word}`, `keys.mode_${word}`]);
// The rarest last.
const MARKED = Object.entries(MARKS)
  .map(([kind, sign]) => [sign, `event.${kind}`])
  .reverse();

const table = (title: string, rows: string[][], mark: (letter: string) => HTMLElement | false = () => false) =>
  h(
    "table",
    h("caption", title),
    rows.map(([key, ...words]) => rowOf([mark(key), key], ...words)),
  );

/** Where the documentation is, if the page was told. */
export const docs = () => document.querySelector<HTMLMetaElement>("meta[name=hophoop-docs]")?.content;

function licencesOf(link: (href: string, words: string) => HTMLElement) {
  const held = document.getElementById("packed-licences")?.textContent;
  if (!held) return link(new URL("licences.txt", import.meta.url).href, "about.licences");
  return h("details", h("summary", "about.licences"), h("pre", document.createTextNode(held)));
}

/** `hosted`: whether the lab owns the page, with its files beside the script or in itself. */
export function aboutDialog(version: string, hosted: boolean) {
  const base = docs();
  const link = (href: string, words: string) => h("a", { href, target: "_blank", rel: "noopener" }, words);
  const row = (name: string, ...words: (Node | string)[]) => [h("dt", name), h("dd", words)];
  const licences = hosted && licencesOf(link);
  return h(
    "dialog.about",
    { "aria-label": "menu.about" },
    h("h2", "menu.about"),
    h("p", "about.intro"),
    h(
      "dl",
      row("about.version", document.createTextNode(version)),
      row("about.licence", document.createTextNode("MIT"), ...(licences ? [". ", licences] : [])),
      base ? row("about.documentation", link(base, "about.documentation_link")) : [],
      row("about.commands", h("code", document.createTextNode("hophoop --help"))),
    ),
    closing(),
  );
}

/** `keys`: what switches single keys off. */
export function helpDialog(about: HTMLDialogElement, colors: Colors, keys: HTMLElement) {
  return h(
    "dialog.help",
    { "aria-label": "keys.title" },
    h("h2", { tabindex: "-1", autofocus: true }, "player.picture"), // else the button at the end has the focus
    h("p", "keys.intro"),
    table("keys.modes", MODES, (letter) => h("i.dot", { style: `background:${colors.modes[letter]}` })),
    table("keys.marks", MARKED),
    table("keys.keys", KEYS),
    keys,
    h("button.link", { onclick: () => about.showModal() }, "menu.about"),
    closing(),
  );
}
