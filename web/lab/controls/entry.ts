// A field for a number: what may be typed, and what is said where it is none or not allowed.

import { h, say } from "../common/dom.ts";
import { NUMBER } from "../../model/text.ts";
import { show, withUnit } from "../common/numbers.ts";
import { local } from "../words/words.ts";

/** A digit of any script as one of ours: each script has its ten in a row. */
function digit(letter: string) {
  const code = letter.codePointAt(0) as number;
  let value = 0;
  while (value < 9 && /\p{Nd}/u.test(String.fromCodePoint(code - value - 1))) value += 1;
  return String(value);
}

/**
 * A number as people type it: digits of any script, a decimal comma or point, a real minus sign, powers of ten, ∞. NaN
 * where it is none. `unit`: which may stand behind it.
 */
export function readNumber(text: string, unit = "") {
  let plain = text.trim();
  if (unit && plain.endsWith(unit)) plain = plain.slice(0, -unit.length);
  plain = plain
    .replace(/[！-～]|\p{Nd}/gu, (letter) => letter.normalize("NFKC"))
    .replace(/\p{Nd}/gu, digit)
    .replace(/[\s\p{Cf}]/gu, "") // marks of direction, too
    .replace(/[−–]/g, "-")
    .replace(/[,。٫]/g, ".")
    .replace(/[·×*x]10\^?([-⁻]?)([\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/, (_, sign, power) => `e${sign && "-"}${power.normalize("NFKD")}`);
  const endless = /^([+-]?)(inf|infinity|∞)$/i.exec(plain);
  if (endless) return endless[1] === "-" ? -Infinity : Infinity;
  return NUMBER.test(plain) ? Number(plain) : Number.NaN;
}

/**
 * What is wrong with an entry, in the unit of its field; empty where nothing is. `text`: as it was typed; `value`: in
 * the field's unit; `field`: its range in the field's unit.
 */
export function refusal(
  text: string,
  value: number,
  { label, unit, range }: { label: string; unit: string; range?: NumberRange },
): Message {
  const typed = text.trim();
  if (Number.isNaN(value)) {
    return { key: "controls.value_not_a_number", values: { name: label, value: typed } };
  }
  if (!Number.isFinite(value) && /\p{Nd}/u.test(typed)) {
    return { key: "controls.value_too_large", values: { label, value: typed } };
  }
  if (!range || (value >= range.least && value <= range.most) || range.also.includes(value)) return "";
  const [zero, endless] = [range.also.includes(0), range.also.includes(Infinity)];
  const span = `range.${zero ? "zero_or_" : ""}from_to${endless ? "_or_inf" : ""}`;
  const rule = { key: span, values: { least: show(range.least, 4), most: withUnit(show(range.most, 4), unit) } };
  const values = { name: label, value: withUnit(show(value, 6), unit), rule };
  return { key: "controls.value_out_of_range", values };
}

interface FieldInfo {
  label: string;
  unit: string;
  range?: NumberRange; // in the field's unit
  name?: Message; // for a screen reader, where no label belongs to it
}

let count = 0;

// The text that is typed stays until it is a number that is taken, or until Escape brings back what was there.
export class Entry {
  shown = "";
  typing = false;
  error = h("p.error", { role: "alert", id: `hh-error-${++count}`, hidden: true });
  input = h("input.exact", {
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": this.info.name,
    oninput: () => {
      this.typing = true;
      this.accept();
    },
    onchange: () => this.typed(),
    onblur: () => this.typing && this.typed(),
    onkeydown: (event: KeyboardEvent) => {
      if (event.key !== "Escape" || !(this.typing || this.refused())) return;
      event.stopPropagation();
      this.restore();
    },
  });

  constructor(
    readonly info: FieldInfo,
    readonly onvalue: (value: number) => void,
  ) {}

  refused() {
    return this.input.ariaInvalid === "true";
  }

  typed() {
    const text = this.input.value;
    if (!this.typing) return;
    this.typing = false;
    if (text.trim() === "") {
      this.restore();
      return;
    }
    const value = readNumber(text, this.info.unit);
    const wrong = refusal(text, value, this.info);
    if (wrong) this.refuse(wrong);
    else this.onvalue(value);
  }

  refuse(sentence: Message) {
    this.input.ariaInvalid = "true";
    this.input.setAttribute("aria-describedby", this.error.id);
    say(this.error, sentence);
    this.error.hidden = false;
  }

  accept() {
    this.input.ariaInvalid = null;
    this.input.removeAttribute("aria-describedby");
    this.error.hidden = true;
  }

  restore() {
    this.typing = false;
    this.input.value = this.shown;
    this.accept();
  }

  /** `text`: the present value. What a hand is typing stays, and what was refused while the value is the same. */
  show(text: string) {
    const before = this.shown;
    this.shown = local(text);
    if (!this.typing && !(this.refused() && this.shown === before)) this.restore();
  }
}
