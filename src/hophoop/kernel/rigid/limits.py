"""Where a motion ends at the latest, and how far it is from there."""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.double_double import TWO_PI, TWO_PI_LOW, plus
from hophoop.kernel.records.state import moved

STOP_AT_TURN, STOP_AT_TAKEOFF = 1, 2


class Limits(NamedTuple):
    """Where a motion ends at the latest: a time, and an angle to either side of the start (nan: none)."""

    t_end: float
    stop: int  # sum of STOP_AT_TURN, STOP_AT_TAKEOFF
    span: float
    span_turns: float  # the span as whole turns and the rest
    span_rest: float
    turns: float  # the angle of the start
    th: float
    th_low: float


def limits_of(start, t_end, span, stop):
    """Limits of a motion; a span that is a double beside whole turns means these turns."""
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
    """Angle to go in the direction `way` until the motion has turned by its span."""
    turns = limits.span_turns - way * (state.turns - limits.turns)
    rest = limits.span_rest - way * ((state.th - limits.th) + (state.th_low - limits.th_low))
    return turns * TWO_PI + (rest + turns * TWO_PI_LOW)


@inline
def at_span(limits, state, way):
    """The state at exactly the angle where the span ends."""
    th, low = plus(limits.th, limits.th_low, way * limits.span_rest)
    turns = limits.turns + way * limits.span_turns
    return moved(state, state.t, state.t_low, state.x, state.x_low, state.y, turns, th, low)
