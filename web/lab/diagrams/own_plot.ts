// A diagram of the visitor's own choice: any quantity upwards; what stands across is chosen for all diagrams.

import { h } from "../common/dom.ts";
import { Plot } from "./plot.ts";
import { QUANTITIES, withSymbol, type Quantity } from "./quantities.ts";

/** Options of a list of quantities. */
export const optionsOf = (words: (quantity: Quantity) => Message) =>
  Object.entries(QUANTITIES).map(([key, quantity]) => h("option", { value: key }, words(quantity)));

export function ownPlot(shared: PlotShared): Plot {
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
  plot.element.querySelector("h3")?.after(select);
  return plot;
}
