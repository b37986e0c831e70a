"""Rolling and slip step by step: what is carried from turn to turn and from panel to panel, and what stays at rest."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.integrate import solve_ivp

import hophoop as hh
from hophoop._jit import forced, interpreted
from hophoop.numerics.collocation import NODES, ORDER, lagrange
from hophoop.panels.anchor import FREE, ROLLING, SLIPPING, Anchor
from hophoop.panels.panel import ARRIVE, HOLD, LEAVE, LINEAR
from hophoop.physics.body import Event, Mode, Status
from hophoop.physics.resistance import forces_rolling, torque_at_rest
from hophoop.records.layout import EVENT, SEGMENT
from hophoop.records.scratch import new_scratch
from hophoop.records.state import start_state
from hophoop.records.writing import new_log
from hophoop.rigid import contact_phase, panel_events
from hophoop.rigid.kernel import run
from hophoop.rigid.limits import STOP_AT_TAKEOFF, STOP_AT_TURN, limits_of
from hophoop.rigid.phase import Phase
from newton_euler import accelerations

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel


def body_of(gamma=0.75, slope=0.0, mu=0.5, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu, slope=slope, **plane)).to_body()


def state_of(angle, om=0.0, vt=0.0, anchor=None):
    state = interpreted(start_state)(0.0, 0.0, angle, vt, 0.0, om)
    return state if anchor is None else state._replace(anchor=anchor)


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
    before = state_of(0.0, 1.0)._replace(turns=5.0, th=th, th_low=3e-17, anchor=anchor)
    after = interpreted(contact_phase.counted)(body, before)
    way = math.copysign(1.0, th)
    with mp.workdps(40):
        assert after.turns == 5.0 + way
        assert abs(exactly(after.turns, after.th, after.th_low) - exactly(5, th, 3e-17)) < 1e-30
        moves = exactly(1, 0.0, 0.0) * int(way)
        own_hilltop = (anchor.kind == ROLLING and anchor.bend > 0.0) or (anchor.kind == SLIPPING and mu == 0.0)
        shift = 0 if own_hilltop else -moves
        assert (
            abs(exactly(0, after.anchor.base, after.anchor.base_low) - exactly(0, anchor.base, anchor.base_low) - shift) < 1e-30
        )
        # 2 V falls by 2 g_t a radian down the slope, and so it does to the hilltop of the next turn
        gained = 2 * mpf(body.gt) * moves if anchor.kind == ROLLING and anchor.bend > 0.0 else 0
        assert abs(mpf(after.anchor.excess) - mpf(anchor.excess) - gained) < 1e-14
    assert (after.anchor.kind, after.anchor.bend) == (anchor.kind, anchor.bend)
    assert after[:5] == before[:5]
    assert after[8:-1] == before[8:-1]


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(("base", "largest"), [(0.0, 1e-280), (0.5, 1e-30)])
def test_on_a_hilltop_only_what_is_there_exactly_stays(way, base, largest):
    """θ in two doubles; on the level 1e-280 rad are 600 √(R/g) away from being seen."""
    body = body_of(slope=0.0 if base == 0.0 else -0.2)
    for kind in (ROLLING, SLIPPING):
        for psi, still in ((0.0, True), (0.5 * largest, True), (2.0 * largest, False), (1e-20, False)):
            state = state_of(base, anchor=Anchor(kind, 0.0, base, 0.0, 0.5))._replace(th_low=way * psi)
            assert interpreted(contact_phase.is_still)(body, 0, state) is still


@pytest.mark.parametrize("th", [math.pi, -math.pi, 0.5 * math.pi, 0.0])
def test_elsewhere_what_has_no_torque_stays(th):
    """In the valley, which no double is, within its rounding; not where the weight turns the hoop."""
    valley = abs(th) == math.pi
    for anchor in (Anchor(FREE, 0.0, 0.0, 0.0, 0.0), Anchor(ROLLING, 0.0, th, 0.0, -0.5)):
        for psi in (0.0, 1e-16, 1e-14):
            still = interpreted(contact_phase.is_still)(body_of(), 0, state_of(th + psi, anchor=anchor))
            assert still is ((valley and psi < 1e-15) or (th == 0.0 and psi < 1e-15))


def test_speeds_whose_squares_underflow_are_none():
    events = np.empty(10, EVENT)
    start = state_of(math.pi, om=1e-150)
    status, count, _ = interpreted(run)(
        body_of(), start, 1.0, math.nan, 0, events, np.empty(0, SEGMENT), new_scratch(), events[:0]
    )
    assert status == Status.AT_REST
    assert events["kind"][:count].tolist() == [Event.START, Event.REST, Event.END]


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
    at_end = interpreted(contact_phase.carried)(body, given, given, 1.0, state_of(0.5, anchor=anchor))
    factor = 4.0 if kind == LINEAR else 0.25  # solved from the turning point back
    assert at_end.anchor == anchor._replace(excess=0.5 * factor)
    inside = interpreted(contact_phase.carried)(body, given, given, math.nextafter(1.0, 0.0), state_of(0.5, anchor=anchor))
    assert inside.anchor.kind == FREE


@pytest.mark.parametrize("xi", [0.3, 1.0])
def test_without_friction_the_excess_goes_as_one_over_the_inertia(xi):
    """κ + ε² sin² θ, between any two angles."""
    body = body_of(mu=0.0)
    anchor = Anchor(SLIPPING, 0.5, 0.0, 0.0, 0.75)
    given = Given(sine=math.sin(0.25))
    after = interpreted(contact_phase.carried)(body, given, given, xi, state_of(1.0, anchor=anchor))
    inertia = [body.kap + (body.eps * math.sin(angle)) ** 2 for angle in (0.25, 1.0)]
    assert after.anchor.excess == pytest.approx(0.5 * inertia[0] / inertia[1], rel=1e-15)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_where_the_rotation_turns_round_the_couple_does_too_and_the_grip_may_go(side):
    """Rolling up a slope, its couple helps friction to turn it; rolling down again it would need more than there is."""
    plane = hh.Plane(mu=0.056, slope=-0.388 * side, rolling_resistance=0.1)
    start = hh.Start.rolling(0.5865 * side, angle=-1.308 * side)
    with forced("interpreted"):
        motion = hh.simulate(hh.Hoop.ideal(0.3423), plane, start, duration=0.3)
    turn, slip = motion.events[1:3]
    assert [(event.kind, event.from_mode, event.to_mode) for event in (turn, slip)] == [
        ("turn", "R", "R"),
        ("slip_start", "R", "S" if side > 0.0 else "K"),
    ]
    assert (turn.t, turn.omega) == (slip.t, 0.0)
    body = motion.scenario.to_body()
    shares = []
    for omega in (1e-9 * side, -1e-9 * side):
        friction, normal = interpreted(forces_rolling)(body, math.sin(turn.angle), math.cos(turn.angle), omega)
        shares.append(abs(friction) / normal)
    assert shares[0] < body.mu_s < shares[1]


@pytest.mark.parametrize("offset", [1e-100, -1e-30])
def test_a_slow_start_in_a_short_time(offset):
    """δ cosh λt beside the top, λ² = ε/(κ + (1 + ε)²): so slow that a panel of the usual width would last much too long."""
    body = body_of()
    rate = math.sqrt(body.eps / (body.kap + (1.0 + body.eps) ** 2))
    events, none = np.empty(10, EVENT), np.empty(0, SEGMENT)
    for t_end in (0.5, 2.0):
        status, count, _ = interpreted(run)(body, state_of(offset), t_end, math.nan, 0, events, none, new_scratch(), events[:0])
        assert (status, count) == (Status.COMPLETED, 2)
        assert events["angle"][1] == pytest.approx(offset * math.cosh(rate * t_end), rel=1e-13, abs=0.0)
        assert events["omega"][1] == pytest.approx(offset * rate * math.sinh(rate * t_end), rel=1e-12, abs=0.0)


@pytest.mark.parametrize("f", [0.0, 0.05])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_rolling_lasts_until_it_needs_all_friction(f, side):
    """With the couple of rolling resistance too: |F| = μ N where slip starts, by the closed forms."""
    with forced("interpreted"):
        motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(rolling_resistance=f), hh.Start.rolling(3.1 * side), duration=1.0)
    slip, body = motion.find("slip_start")[0], motion.scenario.to_body()
    om = slip.omega * motion.units.time
    friction, normal = interpreted(forces_rolling)(body, math.sin(slip.angle), math.cos(slip.angle), om)
    assert abs(friction) == pytest.approx(body.mu_s * normal, rel=1e-11)
    assert normal > 0.0


# a place on a solved panel


@pytest.mark.parametrize("xi", [-0.75, 0.3, -1.0 + 1e-7, 1.0 - 1e-7])
@pytest.mark.parametrize(("kind", "end"), [(LINEAR, None), (ARRIVE, 1.0), (LEAVE, -1.0)])
def test_a_small_square_of_the_speed_has_its_digits_beside_a_turning_point(kind, end, xi):
    """θ̇² = s² (1 + ξ/4), where s vanishes at the turning point."""

    def square(at):
        return (1.0 if end is None else (end - at) ** 2) * (1.0 + 0.25 * at)

    weights = np.empty(ORDER)
    interpreted(lagrange)(xi, weights)
    found = interpreted(contact_phase.u_between)(Given(kind=kind), xi, weights, square(NODES))
    assert found == pytest.approx(square(xi), rel=1e-13, abs=0.0)


STARTED = {"t": 3.0, "t_low": 1e-17, "x": 2.0, "x_low": -1e-17, "turns": 2.0, "friction": 0.125, "impact_n": 0.25}
STARTED |= {"impact_t": 0.375, "resisted": 0.5}


def solved_panel(body, sigma, th, om):
    """(panel, totals, state at its start, arrays) as the kernel chooses it."""
    scratch = new_scratch()
    state = state_of(th, om, 0.75 * sigma)._replace(**STARTED)
    state = interpreted(contact_phase.anchored)(body, sigma, state, scratch)
    panel, totals, _ = interpreted(contact_phase.choose_panel)(body, sigma, state, 2, scratch)
    assert totals.tail < 2e-13
    interpreted(contact_phase.fill_inside)(panel, scratch.work)
    return panel, totals, state, scratch


def followed(body, sigma, way, state, duration):
    """(x, θ, θ̇, v_t, friction's work, that of the rolling resistance) by Newton's and Euler's equations in time."""

    def rates(t, now):
        _, th, om, vt, _, _ = now
        ax, _, alpha, _, normal = accelerations(body, th, om, sigma or "roll", way * body.resist)
        work = sigma * body.mu_k * normal * vt
        return [vt + om, om, alpha, ax - alpha, work, body.resist * normal * om * way]

    start = [state.x, state.th, state.om, state.vt, state.friction, state.resisted]
    if duration == 0.0:
        return start
    found = solve_ivp(rates, (0.0, duration), start, method="DOP853", rtol=1e-12, atol=1e-13)
    return found.y[:, -1]


@pytest.mark.parametrize("resist", [0.0, 0.0625])
@pytest.mark.parametrize("sigma", [0, 1, -1])
@pytest.mark.parametrize(
    ("kind", "th", "om"),
    [(LINEAR, 2.0, 1.5), (LINEAR, 2.0, -1.5), (LEAVE, 2.0, 0.0), (ARRIVE, 1.0, -0.25), (ARRIVE, 5.0, 0.25)],
)
def test_a_place_on_a_panel_is_where_the_hoop_comes_to(kind, th, om, sigma, resist):
    body = body_of(slope=0.125, mu=0.25, rolling_resistance=resist)
    panel, totals, state, scratch = solved_panel(body, sigma, th, om)
    assert panel.kind == kind
    for xi in (-1.0, -0.5, 0.375, 1.0):
        after = interpreted(contact_phase.state_on_panel)(body, panel, totals, state, xi, scratch)
        expected = followed(body, sigma, panel.way, state, after.t - state.t)
        found = [after.x, after.th, after.om, after.vt, after.friction, after.resisted]
        assert found == pytest.approx(expected, rel=1e-11, abs=1e-11)
        assert (after.t > state.t) == (xi > -1.0)
        assert (after.y, after.vn, after.turns, after.impact_n, after.impact_t) == (0.0, 0.0, 2.0, 0.25, 0.375)
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
        after = interpreted(contact_phase.state_on_panel)(body, panel, totals, state, -1.0 + place * 2.0**-53, scratch)
        assert after.t >= 0.0


# slip without rotation, and rest


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("slope", [0.25, -0.25, 0.75])
def test_slip_that_does_not_turn_is_slowed_as_a_block_is(sigma, slope):
    """v̇_t = g_t − σ μ g_n: it stops where that goes against it."""
    body = body_of(slope=slope, mu=0.5)
    rate = math.sin(slope) - sigma * 0.5 * math.cos(slope)
    found, until = interpreted(contact_phase.frozen_end)(body, sigma, 3.0 * sigma)
    assert found == pytest.approx(rate, rel=1e-14)
    assert until == (pytest.approx(-3.0 * sigma / rate, rel=1e-14) if sigma * rate < 0.0 else math.inf)


def log_of(room=10):
    scratch = new_scratch()
    return interpreted(new_log)(np.zeros(room, EVENT), np.zeros(room, SEGMENT), scratch), scratch


def sliding(sigma, th=math.pi):
    """Slip over the load, which does not turn at θ = π without friction on the load's arm."""
    mode = contact_phase.SKID if sigma > 0 else contact_phase.SPIN
    state = state_of(th, 0.0, 1.5 * sigma)._replace(**STARTED)
    return Phase(mode, state, False, 0, 0.0, 5, 0.75, 0, -1)


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("at_stop", [0.5, 1.0, 50.0])
def test_slip_without_rotation_lasts_until_it_stops_or_time_is_over(at_stop, sigma):
    """The distance, the speed and friction's work are those of a block; a stop at the very end of time comes first."""
    body = body_of(slope=0.25, mu=0.5)
    log, _ = log_of()
    rate, until = interpreted(contact_phase.frozen_end)(body, sigma, 1.5 * sigma)
    phase = sliding(sigma)
    state = phase.state._replace(t=0.0, t_low=0.0) if at_stop == 1.0 else phase.state
    t_end = state.t + at_stop * until
    what, after = interpreted(contact_phase.hold)(body, phase.mode, state, t_end, log)
    stops = at_stop >= 1.0
    tau = until if stops else 0.5 * until
    slid = 1.5 * sigma * tau + 0.5 * rate * tau * tau
    assert what == (contact_phase.STOP if stops else contact_phase.LIMIT)
    assert after.t + after.t_low == pytest.approx(state.t + tau, rel=1e-15)
    if not stops:
        assert (after.t, after.t_low) == (t_end, 0.0)
    assert after.x == pytest.approx(2.0 + slid, rel=1e-14)
    assert after.vt == (0.0 if stops else pytest.approx(0.75 * sigma, rel=1e-14))
    assert after.friction == pytest.approx(0.125 + 0.5 * math.cos(0.25) * abs(slid), rel=1e-14)
    assert after[4:8] == state[4:8]
    assert (after.y, after.vn, after.om) == (0.0, 0.0, 0.0)
    assert (after.impact_n, after.impact_t, after.resisted) == (0.25, 0.375, 0.5)
    assert log.written[:2].tolist() == [0, 1]
    row = log.segments[0]
    assert (row["t"], row["t_end"], row["mode"], row["sigma"], row["kind"]) == (state.t, after.t, phase.mode, sigma, HOLD)
    assert (row["opening"], row["xi"], row["way"]) == (rate, 0.0, 0.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("resist", [0.0, 0.0625])
def test_rest_is_stable_in_a_valley_or_where_the_couple_holds_it_with_some_left(side, resist):
    stable = interpreted(contact_phase.equilibrium_is_stable)
    level = body_of(rolling_resistance=resist)
    assert stable(level, math.pi * side)
    assert stable(level, 0.0) is (resist > 0.0)
    held = math.asin(0.0625 / 0.75)  # ε sin θ = f
    if resist > 0.0:
        assert stable(level, side * held * 0.999)
        assert not stable(level, side * held * 1.001)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_rest_on_a_slope_is_held_by_what_the_weight_on_the_slope_gives(side):
    """Beside the hilltop, where ε sin(θ + β) + sin β = f cos β at most."""
    body = body_of(slope=0.8 * side, rolling_resistance=0.01)
    for part in (-1.001, -0.999, 0.999, 1.001):
        th = math.asin((part * 0.01 * math.cos(0.8) - math.sin(0.8)) / 0.75) - 0.8
        assert interpreted(contact_phase.equilibrium_is_stable)(body, side * th) is (abs(part) < 1.0)


def test_rest_held_by_all_the_couple_and_rest_of_a_ring_are_not_stable():
    body = body_of(rolling_resistance=0.1)
    needed = interpreted(torque_at_rest)(body, math.sin(0.1), math.cos(0.1))
    assert not interpreted(contact_phase.equilibrium_is_stable)(body._replace(resist=needed), 0.1)
    ring = hh.Scenario(hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=1.0)).to_body()
    assert not interpreted(contact_phase.equilibrium_is_stable)(ring, 1.0)


@pytest.mark.parametrize(("th", "stable"), [(math.pi, 1), (0.0, 0)])
def test_rest_is_written_as_an_event_and_lasts_to_the_end_of_time(th, stable):
    log, scratch = log_of()
    state = state_of(th)._replace(**STARTED)
    phase = Phase(contact_phase.ROLL, state, False, 0, 0.0, 5, 0.75, 0, -1)
    limits = interpreted(limits_of)(state, 8.0, math.nan, 0)
    after = interpreted(contact_phase.still_step)(body_of(), phase, state, limits, log, scratch)
    assert (after.mode, after.what, after.status) == (contact_phase.ROLL, contact_phase.STILL, Status.AT_REST)
    assert after.state == state._replace(t=8.0, t_low=0.0)
    assert (after.bounce, after.begins) == (0.75, False)
    assert log.written[:2].tolist() == [1, 1]
    event, row = log.events[0], log.segments[0]
    assert (event["kind"], event["t"], event["stable"], event["gain"]) == (Event.REST, 3.0, stable, 0.0)
    assert (event["before_mode"], event["after_mode"]) == (contact_phase.ROLL, contact_phase.ROLL)
    assert (row["t"], row["t_end"], row["mode"], row["kind"], row["sigma"]) == (3.0, 8.0, contact_phase.ROLL, HOLD, 0)
    assert (row["xi"], row["opening"]) == (0.0, 0.0)


@pytest.mark.parametrize("gamma", [0.75, 1.0])
@pytest.mark.parametrize("sigma", [1, -1])
def test_after_slip_without_rotation_comes_what_the_mode_rule_says(sigma, gamma):
    """Rolling, as there is no torque; always of the hoop without mass. With the time over the motion ends in slip."""
    body = body_of(gamma)
    phase = sliding(sigma, 2.5 if gamma == 1.0 else math.pi)
    limits = interpreted(limits_of)(phase.state, 50.0, math.nan, 0)
    log, scratch = log_of()
    after = interpreted(contact_phase.still_step)(body, phase, phase.state, limits, log, scratch)
    assert (after.mode, after.what, after.status, after.bounce) == (contact_phase.ROLL, contact_phase.STOP, -1, 0.75)
    assert after.begins
    assert after.state.t == pytest.approx(6.0, rel=1e-15)
    assert log.events[:1][["kind", "before_mode", "after_mode"]].tolist() == [(Event.STICK, phase.mode, contact_phase.ROLL)]
    over = interpreted(contact_phase.still_step)(body, phase, phase.state, limits._replace(t_end=4.0), *log_of())
    assert (over.mode, over.what, over.status) == (phase.mode, contact_phase.LIMIT, Status.COMPLETED)


@pytest.mark.parametrize("slope", [0.0, *(0.05 * k for k in range(-17, 18) if k)])
def test_a_load_close_to_the_plane_rests_in_its_valley_to_the_rounding_of_the_angle(slope):
    """The inertia about the contact point is so small there that the rounding of θ turns the hoop quickly."""
    body = body_of(0.9999, slope)
    valley = math.pi - slope + math.asin(math.sin(slope) / body.eps)
    if abs(valley - math.pi) > 1.0:
        return
    for turn in (0.0, -2.0 * math.pi):
        for th in (math.nextafter(valley + turn, -9.0), valley + turn, math.nextafter(valley + turn, 9.0)):
            assert interpreted(contact_phase.is_still)(body, 0, state_of(0.0)._replace(th=th))
        assert not interpreted(contact_phase.is_still)(body, 0, state_of(0.0)._replace(th=valley + turn + 1e-12))


@pytest.mark.parametrize("slope", [0.05 * k for k in range(-8, 9)])
def test_a_ring_that_rolling_resistance_holds_on_a_slope_stays(slope):
    ring = hh.Scenario(hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=0.7), plane=hh.Plane(slope=slope, rolling_resistance=0.5))
    for th in (0.0, 1.0, -4.0):
        assert interpreted(contact_phase.is_still)(ring.to_body(), 0, state_of(th))


