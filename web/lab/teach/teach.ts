// For teachers: a lesson in brief, what students often think, and a worksheet to print, each with the motions it needs.

import { closing, h, headed, rowOf } from "../common/dom.ts";
import { docs } from "../shell/help.ts";

const HOOP = "hoop.radius=0.4&duration=";
const SHEET = `${HOOP}1.5&start.speed=`;

/** Minute, what happens, the motion that it needs. The first one ends before the hoop takes off. */
const LESSON: [string, string, string?][] = [
  ["0", "teach.lesson_show", `${HOOP}0.58&start.speed=2`],
  ["3", "teach.lesson_guess"],
  ["7", "teach.lesson_energy", `${HOOP}5&start.speed=0.06`],
  ["17", "teach.lesson_takeoff", `${SHEET}2.3`],
  ["24", "teach.lesson_slow", `${SHEET}2`],
  ["28", "teach.lesson_groups", `${SHEET}2.2`],
  ["35", "teach.lesson_why"],
  ["42", "teach.lesson_summary"],
];

const IDEAS = ["top", "bottom", "free_fall", "friction_brakes", "more_friction", "mass"];
const TASKS = ["guess", "energy", "rest", "fall", "force", "lab", "threshold", "slip"];

const SPEEDS = ["1.0", "1.3", "1.6", "1.9", "2.2", "2.3"];

export function teachDialog(load: (query: string) => void, visit: () => void) {
  const link = (words: string, go: () => void) =>
    h(
      "button.link",
      {
        onclick: () => {
          dialog.close();
          go();
        },
      },
      words,
    );
  const motion = (query: string, words = "teach.show") => link(words, () => load(query));
  const base = docs();
  const pages = base && [
    ["teach/index.html", "teach.pages"],
    ["teach/worksheet.html", "teach.worksheet"],
    ["teach/solutions.html", "teach.solutions"],
    ["teach/exercises.html", "teach.exercises"],
  ];
  const lesson = h(
    "table",
    h("caption", "teach.lesson"),
    headed("teach.minute", "motion.story", "teach.motion"),
    h("tbody", ...LESSON.map(([minute, what, query]) => rowOf(minute, what, query && motion(query)))),
  );
  const ideas = h(
    "table",
    h("caption", "teach.ideas"),
    headed("teach.idea", "teach.answer"),
    h("tbody", ...IDEAS.map((idea) => h("tr", h("td", `teach.idea_${idea}`), h("td", `teach.answer_${idea}`)))),
  );
  const sheet = h(
    "section.sheet",
    h("h2", "teach.sheet_title"),
    h("p", "teach.sheet_intro"),
    h(
      "ol",
      TASKS.map((task) => h("li", `teach.task_${task}`, h("div.answer-line"))),
    ),
    h(
      "table.sheet-table",
      headed("v₀ [m/s]", "teach.column_phases", "teach.column_hops", "teach.column_angle"),
      h("tbody", ...SPEEDS.map((speed) => rowOf(motion(`${SHEET}${Number(speed)}`, speed), "", "", ""))),
    ),
  );
  const dialog = h(
    "dialog.teach",
    { "aria-label": "menu.teachers" },
    h("header", h("h2", "menu.teachers"), h("button", { onclick: () => print() }, "teach.print"), closing()),
    h("p", "teach.intro", " ", link("teach.start_visit", visit)),
    pages &&
      h(
        "p",
        pages.map(([page, words]) =>
          h("a.teach-page", { href: new URL(page, new URL(base, document.baseURI)).href }, words),
        ),
      ),
    lesson,
    ideas,
    sheet,
  );
  return dialog;
}
