"""Propagate the derivatives of a motion up to where they end: at a doubt, or at a landing with e = 0."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import EVENT_ROWS, IMPACT_N, IMPACT_T, OM, P_N, P_T, STATE_ROWS, VN, VT, Reason
from hophoop.derivatives.tangents import propagate_tangents
from hophoop.kernel.physics.body import Event

BORDER, PLASTIC, CONTACT = int(Reason.BORDER), int(Reason.PLASTIC), int(Reason.CONTACT)
END = int(Event.END)
LOST = (P_N, P_T, IMPACT_N, IMPACT_T)  # there is no derivative of the bounces that a small restitution causes


def end_at_landing(motion, landing, k, edges, solution):
    """Set to nan what bounces after a landing, or after the start, change: velocities, later events, shares of the loss."""
    events, segments = motion.events, motion.segments
    at_events, at_segments = solution.at_events, solution.at_segments
    count = events.shape[0]
    for row in (OM, VT, VN, P_N, P_T, IMPACT_N, IMPACT_T):
        at_events[landing, row, k] = math.nan
    keeps_last = edges and landing + 1 < count and events[count - 1]["kind"] == END
    for i in range(landing + 1, count):
        if i == count - 1 and keeps_last:
            for row in LOST:
                at_events[i, row, k] = math.nan
        else:
            for row in range(EVENT_ROWS):
                at_events[i, row, k] = math.nan
    for i in range(segments.shape[0]):
        if segments[i]["t"] >= events[landing]["t"]:
            for row in range(STATE_ROWS):
                if not edges or row in (IMPACT_N, IMPACT_T):
                    at_segments[i, row, k] = math.nan


def end_in_doubt(motion, solution):
    """Set to nan what is after a time from which doubles do not decide what follows."""
    events, segments, doubt = motion.events, motion.segments, motion.doubt
    at_events, at_segments = solution.at_events, solution.at_segments
    reasons, failed = solution.reasons, solution.failed
    first = events.shape[0]
    for i in range(events.shape[0] - 1, -1, -1):
        if events[i]["t"] > doubt:
            first = i
            at_events[i] = math.nan
    for i in range(segments.shape[0]):
        if segments[i]["t"] >= doubt:
            at_segments[i] = math.nan
    for k in range(reasons.shape[0]):
        if failed[k] < 0 or failed[k] > first:
            failed[k] = first
            reasons[k] = BORDER


def propagate_motion(body, motion, parameter_tangents, tangents, edges, solution, workspace):
    """Fill in the derivatives of a motion, nan where there are none.

    Parameters
    ----------
    body : Body
    motion : KnownMotion
    parameter_tangents, tangents
        As `propagate_tangents`.
    edges : bool
        Keep also how states after a landing change with a restitution that is 0 and becomes larger.
    solution : Solution
    workspace : Workspace
    """
    propagate_tangents(body, motion, parameter_tangents, tangents, solution, workspace)
    for k in range(solution.reasons.shape[0]):
        if solution.reasons[k] in (PLASTIC, CONTACT):
            end_at_landing(motion, solution.failed[k], k, edges, solution)
    if motion.doubt < math.inf:
        end_in_doubt(motion, solution)
