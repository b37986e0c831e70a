"""Derivatives with rolling resistance: what is known of them beside test_events.py, which goes through all events."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.layout import REASONS, Reason
from hophoop.derivatives.results.propagation import propagate
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from oracles.derivatives import RESISTANCE, one_sided, scenario_of

pytestmark = pytest.mark.usefixtures("interpreted")


SMALL = 2.0**-26
ROCKS = hh.Scenario(hoop=hh.Hoop.ideal(0.5), start=hh.Start.rolling(0.3, angle=2.0), duration=2.0)
HELD = hh.Scenario(
    plane=hh.Plane(slope=0.1, mu=0.5, rolling_resistance=0.1), start=hh.Start.rolling(0.0, angle=3.0), duration=2.0
)  # fmt: skip


@pytest.mark.parametrize(
    ("scenario", "path", "side", "of"),
    [
        (ROCKS, RESISTANCE, 1.0, ["turn.t", "turn.x", "end.omega", "end.x"]),  # that there is some at all
        # a push along its way, and against it
        pytest.param(HELD, "start.speed", 1.0, ["rest.t", "rest.angle", "end.x"], marks=pytest.mark.long),
        pytest.param(HELD, "start.speed", -1.0, ["rest.t", "rest.angle", "end.x"], marks=pytest.mark.long),
    ],
)
def test_derivatives_to_one_side(scenario, path, side, of):
    result = hh.sensitivity(scenario, of, path)
    found = (result.larger if side > 0 else result.smaller)[:, 0]
    assert found == pytest.approx(one_sided(scenario, path, side * SMALL, of), rel=1e-9, abs=1e-9)
    if path == RESISTANCE:
        assert result.reasons == ((EDGE,),) * len(of)
        assert np.isnan(result.smaller).all()
    else:
        assert SIDED in {reason for row in result.reasons for reason in row}


def test_the_hop_loses_height_at_the_rate_of_small_resistances():
    """The derivative at f = 0 is the limit of those at f > 0, and of the loss of height itself."""
    scenario = hh.Scenario(duration=1.8)
    of = ["takeoff.angle", "hop.height", "energy_lost", "at(1.3).x", "at(1.3).rolling_resistance"]
    none = hh.sensitivity(scenario, of, RESISTANCE).larger[:, 0]
    little = hh.sensitivity(scenario.with_values({RESISTANCE: 1e-7}), of, RESISTANCE)
    assert little.reasons == (("",),) * 5
    assert little.derivatives[:, 0] == pytest.approx(none, rel=2e-4)
    assert none[1] == pytest.approx((0.2706 - 0.2919) / 0.001, rel=0.02)


def test_rolling_loses_nothing_else():
    """With the couple alone, what the energy loses is f R ∫ N abs(dθ), which its derivative is taken of apart."""
    plane = hh.Plane(mu=math.inf, rolling_resistance=0.05)
    motion = hh.simulate(hh.Scenario(plane=plane, start=hh.Start.rolling(1.5), duration=1.2))
    assert motion.sequence == "R"
    paths = ["start.speed", "start.angle", "hoop.load_fraction", RESISTANCE, "plane.gravity"]
    rates = propagate(motion, paths).at_times(np.array([0.2, 0.5, 0.9, 1.2]), ["friction", "rolling_resistance", "total"])
    assert np.abs(rates["friction"][1]).max() < 1e-10
    assert np.abs(rates["rolling_resistance"][1][:, 3]).min() > 1.0
    assert (rates["rolling_resistance"][0] == motion.at([0.2, 0.5, 0.9, 1.2]).rolling_resistance).all()


def test_a_mirrored_motion_has_mirrored_derivatives():
    scenario = hh.Scenario(
        plane=hh.Plane(slope=0.05, mu=0.7, rolling_resistance=0.01), start=hh.Start.rolling(2.9, angle=0.4), duration=1.6
    )  # fmt: skip
    turned = {"start.speed": -2.9, "start.angle": -0.4, "plane.slope": -0.05}
    of = ["stick.t", "end.x", "end.angle", "end.rolling_resistance"]
    paths = [*turned, "plane.mu", RESISTANCE]
    one = hh.sensitivity(scenario, of, paths).derivatives
    other = hh.sensitivity(scenario.with_values(turned), of, paths).derivatives
    signs = np.outer([1, -1, -1, 1], [-1, -1, -1, 1, 1])
    assert other == pytest.approx(signs * one, rel=1e-11)
    assert np.abs(one).min() > 1e-3


def test_the_edge_of_rest():
    """Where the couple is just enough to hold the hoop, or just not, the least change decides which."""
    angle = math.pi - math.asin(0.05 / 0.75)
    plane = hh.Plane(rolling_resistance=0.05)
    result = hh.sensitivity(
        hh.Scenario(plane=plane, start=hh.Start.rolling(0.0, angle=angle), duration=1.0),
        "end.angle",
        ["start.angle", RESISTANCE],
    )
    assert set(result.reasons[0]) == {REASONS[Reason.BORDER]}
    inside = hh.Scenario(plane=plane, start=hh.Start.rolling(0.0, angle=angle + 1e-3), duration=1.0)
    assert hh.simulate(inside).status == "at_rest"
    result = hh.sensitivity(inside, "end.angle", ["start.angle", RESISTANCE, "hoop.load_fraction", "start.speed"])
    assert result.derivatives[0].tolist() == [1.0, 0.0, 0.0, 0.0]  # a small push is stopped at once


def test_spread_goes_along():
    motion = hh.simulate(scenario_of("resisted_hop").with_values({"duration": 1.2}))
    uncertainty = motion.uncertainty({RESISTANCE: 0.001, "plane.mu": 0.02})
    of = ["takeoff.angle", "at(1.1).x"]
    slopes = motion.sensitivity(of, [RESISTANCE, "plane.mu"]).derivatives
    assert uncertainty.deviation(of) == pytest.approx(np.hypot(*(slopes * [0.001, 0.02]).T), rel=1e-12)
    assert uncertainty.at(1.1).x[0] == pytest.approx(uncertainty.deviation(of)[1], rel=1e-12)
    assert uncertainty.at(1.1).rolling_resistance[0] > 0.0
