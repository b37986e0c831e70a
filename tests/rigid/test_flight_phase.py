"""One flight, and the fall of the massless hoop's load: what ends them, and the state there; when bounces are closed."""

from __future__ import annotations

import math

import pytest
from mpmath import mp, mpf

from hophoop.kernel.panels.panel import FLY, SKIMMING
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.rigid import flight_phase
from hophoop.kernel.rigid.phase import GOING, STOP_AT_TAKEOFF, Ending, begin_phase
from rigid.tools import FLIGHT, ROLL, SKID, SPIN, body_of, limits, motion_of, moves, state_of, written

SKIM = int(Mode.SKIM)


def fly(state, given, vanishing=0):
    """(ending, state at the end, apexes); with three vanishing derivatives the gap opens by rounding alone."""
    body = body_of()
    f_n = 0.0 if vanishing == 3 else body.eps * state.om**2 * math.cos(state.th) - body.gn
    (ending, after), apexes, segments, _ = written(flight_phase.fly, body, state, f_n, vanishing, given)
    assert segments[["kind", "mode", "t", "t_end"]].tolist() == [(FLY, FLIGHT, state.t, after.t)]
    return ending, after, apexes


def test_without_rotation_a_span_ends_nothing():
    state = state_of(0.5, y=0.5)
    ending, after, apexes = fly(state, limits(state, span=0.25))
    assert (ending, len(apexes)) == (Ending.LANDING, 0)
    assert after.t == pytest.approx(1.0, rel=1e-15)  # g t²/2 of R/2


@pytest.mark.parametrize("om", [0.5, -2.0])
def test_a_flight_ends_at_the_angle_of_its_span(om):
    """One that begins beyond it by a rounding of the angle takes no time; an angle that comes after the end of time is none."""
    start = state_of(0.5, om, y=0.5, vn=2.0)
    given = limits(start, span=0.25)
    ending, after, _ = fly(start, given)
    assert (ending, after.t, after.th) == (Ending.ANGLE_LIMIT, 0.25 / abs(om), 0.5 + math.copysign(0.25, om))
    assert fly(start, given._replace(t_end=0.2 / abs(om)))[0] == Ending.TIME_LIMIT
    ending, after, _ = fly(start._replace(th=0.5 + math.copysign(0.25 + 1e-15, om)), given)
    assert (ending, after.t, after.y) == (Ending.ANGLE_LIMIT, 0.0, 0.5)


@pytest.mark.parametrize("rise", [0.0, 1e-20])
def test_a_hop_of_nothing_lands_where_it_begins_and_never_upwards(rise):
    """Where rounding leaves no opening gap after a lift-off, the rim is on the plane at once."""
    state = state_of(0.5, vn=rise, t=1.0)
    ending, after, apexes = fly(state, limits(state), 3)
    assert (ending, after.t, after.y, after.vn, after.th) == (Ending.LANDING, 1.0, 0.0, 0.0, 0.5)
    assert len(apexes) == 0


@pytest.mark.parametrize("om", [3e8, -3e9])
def test_a_flight_ends_after_a_rotation_whose_angle_time_cannot_tell(om):
    state = state_of(0.5, om, 1e4, y=2.0, vn=1e6 + 0.75 * om * math.sin(0.5))
    ending, after, _ = fly(state, limits(state, 1e12))
    assert ending == Ending.SEARCH_LIMIT
    assert (after.t - state.t) * abs(om) == pytest.approx(flight_phase.LONGEST_FLIGHT)


def test_a_flight_step_ends_as_it_takes_off_or_lands():
    """A hoop that was thrown at t = 0 did not take off; a landing gives the bounce that the next is compared with."""

    def step(state, stop=0, restitution=0.0):
        phase = begin_phase(FLIGHT, state, Ending.LANDING)
        body = body_of(restitution=restitution)
        after, events, _, _ = written(flight_phase.flight_step, body, phase, limits(state, stop=stop))
        return after, events["kind"].tolist()

    for time in (1e-9, 0.5, 1.5):
        state = state_of(0.5, vn=0.5, t=time)
        after, kinds = step(state, STOP_AT_TAKEOFF)
        assert (after.state, after.mode, after.status, kinds) == (state, FLIGHT, Status.COMPLETED, [])
    assert step(state_of(0.5, y=0.5, vn=0.5), STOP_AT_TAKEOFF)[1] == [Event.APEX, Event.IMPACT]
    for restitution in (0.0, 0.5):
        after, kinds = step(state_of(0.5, y=0.5), 0, restitution)
        assert (kinds, after.ending, after.begins) == ([Event.IMPACT], Ending.LANDING, True)
        assert after.state.vn == pytest.approx(restitution)  # it comes with √(2 g R/2)


