"""Phase: the state that the loop over contacts and flights passes on, and how it is written to the tables."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.kernel.compliant.records import (
    FIRST,
    FRICTION,
    KIND,
    LENGTH,
    MODE,
    OM,
    REGIME,
    RESISTED,
    SIZE,
    STEP,
    T_END,
    TH,
    TURNS,
    VN,
    VT,
    T,
    X,
    Y,
    grow_rows,
)
from hophoop.kernel.compliant.tableau import STAGES
from hophoop.kernel.numerics.double_double import turns_and_rest
from hophoop.kernel.physics.body import Event, Mode
from hophoop.kernel.records.layout import EVENTS, SEGMENTS
from hophoop.kernel.records.state import FARTHEST, moved, start_state, with_losses, with_rolling_loss
from hophoop.kernel.records.writing import event_without_jump, has_room, write_event

# NumPy integers, because Numba would compile a function again for every Python integer that it is called with.
ROLL, SPIN, SKID, FLIGHT = (np.int64(mode) for mode in (Mode.ROLL, Mode.SPIN, Mode.SKID, Mode.FLIGHT))
IMPACT = np.int64(Event.IMPACT)
GOING = -1  # status of a motion that has not ended


class Phase(NamedTuple):
    """Phase of a compliant motion; its state is in `work.state`."""

    t: float
    turns: float  # whole revolutions; the state has θ within one, with all digits
    behind: float  # rounding error of `t` (Kahan sum): a step may be shorter than one ulp of `t`
    mode: int | np.int64
    regime: int | np.int64  # of friction
    begins: bool  # True at the start of a contact or of a friction regime
    h: float  # length of the next step
    before: float  # length of the step whose dense output gives Newton's first guess, or 0
    way: float  # sign of the last nonzero θ̇
    status: int  # GOING, or the Status at the end of the motion


def begin_phase(phase, t, mode, regime):
    """Start a phase at the time t."""
    return Phase(t, phase.turns, phase.behind, mode, regime, True, phase.h, phase.before, phase.way, GOING)


def with_step(phase, h, before):
    """Return the same phase with another step length."""
    return Phase(phase.t, phase.turns, phase.behind, phase.mode, phase.regime, False, h, before, phase.way, GOING)


def end_motion(phase, t, status):
    """End the motion in this phase."""
    return Phase(t, phase.turns, phase.behind, phase.mode, phase.regime, False, phase.h, phase.before, phase.way, status)


def within_turn(turns, th):
    """Return (turns, θ) with θ reduced to one revolution, if it is far outside."""
    if abs(th) <= FARTHEST:
        return turns, th
    more, rest, low = turns_and_rest(th)
    return turns + more, rest + low


def add_turns(phase, turns):
    """Return the same phase with more revolutions."""
    return Phase(
        phase.t, phase.turns + turns, phase.behind, phase.mode, phase.regime, phase.begins,
        phase.h, phase.before, phase.way, phase.status,
    )  # fmt: skip


def mode_of(regime):
    """Return the mode of a friction regime."""
    if regime == 0:
        return ROLL
    return SKID if regime > 0 else SPIN


def as_state(t, turns, u):
    """Return the state in the form in which events are written."""
    start = start_state(u[X], u[Y], u[TH], u[VT], u[VN], u[OM])
    there = moved(start, t, 0.0, start.x, 0.0, start.y, start.turns + turns, start.th, start.th_low)
    return with_rolling_loss(with_losses(there, u[FRICTION], 0.0, 0.0), u[RESISTED])


def write_plain_event(log, kind, before, after, t, turns, u):
    """Append an event without a jump of velocity."""
    state = as_state(t, turns, u)
    write_event(log, event_without_jump(kind, before, state), after, state, 0.0, -1)
    if kind == IMPACT and has_room(log):
        log.events[log.counts[EVENTS] - 1]["collision"] = 1


def append_segment(log, rows, phase, t_end, kind, length, work):
    """Append a segment; return the table, which may be a longer copy."""
    pieces = log.counts[SEGMENTS]
    log.counts[SEGMENTS] = pieces + 1
    rows = grow_rows(rows, pieces)
    row = rows[pieces]
    row[T] = phase.t
    row[T_END] = t_end
    row[KIND] = kind
    row[MODE] = phase.mode
    row[REGIME] = phase.regime
    row[TURNS] = phase.turns
    row[LENGTH] = length
    for m in range(SIZE):
        for j in range(STAGES + 1):
            at = FIRST + m * (STAGES + 1) + j
            if kind == STEP:
                row[at] = work.poly[m, j]
            else:
                row[at] = work.state[m] if j == 0 else 0.0
    return rows
