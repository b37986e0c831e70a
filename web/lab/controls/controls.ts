// Sliders with exact entry, and choices; what they show comes back from the server with each motion.

import { h, selection } from "../common/dom.ts";
import { number, tables } from "../../model/tables.ts";
import { Entry } from "./entry.ts";
import { clamp } from "../common/clamp.ts";
import { show, sizeOf, withUnit } from "../common/numbers.ts";
import { Parts, partsLike } from "./parts.ts";
import { t } from "../words/words.ts";
import type { Motions } from "../player/motions.ts";

const CONTACT = ["model", "law", "friction", "stiffness", "slip_speed", "restitution"];
const ADVANCED = ["plane.painleve", "plane.impact_law", ...CONTACT.map((name) => `contact.${name}`)];

/** The range that Python allows, in the unit of the field. */
function rangeOf({ path, unit }: SliderInfo): NumberRange {
  const { least, most, also = [] } = tables.map.allowed[path];
  const size = sizeOf(unit);
  return { least: least / size, most: most / size, also: also.map(number) };
}

class Slider {
  held = false;
  label = `parameter.${this.info.path}`;
  logarithmic = !this.info.step;
  id = `hh-${this.info.path}-${Math.random().toString(36).slice(2, 7)}`;
  range = h("input.slider", {
    type: "range",
    id: this.id,
    min: String(this.place(this.info.least)),
    max: String(this.place(this.info.most)),
    step: String(this.info.step || 0.01),
    "data-path": this.info.path,
    oninput: () => this.slid(false),
    onchange: () => this.slid(true),
    onpointerdown: this.hold(true),
    onpointerup: this.hold(false),
    onpointercancel: this.hold(false),
    onblur: this.hold(false),
  });
  entry = new Entry(
    {
      label: this.label,
      unit: this.info.unit,
      name: {
        key: this.info.unit ? "controls.exact_value_unit" : "controls.exact_value",
        values: { name: this.label, unit: this.info.unit },
      },
      range: rangeOf(this.info),
    },
    (value) => this.send(value, true),
  );
  element = h(
    "div.control",
    { title: `help.${this.info.path}` },
    h("label", { for: this.id }, h("span", this.label), h("span.symbol", this.info.symbol)),
    h("span.entry", this.entry.input, h("span.unit", this.info.unit)),
    this.range,
    this.entry.error,
  );

  constructor(
    readonly info: SliderInfo,
    public onchange: (changes: Change[], commit: boolean) => void,
  ) {}

  hold(held: boolean) {
    return () => {
      this.held = held;
    };
  }

  /** Where a value is on the slider. */
  place(value: number) {
    return this.logarithmic ? Math.log10(value) : value;
  }

  slid(commit: boolean) {
    const place = Number(this.range.value);
    const value = this.logarithmic ? Number((10 ** place).toPrecision(3)) : place;
    this.entry.typing = false;
    this.entry.accept();
    this.entry.show(String(value));
    this.say(value);
    this.send(value, commit);
  }

  send(value: number, commit: boolean) {
    const number = value * sizeOf(this.info.unit);
    this.onchange([[this.info.path, Number.isFinite(number) ? number : "inf"]], commit);
  }

  say(value: number) {
    this.range.ariaValueText = withUnit(show(value, 4), this.info.unit);
  }

  /** `value`: "inf" for no limit; `automatic`: what is chosen where there is no value. */
  show(value: number | string | null | undefined, automatic: number | null = null) {
    if (this.held) return; // what the hand says comes back with its own answer
    // what the lab chooses by itself stands behind an empty field
    const own = value !== null && value !== undefined;
    const found = own ? value : automatic;
    if (found === null || found === undefined) {
      this.entry.show("");
      return;
    }
    const shown = found === "inf" ? Infinity : Number(found) / sizeOf(this.info.unit);
    this.entry.show(!own ? "" : Number.isFinite(shown) ? String(Number(shown.toPrecision(9))) : "∞");
    this.entry.input.placeholder = own ? "" : t("controls.auto_value", { value: show(shown, 2) });
    this.entry.input.title = own ? withUnit(String(shown), this.info.unit) : "";
    const place = this.place(clamp(shown, this.info.least, this.info.most));
    if (Math.abs(Number(this.range.value) - place) > 1e-6) this.range.value = String(place);
    this.say(shown);
  }
}

