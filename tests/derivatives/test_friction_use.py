"""The derivative of the greatest share of friction that a motion uses, against differences of what maps find."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.results.sensitivity import SIDED

USE = "greatest_utilization"


pytestmark = pytest.mark.usefixtures("interpreted")


def use_of(scenario, path, value):
    """As a cell of a map has it."""
    return float(hh.maps.points(scenario, {path: [value]}, [USE], "duration")[USE][0])


def test_two_places_that_need_the_same():
    """On the level each way of a swing needs the same friction; tilted, one of them more: then that one counts."""
    scenario = hh.Scenario.from_query("duration=5&hoop.load_fraction=0.3&start.angle=2&start.speed=0.3")
    result = hh.sensitivity(scenario, USE, "plane.slope")
    assert result.reasons == ((SIDED,),)
    here = use_of(scenario, "plane.slope", 0.0)
    for found, side in ((result.larger, 1.0), (result.smaller, -1.0)):
        step = side * 1e-4
        values = [here, *(use_of(scenario, "plane.slope", n * step) for n in (1, 2, 3, 4))]
        assert found[0, 0] == pytest.approx(np.dot([-25 / 12, 4, -3, 4 / 3, -1 / 4], values) / step, rel=1e-8)
    assert result.smaller[0, 0] < 0.0 < result.larger[0, 0]


def test_slip_uses_all_friction_and_goes_on_doing_so():
    result = hh.sensitivity(hh.Scenario(duration=0.6), USE, ["start.speed", "plane.mu"])
    assert result.values.tolist() == [1.0]
    assert result.derivatives.tolist() == [[0.0, 0.0]]


@pytest.mark.parametrize("start", [hh.Start.rolling(1.0), hh.Start(angle=1.0)])
def test_a_massless_hoop_needs_the_tangent_of_half_the_angle(start):
    """Its force points at the load, up to where it vanishes and the rim skims; afterwards the load lies on the plane."""
    motion = hh.simulate(hh.Scenario(hoop=hh.Hoop.ideal(1.0), start=start, duration=3.0))
    assert motion.sequence == "RMR"
    found = motion.sensitivity([USE, "skim.angle"], ["start.angle", "plane.mu", "plane.gravity"])
    half, angle = math.tan(0.5 * motion.events[1].angle), found.derivatives[1]
    assert found.values[0] == pytest.approx(half, rel=1e-13)
    assert use_of(motion.scenario, "plane.mu", 1.0) == pytest.approx(half, rel=1e-13)
    assert found.derivatives[0] == pytest.approx(0.5 * (1 + half**2) * angle - [0.0, half, 0.0], rel=1e-12)


def test_where_there_is_none():
    flying = hh.Scenario(start=hh.Start(height=0.5), duration=0.1)
    result = hh.sensitivity(flying, USE, "start.angle")
    assert np.isnan([result.values[0], result.derivatives[0, 0]]).all()
    endless = hh.Scenario.from_query("duration=0.3&plane.mu=inf&start.speed=1")
    result = hh.sensitivity(endless, USE, "start.angle")
    assert (result.values[0], result.derivatives[0, 0]) == (0.0, 0.0)


def test_at_rest_it_is_the_slope_over_the_friction():
    """Whatever holds the hoop: F = −m g sin β and N = m g cos β."""
    slope, mu = -0.05, 0.5
    plane = hh.Plane(slope=slope, mu=mu, rolling_resistance=0.4)
    motion = hh.simulate(hh.Hoop(), plane, hh.Start.rolling(0.0, angle=0.3), duration=0.3)
    assert motion.status == "at_rest"
    result = motion.sensitivity(USE, ["plane.slope", "plane.mu", "start.angle", "plane.rolling_resistance"])
    assert result.derivatives[0] == pytest.approx([-1 / math.cos(slope) ** 2 / mu, math.tan(slope) / mu**2, 0, 0], rel=1e-12)
    assert result.values[0] == pytest.approx(-math.tan(slope) / mu, rel=1e-9)
    assert use_of(motion.scenario, "plane.mu", mu) == pytest.approx(result.values[0], rel=1e-9)