@pytest.mark.parametrize("ratio", [0.0625, 0.5, 0.99])
@pytest.mark.parametrize("time", [0.5, 20.0])
def test_bounces_are_closed_when_those_to_come_take_no_time(ratio, time):
    """Each takes 2 v/g and is slower by the same ratio: 2 v/(g (1 − ratio)) in all, beside the time so far or its unit."""
    allowed = flight_phase.CLOSING * max(time, 1.0) * (1.0 - ratio) / 2.0
    for v_n, closes in ((0.99 * allowed, True), (1.01 * allowed, False)):
        landing, after = state_of(0.0, t=time, vn=-v_n / ratio), state_of(0.0, t=time, vn=v_n)
        assert flight_phase.is_last_bounce(body_of(0.0), landing, after) is closes


def test_bounces_that_grow_no_slower_are_not_closed():
    last, body = flight_phase.is_last_bounce, body_of(0.0)
    before, state = state_of(0.0, vn=-1.0), state_of(0.0, vn=1e-14)
    for speed in (1e-14, 0.5e-14, 0.0):
        assert not last(body, state._replace(vn=-speed), state)
    assert not last(body, before, state._replace(vn=0.0))
    assert not last(body_of(0.0, gravity=0.0), before, state)
    assert last(body, before, state._replace(vn=1e-101))
    # an impact tells by itself by how much slower the next one is
    _, events, _ = motion_of(body_of(0.0, restitution=0.5), state_of(0.0, vn=-1e-13), 1.0)
    assert [kind for kind in events["kind"] if kind != Event.APEX][:2] == [Event.START, Event.BOUNCE_LIMIT]


# the massless hoop: a particle in free fall


@pytest.mark.parametrize("angle", [0.5, 2.0, 3.0, -0.5, -2.0, -3.0])
def test_where_the_load_sinks_or_is_about_to_the_rim_skims(angle):
    """A load that rises leaves open how the rim turns."""
    for om in (2.0, 0.25, 0.0, -0.25, -2.0):
        state = state_of(angle, om, 0.25)
        (mode, after), events, _, _ = written(flight_phase.begin_skim, body_of(1.0), state)
        rises = math.sin(angle) * om < 0.0
        assert (mode, after) == (UNDECIDED if rises else SKIM, state)
        assert moves(events) == ([] if rises else [(Event.SKIM, ROLL, SKIM)])


@pytest.mark.parametrize("gravity", [9.81, 0.0])
@pytest.mark.parametrize("om", [2.0, 1.5, -1.5, -2.0])
def test_at_the_top_the_rim_takes_the_rate_of_the_falling_load(om, gravity):
    """1 − cos θ = g t²/2 makes θ̇ = √g there; the load, 2 R above the plane, keeps its speed v_t + 2 θ̇ along it."""
    body, state = body_of(1.0, gravity=gravity), state_of(0.0, om, 0.25)
    (mode, after), events, _, _ = written(flight_phase.begin_skim, body, state)
    assert (mode, after.om) == (SKIM, math.copysign(math.sqrt(body.gn), om))
    assert after.vt + 2.0 * after.om == pytest.approx(0.25 + 2.0 * om, rel=1e-15)
    assert after._replace(om=om, vt=0.25) == state
    assert events[["kind", "omega", "slip"]].tolist() == [(Event.SKIM, after.om, after.vt)]
    for angle in (1e-9, -1e-9):  # where the cosine is 1 the load has no height to rise: it passes the top
        (mode, after), _, _, _ = written(flight_phase.begin_skim, body, state_of(angle, om))
        assert (mode, after.om) == (SKIM, om)


def skim(body, state, t_end):
    """(whether it strikes, state, v_n of the load, segment)."""
    (ending, after, vn), _, segments, _ = written(flight_phase.skim, body, state, limits(state, t_end))
    assert ending in (Ending.LOAD_STRIKE, Ending.TIME_LIMIT)
    return ending == Ending.LOAD_STRIKE, after, vn, segments[0]


