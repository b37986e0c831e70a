"""The event loop of the rigid hoop, in nopython mode: phases between events, events between phases."""

from __future__ import annotations

import math

from hophoop._jit import jit, unit_jit
from hophoop.numerics.double_double import plus
from hophoop.numerics.trigonometry import sine_cosine
from hophoop.panels.landing import first_landing
from hophoop.panels.panel import FLY, HOLD, SKIMMING, no_panel
from hophoop.physics.body import Event, Mode, Status
from hophoop.physics.contact import free_acceleration
from hophoop.physics.flight import flight_displacement, flight_gap
from hophoop.physics.massless import skim_duration, skim_state, strike
from hophoop.physics.modes import UNDECIDED, can_roll, slip_direction, slip_mode
from hophoop.records.state import at_time, flown, later, moved, time_left, with_losses, with_velocities
from hophoop.records.writing import Cause, copy_event, quiet, state_of, write_event, write_segment
from hophoop.rigid.contact_phase import (
    CONE_AHEAD,
    FULL_ANGLE,
    LIFT,
    LIMIT,
    ON,
    START_LEVEL,
    STILL,
    STOP,
    STUCK,
    TURNED,
    advance_contact,
    anchored,
    angle_left,
    at_span,
    equilibrium_is_stable,
    frozen_end,
    limits_of,
)
from hophoop.rigid.doubts import CLOSE, note_doubt
from hophoop.rigid.transitions import close_bounces, collide, pass_singular, settle

ROLL, FLIGHT, SKIM = int(Mode.ROLL), int(Mode.FLIGHT), int(Mode.SKIM)
START, SLIP_START, STICK, TAKEOFF = (int(kind) for kind in (Event.START, Event.SLIP_START, Event.STICK, Event.TAKEOFF))
IMPACT, TURN, APEX, BOUNCE_LIMIT = (int(kind) for kind in (Event.IMPACT, Event.TURN, Event.APEX, Event.BOUNCE_LIMIT))
SKIM_START, REST, END = (int(kind) for kind in (Event.SKIM, Event.REST, Event.END))
COMPLETED, AT_REST, JAMMED = (int(end) for end in (Status.COMPLETED, Status.AT_REST, Status.JAMMED))
UNDETERMINED, EVENT_LIMIT, BUFFER = (int(end) for end in (Status.UNDETERMINED, Status.EVENT_LIMIT, Status.BUFFER))

STOP_AT_TURN, STOP_AT_TAKEOFF = 1, 2
# A sequence of bounces is closed when what is left of it takes less than this part of the time so far.
CLOSING = 1e-12
SLOWEST_BOUNCE = 1e-100  # heights of slower ones are on the way to underflow
LOWEST_START = 1e-250  # a rim this high touches: the time to fall would underflow
MOST_PANELS = 4_000_000


@jit
def fly(body, state, opening, zeros, limits, events, count, segments, pieces, scratch):
    """Fly until landing, the limit of time or of angle.

    `opening` is f_n at the start, exactly 0 after a lift-off from slip; `zeros` counts the leading
    derivatives of the gap that vanish there.

    Returns (what, state just before the impact, count, pieces): what is STOP for a landing.
    """
    limit = time_left(state, limits.t_end)
    what = LIMIT
    way = 1.0 if state.om > 0.0 else -1.0
    if not math.isnan(limits.span) and state.om != 0.0:
        until = max(angle_left(limits, state, way) / abs(state.om), 0.0)
        if until < limit:
            limit = until
            what = FULL_ANGLE
    landing, apex = first_landing(
        body,
        state.th,
        state.om,
        state.y,
        state.vn,
        opening,
        zeros,
        limit,
        scratch.values,
        scratch.series,
        scratch.stack,
    )
    tau = limit
    if 0.0 <= landing <= limit:
        tau = landing
        what = STOP
    s, c = sine_cosine(state.th, state.th_low)
    for step in range(2):
        at = tau
        if step == 0:
            if not 0.0 < apex < tau:
                continue
            at = apex
        y, vn = flight_gap(body, s, c, state.om, state.y, state.vn, opening, at)
        along, vt = flight_displacement(body, state.vt, state.om, s, c, at)
        if step == 0:
            vn = 0.0
        elif what == STOP:
            y = 0.0
            vn = min(vn, 0.0)
        after = flown(state, along, y, at, vt, vn)
        if step == 1 and what == LIMIT:
            after = at_time(after, limits.t_end)
        elif step == 1 and what == FULL_ANGLE:
            after = at_span(limits, after, way)
        if step == 0:
            count = write_event(events, count, quiet(APEX, FLIGHT, after), FLIGHT, after, 0.0, -1)
    pieces = write_segment(segments, pieces, FLIGHT, no_panel(FLY, 0, 0.0), 0.0, opening, state, after.t)
    return what, after, count, pieces


