"""Continuation of a motion from the start of one of its phases, with the same bits as the motion that was not interrupted."""

from __future__ import annotations

import math

from hophoop.kernel.records.writing import new_log
from hophoop.kernel.rigid.limits import limits_of
from hophoop.kernel.rigid.phase import Phase
from hophoop.kernel.rigid.run import follow
from hophoop.kernel.rigid.script import repeat


def continue_motion(body, bounce, t_end, events, segments, scratch, script):
    """Compute a motion from an event that starts a phase.

    Parameters
    ----------
    body : Body
    bounce : float
        v_n after the last landing before it, 0 if there was none.
    t_end : float
        Time at which the motion ends, with the same origin as the event's time; all quantities are in kernel units.
    events, segments : ndarray of records.EVENT, records.SEGMENT
        Filled; the first event is the given one.
    scratch : records.Scratch
    script : ndarray of records.EVENT, length 2
        The event, twice.

    Returns
    -------
    status, number of events, number of segments : int
        As `run`.
    """
    scratch.doubt[0] = math.nan
    scratch.doubt[1] = math.nan
    log = new_log(events, segments, scratch)
    phase = repeat(body, script, log, scratch)
    phase = Phase(
        phase.mode, phase.state, phase.begins, phase.zeros, phase.opening, phase.level, bounce, phase.what, phase.status
    )
    return follow(body, phase, limits_of(phase.state, t_end, math.nan, 0), log, scratch)
