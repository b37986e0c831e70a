"""What follows rolling and slip that end, or turn round, and slip or rest without rotation."""

from __future__ import annotations

import math

import pytest

from hophoop.kernel.panels.panel import HOLD
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.physics.contact import torque_at_rest
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import STOP_AT_TURN, Ending
from rigid.tools import (
    FLIGHT,
    ROLL,
    SKID,
    SPIN,
    STARTED,
    body_of,
    limits,
    motion_of,
    moves,
    phase_at,
    sliding,
    state_of,
    written,
)

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel
SIDES = pytest.mark.parametrize("side", [1, -1])


def slip_of(side):
    """The modes of slip to a side, and to the other one."""
    return (SKID, SPIN) if side > 0 else (SPIN, SKID)


def test_rolling_that_cannot_be_followed_ends_in_doubt():
    state = state_of(1.0, 0.5, t=3.0)
    after, events, _, doubt = written(contact_phase.after_rolling, body_of(), phase_at(ROLL, state), Ending.SEARCH_LIMIT, state)
    assert (after.mode, after.ending, after.status) == (ROLL, Ending.SEARCH_LIMIT, Status.UNDETERMINED)
    assert (moves(events), doubt) == ([], [3.0])


@pytest.mark.parametrize(("ending", "slips"), [(Ending.CONE_FORWARD, SPIN), (Ending.CONE_BACKWARD, SKID)])
def test_after_rolling_that_needs_all_friction_it_slips_against_it_or_flies(ending, slips):
    """It flies where ε θ̇² > g at the top; v_t begins with its second derivative where the friction is the same in slip."""
    for om, mode, kind in ((0.5, slips, Event.SLIP_START), (2.0, FLIGHT, Event.TAKEOFF)):
        state = state_of(0.0, om, t=3.0)
        for mu_k, vanishing in ((0.5, 2), (0.25, 1)):
            body = body_of()._replace(mu_k=mu_k)
            after, events, _, _ = written(contact_phase.after_rolling, body, phase_at(ROLL, state), ending, state)
            assert (after.mode, after.ending, after.status, after.begins) == (mode, ending, -1, True)
            assert mode == FLIGHT or contact_phase.vanishing_slip_derivatives(body, after) == vanishing
            assert moves(events) == [(kind, ROLL, mode)]


@SIDES
def test_slip_that_ends_rolls_where_it_can_and_flies_where_it_lifts_off(side):
    mode, _ = slip_of(side)
    for ending, state, after_it, kind in (
        (Ending.LIFT_OFF, state_of(0.0, 2.0, side), FLIGHT, Event.TAKEOFF),
        (Ending.SLIP_END, state_of(3.0, 0.5), ROLL, Event.STICK),
    ):
        after, events, _, _ = written(contact_phase.after_slip, body_of(), phase_at(mode, state), ending, state)
        assert (after.mode, after.ending, after.status) == (after_it, ending, -1)
        assert moves(events) == [(kind, mode, after_it)]


@SIDES
def test_where_rolling_or_slip_turns_it_rests_goes_on_or_slips(side):
    """Rolling by the torque ε sin θ against f, and by tan of the angle of the force against μ."""
    _, slip = slip_of(side)  # the load drives the rim that it turns

    def turned(mode, th, vt=0.0, stop=0, mu=0.5):
        state = state_of(side * th, 0.0, vt, t=3.0)
        body = body_of(mu=mu, rolling_resistance=0.125)
        after, events, _, _ = written(
            contact_phase.turning_point_step, body, phase_at(mode, state), state, 7, limits(state, 8.0, stop=stop)
        )
        assert after.state.t == (8.0 if after.status == Status.AT_REST else 3.0)
        return after.mode, after.status, after.ending, after.begins, moves(events)

    turn = (Event.TURN, ROLL, ROLL)
    assert turned(ROLL, 0.1) == (ROLL, Status.AT_REST, Ending.REST, False, [(Event.REST, ROLL, ROLL)])
    assert turned(ROLL, 1.0) == (ROLL, -1, Ending.TURNING_POINT, False, [turn])
    begun = [turn, (Event.SLIP_START, ROLL, slip)]
    assert turned(ROLL, 1.0, mu=0.125) == (slip, -1, Ending.TURNING_POINT, True, begun)
    for mu in (0.5, 0.125):
        assert turned(ROLL, 1.0, stop=STOP_AT_TURN, mu=mu)[1:] == (Status.COMPLETED, Ending.TURNING_POINT, False, [turn])
    mode, _ = slip_of(side)
    for stop, status in ((0, -1), (STOP_AT_TURN, Status.COMPLETED)):
        found = turned(mode, 2.0, 0.5 * side, stop)
        assert found == (mode, status, Ending.TURNING_POINT, False, [(Event.TURN, mode, mode)])