@jit
def opening_of(body, state):
    """(f_n at the start of a flight, exactly 0 after a lift-off from slip; how many derivatives of the gap vanish)."""
    s, c = sine_cosine(state.th, state.th_low)
    opening = free_acceleration(body, s, c, state.om * state.om)[1]
    if state.y > 0.0:
        return opening, 0
    if state.vn > 0.0:
        return opening, 1
    if opening <= 1e-13 * (body.gn + state.om * state.om):
        return 0.0, 3
    return opening, 2


@jit
def let_go(body, state, events, count):
    """The massless hoop has lost its contact force: the load falls freely and the rim skims.

    Returns (mode, state, count); the mode is UNDECIDED where the load rises, which leaves the rim's rotation open.
    """
    s = math.sin(state.th)
    if not (s * state.om > 0.0 or (state.om == 0.0 and s != 0.0) or math.cos(state.th) == 1.0):
        return UNDECIDED, state, count
    if s == 0.0:
        jump = math.copysign(math.sqrt(body.gn), state.om) - state.om
        state = with_velocities(state, state.vt - 2.0 * jump, state.vn, state.om + jump)
    return SKIM, state, write_event(events, count, quiet(SKIM_START, ROLL, state), SKIM, state, 0.0, -1)


@jit
def skim(body, state, t_end, segments, pieces):
    """The massless hoop after the loss of its contact force: (whether the load strikes, state, v_x, pieces).

    The last answer but one is the speed of the load along the plane.
    """
    way = 1.0 if state.om > 0.0 or (state.om == 0.0 and math.sin(state.th) > 0.0) else -1.0
    c = math.cos(state.th)
    along = state.vt + state.om * (1.0 + c)
    duration = skim_duration(body, c, math.sin(state.th) * state.om)
    left = time_left(state, t_end)
    strikes = duration <= left
    tau = duration if strikes else left
    x, th, vt, om = skim_state(body, state.x, state.th, state.vt, state.om, way, tau)
    pieces = write_segment(segments, pieces, SKIM, no_panel(SKIMMING, 0, way), 0.0, 0.0, state, state.t + tau)
    t, t_low = later(state, tau)
    if not strikes:
        t, t_low = t_end, 0.0
    if strikes:
        x = state.x + math.sin(state.th) + along * tau + 0.5 * body.gt * tau * tau
        th = math.pi * (2.0 * math.floor(0.5 * state.th / math.pi + (0.0 if way > 0 else -1e-12)) + 1.0)
        vt = along + body.gt * tau
    after = with_velocities(moved(state, t, t_low, x, 0.0, 0.0, state.turns, th, 0.0), vt, 0.0, om)
    return strikes, after, math.sin(state.th) * state.om + body.gn * tau, pieces


