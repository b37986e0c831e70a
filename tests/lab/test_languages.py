"""The page in other languages: one file each, with the same keys and places; what Python says stays Python's."""

import json
import re

import pytest

from checkout import ROOT
from hophoop.lab import tables
from hophoop.scenario import paths
from hophoop.vocabulary.names import EVENTS

WEB = ROOT / "web"
TABLES = {
    path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted((ROOT / "src/hophoop/lab/words").glob("*.json"))
}
ENGLISH = TABLES["en"]
OTHERS = [code for code in TABLES if code != "en"]
PYTHON = tables.english()
PLACE = re.compile(r"\{(\w+)\}")
# the plurals of a language; further ones, of millions, are said as the others
PLURALS = {"zh": {"other"}}
# what is written alike in English and in some other language
ALIKE = re.compile(r"\S*( \S*){0,2}$|[{}\w\s.=():]*$")

SOURCES = {
    path: path.read_text(encoding="utf-8")
    for folder in ("kernel", "lab", "model", "pages", "site", "words")
    for path in sorted((WEB / folder).rglob("*"))
    if path.suffix in (".ts", ".html")
}
# the second form is within a template
LITERALS = {
    found for text in SOURCES.values() for form in (r'"([^"\n]*)"', r'\bt\("([^"]+)"') for found in re.findall(form, text)
}


def forms(text):
    return text if isinstance(text, dict) else {"": text}


@pytest.mark.parametrize("code", TABLES)
def test_every_language_has_every_text_with_its_plurals(code):
    table = TABLES[code]
    assert list(table) == list(ENGLISH)
    for key, text in table.items():
        english = ENGLISH[key]
        assert isinstance(text, dict) == isinstance(english, dict), key
        if isinstance(text, dict):
            assert text.keys() == PLURALS.get(code, {"one", "other"}), key
            assert all("{count}" in form for form in text.values()), key
        for form in forms(text).values():
            assert form, key
            assert form.strip() == form or key.startswith("list."), key
            places = [sorted(PLACE.findall(one)) for one in (form, forms(english).get("other", english))]
            assert places[0] == places[1], key
        assert code == "en" or text != english or isinstance(text, dict) or ALIKE.match(english), key


@pytest.mark.parametrize("code", TABLES)
def test_labels_to_which_a_text_sends_are_on_the_page(code):
    """Those of a closed group, or of another view, come with what opens it."""
    table = TABLES[code]
    opening = [table["controls.advanced"], table["shell.everything"]]
    for key, text in table.items():
        quoted = re.findall(r"[‘„«“]\s?([^‘’„“«»”]+?)\s?[’“»”]", text) if isinstance(text, str) else []
        if quoted and not key.startswith("teach."):
            assert quoted == opening, key


def test_every_event_is_told_and_summed_up():
    assert {f"story.{kind}" for kind in EVENTS} - set(ENGLISH) == {"story.end"}
    by_word = {"start", "slip_start", "slip_reversal"}
    assert {f"summary.{kind}" for kind, facts in EVENTS.items() if facts.summed_up} - set(ENGLISH) == {
        f"summary.{kind}" for kind in by_word
    }


@pytest.mark.parametrize("code", OTHERS)
def test_signs_are_those_of_the_language(code):
    """French spaces before ; : ! ?, full-width signs in Chinese, decimal commas."""
    said = [form for key, text in TABLES[code].items() for form in forms(text).values()]
    if code == "fr":
        assert [text for text in said if re.search(r"[^\W_][!?;:](?!\w)", text)] == []
    if code == "zh":
        assert [text for text in said if re.search(r"[\u4e00-\u9fff][,;:?!]", text)] == []
    else:
        assert [text for text in said if re.search(r"\d\.\d", text)] == []


def test_the_words_of_python_are_those_of_python():
    """`python -m hophoop.lab.tables` writes them into words/en.json."""
    assert {key: ENGLISH.get(key) for key in PYTHON} == PYTHON
    assert tables.ENGLISH.read_text(encoding="utf-8") == tables.words()


def test_no_key_is_a_path_of_a_scenario():
    """Such a path, in a sentence, would be taken for the key."""
    assert not ENGLISH.keys() & {*paths(), *(path.split(".")[0] for path in paths())}
    assert all(re.fullmatch(r"[a-z_]+(\.[\w-]+)+", key) for key in ENGLISH)


def test_every_key_that_is_used_is_there():
    heads = {key.split(".")[0] for key in ENGLISH} - {"map"}
    files = re.compile(r".*\.(js|css|json|toml|csv|nc|mp4|gif|wasm|png|svg|webm)")
    elements = {name for text in SOURCES.values() for name in re.findall(r'\bh\(\s*"([^"]+)"', text)}
    used = {text for text in LITERALS - elements if re.fullmatch(r"[a-z_]+(\.[a-z0-9_]+)+", text) and not files.fullmatch(text)}
    used = {text for text in used if text.split(".")[0] in heads}
    assert used - ENGLISH.keys() - set(paths()) == set()
    assert len(used) > 400
