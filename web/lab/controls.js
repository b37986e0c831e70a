// Sliders with exact entry, and choices; what they show comes back from the server with each motion.

import { focused, h } from "./dom.js";
import { clamp, show, withUnit } from "./numbers.js";
import { Parts, partsLike } from "./parts.js";

const DEGREE = Math.PI / 180;

class Slider {
  /**
   * @param {SliderInfo} info
   * @param {(changes: Change[], commit: boolean) => void} onchange
   */
  constructor(info, onchange) {
    this.info = info;
    this.onchange = onchange;
    const id = `hh-${info.path}-${Math.random().toString(36).slice(2, 7)}`;
    this.range = h("input", {
      type: "range",
      id,
      class: "slider",
      min: String(this.low()),
      max: String(this.high()),
      step: info.logarithmic ? "0.01" : String(info.step),
      "data-path": info.path,
      oninput: () => this.slid(false),
      onchange: () => this.slid(true),
    });
    this.number = h("input", {
      type: "number",
      step: "any",
      class: "exact",
      "aria-label": `${info.label}, exact value${info.unit ? ` in ${info.unit}` : ""}`,
      onchange: () => this.typed(),
    });
    this.element = h(
      "div",
      { class: "control", title: info.help },
      h("label", { for: id }, h("span", {}, info.label), h("span", { class: "symbol" }, info.symbol)),
      this.range,
      h("span", { class: "entry" }, this.number, h("span", { class: "unit" }, info.unit)),
    );
  }

  low() {
    return this.info.logarithmic ? Math.log10(this.info.least) : this.info.least;
  }

  high() {
    return this.info.logarithmic ? Math.log10(this.info.most) : this.info.most;
  }

  /** @param {boolean} commit */
  slid(commit) {
    const place = Number(this.range.value);
    const value = this.info.logarithmic ? Number((10 ** place).toPrecision(3)) : place;
    this.number.value = String(value);
    this.say(value);
    this.send(value, commit);
  }

  typed() {
    if (this.number.value.trim() === "") return;
    this.send(Number(this.number.value), true);
  }

  /**
   * @param {number} value
   * @param {boolean} commit
   */
  send(value, commit) {
    this.onchange([[this.info.path, this.info.degrees ? value * DEGREE : value]], commit);
  }

  /** @param {number} value */
  say(value) {
    this.range.setAttribute("aria-valuetext", withUnit(show(value, 4), this.info.unit));
  }

  /**
   * @param {number | string | null | undefined} value "inf" for no limit
   * @param {number | null} automatic what is chosen where there is no value
   */
  show(value, automatic = null) {
    // what the lab chooses by itself stands behind an empty field
    const own = value !== null && value !== undefined;
    const found = own ? value : automatic;
    if (found === null || found === undefined) {
      this.number.value = "";
      return;
    }
    const shown = found === "inf" ? Infinity : Number(found) / (this.info.degrees ? DEGREE : 1);
    const text = Number.isFinite(shown) ? String(Number(shown.toPrecision(9))) : "";
    this.number.value = own ? text : "";
    this.number.placeholder = !own ? `auto ${show(shown, 2)}` : Number.isFinite(shown) ? "" : "∞";
    this.number.title = own ? withUnit(String(shown), this.info.unit) : "";
    const place = this.info.logarithmic ? Math.log10(shown) : shown;
    if (!focused(this.range) || Math.abs(Number(this.range.value) - place) > 1e-6) {
      this.range.value = String(clamp(place, this.low(), this.high()));
    }
    this.say(shown);
  }
}

/**
 * @param {ChoiceInfo} info
 * @param {(changes: Change[], commit: boolean) => void} onchange
 */
function choice(info, onchange) {
  const select = h(
    "select",
    { "data-path": info.path, onchange: () => onchange([[info.path, select.value]], true) },
    info.options.map(([value, label]) => h("option", { value }, label)),
  );
  const element = h("label", { class: "choice", title: info.help }, h("span", {}, info.label), select);
  return { element, select, path: info.path };
}

