"""The state that passes through the event loop, and how events and segments are written."""

from __future__ import annotations

from typing import NamedTuple

from hophoop._jit import inline_jit, jit
from hophoop.numerics.double_double import PI, TWO_PI, TWO_PI_LOW, add, plus, turns_and_rest
from hophoop.physics.anchor import NONE, Anchor


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
    anchor: Anchor


@jit
def start_state(x, y, angle, vt, vn, om):
    """A state at t = 0, from the whole angle."""
    turns, th, th_low = turns_and_rest(angle)
    return State(0.0, 0.0, x, 0.0, y, turns, th, th_low, vt, vn, om, 0.0, 0.0, 0.0, NONE)


@inline_jit
def whole_angle(state):
    """θ with its turns."""
    return state.turns * TWO_PI + (state.th + (state.th_low + state.turns * TWO_PI_LOW))


@inline_jit
def moved(state, t, t_low, x, x_low, y, turns, th, th_low):
    """The state elsewhere, with its velocities and losses."""
    return State(
        t, t_low, x, x_low, y, turns, th, th_low, state.vt, state.vn, state.om,
        state.friction, state.impact_n, state.impact_t, state.anchor,
    )  # fmt: skip


@inline_jit
def with_velocities(state, vt, vn, om):
    """The state with other velocities."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low, vt, vn, om,
        state.friction, state.impact_n, state.impact_t, state.anchor,
    )  # fmt: skip


@inline_jit
def with_losses(state, friction, impact_n, impact_t):
    """The state with other losses."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low,
        state.vt, state.vn, state.om, friction, impact_n, impact_t, state.anchor,
    )  # fmt: skip


@inline_jit
def with_anchor(state, anchor):
    """The state with another anchor."""
    return State(
        state.t, state.t_low, state.x, state.x_low, state.y, state.turns, state.th, state.th_low,
        state.vt, state.vn, state.om, state.friction, state.impact_n, state.impact_t, anchor,
    )  # fmt: skip


@inline_jit
def at_time(state, t):
    """The state at exactly the time t."""
    return moved(state, t, 0.0, state.x, state.x_low, state.y, state.turns, state.th, state.th_low)


@inline_jit
def later(state, tau):
    """(time, its low part) when tau has passed."""
    return plus(state.t, state.t_low, tau)


@inline_jit
def time_left(state, t_end):
    """Time from the state to t_end."""
    return (t_end - state.t) - state.t_low


@jit
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


@jit
def flown(state, along, y, tau, vt, vn):
    """The state in flight, with θ̇ unchanged, after the time tau."""
    t, t_low = later(state, tau)
    x, x_low = plus(state.x, state.x_low, along)
    turns, th, th_low = turned_by(state, state.om * tau)
    after = with_anchor(moved(state, t, t_low, x, x_low, y, turns, th, th_low), NONE)
    return with_velocities(after, vt, vn, state.om)


class Cause(NamedTuple):
    """An event to be written once the mode after it is known: the mode and velocities before it, its impulse."""

    kind: int
    mode: int
    vt: float
    vn: float
    om: float
    p_n: float
    p_t: float
    gain: float
    collision: int


@jit
def quiet(kind, mode, state):
    """A cause without a jump."""
    return Cause(kind, mode, state.vt, state.vn, state.om, 0.0, 0.0, 0.0, -1)


@jit
def write_event(events, count, cause, mode, state, gain, stable):
    """Append an event; returns the new count, or -1 where the array is full."""
    if count < 0 or count >= events.shape[0]:
        return -1
    row = events[count]
    row["t"] = state.t
    row["t_low"] = state.t_low
    row["x_low"] = state.x_low
    row["turns"] = state.turns
    row["theta"] = state.th
    row["theta_low"] = state.th_low
    row["kind"] = cause.kind
    row["before_mode"] = cause.mode
    row["after_mode"] = mode
    row["x"] = state.x
    row["height"] = state.y
    row["angle"] = whole_angle(state)
    row["vx"] = state.vt + state.om
    row["vy"] = state.vn
    row["omega"] = state.om
    row["slip"] = state.vt
    row["before_vx"] = cause.vt + cause.om
    row["before_vy"] = cause.vn
    row["before_omega"] = cause.om
    row["before_slip"] = cause.vt
    row["impulse_normal"] = cause.p_n
    row["impulse_tangential"] = cause.p_t
    row["friction"] = state.friction
    row["impact_normal"] = state.impact_n
    row["impact_tangential"] = state.impact_t
    row["gain"] = gain
    row["collision"] = cause.collision
    row["stable"] = stable
    return count + 1


@jit
def copy_event(events, count, row):
    """Append an event that is known; returns the new count, or -1 where the array is full."""
    if count < 0 or count >= events.shape[0]:
        return -1
    events[count] = row
    return count + 1


@jit
def write_segment(segments, count, mode, panel, xi, opening, state, t_end):
    """Append a segment that starts in `state`; an array of length 0 keeps none; -1 where it is full."""
    if segments.shape[0] == 0:
        return count
    if count < 0 or count >= segments.shape[0]:
        return -1
    row = segments[count]
    row["t"] = state.t
    row["t_low"] = state.t_low
    row["t_end"] = t_end
    row["mode"] = mode
    row["kind"] = panel.kind
    row["sigma"] = panel.sigma
    row["level"] = panel.level
    row["way"] = panel.way
    row["ref"] = panel.ref
    row["ref_low"] = panel.ref_low
    row["sine"] = panel.sine
    row["cosine"] = panel.cosine
    row["extent"] = panel.extent
    row["arm"] = panel.arm
    row["stiffness"] = panel.stiffness
    row["u"] = panel.u
    row["xi"] = xi
    row["opening"] = opening
    row["x"] = state.x
    row["x_low"] = state.x_low
    row["height"] = state.y
    row["angle"] = whole_angle(state)
    row["turns"] = state.turns
    row["theta"] = state.th
    row["theta_low"] = state.th_low
    row["vy"] = state.vn
    row["omega"] = state.om
    row["slip"] = state.vt
    row["friction"] = state.friction
    row["impact_normal"] = state.impact_n
    row["impact_tangential"] = state.impact_t
    return count + 1


@jit
def state_of(row):
    """The state just after an event, or where a segment begins."""
    return State(
        row["t"], row["t_low"], row["x"], row["x_low"], row["height"], row["turns"], row["theta"], row["theta_low"],
        row["slip"], row["vy"], row["omega"], row["friction"], row["impact_normal"], row["impact_tangential"], NONE,
    )  # fmt: skip
