"""A motion that is known, gone through again with its derivatives in all directions, in nopython mode."""

from __future__ import annotations

import math

from hophoop.derivatives.events.conditions import (
    fail,
    fail_all,
    go_with_jam,
    is_on_border,
    lose_slip,
    meet_cone,
    meet_jam,
    meet_opening,
    meet_row,
    meet_time,
    part_at_rest,
)
from hophoop.derivatives.events.impact import NONE, SIDED, impact_change, pulled_back
from hophoop.derivatives.events.massless import follow_strike, skim_rates
from hophoop.derivatives.events.start_in_contact import let_fall, stop_throw
from hophoop.derivatives.layout import (
    BEFORE_OM,
    BEFORE_VN,
    BEFORE_VT,
    CARRIED,
    END,
    EPS,
    IMPACT_N,
    IMPACT_T,
    KAP,
    OM,
    P_N,
    P_T,
    RESISTED,
    REST,
    TH,
    VN,
    VT,
    Reason,
    Y,
)
from hophoop.derivatives.pieces.flight_and_rest import accelerations, motion_against, resisted_motion, skims_plane
from hophoop.derivatives.pieces.pieces import follow_piece, follow_without_panel, is_before, is_panel, length_of
from hophoop.kernel.native import apart
from hophoop.kernel.numerics.circular import sine
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.panels.panel import FLY, HOLD, LINEAR, SKIMMING
from hophoop.kernel.physics.body import Event, Mode
from hophoop.kernel.physics.contact import free_acceleration
from hophoop.kernel.physics.impact import impact
from hophoop.kernel.physics.modes import slip_direction
from hophoop.kernel.physics.resistance import forces_rolling
from hophoop.kernel.records.state import with_velocities
from hophoop.kernel.records.writing import state_of

ROLL, FLIGHT, SKIM = int(Mode.ROLL), int(Mode.FLIGHT), int(Mode.SKIM)
SLIP_START, STICK, SLIP_REVERSAL, TAKEOFF, IMPACT, TURN, APEX = (
    int(kind)
    for kind in (Event.SLIP_START, Event.STICK, Event.SLIP_REVERSAL, Event.TAKEOFF, Event.IMPACT, Event.TURN, Event.APEX)
)
START, BOUNCE_LIMIT, JAM, SKIM_START, REST_EVENT, END_EVENT = (
    int(kind) for kind in (Event.START, Event.BOUNCE_LIMIT, Event.JAM, Event.SKIM, Event.REST, Event.END)
)
PAINLEVE_INCONSISTENT = int(Event.PAINLEVE_INCONSISTENT)
GRAZE, BORDER, CONTACT, SINGULAR = (int(why) for why in (Reason.GRAZE, Reason.BORDER, Reason.CONTACT, Reason.SINGULAR))
MASSLESS, FRICTIONLESS, ENDED, PLASTIC = (
    int(why) for why in (Reason.MASSLESS, Reason.FRICTIONLESS, Reason.ENDED, Reason.PLASTIC)
)


@apart
def begin_lifted(body, mode, state, z, reasons, k):
    """A start in contact whose rim is lifted or thrown: it flies off, or comes down again, and then has other events."""
    if mode == FLIGHT and z[Y, k] >= 0.0 and z[VN, k] >= 0.0:
        reasons[k] = SIDED
        return
    sigma = slip_direction(mode)
    contact = body.kap > 0.0 and mode != FLIGHT and mode != SKIM
    if contact and (stop_throw(body, sigma, state, z, k) if z[VN, k] != 0.0 else let_fall(body, sigma, state, z, k)):
        reasons[k] = CONTACT
    else:
        fail(z, reasons, k, CONTACT)