def test_what_hardly_moves_is_followed_in_panels_of_the_time_that_there_is():
    """A ring rolls on as it is; one panel is the whole motion."""
    for om in (1e-9, -1e-5):
        status, events, segments = motion_of(body_of(0.0), state_of(2.0, om), 0.25)
        assert (status, len(segments), moves(events[1:])) == (Status.COMPLETED, 1, [(Event.END, ROLL, ROLL)])
        assert (events["theta"][1] - 2.0) + events["theta_low"][1] == pytest.approx(0.25 * om, rel=1e-12)
        assert events["x"][1] == pytest.approx(0.25 * om, rel=1e-12)
    _, events, segments = motion_of(body_of(), state_of(2.0, 0.5), 0.0)
    assert (events["kind"].tolist(), len(segments)) == ([Event.START, Event.END], 1)  # no time at all


def test_a_swing_within_the_rounding_of_the_angle_turns_before_it_rests():
    status, events, _ = motion_of(body_of(), state_of(math.pi, 1e-17), 20.0)
    assert (status, events["kind"].tolist()) == (Status.AT_REST, [Event.START, Event.TURN, Event.REST, Event.END])
    assert events["omega"].tolist() == [1e-17, 0.0, 0.0, 0.0]


# slip without rotation, and rest


@SIDES
@pytest.mark.parametrize("at_stop", [0.5, 1.0, 50.0])
def test_slip_without_rotation_lasts_until_it_stops_or_time_is_over(at_stop, side):
    """The distance, the speed and friction's work are those of a block; a stop at the very end of time comes first."""
    body = body_of(slope=0.25)
    rate = math.sin(0.25) - side * 0.5 * math.cos(0.25)
    until = -1.5 * side / rate
    phase = sliding(side)
    state = phase.state._replace(t=0.0, t_low=0.0) if at_stop == 1.0 else phase.state
    t_end = state.t + at_stop * until
    (ending, after), events, segments, _ = written(contact_phase.slide_without_rotation, body, phase.mode, state, t_end)
    stops = at_stop >= 1.0
    tau = until if stops else 0.5 * until
    slid = 1.5 * side * tau + 0.5 * rate * tau * tau
    assert ending == (Ending.SLIP_END if stops else Ending.TIME_LIMIT)
    expected = {
        "t": state.t + tau, "x": 2.0 + slid, "vt": 0.0 if stops else 0.75 * side,
        "friction": 0.125 + 0.5 * math.cos(0.25) * abs(slid), "om": 0.0,
        "impact_n": 0.25, "impact_t": 0.375, "rolling_loss": 0.5,
    }  # fmt: skip
    assert {name: getattr(after, name) for name in expected} == pytest.approx(expected, rel=1e-14)
    assert after[4:8] == state[4:8]
    assert stops or (after.t, after.t_low) == (t_end, 0.0)
    assert (len(events), len(segments)) == (0, 1)
    row = segments[0]
    assert (row["t"], row["t_end"], row["mode"], row["sigma"], row["kind"]) == (state.t, after.t, phase.mode, side, HOLD)


@SIDES
@pytest.mark.parametrize("gamma", [0.75, 1.0])
def test_after_slip_without_rotation_comes_what_the_mode_rule_says(side, gamma):
    """Rolling, as there is no torque; always of the hoop without mass. With the time over the motion ends in slip."""
    phase = sliding(side, 2.5 if gamma == 1.0 else math.pi)

    def after(body, t_end=50.0):
        found, events, _, _ = written(contact_phase.still_step, body, phase, phase.state, limits(phase.state, t_end))
        return (found.mode, found.ending, found.status, found.state.t), moves(events)

    t = pytest.approx(6.0, rel=1e-15)
    assert after(body_of(gamma)) == ((ROLL, Ending.SLIP_END, -1, t), [(Event.STICK, phase.mode, ROLL)])
    assert after(body_of(gamma), 4.0)[0] == (phase.mode, Ending.TIME_LIMIT, Status.COMPLETED, 4.0)
    if gamma < 1.0:  # without friction it slides back down the slope
        _, other = slip_of(side)
        found, events = after(body_of(mu=0.0, slope=-0.25 * side))
        assert (found[0], events) == (other, [(Event.SLIP_REVERSAL, phase.mode, other)])


