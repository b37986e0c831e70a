"""What pages make from the code: nothing of it is left out, and numbers are said as they are."""

import dataclasses
import inspect
import math
import re

import pytest

from checkout import text_of
from hophoop.results.records import EventErrors, EventRecord, Ledger, Sample, Velocity
from hophoop.scenario import paths
from hophoop.vocabulary import names
from hophoop.vocabulary.parameters import RANGES, Range
from page_tools import options

generated = pytest.importorskip("generated", reason="the extra 'docs' is not installed")

COMMANDS = ["run", "lab", "animate", "map", "track", "fit", "plan", "theory", "prove", "gait", "diagram", "reproduce"]


def test_every_command_has_every_option():
    text = generated.commands()
    sections = dict(re.findall(r"^## hophoop (\w+)\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL))
    assert list(sections) == COMMANDS
    shared = text.partition("## hophoop run")[0]
    for name, section in sections.items():
        said = section + (shared if "options that make a scenario" in section else "")
        for option in {option for option in options(name) if option.startswith("-")} - {"--help"}:
            assert re.search(rf"{re.escape(option)}\b", said), (name, option)


def test_the_scenario_file_has_every_key_with_what_it_may_be():
    text = generated.scenario_file()
    for path in paths():
        assert f"| `{path.rpartition('.')[2]}` |" in text, path
    assert "| `gravity` | Gravity | m/s² | 9.81 | 0 or 10⁻⁶ to 10⁶ |" in text
    assert '| `impact_law` | Law of restitution |  | `"stronge"` | `"stronge"`, `"newton"` or `"poisson"` |' in text
    for row in re.findall(r"^\| `.*\|$", text, re.MULTILINE):
        assert not row.endswith("|  |"), row  # every key says what it may be


@pytest.mark.parametrize(
    ("allowed", "said"),
    [
        (Range(1e-6, 1e6, (0.0,)), "0 or 10⁻⁶ to 10⁶"),
        (Range(0.0, 2.5e-7, (math.inf,)), '0 to 2.5·10⁻⁷ or `"inf"`'),
        (Range(-1e9, 1.57), "−10⁹ to 1.57"),
    ],
)
def test_a_range_in_words(allowed, said):
    assert generated.spoken(allowed) == said


def test_a_mark_that_nobody_makes_is_an_error():
    with pytest.raises(KeyError):
        generated.put_in(None, "page", ["% generated: nothing\n"])
    page = ["before\n% generated: quantities\nafter"]
    generated.put_in(None, "page", page)
    assert "`hop_height`" in page[0]
    assert "% generated" not in page[0]


def test_the_tables_of_events_and_ranges_are_complete():
    assert re.findall(r"^\| `(\w+)` \|", generated.events(), re.MULTILINE) == list(names.EVENTS)
    assert re.findall(r"^\| `(\w+)` \|", generated.statuses(), re.MULTILINE) == list(names.STATUSES)
    assert set(re.findall(r"`([\w.]+)`", generated.ranges())) == set(RANGES)


@pytest.mark.parametrize("record", [EventRecord, Velocity, Sample, Ledger, EventErrors])
def test_every_field_of_a_result_has_a_line_with_its_unit(record):
    lines = inspect.getdoc(record).splitlines()
    for field in dataclasses.fields(record):
        place = [k for k, line in enumerate(lines) if line.startswith(f"{field.name} : ")]
        assert len(place) == 1, field.name
        if re.search(r"float|ndarray, shape", lines[place[0]]):
            assert re.search(r"\[[^]]+\]", lines[place[0] + 1]), field.name


def test_the_tables_of_engines_are_those_of_the_kept_scores():
    page = [text_of("docs/engines.md")]
    generated.put_in(None, "engines", page)
    assert "| Drake 1.51.1 | 5/7 | −68 | −68 |" in page[0]
    assert "| Drake 1.51.1 | default, 1\u00a0ms | 5/7 | +2.5 | −68 |" in page[0]
