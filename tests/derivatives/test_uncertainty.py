"""Spread of parameters, carried to events, times and figures."""

import math

import numpy as np
import pytest
from matplotlib.figure import Figure

import hophoop as hh
from hophoop import plots
from hophoop.kernel.native import forced

pytestmark = pytest.mark.usefixtures("interpreted")


@pytest.fixture(scope="module")
def hop():
    with forced("interpreted"):
        return hh.simulate(hh.Scenario(duration=2.0))


def test_variances_add_and_correlations_count_twice(hop):
    spread = {"plane.mu": 0.02, "start.speed": 0.01}
    alone = hop.uncertainty(spread)
    one, other = (alone.shares("hop.height")[path] for path in spread)
    assert alone.deviation("hop.height")[0] == pytest.approx(math.hypot(one, other), rel=1e-13)
    slopes = hop.sensitivity("hop.height", list(spread)).derivatives[0]
    assert slopes[0] * slopes[1] < 0.0
    for value in (-1.0, 0.3, 1.0):
        together = hop.uncertainty(spread, {("start.speed", "plane.mu"): value}).deviation("hop.height")[0]
        assert together == pytest.approx(math.sqrt(one**2 + other**2 - 2 * value * one * other), rel=1e-12)
    of = ["hop.height", "takeoff.angle"]
    both = hop.sensitivity(of, list(spread)).derivatives * [0.02, 0.01]
    assert alone.covariance(of) == pytest.approx(both @ both.T, rel=1e-12)
    assert alone.deviation(of) == pytest.approx(np.hypot(*both.T), rel=1e-12)


def test_the_state_at_a_time(hop):
    at = hop.uncertainty({"plane.mu": 0.02, "start.speed": 0.01}).at([0.1, 0.7, 1.3, 1.9])
    for i, t in enumerate(at.t):
        names = [f"at({float(t)}).{name}" for name in ("x", "angle", "vx", "omega", "slip", "height", "friction", "total")]
        direct = hop.uncertainty({"plane.mu": 0.02, "start.speed": 0.01}).deviation(names)
        assert [getattr(at, name.split(".")[-1])[i] for name in names] == pytest.approx(direct, rel=1e-12)


def test_the_two_sides_of_an_impact(hop):
    impact = hop.find("impact")[0]
    uncertainty = hop.uncertainty({"start.speed": 0.01})
    left, right = (uncertainty.at(impact.t, side) for side in ("left", "right"))
    assert left.slip[0] > 1e-3
    assert right.slip[0] == 0.0  # it rolls
    assert right.height[0] == 0.0


@pytest.mark.parametrize(
    ("spread", "correlations", "sentence"),
    [
        ({}, None, "at least one"),
        ({"plane.mu": -0.1}, None, "not negative"),
        ({"plane.mu": math.inf}, None, "finite"),
        ({"plane.colour": 0.1}, None, "not a parameter"),
        ({"plane.mu": 0.1}, {("plane.mu", "start.speed"): 0.1}, "must be two of"),
        ({"plane.mu": 0.1, "start.speed": 0.1}, {("plane.mu", "start.speed"): 1.5}, "from -1 to 1"),
        (
            {"plane.mu": 0.1, "start.speed": 0.1, "start.x": 1.0},
            {("plane.mu", "start.speed"): 1.0, ("plane.mu", "start.x"): 1.0, ("start.speed", "start.x"): -1.0},
            "negative eigenvalue",
        ),
    ],
)
def test_what_is_refused(hop, spread, correlations, sentence):
    with pytest.raises(ValueError, match=sentence):
        hop.uncertainty(spread, correlations)


def test_sides_and_times_are_checked(hop):
    uncertainty = hop.uncertainty({"plane.mu": 0.02})
    with pytest.raises(ValueError, match="side"):
        uncertainty.at(0.1, "middle")
    with pytest.raises(ValueError, match="the motion's end"):
        uncertainty.at(5.0)


@pytest.mark.long
def test_bands_lie_two_deviations_about_the_curve(hop):
    ax = Figure().subplots()
    plots.velocities(hop, ax=ax, uncertainty=hop.uncertainty({"start.speed": 0.1}))
    band = ax.collections[0].get_paths()[0].vertices
    begin = band[np.isclose(band[:, 0], 0.0)][:, 1]
    assert [begin.min(), begin.max()] == pytest.approx([2.9, 3.3], rel=1e-9)
    with pytest.raises(ValueError, match="must be 'time'"):
        plots.gap(hop, against="angle", uncertainty=hop.uncertainty({"start.speed": 0.1}))
