"""One flight, and the fall of the massless hoop's load: what ends them, and the state there; when bounces are closed."""

import math

import pytest

from hophoop.kernel.panels.panel import FLY
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.rigid import flight_phase
from hophoop.kernel.rigid.phase import GOING, Ending, begin_phase
from rigid.tools import FLIGHT, ROLL, SKID, SPIN, body_of, limits, motion_of, moves, state_of, written

SKIM = int(Mode.SKIM)
MASSLESS = body_of(1.0)
SIDES = pytest.mark.parametrize("side", [1.0, -1.0])


def fly(state, given, vanishing=0):
    """(ending, state at the end, apexes); with three vanishing derivatives the gap opens by rounding alone."""
    body = body_of()
    f_n = 0.0 if vanishing == 3 else body.eps * state.om**2 * math.cos(state.th) - body.gn
    (ending, after), apexes, segments, _ = written(flight_phase.fly, body, state, f_n, vanishing, given)
    assert segments[["kind", "mode", "t", "t_end"]].tolist() == [(FLY, FLIGHT, state.t, after.t)]
    return ending, after, len(apexes)


@SIDES
def test_a_flight_ends_at_the_angle_of_its_span(side):
    """One that begins beyond it by a rounding takes no time; an angle that comes after the end of time, or never, is none."""
    start = state_of(0.5, 2.0 * side, y=0.5, vn=2.0)
    given = limits(start, span=0.25)
    ending, after, _ = fly(start, given)
    assert (ending, after.t, after.th) == (Ending.ANGLE_LIMIT, 0.125, 0.5 + side * 0.25)
    assert fly(start, given._replace(t_end=0.1))[0] == Ending.TIME_LIMIT
    ending, after, _ = fly(start._replace(th=0.5 + side * (0.25 + 1e-15)), given)
    assert (ending, after.t, after.y) == (Ending.ANGLE_LIMIT, 0.0, 0.5)
    ending, after, apexes = fly(state_of(0.5, y=0.5), given)
    assert (ending, after.t, apexes) == (Ending.LANDING, pytest.approx(1.0, rel=1e-15), 0)  # g t²/2 of R/2


def test_a_flight_that_cannot_be_followed_lands_at_once_or_is_given_up():
    """Where rounding leaves no opening gap after a lift-off, and after a rotation whose angle time cannot tell."""
    for rise in (0.0, 1e-20):
        state = state_of(0.5, vn=rise, t=1.0)
        ending, after, apexes = fly(state, limits(state), 3)
        assert (ending, after.t, after.y, after.vn, after.th, apexes) == (Ending.LANDING, 1.0, 0.0, 0.0, 0.5, 0)
    for om in (3e8, -3e9):
        state = state_of(0.5, om, 1e4, y=2.0, vn=1e6 + 0.75 * om * math.sin(0.5))
        ending, after, _ = fly(state, limits(state, 1e12))
        assert (ending, (after.t - state.t) * abs(om)) == (Ending.SEARCH_LIMIT, pytest.approx(flight_phase.LONGEST_FLIGHT))


@pytest.mark.parametrize("ratio", [0.0625, 0.5, 0.99])
@pytest.mark.parametrize("time", [0.5, 20.0])
def test_bounces_are_closed_when_those_to_come_take_no_time(ratio, time):
    """Each takes 2 v/g and is slower by the same ratio: 2 v/(g (1 − ratio)) in all, beside the time so far or its unit."""
    allowed = flight_phase.CLOSING * max(time, 1.0) * (1.0 - ratio) / 2.0
    for v_n, closes in ((0.99 * allowed, True), (1.01 * allowed, False)):
        landing, after = state_of(0.0, t=time, vn=-v_n / ratio), state_of(0.0, t=time, vn=v_n)
        assert flight_phase.is_last_bounce(body_of(0.0), landing, after) is closes


