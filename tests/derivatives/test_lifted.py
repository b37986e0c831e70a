"""A start in contact that is lifted or thrown a little: the states later on, against motions that bounce."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.layout import REASONS, Reason
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from hophoop.kernel.native import forced

ROLLS = "duration=0.45&start.speed=1&start.angle=0.6&plane.slope=0.1"
SLIDES = "duration=0.35&start.vx=2&start.omega=-1&start.angle=0.6&plane.mu=0.3"
FLIES = "duration=0.5&start.speed=3.9&start.angle=0.1"
FIELDS = ("x", "angle", "omega", "slip")
LIFTED = REASONS[Reason.CONTACT]


@pytest.fixture(autouse=True)
def _interpreted():
    with forced("interpreted"):
        yield


def beside(query, path, side):
    """How the end changes, by two motions beside this one whose error of first order is taken away."""
    scenario = hh.Scenario.from_query(query)
    end = scenario.duration
    still = hh.simulate(scenario).at(end)
    rates = []
    for step in (1e-6, 0.25e-6):
        state = hh.simulate(scenario.with_values({path: side * step})).at(end)
        rates.append(np.array([(getattr(state, name) - getattr(still, name)) / (side * step) for name in FIELDS]))
    # what is left is of the order of the step, where the hoop first falls of that of its root
    return 2 * rates[1] - rates[0] if path == "start.height" and query != FLIES else (4 * rates[1] - rates[0]) / 3


@pytest.mark.parametrize("restitution", [0.0, 0.3])
@pytest.mark.parametrize("resistance", [0.0, 0.05])
@pytest.mark.parametrize("query", [ROLLS, SLIDES])
def test_thrown_up_and_down(query, restitution, resistance):
    query += f"&plane.restitution={restitution}&plane.rolling_resistance={resistance}"
    result = hh.simulate(hh.Scenario.from_query(query)).sensitivity([f"end.{name}" for name in FIELDS], "start.vy")
    for side, found in ((1, result.larger), (-1, result.smaller)):
        assert found[:, 0] == pytest.approx(beside(query, "start.vy", side), rel=2e-6, abs=1e-9)
    alike = resistance == 0.0
    assert (result.reasons[1] == ("",)) == alike
    assert (result.reasons[1] == (SIDED,)) != alike
    assert abs(result.larger[1, 0]) > 0.01


@pytest.mark.parametrize("query", [ROLLS, SLIDES, SLIDES + "&plane.restitution=0.3", FLIES])
def test_lifted(query):
    result = hh.simulate(hh.Scenario.from_query(query)).sensitivity([f"end.{name}" for name in FIELDS], "start.height")
    assert result.larger[:, 0] == pytest.approx(beside(query, "start.height", 1), rel=1e-5, abs=1e-6)
    assert np.isnan(result.smaller).all()
    assert result.reasons == ((EDGE,),) * 4
    assert abs(result.larger[1, 0]) > 0.01


@pytest.mark.parametrize("more", ["&plane.restitution=0.3", "&plane.rolling_resistance=0.05"])
def test_rolling_that_is_lifted_and_bounces(more):
    result = hh.simulate(hh.Scenario.from_query(ROLLS + more)).sensitivity("end.angle", "start.height")
    assert result.reasons == ((LIFTED,),)
    assert np.isnan(result.larger).all()


def test_a_drop_onto_a_slope_moves_a_hoop_that_rests_there():
    """It falls vertically, h tan β along the plane, and rests there again."""
    plane = hh.Plane(slope=0.1, mu=0.5)
    angle = math.pi + math.asin(math.sin(0.1) / 0.75) - 0.1
    scenario = hh.Scenario(plane=plane, start=hh.Start.rolling(0.0, angle=angle), duration=0.5)
    motion = hh.simulate(scenario)
    assert motion.status == "at_rest"
    result = motion.sensitivity(["end.x", "end.angle"], "start.height")
    assert result.larger[:, 0] == pytest.approx([math.tan(0.1), 0.0], abs=1e-12)


def test_the_events_are_others():
    motion = hh.simulate(hh.Scenario(duration=1.2))
    result = motion.sensitivity(["takeoff.t", "hop.takeoff_angle", "end.friction", "end.x"], "start.vy")
    assert result.reasons == ((LIFTED,),) * 3 + (("",),)


def test_a_hop_at_once_that_is_thrown_down_lands_first():
    result = hh.sensitivity(hh.Scenario.from_query(FLIES), ["end.x", "hop.height"], "start.vy")
    assert np.isfinite(result.larger).all()
    assert np.isnan(result.smaller).all()
    assert result.larger[0, 0] == pytest.approx(beside(FLIES, "start.vy", 1)[0], rel=1e-6)