def test_without_gravity_what_does_not_turn_stays():
    assert interpreted(contact_phase.is_still)(body_of(gravity=0.0), 0, state_of(1.0))


def test_the_massless_hoop_stays_where_it_slips_or_has_its_load_on_the_plane():
    stays, massless = interpreted(contact_phase.stays), body_of(1.0)
    for sigma in (1, -1):
        assert stays(massless, sigma, state_of(1.0))
        assert not stays(body_of(), sigma, state_of(1.0))
    for th in (math.pi, math.pi - 1e-9):  # as the first phase asks for it: to the rounding of cos θ
        assert stays(massless, 0, state_of(th))
    for th in (1.0, 2.0):
        assert not stays(massless, 0, state_of(th))
    assert not stays(body_of(), 0, state_of(2.0))


# what follows


def phase_at(mode, state, level=5):
    return Phase(mode, state, False, 0, 0.0, level, 0.75, 0, -1)


def events_of(log):
    return [tuple(row) for row in log.events[: log.written[0]][["kind", "before_mode", "after_mode"]].tolist()]


ROLL, SPIN, SKID, FLIGHT = (contact_phase.ROLL, contact_phase.SPIN, contact_phase.SKID, contact_phase.FLIGHT)


def test_rolling_that_cannot_be_followed_ends_in_doubt():
    log, scratch = log_of()
    state = state_of(1.0, 0.5)._replace(t=3.0)
    after = interpreted(contact_phase.after_rolling)(body_of(), phase_at(ROLL, state), contact_phase.STUCK, state, log, scratch)
    assert (after.mode, after.what, after.status) == (ROLL, contact_phase.STUCK, Status.UNDETERMINED)
    assert scratch.doubt.tolist() == [3.0, 3.0]
    assert events_of(log) == []


