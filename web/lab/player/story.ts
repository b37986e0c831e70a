// The motion in words, as a list that leads to each moment, and what theory says about this hoop.

import { copying, h, say } from "../common/dom.ts";
import { show } from "../common/numbers.ts";
import type { Comparison } from "../backend/sameness.ts";

const FADED = 20; // pixels at the end of the list

export class Story {
  film: Film;
  items: HTMLElement[];
  current: number;
  listed: Film | null = null;
  /** The fingerprint that is shown. */
  signed: string;

  summary = h("p.summary");
  doubt = h("p.hint", { hidden: true });
  list = h("ol.story-list", { onscroll: () => this.fade() });
  heading = h("h2", "motion.story");
  signature = h("span");
  compared = h("span");
  /** Shown with the advanced controls. */
  fingerprint = h("p.hint.fingerprint", this.signature, this.compared);
  live = h("div.spoken", { role: "status", "aria-live": "polite" });
  element = h(
    "section.story",
    { "aria-label": "motion.story_label" },
    this.heading,
    this.summary,
    this.doubt,
    this.list,
    this.live,
  );

  constructor(public clock: Clock) {}

  /**
   * The list is that of the chosen hoop, the sentences above it are those of both. `comparisons`: of its fingerprint
   * with those of elsewhere.
   */
  draw(films: Film[], active: number, colors: Colors, comparisons: Comparison[]) {
    this.film = films[active];
    say(this.heading, films.length > 1 ? { key: "motion.story_of", values: { hoop: "AB"[active] } } : "motion.story");
    this.summary.replaceChildren(
      ...films.flatMap((film, i) => [
        films.length > 1 ? h("b", `${"AB"[i]}: `) : "",
        h("span", film.summary),
        film.status === "event_limit" || film.shortened ? h("span", " ", "motion.shortened") : "",
        i + 1 < films.length ? h("br") : "",
      ]),
    );
    this.doubt.hidden = !this.film.doubt;
    say(this.doubt, this.film.doubt);
    if (this.listed !== this.film) this.fill(colors);
    this.sign();
    this.compared.replaceChildren(
      ...comparisons.flatMap(({ same, text }) => [" ", h("span", { class: same ? "same" : "differs" }, text)]),
    );
    // what a link has asked, and what should be equal and is not, is seen
    const group = this.fingerprint.closest("details");
    if (group && comparisons.some(({ same, asked }) => asked || !same)) group.open = true;
    this.cursor(this.clock.time);
  }

  /** The list; it stays as it is while the motion is the same, with what has the focus in it. */
  fill(colors: Colors) {
    this.listed = this.film;
    this.current = -1;
    const point = (time: number | null) => () => this.clock.point(time);
    this.items = this.film.story.map((sentence) =>
      h(
        "li",
        h(
          "button",
          {
            onclick: () => this.clock.seek(sentence.t),
            onpointerenter: point(sentence.t),
            onpointerleave: point(null),
            onfocus: point(sentence.t),
            onblur: point(null),
          },
          h("i.dot", { style: `background:${colors.modes[sentence.mode]}`, "aria-hidden": "true" }),
          h("span.when", `${show(sentence.t, 4)} s`),
          h("span", sentence.text),
        ),
      ),
    );
    this.list.replaceChildren(...this.items);
    this.clock.pointed = null; // what was pointed at is gone
  }

  /** At its top the list fades as at its end, unless a row begins there. */
  fade() {
    const [first] = this.items;
    const begins = this.items.some((one) => Math.abs(one.offsetTop - first.offsetTop - this.list.scrollTop) < 1);
    this.list.style.setProperty("--fade", begins ? "" : `${FADED}px`);
  }

  /** The fingerprint; its button stays, with what it has said, until the motion is another. */
  sign() {
    const { fingerprint } = this.film;
    if (fingerprint === this.signed) return;
    this.signed = fingerprint;
    this.signature.replaceChildren(...fingerprintOf(fingerprint));
  }

  /** Tell a screen reader: the one place where changes are said, so that they do not talk over each other. */
  say(said: Message) {
    say(this.live, said);
  }

  announce(films: Film[]) {
    this.say(films.flatMap((film, k) => (k ? [" ", film.summary] : [film.summary])));
  }

  cursor(time: number) {
    const { story } = this.film;
    const now = story.findLastIndex(({ t }) => t <= time + 1e-9);
    if (now === this.current) return;
    this.items[this.current]?.removeAttribute("aria-current");
    this.items[now]?.setAttribute("aria-current", "step");
    this.current = now;
    // scroll the list, never the page
    const item = this.items[now];
    if (item) {
      const { offsetTop, offsetHeight } = item;
      const { scrollTop, clientHeight } = this.list;
      const hidden = offsetTop < scrollTop + FADED || offsetTop + offsetHeight > scrollTop + clientHeight - FADED;
      const first = this.items.find((one) => one.offsetTop >= offsetTop - 0.4 * clientHeight) ?? item;
      if (hidden) this.list.scrollTop = first.offsetTop - this.items[0].offsetTop;
    }
  }
}

/** The fingerprint with a button that copies it. */
function fingerprintOf(fingerprint: string) {
  const code = h("code", document.createTextNode(fingerprint));
  const title = "motion.fingerprint_title";
  return [h("span", { title }, "motion.fingerprint"), " ", code, " ", copying(code)];
}

export class Theory {
  list = h("dl");
  heading = h("h2", "motion.theory");
  element = h("section.theory", this.heading, this.list);

  draw(thresholds: { label: Message; text: Message }[], hoop = "") {
    say(this.heading, hoop ? { key: "motion.theory_of", values: { hoop } } : "motion.theory");
    this.list.replaceChildren(...thresholds.flatMap(({ label, text }) => [h("dt", label), h("dd", text)]));
  }
}
