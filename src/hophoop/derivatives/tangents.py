"""Propagate the derivatives of a computed motion in all directions through its pieces and events."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from hophoop.derivatives.events.conditions import (
    fail,
    fail_all,
    go_with_jam,
    is_on_border,
    meet_jam,
    meet_margin,
    meet_row,
    meet_time,
    part_at_rest,
)
from hophoop.derivatives.events.impact import (
    BORDER,
    NONE,
    PLASTIC,
    SIDED,
    Blow,
    d_stop_impulse,
    impact_change,
    is_between_courses,
)
from hophoop.derivatives.events.massless import follow_strike
from hophoop.derivatives.layout import (
    BEFORE_OM,
    END,
    EPS,
    IMPACT_N,
    IMPACT_T,
    KAP,
    OM,
    P_N,
    P_T,
    STATE_ROWS,
    TH,
    VN,
    VT,
    Reason,
    Y,
    body_tangent,
)
from hophoop.derivatives.pieces.flight_and_rest import accelerations, skims_plane
from hophoop.derivatives.pieces.pieces import follow_piece, follow_without_panel, is_before, is_panel, length_of
from hophoop.kernel.model import Event, Mode, impact, slip_direction
from hophoop.kernel.native import noinline, replaced
from hophoop.kernel.numerics.circular import sine, sine_cosine
from hophoop.kernel.records import state_of
from hophoop.kernel.steps import FLY, HOLD, LINEAR, SKIMMING


@noinline
def begin_changes(body, row, tangents, reasons):
    """Propagate a changed start to the start of its first piece."""
    state = state_of(row)
    if state.y > 0.0 or state.vn != 0.0:
        return
    mode = row["after_mode"]
    touches = mode != Mode.FLIGHT and mode != Mode.SKIM
    slips_freely = touches and body.mu_k == 0.0 and slip_direction(mode) != 0
    for k in range(tangents.shape[1]):
        if tangents[Y, k] != 0.0 or tangents[VN, k] != 0.0:
            fail(tangents, reasons, k, Reason.CONTACT)
        elif touches and state.vt == 0.0 and tangents[VT, k] != 0.0 and not slips_freely:
            fail(tangents, reasons, k, Reason.BORDER)
    if touches:
        part_at_rest(body, slip_direction(mode), state, tangents, reasons)
    if is_on_border(body, state):
        fail_all(tangents, reasons, Reason.BORDER)


@noinline
def end_rolling(body, row, before, rates, parameter_tangents, tangents, reasons):
    """Propagate all directions to the end of rolling at the friction cone, or at N = 0."""
    meet_margin(body, False, before, rates, parameter_tangents, tangents, reasons)
    if row["kind"] == Event.SKIM:
        for k in range(tangents.shape[1]):
            if parameter_tangents[EPS, k] != 0.0 or parameter_tangents[KAP, k] != 0.0:
                fail(tangents, reasons, k, Reason.MASSLESS)


@noinline
def collide_changes(body, rest, row, before, parameter_tangents, tangents, event_tangents, reasons):
    """All directions through an impact."""
    s, c = sine_cosine(before.th, before.th_low)
    blow = Blow(rest, s, c, before.vt, before.vn)
    vn = impact(body, rest, s, c, before.vt, before.vn)[1]
    pulls = row["kind"] == Event.BOUNCE_LIMIT and vn > 0.0
    between = is_between_courses(body, blow)
    for k in range(tangents.shape[1]):
        dth = tangents[TH, k]
        if math.isnan(dth):
            continue
        d_body = body_tangent(parameter_tangents, k)
        d_rest = d_body.rest if rest == body.rest else 0.0
        change, reason = impact_change(body, blow, d_body, Blow(d_rest, c * dth, -s * dth, tangents[VT, k], tangents[VN, k]))
        dvt, dvn, dspin, dp_n, dp_t, dloss_n, dloss_t = change
        if pulls:
            turned, pulled_n, pulled_t, lost = d_stop_impulse(body, s, c, vn, d_body, c * dth, -s * dth, dvn)[1]
            dvt = dvn = 0.0
            dspin += turned
            dp_n += pulled_n
            dp_t += pulled_t
            dloss_n += lost
        tangents[VT, k] = dvt
        tangents[VN, k] = dvn
        tangents[OM, k] += dspin
        event_tangents[P_N, k] = dp_n
        event_tangents[P_T, k] = dp_t
        tangents[IMPACT_N, k] += dloss_n
        tangents[IMPACT_T, k] += dloss_t
        if between and reason != PLASTIC:
            reason = BORDER
        if reason == SIDED:
            if reasons[k] == NONE:
                reasons[k] = SIDED
        elif reason == PLASTIC:  # time and place of the landing do not change
            tangents[OM : IMPACT_T + 1, k] = math.nan
            event_tangents[P_N:, k] = math.nan
            if reasons[k] <= 0:
                reasons[k] = PLASTIC
        elif reason != NONE:
            fail(tangents, reasons, k, reason)


@noinline
def keep_before(tangents, event_tangents):
    """The velocities just before an event, and no impulse."""
    event_tangents[BEFORE_OM:P_N] = tangents[OM : VN + 1]
    for k in range(tangents.shape[1]):
        event_tangents[P_N:, k] = 0.0 * tangents[OM, k]  # nan where there is no derivative


class Past(NamedTuple):
    """The last piece before an event."""

    piece: Any
    passed: bool  # whether it is after the event before
    fresh: Any  # the tangents at its start


@noinline
def meet_event(body, row, past, t_end, parameter_tangents, tangents, event_tangents, reasons):
    """Propagate all directions from the end of the last piece through an event."""
    piece, passed = past.piece, past.passed
    kind = row["kind"]
    mode = row["before_mode"]
    after = state_of(row)
    before = replaced(after, vt=row["before_slip"], vn=row["before_vy"], om=row["before_omega"])
    if kind == Event.IMPACT and mode == Mode.SKIM:
        tangents[:] = past.fresh
        follow_strike(body, state_of(piece), parameter_tangents, tangents, event_tangents)
        return
    if kind == Event.START:
        begin_changes(body, row, tangents, reasons)
        keep_before(tangents, event_tangents)
        return
    rates = (0.0, 0.0, 0.0, 0.0)
    way = piece["direction"] if passed and is_panel(piece) else 0.0
    # the couple changes its sign where the hoop turns round, and with it the forces: what follows is decided anew
    turned = body.resist > 0.0 and before.om == 0.0 and (way != 0.0 or kind in (Event.SLIP_START, Event.TAKEOFF))
    if mode >= 0 and not (passed and piece["kind"] == HOLD and piece["sigma"] == 0):
        rates = accelerations(body, mode, before, way)
    if turned and kind != Event.END:
        pass
    elif mode == Mode.ROLL and (kind in (Event.SLIP_START, Event.TAKEOFF) or (kind == Event.SKIM and passed)):
        end_rolling(body, row, before, rates, parameter_tangents, tangents, reasons)
    elif kind == Event.TAKEOFF and before.vt != 0.0:
        meet_margin(body, True, before, rates, parameter_tangents, tangents, reasons)
    elif kind in (Event.STICK, Event.SLIP_REVERSAL, Event.TAKEOFF):
        meet_row(VT, rates[1], 1e-300 + body.gn + abs(body.gt) + before.om * before.om, before, rates, tangents, reasons)
    elif (kind == Event.IMPACT and mode == Mode.FLIGHT and row["collision"] == 1) or kind == Event.BOUNCE_LIMIT:
        meet_row(Y, before.vn, 1e-300, before, rates, tangents, reasons)
    elif kind == Event.JAM:
        meet_jam(body, slip_direction(mode), after, before, parameter_tangents, tangents)
    elif kind == Event.PAINLEVE_INCONSISTENT and passed:
        fail_all(tangents, reasons, Reason.SINGULAR)
    elif kind == Event.REST and body.mu_s == 0.0:
        fail_all(tangents, reasons, Reason.FRICTIONLESS)
    elif kind == Event.END:
        if row["t"] == t_end:
            meet_time(parameter_tangents, END, before, rates, tangents)
        elif passed and mode == Mode.ROLL and math.isinf(body.mu_s):  # N = 0, but free motion would enter the plane
            end_rolling(body, row, before, rates, parameter_tangents, tangents, reasons)
        elif passed:
            fail_all(tangents, reasons, Reason.ENDED)
    keep_before(tangents, event_tangents)
    if kind == Event.SKIM and sine(before.th) == 0.0:
        fail_all(tangents, reasons, Reason.MASSLESS)
    if kind == Event.IMPACT:
        collide_changes(body, body.rest, row, before, parameter_tangents, tangents, event_tangents, reasons)
    elif kind == Event.BOUNCE_LIMIT:
        collide_changes(body, 0.0, row, before, parameter_tangents, tangents, event_tangents, reasons)
    settles = kind in (Event.IMPACT, Event.STICK, Event.SLIP_REVERSAL, Event.BOUNCE_LIMIT) or turned
    if settles and row["after_mode"] != Mode.FLIGHT and kind != Event.END:
        if is_on_border(body, after):
            fail_all(tangents, reasons, Reason.BORDER)
        part_at_rest(body, slip_direction(row["after_mode"]), after, tangents, reasons)


@noinline
def keep_after(row, tangents, event_tangents):
    """Record the tangents just after an event; at the start those that were given."""
    for k in range(tangents.shape[1]):
        if row["kind"] != Event.START or math.isnan(tangents[TH, k]):
            event_tangents[:STATE_ROWS, k] = tangents[:, k]


@noinline
def pass_apex(body, row, piece, parameter_tangents, tangents, event_tangents, reasons):
    """Propagate all directions from the start of a flight to its apex, an event inside it."""
    tau = ((row["t"] - piece["t"]) + row["t_low"]) - piece["t_low"]
    state = follow_without_panel(body, piece, tau, parameter_tangents, tangents)
    state = replaced(state, vn=0.0)
    rates = accelerations(body, Mode.FLIGHT, state, 0.0)
    meet_row(VN, rates[2], 1e-300 + body.gn + state.om * state.om, state, rates, tangents, reasons)
    keep_before(tangents, event_tangents)


def propagate_tangents(body, motion, parameter_tangents, tangents, solution, workspace):
    """Fill in the derivatives at all events and at the starts of all pieces of a motion.

    Parameters
    ----------
    body : Body
    motion : KnownMotion
    parameter_tangents : ndarray, shape (PARAMETERS, directions)
        How the parameters change in each direction.
    tangents : ndarray, shape (STATE_ROWS, directions)
        How the start changes; overwritten.
    solution : Solution
    workspace : Workspace
    """
    events, segments = motion.events, motion.segments
    at_events, at_segments = solution.at_events, solution.at_segments
    reasons, failed = solution.reasons, solution.failed
    done = 0
    for i in range(events.shape[0]):
        row = events[i]
        event_tangents = at_events[i]
        if row["kind"] == Event.APEX:
            event_tangents[:STATE_ROWS] = tangents
            pass_apex(body, row, segments[done], parameter_tangents, event_tangents[:STATE_ROWS], event_tangents, reasons)
            continue
        passed = False
        goes_along = False
        while done < segments.shape[0] and is_before(segments[done]["t"], segments[done]["t_low"], row):
            piece = segments[done]
            at_segments[done] = tangents
            if row["kind"] == Event.JAM:
                if piece["kind"] == LINEAR and not goes_along:
                    go_with_jam(body, piece["sigma"], state_of(piece), state_of(row), parameter_tangents, tangents)
                goes_along = piece["kind"] == LINEAR
            strikes = piece["kind"] == SKIMMING and row["kind"] == Event.IMPACT
            if piece["kind"] == FLY and skims_plane(body, piece["f_n"], state_of(piece), length_of(piece)):
                fail_all(tangents, reasons, Reason.GRAZE)
            if not strikes:
                follow_piece(body, piece, parameter_tangents, tangents, workspace)
            done += 1
            passed = True
        last = max(done - 1, 0)
        event_tangents[:STATE_ROWS] = tangents
        past = Past(segments[last], passed, at_segments[last])
        meet_event(body, row, past, motion.t_end, parameter_tangents, tangents, event_tangents, reasons)
        keep_after(row, tangents, event_tangents)
        for k in range(tangents.shape[1]):
            if reasons[k] > 0 and failed[k] < 0:
                failed[k] = i
                fail(tangents, reasons, k, reasons[k])
    while done < segments.shape[0]:  # of no length, at the very end
        at_segments[done] = tangents
        done += 1
