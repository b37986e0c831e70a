// What stands around the player besides: the hoop in the hand, languages, the visit, challenges, sound, the table, and
// what a class needs.

import { Challenges } from "../teach/challenges.ts";
import { h, iconButton, menuItem } from "../common/dom.ts";
import { Grips } from "../player/grips.ts";
import { icon } from "../common/icons.ts";
import { More } from "../sensitivity/more.ts";
import { Present } from "./present.ts";
import { Sound } from "../player/sound.ts";
import { Table } from "../diagrams/table.ts";
import { teachDialog } from "../teach/teach.ts";
import { Visit } from "../teach/visit.ts";
import { current, repeat, spoken, t, keep, LANGUAGES, speak } from "../words/words.ts";
import type { Lab } from "./lab.ts";

const LONG = 60; // letters of a motion's name

/** What the parts of the page need that are made here. */
type Around = Visit["lab"] & More["lab"] & Present["lab"] & Pick<Lab, "hosted" | "about" | "known" | "load" | "theme">;

export class Extras {
  clock = this.lab.clock;
  grips = new Grips(
    this.clock,
    this.lab.motions,
    this.lab.stage,
    this.lab.notice,
    (held) => this.lab.mark("holding", held),
    () => this.lab.request(),
  );
  sound = new Sound();
  present = new Present(this.lab);
  challenges = new Challenges(this.lab.motions, this.lab.stage, (query) => this.lab.load(query));
  visit = new Visit(this.lab);
  table = new Table(this.clock, this.lab.motions, this.lab.theme);
  more = new More(this.lab);
  teach = teachDialog(
    (query) => {
      this.visit.leave();
      this.lab.load(query);
    },
    () => this.visit.start(),
  );
  /** Switches beside those of the player, and whether each is on. */
  switches = new Map([
    this.switch(
      "loop",
      "menu.repeat",
      () => this.clock.loop,
      () => (this.clock.loop = !this.clock.loop),
    ),
    this.switch(
      "slow",
      "menu.slow_motion",
      () => this.clock.speed === 0.1,
      () => {
        this.clock.speed = this.clock.speed === 0.1 ? 1 : 0.1;
        this.clock.changed();
      },
    ),
    this.switch(
      "sound",
      "menu.sound",
      () => this.sound.on,
      () => this.sound.turn(!this.sound.on),
    ),
    this.switch(
      "large",
      "menu.presentation_title",
      () => this.present.on,
      () => this.present.turn(),
    ),
  ]);
  tools = h("div.buttons.tools", [...this.switches.keys()]);
  menu = h(
    "details.menu.learn",
    h("summary.button", "menu.learn"),
    h(
      "div.menu-body",
      menuItem("menu.visit", () => this.visit.start()),
      menuItem("menu.challenges", () => this.challenges.open()),
      menuItem("sensitivity.title", () => this.more.turn(true)),
      menuItem("table.title", () => this.table.open(true)),
      menuItem("menu.presentation", () => this.present.turn(true)),
      menuItem("menu.teachers", () => this.teach.showModal()),
      menuItem("menu.about", () => this.lab.about.showModal()),
    ),
  );
  languages = languageMenu(
    () => {
      this.spoken();
      repeat(this.lab.root);
      this.lab.show();
    },
    (error) => this.lab.notice.fail(error),
  );

  constructor(readonly lab: Around) {
    this.mark();
    this.spoken();
  }

  switch(name: Parameters<typeof icon>[0], title: string, on: () => boolean, turn: () => void) {
    const pressed = () => {
      turn();
      this.mark();
    };
    return [iconButton(icon(name), title, pressed), on] as const;
  }

  mark() {
    for (const [button, on] of this.switches) button.ariaPressed = String(on());
  }

  spoken() {
    this.lab.root.lang = current();
    if (this.lab.hosted) document.documentElement.lang = current();
    this.titled();
  }

  /** The title of the page names what is shown, unless a visitor still guesses what that is. */
  titled() {
    const { lab } = this;
    if (!lab.hosted) return;
    const names = new Set(lab.motions.films().map((film) => this.nameOf(film)));
    const said = this.visit.guessing ? "" : [...names].join(" | ");
    document.title = said ? `${said} – hophoop` : t("page.title");
  }

  nameOf({ query, summary }: Film) {
    const example = this.lab.known.find((one) => one.query === query);
    if (example) return t(`example.${example.key}`);
    const [sentence] = spoken(summary).split(/(?<=[.。])(?!\d)/u);
    return sentence.length <= LONG
      ? sentence.replace(/[.。]$/u, "")
      : `${sentence.slice(0, LONG).replace(/[,，][^,，]*$/u, "")} …`;
  }

  /** Another picture is on the screen. */
  frame() {
    const { lab } = this;
    this.grips.draw();
    this.sound.follow(lab.film(), lab.clock);
    this.table.cursor(lab.clock.time);
    this.more.frame();
    this.visit.frame();
    this.mark();
  }

  /** Another motion is there, or the page looks or speaks otherwise. */
  changed() {
    this.grips.draw();
    this.table.draw(this.lab.film());
    this.more.changed();
    this.challenges.changed();
    this.visit.changed();
    this.titled();
  }

  close() {
    this.sound.close();
    this.present.close();
  }
}

// --- The choice of a language: in the head of the page, and on the page that makes tags

/** `changed`: called when another one is spoken; `failed`: where it is not to be had. */
export function languageMenu(changed: () => void, failed: (error: Error) => void = () => {}) {
  const select = h(
    "select.language",
    {
      "aria-label": "language.language",
      onchange: async () => {
        try {
          await speak(select.value);
          keep(select.value);
          changed();
        } catch {
          select.value = current();
          failed(new Error("language.not_loaded"));
        }
      },
    },
    Object.entries(LANGUAGES).map(([code, name]) =>
      h("option", { value: code, lang: code }, document.createTextNode(name)),
    ),
  );
  select.value = current();
  return select;
}
