// For teachers: a lesson in brief, what students often think, and a worksheet to print, each with the motions it needs.

import { h } from "../common/dom.ts";
import { docs } from "../shell/help.ts";

const SHEET = "hoop.radius=0.4&duration=1.5&start.speed=";

/** Minute, what happens, the motion that it needs. */
const LESSON: [string, string, string | null][] = [
  ["0", "Show the hoop at full speed, once, without a comment. “I push it. Does it only roll?”", "duration=2"],
  ["3", "Everybody predicts where the load is at take-off. Count the votes by quarters of the turn.", null],
  ["7", "Energy on the way down, in pairs: who has the energy when the load is at rest?", "start.speed=0.1&duration=8"],
  ["17", "Lift at the top: at which speed is the force of the floor zero?", "start.speed=3.7&duration=2"],
  ["24", "The film again, in slow motion and with forces; stop at take-off. Compare with the votes.", "duration=2"],
  ["28", "Each group takes one speed of the worksheet; results on the board.", `${SHEET}2.2`],
  ["35", "Why? What has to brake the rotation on the way up, how strong can it be, and what if it is too weak?", null],
  ["42", "One sentence each: “The hoop hops because …”", null],
];

const IDEAS: [string, string][] = [
  [
    "The load pulls the hoop up at the top, so it hops there.",
    "Only if it is very fast. Slower hoops hop before the top, after slipping.",
  ],
  ["It hops at the bottom, where it is fastest.", "There the floor pushes hardest: the load has to be turned upwards."],
  ["Nothing can be faster than a falling stone.", "The ring can: it gets the energy of a load that has come to rest."],
  ["Friction always brakes.", "It acts against slip. On the hoop’s way up it points forwards."],
  ["More friction, more hop.", "There is a best friction in between."],
  ["A heavier hoop behaves otherwise.", "Only the shares of mass count."],
];

const TASKS = [
  "Before the film: where is the load when the hoop leaves the floor? Mark the place and give one reason.",
  "The hoop gets only the smallest push and rolls. How much potential energy has been set free when the load is at the bottom?",
  "While a wheel rolls, its lowest point is at rest. Which part of the hoop has kinetic energy then, and how fast is the centre?",
  "How fast is a stone that falls from the height of the load? Why can the hoop be faster?",
  "Find the force of the floor at the top for 1.0 m/s, and the speed at which it becomes zero.",
  "In the lab: what does the hoop do in its first 1.5 s, and at which angle does it hop? Fill in the table.",
  "Find the smallest speed with which the hoop hops, to 1 cm/s.",
  "At 2.2 m/s the hoop leaves the floor while its rim slips. Why does slipping help it to hop?",
];

const SPEEDS = ["1.0", "1.3", "1.6", "1.9", "2.2", "2.3"];

export function teachDialog(load: (query: string) => void, visit: () => void) {
  const go = (query: string) => {
    dialog.close();
    load(query);
  };
  const motion = (query: string, words = "Show") =>
    h("button", { type: "button", class: "link", onclick: () => go(query) }, words);
  const base = docs();
  const pages = base && [
    ["teach/index.html", "Teaching with the hoop"],
    ["teach/worksheet.html", "Worksheet"],
    ["teach/solutions.html", "Solutions"],
    ["teach/exercises.html", "Exercises"],
  ];
  const lesson = h(
    "table",
    {},
    h("caption", {}, "A lesson of 45 minutes"),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        ["Minute", "What happens", "Motion"].map((name) => h("th", { scope: "col" }, name)),
      ),
    ),
    h(
      "tbody",
      {},
      LESSON.map(([minute, what, query]) =>
        h(
          "tr",
          {},
          h("th", { scope: "row" }, minute),
          h("td", {}, what),
          h("td", {}, query === null ? "" : motion(query)),
        ),
      ),
    ),
  );
  const ideas = h(
    "table",
    {},
    h("caption", {}, "What students often think"),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        ["Idea", "What is right"].map((name) => h("th", { scope: "col" }, name)),
      ),
    ),
    h(
      "tbody",
      {},
      IDEAS.map(([idea, right]) => h("tr", {}, h("td", {}, idea), h("td", {}, right))),
    ),
  );
  const sheet = h(
    "section",
    { class: "sheet" },
    h("h3", {}, "Worksheet: the hoop that hops"),
    h(
      "p",
      {},
      "A thin ring of radius 0.40 m has a mass of 0.25 kg. A load of 0.75 kg is fixed to its rim. The hoop stands on a " +
        "level floor with the load at the top and is pushed to the right. Friction: μ = 1; g = 9.81 m/s².",
    ),
    h(
      "ol",
      {},
      TASKS.map((task) => h("li", {}, task, h("div", { class: "answer-line" }))),
    ),
    h(
      "table",
      { class: "sheet-table" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          ["v₀ [m/s]", "phases", "does it hop?", "at which angle?"].map((name) => h("th", { scope: "col" }, name)),
        ),
      ),
      h(
        "tbody",
        {},
        SPEEDS.map((speed) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, motion(`${SHEET}${Number(speed)}`, speed)),
            h("td", {}),
            h("td", {}),
            h("td", {}),
          ),
        ),
      ),
    ),
  );
  const dialog = h(
    "dialog",
    { class: "teach", "aria-label": "For teachers" },
    h(
      "header",
      {},
      h("h2", {}, "For teachers"),
      h("button", { type: "button", onclick: () => print() }, "Print"),
      h("button", { type: "button", class: "close", onclick: () => dialog.close() }, "Close"),
    ),
    h(
      "p",
      {},
      "The visit asks before it shows; the presentation fills the screen; the table gives numbers to every student. ",
      h(
        "button",
        {
          type: "button",
          class: "link",
          onclick: () => {
            dialog.close();
            visit();
          },
        },
        "Start the visit",
      ),
    ),
    pages &&
      h(
        "p",
        {},
        pages.map(([page, words]) =>
          h("a", { class: "teach-page", href: new URL(page, new URL(base, document.baseURI)).href }, words),
        ),
      ),
    lesson,
    ideas,
    sheet,
  );
  return dialog;
}
