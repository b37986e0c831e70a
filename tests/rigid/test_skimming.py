"""The fall of the massless hoop's load, written by the kernel: a parabola, and one motion for both sides."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid.phase import angle_left, limits_of
from hophoop.kernel.rigid.run import BY_RULE, run
from hophoop.kernel.rigid.sampling import MARGINS, margins_of


def body_of(mu, restitution=0.0):
    return hh.Scenario(hoop=hh.Hoop.ideal(1.0), plane=hh.Plane(mu=mu, restitution=restitution)).to_body()


def motion_of(body, angle, om, t_end=20.0):
    events, segments = np.empty(100, EVENT), np.empty(1000, SEGMENT)
    start = start_state(0.0, 0.0, angle, 0.0, 0.0, om)
    status, count, pieces = run(body, start, BY_RULE, t_end, math.nan, 0, events, segments, new_scratch())
    return status, events[:count], segments[:pieces]


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("angle", [0.5, 0.5 * math.pi, 2.0, 3.0])
def test_from_rest_the_load_falls_straight_down(side, angle):
    """Without friction; the rim goes under it, to the side to which the load turns."""
    status, events, segments = motion_of(body_of(0.0), side * angle, 0.0)
    skim, impact = events[1:3]
    assert (skim["kind"], skim["after_mode"], skim["t"]) == (Event.SKIM, Mode.SKIM, 0.0)
    assert (impact["kind"], impact["before_mode"]) == (Event.IMPACT, Mode.SKIM)
    assert impact["t"] == pytest.approx(math.sqrt(2.0 * (1.0 + math.cos(angle))), rel=1e-14)
    assert impact["x"] == pytest.approx(side * math.sin(angle), rel=1e-14)
    assert impact["angle"] == side * math.pi
    assert segments[segments["mode"] == Mode.SKIM]["direction"].tolist() == [side]
    assert impact["before_vy"] == pytest.approx(-impact["t"], rel=1e-14)
    assert (impact["gain"], impact["stable"], impact["collision"]) == (0.0, -1, 1)
    assert impact["impact_normal"] == pytest.approx(0.5 * impact["t"] ** 2, rel=1e-13)
    assert status != Status.UNDETERMINED


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_over_the_top_the_load_flies_on(side):
    """Too fast to be held, it keeps its speed along the plane, twice that of the rim, and falls from 2 R."""
    _, events, segments = motion_of(body_of(0.5), 0.0, side * 1.5)
    impact = events[events["kind"] == Event.IMPACT][0]
    assert impact["angle"] == side * math.pi
    assert impact["t"] == pytest.approx(2.0, rel=1e-14)  # from 2 R
    assert impact["x"] == pytest.approx(side * 2.0 * 1.5 * 2.0, rel=1e-14)
    assert impact["slip"] == pytest.approx(side * (2.0 * 1.5 - 0.5 * 2.0), rel=1e-14)  # braked by μ times the blow
    assert impact["after_mode"] == (Mode.SKID if side > 0.0 else Mode.SPIN)
    assert segments[0]["direction"] == side


@pytest.mark.parametrize("restitution", [0.5, 1.0])
def test_after_an_elastic_blow_nothing_tells_how_the_rim_turns(restitution):
    status, events, _ = motion_of(body_of(0.0, restitution), 2.0, 0.0)
    assert status == Status.UNDETERMINED
    assert (events[2]["kind"], events[2]["after_mode"]) == (Event.IMPACT, Mode.FLIGHT)


def test_a_fall_that_does_not_end_in_time():
    _, events, _ = motion_of(body_of(0.0), 2.0, 0.0, t_end=0.5)
    last = events[-1]
    assert (last["kind"], last["before_mode"], last["t"]) == (Event.END, Mode.SKIM, 0.5)
    assert (last["vy"], last["height"]) == (0.0, 0.0)
    height = 1.0 + math.cos(2.0) - 0.5 * 0.5**2
    assert 1.0 + math.cos(last["angle"]) == pytest.approx(height, rel=1e-14)
    assert last["x"] + math.sin(last["angle"]) == pytest.approx(math.sin(2.0), rel=1e-14)


def test_a_plane_without_slip_has_no_limit_where_it_presses():
    hoop = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(mu=math.inf)).to_body()
    limits = []
    for omega in (0.0, 1.5, 3.0):  # on the plane, and held down by it, by less than the weight or more
        found = dict(zip(MARGINS, margins_of(hoop, Mode.ROLL, 0.0, 0.0, omega, 0.0, 0.0), strict=True))
        limits.append((math.copysign(1.0, found["normal_force"]), found["friction_limit"]))
    assert limits == [(1.0, math.inf), (-1.0, -math.inf), (-1.0, -math.inf)]


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("turns", [1, 2, 5])
def test_the_angle_that_is_left_has_its_digits(way, turns):
    """Also where hardly anything is left of many turns."""
    start = start_state(0.0, 0.0, 0.25, 0.0, 0.0, 1.0)
    limits = limits_of(start, 9.0, 2.0 * math.pi * turns, 0, 0)
    th, low = way * 6.5, 1e-17
    state = start._replace(revolutions=way * (turns - 1), th=th, th_low=low)
    with mp.workdps(40):
        done = way * (2 * mp.pi * state.revolutions + mpf(th) + mpf(low) - mpf("0.25"))
        assert abs(mpf(float(angle_left(limits, state, way))) - (2 * mp.pi * turns - done)) < 5e-16
