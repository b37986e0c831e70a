"""Propagate the derivatives of a motion up to where doubles do not decide what follows."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import Reason
from hophoop.derivatives.tangents import propagate_tangents

BORDER = int(Reason.BORDER)


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


def propagate_motion(body, motion, parameter_tangents, tangents, solution, workspace):
    """Fill in the derivatives of a motion, nan where there are none.

    Parameters
    ----------
    body : Body
    motion : KnownMotion
    parameter_tangents, tangents
        As `propagate_tangents`.
    solution : Solution
    workspace : Workspace
    """
    propagate_tangents(body, motion, parameter_tangents, tangents, solution, workspace)
    if motion.doubt < math.inf:
        end_in_doubt(motion, solution)
