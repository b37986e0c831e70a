"""Phases without contact force: flight up to the landing and its impact, and the skim of a massless hoop.

A massless hoop that has lost its contact force skims: its load falls freely, with the rim on the plane, until the load strikes.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline, replaced
from hophoop.kernel.numerics.arithmetic import PI
from hophoop.kernel.numerics.circular import sine, sine_and_cosine, sine_cosine
from hophoop.kernel.panels.landing import first_landing
from hophoop.kernel.panels.panel import FLY, SKIMMING, STRUCK, no_panel
from hophoop.kernel.physics.body import APEX, COMPLETED, EVENT_LIMIT, FLIGHT, IMPACT, ROLL, SKIM, SKIM_START, UNDETERMINED
from hophoop.kernel.physics.closed_forms import (
    flight_displacement,
    flight_gap,
    revolutions_before,
    skim_duration,
    skim_state,
    strike,
    strike_limit,
)
from hophoop.kernel.physics.contact import free_acceleration
from hophoop.kernel.physics.modes import UNDECIDED, slip_mode
from hophoop.kernel.records.layout import STOP_AT_TAKEOFF
from hophoop.kernel.records.state import flown, later, time_left
from hophoop.kernel.records.writing import PendingEvent, write_event, write_flight, write_plain_event, write_segment
from hophoop.kernel.rigid.phase import ROUNDING, Ending, angle_left, at_span, begin_phase, end_motion
from hophoop.kernel.rigid.transitions import collide, end_bounces, resolve_mode

# A sequence of bounces is closed when the bounces to come would take less than this fraction of the time so far.
CLOSING = 1e-12
SLOWEST_BOUNCE = 1e-100  # the heights of slower bounces come close to underflow
LONGEST_FLIGHT = 1e9  # rad: after a longer rotation time is too coarse to give the angle to 1e-7 rad


@noinline
def apex_state(body, state, f_n, apex):
    """Return the state at the apex of a flight."""
    s, c = sine_cosine(state.th, state.th_low)
    y = flight_gap(body, s, c, state.om, state.y, state.vn, f_n, apex)[0]
    along, vt = flight_displacement(body, state.vt, state.om, s, c, apex)
    return flown(state, along, y, apex, vt, 0.0)


@inline
def flight_start(body, state, after_slip):
    """Return (f_n at the start of a flight, number of derivatives of the gap that vanish there, the gap included).

    f_n is exactly zero after a lift-off from slip, where N, and with it f_n, reaches zero.
    """
    if after_slip:
        return 0.0, 3
    s, c = sine_cosine(state.th, state.th_low)
    f_n = free_acceleration(body, s, c, state.om * state.om)[1]
    if state.y > 0.0:
        return f_n, 0
    if state.vn > 0.0:
        return f_n, 1
    if f_n <= 1e-13 * (body.gn + state.om * state.om):
        return 0.0, 3
    return f_n, 2


@noinline
def fly(body, state, f_n, vanishing, limits, log):
    """Fly until the landing, the time limit, the angle limit or `LONGEST_FLIGHT`; `flight_start` returns f_n and `vanishing`.

    Returns (ending, state just before the impact): the ending is LANDING, a limit, or SEARCH_LIMIT if no landing was found.
    """
    limit = time_left(state, limits.t_end)
    ending = Ending.TIME_LIMIT
    direction = 1.0 if state.om > 0.0 else -1.0
    if not math.isnan(limits.span) and state.om != 0.0:
        until = max(angle_left(limits, state, direction) / abs(state.om), 0.0)
        if until < limit:
            limit = until
            ending = Ending.ANGLE_LIMIT
    if abs(state.om) * limit > LONGEST_FLIGHT:
        limit = LONGEST_FLIGHT / abs(state.om)
        ending = Ending.SEARCH_LIMIT
    landing, apex, seen = first_landing(body, state.th, state.om, state.y, state.vn, f_n, vanishing, limit)
    tau = limit
    if seen < limit:
        tau = seen
        ending = Ending.SEARCH_LIMIT
    if 0.0 <= landing <= limit:
        tau = landing
        ending = Ending.LANDING
    if 0.0 < apex < tau:
        write_plain_event(log, APEX, FLIGHT, FLIGHT, apex_state(body, state, f_n, apex))
    s, c = sine_cosine(state.th, state.th_low)
    y, vn = flight_gap(body, s, c, state.om, state.y, state.vn, f_n, tau)
    along, vt = flight_displacement(body, state.vt, state.om, s, c, tau)
    if ending == Ending.LANDING:
        y = 0.0
    after = flown(state, along, y, tau, vt, vn)
    if ending == Ending.LANDING and vn > 0.0:
        after = replaced(after, vn=0.0)
    if ending == Ending.TIME_LIMIT:
        after = replaced(after, t=limits.t_end, t_low=0.0)
    elif ending == Ending.ANGLE_LIMIT:
        after = at_span(limits, after, direction)
    write_flight(log, f_n, state, after.t)
    return ending, after


@noinline
def is_last_bounce(body, state, after):
    """Return True if the bounces to come take less than `CLOSING` of the time so far.

    A short flight only changes the sign of v_n, so that v_n falls from bounce to bounce by the same ratio as in this impact.
    """
    s, c = sine_and_cosine(state.th)
    fall = -free_acceleration(body, s, c, after.om * after.om)[1]
    if not (after.vn > 0.0 and fall > 0.0):
        return False
    if after.vn < SLOWEST_BOUNCE:
        return True
    if not after.vn < -state.vn:
        return False
    ratio = after.vn / -state.vn
    return 2.0 * after.vn / (fall * (1.0 - ratio)) < CLOSING * max(state.t, 1.0)


@inline
def land(body, state, log):
    """Return the phase after the impact of a landing."""
    after, cause = collide(body, body.rest, state, IMPACT, FLIGHT, 1)
    if is_last_bounce(body, state, after):
        after, cause = end_bounces(body, state)
    mode, settled = resolve_mode(body, after, cause, log)
    return begin_phase(mode, settled, Ending.LANDING)


@inline
def flight_step(body, phase, limits, log):
    """Fly until the landing or a limit, and return the next phase."""
    if limits.stop & STOP_AT_TAKEOFF and phase.state.t > 0.0:
        return end_motion(phase, FLIGHT, phase.state, Ending.TIME_LIMIT, COMPLETED)
    f_n, vanishing = flight_start(body, phase.state, phase.ending == Ending.LIFT_OFF)
    ending, state = fly(body, phase.state, f_n, vanishing, limits, log)
    if ending != Ending.LANDING:
        return end_motion(phase, FLIGHT, state, ending, EVENT_LIMIT if ending == Ending.SEARCH_LIMIT else COMPLETED)
    return land(body, state, log)


# --- the massless hoop -------------------------------------------------------------------------------------------------------


def begin_skim(body, state, log):
    """Start to skim: the massless hoop has lost its contact force, and its load falls freely.

    Returns (mode, state); the mode is UNDECIDED if the load rises, since nothing then determines the rim's rotation.
    """
    s, c = sine_and_cosine(state.th)
    if not (s * state.om > 0.0 or (state.om == 0.0 and s != 0.0) or c == 1.0):
        return UNDECIDED, state
    if s == 0.0:
        jump = math.copysign(math.sqrt(body.gn), state.om) - state.om
        state = replaced(state, vt=state.vt - 2.0 * jump, om=state.om + jump)
    write_plain_event(log, SKIM_START, ROLL, SKIM, state)
    return SKIM, state


def time_to_strike(body, state):
    """Return the time from the start of a skim until the load strikes the plane."""
    s, c = sine_and_cosine(state.th)
    return skim_duration(body, 1.0 + c, max(s * state.om, 0.0))  # within rounding of the top the load may still rise


def time_to_angle(body, state, ahead, direction):
    """Return the time from the start of a skim until θ has changed by an angle; inf if the load strikes before."""
    to_strike = PI * (2.0 * revolutions_before(state.th, direction) + 1.0) - direction * state.th
    if not 0.0 <= ahead < to_strike:
        return math.inf
    fall = 2.0 * direction * sine(state.th + 0.5 * direction * ahead) * sine(0.5 * ahead)
    return skim_duration(body, max(fall, 0.0), max(sine(state.th) * state.om, 0.0))


def skim(body, state, limits, log):
    """Skim until the load strikes, or a limit of time or angle; return (ending, state, v_n of the load).

    If the load strikes, v_t of the state is the velocity of the load along the plane.
    """
    s, c = sine_and_cosine(state.th)
    direction = 1.0 if state.om > 0.0 or (state.om == 0.0 and s > 0.0) else -1.0
    along = state.vt + state.om * (1.0 + c)
    duration = time_to_strike(body, state)
    left = time_left(state, limits.t_end)
    ending = Ending.LOAD_STRIKE if duration <= left else Ending.TIME_LIMIT
    tau = min(duration, left)
    if not math.isnan(limits.span):
        reach = time_to_angle(body, state, angle_left(limits, state, direction), direction)
        if reach < tau:
            ending = Ending.ANGLE_LIMIT
            tau = reach
    strikes = ending == Ending.LOAD_STRIKE
    x, th, vt, om = skim_state(body, state.x, state.th, state.vt, state.om, direction, tau)
    t, t_low = later(state, tau)
    if ending == Ending.TIME_LIMIT:
        t, t_low = limits.t_end, 0.0
    write_segment(log, SKIM, no_panel(SKIMMING, 0, direction), STRUCK if strikes else 0.0, state, t)
    if strikes:
        x, th, vt = strike_limit(body, state.x, state.th, s, along, direction, tau)
    after = replaced(state, t=t, t_low=t_low, x=x, x_low=0.0, y=0.0, th=th, th_low=0.0, vt=vt, vn=0.0, om=om)
    if ending == Ending.ANGLE_LIMIT:
        after = at_span(limits, after, direction)
    return ending, after, -(s * state.om + body.gn * tau)


@noinline
def skim_step(body, phase, limits, log):
    """Fall until the load strikes the plane or time is over; return the next phase."""
    ending, after, vn = skim(body, phase.state, limits, log)
    if ending != Ending.LOAD_STRIKE:
        return end_motion(phase, SKIM, after, ending, COMPLETED)
    along, p_n, p_t = strike(body, after.vt, vn)
    lost_n = after.impact_n + 0.5 * vn * vn
    lost_t = after.impact_t + 0.5 * (after.vt * after.vt - along * along)
    landed = replaced(after, vt=along, vn=0.0, om=0.0, impact_n=lost_n, impact_t=lost_t)
    cause = PendingEvent(IMPACT, SKIM, after.vt, vn, math.nan, p_n, p_t, 0.0, 1)
    mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)
    if body.rest > 0.0:
        mode = FLIGHT
    write_event(log, cause, mode, landed, 0.0, -1)
    if body.rest > 0.0:
        # a segment of zero length holds the state after the strike; before the strike θ̇ is unbounded
        write_segment(log, mode, no_panel(FLY, 0, 0.0), 0.0, landed, landed.t)
        return end_motion(phase, mode, landed, Ending.LOAD_STRIKE, UNDETERMINED)
    if not math.isnan(limits.span) and min(angle_left(limits, landed, 1.0), angle_left(limits, landed, -1.0)) <= ROUNDING:
        return end_motion(phase, mode, landed, Ending.ANGLE_LIMIT, COMPLETED)
    return begin_phase(mode, landed, Ending.LOAD_STRIKE)
