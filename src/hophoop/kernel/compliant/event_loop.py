"""The event loop over contacts and flights on a compliant plane, and the states at given times of a computed motion."""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.compliant.contact_step import contact_step
from hophoop.kernel.compliant.motion import contact_force
from hophoop.kernel.compliant.records import (
    DAMPING,
    FIRST,
    FLY,
    FRICTION,
    GOING,
    KIND,
    LENGTH,
    MODE,
    OM,
    REGIME,
    RESTING,
    REVOLUTIONS,
    ROLLING_LOSS,
    SIZE,
    STAGES,
    T_END,
    TH,
    VN,
    VT,
    Phase,
    T,
    X,
    Y,
    Z,
    append_segment,
    begin_phase,
    end_motion,
    mode_of,
    new_work,
    within_revolution,
    write_plain_event,
)
from hophoop.kernel.native import replaced
from hophoop.kernel.numerics.arithmetic import TWO_PI, TWO_PI_LOW, revolutions_and_rest
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.collocation import NOT_FOUND, ORDER, margin_downcrossing
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.landing import first_landing
from hophoop.kernel.physics.body import APEX, COMPLETED, END, EVENT_LIMIT, FLIGHT, IMPACT, START
from hophoop.kernel.physics.closed_forms import flight_displacement, flight_gap, kinetic_energy, potential_energy
from hophoop.kernel.physics.compliant import BRISTLE, KELVIN_VOIGT, first_regime, normal_force, spring_energy
from hophoop.kernel.physics.contact import free_acceleration
from hophoop.kernel.records.layout import EVENTS, PANELS, SEGMENTS
from hophoop.kernel.records.writing import Log, count_panel, find_segment, has_room

MAX_STEPS = 300_000  # a few seconds, and about 140 MB
MOST_PANELS = 20_000  # maximum per flight below the plane's level
PHASE = 3.0  # rad of rotation per panel: the first omitted coefficient, J₁₆(1.5), is 5e-16
LANDED, CLEAR, LASTS, GIVEN_UP = 0, 1, 2, 3

# --- flight in closed form, also while the rim is still below the plane's level -----------------------------------------------


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
        clear = margin_downcrossing(work.values[0], True, 0.0, work)[0]
        landed = margin_downcrossing(work.values[1], True, 0.0, work)[0]
        first = min(clear, landed)
        if first != NOT_FOUND:
            return (CLEAR if clear <= landed else LANDED), start + 0.5 * length * (1.0 + first)
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
    more = fly_state(body, comp, u, f_n, tau, work.start)
    phase = replaced(phase, revolutions=phase.revolutions + more)
    if what == CLEAR or (what == LANDED and u[Y] >= 0.0):
        work.start[Y] = 0.0
    u[:] = work.start
    if what == GIVEN_UP:
        return end_motion(phase, after, EVENT_LIMIT)
    if what != LANDED:
        return begin_phase(phase, after, FLIGHT, phase.regime)
    regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
    mode = mode_of(regime)
    write_plain_event(log, IMPACT, FLIGHT, mode, after, phase.revolutions, u)
    return begin_phase(phase, after, mode, regime)


# --- the motion --------------------------------------------------------------------------------------------------------------


def set_tolerances(body, comp, work):
    """Set the sizes of the variables to which errors are relative."""
    work.atol[:] = 1.0
    work.atol[Y] = min(1.0, 1.0 / comp.k)
    work.atol[VT] = min(1.0, comp.v_s)
    work.atol[VN] = min(1.0, 1.0 / math.sqrt(comp.k))
    if body.resist > 0.0:
        work.atol[OM] = work.atol[VT]
    if comp.friction == BRISTLE:
        work.atol[Z] = min(1.0, 1.0 / comp.k_t)


def begin(comp, touching, log, work):
    """Start a motion and return its first phase."""
    u = work.state
    regime = 0
    mode = FLIGHT
    if touching:
        regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
        mode = mode_of(regime)
    revolutions, u[TH] = within_revolution(0.0, u[TH])
    write_plain_event(log, START, -1 if touching else FLIGHT, mode, 0.0, revolutions, u)
    return Phase(0.0, revolutions, 0.0, mode, regime, True, 0.0, 0.0, 0.0, GOING)


