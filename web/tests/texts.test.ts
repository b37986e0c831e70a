// Texts by key and values: places, plurals, lists, capitals and decimal commas of a language.

import assert from "node:assert/strict";
import { test } from "node:test";
import { english, listed, Refused, messageOf, speak, spoken, t, wordsFrom } from "../words/texts.ts";

const GERMAN: Words = {
  "map.count": { one: "{count} Bewegung", other: "{count} Bewegungen" },
  "summary.whole": "{Phrases}.",
  "summary.takeoff": "hüpft bei {where}",
  "verb.roll": "rollt",
  "list.comma": ", ",
};

async function inGerman(check: () => void) {
  wordsFrom(async () => GERMAN);
  await speak("de");
  try {
    check();
  } finally {
    await speak("en");
  }
}

test("a key is said, and what is none stays as it is", () => {
  assert.equal(t("verb.roll"), "rolls");
  assert.equal(t("plane.mu"), "plane.mu");
  assert.equal(t("constructor"), "constructor");
  assert.equal(t("3.5 m"), "3.5 m");
});

test("a count chooses the plural of the language", async () => {
  const motions = (count: number) => spoken({ key: "map.count", values: { count } });
  assert.deepEqual([motions(1), motions(384)], ["1 motion", "384 motions"]);
  await inGerman(() => assert.deepEqual([motions(1), motions(384)], ["1 Bewegung", "384 Bewegungen"]));
});

test("phrases are listed, begin with a capital, and have the language's decimals", async () => {
  const phrases = listed(["verb.roll", { key: "summary.takeoff", values: { where: "315.6°" } }]);
  const said = () => spoken({ key: "summary.whole", values: { phrases } });
  assert.equal(said(), "Rolls, hops at 315.6°.");
  await inGerman(() => assert.equal(said(), "Rollt, hüpft bei 315,6°."));
});

test("what a language lacks is said in English, and English is at hand in every language", async () => {
  await inGerman(() => {
    assert.equal(t("verb.skid"), "skids");
    assert.equal(english({ key: "summary.takeoff", values: { where: "315.6°" } }), "hops at 315.6°");
    const refused = new Refused({ key: "map.count", values: { count: 2 } });
    assert.deepEqual([refused.message, spoken(messageOf(refused))], ["2 motions", "2 Bewegungen"]);
  });
});
