"""The angle at which a motion ends: how far it is, and the state there, to two doubles."""

from __future__ import annotations

import math

import pytest
from mpmath import mp, mpf

from hophoop.kernel.numerics.arithmetic import revolutions_and_rest
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid.phase import (
    STOP_AT_TAKEOFF,
    STOP_AT_TURN,
    angle_left,
    at_span,
    limits_at_angle,
    limits_of,
    limits_until,
)
from hophoop.simulation.until import NOTHING

EXACT_TURN = 2.0 * math.pi


def start_of(angle=0.25, low=0.0):
    return start_state(0.0, 0.0, angle, 0.0, 0.0, 1.0)._replace(th_low=low)


def limits(span, start=None):
    return limits_of(start or start_of(), 9.0, span, STOP_AT_TURN, 0)


def exactly(turns, high, low=0.0):
    """An angle in 40 digits."""
    return 2 * mp.pi * mpf(turns) + mpf(float(high)) + mpf(float(low))


@pytest.mark.parametrize("turns", [1, 2, 3, 7, 1000])
def test_a_span_that_is_a_double_beside_whole_turns_means_the_turns(turns):
    """By a part of 4·10⁻¹⁶, within which lie the doubles on both sides; the next but one is meant as it stands."""
    span = turns * EXACT_TURN
    for near in (span, math.nextafter(span, 0.0), math.nextafter(span, math.inf)):
        if abs(near - span) <= 4e-16 * near:
            assert (limits(near).span_turns, limits(near).span_rest) == (turns, 0.0)
    for sign in (1.0, -1.0):
        found = limits(span * (1.0 + sign * 1e-14))
        assert found.span_turns == turns
        assert found.span_rest == pytest.approx(sign * 1e-14 * span, rel=0.2, abs=0.0)
        assert limits(span * (1.0 + sign * 8e-16)).span_rest * sign > 0.0


@pytest.mark.parametrize("span", [1e-3, 0.1, 3.0, 3.3, 10.0, 1000.0])
def test_a_span_is_whole_turns_and_a_rest_of_half_a_turn_at_most(span):
    found = limits(span)
    assert found.span_turns == math.floor(span / EXACT_TURN + 0.5)
    assert abs(found.span_rest) <= math.pi
    assert found.span_turns * EXACT_TURN + found.span_rest == pytest.approx(span, rel=1e-15)


def test_what_a_motion_is_told_is_kept():
    start = start_of(0.25 + 3 * EXACT_TURN, low=1e-18)
    found = limits(0.5, start)
    assert (found.t_end, found.stop, found.span) == (9.0, STOP_AT_TURN, 0.5)
    assert (found.revolutions, found.th, found.th_low) == (start.revolutions, start.th, start.th_low)
    unlimited = limits(math.nan)
    assert math.isnan(unlimited.span)
    assert (unlimited.span_turns, unlimited.span_rest) == (0.0, 0.0)


def test_the_two_stops_are_told_apart():
    """They are asked for by their sum, of which each is a bit of its own."""
    assert STOP_AT_TURN.bit_count() == STOP_AT_TAKEOFF.bit_count() == 1
    assert STOP_AT_TURN != STOP_AT_TAKEOFF


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("span", [0.5, 3.0, 2.0 * math.pi, 20.0, 6283.185307179586])
@pytest.mark.parametrize(("turned", "th", "low"), [(0, 0.25, 3e-17), (0, 0.375, -3e-17), (2, -3.0, 1e-16), (3, 3.0, 1e-16)])
def test_the_angle_that_is_left_is_the_span_less_what_is_turned(way, span, turned, th, low):
    """Whole turns are exact, so that little that is left of many turns has its digits."""
    start = start_of(0.25 - 5 * EXACT_TURN, low=2e-17)
    state = start._replace(revolutions=start.revolutions + way * turned, th=way * th, th_low=way * low)
    given = limits(span, start)
    left = float(angle_left(given, state, way))
    with mp.workdps(40):
        begin = exactly(start.revolutions, start.th, start.th_low)
        expected = exactly(given.span_turns, given.span_rest) - way * (
            exactly(state.revolutions, state.th, state.th_low) - begin
        )
        assert abs(left - expected) <= 3e-16 * max(abs(expected), 1.0)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_of_a_small_span_the_low_parts_count(way):
    span = 2.0**-30
    start = start_of(0.25, low=2e-17)
    state = start._replace(th=0.25 + way * span, th_low=-1e-17)
    assert float(angle_left(limits(span, start), state, way)) == pytest.approx(way * 3e-17, rel=1e-7, abs=0.0)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("span", [0.5, 3.0, 4.0 * math.pi, 20.0])
