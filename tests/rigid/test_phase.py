"""How a phase begins, and the angle at which a motion ends: how far it is, and the state there, to two doubles."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from hophoop.kernel.numerics.arithmetic import revolutions_and_rest
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.rigid import phase as phases
from hophoop.kernel.rigid.contact_phase import vanishing_slip_derivatives
from hophoop.kernel.rigid.flight_phase import flight_start
from hophoop.kernel.rigid.phase import Ending, angle_left, at_span, limits_at_angle
from hophoop.kernel.rigid.transitions import undecided
from rigid.tools import FLIGHT, SKID, body_of, limits, state_of, written

TURN = 2.0 * math.pi
BOTH_WAYS = pytest.mark.parametrize("way", [1.0, -1.0])


def exactly(state):
    """Its angle in 40 digits."""
    return 2 * mp.pi * mpf(state.revolutions) + mpf(float(state.th)) + mpf(float(state.th_low))


def exact_span(given):
    return 2 * mp.pi * mpf(given.span_turns) + mpf(float(given.span_rest))


@pytest.mark.parametrize("turns", [1, 2, 3, 7, 1000])
def test_a_span_that_is_a_double_beside_whole_turns_means_the_turns(turns):
    """By a part of 4·10⁻¹⁶, within which lie the doubles on both sides; the next but one is meant as it stands."""

    def spanned(span):
        given = limits(state_of(0.25), span=span)
        assert abs(given.span_rest) <= math.pi
        return given.span_turns, given.span_rest

    span = turns * TURN
    for near in (span, math.nextafter(span, 0.0), math.nextafter(span, math.inf)):
        assert abs(near - span) > 4e-16 * near or spanned(near) == (turns, 0.0)
    for sign in (1.0, -1.0):
        assert spanned(span * (1.0 + sign * 1e-14)) == (turns, pytest.approx(sign * 1e-14 * span, rel=0.2, abs=0.0))
        assert spanned(span * (1.0 + sign * 8e-16))[1] * sign > 0.0


@BOTH_WAYS
@pytest.mark.parametrize("span", [0.5, 3.0, 4.0 * math.pi, 20.0, 6283.185307179586])
def test_the_angle_that_is_left_is_the_span_less_what_is_turned(way, span):
    """Whole turns are exact, so that little that is left of many turns has its digits; nothing is left at the end."""
    start = state_of(0.25 - 5 * TURN, 1.0)._replace(th_low=2e-17)
    given = limits(start, span=span)
    for turned, th, low in ((0, 0.25, 3e-17), (0, 0.375, -3e-17), (2, -3.0, 1e-16), (3, 3.0, 1e-16)):
        state = start._replace(revolutions=start.revolutions + way * turned, th=way * th, th_low=way * low)
        with mp.workdps(40):
            expected = exact_span(given) - way * (exactly(state) - exactly(start))
            assert abs(float(angle_left(given, state, way)) - expected) <= 3e-16 * max(abs(expected), 1.0)
    state = start._replace(t=2.0, t_low=1e-17, x=3.0, x_low=1e-17, y=0.5, revolutions=90.0, th=1.0, th_low=0.0)
    found = at_span(given, state, way)
    assert found._replace(revolutions=90.0, th=1.0, th_low=0.0) == state  # all but the angle stays
    with mp.workdps(40):
        assert abs(exactly(found) - exactly(start) - way * exact_span(given)) < 1e-29
    assert abs(float(angle_left(given, found, way))) < 1e-15


def test_without_a_span_nothing_of_it_is_left():
    start = state_of(0.25 + 3 * TURN, th_low=1e-18)
    given = limits(start, stop=phases.STOP_AT_TURN)
    assert (given.t_end, given.stop, given.span_turns, given.span_rest) == (9.0, phases.STOP_AT_TURN, 0.0, 0.0)
    assert (given.revolutions, given.th, given.th_low) == (start.revolutions, start.th, start.th_low)
    assert math.isnan(given.span)


@BOTH_WAYS
def test_of_a_small_span_the_low_parts_count(way):
    span, start = 2.0**-30, state_of(0.25, 1.0, th_low=2e-17)
    state = start._replace(th=0.25 + way * span, th_low=-1e-17)
    assert float(angle_left(limits(start, span=span), state, way)) == pytest.approx(way * 3e-17, rel=1e-7, abs=0.0)


@pytest.mark.parametrize("angle", [0.0, 0.25, -1.5, 3.0, -3.0, math.pi, -math.pi, 100.0])
@pytest.mark.parametrize("at", [0.1, 4.0, 6.2, -0.1, -2.9, 50.0])
def test_a_motion_ends_at_the_next_passage_of_an_angle_on_either_side(angle, at):
    """Both are less than a revolution from the start, and differ by one."""
    start = state_of(at)
    given = limits_at_angle(start, 9.0, angle)
    assert (given.t_end, given.stop, given.landings, given.span) == (9.0, 0, 0, math.pi)
    ahead = (angle - at) % TURN
    for way, left in ((1.0, ahead), (-1.0, TURN - ahead)):
        assert float(angle_left(given, start, way)) == pytest.approx(left, abs=1e-13)
        found = at_span(given, start, way)
        with mp.workdps(40):
            beyond = (exactly(found) - mpf(angle)) / (2 * mp.pi)
            assert abs(beyond - mp.nint(beyond)) < 1e-29 + abs(angle) * 1e-32
        assert abs(found.th) <= TURN


@pytest.mark.parametrize("angle", [0.0, 1.5, -3.0, math.pi])
def test_a_start_at_the_angle_does_not_end_there(angle):
    """It is one revolution from the next passage in both directions, also if rounding moved it."""
    revolutions, th, low = revolutions_and_rest(angle)
    for turns, off in ((0, 0.0), (-3, 1e-15), (3, -1e-15)):
        start = state_of(0.0, revolutions=revolutions + turns, th=th, th_low=low + off)
        given = limits_at_angle(start, 9.0, angle)
        for way in (1.0, -1.0):
            assert float(angle_left(given, start, way)) == pytest.approx(TURN, abs=1e-14)
            found = at_span(given, start, way)
            assert (found.revolutions, found.th, found.th_low) == (revolutions + turns + way, th, low)


def test_how_a_flight_opens():
    """f_n, and how many derivatives of the gap are zero: none above the plane, three where f_n is zero, too."""
    body = body_of(0.5, 0.75)
    fast, free = 2.0, math.sqrt(2.0)  # ε θ̇² = 2 g and g, with the load at the top
    for state, found in (
        (state_of(0.0, fast, y=1.0), (1.0, 0)),
        (state_of(0.0, fast, vn=1.0), (1.0, 1)),
        (state_of(0.0, fast), (1.0, 2)),
        (state_of(0.0, free), (0.0, 3)),
    ):
        assert flight_start(body, state, False) == found
    # f_n that is a part of 10⁻¹³ of g_n + θ̇² or less is rounding, and is left out
    for part, count in ((0.25, 3), (4.0, 2), (1e3, 2)):
        opening = part * 1e-13 * 3.0
        f_n, vanishing = flight_start(body, state_of(0.0, math.sqrt(2.0 * (1.0 + opening))), False)
        assert (f_n, vanishing) == (0.0 if count == 3 else pytest.approx(opening, rel=0.1), count)


def test_how_a_phase_begins_goes_on_and_ends():
    """Slip after a jump begins at its speed, or with zero."""
    for speed, vanishing in ((0.0, 1), (1.0, 0), (-1.0, 0), (1e-300, 0)):
        state = state_of(0.5, 1.0, speed)
        phase = phases.begin_phase(SKID, state, Ending.CONTINUES)
        assert phase == phases.Phase(SKID, state, True, phases.START_LEVEL, Ending.CONTINUES, phases.GOING)
        assert vanishing_slip_derivatives(body_of(), phase) == vanishing
    later = state_of(0.5, 2.0, t=1.0)
    lifted = phase._replace(state=later, begins=False, level=8, ending=Ending.LIFT_OFF)
    assert phases.continue_phase(phase, later, 8, Ending.LIFT_OFF) == lifted
    ended = lifted._replace(mode=FLIGHT, level=phase.level, status=phases.UNDETERMINED)
    assert phases.end_motion(phase, FLIGHT, later, Ending.LIFT_OFF, phases.UNDETERMINED) == ended


@pytest.mark.parametrize(("mu", "doubt"), [(0.5, 3.0), (math.inf, math.nan)])
def test_where_nothing_is_decided_more_digits_may_tell(mu, doubt):
    """Not where no friction is too much: there the model itself has no answer."""
    state = state_of(0.5, 1.0, t=3.0)
    found, _, _, noted = written(undecided, body_of(mu=mu), state)
    assert found == (UNDECIDED, state)
    assert phases.begin_phase(*found, Ending.CONTINUES).status == phases.UNDETERMINED
    assert np.array_equal(noted, [doubt], equal_nan=True)
