"""The state of a compliant motion, the record of every accepted step, and the phase that the loop passes on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.kernel.native import replaced
from hophoop.kernel.numerics.arithmetic import revolutions_and_rest
from hophoop.kernel.numerics.collocation import DEPTH, ORDER
from hophoop.kernel.numerics.tables import RADAU_LAMBDA, RADAU_NODES
from hophoop.kernel.physics.body import IMPACT, ROLL, SKID, SPIN
from hophoop.kernel.records.layout import EVENTS, SEGMENTS
from hophoop.kernel.records.state import FARTHEST, start_state
from hophoop.kernel.records.writing import event_without_jump, has_room, write_event

STAGES = len(RADAU_NODES)  # of Radau IIA
BLOCKS = 1 + len(RADAU_LAMBDA)  # of Newton's system, in the eigenbasis of A⁻¹

# Variables of the state array, in kernel units; `bristle` is z; `friction`, `damping`, `rolling_resistance`: energy lost so
# far.
VARIABLES = ("height", "angle", "slip", "vy", "omega", "bristle", "x", "friction", "damping", "rolling_resistance")
Y, TH, VT, VN, OM, Z, X, FRICTION, DAMPING, ROLLING_LOSS = range(10)
DYNAMIC = 6  # the first 6; the others are integrals along the motion, on which nothing depends
SIZE = len(VARIABLES)
MEASURED = 9  # number of variables in the mean error of a step

# Kinds of segments.
STEP, FLY, RESTING = 0.0, 1.0, 2.0
# Columns of a segment. A STEP is the polynomial Σ_j p_j s^j, s = (t − its start)/step. FLY and RESTING only keep p_0, and FLY
# has f_n at its start in `step`. The angle is θ within one revolution; `revolutions` counts whole ones.
T, T_END, KIND, MODE, REGIME, REVOLUTIONS, LENGTH, FIRST = range(8)  # FIRST: where the polynomials start
WIDTH = FIRST + SIZE * (STAGES + 1)
SEGMENT = np.dtype(
    [(name, "f8") for name in ("t", "t_end", "kind", "mode", "regime", "revolutions", "step")]
    + [(f"{name}_{power}", "f8") for name in VARIABLES for power in range(STAGES + 1)]
)


class Work(NamedTuple):
    """Scratch arrays of a step."""

    state: np.ndarray
    stages: np.ndarray  # Z_i, increments of the dynamic variables
    integrals: np.ndarray  # increments of the integrals
    rates: np.ndarray  # f at the stages
    powers: np.ndarray  # integrands at the stages
    start_rate: np.ndarray
    trial: np.ndarray
    jacobian: np.ndarray
    blocks: np.ndarray  # factors of Newton's system
    pivots: np.ndarray
    side: np.ndarray
    forms: np.ndarray  # the stages in the eigenbasis
    error: np.ndarray
    scale: np.ndarray
    atol: np.ndarray
    poly: np.ndarray  # Σ_j poly[:, j] s^j
    start: np.ndarray
    nodes: np.ndarray  # the dynamic variables at the nodes of a panel
    values: np.ndarray  # of margins there
    series: np.ndarray
    stack: np.ndarray


def new_work():
    """Return a new set of scratch arrays."""
    return Work(
        np.zeros(SIZE),
        np.zeros((STAGES, DYNAMIC)),
        np.zeros((STAGES, SIZE - DYNAMIC)),
        np.zeros((STAGES, DYNAMIC)),
        np.zeros((STAGES, SIZE - DYNAMIC)),
        np.zeros(SIZE),
        np.zeros(DYNAMIC),
        np.zeros((DYNAMIC, DYNAMIC)),
        np.zeros((BLOCKS, DYNAMIC, DYNAMIC), np.complex128),
        np.zeros((BLOCKS, DYNAMIC), np.int64),
        np.zeros(DYNAMIC, np.complex128),
        np.zeros((BLOCKS, DYNAMIC), np.complex128),
        np.zeros(SIZE),
        np.zeros(SIZE),
        np.zeros(SIZE),
        np.zeros((SIZE, STAGES + 1)),
        np.zeros(SIZE),
        np.zeros((DYNAMIC, ORDER)),
        np.zeros((2, ORDER)),
        np.zeros(ORDER),
        np.zeros((DEPTH + 3, ORDER + 2)),
    )


# --- the phase

GOING = -1  # status of a motion that has not ended


class Phase(NamedTuple):
    """Phase of a compliant motion; its state is in `work.state`."""

    t: float
    revolutions: float  # whole revolutions; the state has θ within one, with all digits
    behind: float  # rounding error of `t` (Kahan sum): a step may be shorter than one ulp of `t`
    mode: int
    regime: int  # of friction
    begins: bool  # True at the start of a contact or of a friction regime
    h: float  # length of the next step
    before: float  # length of the step whose dense output gives Newton's first guess, or 0
    direction: float  # sign of the last nonzero θ̇
    status: int  # GOING, or the Status at the end of the motion


def begin_phase(phase, t, mode, regime):
    """Start a phase at the time t."""
    return replaced(phase, t=t, mode=mode, regime=regime, begins=True)


def with_step(phase, h, before):
    """Return the same phase with another step length."""
    return replaced(phase, begins=False, h=h, before=before)


def end_motion(phase, t, status):
    """End the motion in this phase."""
    return replaced(phase, t=t, begins=False, status=status)


def within_revolution(revolutions, th):
    """Return (revolutions, θ) with θ reduced to one revolution, if it is far outside."""
    if abs(th) <= FARTHEST:
        return revolutions, th
    more, rest, low = revolutions_and_rest(th)
    return revolutions + more, rest + low


def mode_of(regime):
    """Return the mode of a friction regime."""
    if regime == 0:
        return ROLL
    return SKID if regime > 0 else SPIN


def as_state(t, revolutions, u):
    """Return the state in the form in which events are written."""
    start = start_state(u[X], u[Y], u[TH], u[VT], u[VN], u[OM])
    turned = start.revolutions + revolutions
    return replaced(start, t=t, revolutions=turned, friction=u[FRICTION], rolling_loss=u[ROLLING_LOSS])


def write_plain_event(log, kind, before, after, t, revolutions, u):
    """Append an event without a jump of velocity."""
    state = as_state(t, revolutions, u)
    write_event(log, event_without_jump(kind, before, state), after, state, 0.0, -1)
    if kind == IMPACT and has_room(log):
        log.events[log.counts[EVENTS] - 1]["collision"] = 1


def append_segment(log, phase, t_end, kind, length, work):
    """Append a segment; those beyond the end of the table are only counted."""
    pieces = log.counts[SEGMENTS]
    log.counts[SEGMENTS] = pieces + 1
    if pieces >= log.segments.shape[0]:
        return
    row = log.segments[pieces]
    row[T] = phase.t
    row[T_END] = t_end
    row[KIND] = kind
    row[MODE] = phase.mode
    row[REGIME] = phase.regime
    row[REVOLUTIONS] = phase.revolutions
    row[LENGTH] = length
    for m in range(SIZE):
        for j in range(STAGES + 1):
            at = FIRST + m * (STAGES + 1) + j
            if kind == STEP:
                row[at] = work.poly[m, j]
            else:
                row[at] = work.state[m] if j == 0 else 0.0