def test_the_state_at_the_end_of_the_span_is_there_exactly(way, span):
    """Where nothing is left of it; all but the angle stays."""
    start = start_of(0.3 + 2 * EXACT_TURN, low=2e-17)
    given = limits(span, start)
    state = start._replace(t=2.0, t_low=1e-17, x=3.0, x_low=1e-17, y=0.5, revolutions=90.0, th=1.0, th_low=0.0)
    found = at_span(given, state, way)
    assert found._replace(revolutions=90.0, th=1.0, th_low=0.0) == state
    with mp.workdps(40):
        begin = exactly(start.revolutions, start.th, start.th_low)
        expected = begin + way * exactly(given.span_turns, given.span_rest)
        assert abs(exactly(found.revolutions, found.th, found.th_low) - expected) < 1e-29
    assert abs(float(angle_left(given, found, way))) < 1e-15


@pytest.mark.parametrize("angle", [0.0, 0.25, -0.25, 1.5, -1.5, 3.0, -3.0, math.pi, -math.pi, 100.0])
@pytest.mark.parametrize("at", [0.1, 2.0, 4.0, 6.2, -0.1, -2.9, -6.2, 50.0])
def test_a_motion_ends_at_the_next_passage_of_an_angle_on_either_side(angle, at):
    """Both are less than a revolution from the start, and differ by one."""
    start = start_of(at)
    given = limits_at_angle(start, 9.0, angle)
    assert (given.t_end, given.stop, given.landings, given.span) == (9.0, 0, 0, math.pi)
    ahead = (angle - at) % EXACT_TURN
    assert float(angle_left(given, start, 1.0)) == pytest.approx(ahead, abs=1e-13)
    assert float(angle_left(given, start, -1.0)) == pytest.approx(EXACT_TURN - ahead, abs=1e-13)
    with mp.workdps(40):
        for way in (1.0, -1.0):
            found = at_span(given, start, way)
            beyond = (exactly(found.revolutions, found.th, found.th_low) - mpf(angle)) / (2 * mp.pi)
            assert abs(beyond - mp.nint(beyond)) < 1e-29 + abs(angle) * 1e-32
            assert abs(found.th) <= EXACT_TURN


@pytest.mark.parametrize("angle", [0.0, 1.5, -3.0, math.pi])
@pytest.mark.parametrize("turns", [-3, 0, 3])
@pytest.mark.parametrize("off", [0.0, 1e-15, -1e-15])
def test_a_start_at_the_angle_does_not_end_there(angle, turns, off):
    """It is one revolution from the next passage in both directions, also if rounding moved it."""
    revolutions, th, low = revolutions_and_rest(angle)
    start = start_of()._replace(revolutions=revolutions + turns, th=th, th_low=low + off)
    given = limits_at_angle(start, 9.0, angle)
    for way in (1.0, -1.0):
        assert float(angle_left(given, start, way)) == pytest.approx(EXACT_TURN, abs=1e-14)
        found = at_span(given, start, way)
        assert (found.revolutions, found.th, found.th_low) == (revolutions + turns + way, th, low)


def test_what_ends_a_motion_before_its_duration():
    start = start_of()
    assert limits_until(start, 9.0, NOTHING._replace(revolutions=0.3)) == limits_of(start, 9.0, EXACT_TURN * 0.3, 0, 0)
    assert limits_until(start, 9.0, NOTHING._replace(angle=0.3)) == limits_at_angle(start, 9.0, 0.3)
    found = limits_until(start, 9.0, NOTHING._replace(stop=STOP_AT_TURN, landings=3))
    assert (found.stop, found.landings) == (STOP_AT_TURN, 3)
    assert math.isnan(found.span)