@SIDES
def test_rest_is_stable_in_a_valley_or_where_the_couple_holds_it_with_some_left(side):
    """On a slope where ε sin(θ + β) + sin β = f cos β at most; held by all of the couple, or a ring, it is not."""
    stable = contact_phase.equilibrium_is_stable
    for resist in (0.0, 0.0625):
        level = body_of(rolling_resistance=resist)
        assert stable(level, math.pi * side)
        assert stable(level, 0.0) is (resist > 0.0)
    for slope, resist in ((0.0, 0.0625), (0.8, 0.01)):
        body = body_of(slope=slope * side, rolling_resistance=resist)
        for part in (-1.001, -0.999, 0.999, 1.001):
            th = math.asin((part * resist * math.cos(slope) - math.sin(slope)) / 0.75) - slope
            assert stable(body, side * th) is (abs(part) < 1.0)
    needed = torque_at_rest(level, math.sin(0.05), math.cos(0.05))
    assert not stable(level._replace(resist=needed), 0.05)
    assert not stable(body_of(0.0), 1.0)


@pytest.mark.parametrize(("th", "stable"), [(math.pi, 1), (0.0, 0)])
def test_rest_is_written_as_an_event_and_lasts_to_the_end_of_time(th, stable):
    state = state_of(th, **STARTED)
    after, events, segments, _ = written(contact_phase.still_step, body_of(), phase_at(ROLL, state), state, limits(state, 8.0))
    assert (after.mode, after.ending, after.status, after.begins) == (ROLL, Ending.REST, Status.AT_REST, False)
    assert after.state == state._replace(t=8.0, t_low=0.0)
    assert moves(events) == [(Event.REST, ROLL, ROLL)]
    assert (events["t"][0], events["stable"][0], events["gain"][0]) == (3.0, stable, 0.0)
    names = ["t", "t_end", "mode", "kind", "sigma", "xi", "f_n"]
    assert segments[names].tolist() == [(3.0, 8.0, ROLL, HOLD, 0, 0.0, 0.0)]


def test_a_load_close_to_the_plane_rests_in_its_valley_to_the_rounding_of_the_angle():
    """The inertia about the contact point is so small there that the rounding of θ turns the hoop quickly."""
    for k in range(-17, 18):
        slope = 0.05 * k
        body = body_of(0.9999, slope=slope)
        valley = math.pi - slope + math.asin(math.sin(slope) / body.eps)
        for turn in (0.0, -2.0 * math.pi) if abs(valley - math.pi) <= 1.0 else ():
            for th in (math.nextafter(valley + turn, -9.0), valley + turn, math.nextafter(valley + turn, 9.0)):
                assert contact_phase.is_equilibrium(body, 0, state_of(0.0, th=th)), slope
            assert not contact_phase.is_equilibrium(body, 0, state_of(0.0, th=valley + turn + 1e-12)), slope


def test_what_nothing_turns_stays():
    """Without gravity, a ring that the couple holds, and the massless hoop that slips or has its load on the plane."""
    assert contact_phase.is_equilibrium(body_of(gravity=0.0), 0, state_of(1.0))
    assert contact_phase.is_equilibrium(body_of(0.0, 0.7, slope=0.4, rolling_resistance=0.5), 0, state_of(-4.0))
    stays, massless = contact_phase.remains_at_rest, body_of(1.0)
    for sigma in (1, -1):
        assert stays(massless, sigma, state_of(1.0))
        assert not stays(body_of(), sigma, state_of(1.0))
    for th in (math.pi, math.pi - 1e-9):  # as the first phase asks for it: to the rounding of cos θ
        assert stays(massless, 0, state_of(th))
    for th in (1.0, 2.0):
        assert not stays(massless, 0, state_of(th))
    assert not stays(body_of(), 0, state_of(2.0))
