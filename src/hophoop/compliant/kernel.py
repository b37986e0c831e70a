"""The loop over contacts and flights on a compliant plane, in nopython mode."""

from __future__ import annotations

import math

import numpy as np

from hophoop._native import compiled
from hophoop.compliant.contact_step import contact_step
from hophoop.compliant.events import GUARDS
from hophoop.compliant.flight import flight_step
from hophoop.compliant.parameters import to_compliance, to_start
from hophoop.compliant.phase import FLIGHT, GOING, Phase, ended, mode_of, note, within_turn
from hophoop.compliant.records import (
    DYNAMIC,
    FIRST,
    FLY,
    HOLD,
    KIND,
    MODE,
    OM,
    REGIME,
    SEGMENT,
    SIZE,
    TH,
    TURNS,
    VN,
    VT,
    WIDTH,
    Y,
    Z,
    new_work,
)
from hophoop.compliant.tableau import STAGES
from hophoop.physics.body import Event, Mode, Status
from hophoop.physics.compliant import BRISTLE, first_regime, normal_force
from hophoop.records.layout import EVENT
from hophoop.records.layout import SEGMENT as RIGID_SEGMENT
from hophoop.records.writing import Log, count_panel, has_room
from hophoop.scenario import Scenario

START, END = np.int64(Event.START), np.int64(Event.END)
NO_MODE = np.int64(-1)
COMPLETED, EVENT_LIMIT = int(Status.COMPLETED), int(Status.EVENT_LIMIT)


def set_tolerances(body, comp, work):
    """Sizes of the variables beside which errors are measured."""
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
    """The first phase of a motion."""
    u = work.state
    regime = np.int64(0)
    mode = FLIGHT
    if touching:
        regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
        mode = mode_of(regime)
    turns, u[TH] = within_turn(0.0, u[TH])
    note(log, START, NO_MODE if touching else FLIGHT, mode, 0.0, turns, u)
    return Phase(0.0, turns, 0.0, mode, regime, True, 0.0, 0.0, 0.0, GOING)


def run(body, comp, start, touching, t_end, rtol, max_steps, events, no_segments, reached):
    """The motion from a state to the end of time.

    Parameters
    ----------
    body : Body
    comp : Compliance
    start : ndarray, shape (SIZE,)
        Not changed.
    touching : bool
        Whether the contact acts at the start.
    t_end, rtol : float
    max_steps : int
        Steps, failed ones included, and flights after which the motion is given up.
    events : ndarray of records.EVENT
        Filled.
    no_segments : ndarray of records.SEGMENT
        Of length 0.
    reached : ndarray, shape (1,)
        The share of the time that is computed, for who looks on from another thread.

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
    log = Log(events, no_segments, np.array([0, 0, 0, max_steps + 1]))
    phase = begin(comp, touching, log, work)
    while phase.status == GOING and phase.t < t_end and has_room(log):
        count_panel(log)  # also of a step that failed
        if log.written[2] >= max_steps:
            phase = ended(phase, phase.t, EVENT_LIMIT)
        elif phase.mode == FLIGHT:
            phase, rows = flight_step(body, comp, phase, t_end, log, rows, work)
        else:
            phase, rows = contact_step(body, comp, phase, t_end, rtol, armed, log, rows, work)
        reached[0] = phase.t / t_end
    note(log, END, phase.mode, phase.mode, phase.t, phase.turns, work.state)
    if log.written[0] < 0:
        return EVENT_LIMIT, events.shape[0], rows, log.written[1]
    return COMPLETED if phase.status == GOING else phase.status, log.written[0], rows, log.written[1]


def run_into(body, comp, start, touching, t_end, rtol, max_steps, events, no_segments, reached, kept):
    """`run` with its segments copied into `kept`, as many as it has room for; (status, number of events, of segments)."""
    status, count, rows, pieces = run(body, comp, start, touching, t_end, rtol, max_steps, events, no_segments, reached)
    for k in range(min(pieces, kept.shape[0])):
        kept[k] = rows[k]
    return status, count, pieces


FIRST_EVENTS = 256
FIRST_ROWS = 20_000  # 9 MB, of which only what is written is taken from the system
MAX_STEPS = 300_000  # some seconds, and some 140 MB


def simulate_compliant(scenario: Scenario, reached: np.ndarray | None = None) -> tuple[int, np.ndarray, np.ndarray]:
    """Compute the motion of a scenario with compliant contact.

    Parameters
    ----------
    scenario : Scenario
        Its contact is Compliant.
    reached : ndarray, shape (1,), optional
        Is given the share of the duration that is computed, again and again [1].

    Returns
    -------
    status : int
        A Status.
    events : ndarray of hophoop.records.layout.EVENT
    segments : ndarray of hophoop.compliant.records.SEGMENT
        Both in units of R, m and √(R/g).
    """
    body, comp, t_end, rtol = to_compliance(scenario)
    start, touching = to_start(scenario, body, comp)
    limit = scenario.contact.max_events
    size = min(FIRST_EVENTS, limit)
    reached = np.zeros(1) if reached is None else reached
    room = FIRST_ROWS
    while True:
        events = np.empty(size, EVENT)
        rows = np.empty((room, WIDTH))
        status, count, pieces = compiled(run_into)(
            body, comp, start, touching, t_end, rtol, MAX_STEPS, events, np.empty(0, RIGID_SEGMENT), reached, rows
        )
        if pieces > room:
            room = MAX_STEPS
            continue
        if status != EVENT_LIMIT or count < size or size == limit:
            break
        size = min(8 * size, limit)
    if pieces == 0:  # no time has passed before the limit: a piece of no length holds the start
        pieces = 1
        rows[0] = 0.0
        rows[0, KIND] = HOLD if touching else FLY
        rows[0, MODE] = events[count - 1]["after_mode"]
        mode = events[count - 1]["after_mode"]
        rows[0, REGIME] = float(mode == Mode.SKID) - float(mode == Mode.SPIN)
        rows[0, TURNS] = events[count - 1]["turns"]
        rows[0, FIRST :: STAGES + 1] = start
        rows[0, FIRST + TH * (STAGES + 1)] = events[count - 1]["theta"]
    segments = np.ascontiguousarray(rows[:pieces]).view(SEGMENT)[:, 0]
    return status, events[:count].copy(), segments
