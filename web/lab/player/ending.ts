// What becomes of the shown motion in the end: a sentence on request, and the gait that it settles on.

import { h, say } from "../common/dom.ts";
import { show } from "../common/numbers.ts";
import { messageOf } from "../words/words.ts";
import type { Motions } from "./motions.ts";
import type { Story } from "./story.ts";

export class Ending {
  asked: AbortController | null = null;
  known: Fate | null = null;
  of: any = null; // the scenario of the answer
  answer = h("span");
  ask = h("button", { onclick: () => this.fetch() }, "ending.ask");
  gait = h("button", { hidden: true, onclick: () => this.take() }, "ending.show");
  element = h("p.ending", this.ask, " ", this.answer, " ", this.gait);

  constructor(
    readonly backend: Backend,
    readonly clock: Clock,
    readonly motions: Motions,
    readonly story: Story,
  ) {}

  /** Another motion has another end. */
  changed() {
    if (this.motions.film().scenario === this.of) return;
    this.asked?.abort();
    this.of = this.known = null;
    this.gait.hidden = true;
    say(this.answer, "");
  }

  async fetch() {
    this.asked?.abort();
    this.asked = new AbortController();
    const { scenario } = this.motions.film();
    this.of = scenario;
    say(this.answer, "ending.computing");
    let said: Message;
    try {
      this.known = await this.backend.fate(scenario, this.asked.signal);
      said = textOf(this.known);
    } catch (error) {
      if (error.name === "AbortError") return;
      said = messageOf(error);
    }
    say(this.answer, said);
    this.gait.hidden = !Number.isFinite(this.known?.final_omega);
    this.story.say(said);
  }

  /** Start on the gait, with the load at the bottom. */
  take() {
    const { hoop } = this.motions.film().scenario;
    const speed = (this.known as Fate).final_omega * hoop.radius;
    this.clock.time = 0;
    this.motions.change(
      [
        ["start.angle", Math.PI],
        ["start.speed", speed],
      ],
      true,
    );
  }
}

function textOf({ fate, turns, hops, passages, mean_speed }: Fate): Message {
  const sentence = `fate.${fate}`;
  if (fate === "gait")
    return [sentence, " ", { key: "ending.gait_in", values: { turns, hops, speed: show(mean_speed, 4) } }];
  if (fate === "undecided" || fate === "chaotic")
    return [sentence, " ", { key: "ending.after", values: { count: passages } }];
  return sentence;
}