function choice({ path, options }: ChoiceInfo, onchange: (changes: Change[], commit: boolean) => void) {
  const select = selection(
    options,
    (value) => `choice.${path}.${value}`,
    (value) => onchange([[path, value]], true),
    { "data-path": path },
  );
  const element = h("label.choice", { title: `help.${path}` }, h("span", `parameter.${path}`), select);
  return { element, select };
}

export class Controls {
  film: Film;
  broken: Entry | null = null; // a rule between fields, by the value of this one

  onchange = (changes: Change[], commit = true) => this.motions.change(changes, commit);
  sliders = new Map(
    Object.values(this.setup.groups)
      .flat()
      .map((info) => [info.path, new Slider(info, this.onchange)]),
  );
  choices = new Map(this.setup.choices.map((info) => [info.path, choice(info, this.onchange)]));
  parts = new Parts(this.onchange);
  gravities = this.setup.gravities as [string, number][];
  way = this.select(
    "controls.hoop_definition",
    {
      load_fraction: "controls.by_load_fraction",
      eccentricity: "controls.by_eccentricity",
      parts: "controls.by_parts",
    },
    (way) => {
      const { values } = this.film;
      if (way === "parts") this.onchange([["hoop.parts", partsLike(values)]]);
      else this.onchange([[`hoop.${way}`, values["hoop.eccentricity"]]]);
    },
  );
  derived = h("p.derived");
  apart = h("input", {
    type: "checkbox",
    onchange: () => {
      const { values } = this.film;
      const names = this.apart.checked ? ["mu_static", "mu_kinetic"] : ["mu"];
      this.onchange(names.map((name) => [`plane.${name}`, values[`plane.${name}`] ?? values["plane.mu_static"]]));
    },
  });
  gravity = this.select(
    "controls.gravity_place",
    { ...Object.fromEntries(this.gravities.map(([name]) => [name, name])), "": "controls.gravity_other" },
    (name) => {
      const found = this.gravities.find(([known]) => known === name);
      if (found) this.onchange([["plane.gravity", found[1]]]);
    },
  );
  kind = this.select(
    "controls.start_kind",
    { rolling: "controls.start_rolling", free: "controls.start_free" },
    (kind) => {
      const { values } = this.film;
      if (kind === "rolling") this.onchange([["start.speed", values["start.vx"]]]);
      else this.onchange([["start.omega", values["start.omega"]]]);
    },
  );
  start = this.group("controls.start", this.kind.element, ...this.of("start"), this.at("duration"));
  element = h(
    "div.controls",
    this.group(
      "controls.hoop",
      this.way.element,
      ...this.of("hoop", { "hoop.radius": [this.parts.element, this.derived] }),
    ),
    this.group(
      "controls.plane",
      ...this.of("plane", {
        "plane.slope": [h("label.check", this.apart, "controls.two_frictions")],
        "plane.gravity": [this.gravity.element],
      }),
    ),
    this.start,
    // what few visitors ask for; closed at first
    this.group("controls.advanced", ...ADVANCED.map((path) => this.at(path)), this.fingerprint),
  );

  /** `fingerprint`: of the motion, shown with what few visitors ask for. */
  constructor(
    readonly motions: Motions,
    readonly setup: ControlsInfo,
    readonly fingerprint: HTMLElement,
  ) {}

  at(path: string) {
    const found = this.sliders.get(path) ?? this.choices.get(path);
    if (!found) throw new Error(`There is no control of ${path}.`);
    return found.element;
  }

  /**
   * The controls of a section in the order of Python's table: sliders, then choices. `before`: what comes before some
   * of them.
   */
  of(section: string, before: Named<HTMLElement[]> = {}) {
    return [...this.sliders.keys(), ...this.choices.keys()]
      .filter((path) => path.startsWith(`${section}.`) && !ADVANCED.includes(path))
      .flatMap((path) => [...(before[path] ?? []), this.at(path)]);
  }