@pytest.mark.parametrize(
    ("what", "om", "mode"),
    [("CONE_AHEAD", 0.5, SPIN), ("CONE_BACK", 0.5, SKID), ("CONE_AHEAD", 2.0, FLIGHT), ("CONE_BACK", 2.0, FLIGHT)],
)
def test_after_rolling_that_needs_all_friction_it_slips_against_it_or_flies(what, om, mode):
    """It flies where ε θ̇² > g at the top; v_t begins with its second derivative where the friction is the same in slip."""
    what = getattr(panel_events, what)
    state = state_of(0.0, om)._replace(t=3.0)
    for mu_k, zeros in ((0.5, 2), (0.25, 1)):
        log, scratch = log_of()
        body = body_of()._replace(mu_k=mu_k)
        after = interpreted(contact_phase.after_rolling)(body, phase_at(ROLL, state), what, state, log, scratch)
        assert (after.mode, after.what, after.status, after.begins, after.bounce) == (mode, what, -1, True, 0.75)
        assert mode == FLIGHT or after.zeros == zeros
        assert events_of(log) == [(Event.TAKEOFF if mode == FLIGHT else Event.SLIP_START, ROLL, mode)]


@pytest.mark.parametrize("mode", [SPIN, SKID])
def test_slip_that_lifts_off_flies(mode):
    log, scratch = log_of()
    state = state_of(0.0, 2.0, 1.0 if mode == SKID else -1.0)
    after = interpreted(contact_phase.after_slip)(body_of(), phase_at(mode, state), contact_phase.LIFT, state, log, scratch)
    assert (after.mode, after.what, after.status, after.zeros) == (FLIGHT, contact_phase.LIFT, -1, 3)
    assert events_of(log) == [(Event.TAKEOFF, mode, FLIGHT)]