@jit
def hold(body, mode, state, t_end, segments, pieces):
    """Slip without rotation: until v_t = 0 or the end of time; (what, state, pieces)."""
    sigma = slip_direction(mode)
    rate, until = frozen_end(body, sigma, state.vt)
    what = STOP
    tau = until
    left = time_left(state, t_end)
    if not until <= left:
        what = LIMIT
        tau = left
    slid = state.vt * tau + 0.5 * rate * tau * tau
    vt = 0.0 if what == STOP else state.vt + rate * tau
    t, t_low = later(state, tau)
    if what != STOP:
        t, t_low = t_end, 0.0
    x, x_low = plus(state.x, state.x_low, slid)
    friction = state.friction + sigma * body.mu_k * body.gn * slid
    after = with_velocities(moved(state, t, t_low, x, x_low, 0.0, state.turns, state.th, state.th_low), vt, 0.0, 0.0)
    after = with_losses(after, friction, state.impact_n, state.impact_t)
    pieces = write_segment(segments, pieces, mode, no_panel(HOLD, sigma, 0.0), 0.0, rate, state, after.t)
    return what, after, pieces


@jit
def is_last_bounce(body, state, after, last):
    """Whether the bounces that would follow take less than `CLOSING` of the time so far."""
    pull = -free_acceleration(body, math.sin(state.th), math.cos(state.th), after.om * after.om)[1]
    if not (after.vn > 0.0 and pull > 0.0):
        return False
    if after.vn < SLOWEST_BOUNCE:
        return True
    if not after.vn < last:
        return False
    ratio = after.vn / last
    return 2.0 * after.vn / (pull * (1.0 - ratio)) < CLOSING * max(state.t, 1.0)


