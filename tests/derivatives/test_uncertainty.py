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


def test_one_parameter_spreads_by_its_derivative(hop):
    of = ["takeoff.angle", "hop.height"]
    slopes = hop.sensitivity(of, "plane.mu").derivatives[:, 0]
    assert hop.uncertainty({"plane.mu": 0.02}).deviation(of) == pytest.approx(0.02 * abs(slopes), rel=1e-13)


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
    covariance = alone.covariance(["hop.height", "takeoff.angle"])
    both = hop.sensitivity(["hop.height", "takeoff.angle"], list(spread)).derivatives * [0.02, 0.01]
    assert covariance == pytest.approx(both @ both.T, rel=1e-12)


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


@pytest.mark.slow
def test_motions_drawn_at_random_have_that_spread(hop):
    random = np.random.default_rng(5)
    spread = {"plane.mu": 2e-3, "start.speed": 1e-3, "hoop.load_fraction": 2e-4}
    usual = {"plane.mu": 1.0, "start.speed": 3.1, "hoop.load_fraction": 0.75}
    heights = []
    for _ in range(400):
        drawn = {path: usual[path] + float(random.normal()) * spread[path] for path in spread}
        heights.append(hh.simulate(hop.scenario.with_values(drawn)).find("apex")[0].height)
    assert np.std(heights) == pytest.approx(hop.uncertainty(spread).deviation("hop.height")[0], rel=0.1)


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


def test_bands_lie_two_deviations_about_the_curve():
    motion = hh.simulate(hh.Scenario(duration=0.2))
    uncertainty = motion.uncertainty({"start.speed": 0.1})
    ax = Figure().subplots()
    plots.velocities(motion, ax=ax, uncertainty=uncertainty)
    band = ax.collections[0].get_paths()[0].vertices
    middle = 0.5 * (band[:, 1].max() + band[:, 1].min())
    begin = band[np.isclose(band[:, 0], 0.0)][:, 1]
    assert [begin.min(), begin.max()] == pytest.approx([2.9, 3.3], rel=1e-9)
    assert middle == pytest.approx(motion.at(0.1).vx, rel=0.1)
    with pytest.raises(ValueError, match="must be 'time'"):
        plots.gap(motion, against="angle", uncertainty=uncertainty)
