"""The page in other languages: one file each, complete, and all that Python writes for the page is recognised."""

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

import hophoop as hh
import random_scenarios
from hophoop.derivatives.layout import REASONS
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from hophoop.lab.api import motion_map
from hophoop.lab.site import export
from hophoop.lab.site.controls import controls
from hophoop.lab.site.presets import presets
from hophoop.vocabulary.classes import CODES, class_text
from hophoop.vocabulary.events import EVENTS
from hophoop.vocabulary.modes import LETTERS, MODE_WORDS
from hophoop.vocabulary.sentences import LAB, THEORY
from hophoop.vocabulary.statuses import STATUSES
from model.test_page_model import answers
from web_tools import needs_node

WEB = Path(__file__).parents[2] / "web"
LANGUAGES = sorted(path.stem for path in (WEB / "words").glob("*.json"))
TABLES = {code: json.loads((WEB / "words" / f"{code}.json").read_text(encoding="utf-8")) for code in LANGUAGES}
ENGLISH = TABLES["de"].keys()
PLACE = re.compile(r"\{(\w+)\}")
# what is written alike in English and in some other language
ALIKE = re.compile(r"\{stars\} \{points\} points|\{name\} \[\{unit\}\]$|θ mod 360°$|z y  Ctrl Z$|\S*( \S+){0,2}$")


# units, and names of the scenario's keys and of its words, are the same everywhere
NAMES = r"(\d\S* )?(rad(/s)?|kg|m/s²?)|'?[\w.\[\]]+\.\w+'?|'\w*'|([\w.]+, )+[\w.]+"


def pattern(key):
    return re.compile("(.+?)".join(map(re.escape, PLACE.split(key)[::2])) + r"\Z", re.DOTALL)


SENTENCES = sorted((key for key in ENGLISH if "{" in key), key=lambda key: -len(PLACE.sub("", key)))
PATTERNS = {key: pattern(key) for key in SENTENCES}


def known(text):
    """As web/lab/words/words.ts recognises a text: whole, by its form with known words in its places, or as a row of phases."""
    text = text.strip()
    if text in ENGLISH or not re.search(r"[^\W\d_⁰¹²³⁴-⁹]{3}", text) or re.fullmatch(NAMES, text):
        return True
    for key in SENTENCES:
        found = PATTERNS[key].match(text)
        if found:
            # words of the scenario's own stay as they are
            return all(
                name.startswith("word") or known(place) for name, place in zip(PLACE.findall(key), found.groups(), strict=True)
            )
    return " → " in text and all(known(part) for part in text.split(" → "))


def told(summary):
    """As web/lab/words/words.ts takes a summary apart."""
    first, _, rest = re.fullmatch(r"(.*?)\.(?:( )(.*))?", summary, re.DOTALL).groups()
    phrases = re.split(r", (?!\d)", first[:1].lower() + first[1:])
    return [phrase for phrase in phrases if not known(phrase)] + ([rest] if rest and not known(rest) else [])


@pytest.mark.parametrize("code", LANGUAGES)
def test_every_language_has_every_text(code):
    table = TABLES[code]
    assert table.keys() == ENGLISH
    for key, text in table.items():
        assert text.strip() == text != "", key
        assert sorted(PLACE.findall(text)) == sorted(PLACE.findall(key)), key
        assert text != key or ALIKE.match(key), key
    # French spaces before ; : ! ?, full-width signs in Chinese, decimal commas
    if code == "fr":
        assert not [text for text in table.values() if re.search(r"\w[!?;:](?!\w)", text)]
    if code == "zh":
        assert not [text for text in table.values() if re.search(r"[\u4e00-\u9fff][,;:?!]", text)]
    else:
        assert not [text for text in table.values() if re.search(r"\d\.\d", text)]


