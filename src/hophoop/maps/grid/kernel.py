"""Motions of a map: each cell is a column of numbers, each result a row of reduced quantities."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from hophoop.kernel.model import PASSING, Body, Event, Mode, Status
from hophoop.kernel.records import (
    EVENT,
    EVENTS,
    SEGMENT,
    STOP_AT_TAKEOFF,
    STOP_AT_TURN,
    Cell,
    add_letter,
    body_of,
    mode_of,
    new_log,
    new_scratch,
    scales_of,
    start_of,
    state_of,
    whole_angle,
)
from hophoop.kernel.steps import Ending, collide, flight_start, fly, limits_of, run
from hophoop.maps.grid.friction_utilization import greatest_utilization

# Columns of the results, in SI units.
NUMBERS = (
    "time", "end_angle", "end_speed", "distance", "distance_rolled", "revolutions_to_rolling", "energy_lost",
    "greatest_utilization", "takeoff_time", "takeoff_angle", "hop_height", "flight_time", "flight_distance",
    "landing_angle", "landing_loss",
)  # fmt: skip
WORDS = ("status", "ending", "first_event", "hop", "painleve")
NO_FLIGHT = (math.nan,) * 7  # the last of the numbers

# How a span ended; the last four are those of `Status` that are not COMPLETED, in its order.
ENDINGS = ("duration", "revolutions", "reversal", "takeoff", "rest", "jam", "undetermined", "event_limit")
BY_TIME, BY_ANGLE, BY_REVERSAL, BY_TAKEOFF, BY_REST = range(5)
NOT_ALLOWED = -1

INTEGERS = 4  # of a packed sequence, see records.layout

FLIGHT_REQUESTED, UTILIZATION_REQUESTED = 1, 2

BLOCK = 64  # cells that share one set of scratch arrays
FIRST_EVENTS, FIRST_SEGMENTS, LONGER = 64, 256, 4  # lengths of the first arrays, and the factor to the next
# Time limit where none is requested, so that endless sliding ends too. In kernel units.
FOREVER = 1e9


class ComputedMotion(NamedTuple):
    """A computed motion, possibly truncated."""

    body: Body
    status: int
    events: Any  # of which `length` are its own
    length: int
    segments: Any  # of which `pieces` are its own; none unless the utilization is requested
    pieces: int
    cut: bool  # at its take-off at the very start, which the kernel does not look for
    t_end: float


class Workspace(NamedTuple):
    """Memory of a thread."""

    passing: Any
    segments: Any
    scratch: Any


def reduce_flight(motion, hop, scales, workspace):
    """Return the numbers of the hop that starts at an event, from its take-off to the loss of its landing."""
    body = motion.body
    row = motion.events[hop]
    begins = row["t"] * scales.time
    unknown = (begins, row["angle"], math.nan, math.nan, math.nan, math.nan, math.nan)
    state = state_of(row)
    if body.gn == 0.0:
        return unknown
    f_n, vanishing = flight_start(body, state, False)
    log = new_log(workspace.passing, workspace.segments, workspace.scratch)
    ending, landed = fly(body, state, f_n, vanishing, limits_of(state, FOREVER, math.nan, 0, 0), log)
    if ending != Ending.LANDING:
        return unknown
    height = workspace.passing[0]["height"] if log.counts[EVENTS] > 0 else 0.0
    after, _ = collide(body, body.rest, landed, Event.IMPACT, Mode.FLIGHT, 1)
    loss = (after.impact_n - landed.impact_n) + (after.impact_t - landed.impact_t)
    return (
        begins, row["angle"], height * scales.length, (landed.t - state.t) * scales.time,
        (landed.x - state.x) * scales.length, whole_angle(landed), loss * scales.energy,
    )  # fmt: skip


def first_beyond(events, count, angle_span):
    """Return the index of the first event at which the rotation has reached the span, or of the last event."""
    if not math.isnan(angle_span):
        for i in range(count):
            if abs(events[i]["angle"] - events[0]["angle"]) >= angle_span:
                return i
    return count - 1


def ending_of(motion, request):
    """Return the limit or event that ended the span."""
    if motion.cut:
        return BY_TAKEOFF
    events = motion.events
    count = motion.length
    if motion.status != Status.COMPLETED:
        return BY_REST + motion.status - Status.AT_REST
    end = events[count - 1]
    for i in range(count - 2, -1, -1):
        before = events[i]
        if before["t"] != end["t"]:
            break
        if request.stop & STOP_AT_TURN and before["kind"] == Event.TURN:
            return BY_REVERSAL
        if request.stop & STOP_AT_TAKEOFF and before["after_mode"] == Mode.FLIGHT:
            return BY_TAKEOFF
    return BY_TIME if end["t"] >= motion.t_end else BY_ANGLE


def first_hop(events, count):
    """Return the index of the event at which the rim first leaves the plane, or -1."""
    for i in range(count):
        row = events[i]
        touches = row["height"] == 0.0 and not row["vy"] < 0.0
        if row["after_mode"] == Mode.FLIGHT and touches and row["kind"] not in PASSING:
            return i
    return -1


def reduce_motion(motion, request, hop, scales, workspace, results, k):
    """Write row k of the results from the events of one motion; `hop` is the event of its first take-off, or -1."""
    numbers, words, sequences = results
    events = motion.events
    last = motion.length - 1
    ending = ending_of(motion, request)
    painleve = 0
    first = -1
    rolled = 0.0
    rolling_since = math.nan
    mode = -1
    mark = -1
    length = 0
    ended = events[last]["t"]
    for i in range(motion.length):
        row = events[i]
        kind, follows = row["kind"], row["after_mode"]
        if i > 0 and first < 0 and kind != Event.APEX:
            first = kind
        if kind in (Event.PAINLEVE_INCONSISTENT, Event.PAINLEVE_INDETERMINATE, Event.JAM):
            painleve = 1
        if kind == Event.REST:
            ended = row["t"]
        if i < last and follows == Mode.ROLL:
            rolled += abs(events[i + 1]["x"] - row["x"])
        if kind in PASSING and i < last:
            continue
        if mark >= 0 and row["t"] > events[mark]["t"]:
            length = add_letter(sequences, k, length, mode)
        mark = i
        if follows == Mode.ROLL and mode != Mode.ROLL:
            rolling_since = row["angle"]
        mode = follows
    if ending == BY_TAKEOFF or length == 0:
        length = add_letter(sequences, k, length, mode)
    start = events[0]
    end = events[last]
    revolutions = abs(rolling_since - start["angle"]) / (2.0 * math.pi) if mode == Mode.ROLL and ending <= BY_REST else math.nan
    lost = end["friction"] + end["impact_normal"] + end["impact_tangential"] + end["rolling_resistance"]
    used = greatest_utilization(motion, workspace.scratch) if request.quantities & UTILIZATION_REQUESTED else math.nan
    flight = NO_FLIGHT
    if hop >= 0 and request.quantities & FLIGHT_REQUESTED:
        flight = reduce_flight(motion, hop, scales, workspace)
    whole = (
        ended * scales.time, end["angle"], end["vx"] * scales.speed, (end["x"] - start["x"]) * scales.length,
        rolled * scales.length, revolutions, lost * scales.energy, used,
    )  # fmt: skip
    found = whole + flight
    for i in range(len(found)):
        numbers[k, i] = found[i]
    status = Status.COMPLETED if motion.cut else motion.status
    coded = (status, ending, Event.TAKEOFF if motion.cut and first < 0 else first, 1 if hop >= 0 else 0, painleve)
    for i in range(len(coded)):
        words[k, i] = coded[i]


def evaluate_cell(cells, k, request, events, segments, workspace, results):
    """Compute one cell; return False where `events` or `segments` is too short for its motion.

    `workspace.passing` takes 2 more events, and `workspace.segments` has length 0.
    """
    results.numbers[k, :] = math.nan
    results.words[k, :] = NOT_ALLOWED
    results.sequences[k, :] = 0
    if cells[Cell.ALLOWED, k] == 0.0:
        return True
    scales = scales_of(cells[:, k])
    body = body_of(cells[:, k])
    start = start_of(cells[:, k], scales.time)
    t_end = cells[Cell.DURATION, k] / scales.time if request.timed else FOREVER
    angle_span, stop, scratch = request.angle_span, request.stop, workspace.scratch
    most = int(cells[Cell.MAX_EVENTS, k])
    events = events[:most]
    mode = mode_of(cells[:, k])
    status, count, pieces = run(body, start, mode, t_end, angle_span, stop, events, segments, scratch)
    if status == Status.BUFFER:
        return False
    beyond = first_beyond(events, count, angle_span)
    if beyond < count - 1:  # an event at the very end of the span
        count = beyond + 1
        status = Status.COMPLETED
    if status == Status.EVENT_LIMIT and events.shape[0] < most:
        return False
    hop = first_hop(events, count)
    # the kernel looks for a take-off after the start only
    cut = hop >= 0 and stop & STOP_AT_TAKEOFF != 0 and events[hop]["t"] == 0.0
    motion = ComputedMotion(body, status, events, hop + 1 if cut else count, segments, pieces, cut, t_end)
    reduce_motion(motion, request, hop, scales, workspace, results, k)
    return True


def evaluate_block(cells, low, high, request, results):
    """Compute the cells from `low` to `high`."""
    usual = np.empty(FIRST_EVENTS, EVENT)
    first = np.empty(FIRST_SEGMENTS if request.quantities & UTILIZATION_REQUESTED else 0, SEGMENT)
    workspace = Workspace(np.empty(2, EVENT), np.empty(0, SEGMENT), new_scratch())
    for k in range(low, high):
        events, segments = usual, first
        while not evaluate_cell(cells, k, request, events, segments, workspace, results):
            events = np.empty(min(LONGER * events.shape[0], int(cells[Cell.MAX_EVENTS, k])), EVENT)
            segments = np.empty(LONGER * segments.shape[0], SEGMENT)