@pytest.mark.parametrize("mode", [SPIN, SKID])
def test_slip_that_ends_rolls_where_it_can(mode):
    log, scratch = log_of()
    state = state_of(3.0, 0.5)
    after = interpreted(contact_phase.after_slip)(body_of(), phase_at(mode, state), contact_phase.STOP, state, log, scratch)
    assert (after.mode, after.what, after.status, after.bounce) == (ROLL, contact_phase.STOP, -1, 0.75)
    assert events_of(log) == [(Event.STICK, mode, ROLL)]


def turned(mode, th, vt=0.0, stop=0, **plane):
    """What follows a turning point there, and what is written."""
    log, scratch = log_of()
    state = state_of(th, 0.0, vt)._replace(t=3.0)
    limits = interpreted(limits_of)(state, 8.0, math.nan, stop)
    phase = phase_at(mode, state)
    after = interpreted(contact_phase.turned_step)(body_of(**plane), phase, state, 7, limits, log, scratch)
    return after, events_of(log)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_where_rolling_turns_it_rests_rolls_back_or_slips(side):
    """By the torque ε sin θ against f, and by tan of the angle of the force against μ."""
    resist = {"rolling_resistance": 0.125}
    after, events = turned(ROLL, side * 0.1, **resist)
    assert (after.mode, after.status, after.state.t) == (ROLL, Status.AT_REST, 8.0)
    assert events == [(Event.REST, ROLL, ROLL)]
    after, events = turned(ROLL, side * 1.0, **resist)
    assert (after.mode, after.status, after.what, after.level, after.begins) == (ROLL, -1, contact_phase.TURNED, 7, False)
    assert events == [(Event.TURN, ROLL, ROLL)]
    after, events = turned(ROLL, side * 1.0, stop=STOP_AT_TURN, **resist)
    assert (after.mode, after.status, after.what) == (ROLL, Status.COMPLETED, contact_phase.TURNED)
    assert events == [(Event.TURN, ROLL, ROLL)]
    slip = SPIN if side > 0.0 else SKID
    after, events = turned(ROLL, side * 1.0, mu=0.125, **resist)
    assert (after.mode, after.status, after.what, after.begins, after.bounce) == (slip, -1, contact_phase.TURNED, True, 0.75)
    assert events == [(Event.TURN, ROLL, ROLL), (Event.SLIP_START, ROLL, slip)]
    after, events = turned(ROLL, side * 1.0, mu=0.125, stop=STOP_AT_TURN, **resist)
    assert (after.mode, after.status, after.what) == (ROLL, Status.COMPLETED, contact_phase.TURNED)
    assert events == [(Event.TURN, ROLL, ROLL)]


