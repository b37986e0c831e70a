"""The event loop of the rigid hoop, in nopython mode: from phase to phase until the motion ends."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.circular import cosine, sine_cosine
from hophoop.kernel.panels.anchor import NONE, rolling_anchor
from hophoop.kernel.panels.panel import FLY, HOLD, LINEAR, no_panel
from hophoop.kernel.physics.body import (
    BUFFER,
    COMPLETED,
    END,
    EVENT_LIMIT,
    FLIGHT,
    JAMMED,
    ROLL,
    SKID,
    SKIM,
    SPIN,
    START,
    UNDETERMINED,
)
from hophoop.kernel.physics.contact import (
    acceleration_in_contact,
    free_acceleration,
    resistance_arm,
    slip_coefficients,
    slip_motion,
)
from hophoop.kernel.physics.modes import can_roll, opening_sign, slip_direction, slip_mode
from hophoop.kernel.records.cells import Cell, body_of, mode_of, second_of, start_of
from hophoop.kernel.records.layout import EVENTS, SEGMENTS, Outcome, new_scratch
from hophoop.kernel.records.writing import count_panel, event_without_jump, has_room, new_log, write_plain_event, write_segment
from hophoop.kernel.rigid.contact_phase import contact_step, remains_at_rest
from hophoop.kernel.rigid.flight_phase import begin_skim, flight_step, land, skim_step
from hophoop.kernel.rigid.panel_events import CLOSE
from hophoop.kernel.rigid.phase import (
    GOING,
    START_LEVEL,
    Ending,
    Phase,
    begin_phase,
    continue_phase,
    end_motion,
    limits_after_start,
    limits_of,
    limits_until,
)
from hophoop.kernel.rigid.transitions import resolve_mode

LARGEST = 1e150  # maximum of all quantities of a motion in its own units: the squares of larger ones overflow
BY_RULE = -1  # instead of a mode at the start: the rule of the modes selects it
RISING = 1e-6  # relative: slip that starts at the friction cone has v̇_t = 0 within rounding; slip that ends has more than this


@noinline
def begin_massless(body, state, given, log):
    """Start the motion of a massless hoop, which rolls, skims, and slides with its load on the plane."""
    down = cosine(state.th) <= -1.0
    if slip_direction(given) != 0 and down and state.om == 0.0:
        write_plain_event(log, START, -1, given, state)
        return begin_phase(given, state, Ending.CONTINUES)
    if state.y > 0.0 or state.vn != 0.0 or state.vt != 0.0:
        mode = FLIGHT
        if state.y == 0.0 and state.vn == 0.0:
            mode = slip_mode(1 if state.vt > 0.0 else -1)
        write_plain_event(log, START, FLIGHT if mode == FLIGHT else -1, mode, state)
        return Phase(mode, state, False, START_LEVEL, Ending.CONTINUES, UNDETERMINED, NONE)
    mode = ROLL
    write_plain_event(log, START, -1, ROLL, state)
    if down and state.om != 0.0:  # load on the plane: the rotation has no energy, so nothing determines it
        return Phase(mode, state, False, START_LEVEL, Ending.CONTINUES, UNDETERMINED, NONE)
    if not down and not can_roll(body, state.th, state.om):
        mode, state = begin_skim(body, state, log)
    return begin_phase(mode, state, Ending.CONTINUES)


@noinline
def goes_on_slipping(body, mode, state):
    """Return True if a state in contact belongs to a phase of slip that does not end there."""
    sigma = slip_direction(mode)
    if sigma == 0 or math.isinf(body.mu_k) or opening_sign(body, state.th, state.om) >= 0:
        return False
    s, c = sine_cosine(state.th, state.th_low)
    rho = resistance_arm(body, s, c, state.om, sigma)
    if not slip_coefficients(body, s, c, sigma, rho)[1] > 0.0:
        return False
    alpha, normal, rate = slip_motion(body, s, c, state.om * state.om, sigma, rho)
    size = body.gn + abs(body.gt) + state.om * state.om + 2.0 * abs(alpha) + body.mu_k * normal
    return state.vt != 0.0 or sigma * rate > -RISING * size


@noinline
def ends_in_lift_off(body, mode, state):
    """Return True if a state in contact is the last one of slip that lifts off, where N is zero within rounding."""
    if slip_direction(mode) == 0 or state.vt == 0.0 or opening_sign(body, state.th, state.om) < 0:
        return False
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    return abs(free_acceleration(body, s, c, u)[1]) <= CLOSE * (body.gn + body.eps * u)


@noinline
def begin_in_mode(body, mode, state, log):
    """Start the motion in the mode of a state of another motion, which the rule may miss by rounding.

    Rolling whose friction is used up in this state ends at once.
    """
    write_plain_event(log, START, -1, mode, state)
    phase = begin_phase(mode, state, Ending.CONTINUES)
    if mode != ROLL:
        return phase
    s, c = sine_cosine(state.th, state.th_low)
    return continue_phase(phase, state, phase.level, Ending.CONTINUES, rolling_anchor(body, state, s, c))


@noinline
def begin(body, start, given, log):
    """Start the motion, in a given mode or BY_RULE: write its START event and return its first phase."""
    state = start
    if body.kap == 0.0:
        return begin_massless(body, state, given, log)
    if state.y > 0.0 or state.vn != 0.0 or given == FLIGHT:
        write_plain_event(log, START, FLIGHT, FLIGHT, state)
        if state.y == 0.0 and state.vn < 0.0:
            return land(body, state, log)
        return begin_phase(FLIGHT, state, Ending.CONTINUES)
    if (given == ROLL and state.vt == 0.0) or goes_on_slipping(body, given, state):
        return begin_in_mode(body, given, state, log)
    if ends_in_lift_off(body, given, state):
        write_plain_event(log, START, -1, FLIGHT, state)
        return begin_phase(FLIGHT, state, Ending.LIFT_OFF)
    mode, state = resolve_mode(body, state, event_without_jump(START, -1, state), log)
    return begin_phase(mode, state, Ending.CONTINUES)


@inline
def step(body, phase, limits, log, scratch):
    """Compute one step and return the next phase, or the same phase after a turning point."""
    if phase.mode == FLIGHT:
        return flight_step(body, phase, limits, log)
    if phase.mode == SKIM:
        return skim_step(body, phase, limits, log)
    return contact_step(body, phase, limits, log, scratch)


@noinline
def can_follow(before, after, t_end):
    """Return True if `after` is not earlier than `before` and the squares of its quantities do not overflow."""
    sizes = abs(after.x) + after.y + abs(after.revolutions) + abs(after.vt) + abs(after.vn) + abs(after.om)
    lost = abs(after.friction) + abs(after.impact_n) + abs(after.impact_t) + abs(after.rolling_loss)
    return after.t >= min(before.t, t_end) and sizes < LARGEST and lost < LARGEST * LARGEST  # False for nan


@noinline
def write_end(body, log, mode, phase):
    """Write a segment of zero length with the state after the event, or at the angle, that ends the motion.

    Without an answer of the model the contact forces are not known: the segment then has none, as in flight. At a jam N is
    infinite, and no segment is written.
    """
    state = phase.state
    sigma = slip_direction(mode)
    kind = FLY
    turning = state.om
    if phase.status == COMPLETED and mode in (ROLL, SPIN, SKID):
        kind = LINEAR
        if state.om == 0.0 and remains_at_rest(body, sigma, state):
            kind = HOLD
        elif state.om == 0.0:
            s, c = sine_cosine(state.th, state.th_low)
            turning = acceleration_in_contact(body, s, c, 0.0, sigma)
    direction = 1.0 if turning > 0.0 else -1.0 if turning < 0.0 else 0.0
    write_segment(log, mode, no_panel(kind, sigma, direction), 0.0, state, state.t)


@inline
def count_landing(phase, landings, limits):
    """Return (landings so far, phase) after a step; the last of the landings that are asked for ends the motion."""
    if phase.ending == Ending.LANDING or phase.ending == Ending.LOAD_STRIKE:
        landings += 1
        if landings == limits.landings:
            phase = end_motion(phase, phase.mode, phase.state, phase.ending, COMPLETED)
    return landings, phase


@inline
def follow(body, phase, limits, log, scratch):
    """Go from phase to phase until the motion ends; return what `run` does."""
    landings, phase = count_landing(phase, 0, limits)
    while phase.status == GOING and has_room(log):
        count_panel(log)
        events_before, segments_before = log.counts[EVENTS], log.counts[SEGMENTS]
        after = step(body, phase, limits, log, scratch)
        if not can_follow(phase.state, after.state, limits.t_end):
            log.counts[EVENTS], log.counts[SEGMENTS] = events_before, segments_before
            break
        landings, phase = count_landing(after, landings, limits)
        if limits.leaves:
            limits = limits_after_start(limits, phase.state)
    if log.counts[EVENTS] >= 0 and log.counts[SEGMENTS] >= 0:  # also if the panels are used up: END is at the state reached
        last = log.events[log.counts[EVENTS] - 1]
        mode, ends = last["after_mode"], last["t"] == phase.state.t
        write_plain_event(log, END, mode, mode, phase.state)
        if phase.status != JAMMED and (ends or phase.ending == Ending.ANGLE_LIMIT):
            write_end(body, log, mode, phase)
    count = log.counts[EVENTS] if log.counts[EVENTS] >= 0 else log.events.shape[0]
    if log.counts[SEGMENTS] < 0:
        return BUFFER, count, log.segments.shape[0]
    if log.counts[EVENTS] < 0:
        return EVENT_LIMIT, count, log.counts[SEGMENTS]
    return phase.status if phase.status != GOING else EVENT_LIMIT, count, log.counts[SEGMENTS]


def run(body, start, mode, t_end, angle_span, stop, events, segments, scratch):
    """Compute a motion up to the final time, an end by the physics, or a limit.

    Parameters
    ----------
    body : Body
    start : State
        The rim is on the plane (y = 0) or above it.
    mode : int
        Mode at the start, or BY_RULE.
    t_end : float
        Time at which the motion ends; all quantities are in kernel units.
    angle_span : float
        The motion also ends when θ has changed by this much (nan: no limit).
    stop : int
        Sum of limits.STOP_AT_TURN, STOP_AT_TAKEOFF.
    events, segments : ndarray of records.EVENT, records.SEGMENT
        Filled; segments of length 0 are not written, if only events are wanted.
    scratch : records.Scratch
        Its `doubt` holds nan afterwards if double precision sufficed.

    Returns
    -------
    status, number of events, number of segments : int
        Status.BUFFER: the segments were full. EVENT_LIMIT: the events were full, and the motion ends at the last one, even if
        later segments exist; or the limit of panels or of the size of quantities was reached.
    """
    return run_within(body, start, mode, limits_of(start, t_end, angle_span, stop, 0), events, segments, scratch)


@inline
def run_within(body, start, mode, limits, events, segments, scratch):
    """Compute a motion within its limits, as `run` does."""
    log = new_log(events, segments, scratch)
    return follow(body, begin(body, start, mode, log), limits, log, scratch)


def run_cell(tables, until):
    """Compute the motion of a cell up to its duration, or to what ends it before."""
    scratch = new_scratch()
    cell = tables.cell[:, 0]
    second = second_of(cell)
    events = tables.events[: int(cell[Cell.MAX_EVENTS])]
    start = start_of(cell, second)
    limits = limits_until(start, cell[Cell.DURATION] / second, until)
    status, count, pieces = run_within(body_of(cell), start, mode_of(cell), limits, events, tables.segments, scratch)
    return Outcome(status, count, pieces, scratch.doubt[0], scratch.counts[EVENTS] < 0)
