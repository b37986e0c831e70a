"""States at given times of a computed compliant motion, from the steps' own polynomials."""

from __future__ import annotations

import numpy as np

from hophoop.kernel.compliant.flight import fly_state
from hophoop.kernel.compliant.motion import contact_force
from hophoop.kernel.compliant.records import (
    DAMPING,
    FIRST,
    FLY,
    FRICTION,
    HOLD,
    KIND,
    LENGTH,
    MODE,
    OM,
    REGIME,
    RESISTED,
    SIZE,
    T_END,
    TH,
    TURNS,
    VN,
    VT,
    T,
    X,
    Y,
    Z,
)
from hophoop.kernel.compliant.tableau import STAGES
from hophoop.kernel.numerics.double_double import TWO_PI, TWO_PI_LOW
from hophoop.kernel.physics.compliant import spring_energy
from hophoop.kernel.physics.energy import kinetic_energy, potential_energy

# Columns of a sample, in kernel units.
COLUMNS = (
    "mode", "x", "height", "angle", "vx", "vy", "omega", "slip", "friction_force", "normal_force",
    "friction", "impact_normal", "impact_tangential", "spring", "damping", "rolling_resistance", "theta",
    "kinetic", "potential",
)  # fmt: skip


def find_row(rows, t, left):
    """Return the index of the segment that contains the time t; at a boundary the earlier one if `left`."""
    low = 0
    high = rows.shape[0]
    while high - low > 1:
        middle = (low + high) // 2
        begin = rows[middle, T]
        if begin < t or (begin == t and not left):
            low = middle
        else:
            high = middle
    return low


def sample(body, comp, rows, times, left, out):
    """Fill `out`, shape (len(times), len(COLUMNS)), with the motion at these times (kernel units)."""
    u = np.zeros(SIZE)
    begin = np.zeros(SIZE)
    for index in range(times.shape[0]):
        row = rows[find_row(rows, times[index], left)]
        t = min(max(times[index], row[T]), row[T_END])
        kind = row[KIND]
        regime = int(row[REGIME])
        for m in range(SIZE):
            begin[m] = row[FIRST + m * (STAGES + 1)]
        turns = row[TURNS]
        friction = 0.0
        normal = 0.0
        if kind == FLY:
            turns += fly_state(body, comp, begin, row[LENGTH], t - row[T], u)
        elif kind == HOLD:
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
        place[3] = turns * TWO_PI + (u[TH] + turns * TWO_PI_LOW)
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
        place[15] = u[RESISTED]
        place[16] = u[TH]
        place[17] = kinetic_energy(body, u[TH], u[OM], u[VT], u[VN], 0.0)
        place[18] = potential_energy(body, u[X], u[Y], u[TH])
