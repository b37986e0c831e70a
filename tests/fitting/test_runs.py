"""Several runs of one hoop on one plane."""

from dataclasses import replace

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import TRUTH, filmed, hopping, read_again
from hophoop.fitting import report

SHARED = ("gamma", "mu_kinetic", "mu_excess", "restitution")
SPEEDS = (1.9, 1.0, 2.1)  # the second never slips


def runs(*hoops):
    """A film of each hoop, one after the other at each speed."""
    motions = [hopping(hoop, start=hh.Start.rolling(speed, angle=0.1)) for hoop, speed in zip(hoops, SPEEDS, strict=False)]
    return [replace(filmed(one, seed, rate=60.0), source=f"{'abc'[seed]}.csv") for seed, one in enumerate(motions)]


@pytest.fixture(scope="module")
def together():
    return hh.fit(runs(None, None, None), start="rolling")


def test_several_runs_share_the_hoop_and_each_has_its_own_start(together):
    assert together.good
    for k, speed in enumerate(SPEEDS, 1):
        assert abs(together.values[f"speed_{k}"] - speed) < 4 * together.error(f"speed_{k}")
    for name in SHARED:
        assert abs(together.values[name] - TRUTH[name]) < 4 * together.error(name), name
        best = min(one.error(name) for one in together.alone if name in one.free)
        assert together.error(name) < 1.05 * best
    assert together.error("gamma") < 0.9 * min(one.error("gamma") for one in together.alone)
    assert together.degrees_of_freedom == sum(one.problem.count for one in together.alone) - len(together.free)
    assert any(sentence.startswith("The runs agree in gamma") for sentence in together.sentences())
    head, *rows = together.comparison()
    assert head == ["parameter", "together", "run 1: a.csv", "run 2: b.csv", "run 3: c.csv", "agree"]
    table = {row[0]: row[1:] for row in rows}
    assert table["gamma"][-1] == "yes"
    assert table["restitution"][2] == "not determined"  # without an impact
    assert np.isnan(together.agreement("rolling_resistance"))


@pytest.mark.long
def test_a_run_of_another_hoop_is_named_and_options_are_of_one_run_or_of_all():
    two = runs(None, hh.Hoop.ideal(0.61, radius=0.3))
    found = hh.fit(two, fixed={"slope": 0.0, "x0_2": 0.0, "restitution": 0.3}, bounds={"speed_1": (1.0, 2.5)})
    assert any("The runs do not agree in gamma" in sentence for sentence in found.sentences())
    assert found.agreement("gamma") < 1e-6
    assert found.values["x0_2"] == 0.0
    assert "x0_1" in found.free
    assert "x0_2" not in found.free
    assert found.values["restitution"] == 0.3
    with pytest.raises(ValueError, match="'x0_3' is no parameter of this fit; it has gamma"):
        hh.fit(two, fixed={"x0_3": 0.0})
    with pytest.raises(ValueError, match="There is no record"):
        hh.fit([])


def test_runs_are_saved_and_reported(together, tmp_path):
    text = report(together, tmp_path).read_text(encoding="utf-8")
    assert "x (mm), run 3" in text
    assert "<th>run 2: b.csv</th>" in text
    assert len(read_again(together, tmp_path).alone) == 3
