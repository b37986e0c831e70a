// What stands beside the picture: mode, time and angle of each hoop, the colours of speed, what the lines are.

const MOST_RULER = 90; // pixels

const element: (id: string) => HTMLElement = (id) => document.getElementById(id) as HTMLElement;

const named: (tag: string, className: string, ...children: (Node | string)[]) => HTMLElement = (
  tag,
  className,
  ...children
) => {
  const made = document.createElement(tag);
  made.className = className;
  made.append(...children);
  return made;
};

export class Words {
  rows: { dot: HTMLElement; word: HTMLElement; time: HTMLElement; angle: HTMLElement }[];
  ruler: HTMLElement | undefined;
  force: Text | undefined;

  constructor(readonly data: SceneData) {
    document.body.style.background = data.theme.background;
    document.body.style.color = data.theme.ink;
    this.rows = data.hoops.map((hoop) => this.row(hoop));
    this.scale();
    this.key();
  }

  row(hoop: SceneHoop) {
    const [dot, word, time, angle] = ["dot", "word", "t", "angle"].map((name) => named("span", name));
    const label = named("span", "label", hoop.tag ? `${hoop.tag}: ${hoop.label}` : hoop.label);
    element("words").append(named("div", "row", named("span", "mode", dot, word), time, angle, label));
    return { dot, word, time, angle };
  }

  scale() {
    const { map, topSpeed } = this.data;
    const stops = map.map((color) => `rgb(${color.join(",")})`).join(",");
    element("bar").style.background = `linear-gradient(to right, ${stops})`;
    const power = 10 ** Math.floor(Math.log10(topSpeed / 3));
    const step = [5, 2, 1].map((x) => x * power).find((x) => x <= (topSpeed / 3) * 1.000001) ?? power;
    for (let value = 0; value <= topSpeed; value += step) {
      const tick = named("span", "", String(+value.toPrecision(6)));
      tick.style.left = `${(100 * value) / topSpeed}%`;
      element("ticks").append(tick);
    }
  }

  key() {
    const { hoops, colors, theme, newton, flies } = this.data;
    const lines = [];
    if (hoops.some((hoop) => hoop.traces !== null)) {
      lines.push([theme.load, "load"], [colors.center, "centre of gravity"]);
      if (flies) lines.push([colors.airborne, "airborne"]);
    }
    if (newton) lines.push([colors.normal, "normal force"], [colors.friction, "friction"]);
    for (const [color, word] of lines) {
      const swatch = document.createElement("i");
      swatch.style.borderColor = color;
      element("lines").append(named("span", "", swatch, word));
    }
    if (!newton) return;
    // its length is that of the arrow of a round force, at the hoop's distance
    this.ruler = document.createElement("i");
    this.force = document.createTextNode("");
    element("lines").append(named("span", "ruler", this.ruler, this.force));
  }

  /** `newton`: length of a newton's arrow [m]; `metre`: [pixels]. */
  showScale(newton: number, metre: number) {
    if (!this.ruler || !this.force) return;
    const most = MOST_RULER / (newton * metre);
    const power = 10 ** Math.floor(Math.log10(most));
    const amount = [5, 2, 1].map((x) => x * power).find((x) => x <= most * 1.000001) ?? power;
    this.ruler.style.width = `${(amount * newton * metre).toFixed(1)}px`;
    this.force.textContent = `${+amount.toPrecision(6)} N`;
  }

  /** `metre`: at what is looked at [pixels]. */
  show(now: number, metre: number) {
    const frame = Math.floor(now);
    if (this.data.newton) this.showScale(this.data.newton[frame], metre);
    for (const [i, hoop] of this.data.hoops.entries()) {
      const [word, color] = this.data.modes[hoop.mode[frame]];
      const row = this.rows[i];
      // the numbers are those of a frame; only the picture moves on between two
      const degrees = ((hoop.angle[frame] * 180) / Math.PI).toFixed(1);
      row.dot.style.background = color;
      row.word.textContent = word;
      row.time.textContent = `t = ${hoop.t[frame].toFixed(3)} s`;
      row.angle.textContent = `θ = ${degrees}°`.replace("-", "−");
    }
  }
}