@pytest.mark.parametrize("sigma", [1, -1])
def test_where_slip_turns_it_goes_on(sigma):
    mode = SKID if sigma > 0 else SPIN
    for stop, status in ((0, -1), (STOP_AT_TURN, Status.COMPLETED)):
        after, events = turned(mode, 2.0, 0.5 * sigma, stop, rolling_resistance=0.125)
        assert (after.mode, after.status, after.what) == (mode, status, contact_phase.TURNED)
        assert events == [(Event.TURN, mode, mode)]


@pytest.mark.parametrize("sigma", [1, -1])
def test_slip_without_rotation_that_stops_on_a_slope_turns_round(sigma):
    """Without friction it slides back."""
    mode, other = (SKID, SPIN) if sigma > 0 else (SPIN, SKID)
    body = body_of(mu=0.0, slope=-0.25 * sigma)
    phase = sliding(sigma)
    limits = interpreted(limits_of)(phase.state, 50.0, math.nan, 0)
    log, scratch = log_of()
    after = interpreted(contact_phase.still_step)(body, phase, phase.state, limits, log, scratch)
    assert (after.mode, after.what, after.status) == (other, contact_phase.STOP, -1)
    assert events_of(log) == [(Event.SLIP_REVERSAL, mode, other)]


def test_the_massless_hoop_skims_where_rolling_has_no_force_left():
    """And one with inertia 1 slips."""
    state = state_of(1.0, 0.5)
    log, scratch = log_of()
    after = interpreted(contact_phase.after_rolling)(
        body_of(1.0), phase_at(ROLL, state), panel_events.CONE_AHEAD, state, log, scratch
    )
    assert (after.mode, events_of(log)) == (int(Mode.SKIM), [(Event.SKIM, ROLL, Mode.SKIM)])
    log, scratch = log_of()
    heavy = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=1.0), plane=hh.Plane(mu=0.5)).to_body()
    after = interpreted(contact_phase.after_rolling)(heavy, phase_at(ROLL, state), panel_events.CONE_AHEAD, state, log, scratch)
    assert (after.mode, events_of(log)) == (SPIN, [(Event.SLIP_START, ROLL, SPIN)])