@pytest.mark.parametrize(("angle", "om", "vt"), [(0.0, 1.0, 0.25), (0.5, 0.0, -0.5), (2.0, 1.5, 0.0), (3.0, 0.25, 0.25)])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_load_strikes_where_its_parabola_says(angle, om, vt, side):
    """Up to the blow, and not a moment before it."""
    body, state = body_of(1.0), state_of(side * angle, side * om, side * vt, x=0.75, t=2.0)
    with mp.workdps(30):
        height, sink = 1 + mp.cos(mpf(angle)), mp.sin(mpf(angle)) * om
        v_n = mp.sqrt(sink**2 + 2 * height)
        duration = float(v_n - sink)
    along = side * (vt + om * (1.0 + math.cos(angle)))  # of the load
    strikes, after, found, segment = skim(body, state, 99.0)
    assert strikes
    assert (after.t, found) == pytest.approx((2.0 + duration, -float(v_n)), rel=1e-14)
    assert (after.x, after.vt) == pytest.approx((0.75 + side * math.sin(angle) + along * duration, along), rel=1e-13, abs=1e-14)
    assert (after.th, after.th_low, after.vn) == (side * math.pi, 0.0, 0.0)
    names = ["mode", "kind", "direction", "t", "t_end"]
    assert segment[names].tolist() == (SKIM, SKIMMING, side, 2.0, after.t)
    state = state._replace(t=0.0)
    t = skim(body, state, 99.0)[1].t
    assert skim(body, state, t)[0]
    strikes, after, _, segment = skim(body, state, math.nextafter(t, 0.0))
    assert (strikes, after.t, segment["t_end"]) == (False, math.nextafter(t, 0.0), after.t)


def test_without_gravity_a_load_at_the_top_or_at_rest_strikes_in_the_future_or_never():
    """Its rise of 1e-160 counted as a fall that had been over for 1e160 units of time."""
    body = body_of(1.0, gravity=0.0)
    for angle in (1e-160, -1e-160, 1e-9, -1e-9):
        strikes, after, _, segment = skim(body, state_of(angle, 1.5), 7.0)
        assert (strikes, after.t, segment["t_end"]) == (False, 7.0, 7.0)
    strikes, after, _, _ = skim(body, state_of(2.0, vt=0.25), 7.0)
    assert (strikes, after.t, after.x, after.th) == (False, 7.0, pytest.approx(7.0 * 0.25), pytest.approx(2.0))


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
@pytest.mark.parametrize(
    ("mu", "speed", "sticks"), [(0.5, 0.5, True), (0.5, 1.0, False), (0.25, 0.5, False), (0.25, 0.0, True)]
)
def test_the_blow_is_that_of_a_particle_with_friction(side, restitution, mu, speed, sticks):
    """It takes m v_n, and μ of it along the plane, or what stops the load if that is less; nothing turns the rim."""
    body = body_of(1.0, mu=mu, restitution=restitution)
    state = state_of(side * 2.0, 0.0, side * speed, friction=0.25, impact_n=0.5, impact_t=0.75)
    v_n = math.sqrt(2.0 * (1.0 + math.cos(2.0)))
    phase = begin_phase(SKIM, state, Ending.LOAD_STRIKE)
    after, events, segments, _ = written(flight_phase.skim_step, body, phase, limits(state, 99.0))
    left = 0.0 if sticks else side * (speed - mu * v_n)
    mode = FLIGHT if restitution else ROLL if sticks else SKID if side > 0.0 else SPIN
    assert moves(events) == [(Event.IMPACT, SKIM, mode)]
    expected = {
        "before_slip": side * speed, "before_vy": -v_n, "before_omega": math.nan, "slip": left, "vy": 0.0, "omega": 0.0,
        "impulse_normal": v_n, "impulse_tangential": left - side * speed, "gain": 0.0, "collision": 1, "stable": -1,
    }  # fmt: skip
    assert {name: events[name][0] for name in expected} == pytest.approx(expected, rel=1e-13, nan_ok=True)
    losses = [after.state.friction, after.state.impact_n, after.state.impact_t]
    assert losses == pytest.approx([0.25, 0.5 + 0.5 * v_n**2, 0.75 + 0.5 * (speed**2 - left**2)], rel=1e-13)
    assert (after.state.vt, after.state.vn, after.state.om) == (events["slip"][0], 0.0, 0.0)
    assert (after.mode, after.ending) == (mode, Ending.LOAD_STRIKE)
    assert (after.status, after.begins) == ((Status.UNDETERMINED, False) if restitution else (GOING, True))
    ends = [(mode, FLY, after.state.t, after.state.t, 0.0, after.state.vt)] if restitution else []
    assert segments[["mode", "kind", "t", "t_end", "omega", "slip"]].tolist()[1:] == ends


def test_a_fall_that_is_not_over_ends_the_motion():
    state = state_of(2.0)
    phase = begin_phase(SKIM, state, Ending.LOAD_STRIKE)
    after, events, segments, _ = written(flight_phase.skim_step, body_of(1.0), phase, limits(state, 0.5))
    assert (after.mode, after.state.t, after.ending, after.status) == (SKIM, 0.5, Ending.TIME_LIMIT, Status.COMPLETED)
    assert (len(events), len(segments)) == (0, 1)
