"""The quantities of events that have derivatives: their rows, their units, and how the units change with the parameters."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.layout import (
    BEFORE_OM,
    BEFORE_VN,
    BEFORE_VT,
    IMPACT_N,
    IMPACT_T,
    OM,
    P_N,
    P_T,
    ROLLING_LOSS,
    TH,
    VN,
    VT,
    T,
    X,
    Y,
)
from hophoop.kernel.model import Scales

# Exponents of the units of length, time and mass.
LENGTH, TIME, ANGLE, SPEED, TURNING = (1, 0, 0), (0, 1, 0), (0, 0, 0), (1, -1, 0), (0, -1, 0)
MOMENTUM, ENERGY = (1, -1, 1), (2, -2, 1)
# Quantities of an event: column of the record, row of its derivatives, unit.
DIRECT = {
    "t": ("t", T, TIME),
    "x": ("x", X, LENGTH),
    "height": ("height", Y, LENGTH),
    "angle": ("angle", TH, ANGLE),
    "omega": ("omega", OM, TURNING),
    "slip": ("slip", VT, SPEED),
    "vy": ("vy", VN, SPEED),
    "before.omega": ("before_omega", BEFORE_OM, TURNING),
    "before.slip": ("before_slip", BEFORE_VT, SPEED),
    "before.vy": ("before_vy", BEFORE_VN, SPEED),
    "impulse_normal": ("impulse_normal", P_N, MOMENTUM),
    "impulse_tangential": ("impulse_tangential", P_T, MOMENTUM),
    "impact_normal": ("impact_normal", IMPACT_N, ENERGY),
    "impact_tangential": ("impact_tangential", IMPACT_T, ENERGY),
    "rolling_resistance": ("rolling_resistance", ROLLING_LOSS, ENERGY),
}
UNITS = (LENGTH, TIME, ANGLE, SPEED, TURNING, MOMENTUM, ENERGY)
UNIT_OF_ROW = np.array([UNITS.index(unit) for _, _, unit in sorted(DIRECT.values(), key=lambda each: each[1])])


def sizes_and_rates(scales: Scales, units: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Sizes of UNITS, and their logarithmic rates in each direction, from those of length, time and mass."""
    sizes = [scales.length, scales.time, 1.0, scales.speed, scales.rate, scales.impulse, scales.energy]
    return np.array(sizes), (np.array(UNITS)[..., None] * units).sum(axis=1)
