"""One flight: what ends it, and the state there, by the parabola of the centre of gravity and a constant rotation."""

from __future__ import annotations

import math

import pytest
from mpmath import mp, mpf

from contact_tools import body_of, log_of
from hophoop.kernel.panels.panel import FLY
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.records.layout import EVENTS, SEGMENTS
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import flight_phase
from hophoop.kernel.rigid.phase import STOP_AT_TAKEOFF, Ending, begin_phase, limits_of


def state_of(angle=0.5, *, y=0.0, vt=0.0, vn=0.0, om=0.0, time=0.0):
    return start_state(0.25, y, angle, vt, vn, om)._replace(t=time)


def limits(state, t_end=9.0, span=math.nan, stop=0):
    return limits_of(state, t_end, span, stop, 0)


def fly(body, state, given, vanishing=0):
    """(ending, state at the end, apexes, segment); with three vanishing derivatives the gap opens by rounding alone."""
    log, scratch = log_of()
    f_n = 0.0 if vanishing == 3 else body.eps * state.om**2 * math.cos(state.th) - body.gn
    ending, after = flight_phase.fly(body, state, f_n, vanishing, given, log)
    assert scratch.counts[SEGMENTS] == 1
    return ending, after, log.events[: scratch.counts[EVENTS]], log.segments[0]


def thrown(body, state, tau):
    """x, y, v_t and v_n of the lowest point of the rim after the time tau, in 30 digits."""
    with mp.workdps(30):
        th, om, eps = mpf(state.th), mpf(state.om), mpf(body.eps)
        end = th + om * tau
        speed_x, speed_y = state.vt + om * (1 + eps * mp.cos(th)), state.vn - om * eps * mp.sin(th)  # of G
        x = state.x + eps * (mp.sin(th) - mp.sin(end)) + speed_x * tau + body.gt * tau**2 / 2
        y = state.y + eps * (mp.cos(th) - mp.cos(end)) + speed_y * tau - body.gn * tau**2 / 2
        v_t = speed_x + body.gt * tau - om * (1 + eps * mp.cos(end))
        v_n = speed_y - body.gn * tau + om * eps * mp.sin(end)
        return [float(number) for number in (x, y, v_t, v_n)]


def check_end(body, state, after, tau):
    assert [after.x, after.y, after.vt, after.vn] == pytest.approx(thrown(body, state, tau), rel=1e-13, abs=1e-13)
    assert (after.om, after.t) == (state.om, pytest.approx(state.t + tau, rel=1e-15))


@pytest.mark.parametrize("om", [0.5, 1.0, 1.5, -0.5, -1.0, -1.5])
@pytest.mark.parametrize("slope", [0.0, 0.3])
def test_a_flight_ends_in_time_or_by_its_angle_or_on_the_plane(om, slope):
    body, state = body_of(slope=slope), state_of(y=0.5, vt=0.25, vn=1.0, om=om, time=2.0)
    ending, after, apexes, _ = fly(body, state, limits(state, 2.75))
    assert (ending, after.t, after.t_low) == (Ending.TIME_LIMIT, 2.75, 0.0)
    check_end(body, state, after, 0.75)
    ending, after, _, _ = fly(body, state, limits(state, 9.0, 0.25))
    assert (ending, after.revolutions, after.th) == (Ending.ANGLE_LIMIT, 0.0, 0.5 + math.copysign(0.25, om))
    check_end(body, state, after, 0.25 / abs(om))
    assert fly(body, state, limits(state, 2.0 + 0.2 / abs(om), 0.25))[0] == Ending.TIME_LIMIT
    ending, after, apexes, segment = fly(body, state, limits(state, 9.0, 100.0))
    assert ending == Ending.LANDING
    assert after.y == 0.0
    assert after.vn < 0.0
    check_end(body, state, after, after.t - 2.0)
    assert after.th + 2.0 * math.pi * after.revolutions == pytest.approx(0.5 + om * (after.t - 2.0), rel=1e-14)
    assert (segment["t"], segment["t_end"], segment["kind"], segment["mode"]) == (2.0, after.t, FLY, Mode.FLIGHT)
    for apex in apexes:
        tau = apex["t"] - 2.0
        assert (apex["kind"], apex["before_mode"], apex["after_mode"]) == (Event.APEX, Mode.FLIGHT, Mode.FLIGHT)
        assert [apex["x"], apex["height"], apex["slip"], apex["vy"]] == pytest.approx(thrown(body, state, tau), abs=1e-13)
        assert (apex["vy"], apex["omega"]) == (0.0, om)
        assert apex["height"] > max(thrown(body, state, tau + step)[1] for step in (-1e-3, 1e-3))
    assert len(apexes) == 1


