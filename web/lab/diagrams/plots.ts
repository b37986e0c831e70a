// Which diagrams there are: velocities, energies and losses, forces, friction utilization.

import { h, say } from "../common/dom.ts";
import { byFingers } from "../common/pointer.ts";
import { Plot } from "./plot.ts";
import { QUANTITIES, withSymbol, type Quantity } from "./quantities.ts";

function definitions(colors: Colors): PlotDefinition[] {
  return [
    {
      key: "velocities",
      title: "diagram.velocities",
      unit: "diagram.velocity_axis",
      curves: (film: Film) => [
        { name: "diagram.speed", color: colors.center_speed, values: film.columns.vx },
        { name: "diagram.rotation", color: colors.rotation_speed, dash: "dash", values: QUANTITIES.spin.values(film) },
      ],
    },
    {
      key: "energies",
      title: "diagram.energies",
      unit: "diagram.energy_axis",
      curves: (film: Film) => [
        { name: "diagram.kinetic", color: colors.kinetic, values: film.columns.kinetic },
        { name: "diagram.potential", color: colors.potential, values: film.columns.potential },
        { name: "diagram.total", values: QUANTITIES.total.values(film), dash: "dash" },
        // as in Python's plots: what an impact loses along the plane is friction's
        { name: "diagram.friction_loss", color: colors.friction_loss, values: film.columns.friction_loss },
        {
          name: film.scenario.contact.model === "compliant" ? "diagram.damper_loss" : "diagram.impact_loss",
          color: colors.impact_loss,
          values: film.columns.normal_loss,
          dash: "dot",
        },
        ...(film.scenario.plane.rolling_resistance
          ? [{ name: "diagram.rolling_loss", values: film.columns.rolling_resistance, dash: "dot" as const }]
          : []),
      ],
    },
    {
      key: "forces",
      title: "diagram.forces",
      unit: "diagram.force_axis",
      curves: (film: Film) => [
        { name: "diagram.normal_force", color: colors.normal_force, values: film.columns.normal_force },
        {
          name: "diagram.friction_force",
          color: colors.friction_force,
          dash: "dash",
          values: film.columns.friction_force,
        },
      ],
    },
    {
      key: "utilization",
      title: "diagram.utilization",
      unit: "|F| / μN",
      limits: [0, 1.08],
      curves: (film: Film) => [{ name: "|F| / μN", color: colors.friction_force, values: film.columns.utilization }],
    },
  ];
}

export class Plots {
  films: Film[];
  active: number;
  look: Look;

  shared = { axis: "time", range: null, clock: this.clock, changed: () => this.redraw() };
  axis = h(
    "select",
    {
      "aria-label": "diagram.axis_choice",
      onchange: () => {
        this.shared.axis = this.axis.value;
        this.shared.range = null;
        this.redraw();
      },
    },
    optionsOf(({ name }) => ({ key: "diagram.axis_option", values: { quantity: name } })),
  );
  plots: Plot[] = [
    ...definitions(this.colors).map((definition) => new Plot(definition, this.shared)),
    ownPlot(this.shared),
  ];
  // curves that are scrolled away wait until they are seen; not so the legends, whose room moves what is below
  seen = new Map(this.plots.map((plot) => [plot.element, true]));
  whole = false; // all curves, also those that are not seen
  back = h("button", { hidden: true, onclick: () => this.plots[0].zoomTo(null) }, "diagram.zoom_home");
  hint = h("span", { class: "hint" });
  element = h("div", { class: "plots" }, h("div", { class: "plots-head" }, this.axis, this.back, this.hint), [
    ...this.seen.keys(),
  ]);

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
    this.films = films;
    this.active = active;
    this.look = look;
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

/** Options of a list of quantities. */
const optionsOf = (words: (quantity: Quantity) => Message) =>
  Object.entries(QUANTITIES).map(([key, quantity]) => h("option", { value: key }, words(quantity)));

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
  const name = () => {
    const { symbol, unit } = QUANTITIES[key];
    plot.unit = unit ? `${symbol} [${unit}]` : symbol;
  };
  const select = h(
    "select",
    {
      "aria-label": "diagram.own_choice",
      onchange: () => {
        key = select.value;
        name();
        shared.changed();
      },
    },
    optionsOf(withSymbol),
  );
  select.value = key;
  name();
  plot.element.querySelector("h2")?.after(select);
  return plot;
}
