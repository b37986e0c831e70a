"""Flight between contacts, in closed form, also while the rim is still below the plane's level."""

from __future__ import annotations

import numpy as np

from hophoop.kernel.compliant.records import (
    DAMPING,
    FLIGHT,
    FLY,
    FRICTION,
    IMPACT,
    OM,
    ROLLING_LOSS,
    SIZE,
    TH,
    VN,
    VT,
    X,
    Y,
    Z,
    add_revolutions,
    append_segment,
    begin_phase,
    end_motion,
    mode_of,
    within_revolution,
    write_plain_event,
)
from hophoop.kernel.numerics.arithmetic import revolutions_and_rest
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.collocation import NOT_FOUND, ORDER, coefficients, first_downcrossing
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.landing import first_landing
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.physics.closed_forms import flight_displacement, flight_gap
from hophoop.kernel.physics.compliant import BRISTLE, KELVIN_VOIGT, first_regime, normal_force
from hophoop.kernel.physics.contact import free_acceleration

APEX = np.int64(Event.APEX)
EVENT_LIMIT = int(Status.EVENT_LIMIT)
MOST_PANELS = 20_000  # maximum per flight below the plane's level
PHASE = 3.0  # rad of rotation per panel: the first omitted coefficient, J₁₆(1.5), is 5e-16
LANDED, CLEAR, LASTS, GIVEN_UP = 0, 1, 2, 3


def fly_state(body, comp, begin, f_n, tau, out):
    """Fill `out` with the state after the time tau of a flight; `f_n` is f_n at its start. Return the revolutions."""
    s, c = sine_and_cosine(begin[TH])
    out[Y], out[VN] = flight_gap(body, s, c, begin[OM], begin[Y], begin[VN], f_n, tau)
    along, out[VT] = flight_displacement(body, begin[VT], begin[OM], s, c, tau)
    out[X] = begin[X] + along
    # of the same angle as in the gap, which may be many revolutions
    more, rest, low = revolutions_and_rest(begin[OM] * tau)
    revolutions, out[TH] = within_revolution(more, begin[TH] + (rest + low))
    out[OM] = begin[OM]
    out[Z] = 0.0
    out[FRICTION] = begin[FRICTION]
    out[ROLLING_LOSS] = begin[ROLLING_LOSS]
    if comp.friction == BRISTLE and begin[Z] != 0.0:
        # the free bristle relaxes; its damper dissipates its spring's energy
        out[Z] = begin[Z] * exponential(-comp.k_t / comp.c_t * tau)
        out[FRICTION] += 0.5 * comp.k_t * (begin[Z] - out[Z]) * (begin[Z] + out[Z])
    # the normal damper likewise, since the spring cannot follow the rim
    before = min(begin[Y], 0.0)
    after = min(out[Y], 0.0)
    out[DAMPING] = begin[DAMPING] + 0.5 * comp.k * (before - after) * (before + after)
    return revolutions


def _negative_contact_condition(comp, y, vn):
    """Return the negative of the quantity that is positive when the contact acts again below the plane's level."""
    if comp.law == KELVIN_VOIGT:
        return comp.k * y + comp.c * vn
    return comp.d * vn - 1.0


def fly_below(body, comp, begin, f_n, limit, work):
    """Return (outcome, τ) of a flight below the plane's level: CLEAR of it, LANDED again, LASTS, or GIVEN_UP."""
    s, c = sine_and_cosine(begin[TH])
    om = begin[OM]
    start = 0.0
    length = 4.0 * abs(begin[Y]) / max(begin[VN], 1e-300)
    for _ in range(MOST_PANELS):
        if not start < limit:
            return LASTS, limit
        length = min(length, limit - start)
        if om != 0.0:
            length = min(length, PHASE / abs(om))
        for i in range(ORDER):
            tau = start + 0.5 * length * (1.0 + NODES[i])
            y, vn = flight_gap(body, s, c, om, begin[Y], begin[VN], f_n, tau)
            work.values[0, i] = -y
            work.values[1, i] = _negative_contact_condition(comp, y, vn)
        what = LASTS
        best = NOT_FOUND
        coefficients(work.values[0], work.series)
        xi = first_downcrossing(work.series, 0.0, work.stack)
        if xi != NOT_FOUND:
            best = xi
            what = CLEAR
        coefficients(work.values[1], work.series)
        xi = first_downcrossing(work.series, 0.0, work.stack)
        if xi != NOT_FOUND and (best == NOT_FOUND or xi < best):
            best = xi
            what = LANDED
        if what != LASTS:
            return what, start + 0.5 * length * (1.0 + best)
        start += length
        length *= 2.0
    return GIVEN_UP, start


def fly_above(body, begin, f_n, vanishing_derivatives, limit):
    """Return (outcome, τ, τ of the apex or −1) of a flight from the plane's level or above it."""
    landing, apex, seen = first_landing(body, begin[TH], begin[OM], begin[Y], begin[VN], f_n, vanishing_derivatives, limit)
    if 0.0 <= landing <= limit:
        return LANDED, landing, apex
    return (GIVEN_UP if seen < limit else LASTS), seen, apex


def flight_step(body, comp, phase, t_end, log, work):
    """Fly up to the next contact or the final time; return the next phase."""
    u = work.state
    t = phase.t
    s, c = sine_and_cosine(u[TH])
    f_n = free_acceleration(body, s, c, u[OM] * u[OM])[1]
    apex = -1.0
    if u[Y] < 0.0:
        what, tau = fly_below(body, comp, u, f_n, t_end - t, work)
    elif u[Y] == 0.0 and u[VN] < 0.0:  # a start that lands at once
        what, tau = LANDED, 0.0
    else:
        vanishing_derivatives = 0 if u[Y] > 0.0 else 1 if u[VN] > 0.0 else 2
        what, tau, apex = fly_above(body, u, f_n, vanishing_derivatives, t_end - t)
    if 0.0 < apex < tau:
        more = fly_state(body, comp, u, f_n, apex, work.start)
        work.start[VN] = 0.0
        write_plain_event(log, APEX, FLIGHT, FLIGHT, t + apex, phase.revolutions + more, work.start)
    after = t_end if what == LASTS else t + tau
    append_segment(log, phase, after, FLY, f_n, work)
    phase = add_revolutions(phase, fly_state(body, comp, u, f_n, tau, work.start))
    if what == CLEAR or (what == LANDED and u[Y] >= 0.0):
        work.start[Y] = 0.0
    for m in range(SIZE):
        u[m] = work.start[m]
    if what == GIVEN_UP:
        return end_motion(phase, after, EVENT_LIMIT)
    if what != LANDED:
        return begin_phase(phase, after, FLIGHT, phase.regime)
    regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
    mode = mode_of(regime)
    write_plain_event(log, IMPACT, FLIGHT, mode, after, phase.revolutions, u)
    return begin_phase(phase, after, mode, regime)
