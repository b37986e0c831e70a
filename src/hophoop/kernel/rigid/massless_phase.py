"""The massless hoop: its load falls freely while the rim skims, until the load strikes the plane."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.panels.panel import FLY, SKIMMING, STRUCK, no_panel
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.physics.massless import skim_duration, skim_state, strike, strike_limit
from hophoop.kernel.physics.modes import UNDECIDED, slip_mode
from hophoop.kernel.records.state import later, moved, time_left, with_losses, with_velocities
from hophoop.kernel.records.writing import PendingEvent, write_event, write_plain_event, write_segment
from hophoop.kernel.rigid.ending import Ending
from hophoop.kernel.rigid.phase import begin_phase, end_motion

ROLL, FLIGHT, SKIM = int(Mode.ROLL), int(Mode.FLIGHT), int(Mode.SKIM)
SKIM_START, IMPACT = int(Event.SKIM), int(Event.IMPACT)
COMPLETED, UNDETERMINED = int(Status.COMPLETED), int(Status.UNDETERMINED)


def begin_skim(body, state, log):
    """Start to skim: the massless hoop has lost its contact force, and its load falls freely.

    Returns (mode, state); the mode is UNDECIDED if the load rises, since nothing then determines the rim's rotation.
    """
    s, c = sine_and_cosine(state.th)
    if not (s * state.om > 0.0 or (state.om == 0.0 and s != 0.0) or c == 1.0):
        return UNDECIDED, state
    if s == 0.0:
        jump = math.copysign(math.sqrt(body.gn), state.om) - state.om
        state = with_velocities(state, state.vt - 2.0 * jump, state.vn, state.om + jump)
    write_plain_event(log, SKIM_START, ROLL, SKIM, state)
    return SKIM, state


def skim(body, state, t_end, log):
    """Skim until the load strikes or time is over; return (True if the load strikes, state, v_n of the load).

    If the load strikes, v_t of the state is the velocity of the load along the plane.
    """
    s, c = sine_and_cosine(state.th)
    way = 1.0 if state.om > 0.0 or (state.om == 0.0 and s > 0.0) else -1.0
    along = state.vt + state.om * (1.0 + c)
    # within rounding of the top the load may still rise
    duration = skim_duration(body, c, max(s * state.om, 0.0))
    left = time_left(state, t_end)
    strikes = duration <= left
    tau = duration if strikes else left
    x, th, vt, om = skim_state(body, state.x, state.th, state.vt, state.om, way, tau)
    t, t_low = later(state, tau)
    if not strikes:
        t, t_low = t_end, 0.0
    # a segment that ends with the strike is marked by STRUCK and holds its duration
    write_segment(log, SKIM, no_panel(SKIMMING, 0, way), STRUCK if strikes else 0.0, tau, state, t)
    if strikes:
        x, th, vt = strike_limit(body, state.x, state.th, s, along, way, tau)
    after = with_velocities(moved(state, t, t_low, x, 0.0, 0.0, state.turns, th, 0.0), vt, 0.0, om)
    return strikes, after, -(s * state.om + body.gn * tau)


@apart
def skim_step(body, phase, limits, log, scratch):
    """Fall until the load strikes the plane or time is over; return the next phase."""
    strikes, after, vn = skim(body, phase.state, limits.t_end, log)
    if not strikes:
        return end_motion(phase, SKIM, after, Ending.TIME_LIMIT, COMPLETED)
    along, p_n, p_t = strike(body, after.vt, vn)
    lost_n = after.impact_n + 0.5 * vn * vn
    lost_t = after.impact_t + 0.5 * (after.vt * after.vt - along * along)
    landed = with_losses(with_velocities(after, along, 0.0, 0.0), after.friction, lost_n, lost_t)
    cause = PendingEvent(IMPACT, SKIM, after.vt, vn, math.nan, p_n, p_t, 0.0, 1)
    mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)
    if body.rest > 0.0:
        mode = FLIGHT
    write_event(log, cause, mode, landed, 0.0, -1)
    if body.rest > 0.0:
        # a segment of zero length holds the state after the strike; before the strike θ̇ is unbounded
        write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, 0.0, landed, landed.t)
        return end_motion(phase, mode, landed, Ending.LOAD_STRIKE, UNDETERMINED)
    return begin_phase(body, mode, landed, Ending.LOAD_STRIKE, scratch)
