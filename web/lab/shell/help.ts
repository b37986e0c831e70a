// Keys and help.

import { h, rowOf } from "../common/dom.ts";

const KEYS = [
  ["keys.space", "keys.play_pause"],
  ["← →", "keys.one_frame"],
  ["keys.shift", "keys.previous_next_event"],
  ["h  l", "keys.next_flight_landing"],
  ["[ ]", "keys.slower_faster"],
  ["keys.home_end", "keys.start_end"],
  ["t f c w", "keys.traces_forces_rim_speed"],
  ["a", "keys.arrows_what_a_little"],
  ["3", "keys.in_space"],
  ["+ − 0", "keys.zoom_zoom_back"],
  ["keys.esc", "keys.leave_a_field_a"],
  ["keys.z_y_ctrl_z", "keys.undo_redo"],
  ["d", "keys.dark_light"],
  ["p", "keys.python"],
];

// A letter stands for a mode in sequences; slip is named by what the rim does.
const MODES = [
  ["R", "mode.roll", "keys.the_rim_does_not"],
  ["S", "mode.spin", "keys.slip_the_rim_turns"],
  ["K", "mode.skid", "keys.slip_the_rim_slides"],
  ["H", "mode.flight", "keys.the_hop_from_take"],
  ["M", "mode.skim", "keys.a_massless_rim_that"],
];
const MARKED = [
  ["▲ ▼", "keys.take_off_landing"],
  ["•", "event.apex"],
  ["↺", "event.turn"],
  ["◆ ◇", "keys.painleves_paradox_no_solution"],
  ["✖", "event.jam"],
  ["✚", "example.kane"],
  ["≋", "keys.bounces_without_number_end"],
  ["◗ ■", "keys.skimming_begins_rest"],
];

const table = (title: string, rows: string[][], mark: (letter: string) => HTMLElement | false = () => false) =>
  h(
    "table",
    {},
    h("caption", {}, title),
    rows.map(([key, ...words]) => rowOf([mark(key), key], ...words)),
  );

/** Where the documentation is, if the page was told. */
export const docs = () => document.querySelector<HTMLMetaElement>("meta[name=hophoop-docs]")?.content;

/** `hosted`: whether the lab owns the page, with its files beside the script. */
export function aboutDialog(version: string, hosted: boolean) {
  const base = docs();
  const link = (href: string, words: string) => h("a", { href, target: "_blank", rel: "noopener" }, words);
  const row = (name: string, ...words: (Node | string)[]) => [h("dt", {}, name), h("dd", {}, words)];
  const licences = hosted && link(new URL("licences.txt", import.meta.url).href, "keys.licences_of_all_that");
  const dialog = h(
    "dialog",
    { class: "about", "aria-label": "menu.about_hophoop" },
    h("h2", {}, "menu.about_hophoop"),
    h("p", {}, "keys.hophoop_computes_exactly_how"),
    h(
      "dl",
      {},
      row("keys.version", document.createTextNode(version)),
      row("keys.licence", document.createTextNode("MIT"), ...(licences ? [". ", licences] : [])),
      base ? row("keys.documentation", link(base, "keys.the_documentation")) : [],
      row("keys.commands", h("code", {}, document.createTextNode("hophoop --help"))),
    ),
    h("button", { class: "close", onclick: () => dialog.close() }, "table.close"),
  );
  return dialog;
}

/** `keys`: what switches single keys off. */
export function helpDialog(about: HTMLDialogElement, colors: Colors, keys: HTMLElement) {
  const dialog = h(
    "dialog",
    { class: "help", "aria-label": "keys.keys_and_help" },
    h("h2", {}, "player.the_hoop"),
    h("p", {}, "keys.a_ring_with_a"),
    table("keys.modes", MODES, (letter) => h("i", { class: "dot", style: `background:${colors.modes[letter]}` })),
    table("keys.marks_on_the_bar", MARKED),
    table("keys.keys", KEYS),
    keys,
    h("button", { class: "link", onclick: () => about.showModal() }, "menu.about_hophoop"),
    h("button", { class: "close", onclick: () => dialog.close() }, "table.close"),
  );
  return dialog;
}