@apart
def begin_changes(body, row, changes, z, reasons):
    """What a changed start does at once."""
    state = state_of(row)
    if state.y > 0.0 or state.vn != 0.0:
        return
    mode = row["after_mode"]
    for k in range(z.shape[1]):
        if z[Y, k] != 0.0 or z[VN, k] != 0.0:
            begin_lifted(body, mode, state, z, reasons, k)
    if mode != FLIGHT and mode != SKIM and state.vt == 0.0:
        lose_slip(body, state, slip_direction(mode), changes, z, reasons)
    if mode != FLIGHT and mode != SKIM:
        part_at_rest(body, slip_direction(mode), state, z, reasons)
    if is_on_border(body, state):
        fail_all(z, reasons, BORDER)


@apart
def end_rolling(body, row, before, rates, changes, z, reasons):
    """Rolling that ends at the friction cone, or at N = 0."""
    s, c = sine_cosine(before.th, before.th_low)
    friction = forces_rolling(body, s, c, before.om)[0]
    meet_cone(body, before, rates, 1.0 if friction > 0.0 else -1.0, changes, z, reasons)
    if row["kind"] == SKIM_START:
        for k in range(z.shape[1]):
            if changes[EPS, k] != 0.0 or changes[KAP, k] != 0.0:
                fail(z, reasons, k, MASSLESS)


@apart
def stays_with_small_bounces(row):
    """Whether the motion behind a landing with e = 0 is the same to first order in a small e.

    The bounces last a time of order e, at whose end the same quantities are zero as without them, N and F having done what
    their impulses do. So the state differs by the order e², where the contact goes on and its slip keeps its direction;
    but for the couple of rolling resistance, see `bounce_freely`.
    """
    mode = row["after_mode"]
    return row["collision"] == 1 and mode != FLIGHT and mode != SKIM and (mode == ROLL or row["slip"] != 0.0)


@apart
def bounce_freely(body, row, before, drest, z, k):
    """The time 2 v_n/abs(f_n) of the first bounce after a landing with a small e has no rolling resistance.

    Returns whether that is all: a hoop that rolls must do so again after it, and a hoop at rest would begin to turn.
    """
    after = state_of(row)
    s, c = sine_cosine(after.th, after.th_low)
    small = 2.0**-30  # v_n after the landing is in proportion to e
    thrown = impact(body, small, s, c, before.vt, before.vn)
    along, away = free_acceleration(body, s, c, after.om * after.om)
    rolls = row["after_mode"] == ROLL
    if after.om == 0.0 or not away < 0.0:
        return False
    if rolls and not (thrown[0] == 0.0 and impact(body, 0.0, s, c, -2.0 * along / away, -1.0)[0] == 0.0):
        return False
    time = -2.0 * thrown[1] / (small * away) * drest
    sigma = slip_direction(row["after_mode"])
    with_couple = resisted_motion(body, sigma, after, 0.0)
    without = motion_against(body, sigma, after, 0.0)
    z[OM, k] -= (with_couple[0] - without[0]) * time
    z[VT, k] -= (with_couple[1] - without[1]) * time
    z[RESISTED, k] -= with_couple[3] * time
    return True


@apart
def collide_changes(body, rest, row, before, changes, z, kept, reasons):
    """All directions through an impact."""
    s, c = sine_cosine(before.th, before.th_low)
    closes = row["kind"] == BOUNCE_LIMIT
    vn = impact(body, rest, s, c, before.vt, before.vn)[1]
    for k in range(z.shape[1]):
        if math.isnan(z[TH, k]):
            continue
        dvt, dvn, dspin, dp_n, dp_t, dloss_n, dloss_t, reason = impact_change(
            body, rest, s, c, before.vt, before.vn, z[TH, k], z[VT, k], z[VN, k], changes, k
        )
        if closes and vn > 0.0:
            turned, pulled_n, pulled_t, lost = pulled_back(body, s, c, vn, z[TH, k], dvn, changes, k)
            dvt = dvn = 0.0
            dspin += turned
            dp_n += pulled_n
            dp_t += pulled_t
            dloss_n += lost
        z[VT, k] = dvt
        z[VN, k] = dvn
        z[OM, k] += dspin
        kept[P_N, k] = dp_n
        kept[P_T, k] = dp_t
        z[IMPACT_N, k] += dloss_n
        z[IMPACT_T, k] += dloss_t
        if reason == SIDED:
            if reasons[k] == NONE:
                reasons[k] = SIDED
        elif (
            reason == PLASTIC
            and stays_with_small_bounces(row)
            and (body.resist == 0.0 or bounce_freely(body, row, before, changes[REST, k], z, k))
        ):
            if reasons[k] <= 0:
                reasons[k] = PLASTIC
        elif reason != NONE:
            fail(z, reasons, k, reason)


