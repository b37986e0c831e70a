// The parts of the page and where they stand.

import { SPEEDS } from "./clock.js";
import { Controls } from "./controls.js";
import { SPEED_TEXTS, h, icon } from "./dom.js";
import { MotionMap } from "./map.js";
import { PhasePlane } from "./phase.js";
import { Plots } from "./plots.js";
import { Share } from "./share.js";
import { Stage2D } from "./stage2d.js";
import { Story, Theory } from "./story.js";
import { Timeline } from "./timeline.js";

const SWITCHES = [
  ["traces", "Traces", "t"],
  ["forces", "Forces", "f"],
  ["speed", "Rim speed", "c"],
  ["whole", "Whole path", "w"],
];

export function build(lab) {
  const { clock } = lab;
  lab.canvas2 = h("canvas", { class: "stage-canvas" });
  lab.canvas3 = h("canvas", { class: "stage-canvas", hidden: true });
  lab.stage2 = new Stage2D(lab.canvas2);
  lab.stage2.onview = () => lab.request();
  lab.readout = h("dl", { class: "readout", "aria-hidden": "true" });
  lab.fastest = h("span", {});
  lab.legend = h(
    "div",
    { class: "legend", "aria-hidden": "true" },
    h("i", { style: `background: linear-gradient(90deg, ${SPEED_TEXTS.filter((_, k) => k % 15 === 0).join(",")})` }),
    h("span", {}, "0"),
    h("span", {}, "rim speed"),
    lab.fastest,
  );
  const dot = (color, words) =>
    h("span", {}, h("i", { class: "dot", style: `background:${color}` }), words);
  lab.stageKeys = [
    dot("var(--ink)", "load"),
    dot(lab.colors.gravity_center, "centre of gravity"),
    dot(lab.colors.airborne, "airborne"),
    h("span", { hidden: true }, "A in front, B behind"),
  ];
  lab.stageBox = h(
    "div",
    { class: "stage", role: "img", "aria-label": "The hoop", tabindex: "0" },
    lab.canvas2,
    lab.canvas3,
    lab.readout,
    lab.legend,
    h("div", { class: "stage-keys", "aria-hidden": "true" }, lab.stageKeys),
  );
  lab.timeline = new Timeline(clock);
  lab.story = new Story(clock);
  lab.theory = new Theory();
  lab.plots = new Plots(clock, lab.colors);
  lab.phase = new PhasePlane(lab);
  lab.map = new MotionMap(lab);
  lab.controls = new Controls(lab.setup.controls, (changes, commit) => lab.change(changes, commit));
  lab.share = new Share(lab);
  lab.message = h("p", { class: "message", role: "alert", hidden: true });
  const want = (name) => !lab.panels || lab.panels.includes(name);
  const side = h(
    "aside",
    { class: "side", "aria-label": "Parameters" },
    lanesBar(lab),
    lab.message,
    lab.controls.element,
  );
  const main = h(
    "div",
    { class: "middle" },
    h("div", { class: "player" }, lab.stageBox, lab.timeline.element, transport(lab)),
    h("div", { class: "words" }, lab.story.element, want("theory") && lab.theory.element),
    want("map") && lab.map.element,
  );
  const why = h(
    "div",
    { class: "why" },
    want("plots") && lab.plots.element,
    want("plots") && lab.phase.element,
  );
  lab.toast = h("div", { class: "toast", role: "status", hidden: true });
  lab.root.replaceChildren(
    h("div", { class: "page" }, header(lab), h("div", { class: "columns" }, want("controls") && side, main, why)),
    lab.toast,
    lab.share.dialog,
    help(lab),
  );
  if (!want("controls")) lab.root.classList.add("no-controls");
  if (lab.hosted) document.addEventListener("keydown", (event) => lab.key(event));
  else {
    lab.root.addEventListener("keydown", (event) => {
      lab.key(event);
      event.stopPropagation(); // what is typed here is not meant for the notebook
    });
  }
}