class Texts(HTMLParser):
    """The texts of a page, and what is read to people."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_starttag(self, tag, attrs):
        self.found += [value for name, value in attrs if name == "aria-label"]

    def handle_data(self, data):
        self.found.append(" ".join(data.split()))


def texts(name):
    page = Texts()
    page.feed((Path(export.__file__).parents[1] / "static" / name).read_text(encoding="utf-8"))
    return [text for text in page.found if text]


TAGS = texts("embed.html")


def test_the_page_that_makes_tags_is_there():
    assert len(TAGS) > 15
    assert [text for text in TAGS if not known(text)] == []


def test_no_text_is_left_over():
    """Each key stands in a source, or is what Python writes."""
    scripts = [*sorted((WEB / "lab").rglob("*.ts")), WEB / "kernel" / "kernel.ts", WEB / "site" / "embed.ts"]
    sources = "".join(path.read_text(encoding="utf-8") for path in scripts) + "|".join(TAGS)
    sources = re.sub(r'"\s*\+\s*["`]', "", sources)
    sources += "|".join(re.findall(r't\("([^"]+)"', sources))  # also within templates
    sources = re.sub(r"\$\{(?:[^{}]|\{[^{}]*\})*\}", "{}", sources)
    sources += json.dumps(controls(), ensure_ascii=False) + json.dumps(
        list(motion_map.MAP_QUANTITIES.values()), ensure_ascii=False
    )
    sources += "".join(f"{p.group}|{p.title}|{p.text}|" for p in presets()) + "|".join(
        facts.sentence for facts in STATUSES.values()
    )
    sources += "|".join(event.label for event in EVENTS.values())
    lab = Path(export.__file__).parents[1]
    vocabulary = lab.parent / "vocabulary"
    rooms = [*lab.rglob("*.py"), *vocabulary.glob("*.py"), *(lab.parent / "scenario").glob("*.py")]
    sources += "|".join([*REASONS.values(), EDGE, SIDED])
    for path in [*rooms, lab.parent / "maps" / "grid" / "evaluate.py"]:
        text = path.read_text(encoding="utf-8")
        text = re.sub(r'"\s*\n\s*f?"', "", text)
        sources += re.sub(r"\{[^{}]*\}", "{}", text)
    left = [key for key in ENGLISH if PLACE.sub("{}", key) not in PLACE.sub("{}", sources)]
    # put together from words that are there
    verbs = "rolls|spins|skids|flies|skims|hops|lands|bounces|slips|stops|turns|has|meets|jams|gains|rests|starts"
    begins = "It |would |μ = |from |0 or |at |{|and |Click to |click to |over |Hoop |can end|with the load|greater"
    begins += "|'{|The lab is busy"
    built = re.compile(rf"({verbs})\b.* at {{angle}}$|{begins}|.*\(\w\)$")
    assert [key for key in left if not built.match(key) and not any(key in vals for vals in map(str, CODES.values()))] == []


def test_what_python_puts_on_the_page_is_there():
    shown = [info[name] for group in controls()["groups"].values() for info in group for name in ("label", "help")]
    shown += [text for choice in controls()["choices"] for text in (choice["label"], choice["help"])]
    shown += [label for choice in controls()["choices"] for _, label in choice["options"]]
    shown += [name for name, _ in controls()["gravities"]] + [axis["label"] for axis in controls()["map_axes"]]
    shown += [label for label, _ in motion_map.MAP_QUANTITIES.values()]
    shown += [text for preset in presets() for text in (preset.group, preset.title, preset.text)]
    shown += [
        *MODE_WORDS,
        *filter(None, (facts.sentence for facts in STATUSES.values())),
        *filter(str.isalpha, LETTERS.values()),
    ]
    shown += [event.label for event in EVENTS.values()]
    shown += [class_text(letter) for letter in "RSKHM"]
    shown += [class_text(word, what) for what in motion_map.MAP_QUANTITIES if what in CODES for word in CODES[what]]
    assert [text for text in shown if not known(text)] == []


def untold(found):
    """What no language knows of the stories, summaries and thresholds that the page makes for scenarios."""
    films = answers("film", [{"scenario": scenario.to_dict()} for scenario in found])
    theory = answers("theory", [{"scenario": scenario.to_dict()} for scenario in found])
    left = []
    for film, rows in zip(films, theory, strict=True):
        header = film["value"]["header"]
        left += told(header["summary"]) + [said["text"] for said in header["story"] if not known(said["text"])]
        left += [text for row in rows["value"] for text in (row["label"], row["text"]) if not known(text)]
    return left


@needs_node
def test_every_motion_is_told_in_known_sentences():
    found = [preset.scenario for preset in presets()]
    found += [random_scenarios.scenario_of(random_scenarios.draw(9, index)[1], 300) for index in range(40)]
    assert untold([scenario.replace("duration", min(scenario.duration, 6.0)) for scenario in found]) == []


def test_refusals_are_known():
    refused = """hoop.mass=-1 hoop.mass=1e99 plane.mu=-3 plane.restitution=2 hoop.load_fraction=1.5 plane.gravity=-2
        plane.slope=2 start.angle=x duration=0 hoop.radius=0 plane.impact_law=foo foo=1 plane.foo=1 start.height=-1
        start.speed=1e10 start.speed=inf plane.mu_static=0.3&plane.mu_kinetic=0.5 hoop.load_fraction=1&plane.slope=0.1
        start.speed=1&start.omega=2 hoop.load_fraction=1&contact.model=compliant contact.max_events=0"""
    for query in refused.split():
        with pytest.raises(ValueError) as found:
            hh.Scenario.from_query(query)
        assert known(str(found.value)), found.value


def test_every_sentence_of_theory_and_of_the_lab_is_known():
    whole = [text for key, text in THEORY.items() if not key.startswith("would") and "{would}" not in text]
    never = {"not_a_pair", "too_many_changes", "window", "times", "number_path", "one_of"}  # which the page itself never causes
    refused = [text for key, text in LAB.items() if key not in never]
    assert [text for text in [*whole, *refused] if not known(re.sub(r"\{[^{}]*\}", "7", text))] == []


def test_every_reason_why_there_is_no_derivative_is_known():
    assert [text for text in [*REASONS.values(), EDGE, SIDED] if not known(text)] == []


def test_an_unknown_sentence_is_noticed():
    assert not known("It flies at 3° and sings.")
    assert not known("roll → sing")
    assert told("Rolls, sings at 3.0°.") == ["sings at 3.0°"]
