"""How events and segments are written."""

from __future__ import annotations

from typing import NamedTuple

from hophoop._jit import jit
from hophoop.panels.anchor import NONE
from hophoop.records.state import State, whole_angle


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