@apart
def keep_before(z, kept):
    """The velocities just before an event, and no impulse."""
    for k in range(z.shape[1]):
        kept[BEFORE_OM, k] = z[OM, k]
        kept[BEFORE_VT, k] = z[VT, k]
        kept[BEFORE_VN, k] = z[VN, k]
        kept[P_N, k] = 0.0 * z[OM, k]
        kept[P_T, k] = 0.0 * z[OM, k]


@apart
def meet_event(body, row, fresh, piece, passed, t_end, changes, z, kept, reasons):
    """All directions to an event, and what they are just after it.

    `passed` tells whether a piece lies between the event before and this one, `piece` is the last one that was
    gone through. `fresh` are the directions at the begin of that piece.
    """
    kind = row["kind"]
    mode = row["before_mode"]
    after = state_of(row)
    before = with_velocities(after, row["before_slip"], row["before_vy"], row["before_omega"])
    if kind == IMPACT and mode == SKIM:
        for k in range(z.shape[1]):
            for i in range(CARRIED):
                z[i, k] = fresh[i, k]
        follow_strike(body, state_of(piece), length_of(piece), changes, z, kept)
        return
    if kind == START:
        begin_changes(body, row, changes, z, reasons)
        keep_before(z, kept)
        return
    rates = (0.0, 0.0, 0.0, 0.0)
    way = piece["way"] if passed and is_panel(piece) else 0.0
    # the couple changes its sign where the hoop turns round, and with it the forces: what follows is decided anew
    turned = body.resist > 0.0 and way != 0.0 and before.om == 0.0
    if mode == SKIM:
        rates = skim_rates(body, before)
    elif mode >= 0 and not (passed and piece["kind"] == HOLD and piece["sigma"] == 0):
        rates = accelerations(body, mode, before, way)
    if turned and kind != END_EVENT:
        pass
    elif mode == ROLL and (kind in (SLIP_START, TAKEOFF) or (kind == SKIM_START and passed)):
        end_rolling(body, row, before, rates, changes, z, reasons)
    elif kind == TAKEOFF and before.vt != 0.0:
        meet_opening(body, before, rates, changes, z, reasons)
    elif kind in (STICK, SLIP_REVERSAL, TAKEOFF):
        meet_row(VT, rates[1], 1e-300 + body.gn + abs(body.gt) + before.om * before.om, before, rates, z, reasons)
    elif (kind == IMPACT and mode == FLIGHT and row["collision"] == 1) or kind == BOUNCE_LIMIT:
        meet_row(Y, before.vn, 1e-300, before, rates, z, reasons)
    elif kind == JAM:
        meet_jam(body, slip_direction(mode), after, before, changes, z)
    elif kind == PAINLEVE_INCONSISTENT and passed:
        fail_all(z, reasons, SINGULAR)
    elif kind == REST_EVENT and body.mu_s == 0.0:
        fail_all(z, reasons, FRICTIONLESS)
    elif kind == END_EVENT:
        if row["t"] == t_end:
            meet_time(changes, END, before, rates, z)
        elif mode == ROLL and math.isinf(body.mu_s):  # N = 0, but free motion would enter the plane
            end_rolling(body, row, before, rates, changes, z, reasons)
        elif passed:
            fail_all(z, reasons, ENDED)
    keep_before(z, kept)
    if kind == SKIM_START and sine(before.th) == 0.0:
        fail_all(z, reasons, MASSLESS)
    if kind == IMPACT:
        collide_changes(body, body.rest, row, before, changes, z, kept, reasons)
    elif kind == BOUNCE_LIMIT:
        collide_changes(body, 0.0, row, before, changes, z, kept, reasons)
    settled = (kind in (IMPACT, STICK, SLIP_REVERSAL, BOUNCE_LIMIT) or turned) and row["after_mode"] != FLIGHT
    if settled and kind != END_EVENT:
        if is_on_border(body, after):
            fail_all(z, reasons, BORDER)
        part_at_rest(body, slip_direction(row["after_mode"]), after, z, reasons)


