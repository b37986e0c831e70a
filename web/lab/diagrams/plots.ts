// Which diagrams there are: velocities, energies and losses, forces, friction utilization.

import { h, say, selection } from "../common/dom.ts";
import { byFingers } from "../common/pointer.ts";
import { tables } from "../../model/tables.ts";
import { Plot } from "./plot.ts";
import { QUANTITIES } from "./quantities.ts";

/** The table of curves is that of Python's plots and films. */
const definitions = Object.entries(tables.curves).map(
  ([key, curves]): PlotDefinition => ({
    key,
    title: `diagram.${key}`,
    unit: `diagram.${key}_axis`,
    limits: key === "utilization" ? [0, 1.08] : undefined,
    curves: (film) =>
      curves
        .filter(({ field }) => field !== "rolling_resistance" || film.scenario.plane[field])
        .map(({ field, color }) => ({ name: nameOf(field, film), color, values: QUANTITIES[field].values(film) })),
  }),
);

/** What compliant contacts lose, they lose in their damper. */
const nameOf = (field: string, { scenario }: Film) =>
  `curve.${field === "normal_loss" && scenario.contact.model === "compliant" ? "damper_loss" : field}`;

export class Plots {
  films: Film[];
  active: number;
  look: Look;

  shared = { axis: "time", range: null, clock: this.clock, changed: () => this.redraw() };
  axis = selection(
    Object.keys(QUANTITIES),
    (key) => ({ key: "diagram.axis_option", values: { quantity: QUANTITIES[key].name } }),
    (key) => {
      Object.assign(this.shared, { axis: key, range: null });
      this.redraw();
    },
    { "aria-label": "diagram.axis_choice" },
  );
  plots: Plot[] = [...definitions.map((definition) => new Plot(definition, this.shared)), ownPlot(this.shared)];
  // curves that are scrolled away wait until they are seen; not so the legends, whose room moves what is below
  seen = new Map(this.plots.map((plot) => [plot.element, true]));
  whole = false; // all curves, also those that are not seen
  back = h("button", { hidden: true, onclick: () => this.plots[0].home() }, "diagram.zoom_home");
  hint = h("span.hint");
  element = h("div.plots", h("div.plots-head", this.axis, this.back, this.hint), [...this.seen.keys()]);

  constructor(
    readonly clock: Clock,
    readonly colors: Colors,
  ) {
    const watch = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) this.seen.set(target as HTMLElement, isIntersecting);
        this.redraw();
      },
      { rootMargin: "400px" },
    );
    for (const plot of this.plots) watch.observe(plot.element);
  }

  draw(films: Film[], active: number, look: Look) {
    Object.assign(this, { films, active, look });
    const hands = byFingers() ? "diagram.hint_touch" : "diagram.hint_mouse";
    const two = films.length > 1;
    say(this.hint, two ? { key: "diagram.hint_two_hoops", values: { hoop: "AB"[active], hands } } : hands);
    this.redraw();
  }

  redraw() {
    if (!this.films?.length) return;
    this.back.hidden = !this.shared.range;
    for (const plot of this.plots) plot.take(this.films, this.active, this.look);
    for (const plot of this.visible()) plot.draw(this.colors);
    this.cursor(this.shared.clock.time);
  }

  visible() {
    return this.plots.filter((plot) => this.whole || this.seen.get(plot.element));
  }

  cursor(time: number) {
    for (const plot of this.visible()) plot.cursor(time);
  }
}

// --- A diagram of the visitor's own choice: any quantity upwards; what stands across is chosen for all diagrams

function ownPlot(shared: PlotShared): Plot {
  let key = "height";
  const plot = new Plot(
    {
      key: "own",
      title: "diagram.own",
      unit: "",
      curves: (film) => [{ name: QUANTITIES[key].name, values: QUANTITIES[key].values(film) }],
    },
    shared,
  );
  const name = (chosen: string) => {
    key = chosen;
    const { symbol, unit } = QUANTITIES[key];
    plot.definition.unit = unit ? `${symbol} [${unit}]` : symbol;
  };
  const select = selection(
    Object.keys(QUANTITIES),
    (other) => [QUANTITIES[other].name, " ", QUANTITIES[other].symbol],
    (chosen) => {
      name(chosen);
      shared.changed();
    },
    { "aria-label": "diagram.own_choice" },
  );
  select.value = key;
  name(key);
  plot.element.querySelector("h2")?.after(select);
  return plot;
}