  select(label: string, options: Named<string>, onchange: (value: string) => void) {
    const select = selection(Object.keys(options), (value) => options[value], onchange);
    return { select, element: h("label.choice", h("span", label), select) };
  }

  group(title: string, ...children: HTMLElement[]) {
    // on a phone all of it would be a long way to scroll
    const wide = !matchMedia("(max-width: 47.5em)").matches;
    const open = title === "controls.start" || title === "controls.plane" || (wide && title === "controls.hoop");
    return h("details.group", { open }, h("summary", title), children);
  }

  /** A change that was refused is said at its field, if it is one that is seen. */
  refuse(changes: Change[], sentence: Message) {
    const slider = changes.length === 1 ? this.sliders.get(changes[0][0]) : undefined;
    if (!slider?.element.checkVisibility()) return false;
    slider.entry.refuse(sentence);
    this.broken = slider.entry;
    return true;
  }

  /** Take back what was said of values that were refused: they belong to another motion. */
  accept() {
    for (const { entry } of this.sliders.values()) entry.accept();
    for (const entry of this.parts.entries.values()) entry.accept();
  }

  /**
   * Bring back what is so where a choice was refused; what was typed stays beside its sentence.
   */
  restore() {
    if (this.film) this.showChoices(this.film, new Set());
  }

  /** `waiting`: paths that have a newer value already, which must not be written over. */
  show(film: Film, waiting = new Set<string>()) {
    if (film !== this.film) {
      this.broken?.accept();
      this.broken = null;
    }
    this.film = film;
    this.showChoices(film, waiting);
    for (const [path, slider] of this.sliders) {
      if (!waiting.has(path)) slider.show(film.value(path), film.automatic[path]);
    }
  }

  showChoices(film: Film, waiting: Set<string>) {
    const { scenario, values } = film;
    const way = scenario.hoop.parts ? "parts" : "load_fraction" in scenario.hoop ? "load_fraction" : "eccentricity";
    const rolling = "speed" in scenario.start;
    const apart = "mu_static" in scenario.plane;
    const compliant = scenario.contact.model === "compliant";
    const newer = (...paths: string[]) => paths.some((path) => waiting.has(path));
    if (!newer("hoop.load_fraction", "hoop.eccentricity", "hoop.parts")) this.way.select.value = way;
    if (!newer("start.speed", "start.omega")) this.kind.select.value = rolling ? "rolling" : "free";
    if (!newer("plane.mu", "plane.mu_static")) this.apart.checked = apart;
    const near = this.gravities.find(([, g]) => Math.abs(g - scenario.plane.gravity) < 1e-9);
    if (!newer("plane.gravity")) this.gravity.select.value = near ? near[0] : "";
    const visible: [boolean, string, ...string[]][] = [
      [way === "load_fraction", "hoop", "load_fraction"],
      [way === "eccentricity", "hoop", "eccentricity", "inertia_ratio"],
      [way !== "parts", "hoop", "mass"],
      [!apart, "plane", "mu"],
      [apart, "plane", "mu_static", "mu_kinetic"],
      [!compliant, "plane", "restitution", "impact_law", "painleve"],
      [rolling, "start", "speed"],
      [!rolling, "start", "height", "vx", "vy", "omega"],
      [compliant, "contact", "law", "friction", "stiffness", "slip_speed", "restitution"],
    ];
    for (const [seen, section, ...names] of visible) {
      for (const name of names) this.at(`${section}.${name}`).hidden = !seen;
    }
    this.parts.element.hidden = way !== "parts";
    if (scenario.hoop.parts) this.parts.show(scenario.hoop.parts, values["hoop.radius"], values["hoop.mass"]);
    this.derived.textContent =
      way === "eccentricity"
        ? ""
        : `ε = ${show(values["hoop.eccentricity"], 5)}, κ = ${show(values["hoop.inertia_ratio"], 5)}` +
          (way === "parts" ? `, m = ${show(values["hoop.mass"], 5)} kg` : "");
    for (const [path, { select }] of this.choices)
      if (!waiting.has(path)) select.value = film.value(path) ?? select.value;
  }
}