@apart
def keep_after(row, z, kept):
    """What all directions are just after an event; the start keeps what was given, not what becomes of it at once."""
    for k in range(z.shape[1]):
        if row["kind"] != START or math.isnan(z[TH, k]):
            for i in range(CARRIED):
                kept[i, k] = z[i, k]


@apart
def pass_apex(body, row, piece, changes, z, kept, reasons):
    """All directions from the begin of a flight to its apex, which is an event inside of it."""
    tau = ((row["t"] - piece["t"]) + row["t_low"]) - piece["t_low"]
    state = follow_without_panel(body, piece, tau, changes, z)
    state = with_velocities(state, state.vt, 0.0, state.om)
    rates = accelerations(body, FLIGHT, state, 0.0)
    meet_row(VN, rates[2], 1e-300 + body.gn + state.om * state.om, state, rates, z, reasons)
    keep_before(z, kept)


def replay(body, events, segments, changes, z, t_end, at_events, at_segments, reasons, failed, scratch, local):
    """Derivatives at all events and at the begin of all pieces of a motion.

    Parameters
    ----------
    body : Body
    events, segments : ndarray of records.EVENT, records.SEGMENT
        The motion, in kernel units like all that follows.
    changes : ndarray, shape (PARAMETERS, directions)
        How the parameters change in each direction.
    z : ndarray, shape (CARRIED, directions)
        How the start changes; used up.
    t_end : float
        Duration.
    at_events : ndarray, shape (events, KEPT, directions)
        Filled.
    at_segments : ndarray, shape (segments, CARRIED, directions)
        Filled; what is there for a segment belongs to its begin.
    reasons : ndarray of int, shape (directions,)
        Filled with why there is no derivative from some event on, −1 where it holds for one side only, else 0. After a
        landing with e = 0 the states go on, as they change with larger e; the events there are others.
    failed : ndarray of int, shape (directions,)
        Filled with the event from which on there is none.
    scratch : records.Scratch
    local : ndarray, shape (panels.ROWS, ORDER)
    """
    done = 0
    for i in range(events.shape[0]):
        row = events[i]
        kept = at_events[i]
        if row["kind"] == APEX:
            kept[:CARRIED] = z
            pass_apex(body, row, segments[done], changes, kept[:CARRIED], kept, reasons)
            continue
        passed = False
        goes_along = False
        while done < segments.shape[0] and is_before(segments[done]["t"], segments[done]["t_low"], row):
            piece = segments[done]
            at_segments[done] = z
            if row["kind"] == JAM:
                if piece["kind"] == LINEAR and not goes_along:
                    go_with_jam(body, piece["sigma"], state_of(piece), state_of(row), changes, z)
                goes_along = piece["kind"] == LINEAR
            strikes = piece["kind"] == SKIMMING and row["kind"] == IMPACT
            if piece["kind"] == FLY and skims_plane(body, piece["opening"], state_of(piece), length_of(piece)):
                fail_all(z, reasons, GRAZE)
            if not strikes:
                follow_piece(body, piece, changes, z, scratch, local)
            done += 1
            passed = True
        last = max(done - 1, 0)
        kept[:CARRIED] = z
        meet_event(body, row, at_segments[last], segments[last], passed, t_end, changes, z, kept, reasons)
        keep_after(row, z, kept)
        for k in range(z.shape[1]):
            if reasons[k] > 0 and failed[k] < 0:
                failed[k] = i
    while done < segments.shape[0]:  # of no length, at the very end
        at_segments[done] = z
        done += 1
