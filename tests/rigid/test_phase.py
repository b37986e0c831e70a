"""The angle at which a motion ends: how far it is, and the state there, to two doubles; how a flight opens."""

import math

import pytest
from mpmath import mp, mpf

from hophoop.kernel.rigid.flight_phase import flight_start
from hophoop.kernel.rigid.phase import angle_left, at_span
from rigid.tools import body_of, limits, state_of

TURN = 2.0 * math.pi
BOTH_WAYS = pytest.mark.parametrize("way", [1.0, -1.0])


def exactly(state):
    """Its angle in 40 digits."""
    return 2 * mp.pi * mpf(state.revolutions) + mpf(float(state.th)) + mpf(float(state.th_low))


@pytest.mark.parametrize("turns", [1, 3, 1000])
def test_a_span_that_is_a_double_beside_whole_turns_means_the_turns(turns):
    """By a part of 4·10⁻¹⁶, within which lie the doubles on both sides; the next but one is meant as it stands."""
    span = turns * TURN
    for near in (span, math.nextafter(span, 0.0), math.nextafter(span, math.inf)):
        given = limits(state_of(0.25), span=near)
        assert abs(near - span) > 4e-16 * near or (given.span_turns, given.span_rest) == (turns, 0.0)
    for part in (1e-14, -1e-14, 8e-16, -8e-16):
        given = limits(state_of(0.25), span=span * (1.0 + part))
        assert (given.span_turns, given.span_rest) == (turns, pytest.approx(part * span, rel=0.6, abs=0.0))


@BOTH_WAYS
@pytest.mark.parametrize("span", [2.0**-30, 3.0, 4.0 * math.pi, 6283.185307179586])
def test_the_angle_that_is_left_is_the_span_less_what_is_turned(way, span):
    """Whole turns are exact, so that little that is left of many turns has its digits; nothing is left at the end."""
    start = state_of(0.25 - 5 * TURN, 1.0)._replace(th_low=2e-17)
    given = limits(start, span=span)
    with mp.workdps(40):
        whole = 2 * mp.pi * mpf(given.span_turns) + mpf(float(given.span_rest))
        for turned, th, low in ((0, 0.25, 3e-17), (0, 0.375, -3e-17), (2, -3.0, 1e-16), (3, 3.0, 1e-16)):
            state = start._replace(revolutions=start.revolutions + way * turned, th=way * th, th_low=way * low)
            expected = whole - way * (exactly(state) - exactly(start))
            assert abs(float(angle_left(given, state, way)) - expected) <= 3e-16 * max(abs(expected), 1.0)
        state = start._replace(t=2.0, t_low=1e-17, x=3.0, x_low=1e-17, y=0.5, revolutions=90.0, th=1.0, th_low=0.0)
        found = at_span(given, state, way)
        assert found._replace(revolutions=90.0, th=1.0, th_low=0.0) == state  # all but the angle stays
        assert abs(exactly(found) - exactly(start) - way * whole) < 1e-29
    assert abs(float(angle_left(given, found, way))) < 1e-15
    start = state_of(0.25, 1.0, th_low=2e-17)
    state = start._replace(th=0.25 + way * 2.0**-30, th_low=-1e-17)
    left = float(angle_left(limits(start, span=2.0**-30), state, way))
    assert left == pytest.approx(way * 3e-17, rel=1e-7, abs=0.0)  # the low parts count


def test_how_a_flight_opens():
    """f_n, and how many derivatives of the gap are zero: none above the plane, three where f_n is zero, too.

    With the load at the top ε θ̇² is 2 g or g; f_n that is a part of 10⁻¹³ of g_n + θ̇² or less is rounding, and is left out.
    """
    for state, found in (
        (state_of(0.0, 2.0, y=1.0), (1.0, 0)),
        (state_of(0.0, 2.0, vn=1.0), (1.0, 1)),
        (state_of(0.0, 2.0), (1.0, 2)),
        (state_of(0.0, math.sqrt(2.0)), (0.0, 3)),
        (state_of(0.0, math.sqrt(2.0 + 0.25 * 6e-13)), (0.0, 3)),
        (state_of(0.0, math.sqrt(2.0 + 4.0 * 6e-13)), (pytest.approx(12e-13, rel=0.1), 2)),
    ):
        assert flight_start(body_of(0.5, 0.75), state, False) == found
