"""The page in other languages: one file each, with the same keys and places; what Python says stays Python's."""

import json
import re
from pathlib import Path

import pytest

from hophoop.kernel.physics.body import EVENT_NAMES
from hophoop.lab import tables
from hophoop.scenario import paths
from hophoop.vocabulary.names import EVENTS, WORDS

ROOT = Path(__file__).parents[2]
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
# keys that are put together: `story.${…}`
FAMILIES = {found for text in SOURCES.values() for found in re.findall(r"`([a-z_]+)\.\$\{", text)}


def forms(text):
    return text if isinstance(text, dict) else {"": text}


def test_there_are_languages():
    assert len(OTHERS) >= 4
    assert len(ENGLISH) > 600


@pytest.mark.parametrize("code", OTHERS)
def test_every_language_has_every_text(code):
    table = TABLES[code]
    assert list(table) == list(ENGLISH)
    for key, text in table.items():
        english = ENGLISH[key]
        assert isinstance(text, dict) == isinstance(english, dict), key
        for form in forms(text).values():
            assert form, key
            assert form.strip() == form or key.startswith("list."), key
            places = [sorted(PLACE.findall(one)) for one in (form, forms(english).get("other", english))]
            assert places[0] == places[1], key
        assert text != english or isinstance(text, dict) or ALIKE.match(english), key


def test_every_event_is_told_and_summed_up():
    assert {f"story.{kind}" for kind in EVENTS} - set(ENGLISH) == {"story.end"}
    by_word = {"start", "slip_start", "slip_reversal"}
    assert {f"summary.{kind}" for kind, facts in EVENTS.items() if facts.summed_up} - set(ENGLISH) == {
        f"summary.{kind}" for kind in by_word
    }


@pytest.mark.parametrize("code", TABLES)
def test_plurals_are_those_of_the_language(code):
    plurals = {key: text for key, text in TABLES[code].items() if isinstance(text, dict)}
    assert len(plurals) > 4
    for key, text in plurals.items():
        assert text.keys() == PLURALS.get(code, {"one", "other"}), key
        assert all("{count}" in form for form in text.values()), key


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


def known_to_python(part):
    return part in {*map(str, EVENT_NAMES), *WORDS} or part in {"start_flight", "start_skim"}


def built(key):
    """Whether a key is put together of parts that are there."""
    family, _, rest = key.partition(".")
    if family not in FAMILIES:
        return False
    parts = rest.split(".")
    said = all(part in LITERALS or known_to_python(part) or part in ("above", "always") for part in parts)
    return said or (family == "range" and re.fullmatch("(zero_or_)?from_to(_or_inf)?", rest) is not None)


def test_every_key_is_used():
    left = [key for key in ENGLISH if key not in LITERALS and key not in PYTHON and not built(key)]
    assert left == []


def test_every_key_that_is_used_is_there():
    heads = {key.split(".")[0] for key in ENGLISH} - {"map"}
    files = re.compile(r".*\.(js|css|json|toml|csv|nc|mp4|gif|wasm|png|svg|webm)")
    used = {text for text in LITERALS if re.fullmatch(r"[a-z_]+(\.[a-z0-9_]+)+", text) and not files.fullmatch(text)}
    used = {text for text in used if text.split(".")[0] in heads}
    assert used - ENGLISH.keys() - set(paths()) == set()
    assert len(used) > 400
