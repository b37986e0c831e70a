"""The event loop over contacts and flights on a compliant plane, and the states at given times of a computed motion."""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.compliant.contact_step import GUARDS, contact_step
from hophoop.kernel.compliant.flight import flight_step, fly_state
from hophoop.kernel.compliant.motion import contact_force
from hophoop.kernel.compliant.records import (
    DAMPING,
    DYNAMIC,
    FIRST,
    FLIGHT,
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
    end_motion,
    mode_of,
    new_work,
    within_revolution,
    write_plain_event,
)
from hophoop.kernel.numerics.arithmetic import TWO_PI, TWO_PI_LOW
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.physics.closed_forms import kinetic_energy, potential_energy
from hophoop.kernel.physics.compliant import BRISTLE, first_regime, normal_force, spring_energy
from hophoop.kernel.records.layout import EVENTS, PANELS, SEGMENTS
from hophoop.kernel.records.writing import Log, count_panel, find_segment, has_room

START, END = np.int64(Event.START), np.int64(Event.END)
NO_MODE = np.int64(-1)
COMPLETED, EVENT_LIMIT = int(Status.COMPLETED), int(Status.EVENT_LIMIT)
MAX_STEPS = 300_000  # a few seconds, and about 140 MB


def set_tolerances(body, comp, work):
    """Set the sizes of the variables to which errors are relative."""
    work.atol[Y] = min(1.0, 1.0 / comp.k)
    work.atol[TH] = 1.0
    work.atol[VT] = min(1.0, comp.v_s)
    work.atol[VN] = min(1.0, 1.0 / math.sqrt(comp.k))
    work.atol[OM] = min(1.0, comp.om_s) if body.resist > 0.0 else 1.0
    work.atol[Z] = 1.0
    if comp.friction == BRISTLE:
        work.atol[Z] = min(1.0, 1.0 / comp.k_t)
    for m in range(DYNAMIC, SIZE):
        work.atol[m] = 1.0


def begin(comp, touching, log, work):
    """Start a motion and return its first phase."""
    u = work.state
    regime = np.int64(0)
    mode = FLIGHT
    if touching:
        regime = first_regime(comp, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
        mode = mode_of(regime)
    revolutions, u[TH] = within_revolution(0.0, u[TH])
    write_plain_event(log, START, NO_MODE if touching else FLIGHT, mode, 0.0, revolutions, u)
    return Phase(0.0, revolutions, 0.0, mode, regime, True, 0.0, 0.0, 0.0, GOING)


def run(body, comp, start, touching, t_end, rtol, max_steps, events, rows, reached):
    """Compute a motion up to `t_end`; return (status, number of events, number of segments).

    `start` has the shape (SIZE,) and is not changed; `touching` is True if the contact acts there. The motion is given up after
    `max_steps` steps, failed ones included, and flights. `events` and `rows` are filled; if there are more segments than rows,
    these are only counted. `reached[0]` is the computed fraction of the time, for another thread.
    """
    work = new_work()
    armed = np.zeros(GUARDS, np.bool_)
    for m in range(SIZE):
        work.state[m] = start[m]
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
            phase = contact_step(body, comp, phase, t_end, rtol, armed, log, work)
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
        for m in range(SIZE):
            begin[m] = row[FIRST + m * (STAGES + 1)]
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
        place = out[index]
        place[0] = row[MODE]
        place[1] = u[X]
        place[2] = u[Y]
        place[3] = revolutions * TWO_PI + (u[TH] + revolutions * TWO_PI_LOW)
        place[4] = u[VT] + u[OM]
        place[5] = u[VN]
        place[6] = u[OM]
        place[7] = u[VT]
        place[8] = friction
        place[9] = normal
        place[10] = u[FRICTION]
        place[11] = 0.0
        place[12] = 0.0
        place[13] = spring_energy(comp, u[Y], u[Z])
        place[14] = u[DAMPING]
        place[15] = u[ROLLING_LOSS]
        place[16] = u[TH]
        place[17] = kinetic_energy(body, u[TH], u[OM], u[VT], u[VN], 0.0)
        place[18] = potential_energy(body, u[X], u[Y], u[TH])
