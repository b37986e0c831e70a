// What stands beside the picture: mode, time and angle of each hoop, the colours of speed, what the lines are.

import { rounded } from "../lab/common/clamp.ts";
import { SPEED_GRADIENT } from "../lab/common/colors.ts";

const MOST_RULER = 90; // pixels

const element = (id: string) => document.getElementById(id) as HTMLElement;

function named(tag: string, className: string, ...children: (Node | string)[]) {
  const made = document.createElement(tag);
  made.className = className;
  made.append(...children);
  return made;
}

/** Without the noise of its last digits. */
const plain = (value: number) => String(Number(value.toPrecision(6)));

export class Words {
  rows = this.data.hoops.map((hoop) => this.row(hoop));
  ruler = named("i", "");
  force = document.createTextNode("");

  constructor(readonly data: SceneData) {
    document.body.style.background = data.theme.paper;
    document.body.style.color = data.theme.ink;
    this.scale(data.extent.speed);
    this.key();
  }

  row(hoop: SceneHoop) {
    const [dot, word, time, angle] = ["dot", "word", "t", "angle"].map((name) => named("span", name));
    const label = named("span", "label", hoop.tag ? `${hoop.tag}: ${hoop.label}` : hoop.label);
    element("words").append(named("div", "row", named("span", "mode", dot, word), time, angle, label));
    return { dot, word, time, angle };
  }

  scale(most: number) {
    element("bar").style.background = SPEED_GRADIENT;
    const step = rounded(most / 3);
    for (let value = 0; value <= most; value += step) {
      const tick = named("span", "", plain(value));
      tick.style.left = `${(100 * value) / most}%`;
      element("ticks").append(tick);
    }
  }

  key() {
    const { hoops, colors, theme, newton, flies } = this.data;
    const path = hoops.some((hoop) => hoop.path !== null);
    const lines = [
      path && [theme.ink, "load"],
      path && [colors.gravity_center, "centre of gravity"],
      flies && [colors.airborne, "airborne"],
      newton && [colors.normal_force, "normal force"],
      newton && [colors.friction_force, "friction"],
    ];
    for (const [color, word] of lines.filter(Boolean) as string[][]) {
      const swatch = named("i", "");
      swatch.style.borderColor = color;
      element("lines").append(named("span", "", swatch, word));
    }
    // its length is that of the arrow of a round force, at the hoop's distance
    if (newton) element("lines").append(named("span", "ruler", this.ruler, this.force));
  }

  /** `metre`: at what is looked at [pixels]. */
  show(now: number, metre: number) {
    const { newton, hoops, modes } = this.data;
    const frame = Math.floor(now);
    if (newton) {
      const amount = rounded(MOST_RULER / (newton * metre));
      this.ruler.style.width = `${(amount * newton * metre).toFixed(1)}px`;
      this.force.data = `${plain(amount)} N`;
    }
    for (const [i, { frames }] of hoops.entries()) {
      const [word, color] = modes[frames.mode[frame]];
      const row = this.rows[i];
      // the numbers are those of a frame; only the picture moves on between two
      const degrees = ((frames.angle[frame] * 180) / Math.PI).toFixed(1);
      row.dot.style.background = color;
      row.word.textContent = word;
      row.time.textContent = `t = ${frames.t[frame].toFixed(3)} s`;
      row.angle.textContent = `θ = ${degrees}°`.replace("-", "−");
    }
  }
}
