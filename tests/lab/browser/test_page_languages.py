"""The page in the visitor's language: chosen by the browser, switched by hand, and nothing left in English."""

import json
import re

import pytest

from checkout import text_of
from lab_page_tools import wait_for

# What stands on the page, and what is read to people.
TEXTS = """() => {
  const found = [document.title];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (node.nodeType === Node.TEXT_NODE) {
      if (!node.parentElement.closest("script, style, noscript, code, pre, .language")) found.push(node.nodeValue);
    } else {
      for (const name of ["aria-label", "title", "placeholder", "label", "aria-valuetext"]) {
        if (node.hasAttribute(name)) found.push(node.getAttribute(name));
      }
    }
  }
  return found;
}"""
# Opens all there is to see.
EVERYTHING = """async () => {
  const lab = hophoopLab;
  const { visit, challenges, table, more } = lab.extras;
  table.open(true);
  more.turn(true);
  const settled = async () => {
    do await new Promise((resolve) => setTimeout(resolve, 40));
    while (lab.surrounding || lab.requested || !more.changes);
  };
  await settled();
  const found = new Set();
  const read = () => { for (const text of (%s)()) found.add(text); };
  for (let step = 0; step < 8; step++) {
    await visit.go(step);
    document.querySelector(".guess-choice input")?.click();
    const key = new KeyboardEvent("keydown", { key: "ArrowUp", bubbles: true });
    document.querySelector(".dial, .sketch-point")?.dispatchEvent(key);
    if (step < 7) visit.show();
    read();
  }
  visit.leave();
  challenges.open();
  for (const tab of challenges.tabs.values()) { tab.click(); read(); }
  await lab.load("plane.slope=0.1");
  read();
  await lab.load("plane.nothing=1");
  read();
  await lab.load("plane.mu=-1");
  read();
  await lab.load("contact.model=compliant&plane.mu=0.7");
  read();
  for (const query of %s) { await lab.load(query); await new Promise((done) => setTimeout(done, 60)); read(); }
  await lab.load("");
  lab.motions.compare();
  lab.transport.jump(1, "takeoff");
  await settled();
  read();
  return [...found];
}"""


def test_a_language_that_cannot_be_loaded_leaves_the_page_as_it_is(visit):
    page = visit(own=True, locale="fi-FI", expected=["404"])  # which there is not
    loaded = page.evaluate("performance.getEntriesByType('resource').map((entry) => entry.name)")
    assert not [url for url in loaded if "words." in url]  # English comes with the script
    page.route("**/words.de.json*", lambda route: route.fulfill(status=404))
    page.get_by_label("Language").select_option("de")
    page.wait_for_selector(".message:not([hidden]), .toast:not([hidden])")
    assert "This language could not be loaded" in page.locator(".message").inner_text()
    assert page.get_by_label("Language").input_value() == "en"


def marked(text):
    return {form: f"⟦{one}⟧" for form, one in text.items()} if isinstance(text, dict) else f"⟦{text}⟧"


def outside(text):
    """What no table has said."""
    before = None
    while text != before:
        before, text = text, re.sub(r"⟦[^⟦⟧]*⟧", "", text)
    return text


@pytest.mark.long
def test_everything_that_is_said_is_in_the_tables(visit):
    """With each text between marks, whatever is not between them is English in the sources."""
    from hophoop.lab.tables import tables

    presets = {preset["key"]: preset["query"] for preset in tables()["setup"]["presets"]}
    queries = [presets[key] for key in ("littlewood", "jam", "indeterminate", "kane", "bounces", "standstill")]
    english = json.loads(text_of("src/hophoop/lab/words/en.json"))
    table = json.dumps({key: marked(text) for key, text in english.items()}, ensure_ascii=False)
    page = visit("?start.speed=2", own=True, locale="en-GB", reduced_motion="reduce")
    page.route("**/words.de.json*", lambda route: route.fulfill(body=table, content_type="application/json"))
    page.get_by_label("Language").select_option("de")
    wait_for(page, "document.documentElement.lang === 'de' && !lab.surrounding && lab.theory.list.children.length > 4")
    texts = page.evaluate(TEXTS) + page.evaluate(EVERYTHING % (TEXTS, json.dumps(queries)))
    assert len(texts) > 600
    # names of units, of the program, of parameters and of words of a scenario are the same everywhere
    names = re.compile(r"rad|cos|hophoop|MIT|Shift|Ctrl|Home|End|Esc|inf|[a-z]+(\.\w+)+|'\w+'|\b[0-9a-f]{16,}\b")
    left = {text for text in texts if re.search(r"[^\W\d_]{3}", names.sub("", outside(text)))}
    assert left == set()
