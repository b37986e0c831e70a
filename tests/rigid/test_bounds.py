"""No motion without end, and none that completes with a number that is not finite: every loop driven to its bound."""

from __future__ import annotations

import json
import math
import time

import numpy as np
import pytest

import hophoop as hh
import hophoop.simulation.simulate
from contact_tools import sines_of
from hophoop.kernel.native import forced
from hophoop.kernel.numerics import collocation
from hophoop.kernel.panels import landing
from hophoop.kernel.panels.panel import LEVELS, RESOLVED
from hophoop.kernel.records.layout import MOST_PANELS, PANELS, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import panel_choice
from hophoop.kernel.rigid.phase import START_LEVEL
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


@pytest.mark.parametrize(
    "start",
    [
        hh.Start.rolling(-0.063, angle=math.pi),
        hh.Start.rolling(0.063, angle=-math.pi),
        hh.Start(angle=math.pi, vx=-0.063),
        hh.Start(angle=math.pi, vx=0.5, omega=-0.063),
        hh.Start.rolling(11.0, angle=3 * math.pi),
    ],
)
def test_the_load_on_the_plane_and_a_speed(start):
    """Without mass in the rim its rotation holds no energy: no motion follows from it. Once without end."""
    motion = hh.simulate(hh.Scenario(hoop=MASSLESS, start=start))
    assert motion.status == "undetermined"
    assert motion.duration == 0.0
    assert is_finite(motion)


@pytest.mark.parametrize("angle", [2.0977, 1.0, 3.0])
def test_massless_without_gravity(angle):
    """Free of any force the load goes on in a straight line until it strikes. Once `completed` with ω = inf."""
    speed = 11.37
    motion = hh.simulate(hh.Scenario(hoop=MASSLESS, plane=SMOOTH, start=hh.Start.rolling(speed, angle=angle)))
    assert motion.sequence.startswith("M")
    assert is_finite(motion)
    impact = motion.find("impact")[0]
    # rolling, the load's velocity is θ̇ times its distance 2 cos(θ/2) from the contact, its downward part θ̇ sin θ
    fall = (1.0 + math.cos(angle)) / (math.sin(angle) * speed)
    assert impact.t == pytest.approx(fall, rel=1e-12)
    along = math.sin(angle) + speed * (1.0 + math.cos(angle)) * fall
    assert impact.x == pytest.approx(along, rel=1e-12)
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range


def test_massless_without_gravity_at_the_top():
    """The load moves along the plane for ever, and the rim below it, without turning."""
    motion = hh.simulate(hh.Scenario(hoop=MASSLESS, plane=SMOOTH, start=hh.Start.rolling(2.0)))
    assert (motion.status, motion.sequence) == ("completed", "M")
    end = motion.at(6.0)
    assert (end.omega, end.vx, end.x) == (0.0, 4.0, pytest.approx(24.0, rel=1e-15))


@pytest.mark.parametrize("rest", [0.5, 1.0])
def test_a_strike_that_rebounds_ends_with_a_finite_state(rest):
    """The model ends at the strike; the state after it is kept, and not the θ̇ without bound before it."""
    motion = hh.simulate(hh.Scenario(hoop=MASSLESS, plane=hh.Plane(restitution=rest), start=hh.Start(angle=3.0)))
    assert motion.status == "undetermined"
    assert motion.at(motion.duration).omega == 0.0
    assert is_finite(motion)


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


def choose(state, body):
    scratch = new_scratch()
    state = panel_choice.set_anchor(body, 0, state, *sines_of(state), scratch)
    return panel_choice.choose_panel(body, 0, state, *sines_of(state), START_LEVEL, scratch), scratch


@pytest.mark.parametrize("omega", [0.0, 1.0, 1e-10, 1e-150])
def test_a_panel_that_is_never_resolved_is_given_up(monkeypatch, omega):
    """Narrower and narrower ones are tried, each counted, down to the smallest that is allowed; then it is said so."""
    solved = solving(monkeypatch, lambda totals, _: totals._replace(tail=1.0))
    (panel, totals, level), scratch = choose(start_state(0.0, 0.0, 1.0, 0.0, 0.0, omega), hh.Scenario().to_body())
    assert totals.tail > RESOLVED
    tried = scratch.counts[PANELS]
    if omega == 0.0:
        # halved from 0.4 rad until it is below the smallest
        assert len(solved) == tried == math.ceil(math.log2(panel_choice.FIRST_EXTENT / panel_choice.SMALLEST_EXTENT)) + 1
        assert panel.extent < panel_choice.SMALLEST_EXTENT
    else:
        # below a speed of 10⁻³ a hoop turns within θ̇²/θ̈, for which there are levels beyond the tables
        finest = LEVELS + max(0, math.ceil(2.0 * math.log2(panel_choice.SLOW**2 / omega**2)))
        assert tried <= finest
        assert level >= finest
        assert len(solved) <= (5 + 1 + panel_choice.MOST_MOVES) * tried


def test_a_motion_whose_panels_are_not_resolved_says_so(monkeypatch):
    """It ends without an answer where the panels end, and not with one that is wrong."""
    solving(monkeypatch, lambda totals, count: totals._replace(tail=1.0) if count > 5 else totals)
    with forced("interpreted"):
        motion = hh.simulate(hh.Scenario(plane=hh.Plane(mu=math.inf), start=hh.Start.rolling(3.1)))
    assert motion.status == "undetermined"
    assert 0.0 < motion.duration < 1.0
    assert is_finite(motion)


def test_a_turning_point_is_moved_so_often_and_no_more(monkeypatch):
    """Where moving it never brings θ̇² to what it is at the start."""
    body = hh.Scenario().to_body()
    begin = panel_choice.PanelStart(-1.0, 0.0, math.sin(-1.0), math.cos(-1.0), 0.5, 1.0, 0.0, 0.0, 1.0, 0.0)
    before = panel_choice.linear_panel(0, 0, 1.0, begin)
    scratch = new_scratch()
    solved = solving(monkeypatch, lambda totals, count: totals._replace(tail=0.0, u=1.1 if count % 2 else 0.9))
    with np.errstate(all="ignore"):
        panel_choice.solve_arrival(body, before, 0.1, scratch.work)
    assert len(solved) == 1 + panel_choice.MOST_MOVES
    # with the true solutions a few moves are enough
    monkeypatch.undo()
    motion = hh.simulate(hh.Scenario(start=hh.Start.rolling(0.5, angle=math.pi)))
    turn = motion.find("turn")[0]
    # ½ v² (2 + 2 γ cos π) = γ g (1 + cos θ) R of height
    height = (1.0 - 0.75) * 0.25 / (0.75 * 9.81)
    assert abs(math.pi - turn.angle) == pytest.approx(math.acos(1.0 - height), rel=1e-12)
