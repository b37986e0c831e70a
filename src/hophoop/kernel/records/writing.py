"""Writing of events and segments, their conversion back to states, and of times in seconds to kernel units."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.panels.panel import FLY, Panel, no_panel
from hophoop.kernel.physics.body import FLIGHT
from hophoop.kernel.records.layout import EVENTS, LETTERS_PER_INTEGER, MORE, PANEL_LIMIT, PANELS, SEGMENTS
from hophoop.kernel.records.state import State, whole_angle


class Log(NamedTuple):
    """Tables that receive the events and segments of a motion."""

    events: np.ndarray  # of records.EVENT
    segments: np.ndarray  # of records.SEGMENT; length 0 if none are wanted
    counts: np.ndarray  # numbers of events, segments (−1: the table was too short) and panels
    doubt: np.ndarray  # time of the first doubt, nan if there is none


def new_log(events, segments, scratch):
    """Return an empty log."""
    scratch.counts[EVENTS] = 0
    scratch.counts[SEGMENTS] = 0
    scratch.counts[PANELS] = 0
    scratch.doubt[0] = math.nan
    return Log(events, segments, scratch.counts, scratch.doubt)


@inline
def record_doubt(doubt, t):
    """Record the time of the first doubt of a motion: a deciding quantity is zero within rounding.

    The motion continues with the values in double precision, by the written order of ties.
    """
    if math.isnan(doubt[0]):
        doubt[0] = t


@inline
def has_room(log):
    """Return True if the tables are not full and the panels not used up."""
    return log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0 and log.counts[PANELS] < log.counts[PANEL_LIMIT]


@inline
def count_panel(log):
    """Count one pass of a loop that must end; `choose_panel` counts the panels that it solves."""
    log.counts[PANELS] += 1


class PendingEvent(NamedTuple):
    """An event that is written once the mode after it is known: mode and velocities before it, and its impulse."""

    kind: int
    mode: int
    vt: float
    vn: float
    om: float
    p_n: float
    p_t: float
    gain: float
    collision: int


def event_without_jump(kind, mode, state):
    """Return a pending event without a jump of velocity."""
    return PendingEvent(kind, mode, state.vt, state.vn, state.om, 0.0, 0.0, 0.0, -1)


@inline
def next_row(counts, which, length):
    """Return the row of the next event (0) or segment (1), and count it; −1 from the first time that the table is full."""
    count = counts[which]
    if count < 0 or count >= length:
        counts[which] = -1
        return -1
    counts[which] = count + 1
    return count


@inline
def write_state(row, state):
    """Write a state to the row of an event or segment."""
    row["t"] = state.t
    row["t_low"] = state.t_low
    row["x"] = state.x
    row["x_low"] = state.x_low
    row["height"] = state.y
    row["angle"] = whole_angle(state)
    row["revolutions"] = state.revolutions
    row["theta"] = state.th
    row["theta_low"] = state.th_low
    row["vy"] = state.vn
    row["omega"] = state.om
    row["slip"] = state.vt
    row["friction"] = state.friction
    row["impact_normal"] = state.impact_n
    row["impact_tangential"] = state.impact_t
    row["rolling_resistance"] = state.rolling_loss


@noinline
def write_event(log, cause, mode, state, gain, stable):
    """Append an event."""
    count = next_row(log.counts, EVENTS, log.events.shape[0])
    if count < 0:
        return
    row = log.events[count]
    write_state(row, state)
    row["kind"] = cause.kind
    row["before_mode"] = cause.mode
    row["after_mode"] = mode
    row["vx"] = state.vt + state.om
    row["before_vx"] = cause.vt + cause.om
    row["before_vy"] = cause.vn
    row["before_omega"] = cause.om
    row["before_slip"] = cause.vt
    row["impulse_normal"] = cause.p_n
    row["impulse_tangential"] = cause.p_t
    row["gain"] = gain
    row["collision"] = cause.collision
    row["stable"] = stable


def write_plain_event(log, kind, before, after, state):
    """Append an event without a jump of velocity."""
    write_event(log, event_without_jump(kind, before, state), after, state, 0.0, -1)


@inline
def write_segment(log, mode, panel, xi, state, t_end):
    """Append a segment that starts in `state`; a table of length 0 stays empty."""
    if log.segments.shape[0] == 0:
        return
    count = next_row(log.counts, SEGMENTS, log.segments.shape[0])
    if count < 0:
        return
    row = log.segments[count]
    write_state(row, state)
    row["t_end"] = t_end
    row["mode"] = mode
    row["kind"] = panel.kind
    row["sigma"] = panel.sigma
    row["level"] = panel.level
    row["direction"] = panel.direction
    row["ref"] = panel.ref
    row["ref_low"] = panel.ref_low
    row["sine"] = panel.sine
    row["cosine"] = panel.cosine
    row["extent"] = panel.extent
    row["torque"] = panel.torque
    row["curvature"] = panel.curvature
    row["arm"] = panel.arm
    row["kappa_p_sigma"] = panel.kappa_p_sigma
    row["u"] = panel.u
    row["xi"] = xi
    row["f_n"] = 0.0


def write_flight(log, f_n, state, t_end):
    """Append a segment of flight, which starts in `state` with the acceleration f_n of the gap."""
    write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, state, t_end)
    count = log.counts[SEGMENTS]
    if count > 0:
        log.segments[count - 1]["f_n"] = f_n


def add_letter(sequences, k, length, mode):
    """Append a mode to the packed sequence in row k of an array of uint64; return its new length."""
    longest = LETTERS_PER_INTEGER * sequences.shape[1] - 1
    if length > longest:
        return length
    letter = np.uint64(MORE if length == longest else mode + 1)
    shift = np.uint64(3 * (length % LETTERS_PER_INTEGER))
    sequences[k, length // LETTERS_PER_INTEGER] |= letter << shift
    return length + 1


@noinline
def state_of(row):
    """Return the state just after an event or at the start of a segment."""
    return State(
        row["t"], row["t_low"], row["x"], row["x_low"], row["height"], row["revolutions"], row["theta"], row["theta_low"],
        row["slip"], row["vy"], row["omega"], row["friction"], row["impact_normal"], row["impact_tangential"],
        row["rolling_resistance"],
    )  # fmt: skip


@noinline
def panel_of(row):
    """Return the panel of a segment of rolling or slip."""
    return Panel(
        row["sigma"], row["kind"], row["level"], row["direction"], row["ref"], row["ref_low"], row["sine"], row["cosine"],
        row["extent"], row["torque"], row["curvature"], row["arm"], row["kappa_p_sigma"], row["u"], row["slip"],
    )  # fmt: skip


# --- times


def find_segment(begins, t, left):
    """Return the index of the segment that contains the time t, by start times; at a boundary the earlier one if `left`."""
    low = 0
    high = begins.shape[0]
    while high - low > 1:
        middle = (low + high) // 2
        if begins[middle] < t or (begins[middle] == t and not left):
            low = middle
        else:
            high = middle
    return low


def kernel_times(begins, end, times, second, out):
    """Fill `out` with times [s] in kernel units, on the same side of each event as in seconds; at most the end of the motion.

    `begins` are the start times of the segments. Converted to seconds and back, the time of an event may differ by rounding and
    move to the event's other side. So a time equal to an event's time in seconds is mapped exactly to the event, and likewise
    for the end.
    """
    last = begins.shape[0] - 1
    for k in range(times.shape[0]):
        found = min(times[k] / second, end)
        before = find_segment(begins, found, True)
        for index in (before, min(before + 1, last)):
            begin = begins[index]
            if begin * second == times[k]:
                found = begin
        if end * second == times[k]:
            found = end
        out[k] = found