def test_without_rotation_a_span_ends_nothing():
    state = state_of(y=0.5)
    ending, after, apexes, _ = fly(body_of(), state, limits(state, 9.0, 0.25))
    assert (ending, len(apexes)) == (Ending.LANDING, 0)
    assert after.t == pytest.approx(1.0, rel=1e-15)  # g t²/2 of R/2


@pytest.mark.parametrize("om", [0.5, -2.0])
def test_a_flight_that_begins_beyond_the_span_takes_no_time(om):
    """By a rounding of the angle: it ends where it is, and not before."""
    start = state_of(y=0.5, om=om)
    given = limits(start, 9.0, 0.25)
    state = start._replace(th=0.5 + math.copysign(0.25 + 1e-15, om))
    ending, after, _, _ = fly(body_of(), state, given)
    assert (ending, after.t, after.y) == (Ending.ANGLE_LIMIT, 0.0, 0.5)


@pytest.mark.parametrize("rise", [0.0, 1e-20])
def test_a_hop_of_nothing_lands_where_it_begins_and_never_upwards(rise):
    """Where rounding leaves no opening gap after a lift-off, the rim is on the plane at once."""
    state = state_of(vn=rise, time=1.0)
    ending, after, apexes, _ = fly(body_of(), state, limits(state), 3)
    assert (ending, after.t, after.y, after.vn, after.th) == (Ending.LANDING, 1.0, 0.0, 0.0, 0.5)
    assert len(apexes) == 0


@pytest.mark.parametrize("om", [3e8, -3e9])
def test_a_flight_ends_after_a_rotation_whose_angle_time_cannot_tell(om):
    body = body_of()
    state = state_of(0.5, y=2.0, vt=1e4, vn=1e6 + body.eps * om * math.sin(0.5), om=om)
    ending, after, _, _ = fly(body, state, limits(state, 1e12))
    assert ending == Ending.SEARCH_LIMIT
    assert (after.t - state.t) * abs(om) == pytest.approx(flight_phase.LONGEST_FLIGHT)


def step(state, stop, restitution=0.0):
    body = body_of(restitution=restitution)
    log, scratch = log_of()
    phase = begin_phase(int(Mode.FLIGHT), state, Ending.LANDING)
    after = flight_phase.flight_step(body, phase, limits(state, 9.0, stop=stop), log)
    return after, log.events["kind"][: scratch.counts[EVENTS]].tolist()


@pytest.mark.parametrize("time", [0.0, 1e-9, 0.5, 1.5])
def test_a_motion_that_may_end_at_a_takeoff_ends_as_it_takes_off(time):
    """A hoop that was thrown at t = 0 did not take off."""
    state = state_of(y=0.0 if time else 0.5, vn=0.5, time=time)
    after, kinds = step(state, STOP_AT_TAKEOFF)
    if time:
        assert (after.state, after.mode, after.status, kinds) == (state, Mode.FLIGHT, Status.COMPLETED, [])
    else:
        assert kinds == [Event.APEX, Event.IMPACT]


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_landing_gives_the_bounce_that_the_next_is_compared_with(restitution):
    after, kinds = step(state_of(y=0.5), 0, restitution)
    assert kinds == [Event.IMPACT]
    assert after.state.vn == pytest.approx(restitution)  # it comes with √(2 g R/2)
    assert after.ending == Ending.LANDING
    assert after.begins
