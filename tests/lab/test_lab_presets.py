"""The lab's presets show what they say, and its code makes the same motion."""

import math

import numpy as np
import pytest
from hophoop.lab.python_code import python_code
from hypothesis import given, settings

import hophoop as hh
from hophoop.lab.api import calls, limits
from hophoop.lab.site import presets
from strategies import scenarios

PRESETS = {preset.key: preset for preset in presets.presets()}


def kinds(key):
    return {event.kind for event in calls.computed(PRESETS[key].scenario).events}


def test_the_article_is_there():
    offered = [preset.scenario for preset in presets.presets() if preset.group == presets.ARTICLE]
    assert sorted(map(hh.Scenario.to_query, offered)) == sorted(map(hh.Scenario.to_query, hh.article.scenarios().values()))


@pytest.mark.parametrize(
    ("key", "kind"),
    [
        ("hop", "takeoff"),
        ("littlewood", "skim"),
        ("littlewood-fast", "skim"),
        ("inconsistent", "painleve_inconsistent"),
        ("indeterminate", "painleve_indeterminate"),
        ("jam", "jam"),
        ("kane", "kane_gain"),
        ("downhill", "takeoff"),
        ("bounces", "bounce_limit"),
        ("moon", "takeoff"),
    ],
)
def test_presets_show_what_they_promise(key, kind):
    assert kind in kinds(key)


def test_presets_say_true_numbers():
    gain = next(e.gain for e in calls.computed(PRESETS["kane"].scenario).events if e.kind == "kane_gain")
    assert 1.5 < gain < 2.5  # 'creates two joules'
    stronge = PRESETS["kane"].scenario.replace("plane.impact_law", "stronge")
    assert not calls.computed(stronge).find("kane_gain")
    earth, moon = (calls.computed(PRESETS[key].scenario) for key in ("hop", "moon"))
    assert moon.find("takeoff")[0].t / earth.find("takeoff")[0].t == pytest.approx(2.46, abs=0.005)
    assert calls.computed(PRESETS["jam"].scenario).status == "jammed"
    impact = PRESETS["indeterminate"].scenario.replace("plane.painleve", "impact")
    assert calls.computed(impact).sequence != calls.computed(PRESETS["indeterminate"].scenario).sequence


def test_presets_open_from_their_links():
    setup = calls.answer(calls.read("setup", {}), limits.USUAL).header
    for preset, offered in zip(presets.presets(), setup["presets"], strict=True):
        assert hh.Scenario.from_query(offered["query"]) == preset.scenario


# Code that makes the same motion


def ran(scenario):
    """What the code says, without the time it takes to compute it."""
    names = {"scenario": made}
    exec(python_code(scenario).partition("print")[0].replace("hh.simulate(", "scenario("), names)
    return names["motion"]


def made(hoop, plane, start, duration, contact=None):
    return hh.Scenario(hoop=hoop, plane=plane, start=start, duration=duration, contact=contact or hh.Rigid())


@pytest.mark.parametrize("key", PRESETS)
def test_python_makes_the_preset(key):
    assert ran(PRESETS[key].scenario) == PRESETS[key].scenario


@given(scenarios())
@settings(max_examples=60)
def test_python_makes_any_scenario(scenario):
    assert ran(scenario) == scenario


def test_python_makes_parts_friction_and_compliance():
    scenario = hh.Scenario(
        hoop=hh.Hoop.from_parts(0.3, [hh.Ring(0.4, 0.28, 0.3), hh.Disk(0.5, 0.02, at=0.27)]),
        plane=hh.Plane(mu_static=0.7, mu_kinetic=0.5, slope=0.05),
        start=hh.Start(height=0.1, vx=0.25),
        contact=hh.Compliant(stiffness=1e4),
        duration=0.1,
    )
    assert ran(scenario) == scenario
    assert 'float("inf")' in python_code(hh.Scenario(plane=hh.Plane(mu=math.inf)))


def test_python_names_what_one_will_want_to_change():
    assert "hh.Hoop(load_fraction=0.75)" in python_code(hh.Scenario())
    assert "hh.Plane(mu=1.0)" in python_code(hh.Scenario())


def test_the_hoop_at_2_8_never_has_a_last_slip():
    """Each slip of the article's motion is weaker, and none is the last: the preset must not promise rolling."""
    slip = PRESETS["slip"]
    assert "none is the last" in slip.text
    motion = hh.simulate(slip.scenario.replace("duration", 60.0))
    begun = [event.t for event in motion.find("slip_start")]
    assert begun[-1] > 58.0
    first, last = (abs(motion.at(np.linspace(t, t + 0.2, 60)).slip).max() for t in (begun[0], begun[-3]))
    assert 0.0 < last < 0.5 * first
