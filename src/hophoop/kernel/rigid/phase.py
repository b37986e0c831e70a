"""What the event loop passes from step to step: the phase and its state, the reasons for endings, the limits of the motion."""

from __future__ import annotations

import math
from enum import IntEnum
from typing import NamedTuple

from hophoop.kernel.native import inline, noinline, replaced
from hophoop.kernel.numerics.arithmetic import PI, PI_LOW, TWO_PI, TWO_PI_LOW, add, plus, revolutions_and_rest
from hophoop.kernel.panels.anchor import NONE, Anchor
from hophoop.kernel.physics.body import UNDETERMINED
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.state import State

GOING = -1  # status of a motion that has not ended
START_LEVEL = 2  # level of the first panel of a phase


class Ending(IntEnum):
    """Endings in the order of their priority: of simultaneous ones, the first in this list counts.

    If N reaches zero without F, both sides of the friction cone are reached at once. The direction of rotation then decides
    between them.
    """

    CONE_FORWARD = 0
    """Rolling needs all available friction, F > 0."""
    CONE_BACKWARD = 1
    """Rolling needs all available friction, F < 0."""
    LIFT_OFF = 2
    """N reaches zero in slip."""
    SLIP_END = 3
    """v_t reaches zero."""
    LANDING = 4
    """The gap closes."""
    LOAD_STRIKE = 5
    """The load of a massless hoop strikes the plane."""
    ANGLE_LIMIT = 6
    """θ has changed by the angle span of the motion."""
    TIME_LIMIT = 7
    """The duration is over."""
    TURNING_POINT = 8
    """θ̇ reaches zero at the end of a panel."""
    REST = 9
    """A hoop with θ̇ = 0 stays at rest."""
    SINGULAR = 10
    """Slip cannot be resolved further: p_σ reaches zero."""
    SEARCH_LIMIT = 11
    """Rolling could not be resolved, or the search for a landing was given up."""
    CONTINUES = 12
    """No ending: the phase continues."""


class Phase(NamedTuple):
    """A phase of the motion, with the state that it has reached."""

    mode: int
    state: State
    begins: bool  # True at the start of the phase: margins that are zero there are no events
    level: int  # level of the next panel's width
    ending: int  # Ending of the piece of motion before this state
    status: int  # GOING, or the Status at the end of the motion
    anchor: Anchor  # of rolling


@inline
def begin_phase(mode, state, ending):
    """Start a phase; an UNDECIDED mode ends the motion."""
    return Phase(mode, state, True, START_LEVEL, ending, UNDETERMINED if mode == UNDECIDED else GOING, NONE)


@inline
def continue_phase(phase, state, level, ending, anchor):
    """Continue the phase from `state`."""
    return Phase(phase.mode, state, False, level, ending, GOING, anchor)


@inline
def end_motion(phase, mode, state, ending, status):
    """End the motion in a mode and state."""
    return Phase(mode, state, False, phase.level, ending, status, phase.anchor)


# --- limits ------------------------------------------------------------------------------------------------------------------

ROUNDING = 4e-15  # rad per revolution: within it a start is at an angle, and not about to pass it


class Limits(NamedTuple):
    """Latest end of a motion: a time, events, and an angle to either side of a centre (nan: no limit)."""

    t_end: float
    stop: int  # sum of STOP_AT_TURN, STOP_AT_TAKEOFF
    landings: int  # 0: no limit
    span: float
    span_turns: float  # the span as revolutions and the rest, a double-double
    span_rest: float
    span_low: float
    revolutions: float  # angle of the centre
    th: float
    th_low: float
    leaves: bool  # True while a start at the angle that ends the motion, the centre, is not left yet


def limits_of(start, t_end, span, stop, landings):
    """Return the limits of a motion; the span is to either side of the start.

    A span within rounding of whole revolutions means exactly these revolutions.
    """
    revolutions = 0.0
    rest = 0.0
    if not math.isnan(span):
        revolutions = 1.0 * math.floor(span / TWO_PI + 0.5)
        rest = span - revolutions * TWO_PI
        if abs(rest) <= 4e-16 * span:
            rest = 0.0
    return Limits(t_end, stop, landings, span, revolutions, rest, 0.0, start.revolutions, start.th, start.th_low, False)


def limits_at_angle(start, t_end, angle):
    """Return the limits of a motion that ends where θ next is `angle` in any revolution.

    These are half a revolution to either side of the opposite angle. A start at `angle` itself has them once it is left.
    """
    _, th, low = revolutions_and_rest(angle)
    ahead = (start.th - th) + (start.th_low - low)  # from the angle in the revolution of the start
    passed = 1.0 * math.floor(ahead / TWO_PI + 0.5)
    revolutions = start.revolutions + passed
    ahead -= passed * TWO_PI
    if abs(ahead) <= ROUNDING * (1.0 + abs(revolutions)):
        return Limits(t_end, 0, 0, TWO_PI, 1.0, 0.0, 0.0, revolutions, th, low, True)
    side = 1.0 if ahead > 0.0 else -1.0
    if side * th > 0.0:  # so that the opposite angle is within half a revolution, too
        revolutions += side
        side = -side
    return limits_beside(t_end, side, revolutions, th, low)


def limits_beside(t_end, side, revolutions, th, low):
    """Return the limits of a motion on one side (±1) of an angle: there, and a revolution further."""
    th, low = add((th, low), (side * PI, side * PI_LOW))
    return Limits(t_end, 0, 0, PI, 0.0, PI, PI_LOW, revolutions, th, low, False)


def limits_until(start, t_end, until):
    """Return the limits of a motion that something ends before its duration."""
    if not math.isnan(until.angle):
        return limits_at_angle(start, t_end, until.angle)
    return limits_of(start, t_end, TWO_PI * until.revolutions, until.stop, until.landings)


@noinline
def limits_after_start(limits, state):
    """Return the limits of a motion that has started at the angle that ends it, and may have left it by now."""
    moved_by = TWO_PI * (state.revolutions - limits.revolutions) + ((state.th - limits.th) + (state.th_low - limits.th_low))
    if abs(moved_by) <= ROUNDING * (1.0 + abs(limits.revolutions)):
        return limits
    return limits_beside(limits.t_end, math.copysign(1.0, moved_by), limits.revolutions, limits.th, limits.th_low)


@inline
def angle_left(limits, state, direction):
    """Return the angle to go in `direction` (±1) until θ has changed by the span."""
    revolutions = limits.span_turns - direction * (state.revolutions - limits.revolutions)
    rest = limits.span_rest - direction * ((state.th - limits.th) + (state.th_low - limits.th_low))
    return revolutions * TWO_PI + ((rest + limits.span_low) + revolutions * TWO_PI_LOW)


@inline
def at_span(limits, state, direction):
    """Return the state at exactly the angle where the span ends."""
    th, low = plus(limits.th, limits.th_low, direction * limits.span_rest)
    th, low = plus(th, low, direction * limits.span_low)
    revolutions = limits.revolutions + direction * limits.span_turns
    return replaced(state, revolutions=revolutions, th=th, th_low=low)