export class Controls {
  /** @type {{ select: HTMLSelectElement, element: HTMLElement }} */
  way;
  /** @type {{ select: HTMLSelectElement, element: HTMLElement }} */
  kind;
  /** @type {{ select: HTMLSelectElement, element: HTMLElement }} */
  gravity;
  /** @type {HTMLInputElement} */
  apart;
  /** @type {HTMLElement} */
  derived;
  /** @type {Film} */
  film;

  /**
   * @param {ControlsInfo} setup
   * @param {(changes: Change[], commit: boolean) => void} onchange
   */
  constructor(setup, onchange) {
    this.onchange = (/** @type {Change[]} */ changes, commit = true) => onchange(changes, commit);
    /** @type {Map<string, Slider>} */
    this.sliders = new Map();
    for (const list of Object.values(setup.groups)) {
      for (const info of list) this.sliders.set(info.path, new Slider(info, this.onchange));
    }
    this.choices = new Map(setup.choices.map((info) => [info.path, choice(info, this.onchange)]));
    this.parts = new Parts(this.onchange);
    this.gravities = setup.gravities;
    this.element = h("div", { class: "controls" }, this.hoop(), this.plane(), this.start(), this.contact());
  }

  /** @param {string} path */
  at(path) {
    const found = this.sliders.get(path) ?? this.choices.get(path);
    if (!found) throw new Error(`There is no control of ${path}.`);
    return found.element;
  }

  /**
   * @param {string} label
   * @param {[string, string][]} options
   * @param {(value: string) => void} onchange
   */
  select(label, options, onchange) {
    const select = h(
      "select",
      { onchange: () => onchange(select.value) },
      options.map(([value, text]) => h("option", { value }, text)),
    );
    return { select, element: h("label", { class: "choice" }, h("span", {}, label), select) };
  }

  /**
   * @param {string} title
   * @param {...HTMLElement} children
   */
  group(title, ...children) {
    // on a phone all of it would be a long way to scroll
    const open = title === "Start" || title === "Plane" || !matchMedia("(max-width: 760px)").matches;
    return h("details", { class: "group", open }, h("summary", {}, title), children);
  }

  hoop() {
    this.way = this.select(
      "Given by",
      [
        ["load_fraction", "load fraction γ"],
        ["eccentricity", "ε and κ"],
        ["parts", "real parts"],
      ],
      (way) => {
        const { values } = this.film;
        if (way === "parts") this.onchange([["hoop.parts", partsLike(values)]]);
        else this.onchange([[`hoop.${way}`, values["hoop.eccentricity"]]]);
      },
    );
    this.derived = h("p", { class: "derived" });
    return this.group(
      "Hoop",
      this.way.element,
      this.at("hoop.load_fraction"),
      this.at("hoop.eccentricity"),
      this.at("hoop.inertia_ratio"),
      this.parts.element,
      this.derived,
      this.at("hoop.radius"),
      this.at("hoop.mass"),
    );
  }

  plane() {
    this.apart = h("input", {
      type: "checkbox",
      onchange: () => {
        const { values } = this.film;
        if (this.apart.checked) {
          this.onchange([
            ["plane.mu_static", values["plane.mu_static"]],
            ["plane.mu_kinetic", values["plane.mu_kinetic"]],
          ]);
        } else this.onchange([["plane.mu", values["plane.mu_static"]]]);
      },
    });
    this.gravity = this.select(
      "Where",
      [...this.gravities.map(([name]) => /** @type {[string, string]} */ ([name, name])), ["", "elsewhere"]],
      (/** @type {string} */ name) => {
        const found = this.gravities.find(([known]) => known === name);
        if (found) this.onchange([["plane.gravity", found[1]]]);
      },
    );
    return this.group(
      "Plane",
      this.at("plane.mu"),
      this.at("plane.mu_static"),
      this.at("plane.mu_kinetic"),
      h("label", { class: "check" }, this.apart, "static and kinetic friction apart"),
      this.at("plane.slope"),
      this.gravity.element,
      this.at("plane.gravity"),
      this.at("plane.restitution"),
      this.at("plane.impact_law"),
      this.at("plane.painleve"),
    );
  }

