// Numbers as a reader wants them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { length, niceStep, show, ticks, tickText } from "../lab/common/numbers.ts";
import { readNumber, refusal } from "../lab/controls/entry.ts";
import { spoken } from "../words/texts.ts";

const slope = { label: "parameter.plane.slope", unit: "°", range: { least: -90, most: 90, also: [] } };
const friction = { label: "parameter.plane.mu", unit: "", range: { least: 0, most: 1e6, also: [Infinity] } };

test("numbers have four digits, no zeros at their end and a real minus sign", () => {
  const shown: [number, string][] = [
    [0, "0"],
    [3.10004, "3.1"],
    [-2, "−2"],
    [123456, "123456"],
    [1.5e6, "1.5·10⁶"],
    [-3e-5, "−3·10⁻⁵"],
    [Infinity, "∞"],
    [Number.NaN, "–"],
  ];
  for (const [value, text] of shown) assert.equal(show(value), text);
});

test("a length has the unit in which it reads well", () => {
  assert.deepEqual([1, 0.5, 0.002].map(length), ["1 m", "50 cm", "2 mm"]);
});

test("steps of an axis are round, and labels have the decimals they need", () => {
  assert.deepEqual(
    [0.9, 7, 13].map((span) => niceStep(span, 5)),
    [0.2, 2, 5],
  );
  assert.deepEqual(ticks(1, 2, 0.5), [1, 1.5, 2]);
  assert.deepEqual(ticks(1, 1, 0.5), []);
  assert.deepEqual([tickText(0.4, 0.02), tickText(-1e-20, 1), tickText(-3, 1)], ["0.40", "0", "−3"]);
});

test("what is typed is read as it is meant", () => {
  const meant: [string, number][] = [
    ["3.1", 3.1],
    ["3,1", 3.1],
    ["−2", -2],
    ["1e-3", 1e-3],
    ["∞", Infinity],
    ["-inf", -Infinity],
    ["3·10⁻⁵", 3e-5],
    ["1 000", 1000],
    ["3.1 m/s", 3.1],
    ["－３，１ｅ－２", -0.031],
    ["3。1", 3.1],
    ["２×１０^６", 2e6],
    ["\u061c-۰۱۲۳٫۴۵۶۷۸۹", -123.456789],
    ["𝟙𝟎", 10],
  ];
  for (const [text, value] of meant) assert.equal(readNumber(text, "m/s"), value, text);
  for (const text of ["1,234.5", "1.2.3", "abc", "", "--1", "1e", "0x10", "3²", "３．１．２"])
    assert.ok(Number.isNaN(readNumber(text, "m/s")), text);
});

test("a refusal names the field in its own unit", () => {
  const said = (text: string) => spoken(refusal(text, readNumber(text, "°"), slope));
  assert.equal(said("100"), "Slope = 100° must be from −90 to 90°.");
  assert.equal(said("x"), "Slope = x must be a number, such as 2.5.");
  assert.equal(said("12"), "");
  assert.equal(spoken(refusal("-1", -1, friction)), "Friction = −1 must be from 0 to 1·10⁶, or inf.");
  assert.equal(refusal("inf", Infinity, friction), "");
  // a number that doubles cannot hold is none of the numbers without end that are meant
  assert.equal(spoken(refusal("-5e400", readNumber("-5e400"), friction)), "Friction = -5e400 is too large.");
  assert.equal(refusal("∞", readNumber("∞"), friction), "");
});
