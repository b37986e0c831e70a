// For teachers: a lesson in brief, what students often think, and a worksheet to print, each with the motions it needs.

import { h, headed, rowOf } from "../common/dom.ts";
import { docs } from "../shell/help.ts";

const SHEET = "hoop.radius=0.4&duration=1.5&start.speed=";

/** Minute, what happens, the motion that it needs. */
const LESSON: [string, string, string | null][] = [
  ["0", "teach.show_the_hoop_at", "duration=2"],
  ["3", "teach.everybody_predicts_where_the", null],
  ["7", "teach.energy_on_the_way", "start.speed=0.1&duration=8"],
  ["17", "teach.lift_at_the_top", "start.speed=3.7&duration=2"],
  ["24", "teach.the_film_again_in", "duration=2"],
  ["28", "teach.each_group_takes_one", `${SHEET}2.2`],
  ["35", "teach.why_what_has_to", null],
  ["42", "teach.one_sentence_each_the", null],
];

const IDEAS: [string, string][] = [
  ["teach.the_load_pulls_the", "teach.only_if_it_is"],
  ["teach.it_hops_at_the", "teach.there_the_floor_pushes"],
  ["teach.nothing_can_be_faster", "teach.the_ring_can_it"],
  ["teach.friction_always_brakes", "teach.it_acts_against_slip"],
  ["teach.more_friction_more_hop", "teach.there_is_a_best"],
  ["teach.a_heavier_hoop_behaves", "teach.only_the_shares_of"],
];

const TASKS = [
  "teach.before_the_film_where",
  "teach.the_hoop_gets_only",
  "teach.while_a_wheel_rolls",
  "teach.how_fast_is_a",
  "teach.find_the_force_of",
  "teach.in_the_lab_what",
  "teach.find_the_smallest_speed",
  "teach.at_2_2_m",
];

const SPEEDS = ["1.0", "1.3", "1.6", "1.9", "2.2", "2.3"];

export function teachDialog(load: (query: string) => void, visit: () => void) {
  const go = (query: string) => {
    dialog.close();
    load(query);
  };
  const motion = (query: string, words = "teach.show") =>
    h("button", { class: "link", onclick: () => go(query) }, words);
  const base = docs();
  const pages = base && [
    ["teach/index.html", "teach.teaching_with_the_hoop"],
    ["teach/worksheet.html", "teach.worksheet"],
    ["teach/solutions.html", "teach.solutions"],
    ["teach/exercises.html", "teach.exercises"],
  ];
  const lesson = h(
    "table",
    {},
    h("caption", {}, "teach.a_lesson_of_45"),
    headed("teach.minute", "motion.what_happens", "teach.motion"),
    h("tbody", {}, ...LESSON.map(([minute, what, query]) => rowOf(minute, what, query === null ? "" : motion(query)))),
  );
  const ideas = h(
    "table",
    {},
    h("caption", {}, "teach.what_students_often_think"),
    headed("teach.idea", "teach.what_is_right"),
    h("tbody", {}, ...IDEAS.map(([idea, right]) => h("tr", {}, h("td", {}, idea), h("td", {}, right)))),
  );
  const sheet = h(
    "section",
    { class: "sheet" },
    h("h3", {}, "teach.worksheet_the_hoop_that"),
    h("p", {}, "teach.a_thin_ring_of"),
    h(
      "ol",
      {},
      TASKS.map((task) => h("li", {}, task, h("div", { class: "answer-line" }))),
    ),
    h(
      "table",
      { class: "sheet-table" },
      headed("v₀ [m/s]", "teach.phases", "teach.does_it_hop", "teach.at_which_angle"),
      h("tbody", {}, ...SPEEDS.map((speed) => rowOf(motion(`${SHEET}${Number(speed)}`, speed), "", "", ""))),
    ),
  );
  const dialog = h(
    "dialog",
    { class: "teach", "aria-label": "menu.for_teachers" },
    h(
      "header",
      {},
      h("h2", {}, "menu.for_teachers"),
      h("button", { onclick: () => print() }, "teach.print"),
      h("button", { class: "close", onclick: () => dialog.close() }, "table.close"),
    ),
    h(
      "p",
      {},
      "teach.the_visit_asks_before",
      " ",
      h(
        "button",
        {
          class: "link",
          onclick: () => {
            dialog.close();
            visit();
          },
        },
        "teach.start_the_visit",
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
