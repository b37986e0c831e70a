"""No motion without end, and none that completes with a number that is not finite: every loop driven to its bound."""

import json
import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.kernel.numerics import collocation
from hophoop.kernel.panels import landing
from hophoop.kernel.records.layout import MOST_PANELS
from hophoop.kernel.rigid import panel_choice


def assert_finite(motion):
    """All that a motion says is finite, and its JSON valid."""
    json.dumps(motion.to_dict(), allow_nan=False)
    sample = motion.at(np.linspace(0.0, motion.duration, 21))
    assert all(np.isfinite(getattr(sample, name)).all() for name in ("x", "angle", "vx", "omega", "slip", "kinetic"))


@pytest.mark.slow
def test_panels_are_used_up():
    """16 turns a millisecond for 30 years: the motion ends with what has been computed, and says where."""
    motion = hh.simulate(hh.Scenario.from_query("duration=1000000000&hoop.radius=0.01&hoop.load_fraction=0&start.speed=1000"))
    assert motion.status == "event_limit"
    assert 0.9 * MOST_PANELS <= 2 * len(motion.tables["segments"]) <= MOST_PANELS
    end = motion.events[-1]
    assert (end.kind, end.t) == ("end", motion.duration)
    assert end.x == pytest.approx(1e3 * end.t, rel=1e-12)  # ε = 0: it rolls on evenly
    assert_finite(motion)


@pytest.mark.long
@pytest.mark.parametrize("contact", [hh.Rigid(), hh.Compliant(stiffness=1e9)])
def test_turns_of_a_flight_are_used_up(contact):
    """Without gravity a rim that touches the plane once a turn but for rounding is looked at so often and no more."""
    angle, omega = 1e-7, 1e4
    dip = 0.75 * (1.0 - math.cos(angle))  # by which the rim comes lower later in a turn
    rise = math.nextafter(0.75 * math.sin(angle) * omega, 0.0)  # with which G stays as high as it is, or sinks by 1e-19 m/s
    start = hh.Start(height=dip - 1e-16, angle=angle, vy=rise, omega=omega)
    motion = hh.simulate(hh.Scenario(plane=hh.Plane(gravity=0.0), start=start, duration=1e9, contact=contact))
    assert (motion.status, motion.sequence) == ("event_limit", "H")
    assert motion.duration == pytest.approx(landing.MOST_BENDS * math.pi / 1e4, rel=1e-4)
    assert_finite(motion)


@pytest.mark.parametrize("gravity", [9.81, 0.0])
def test_a_flight_of_many_turns_keeps_its_law(gravity):
    """10⁶ and 10⁷ turns up in the air are not looked at; G rises with 10 m/s, as sin θ = 0."""
    start = hh.Start(height=1e3, vy=10.0, omega=1e6)
    plane, contact = hh.Plane(gravity=gravity), hh.Rigid(max_events=4)
    motion = hh.simulate(hh.Scenario(plane=plane, start=start, duration=100.0, contact=contact))
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range
    if not gravity:
        assert motion.at(100.0).height == pytest.approx(2e3 + 0.75 * (1 - math.cos(motion.at(100.0).angle)), rel=1e-9)
        return
    # the rim is lowest beside G where the load is at the top, once a turn
    lowest, turn = (10.0 + math.sqrt(100.0 + 2e3 * gravity)) / gravity, 2 * math.pi / 1e6
    assert lowest * (1 - 1e-12) <= motion.find("impact")[0].t <= lowest + turn
    apex = motion.find("apex")[0]
    assert apex.t == pytest.approx(10.0 / gravity, abs=turn)
    assert apex.height == pytest.approx(1e3 + 50.0 / gravity + 1.5, rel=1e-9)


def test_a_search_for_roots_ends(monkeypatch):
    """A wave needs more than one interval; with so few its fall is not found, and nothing hangs."""
    series = np.polynomial.chebyshev.chebinterpolate(lambda x: np.cos(4 * x + 1.0), collocation.ORDER - 1)
    stack = np.zeros((collocation.DEPTH + 3, collocation.ORDER + 2))
    search = collocation.first_downcrossing_after
    assert math.cos(4 * search(series, -2.0, 0.0, stack) + 1.0) == pytest.approx(0.0, abs=1e-7)
    monkeypatch.setattr(collocation, "MOST_INTERVALS", 1)
    assert search(series, -2.0, 0.0, stack) == collocation.NOT_FOUND


def test_a_motion_whose_panels_are_not_resolved_says_so(monkeypatch):
    """It ends in doubt where the panels end, and not with an answer that is wrong."""
    solve, solved = panel_choice.solve, []

    def failing(body, panel, work):
        solved.append(panel)
        totals = solve(body, panel, work)
        return totals._replace(tail=1.0) if len(solved) > 5 else totals

    for name in ("solve", "solve_noinline"):
        monkeypatch.setattr(panel_choice, name, failing)
    with forced("interpreted"):
        motion = hh.simulate(hh.Scenario.from_query("plane.mu=10"))
    assert motion.status == "undetermined"
    assert 0.0 < motion.duration < 1.0
    assert motion.doubt == pytest.approx(motion.duration)
    assert_finite(motion)
