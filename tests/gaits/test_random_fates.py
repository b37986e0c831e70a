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


def test_a_wrong_fate_is_found():
    """A hoop that rolls ahead for ever neither rocks nor rests, and has no gait of one passage that ends."""
    scenario = hh.Scenario(plane=hh.Plane(gravity=1.0), start=hh.Start.rolling(0.3))
    assert hh.gaits.fates([scenario]).fates == ("rolls ahead",)
    for fate in ("rocks", "rests", "rolls back"):
        assert SCAN["problem_of"](scenario, fate, 0, 2) is not None
