"""Limits of a motion in time and angle, and the distance to them."""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.double_double import TWO_PI, TWO_PI_LOW, plus
from hophoop.kernel.records.state import moved

STOP_AT_TURN, STOP_AT_TAKEOFF = 1, 2


class Limits(NamedTuple):
    """Latest end of a motion: a time, and an angle to either side of the start (nan: no limit)."""

    t_end: float
    stop: int  # sum of STOP_AT_TURN, STOP_AT_TAKEOFF
    span: float
    span_turns: float  # the span as revolutions and the rest
    span_rest: float
    turns: float  # angle of the start
    th: float
    th_low: float


def limits_of(start, t_end, span, stop):
    """Return the limits of a motion; a span within rounding of whole revolutions means exactly these revolutions."""
    turns = 0.0
    rest = 0.0
    if not math.isnan(span):
        turns = 1.0 * math.floor(span / TWO_PI + 0.5)
        rest = span - turns * TWO_PI
        if abs(rest) <= 4e-16 * span:
            rest = 0.0
    return Limits(t_end, stop, span, turns, rest, start.turns, start.th, start.th_low)


@inline
def angle_left(limits, state, way):
    """Return the angle to go in the direction `way` until θ has changed by the span."""
    turns = limits.span_turns - way * (state.turns - limits.turns)
    rest = limits.span_rest - way * ((state.th - limits.th) + (state.th_low - limits.th_low))
    return turns * TWO_PI + (rest + turns * TWO_PI_LOW)


@inline
def at_span(limits, state, way):
    """Return the state at exactly the angle where the span ends."""
    th, low = plus(limits.th, limits.th_low, way * limits.span_rest)
    turns = limits.turns + way * limits.span_turns
    return moved(state, state.t, state.t_low, state.x, state.x_low, state.y, turns, th, low)
