"""Slip without rotation, and rest: what stays, how long, and what is written."""

from __future__ import annotations

import math

import pytest

import hophoop as hh
from contact_tools import STARTED, body_of, log_of, sliding, state_of
from hophoop.kernel.panels.panel import HOLD
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.physics.contact import torque_at_rest
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import Ending, Phase, limits_of

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("slope", [0.25, -0.25, 0.75])
def test_slip_that_does_not_turn_is_slowed_as_a_block_is(sigma, slope):
    """v̇_t = g_t − σ μ g_n: it stops where that goes against it."""
    body = body_of(slope=slope, mu=0.5)
    rate = math.sin(slope) - sigma * 0.5 * math.cos(slope)
    assert contact_phase.slip_rate_without_rotation(body, sigma) == pytest.approx(rate, rel=1e-14)
    assert contact_phase.slip_rate_without_rotation(body, 0) == 0.0  # it rests
    log, _ = log_of()
    mode = contact_phase.SKID if sigma > 0 else contact_phase.SPIN
    ending, after = contact_phase.slide_without_rotation(body, mode, state_of(math.pi, 0.0, 3.0 * sigma), 1e6, log)
    stops = sigma * rate < 0.0
    assert ending == (Ending.SLIP_END if stops else Ending.TIME_LIMIT)
    assert after.t == (pytest.approx(-3.0 * sigma / rate, rel=1e-14) if stops else 1e6)


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("at_stop", [0.5, 1.0, 50.0])
def test_slip_without_rotation_lasts_until_it_stops_or_time_is_over(at_stop, sigma):
    """The distance, the speed and friction's work are those of a block; a stop at the very end of time comes first."""
    body = body_of(slope=0.25, mu=0.5)
    log, _ = log_of()
    rate = contact_phase.slip_rate_without_rotation(body, sigma)
    until = -1.5 * sigma / rate
    phase = sliding(sigma)
    state = phase.state._replace(t=0.0, t_low=0.0) if at_stop == 1.0 else phase.state
    t_end = state.t + at_stop * until
    ending, after = contact_phase.slide_without_rotation(body, phase.mode, state, t_end, log)
    stops = at_stop >= 1.0
    tau = until if stops else 0.5 * until
    slid = 1.5 * sigma * tau + 0.5 * rate * tau * tau
    assert ending == (Ending.SLIP_END if stops else Ending.TIME_LIMIT)
    assert after.t + after.t_low == pytest.approx(state.t + tau, rel=1e-15)
    if not stops:
        assert (after.t, after.t_low) == (t_end, 0.0)
    assert after.x == pytest.approx(2.0 + slid, rel=1e-14)
    assert after.vt == (0.0 if stops else pytest.approx(0.75 * sigma, rel=1e-14))
    assert after.friction == pytest.approx(0.125 + 0.5 * math.cos(0.25) * abs(slid), rel=1e-14)
    assert after[4:8] == state[4:8]
    assert (after.y, after.vn, after.om) == (0.0, 0.0, 0.0)
    assert (after.impact_n, after.impact_t, after.rolling_loss) == (0.25, 0.375, 0.5)
    assert log.counts[:2].tolist() == [0, 1]
    row = log.segments[0]
    assert (row["t"], row["t_end"], row["mode"], row["sigma"], row["kind"]) == (state.t, after.t, phase.mode, sigma, HOLD)
    assert (row["f_n"], row["xi"], row["direction"]) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("resist", [0.0, 0.0625])
def test_rest_is_stable_in_a_valley_or_where_the_couple_holds_it_with_some_left(side, resist):
    stable = contact_phase.equilibrium_is_stable
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
        assert contact_phase.equilibrium_is_stable(body, side * th) is (abs(part) < 1.0)


def test_rest_held_by_all_the_couple_and_rest_of_a_ring_are_not_stable():
    body = body_of(rolling_resistance=0.1)
    needed = torque_at_rest(body, math.sin(0.1), math.cos(0.1))
    assert not contact_phase.equilibrium_is_stable(body._replace(resist=needed), 0.1)
    ring = hh.Scenario(hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=1.0)).to_body()
    assert not contact_phase.equilibrium_is_stable(ring, 1.0)


