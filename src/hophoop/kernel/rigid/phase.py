"""Phase: the state that the event loop passes from one step to the next."""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.physics.body import Mode, Status
from hophoop.kernel.physics.contact import free_acceleration
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.state import State
from hophoop.kernel.rigid.doubts import record_doubt
from hophoop.kernel.rigid.panel_choice import START_LEVEL

ROLL, FLIGHT, SKIM = int(Mode.ROLL), int(Mode.FLIGHT), int(Mode.SKIM)
UNDETERMINED = int(Status.UNDETERMINED)
GOING = -1  # status of a motion that has not ended


class Phase(NamedTuple):
    """A phase of the motion, with the state that it has reached."""

    mode: int
    state: State
    begins: bool  # True at the start of the phase: margins that are zero there are no events
    zeros: int  # order of the zero of v_t (slip) or of the gap (flight) at the start
    opening: float  # flight: f_n at the start, exactly 0 after a lift-off from slip
    level: int  # level of the next panel's width
    what: int  # Ending of the last panel
    status: int  # GOING, or the Status at the end of the motion


@inline
def opening_of(body, state):
    """Return (f_n at the start of a flight, exactly 0 after lift-off from slip; number of vanishing derivatives of the gap)."""
    s, c = sine_cosine(state.th, state.th_low)
    opening = free_acceleration(body, s, c, state.om * state.om)[1]
    if state.y > 0.0:
        return opening, 0
    if state.vn > 0.0:
        return opening, 1
    if opening <= 1e-13 * (body.gn + state.om * state.om):
        return 0.0, 3
    return opening, 2


@inline
def begin_phase(body, mode, state, what, scratch):
    """Start a phase; an UNDECIDED mode ends the motion."""
    opening = 0.0
    zeros = 1 if state.vt == 0.0 else 0
    status = GOING
    if mode == FLIGHT:
        opening, zeros = opening_of(body, state)
    elif mode == UNDECIDED:
        status = UNDETERMINED
        if body.kap > 0.0 and not math.isinf(body.mu_s):
            record_doubt(scratch, state.t)
    return Phase(mode, state, True, zeros, opening, START_LEVEL, what, status)


@inline
def begin_flight_after_slip(state, what):
    """Start the flight after a lift-off from slip, where N, and with it f_n, is zero."""
    return Phase(FLIGHT, state, True, 3, 0.0, START_LEVEL, what, GOING)


@inline
def begin_slip_after_roll(body, mode, state, what):
    """Start the slip after rolling has reached the friction cone; v̇_t is zero there too if μs = μk."""
    return Phase(mode, state, True, 2 if body.mu_s == body.mu_k else 1, 0.0, START_LEVEL, what, GOING)


@inline
def continue_phase(phase, state, level, what):
    """Continue the phase from `state`."""
    return Phase(phase.mode, state, False, phase.zeros, phase.opening, level, what, GOING)


@inline
def end_motion(phase, mode, state, what, status):
    """End the motion in a mode and state."""
    return Phase(mode, state, False, phase.zeros, phase.opening, phase.level, what, status)
