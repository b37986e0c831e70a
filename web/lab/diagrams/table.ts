// The motion as a table: chosen columns at equal steps of time, to be read, copied and saved.

import { h, saveBlob, say, selection } from "../common/dom.ts";
import { show } from "../common/numbers.ts";
import { QUANTITIES } from "./quantities.ts";
import { bring } from "../shell/page.ts";
import { current, local, t } from "../words/words.ts";
import type { Motions } from "../player/motions.ts";
import type { Theme } from "../shell/theme.ts";

const FIRST = ["time", "angle", "x", "vx", "rotation", "normal_force", "friction_force"];
const STEPS = [1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];
const MOST = 601; // rows
const DIGITS = 9; // in a file

/** The rows of the table: at equal steps, with the state at each time. `step`: in seconds. */
function rowsOf(film: Film, columns: string[], step: number) {
  const count = Math.min(Math.floor(film.duration / step + 1e-9) + 1, MOST);
  const rows = [];
  for (let k = 0; k < count; k++) {
    const time = Number((k * step).toPrecision(12));
    rows.push({ time, mode: film.at(time).mode, values: columns.map((key) => valueAt(film, key, time)) });
  }
  return rows;
}

/** A quantity at a time. */
function valueAt(film: Film, key: string, time: number) {
  return QUANTITIES[key].values(film.moment(time))[0];
}

export class Table {
  film: Film;
  rows: { time: number; row: HTMLElement }[] = [];
  now: HTMLElement | undefined;

  columns = [...FIRST];

  step = selection(
    STEPS,
    (step) => `${step} s`,
    () => this.fill(),
  );
  picks = h(
    "div.table-picks",
    Object.entries(QUANTITIES)
      .filter(([key]) => key !== "time")
      .map(([key, { name }]) => this.pick(key, name)),
  );
  plain = h("input", { type: "checkbox" });
  choice = h("label.check", this.plain, "table.plain");
  caption = h("caption");
  head = h("thead");
  body = h("tbody");
  element = h(
    "section.table",
    { "aria-label": "table.title", hidden: true },
    h(
      "header",
      h("h2", "table.table"),
      h("label.table-step", h("span", "table.step"), this.step),
      h("button", { onclick: () => this.save() }, "table.save"),
      this.choice,
      h("button", { onclick: () => this.open(false) }, "table.close"),
    ),
    h("details.table-columns", h("summary", "table.columns"), this.picks),
    h(
      "div.table-scroll",
      { tabindex: "0", role: "region", "aria-label": "table.label" },
      h("table", this.caption, this.head, this.body),
    ),
  );

  constructor(
    readonly clock: Clock,
    readonly motions: Motions,
    readonly theme: Theme,
  ) {
    this.step.value = "0.1";
  }

  pick(key: string, name: string) {
    const box = h("input", {
      type: "checkbox",
      checked: this.columns.includes(key),
      onchange: () => {
        const wanted = new Set(this.columns);
        if (box.checked) wanted.add(key);
        else wanted.delete(key);
        this.columns = Object.keys(QUANTITIES).filter((one) => wanted.has(one));
        this.fill();
      },
    });
    return h("label", box, h("span", name));
  }

  open(open: boolean) {
    this.element.hidden = !open;
    if (!open) return;
    this.draw(this.motions.film());
    this.step.focus({ preventScroll: true });
    bring(this.element);
  }

  draw(film: Film) {
    if (this.element.hidden) return;
    this.film = film;
    this.fill();
  }

  fill() {
    const { film, columns } = this;
    const step = Number(this.step.value);
    const names = this.theme.colors.mode_names;
    const units = columns.map((key) => QUANTITIES[key]);
    this.head.replaceChildren(
      h(
        "tr",
        units.map(({ name, symbol, unit }) =>
          h("th", { scope: "col", title: name }, symbol, unit && h("small", ` ${unit}`)),
        ),
        h("th", { scope: "col" }, "table.mode"),
      ),
    );
    const rows = rowsOf(film, columns, step);
    this.rows = rows.map(({ time, mode, values }) => ({
      time,
      row: h(
        "tr",
        { onclick: () => this.clock.seek(time) },
        values.map((value, i) => (i === 0 ? h("th", { scope: "row" }, show(value, 4)) : h("td", show(value, 4)))),
        h("td.table-mode", names[mode]),
      ),
    }));
    this.body.replaceChildren(...this.rows.map(({ row }) => row));
    const whole = film.duration / step + 1 <= MOST + 1e-6;
    const more = { key: "table.shortened", values: { count: MOST } };
    this.choice.hidden = current() === "en"; // whose spreadsheets read the plain file
    say(this.caption, whole ? film.summary : [film.summary, " ", more]);
    this.cursor(this.clock.time);
  }

  cursor(time: number) {
    if (this.element.hidden || !this.rows.length) return;
    const step = Number(this.step.value);
    const now: HTMLElement | undefined = this.rows[Math.min(Math.round(time / step), this.rows.length - 1)]?.row;
    if (now === this.now) return;
    this.now?.classList.remove("now");
    now?.classList.add("now");
    this.now = now;
  }

  /** The file that a spreadsheet in the visitor's language reads, or the plain one. */
  save() {
    const { film, columns } = this;
    const own = current() !== "en" && !this.plain.checked;
    const written = (value: number) => {
      const text = String(Number(value.toPrecision(DIGITS)));
      return own ? local(text) : text;
    };
    const separator = own && local("0.1") === "0,1" ? ";" : ",";
    const head = [
      ...columns.map((key) => `${t(QUANTITIES[key].name)} [${QUANTITIES[key].unit || "1"}]`),
      t("table.mode"),
    ];
    const rows = rowsOf(film, columns, Number(this.step.value)).map(({ mode, values }) => [
      ...values.map(written),
      mode,
    ]);
    const lines = [head, ...rows].map((row) => `${row.join(separator)}\r\n`);
    // without its mark a spreadsheet takes the text for another encoding
    saveBlob(new Blob([own ? "\ufeff" : "", ...lines], { type: "text/csv" }), "hophoop-table.csv");
  }
}