def moved_by_kernel(body, state, t_end, stop=0):
    """(status, kinds of the events, events, number of segments)."""
    events, segments = np.empty(40, EVENT), np.empty(2000, SEGMENT)
    status, count, pieces = interpreted(run)(body, state, t_end, math.nan, stop, events, segments, new_scratch(), events[:0])
    return status, [Event(kind).name for kind in events["kind"][:count]], events[:count], pieces


def test_a_motion_without_duration_has_no_pieces():
    status, kinds, _, pieces = moved_by_kernel(body_of(), state_of(2.0, 0.5), 0.0)
    assert (status, kinds, pieces) == (Status.COMPLETED, ["START", "END"], 0)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_ring_that_rolling_resistance_stops_is_at_rest(side):
    """After ω (1 + κ)/f; it does not turn round."""
    body = hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=1.0), plane=hh.Plane(mu=0.5, rolling_resistance=0.1)
    ).to_body()
    status, kinds, events, _ = moved_by_kernel(body, state_of(1.0, 0.25 * side), 20.0)
    assert (status, kinds) == (Status.AT_REST, ["START", "REST", "END"])
    assert events["t"][1] == pytest.approx(0.25 * 2.0 / 0.1, rel=1e-13)


@pytest.mark.parametrize("resist", [0.0, 0.01])
def test_a_swing_ends_at_its_first_turning_point_only_if_asked(resist):
    body = body_of(rolling_resistance=resist)
    for stop in (0, STOP_AT_TAKEOFF):
        status, kinds, _, _ = moved_by_kernel(body, state_of(2.5), 20.0, stop)
        assert (status, kinds) == (Status.COMPLETED, ["START", *["TURN"] * (len(kinds) - 2), "END"])
        assert len(kinds) > 4
    status, kinds, _, _ = moved_by_kernel(body, state_of(2.5), 20.0, STOP_AT_TURN)
    assert (status, kinds) == (Status.COMPLETED, ["START", "TURN", "END"])