function header(lab) {
  const groups = new Map();
  for (const preset of lab.setup.presets) {
    groups.set(preset.group, [...(groups.get(preset.group) ?? []), preset]);
  }
  lab.presets = h(
    "select",
    {
      class: "presets",
      "aria-label": "Motions to start from",
      onchange: () => {
        const preset = lab.setup.presets.find(({ key }) => key === lab.presets.value);
        if (preset) lab.take(preset.query, preset);
      },
    },
    h("option", { value: "" }, "Motions to start from …"),
    [...groups].map(([group, list]) =>
      h("optgroup", { label: group }, list.map(({ key, title }) => h("option", { value: key }, title))),
    ),
  );
  const button = (label, title, action, extra = {}) =>
    h("button", { type: "button", title, "aria-label": title, onclick: action, ...extra }, label);
  lab.undoButton = button(icon("undo"), "Undo (z)", () => lab.undo());
  lab.redoButton = button(icon("redo"), "Redo (y)", () => lab.redo());
  const words = h("span", {}, h("span", { class: "long" }, "Compare"), h("span", { class: "short" }, icon("two")));
  lab.compareButton = button(words, "Compare two hoops", () => lab.compare(), { "aria-pressed": "false" });
  return h(
    "header",
    { class: "top" },
    h("h1", {}, h("span", { class: "logo", "aria-hidden": "true" }), h("span", {}, "hophoop", h("span", { class: "long" }, " lab"))),
    lab.presets,
    h("div", { class: "buttons" }, lab.undoButton, lab.redoButton, lab.compareButton),
    h(
      "div",
      { class: "buttons right" },
      lab.share.menu,
      button(icon("theme"), "Dark or light (d)", () => lab.toggleTheme()),
      button("?", "Keys and help (?)", () => lab.helpDialog.showModal()),
    ),
  );
}

function lanesBar(lab) {
  lab.tabs = ["A", "B"].map((name, i) =>
    h("button", { type: "button", "aria-pressed": "false", onclick: () => lab.choose(i) }, `Hoop ${name}`),
  );
  lab.tabBar = h("div", { class: "tabs", role: "group", "aria-label": "Which hoop the controls change", hidden: true }, lab.tabs);
  lab.presetText = h("p", { class: "preset-text" });
  return h("div", { class: "lanes" }, lab.tabBar, lab.presetText);
}

function transport(lab) {
  const marked = (mark, word) => h("span", {}, h("span", { "aria-hidden": "true" }, `${mark} `), word);
  const button = (label, title, action) =>
    h("button", { type: "button", title, "aria-label": title, onclick: action }, label);
  lab.playButton = button(icon("play"), "Play (space)", () => lab.clock.play());
  lab.playButton.classList.add("play");
  lab.speeds = h(
    "select",
    {
      "aria-label": "Speed of the film",
      onchange: () => {
        lab.clock.speed = Number(lab.speeds.value);
      },
    },
    SPEEDS.map((speed) => h("option", { value: String(speed) }, `${speed}×`)),
  );
  lab.speeds.value = "1";
  lab.switches = new Map(
    SWITCHES.map(([name, label, key]) => {
      const box = h("button", {
        type: "button", class: "switch", title: `${label} (${key})`, onclick: () => lab.toggle(name),
      }, label);
      return [name, box];
    }),
  );
  lab.threeButton = h(
    "button", { type: "button", class: "switch", title: "In space (3)", onclick: () => lab.toggle("three") }, "3D",
  );
  lab.switches.set("three", lab.threeButton);
  return h(
    "div",
    { class: "transport" },
    h(
      "div",
      { class: "buttons" },
      button(icon("start"), "To the start (Home)", () => lab.clock.seek(0)),
      button(icon("previous"), "Previous event (Shift ←)", () => lab.jump(-1)),
      button(icon("back"), "One frame back (←)", () => lab.nudge(-1)),
      lab.playButton,
      button(icon("on"), "One frame on (→)", () => lab.nudge(1)),
      button(icon("next"), "Next event (Shift →)", () => lab.jump(1)),
    ),
    h(
      "div",
      { class: "buttons" },
      button(marked("▲", "hop"), "To the next hop (h)", () => lab.jump(1, "takeoff")),
      button(marked("▼", "landing"), "To the next landing (l)", () => lab.jump(1, "impact")),
    ),
    lab.speeds,
    h("div", { class: "buttons switches" }, [...lab.switches.values()]),
  );
}

function help(lab) {
  const keys = [
    ["space", "play, pause"], ["← →", "one frame"], ["Shift ← →", "previous, next event"], ["h  l", "next hop, landing"],
    ["[ ]", "slower, faster"], ["Home End", "start, end"], ["t f c w", "traces, forces, rim speed, whole path"],
    ["3", "in space"], ["+ − 0", "zoom, zoom back"], ["z y", "undo, redo"], ["d", "dark, light"], ["p", "Python"],
  ];
  lab.helpDialog = h(
    "dialog",
    { class: "help", "aria-label": "Keys and help" },
    h("h2", {}, "The hoop"),
    h(
      "p",
      {},
      "A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: " +
        "so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.",
    ),
    h("table", {}, h("caption", {}, "Keys"), keys.map(([key, what]) => h("tr", {}, h("th", { scope: "row" }, key), h("td", {}, what)))),
    h("p", { class: "hint" }, `hophoop ${lab.setup.version}`),
    h("button", { type: "button", class: "close", onclick: () => lab.helpDialog.close() }, "Close"),
  );
  return lab.helpDialog;
}
