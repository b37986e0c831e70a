// The table of a real hoop's parts.

import { h } from "./dom.js";
import { Entry } from "./entry.js";

const SHAPES = {
  ring: { label: "Ring", keys: ["mass", "inner_radius", "outer_radius"] },
  disk: { label: "Disk", keys: ["mass", "radius", "at"] },
  point_mass: { label: "Point mass", keys: ["mass", "at"] },
  rod: { label: "Rod", keys: ["mass", "length", "at"] },
};
/** @type {Record<string, [string, string]>} */
const LABELS = {
  mass: ["mass", "kg"],
  inner_radius: ["inner radius", "m"],
  outer_radius: ["outer radius", "m"],
  radius: ["radius", "m"],
  at: ["distance from centre", "m"],
  length: ["length", "m"],
};

/**
 * @param {Part["shape"]} shape
 * @param {number} R
 * @param {number} mass
 */
const fresh = (shape, R, mass) =>
  ({
    ring: { shape, mass, inner_radius: 0.95 * R, outer_radius: R },
    disk: { shape, mass, radius: 0.1 * R, at: 0.8 * R },
    point_mass: { shape, mass, at: R },
    rod: { shape, mass, length: 0.5 * R, at: 0.5 * R },
  })[shape];

/**
 * Parts that stand for the hoop there is: a thin ring and a load.
 * @param {Record<string, any>} values
 * @returns {Part[]}
 */
export function partsLike(values) {
  const R = values["hoop.radius"];
  const mass = values["hoop.mass"];
  const load = Math.min(Math.max(values["hoop.eccentricity"], 0.01), 0.99);
  return [
    { shape: "ring", mass: round(mass * (1 - load)), inner_radius: round(0.98 * R), outer_radius: R },
    { shape: "point_mass", mass: round(mass * load), at: R },
  ];
}

/** @param {number} value */
const round = (value) => Number(value.toPrecision(6));

export class Parts {
  /** @type {Part[]} */
  parts;
  /** @type {string} */
  text;
  /** @type {number} */
  radius;
  /** @type {number} */
  mass;

  /** @param {(changes: Change[], commit?: boolean) => void} onchange */
  constructor(onchange) {
    this.onchange = onchange;
    this.list = h("div", { class: "parts" });
    this.element = h(
      "div",
      {},
      this.list,
      h(
        "select",
        {
          "aria-label": "Add a part",
          onchange: (/** @type {any} */ event) => {
            const shape = event.target.value;
            event.target.value = "";
            if (shape) this.send([...this.parts, fresh(shape, this.radius, round(0.2 * this.mass))]);
          },
        },
        h("option", { value: "" }, "+ add a part …"),
        Object.entries(SHAPES).map(([key, { label }]) => h("option", { value: key }, label)),
      ),
    );
  }

  /** @param {Part[]} parts */
  send(parts) {
    this.onchange([["hoop.parts", parts]]);
  }

  /**
   * @param {Part[]} parts
   * @param {number} radius
   * @param {number} mass
   */
  show(parts, radius, mass) {
    const text = JSON.stringify(parts);
    if (
      text === this.text ||
      this.list.contains(/** @type {Document | ShadowRoot} */ (this.list.getRootNode()).activeElement)
    ) {
      this.parts = parts;
      return;
    }
    Object.assign(this, { text, parts, radius, mass });
    this.list.replaceChildren(...parts.map((part, i) => this.row(part, i)));
  }

  /**
   * @param {Part} part
   * @param {number} i
   */
  row(part, i) {
    const { label, keys } = SHAPES[part.shape];
    return h(
      "fieldset",
      { class: "part" },
      h(
        "legend",
        {},
        label,
        this.parts.length > 1 &&
          h(
            "button",
            {
              type: "button",
              class: "quiet",
              "aria-label": { key: "Remove part {number}, {what}", values: { number: i + 1, what: label } },
              onclick: () => this.send(this.parts.filter((_, k) => k !== i)),
            },
            "×",
          ),
      ),
      keys.map((key) => this.field(part, i, key)),
    );
  }

  /**
   * @param {Part} part
   * @param {number} i
   * @param {string} key
   */
  field(part, i, key) {
    const [label, unit] = LABELS[key];
    const entry = new Entry({ label, unit }, (value) =>
      this.send(this.parts.map((one, k) => (k === i ? { ...one, [key]: value } : one))),
    );
    entry.show(String(part[key] ?? 0));
    return h("div", {}, h("label", {}, label,
      ` [${unit}]`, entry.input), entry.error);
  }
}
