"""The lab's presets show what they say, and its code makes the same motion."""

import re

import numpy as np
import pytest

import hophoop as hh
from checkout import text_of
from hophoop.lab import presets
from hophoop.lab.tables import tables

PRESETS = {preset.key: preset for preset in presets.presets()}


def test_eight_come_first_and_the_article_is_among_them():
    first = [offered["query"] for offered in tables()["setup"]["presets"] if not offered["more"]]
    assert len(first) == 8
    assert {scenario.to_query() for scenario in hh.article.scenarios().values()} < set(first)


# what each shows
SHOWN = {
    "hop": "takeoff",
    "littlewood": "skim",
    "littlewood-fast": "skim",
    "inconsistent": "painleve_inconsistent",
    "indeterminate": "painleve_indeterminate",
    "jam": "jam",
    "kane": "kane_gain",
    "downhill": "takeoff",
    "bounces": "bounce_limit",
    "moon": "takeoff",
}


def test_presets_show_what_they_promise():
    for key, kind in SHOWN.items():
        assert hh.simulate(PRESETS[key].scenario).find(kind), key


def test_presets_say_true_numbers():
    gain = next(e.gain for e in hh.simulate(PRESETS["kane"].scenario).events if e.kind == "kane_gain")
    assert 1.5 < gain < 2.5  # 'creates two joules'
    stronge = PRESETS["kane"].scenario.replace("plane.impact_law", "stronge")
    assert not hh.simulate(stronge).find("kane_gain")
    earth, moon = (hh.simulate(PRESETS[key].scenario) for key in ("hop", "moon"))
    assert moon.find("takeoff")[0].t / earth.find("takeoff")[0].t == pytest.approx(2.46, abs=0.005)
    assert hh.simulate(PRESETS["jam"].scenario).status == "jammed"
    impact = PRESETS["indeterminate"].scenario.replace("plane.painleve", "impact")
    assert hh.simulate(impact).sequence != hh.simulate(PRESETS["indeterminate"].scenario).sequence


def test_the_hoop_at_2_8_never_has_a_last_slip():
    """Each slip of the article's motion is weaker, and none is the last: the preset must not promise rolling."""
    slip = PRESETS["slip"]
    assert "none is the last" in slip.text
    motion = hh.simulate(slip.scenario.replace("duration", 60.0))
    begun = [event.t for event in motion.find("slip_start")]
    assert begun[-1] > 58.0
    first, last = (abs(motion.at(np.linspace(t, t + 0.2, 60)).slip).max() for t in (begun[0], begun[-3]))
    assert 0.0 < last < 0.5 * first


def test_presets_end_as_they_say():
    """How a gait turns and hops is compared on the page."""
    for key, fate in {"hops-for-ever": "gait", "gear": "gait", "chaos": "chaotic", "standstill": "rocks"}.items():
        scenario = PRESETS[key].scenario
        assert hh.passages(scenario, 1000).fate == fate, key
        assert hh.simulate(scenario).find("takeoff"), key  # within what is shown


def test_the_worksheet_has_its_hoop():
    """The same as on paper, and as the lessons of the lab show it."""
    preset = PRESETS["worksheet"]
    sheet = text_of("docs/teach/worksheet.md")
    link = re.search(r"play/index\.html\?([^\"]+)", sheet)[1].replace("&amp;", "&")
    assert hh.Scenario.from_query(link) == preset.scenario
    lessons = text_of("web/lab/teach/teach.ts")
    assert hh.Scenario.from_query(re.search(r'HOOP = "([^"]+)"', lessons)[1] + "1.5&start.speed=1") == preset.scenario
    assert "*Examples* has the hoop of this sheet" in sheet
