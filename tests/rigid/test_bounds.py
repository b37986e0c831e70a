"""No motion without end, and none that completes with a number that is not finite: every loop driven to its bound."""

from __future__ import annotations

import json
import math
import time

import numpy as np
import pytest

import hophoop as hh
import hophoop.simulation.simulate
from hophoop.kernel.native import forced
from hophoop.kernel.numerics import collocation
from hophoop.kernel.panels import landing
from hophoop.kernel.records.layout import MOST_PANELS
from hophoop.kernel.rigid import panel_choice
from hophoop.precise.motion import Run
from hophoop.precise.problem import Problem
from hophoop.precise.series import Work, work_of_step

MASSLESS = hh.Hoop(eccentricity=1.0, inertia_ratio=0.0)
SMOOTH = hh.Plane(gravity=0.0)


def is_finite(motion):
    """Whether all that a motion says is finite, and its JSON valid."""
    json.dumps(motion.to_dict(), allow_nan=False)
    sample = motion.at(motion.times(21) if motion.duration > 0.0 else np.zeros(1))
    return all(np.isfinite(getattr(sample, name)).all() for name in ("x", "angle", "vx", "omega", "slip", "kinetic"))


@pytest.mark.slow
@pytest.mark.compiled
def test_panels_are_used_up():
    """16 turns a millisecond for 30 years: the motion ends with what has been computed, and says where."""
    motion = hh.simulate(hh.Scenario(hoop=hh.Hoop.ideal(0.0, radius=1e-2), start=hh.Start.rolling(1e3), duration=1e9))
    assert motion.status == "event_limit"
    assert 0.9 * MOST_PANELS <= 2 * len(motion.tables["segments"]) <= MOST_PANELS
    end = motion.events[-1]
    assert end.kind == "end"
    assert end.t == motion.duration
    assert end.x == pytest.approx(1e3 * end.t, rel=1e-12)  # ε = 0: it rolls on evenly
    assert is_finite(motion)


@pytest.mark.compiled
@pytest.mark.parametrize("contact", [hh.Rigid(), hh.Compliant(stiffness=1e9)])
def test_turns_of_a_flight_are_used_up(contact):
    """Without gravity a rim that touches the plane once a turn but for rounding is looked at so often and no more."""
    angle, omega = 1e-7, 1e4
    dip = 0.75 * (1.0 - math.cos(angle))  # by which the rim comes lower later in a turn
    rise = math.nextafter(0.75 * math.sin(angle) * omega, 0.0)  # with which G stays as high as it is, or sinks by 1e-19 m/s
    start = hh.Start(height=dip - 1e-16, angle=angle, vy=rise, omega=omega)
    motion = hh.simulate(hh.Scenario(plane=SMOOTH, start=start, duration=1e9, contact=contact))
    assert (motion.status, motion.sequence) == ("event_limit", "H")
    assert motion.duration == pytest.approx(landing.MOST_BENDS * math.pi / 1e4, rel=1e-4)
    assert is_finite(motion)


@pytest.mark.parametrize("gravity", [9.81, 0.0])
def test_a_flight_of_many_turns_keeps_its_law(gravity):
    """10⁶ and 10⁷ turns up in the air are not looked at; where G is, and the energy, is right to rounding."""
    plane = hh.Plane(gravity=gravity)
    start = hh.Start(height=1e3, vy=10.0, omega=1e6)
    motion = hh.simulate(hh.Scenario(plane=plane, start=start, duration=100.0, contact=hh.Rigid(max_events=4)))
    rise = 10.0  # of G, as sin θ = 0
    if gravity:
        impact = motion.find("impact")[0]
        # the rim is lowest beside G where the load is at the top, once a turn
        lowest = (rise + math.sqrt(rise**2 + 2 * gravity * 1e3)) / gravity
        assert lowest * (1 - 1e-12) <= impact.t <= lowest + 2 * math.pi / 1e6
        apex = motion.find("apex")[0]
        assert apex.t == pytest.approx(rise / gravity, abs=2 * math.pi / 1e6)
        assert apex.height == pytest.approx(1e3 + 0.5 * rise**2 / gravity + 1.5, rel=1e-9)
    else:
        assert motion.status == "completed"
        assert motion.at(100.0).height == pytest.approx(2e3 + 0.75 * (1 - math.cos(motion.at(100.0).angle)), rel=1e-9)
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range


def test_a_search_for_roots_ends(monkeypatch):
    """A wave needs more than one interval; with so few its fall is not found, and nothing hangs."""
    series = np.polynomial.chebyshev.chebinterpolate(lambda x: np.cos(4 * x + 1.0), collocation.ORDER - 1)
    stack = np.zeros((collocation.DEPTH + 3, collocation.ORDER + 2))
    search = collocation.first_downcrossing_after
    found = search(series, -2.0, 0.0, stack)
    assert math.cos(4 * found + 1.0) == pytest.approx(0.0, abs=1e-7)
    monkeypatch.setattr(collocation, "MOST_INTERVALS", 1)
    assert search(series, -2.0, 0.0, stack) == collocation.NOT_FOUND


def test_a_step_of_more_bits_costs_what_it_takes():
    """The count of work goes with the time of a step, to a factor of two."""
    costs = []
    for bits in (106, 351):
        run = Run(Problem.of(hh.Scenario(duration=1.0)), bits, False, 1e-23, work=Work(math.inf))
        counted = []
        run.body.work.take = counted.append
        began = time.process_time()
        run.run()
        costs.append((time.process_time() - began) / len(counted) / work_of_step(bits))
    assert 0.5 < costs[1] / costs[0] < 2.0


def solving(monkeypatch, change):
    """The sizes of the panels that are solved, with what `change` makes of each result."""
    solved = []
    solve = panel_choice.solve

    def changed(body, panel, work):
        solved.append(panel.extent)
        return change(solve(body, panel, work), len(solved))

    for name in ("solve", "solve_noinline"):
        monkeypatch.setattr(panel_choice, name, changed)
    return solved


def test_a_motion_whose_panels_are_not_resolved_says_so(monkeypatch):
    """It ends without an answer where the panels end, and not with one that is wrong."""
    solving(monkeypatch, lambda totals, count: totals._replace(tail=1.0) if count > 5 else totals)
    with forced("interpreted"):
        motion = hh.simulate(hh.Scenario(plane=hh.Plane(mu=math.inf), start=hh.Start.rolling(3.1)))
    assert motion.status == "undetermined"
    assert 0.0 < motion.duration < 1.0
    assert is_finite(motion)
