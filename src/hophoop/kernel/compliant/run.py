"""The event loop over contacts and flights on a compliant plane, in nopython mode."""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.compliant.contact_step import contact_step
from hophoop.kernel.compliant.events import GUARDS
from hophoop.kernel.compliant.flight import flight_step
from hophoop.kernel.compliant.phase import FLIGHT, GOING, Phase, end_motion, mode_of, within_turn, write_plain_event
from hophoop.kernel.compliant.records import (
    DYNAMIC,
    OM,
    SIZE,
    TH,
    VN,
    VT,
    WIDTH,
    Y,
    Z,
    new_work,
)
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.physics.compliant import BRISTLE, first_regime, normal_force
from hophoop.kernel.records.layout import EVENTS, PANELS, SEGMENTS
from hophoop.kernel.records.writing import Log, count_panel, has_room

START, END = np.int64(Event.START), np.int64(Event.END)
NO_MODE = np.int64(-1)
COMPLETED, EVENT_LIMIT = int(Status.COMPLETED), int(Status.EVENT_LIMIT)
MAX_STEPS = 300_000  # a few seconds, and about 140 MB


def set_tolerances(body, comp, work):
    """Set the sizes of the variables to which errors are relative."""
    work.atol[Y] = min(1.0, 1.0 / comp.k)
    work.atol[TH] = 1.0
    work.atol[VT] = min(1.0, comp.v_s)
    work.atol[VN] = min(1.0, 1.0 / math.sqrt(comp.k))
    work.atol[OM] = min(1.0, comp.om_s) if body.resist > 0.0 else 1.0
    work.atol[Z] = 1.0
    if comp.friction == BRISTLE:
        work.atol[Z] = min(1.0, 1.0 / comp.k_t)
    for m in range(DYNAMIC, SIZE):
        work.atol[m] = 1.0


def begin(comp, touching, log, work):
    """Start a motion and return its first phase."""
    u = work.state
    regime = np.int64(0)
    mode = FLIGHT
    if touching:
        regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
        mode = mode_of(regime)
    turns, u[TH] = within_turn(0.0, u[TH])
    write_plain_event(log, START, NO_MODE if touching else FLIGHT, mode, 0.0, turns, u)
    return Phase(0.0, turns, 0.0, mode, regime, True, 0.0, 0.0, 0.0, GOING)


def run(body, comp, start, touching, t_end, rtol, max_steps, events, no_segments, reached):
    """Compute a motion up to the final time.

    Parameters
    ----------
    body : Body
    comp : Compliance
    start : ndarray, shape (SIZE,)
        Not changed.
    touching : bool
        True if the contact acts at the start.
    t_end, rtol : float
    max_steps : int
        Maximum of steps, failed ones included, and flights; the motion is given up there.
    events : ndarray of records.EVENT
        Filled.
    no_segments : ndarray of records.SEGMENT
        Of length 0.
    reached : ndarray, shape (1,)
        Progress: the computed fraction of the time, for another thread.

    Returns
    -------
    status, number of events, segments, number of segments
    """
    work = new_work()
    rows = np.empty((256, WIDTH))
    armed = np.zeros(GUARDS, np.bool_)
    for m in range(SIZE):
        work.state[m] = start[m]
    set_tolerances(body, comp, work)
    log = Log(events, no_segments, np.array([0, 0, 0, max_steps + 1]), np.full(1, math.nan))
    phase = begin(comp, touching, log, work)
    while phase.status == GOING and phase.t < t_end and has_room(log):
        count_panel(log)  # failed steps count too
        if log.counts[PANELS] >= max_steps:
            phase = end_motion(phase, phase.t, EVENT_LIMIT)
        elif phase.mode == FLIGHT:
            phase, rows = flight_step(body, comp, phase, t_end, log, rows, work)
        else:
            phase, rows = contact_step(body, comp, phase, t_end, rtol, armed, log, rows, work)
        reached[0] = phase.t / t_end
    write_plain_event(log, END, phase.mode, phase.mode, phase.t, phase.turns, work.state)
    if log.counts[EVENTS] < 0:
        return EVENT_LIMIT, events.shape[0], rows, log.counts[SEGMENTS]
    return COMPLETED if phase.status == GOING else phase.status, log.counts[EVENTS], rows, log.counts[SEGMENTS]


def run_into(body, comp, start, touching, t_end, rtol, max_steps, events, no_segments, reached, kept):
    """Compute as `run` does and copy the segments into `kept` as far as they fit; return (status, events, segments)."""
    status, count, rows, pieces = run(body, comp, start, touching, t_end, rtol, max_steps, events, no_segments, reached)
    for k in range(min(pieces, kept.shape[0])):
        kept[k] = rows[k]
    return status, count, pieces
