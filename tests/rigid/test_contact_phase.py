"""Rolling and slip step by step: what is carried from turn to turn and from panel to panel, and places on one."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.integrate import solve_ivp

from hophoop.kernel.numerics.collocation import ORDER, lagrange
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.anchor import FREE, ROLLING, SLIPPING, Anchor, frictionless_value
from hophoop.kernel.panels.panel import ARRIVE, LEAVE, LINEAR
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.layout import new_scratch
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import Ending
from newton_euler import accelerations
from rigid.tools import (
    SKID,
    SPIN,
    STARTED,
    body_of,
    limits,
    log_of,
    motion_of,
    phase_at,
    sines_of,
    state_of,
)

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel


def exactly(turns, high, low):
    return 2 * mp.pi * int(turns) + mpf(float(high)) + mpf(float(low))


@pytest.mark.parametrize("th", [6.0, -6.0])
@pytest.mark.parametrize(
    ("anchor", "mu"),
    [
        (Anchor(ROLLING, 0.25, 0.125, 1e-18, 0.5), 0.5),
        (Anchor(ROLLING, 0.25, -3.0, 1e-17, -0.5), 0.5),
        (Anchor(SLIPPING, 0.25, 0.125, 1e-18, 0.5), 0.5),
        (Anchor(SLIPPING, 0.25, 0.125, 1e-18, 0.5), 0.0),
        (Anchor(FREE, 0.0, 0.0, 0.0, 0.0), 0.5),
    ],
)
def test_an_angle_counted_in_the_next_turn_is_the_same(th, anchor, mu):
    """θ to 30 digits, from a valley or a hilltop of slip just as far; of the next hilltop of rolling D θ̇² + 2 V is another."""
    body = body_of(slope=0.3, mu=mu)
    before = state_of(0.0, 1.0, revolutions=5.0, th=th, th_low=3e-17, anchor=anchor)
    after = contact_phase.normalize_turns(body, before)
    way = math.copysign(1.0, th)
    rolling_hilltop = anchor.kind == ROLLING and anchor.bend > 0.0
    moved = 0 if rolling_hilltop or (anchor.kind == SLIPPING and mu == 0.0) else -way
    with mp.workdps(40):
        turned = exactly(after.revolutions, after.th, after.th_low) - exactly(5, th, 3e-17)
        base = exactly(moved, anchor.base, anchor.base_low) - exactly(0, after.anchor.base, after.anchor.base_low)
        assert max(abs(turned), abs(base)) < 1e-30
        # 2 V falls by 2 g_t a radian down the slope, and so it does to the hilltop of the next turn
        gained = 2 * mpf(body.gt) * way * 2 * mp.pi if rolling_hilltop else 0
        assert abs(mpf(after.anchor.excess) - mpf(anchor.excess) - gained) < 1e-14
    assert (after.revolutions, after.anchor.kind, after.anchor.bend) == (5.0 + way, anchor.kind, anchor.bend)
    assert (after[:5], after[8:-1]) == (before[:5], before[8:-1])


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(("base", "largest"), [(0.0, 1e-280), (0.5, 1e-30)])
def test_on_a_hilltop_only_what_is_there_exactly_stays(way, base, largest):
    """θ in two doubles; on the level 1e-280 rad are 600 √(R/g) away from being seen."""
    body = body_of(slope=0.0 if base == 0.0 else -0.2)
    for kind in (ROLLING, SLIPPING):
        for psi, still in ((0.0, True), (0.5 * largest, True), (2.0 * largest, False), (1e-20, False)):
            state = state_of(base, anchor=Anchor(kind, 0.0, base, 0.0, 0.5), th_low=way * psi)
            assert contact_phase.is_equilibrium(body, 0, state) is still


@pytest.mark.parametrize("th", [math.pi, -math.pi, 0.5 * math.pi, 0.0])
def test_elsewhere_what_has_no_torque_stays(th):
    """In the valley, which no double is, within its rounding; not where the weight turns the hoop."""
    valley = abs(th) == math.pi
    for anchor in (Anchor(FREE, 0.0, 0.0, 0.0, 0.0), Anchor(ROLLING, 0.0, th, 0.0, -0.5)):
        for psi in (0.0, 1e-16, 1e-14):
            still = contact_phase.is_equilibrium(body_of(), 0, state_of(th + psi, anchor=anchor))
            assert still is ((valley and psi < 1e-15) or (th == 0.0 and psi < 1e-15))


class Given(NamedTuple):
    """What `carried` asks of a panel, of what it comes to and of its end."""

    kind: int = LINEAR
    sine: float = 0.0
    growth: float = 1.0


@pytest.mark.parametrize("kind", [LINEAR, ARRIVE])
def test_the_excess_of_slip_grows_by_the_panels_factor_at_its_end_only(kind):
    body = body_of()
    anchor = Anchor(SLIPPING, 0.5, 0.25, 1e-18, 0.75)
    given = Given(kind=kind, growth=4.0)
    at_end = contact_phase.propagate_anchor(body, given, given, 1.0, state_of(0.5, anchor=anchor))
    factor = 4.0 if kind == LINEAR else 0.25  # solved from the turning point back
    assert at_end.anchor == anchor._replace(excess=0.5 * factor)
    inside = contact_phase.propagate_anchor(body, given, given, math.nextafter(1.0, 0.0), state_of(0.5, anchor=anchor))
    assert inside.anchor.kind == FREE


@pytest.mark.parametrize("xi", [0.3, 1.0])
def test_without_friction_the_excess_goes_as_one_over_the_inertia(xi):
    """κ + ε² sin² θ, between any two angles."""
    body = body_of(mu=0.0)
    anchor = Anchor(SLIPPING, 0.5, 0.0, 0.0, 0.75)
    given = Given(sine=math.sin(0.25))
    after = contact_phase.propagate_anchor(body, given, given, xi, state_of(1.0, anchor=anchor))
    inertia = [body.kap + (body.eps * math.sin(angle)) ** 2 for angle in (0.25, 1.0)]
    assert after.anchor.excess == pytest.approx(0.5 * inertia[0] / inertia[1], rel=1e-15)


@pytest.mark.parametrize("offset", [1e-100, -1e-30])
def test_a_slow_start_in_a_short_time(offset):
    """δ cosh λt beside the top, λ² = ε/(κ + (1 + ε)²): so slow that a panel of the usual width would last much too long."""
    body = body_of()
    rate = math.sqrt(body.eps / (body.kap + (1.0 + body.eps) ** 2))
    for t_end in (0.5, 2.0):
        status, events, _ = motion_of(body, state_of(offset), t_end)
        assert (status, len(events)) == (Status.COMPLETED, 2)
        assert events["angle"][1] == pytest.approx(offset * math.cosh(rate * t_end), rel=1e-13, abs=0.0)
        assert events["omega"][1] == pytest.approx(offset * rate * math.sinh(rate * t_end), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(("sigma", "mode"), [(1, SKID), (-1, SPIN)])
@pytest.mark.parametrize(("off", "regains"), [(1e-8, True), (1e-3, True), (1e-10, False), (-1e-8, True)])
def test_slip_that_comes_back_to_its_hilltop_regains_the_digits_of_its_rate_of_turning(off, regains, sigma, mode):
    """Where θ̇ is not that of its anchor by some part of it; G keeps its velocity along the plane."""
    body = body_of(mu=0.0)
    right = math.sqrt(1e-3 + frictionless_value(body, 0.05, 0.0))
    lost = right * (1.0 + off)
    state = state_of(0.05, lost, 3.0 * sigma, anchor=Anchor(SLIPPING, 1e-3, 0.0, 0.0, 0.75))
    log, scratch = log_of()
    what, after, _ = contact_phase.advance_contact(body, phase_at(mode, state), limits(state, 0.125), log, scratch)
    first = log.segments[0]
    assert (what, after.t, first["t"]) == (Ending.TIME_LIMIT, 0.125, 0.0)
    assert first["omega"] == (pytest.approx(right, rel=1e-15) if regains else lost)
    assert first["u"] == pytest.approx(right**2, rel=1e-14)
    along = [at.vt + at.om * (1.0 + 0.75 * math.cos(at.th)) for at in (state, after)]
    assert along[1] == pytest.approx(along[0], abs=1e-14 if regains else 1e-10)


# a place on a solved panel


@pytest.mark.parametrize("xi", [-0.75, 0.3, -1.0 + 1e-7, 1.0 - 1e-7])
@pytest.mark.parametrize(("kind", "end"), [(LINEAR, None), (ARRIVE, 1.0), (LEAVE, -1.0)])
def test_a_small_square_of_the_speed_has_its_digits_beside_a_turning_point(kind, end, xi):
    """θ̇² = s² (1 + ξ/4), where s vanishes at the turning point."""

    def square(at):
        return (1.0 if end is None else (end - at) ** 2) * (1.0 + 0.25 * at)

    weights = np.empty(ORDER)
    lagrange(xi, weights)
    found = contact_phase.square_rate_inside(Given(kind=kind), xi, weights, square(NODES))
    assert found == pytest.approx(square(xi), rel=1e-13, abs=0.0)


def solved_panel(body, sigma, th, om):
    """(panel, totals, state at its start, arrays) as the kernel chooses it."""
    scratch = new_scratch()
    state = state_of(th, om, 0.75 * sigma, **STARTED)
    state = contact_phase.set_anchor(body, sigma, state, *sines_of(state), scratch)
    panel, totals, _ = contact_phase.choose_panel(body, sigma, state, *sines_of(state), 2, scratch)
    assert totals.tail < 2e-13
    contact_phase.fill_inside(panel, scratch.work)
    return panel, totals, state, scratch


def followed(body, sigma, way, state, duration):
    """(x, θ, θ̇, v_t, friction's work, that of the rolling resistance) by Newton's and Euler's equations in time."""

    def rates(t, now):
        _, th, om, vt, _, _ = now
        ax, _, alpha, _, normal = accelerations(body, th, om, sigma or "roll", way * body.resist)
        work = sigma * body.mu_k * normal * vt
        return [vt + om, om, alpha, ax - alpha, work, body.resist * normal * om * way]

    start = [state.x, state.th, state.om, state.vt, state.friction, state.rolling_loss]
    if duration == 0.0:
        return start
    found = solve_ivp(rates, (0.0, duration), start, method="DOP853", rtol=1e-12, atol=1e-13)
    return found.y[:, -1]


@pytest.mark.parametrize("resist", [0.0, 0.0625])
@pytest.mark.parametrize("sigma", [0, 1, -1])
@pytest.mark.parametrize(
    ("kind", "th", "om"),
    [(LINEAR, 2.0, 1.5), (LINEAR, 2.0, -1.5), (LEAVE, 2.0, 0.0), (LEAVE, -2.0, 0.0), (ARRIVE, 1.0, -0.25), (ARRIVE, 5.0, 0.25)],
)
def test_a_place_on_a_panel_is_where_the_hoop_comes_to(kind, th, om, sigma, resist):
    body = body_of(slope=0.125, mu=0.25, rolling_resistance=resist)
    panel, totals, state, scratch = solved_panel(body, sigma, th, om)
    assert panel.kind == kind
    for xi in (-1.0, -0.5, 0.375, 1.0):
        after = contact_phase.state_on_panel(body, panel, totals, state, xi, scratch)
        expected = followed(body, sigma, panel.direction, state, after.t - state.t)
        found = [after.x, after.th, after.om, after.vt, after.friction, after.rolling_loss]
        assert found == pytest.approx(expected, rel=1e-11, abs=1e-11)
        assert (after.t > state.t) == (xi > -1.0)
        assert (after.y, after.vn, after.revolutions, after.impact_n, after.impact_t) == (0.0, 0.0, 2.0, 0.25, 0.375)
        assert after.anchor == state.anchor
        assert after == state or xi > -1.0
    assert (after.om == 0.0) == (kind == ARRIVE)


@pytest.mark.parametrize(("sigma", "resist", "th", "om"), [(0, 0.0625, 1.0, 0.0), (1, 0.0, 0.8, 1.5)])
def test_no_place_on_a_panel_is_before_its_begin(sigma, resist, th, om):
    """However near it is: the time up to there is rounded, too."""
    body = body_of(slope=0.125, mu=0.25, rolling_resistance=resist)
    panel, totals, state, scratch = solved_panel(body, sigma, th, om)
    state = state._replace(t=0.0, t_low=0.0)
    for place in range(1, 20):
        after = contact_phase.state_on_panel(body, panel, totals, state, -1.0 + place * 2.0**-53, scratch)
        assert after.t >= 0.0
