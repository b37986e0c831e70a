"""The state that passes through the event loop, and how events and segments are written."""

from __future__ import annotations

from typing import NamedTuple

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.double_double import PI, TWO_PI, TWO_PI_LOW, add, plus, turns_and_rest
from hophoop.kernel.panels.anchor import NONE, Anchor

# θ stays within this of the turn it is counted in, so that it has all its digits beside the hilltops of both sides.
FARTHEST = TWO_PI - 0.5


class State(NamedTuple):
    """Position, velocities (v_t in place of ẋ, so that small slip keeps its digits) and energy lost so far.

    Times and angles add up over thousands of turns, so they have a second double for what rounding keeps from the
    first. The angle is a whole number of turns and θ within the turn, which stays between −2π and 2π.
    """

    t: float
    t_low: float
    x: float
    x_low: float
    y: float
    turns: float
    th: float
    th_low: float
    vt: float
    vn: float
    om: float
    friction: float
    impact_n: float
    impact_t: float
    resisted: float  # energy lost to rolling resistance
    anchor: Anchor


@apart
def start_state(x, y, angle, vt, vn, om):
    """A state at t = 0, from the whole angle."""
    turns, th, th_low = turns_and_rest(angle)
    return State(0.0, 0.0, x, 0.0, y, turns, th, th_low, vt, vn, om, 0.0, 0.0, 0.0, 0.0, NONE)


@inline
def whole_angle(state):
    """θ with its turns."""
    return state.turns * TWO_PI + (state.th + (state.th_low + state.turns * TWO_PI_LOW))


@inline
def moved(state, t, t_low, x, x_low, y, turns, th, th_low):
    """The state elsewhere, with its velocities and losses."""
    return State(
        t, t_low, x, x_low, y, turns, th, th_low, state.vt, state.vn, state.om,
        state.friction, state.impact_n, state.impact_t, state.resisted, state.anchor,
    )  # fmt: skip


@inline
def with_velocities(state, vt, vn, om):
    """The state with other velocities."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low, vt, vn, om,
        state.friction, state.impact_n, state.impact_t, state.resisted, state.anchor,
    )  # fmt: skip


@inline
def with_losses(state, friction, impact_n, impact_t):
    """The state with other losses."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low,
        state.vt, state.vn, state.om, friction, impact_n, impact_t, state.resisted, state.anchor,
    )  # fmt: skip


@inline
def with_resisted(state, resisted):
    """The state with another loss to rolling resistance."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low,
        state.vt, state.vn, state.om, state.friction, state.impact_n, state.impact_t, resisted, state.anchor,
    )  # fmt: skip


@inline
def with_anchor(state, anchor):
    """The state with another anchor."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low,
        state.vt, state.vn, state.om, state.friction, state.impact_n, state.impact_t, state.resisted, anchor,
    )  # fmt: skip


@inline
def at_time(state, t):
    """The state at exactly the time t."""
    return moved(state, t, 0.0, state.x, state.x_low, state.y, state.turns, state.th, state.th_low)


@inline
def later(state, tau):
    """(time, its low part) when tau has passed."""
    return plus(state.t, state.t_low, tau)


@inline
def time_left(state, t_end):
    """Time from the state to t_end."""
    return (t_end - state.t) - state.t_low


@apart
def turned_by(state, angle):
    """(turns, θ, its low part) after turning by an angle of any size, with θ within half a turn of 0."""
    more, th, low = turns_and_rest(angle)
    th, low = add((th, low), (state.th, state.th_low))
    turns = state.turns + more
    if th > PI:
        turns += 1.0
        th, low = add((th, low), (-TWO_PI, -TWO_PI_LOW))
    elif th < -PI:
        turns -= 1.0
        th, low = add((th, low), (TWO_PI, TWO_PI_LOW))
    return turns, th, low


@apart
def flown(state, along, y, tau, vt, vn):
    """The state in flight, with θ̇ unchanged, after the time tau."""
    t, t_low = later(state, tau)
    x, x_low = plus(state.x, state.x_low, along)
    turns, th, th_low = turned_by(state, state.om * tau)
    after = with_anchor(moved(state, t, t_low, x, x_low, y, turns, th, th_low), NONE)
    return with_velocities(after, vt, vn, state.om)