@unit_jit
def run(body, start, t_end, angle_span, stop, events, segments, scratch, script):
    """The motion from a state to the end of time, to an end that the physics sets, or to a limit.

    Parameters
    ----------
    body : Body
    start : State
        At t = 0; the rim is at the plane (y = 0) or above it.
    t_end : float
        Duration; everything is in kernel units.
    angle_span : float
        The motion also ends when θ has changed by this much (nan: no such limit).
    stop : int
        Sum of STOP_AT_TURN, STOP_AT_TAKEOFF.
    events, segments : ndarray of records.EVENT, records.SEGMENT
        Filled; segments may have length 0 where only the events are wanted.
    scratch : records.Scratch
        Its `doubt` tells afterwards whether the doubles sufficed.
    script : ndarray of records.EVENT
        First events, where they are known, else of length 0. The last one is a state inside a phase, or again the
        last event: from there on the motion is computed.

    Returns
    -------
    status, number of events, number of segments : int
        With Status.BUFFER or EVENT_LIMIT the arrays were full.
    """
    state = start
    if 0.0 < state.y < LOWEST_START:
        state = moved(start, start.t, start.t_low, start.x, start.x_low, 0.0, start.turns, start.th, start.th_low)
    count = 0
    pieces = 0
    mode = FLIGHT
    opening = 0.0
    zeros = 0
    last_bounce = 0.0
    status = COMPLETED
    massless = body.kap == 0.0
    limits = limits_of(state, t_end, angle_span)
    scratch.doubt[0] = math.nan
    scratch.doubt[1] = math.nan
    # The start.
    row = 0
    last_row = script.shape[0] - 1
    blind = last_row > 0
    if blind:
        count = copy_event(events, count, script[0])
        state = state_of(script[0])
        mode = script[0]["after_mode"]
        limits = limits_of(state, script[1]["t"], math.nan)
    elif state.y > 0.0 or state.vn != 0.0:
        count = write_event(events, count, quiet(START, FLIGHT, state), FLIGHT, state, 0.0, -1)
        if massless:
            status = UNDETERMINED
        if state.y == 0.0 and state.vn < 0.0 and not massless:
            after, cause = collide(body, body.rest, state, IMPACT, FLIGHT, 1)
            if is_last_bounce(body, state, after, 0.0):
                after, cause = close_bounces(body, state)
            state = after
            last_bounce = state.vn
            mode, state, count = settle(body, state, cause, events, count, scratch)
    else:
        cause = quiet(START, -1, state)
        if massless and state.vt != 0.0:
            status = UNDETERMINED
            count = write_event(events, count, cause, slip_mode(1 if state.vt > 0.0 else -1), state, 0.0, -1)
        elif massless:
            # next_mode needs κ > 0 beyond rolling; without mass only rolling and skimming exist
            mode = ROLL
            count = write_event(events, count, cause, ROLL, state, 0.0, -1)
            if math.cos(state.th) > -1.0 and not can_roll(body, state.th, state.om):
                mode, state, count = let_go(body, state, events, count)
        else:
            mode, state, count = settle(body, state, cause, events, count, scratch)
    if mode == UNDECIDED:
        status = UNDETERMINED
        note_doubt(scratch, state.t, state.t)
    slip_zeros = 1 if state.vt == 0.0 else 0
    fresh = True
    level = START_LEVEL
    new_phase = True
    panels = 0
    while status == COMPLETED:
        panels += 1
        if panels > MOST_PANELS:
            status = EVENT_LIMIT
            break
        if count < 0:
            return EVENT_LIMIT, events.shape[0], pieces
        if pieces < 0:
            return BUFFER, count, segments.shape[0]
        if blind and (mode == FLIGHT or not state.t < limits.t_end):
            if mode == FLIGHT and state.t < limits.t_end:
                opening, zeros = opening_of(body, state)
                pieces = write_segment(segments, pieces, mode, no_panel(FLY, 0, 0.0), 0.0, opening, state, limits.t_end)
            row += 1
            state = state_of(script[row])
            mode = script[row]["after_mode"]
            fresh = True
            slip_zeros = 1 if state.vt == 0.0 else 0
            level = START_LEVEL
            new_phase = True
            if row < last_row:
                count = copy_event(events, count, script[row])
                limits = limits_of(state, script[row + 1]["t"], math.nan)
                continue
            blind = False
            limits = limits_of(start, t_end, angle_span)
            if script[row]["t"] > script[row - 1]["t"]:  # inside a phase
                fresh = False
                if mode != FLIGHT:
                    state = anchored(body, slip_direction(mode), state, scratch)
            elif script[row - 1]["kind"] == SLIP_START and body.mu_s == body.mu_k:
                slip_zeros = 2
            continue
        if mode == FLIGHT:
            if stop & STOP_AT_TAKEOFF and state.t > 0.0:
                break
            if new_phase:
                opening, zeros = opening_of(body, state)
            what, state, count, pieces = fly(body, state, opening, zeros, limits, events, count, segments, pieces, scratch)
            if what != STOP:
                break
            after, cause = collide(body, body.rest, state, IMPACT, FLIGHT, 1)
            if is_last_bounce(body, state, after, last_bounce):
                after, cause = close_bounces(body, state)
            last_bounce = after.vn
            mode, state, count = settle(body, after, cause, events, count, scratch)
            if mode == UNDECIDED:
                status = UNDETERMINED
                note_doubt(scratch, state.t, state.t)
            slip_zeros = 1 if state.vt == 0.0 else 0
            fresh = True
            level = START_LEVEL
            new_phase = True
            continue
        if mode == SKIM:
            strikes, after, sink, pieces = skim(body, state, t_end, segments, pieces)
            if not strikes:
                state = after
                break
            along, p_n, p_t = strike(body, after.vt, -sink)
            lost_n = after.impact_n + 0.5 * sink * sink
            lost_t = after.impact_t + 0.5 * (after.vt * after.vt - along * along)
            landed = with_losses(with_velocities(after, along, 0.0, 0.0), after.friction, lost_n, lost_t)
            cause = Cause(IMPACT, SKIM, after.vt, -sink, math.nan, p_n, p_t, 0.0, 1)
            state = landed
            mode = ROLL if along == 0.0 else slip_mode(1 if along > 0.0 else -1)
            if body.rest > 0.0:
                status = UNDETERMINED
                mode = FLIGHT
            count = write_event(events, count, cause, mode, state, 0.0, -1)
            fresh = True
            new_phase = True
            continue
        was = mode
        what, state, level, pieces = advance_contact(
            body, mode, state, fresh, blind, slip_zeros, level, limits, scratch, segments, pieces
        )
        fresh = False
        if blind:
            if what in (STILL, STUCK):
                sigma = slip_direction(mode)
                rate = frozen_end(body, sigma, state.vt)[0] if sigma != 0 else 0.0
                pieces = write_segment(segments, pieces, mode, no_panel(HOLD, sigma, 0.0), 0.0, rate, state, limits.t_end)
                state = at_time(state, limits.t_end)
            continue
        if what == ON:
            continue
        if what == TURNED:
            count = write_event(events, count, quiet(TURN, mode, state), mode, state, 0.0, -1)
            if stop & STOP_AT_TURN:
                break
        elif what in (LIMIT, FULL_ANGLE):
            break
        elif what == STILL:
            if mode == ROLL:
                stable = 1 if equilibrium_is_stable(body, state.th) else 0
                count = write_event(events, count, quiet(REST, ROLL, state), ROLL, state, 0.0, stable)
                pieces = write_segment(segments, pieces, ROLL, no_panel(HOLD, 0, 0.0), 0.0, 0.0, state, t_end)
                state = at_time(with_velocities(state, 0.0, 0.0, 0.0), t_end)
                status = AT_REST
            else:
                what, state, pieces = hold(body, mode, state, t_end, segments, pieces)
                if what == LIMIT:
                    break
                if massless:
                    mode = ROLL
                    count = write_event(events, count, quiet(STICK, was, state), ROLL, state, 0.0, -1)
                else:
                    mode, state, count = settle(body, state, quiet(STICK, was, state), events, count, scratch)
                fresh = True
        elif what == STUCK:
            if mode == ROLL:
                status = UNDETERMINED
                note_doubt(scratch, state.t, state.t)
            else:
                jams, mode, state, count = pass_singular(body, mode, state, events, count, scratch)
                if jams:
                    status = JAMMED
                slip_zeros = 1 if state.vt == 0.0 else 0
                fresh = True
        elif what == LIFT:
            mode = FLIGHT
            count = write_event(events, count, quiet(TAKEOFF, was, state), FLIGHT, state, 0.0, -1)
            zeros = 3
            opening = 0.0
            new_phase = False
            continue
        elif what == STOP:
            mode, state, count = settle(body, state, quiet(STICK, was, state), events, count, scratch)
            slip_zeros = 1 if state.vt == 0.0 else 0
            fresh = True
        elif massless:
            mode, state, count = let_go(body, state, events, count)
        elif math.isinf(body.mu_s):
            opens = free_acceleration(body, math.sin(state.th), math.cos(state.th), state.om * state.om)[1]
            if opens >= 0.0:
                mode = FLIGHT
                count = write_event(events, count, quiet(TAKEOFF, ROLL, state), FLIGHT, state, 0.0, -1)
                new_phase = True
                continue
            status = UNDETERMINED  # the quasi-jump: N = 0, but free motion would enter the plane
        else:
            # rule 2: slip against the friction that was at its limit
            opens = free_acceleration(body, math.sin(state.th), math.cos(state.th), state.om * state.om)[1]
            if abs(opens) <= CLOSE * (body.gn + state.om * state.om):
                note_doubt(scratch, state.t, state.t)
            if opens >= 0.0:
                mode = FLIGHT
                count = write_event(events, count, quiet(TAKEOFF, ROLL, state), FLIGHT, state, 0.0, -1)
                new_phase = True
                continue
            mode = slip_mode(-1 if what == CONE_AHEAD else 1)
            slip_zeros = 2 if body.mu_s == body.mu_k else 1
            count = write_event(events, count, quiet(SLIP_START, ROLL, state), mode, state, 0.0, -1)
            fresh = True
        if mode == UNDECIDED:
            status = UNDETERMINED
            if body.kap > 0.0 and not math.isinf(body.mu_s):
                note_doubt(scratch, state.t, state.t)
        new_phase = True
        if fresh:
            level = START_LEVEL
    if count >= 0:
        last = mode if mode <= SKIM else ROLL
        count = write_event(events, count, quiet(END, last, state), last, state, 0.0, -1)
    if count < 0:
        return EVENT_LIMIT, events.shape[0], pieces
    if pieces < 0:
        return BUFFER, count, segments.shape[0]
    return status, count, pieces