def test_slip_that_ends_goes_on_where_only_a_turning_point_is_asked_for():
    status, kinds, _, _ = moved_by_kernel(body_of(), state_of(2.5, 0.0, 0.5), 5.0, STOP_AT_TURN)
    assert status == Status.COMPLETED
    assert "STICK" in kinds
    assert kinds[-2:] == ["TURN", "END"]


@pytest.mark.parametrize("om", [1e-9, -1e-5])
def test_what_hardly_moves_is_followed_in_panels_of_the_time_that_there_is(om):
    """A ring rolls on as it is; one panel is the whole motion."""
    status, kinds, events, pieces = moved_by_kernel(body_of(0.0), state_of(2.0, om), 0.25)
    assert (status, kinds, pieces) == (Status.COMPLETED, ["START", "END"], 1)
    assert events["after_mode"][1] == ROLL
    assert (events["theta"][1] - 2.0) + events["theta_low"][1] == pytest.approx(0.25 * om, rel=1e-12)
    assert events["x"][1] == pytest.approx(0.25 * om, rel=1e-12)


def test_a_swing_within_the_rounding_of_the_angle_turns_before_it_rests():
    status, kinds, events, _ = moved_by_kernel(body_of(), state_of(math.pi, 1e-17), 20.0)
    assert (status, kinds) == (Status.AT_REST, ["START", "TURN", "REST", "END"])
    assert events["omega"].tolist() == [1e-17, 0.0, 0.0, 0.0]