@pytest.mark.parametrize(("th", "stable"), [(math.pi, 1), (0.0, 0)])
def test_rest_is_written_as_an_event_and_lasts_to_the_end_of_time(th, stable):
    log, _ = log_of()
    state = state_of(th)._replace(**STARTED)
    phase = Phase(contact_phase.ROLL, state, False, 5, Ending.CONTINUES, -1)
    limits = limits_of(state, 8.0, math.nan, 0, 0)
    after = contact_phase.still_step(body_of(), phase, state, limits, log)
    assert (after.mode, after.ending, after.status) == (contact_phase.ROLL, Ending.REST, Status.AT_REST)
    assert after.state == state._replace(t=8.0, t_low=0.0)
    assert after.begins is False
    assert log.counts[:2].tolist() == [1, 1]
    event, row = log.events[0], log.segments[0]
    assert (event["kind"], event["t"], event["stable"], event["gain"]) == (Event.REST, 3.0, stable, 0.0)
    assert (event["before_mode"], event["after_mode"]) == (contact_phase.ROLL, contact_phase.ROLL)
    assert (row["t"], row["t_end"], row["mode"], row["kind"], row["sigma"]) == (3.0, 8.0, contact_phase.ROLL, HOLD, 0)
    assert (row["xi"], row["f_n"]) == (0.0, 0.0)


@pytest.mark.parametrize("gamma", [0.75, 1.0])
@pytest.mark.parametrize("sigma", [1, -1])
def test_after_slip_without_rotation_comes_what_the_mode_rule_says(sigma, gamma):
    """Rolling, as there is no torque; always of the hoop without mass. With the time over the motion ends in slip."""
    body = body_of(gamma)
    phase = sliding(sigma, 2.5 if gamma == 1.0 else math.pi)
    limits = limits_of(phase.state, 50.0, math.nan, 0, 0)
    log, _ = log_of()
    after = contact_phase.still_step(body, phase, phase.state, limits, log)
    assert (after.mode, after.ending, after.status) == (contact_phase.ROLL, Ending.SLIP_END, -1)
    assert after.begins
    assert after.state.t == pytest.approx(6.0, rel=1e-15)
    assert log.events[:1][["kind", "before_mode", "after_mode"]].tolist() == [(Event.STICK, phase.mode, contact_phase.ROLL)]
    over = contact_phase.still_step(body, phase, phase.state, limits._replace(t_end=4.0), log_of()[0])
    assert (over.mode, over.ending, over.status) == (phase.mode, Ending.TIME_LIMIT, Status.COMPLETED)


@pytest.mark.parametrize("slope", [0.0, *(0.05 * k for k in range(-17, 18) if k)])
def test_a_load_close_to_the_plane_rests_in_its_valley_to_the_rounding_of_the_angle(slope):
    """The inertia about the contact point is so small there that the rounding of θ turns the hoop quickly."""
    body = body_of(0.9999, slope)
    valley = math.pi - slope + math.asin(math.sin(slope) / body.eps)
    if abs(valley - math.pi) > 1.0:
        return
    for turn in (0.0, -2.0 * math.pi):
        for th in (math.nextafter(valley + turn, -9.0), valley + turn, math.nextafter(valley + turn, 9.0)):
            assert contact_phase.is_equilibrium(body, 0, state_of(0.0)._replace(th=th))
        assert not contact_phase.is_equilibrium(body, 0, state_of(0.0)._replace(th=valley + turn + 1e-12))


@pytest.mark.parametrize("slope", [0.05 * k for k in range(-8, 9)])
def test_a_ring_that_rolling_resistance_holds_on_a_slope_stays(slope):
    ring = hh.Scenario(hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=0.7), plane=hh.Plane(slope=slope, rolling_resistance=0.5))
    for th in (0.0, 1.0, -4.0):
        assert contact_phase.is_equilibrium(ring.to_body(), 0, state_of(th))


def test_without_gravity_what_does_not_turn_stays():
    assert contact_phase.is_equilibrium(body_of(gravity=0.0), 0, state_of(1.0))


def test_the_massless_hoop_stays_where_it_slips_or_has_its_load_on_the_plane():
    stays, massless = contact_phase.remains_at_rest, body_of(1.0)
    for sigma in (1, -1):
        assert stays(massless, sigma, state_of(1.0))
        assert not stays(body_of(), sigma, state_of(1.0))
    for th in (math.pi, math.pi - 1e-9):  # as the first phase asks for it: to the rounding of cos θ
        assert stays(massless, 0, state_of(th))
    for th in (1.0, 2.0):
        assert not stays(massless, 0, state_of(th))
    assert not stays(body_of(), 0, state_of(2.0))