def test_bounces_that_grow_no_slower_are_not_closed():
    weightless = body_of(0.0, gravity=0.0)
    for before, after, body, closes in (
        (1e-14, 1e-14, body_of(0.0), False),
        (0.5e-14, 1e-14, body_of(0.0), False),
        (0.0, 1e-14, body_of(0.0), False),
        (1.0, 0.0, body_of(0.0), False),
        (1.0, 1e-14, weightless, False),
        (1.0, 1e-101, body_of(0.0), True),
    ):
        assert flight_phase.is_last_bounce(body, state_of(0.0, vn=-before), state_of(0.0, vn=after)) is closes
    # an impact tells by itself by how much slower the next one is
    _, events, _ = motion_of(body_of(0.0, restitution=0.5), state_of(0.0, vn=-1e-13), 1.0)
    assert [kind for kind in events["kind"] if kind != Event.APEX][:2] == [Event.START, Event.BOUNCE_LIMIT]


# the massless hoop: a particle in free fall; see also physics/test_massless.py


@SIDES
def test_at_the_top_the_rim_takes_the_rate_of_the_falling_load(side):
    """1 − cos θ = g t²/2 makes θ̇ = √g there; the load, 2 R above the plane, keeps its speed v_t + 2 θ̇ along it."""
    (mode, after), _, _, _ = written(flight_phase.begin_skim, MASSLESS, state_of(0.0, 2.0 * side, 0.25))
    assert (mode, after) == (SKIM, state_of(0.0, side, 0.25 + 2.0 * side))
    for angle in (1e-9, -1e-9):  # where the cosine is 1 the load has no height to rise: it passes the top
        state = state_of(angle, 2.0 * side)
        assert written(flight_phase.begin_skim, MASSLESS, state)[0] == (SKIM, state)


def test_without_gravity_a_load_at_the_top_or_at_rest_strikes_in_the_future_or_never():
    """Its rise of 1e-160 counted as a fall that had been over for 1e160 units of time."""
    for state in (state_of(1e-160, 1.5), state_of(-1e-160, 1.5), state_of(1e-9, 1.5), state_of(2.0, vt=0.25)):
        (ending, after, _), _, _, _ = written(flight_phase.skim, body_of(1.0, gravity=0.0), state, limits(state, 7.0))
        assert (ending, after.t) == (Ending.TIME_LIMIT, 7.0)
    assert (after.x, after.th) == pytest.approx((7.0 * 0.25, 2.0))


@SIDES
@pytest.mark.parametrize(("mu", "restitution", "sticks"), [(0.5, 0.0, True), (0.25, 0.0, False), (0.25, 0.5, False)])
def test_after_the_blow_of_the_load_it_slides_rolls_or_is_thrown(side, mu, restitution, sticks):
    """It takes m v_n, and μ of it along the plane, or what stops the load if that is less; nothing turns the rim."""
    body = body_of(1.0, mu=mu, restitution=restitution)
    state = state_of(side * 2.0, 0.0, side * 0.5, friction=0.25, impact_n=0.5, impact_t=0.75)
    v_n = math.sqrt(2.0 * (1.0 + math.cos(2.0)))
    phase = begin_phase(SKIM, state, Ending.LOAD_STRIKE)
    after, events, _, _ = written(flight_phase.skim_step, body, phase, limits(state))
    at_the_blow = limits(state, after.state.t)
    assert written(flight_phase.skim, body, state, at_the_blow)[0][0] == Ending.LOAD_STRIKE
    left = 0.0 if sticks else side * (0.5 - mu * v_n)
    mode = FLIGHT if restitution else ROLL if sticks else SKID if side > 0.0 else SPIN
    assert moves(events) == [(Event.IMPACT, SKIM, mode)]
    names = ["before_slip", "before_vy", "slip", "omega", "impulse_normal", "impulse_tangential", "collision"]
    assert events[names].tolist()[0] == pytest.approx((side * 0.5, -v_n, left, 0.0, v_n, left - side * 0.5, 1), rel=1e-13)
    losses = [after.state.friction, after.state.impact_n, after.state.impact_t]
    assert losses == pytest.approx([0.25, 0.5 + 0.5 * v_n**2, 0.75 + 0.5 * (0.25 - left**2)], rel=1e-13)
    assert after.status == (Status.UNDETERMINED if restitution else GOING)
