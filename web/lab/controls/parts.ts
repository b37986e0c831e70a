// The table of a real hoop's parts.

import { h } from "../common/dom.ts";
import { Entry } from "./entry.ts";

const SHAPES = {
  ring: { label: "parts.ring", keys: ["mass", "inner_radius", "outer_radius"] },
  disk: { label: "parts.disk", keys: ["mass", "radius", "at"] },
  point_mass: { label: "parts.point_mass", keys: ["mass", "at"] },
  rod: { label: "parts.rod", keys: ["mass", "length", "at"] },
};
const LABELS: Named<[string, string]> = {
  mass: ["parts.mass", "kg"],
  inner_radius: ["parts.inner_radius", "m"],
  outer_radius: ["parts.outer_radius", "m"],
  radius: ["parts.radius", "m"],
  at: ["parts.at", "m"],
  length: ["parts.length", "m"],
};

const fresh = (shape: Part["shape"], R: number, mass: number) =>
  ({
    ring: { shape, mass, inner_radius: 0.95 * R, outer_radius: R },
    disk: { shape, mass, radius: 0.1 * R, at: 0.8 * R },
    point_mass: { shape, mass, at: R },
    rod: { shape, mass, length: 0.5 * R, at: 0.5 * R },
  })[shape];

/** Parts that stand for the hoop there is: a thin ring and a load. */
export function partsLike(values: Named) {
  const R = values["hoop.radius"];
  const mass = values["hoop.mass"];
  const load = Math.min(Math.max(values["hoop.eccentricity"], 0.01), 0.99);
  return [
    { shape: "ring", mass: round(mass * (1 - load)), inner_radius: round(0.98 * R), outer_radius: R },
    { shape: "point_mass", mass: round(mass * load), at: R },
  ];
}

const round = (value: number) => Number(value.toPrecision(6));

export class Parts {
  parts: Part[] = [];
  shapes = "";
  entries = new Map<string, Entry>();
  radius: number;
  mass: number;

  list = h("div.parts");
  more = h(
    "select",
    {
      "aria-label": "parts.add_label",
      onchange: () => {
        const shape = this.more.value as Part["shape"] | "";
        this.more.value = "";
        if (shape) this.send([...this.parts, fresh(shape, this.radius, round(0.2 * this.mass))]);
      },
    },
    h("option", { value: "" }, "parts.add"),
    Object.entries(SHAPES).map(([key, { label }]) => h("option", { value: key }, label)),
  );
  element = h("div", this.list, this.more);

  constructor(public onchange: (changes: Change[], commit?: boolean) => void) {}

  send(parts: Part[]) {
    this.onchange([["hoop.parts", parts]]);
  }

  show(parts: Part[], radius: number, mass: number) {
    const shapes = parts.map(({ shape }) => shape).join();
    Object.assign(this, { parts, radius, mass });
    if (shapes !== this.shapes) {
      const held = this.list.matches(":focus-within");
      this.shapes = shapes;
      this.entries.clear();
      this.list.replaceChildren(...parts.map((part, i) => this.row(part, i)));
      if (held) this.more.focus(); // what had the focus is gone
    }
    for (const [i, part] of parts.entries()) {
      for (const key of SHAPES[part.shape].keys) this.entries.get(`${i}.${key}`)?.show(String(part[key] ?? 0));
    }
  }

  row(part: Part, i: number) {
    const { label, keys } = SHAPES[part.shape];
    return h(
      "fieldset.part",
      h(
        "legend",
        label,
        this.parts.length > 1 &&
          h(
            "button.quiet",
            {
              "aria-label": { key: "parts.remove", values: { number: i + 1, what: label } },
              onclick: () => this.send(this.parts.filter((_, k) => k !== i)),
            },
            "×",
          ),
      ),
      keys.map((key) => this.field(i, key)),
    );
  }

  field(i: number, key: string) {
    const [label, unit] = LABELS[key];
    const entry = new Entry({ label, unit }, (value) =>
      this.send(this.parts.map((one, k) => (k === i ? { ...one, [key]: value } : one))),
    );
    this.entries.set(`${i}.${key}`, entry);
    return h("div", h("label", label, ` [${unit}]`, entry.input), entry.error);
  }
}
