"""Flight up to the landing, and the impact of the landing."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.panels.landing import first_landing
from hophoop.kernel.panels.panel import FLY, no_panel
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.physics.contact import free_acceleration
from hophoop.kernel.physics.flight import flight_displacement, flight_gap
from hophoop.kernel.records.state import at_time, flown, time_left, with_velocities
from hophoop.kernel.records.writing import write_plain_event, write_segment
from hophoop.kernel.rigid.ending import Ending
from hophoop.kernel.rigid.limits import STOP_AT_TAKEOFF, angle_left, at_span
from hophoop.kernel.rigid.phase import begin_phase, end_motion
from hophoop.kernel.rigid.transitions import collide, end_bounces, resolve_mode

FLIGHT, IMPACT, APEX = int(Mode.FLIGHT), int(Event.IMPACT), int(Event.APEX)
COMPLETED, EVENT_LIMIT = int(Status.COMPLETED), int(Status.EVENT_LIMIT)

# A sequence of bounces is closed when the bounces to come would take less than this fraction of the time so far.
CLOSING = 1e-12
SLOWEST_BOUNCE = 1e-100  # the heights of slower bounces come close to underflow
LONGEST_FLIGHT = 1e9  # rad: after a longer rotation time is too coarse to give the angle to 1e-7 rad


@apart
def apex_state(body, state, opening, apex):
    """Return the state at the apex of a flight."""
    s, c = sine_cosine(state.th, state.th_low)
    y = flight_gap(body, s, c, state.om, state.y, state.vn, opening, apex)[0]
    along, vt = flight_displacement(body, state.vt, state.om, s, c, apex)
    return flown(state, along, y, apex, vt, 0.0)


@apart
def fly(body, state, opening, zeros, limits, log):
    """Fly until the landing, the time limit, the angle limit or `LONGEST_FLIGHT`.

    `opening` is f_n at the start, exactly 0 after a lift-off from slip; `zeros` counts the leading
    derivatives of the gap that vanish there.

    Returns (ending, state just before the impact): the ending is LANDING, a limit, or SEARCH_LIMIT if no landing was found.
    """
    limit = time_left(state, limits.t_end)
    what = Ending.TIME_LIMIT
    way = 1.0 if state.om > 0.0 else -1.0
    if not math.isnan(limits.span) and state.om != 0.0:
        until = max(angle_left(limits, state, way) / abs(state.om), 0.0)
        if until < limit:
            limit = until
            what = Ending.ANGLE_LIMIT
    if abs(state.om) * limit > LONGEST_FLIGHT:
        limit = LONGEST_FLIGHT / abs(state.om)
        what = Ending.SEARCH_LIMIT
    landing, apex, seen = first_landing(body, state.th, state.om, state.y, state.vn, opening, zeros, limit)
    tau = limit
    if seen < limit:
        tau = seen
        what = Ending.SEARCH_LIMIT
    if 0.0 <= landing <= limit:
        tau = landing
        what = Ending.LANDING
    if 0.0 < apex < tau:
        write_plain_event(log, APEX, FLIGHT, FLIGHT, apex_state(body, state, opening, apex))
    s, c = sine_cosine(state.th, state.th_low)
    y, vn = flight_gap(body, s, c, state.om, state.y, state.vn, opening, tau)
    along, vt = flight_displacement(body, state.vt, state.om, s, c, tau)
    if what == Ending.LANDING:
        y = 0.0
    after = flown(state, along, y, tau, vt, vn)
    if what == Ending.LANDING and vn > 0.0:
        after = with_velocities(after, vt, 0.0, state.om)
    if what == Ending.TIME_LIMIT:
        after = at_time(after, limits.t_end)
    elif what == Ending.ANGLE_LIMIT:
        after = at_span(limits, after, way)
    write_segment(log, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)
    return what, after


@apart
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
def land(body, state, log, scratch):
    """Return the phase after the impact of a landing."""
    after, cause = collide(body, body.rest, state, IMPACT, FLIGHT, 1)
    if is_last_bounce(body, state, after):
        after, cause = end_bounces(body, state)
    mode, settled = resolve_mode(body, after, cause, log, scratch)
    return begin_phase(body, mode, settled, Ending.LANDING, scratch)


@inline
def flight_step(body, phase, limits, log, scratch):
    """Fly until the landing or a limit, and return the next phase."""
    if limits.stop & STOP_AT_TAKEOFF and phase.state.t > 0.0:
        return end_motion(phase, FLIGHT, phase.state, Ending.TIME_LIMIT, COMPLETED)
    what, state = fly(body, phase.state, phase.opening, phase.zeros, limits, log)
    if what != Ending.LANDING:
        return end_motion(phase, FLIGHT, state, what, EVENT_LIMIT if what == Ending.SEARCH_LIMIT else COMPLETED)
    return land(body, state, log, scratch)
