// What moves the film: buttons, speed, and which things are drawn.

import { SPEEDS } from "./clock.ts";
import { h, iconButton as button, selection } from "../common/dom.ts";
import { icon } from "../common/icons.ts";
import { degrees, show } from "../common/numbers.ts";
import { eventWord, leaves } from "./marks.ts";
import { name } from "../words/words.ts";
import type { Motions } from "./motions.ts";
import type { Notice } from "../shell/notice.ts";
import type { Stage } from "./stage.ts";
import type { Story } from "./story.ts";

const STEP = 1 / 60; // seconds

const SWITCHES = ["traces", "forces", "speed", "whole", "three"] as const;

const marked = (mark: string, word: string) => h("span", h("span", { "aria-hidden": "true" }, `${mark} `), word);

export class Transport {
  titled = "";

  playButton = button(icon("play"), "player.play", () => this.clock.play(), { class: "play" });
  speeds = selection(
    SPEEDS,
    (speed) => `${speed}×`,
    (speed) => (this.clock.speed = Number(speed)),
    { "aria-label": "player.playback_speed" },
  );
  switches = new Map(
    SWITCHES.map((name) => [
      name,
      h("button.switch", { title: `player.${name}_title`, onclick: () => this.toggle(name) }, `player.${name}`),
    ]),
  );
  row = h("div.buttons.switches", [...this.switches.values()]);
  element = h(
    "div.transport",
    h(
      "div.buttons",
      button(icon("start"), "player.to_start", () => this.clock.seek(0)),
      button(icon("previous"), "player.previous_event", () => this.jump(-1)),
      button(icon("back"), "player.frame_back", () => this.nudge(-1)),
      this.playButton,
      button(icon("on"), "player.frame_on", () => this.nudge(1)),
      button(icon("next"), "player.next_event", () => this.jump(1)),
    ),
    h(
      "div.buttons.jumps",
      button(marked("▲", "mode.flight"), "player.next_flight", () => this.jump(1, "takeoff")),
      button(marked("▼", "event.impact"), "player.next_landing", () => this.jump(1, "impact")),
    ),
    this.speeds,
    this.row,
  );

  constructor(
    readonly clock: Clock,
    readonly motions: Motions,
    readonly stage: Stage,
    readonly story: Story,
    readonly notice: Notice,
    readonly toggle: (name: keyof StageOptions) => void,
  ) {
    this.speeds.value = "1";
  }

  show() {
    const { clock, playButton } = this;
    const { options } = this.stage;
    for (const [name, box] of this.switches) box.ariaPressed = String(options[name]);
    const title = clock.playing ? "player.pause" : "player.play";
    if (this.titled !== title) {
      this.titled = title;
      playButton.replaceChildren(icon(clock.playing ? "pause" : "play"));
      name(playButton, "title", title);
      name(playButton, "aria-label", title);
    }
    if (this.speeds.value !== String(clock.speed)) this.speeds.value = String(clock.speed);
  }

  nudge(way: -1 | 1) {
    this.clock.playing = false;
    this.clock.seek(this.clock.time + way * STEP * Math.min(this.clock.speed, 1));
  }

  /** To the next event of all films, or of one kind; where there is none of that kind any more, to its first. */
  jump(way: -1 | 1, kind: "takeoff" | "impact" | null = null) {
    this.clock.playing = false;
    const { notice, story } = this;
    const films = this.motions.films();
    const all = films
      .flatMap((film, lane) => film.events.map((event) => ({ event, lane })))
      .filter(({ event }) => !kind || (kind === "impact" ? event.kind === kind : leaves(event)))
      .sort((a, b) => a.event.t - b.event.t);
    const now = this.clock.time;
    let next =
      way > 0 ? all.find(({ event }) => event.t > now + 1e-9) : all.findLast(({ event }) => event.t < now - 1e-9);
    if (!next && kind) next = all[0];
    if (!next) {
      if (kind) notice.say(kind === "takeoff" ? "player.no_flight" : "player.no_landing");
      return;
    }
    this.clock.seek(next.event.t);
    const { event, lane } = next;
    const values = { what: eventWord(event.kind), angle: degrees(event.angle), time: show(event.t, 4) };
    const said = { key: "player.event_at", values };
    story.say(films.length > 1 ? [["hoops.a", "hoops.b"][lane], ": ", said] : said);
  }
}
