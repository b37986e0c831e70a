// What stands around the player besides: the hoop in the hand, languages, the visit, challenges, sound, the table, and
// what a class needs.

import { Challenges } from "../teach/challenges.ts";
import { h, iconButton } from "../common/dom.ts";
import { Grips } from "../player/grips.ts";
import { icon } from "../common/icons.ts";
import { languageMenu } from "../words/languages.ts";
import { More } from "../sensitivity/more.ts";
import { Present } from "./present.ts";
import { Sound } from "../player/sound.ts";
import { Table } from "../diagrams/table.ts";
import { teachDialog } from "../teach/teach.ts";
import { Visit } from "../teach/visit.ts";
import { current, repeat, spoken, t } from "../words/words.ts";
import type { Lab } from "./lab.ts";

const LONG = 60; // letters of a motion's name

/** The parts of the page that these need. */
type Around = ConstructorParameters<typeof Grips>[0] &
  ConstructorParameters<typeof Visit>[0] &
  ConstructorParameters<typeof More>[0] &
  Pick<Lab, "root" | "hosted" | "theme" | "load" | "about" | "known">;

export class Extras {
  grips: Grips;
  sound = new Sound();
  present: Present;
  challenges: Challenges;
  visit: Visit;
  table: Table;
  more: More;
  teach: HTMLDialogElement;
  tools: HTMLElement;
  menu: HTMLDetailsElement;
  languages: HTMLElement;
  loop: HTMLButtonElement;
  slow: HTMLButtonElement;
  loud: HTMLButtonElement;
  large: HTMLButtonElement;

  constructor(readonly lab: Around) {
    const film = () => lab.film();
    const load = (query: string) => lab.load(query);
    this.grips = new Grips(lab);
    this.present = new Present(lab.root, () => lab.show());
    this.challenges = new Challenges(film, load, () => lab.stage.options.ahead);
    this.visit = new Visit(lab, () => this.challenges.open());
    this.table = new Table(film, lab.clock, () => lab.theme.colors.mode_names);
    this.more = new More(lab);
    this.teach = teachDialog(load, () => this.visit.start());
    this.tools = this.makeTools();
    this.menu = this.makeMenu();
    const changed = () => {
      this.spoken();
      repeat(lab.root);
      lab.show();
    };
    this.languages = languageMenu(changed, (error) => lab.notice.fail(error));
    this.spoken();
  }

  /** Switches beside those of the player. */
  makeTools() {
    const { clock } = this.lab;
    const toggle = (name: any, title: string, action: () => void) =>
      iconButton(icon(name), title, action, { "aria-pressed": "false" });
    this.loop = toggle("loop", "menu.repeat", () => {
      clock.loop = !clock.loop;
      this.mark();
    });
    this.slow = toggle("slow", "menu.slow_motion", () => {
      clock.speed = clock.speed === 0.1 ? 1 : 0.1;
      clock.changed();
      this.mark();
    });
    this.loud = toggle("sound", "menu.sound", () => {
      this.sound.turn(!this.sound.on);
      this.mark();
    });
    this.large = toggle("large", "menu.presentation_title", () => this.present.turn());
    this.present.onchange = () => this.mark();
    this.mark();
    return h("div", { class: "buttons tools" }, this.loop, this.slow, this.loud, this.large);
  }

  mark() {
    const { clock } = this.lab;
    this.loop.setAttribute("aria-pressed", String(clock.loop));
    this.slow.setAttribute("aria-pressed", String(clock.speed === 0.1));
    this.loud.setAttribute("aria-pressed", String(this.sound.on));
    this.large.setAttribute("aria-pressed", String(this.present.on));
  }

  makeMenu() {
    const item = (words: string, action: () => void) =>
      h(
        "button",
        {
          onclick: () => {
            menu.open = false;
            action();
          },
        },
        words,
      );
    const menu = h(
      "details",
      { class: "learn" },
      h("summary", { class: "button" }, "menu.learn"),
      h(
        "div",
        { class: "menu-body" },
        item("menu.visit", () => this.visit.start()),
        item("menu.challenges", () => this.challenges.open()),
        item("sensitivity.title", () => this.more.turn(true)),
        item("table.title", () => this.table.open(true)),
        item("menu.presentation", () => this.present.turn(true)),
        item("menu.teachers", () => this.teach.showModal()),
        item("menu.about", () => this.lab.about.showModal()),
      ),
    );
    return menu;
  }

  spoken() {
    this.lab.root.lang = current();
    if (!this.lab.hosted) return;
    document.documentElement.lang = current();
    this.titled();
  }

  /** The title of the page names what is shown, unless a visitor still guesses what that is. */
  titled() {
    const { lab } = this;
    if (!lab.hosted) return;
    const names = this.visit.guessing ? [] : lab.motions.films().map((film) => this.nameOf(film));
    const said = [...new Set(names)].join(" | ");
    document.title = said ? `${said} – hophoop` : t("page.title");
  }

  nameOf({ query, summary }: Film) {
    const example = this.lab.known.find((one) => one.query === query);
    if (example) return t(example.title);
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
