"""Random scenarios each have a fate, which a much longer motion does not contradict; benchmarks/fates.py runs thousands."""

import runpy
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.vocabulary.fates import Fate

SCAN = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "fates.py"))
SEED = 7


@pytest.mark.parametrize("index", range(60))
def test_a_random_fate(index):
    scenario = SCAN["scenario_of"](SEED, index)
    judged = hh.gaits.fates([scenario])
    fate = str(judged.fates[0])
    assert fate in set(Fate)
    if fate in ("rocks", "rests", "gait", "rolls ahead", "rolls back"):
        assert SCAN["problem_of"](scenario, fate, int(judged.periods[0]), int(judged.passages[0])) is None


@pytest.mark.parametrize(
    ("index", "fate"),
    [(2, "gait"), (3, "runs away"), (35, "rests"), (340, "slips ever less")],
)
def test_bounces_at_landings_are_not_taken_for_a_fate(index, fate):
    """Bounces that die away are all alike, but do not rock; a revolution in flight that ends in rolling did not roll."""
    scenario = SCAN["scenario_of"](35, index)
    for section in ("bottom", "landing"):
        assert hh.gaits.fates([scenario], section=section).fates == (fate,)


@pytest.mark.parametrize("index", range(100, 160))
def test_sections_agree(index):
    """Where both sections decide what becomes of a motion, they decide the same."""
    scenario = SCAN["scenario_of"](SEED, index)
    bottom, landing = (str(hh.gaits.fates([scenario], 500, section=section).fates[0]) for section in ("bottom", "landing"))
    assert bottom == landing or "undecided" in (bottom, landing)


def test_a_wrong_fate_is_found():
    """A hoop that rolls ahead for ever neither rocks nor rests, and has no gait of one passage that ends."""
    scenario = hh.Scenario(plane=hh.Plane(gravity=1.0), start=hh.Start.rolling(0.3))
    assert hh.gaits.fates([scenario]).fates == ("rolls ahead",)
    for fate in ("rocks", "rests", "rolls back"):
        assert SCAN["problem_of"](scenario, fate, 0, 2) is not None