def run(body, comp, start, touching, t_end, rtol, max_steps, events, rows, reached):
    """Compute a motion up to `t_end`; return (status, number of events, number of segments).

    `start` has the shape (SIZE,) and is not changed; `touching` is True if the contact acts there. The motion is given up after
    `max_steps` steps, failed ones included, and flights. `events` and `rows` are filled; if there are more segments than rows,
    these are only counted. `reached[0]` is the computed fraction of the time, for another thread.
    """
    work = new_work()
    work.state[:] = start
    set_tolerances(body, comp, work)
    log = Log(events, rows, np.array([0, 0, 0, max_steps + 1]), np.full(1, math.nan))
    phase = begin(comp, touching, log, work)
    while phase.status == GOING and phase.t < t_end and has_room(log):
        count_panel(log)  # failed steps count too
        if log.counts[PANELS] >= max_steps:
            phase = end_motion(phase, phase.t, EVENT_LIMIT)
        elif phase.mode == FLIGHT:
            phase = flight_step(body, comp, phase, t_end, log, work)
        else:
            phase = contact_step(body, comp, phase, t_end, rtol, log, work)
        reached[0] = phase.t / t_end
    write_plain_event(log, END, phase.mode, phase.mode, phase.t, phase.revolutions, work.state)
    if log.counts[EVENTS] < 0:
        return EVENT_LIMIT, events.shape[0], log.counts[SEGMENTS]
    return COMPLETED if phase.status == GOING else phase.status, log.counts[EVENTS], log.counts[SEGMENTS]


# --- sampling, from the steps' own polynomials

# Columns of a sample, in kernel units.
COLUMNS = (
    "mode", "x", "height", "angle", "vx", "vy", "omega", "slip", "friction_force", "normal_force",
    "friction", "impact_normal", "impact_tangential", "spring", "damping", "rolling_resistance", "theta",
    "kinetic", "potential",
)  # fmt: skip


def sample(body, comp, rows, times, left, out):
    """Fill `out`, shape (len(times), len(COLUMNS)), with the motion at these times (kernel units)."""
    u = np.zeros(SIZE)
    begin = np.zeros(SIZE)
    for index in range(times.shape[0]):
        row = rows[find_segment(rows[:, T], times[index], left)]
        t = min(max(times[index], row[T]), row[T_END])
        kind = row[KIND]
        regime = int(row[REGIME])
        begin[:] = row[FIRST :: STAGES + 1]
        revolutions = row[REVOLUTIONS]
        friction = 0.0
        normal = 0.0
        if kind == FLY:
            revolutions += fly_state(body, comp, begin, row[LENGTH], t - row[T], u)
        elif kind == RESTING:
            u[:] = begin
        else:
            # a step may be shorter than one ulp of its times
            s = 1.0 if t >= row[T_END] else min((t - row[T]) / row[LENGTH], 1.0)
            for m in range(SIZE):
                at = FIRST + m * (STAGES + 1)
                value = row[at + STAGES]
                for j in range(STAGES - 1, -1, -1):
                    value = value * s + row[at + j]
                u[m] = value
        if kind != FLY:
            friction, normal = contact_force(comp, regime, u)
            if normal < 0.0:  # rounding, where the contact ends
                normal = 0.0
                friction = 0.0
        values = (
            row[MODE], u[X], u[Y], revolutions * TWO_PI + (u[TH] + revolutions * TWO_PI_LOW), u[VT] + u[OM], u[VN], u[OM],
            u[VT], friction, normal, u[FRICTION], 0.0, 0.0, spring_energy(comp, u[Y], u[Z]), u[DAMPING], u[ROLLING_LOSS], u[TH],
            kinetic_energy(body, u[TH], u[OM], u[VT], u[VN], 0.0), potential_energy(body, u[X], u[Y], u[TH]),
        )  # fmt: skip
        for i in range(len(values)):
            out[index, i] = values[i]
