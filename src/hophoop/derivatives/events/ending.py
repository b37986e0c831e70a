"""A motion gone through with its derivatives, and where these end: at a doubt, or at a landing with e = 0; nopython mode."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import CARRIED, IMPACT_N, IMPACT_T, KEPT, OM, P_N, P_T, VN, VT, Reason
from hophoop.derivatives.replay import replay
from hophoop.kernel.physics.body import Event

BORDER, PLASTIC, CONTACT = int(Reason.BORDER), int(Reason.PLASTIC), int(Reason.CONTACT)
END = int(Event.END)
LOST = (P_N, P_T, IMPACT_N, IMPACT_T)  # of the bounces that a small restitution makes, there is no derivative


def end_at_landing(events, segments, landing, k, edges, at_events, at_segments):
    """Take away what bounces behind a landing, or the start, make different: velocities, later events, shares of the loss."""
    count = events.shape[0]
    for row in (OM, VT, VN, P_N, P_T, IMPACT_N, IMPACT_T):
        at_events[landing, row, k] = math.nan
    keeps_last = edges and landing + 1 < count and events[count - 1]["kind"] == END
    for i in range(landing + 1, count):
        if i == count - 1 and keeps_last:
            for row in LOST:
                at_events[i, row, k] = math.nan
        else:
            for row in range(KEPT):
                at_events[i, row, k] = math.nan
    for i in range(segments.shape[0]):
        if segments[i]["t"] >= events[landing]["t"]:
            for row in range(CARRIED):
                if not edges or row in (IMPACT_N, IMPACT_T):
                    at_segments[i, row, k] = math.nan


def end_in_doubt(events, segments, doubt, at_events, at_segments, reasons, failed):
    """Take away what lies behind a time from which on doubles cannot tell what follows."""
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


def go_through(
    body, events, segments, changes, z, t_end, doubt, edges, at_events, at_segments, reasons, failed, scratch, local
):  # fmt: skip
    """`replay`, and its ends.

    Parameters
    ----------
    body : Body
    events, segments, changes, z, t_end
        As `replay`.
    doubt : float
        From when on doubles cannot tell what follows, in kernel units; inf where they always can.
    edges : bool
        Keep also how states change with a restitution that is 0 and becomes larger, behind a landing.
    at_events, at_segments, reasons, failed, scratch, local
        As `replay`.
    """
    replay(body, events, segments, changes, z, t_end, at_events, at_segments, reasons, failed, scratch, local)
    for k in range(reasons.shape[0]):
        if reasons[k] in (PLASTIC, CONTACT):
            end_at_landing(events, segments, failed[k], k, edges, at_events, at_segments)
    if doubt < math.inf:
        end_in_doubt(events, segments, doubt, at_events, at_segments, reasons, failed)