  start() {
    this.kind = this.select(
      "Starts",
      [
        ["rolling", "rolling"],
        ["free", "in any state"],
      ],
      (/** @type {string} */ kind) => {
        const { values } = this.film;
        if (kind === "rolling") this.onchange([["start.speed", values["start.vx"]]]);
        else this.onchange([["start.omega", values["start.omega"]]]);
      },
    );
    return this.group(
      "Start",
      this.kind.element,
      this.at("start.speed"),
      this.at("start.angle"),
      this.at("start.height"),
      this.at("start.vx"),
      this.at("start.vy"),
      this.at("start.omega"),
      this.at("duration"),
    );
  }

  contact() {
    return this.group(
      "Contact",
      this.at("contact.model"),
      this.at("contact.law"),
      this.at("contact.friction"),
      this.at("contact.stiffness"),
      this.at("contact.slip_speed"),
      this.at("contact.restitution"),
    );
  }

  /** @param {Film} film */
  show(film) {
    this.film = film;
    const { scenario, values } = film;
    const way = scenario.hoop.parts ? "parts" : "load_fraction" in scenario.hoop ? "load_fraction" : "eccentricity";
    const rolling = "speed" in scenario.start;
    const apart = "mu_static" in scenario.plane;
    const compliant = scenario.contact.model === "compliant";
    this.way.select.value = way;
    this.kind.select.value = rolling ? "rolling" : "free";
    this.apart.checked = apart;
    const near = this.gravities.find(([, g]) => Math.abs(g - scenario.plane.gravity) < 1e-9);
    this.gravity.select.value = near ? near[0] : "";
    const visible = {
      "hoop.load_fraction": way === "load_fraction",
      "hoop.eccentricity": way === "eccentricity",
      "hoop.inertia_ratio": way === "eccentricity",
      "hoop.mass": way !== "parts",
      "plane.mu": !apart,
      "plane.mu_static": apart,
      "plane.mu_kinetic": apart,
      "plane.restitution": !compliant,
      "plane.impact_law": !compliant,
      "plane.painleve": !compliant,
      "start.speed": rolling,
      "start.height": !rolling,
      "start.vx": !rolling,
      "start.vy": !rolling,
      "start.omega": !rolling,
      "contact.law": compliant,
      "contact.friction": compliant,
      "contact.stiffness": compliant,
      "contact.slip_speed": compliant,
      "contact.restitution": compliant,
    };
    for (const [path, seen] of Object.entries(visible)) this.at(path).hidden = !seen;
    this.parts.element.hidden = way !== "parts";
    if (scenario.hoop.parts) this.parts.show(scenario.hoop.parts, values["hoop.radius"], values["hoop.mass"]);
    this.derived.textContent =
      way === "eccentricity"
        ? ""
        : `ε = ${show(values["hoop.eccentricity"], 5)}, κ = ${show(values["hoop.inertia_ratio"], 5)}` +
          (way === "parts" ? `, m = ${show(values["hoop.mass"], 5)} kg` : "");
    /** @type {Record<string, any>} */
    const sections = scenario;
    for (const [path, slider] of this.sliders) {
      const [section, key] = path.split(".");
      slider.show(values[path] ?? (key ? sections[section]?.[key] : sections[section]), film.automatic?.[path]);
    }
    for (const [path, { select }] of this.choices) {
      const [section, key] = path.split(".");
      if (sections[section]?.[key] !== undefined) select.value = sections[section][key];
    }
  }
}
