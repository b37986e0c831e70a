"""What the kernels write: one record an event, one a segment."""

from __future__ import annotations

import numpy as np

_STATE = ["x", "height", "angle", "vx", "vy", "omega"]
# What rounding keeps from time and place, and the angle as whole turns and θ within the turn.
_PLACE = ["t_low", "x_low", "turns", "theta", "theta_low"]
_ENERGY = ["friction", "impact_normal", "impact_tangential"]
# Kernel units (R, m, √(R/g)). `slip` is v_t after the event, kept because ẋ − Rθ̇ loses its digits near 0;
# energies are those dissipated from the start to just after the event; `gain` is Kane's.
EVENT = np.dtype(
    [("t", "f8"), ("kind", "i8"), ("before_mode", "i8"), ("after_mode", "i8")]
    + [(name, "f8") for name in _STATE]
    + [("slip", "f8"), ("before_vx", "f8"), ("before_vy", "f8"), ("before_omega", "f8"), ("before_slip", "f8")]
    + [("impulse_normal", "f8"), ("impulse_tangential", "f8")]
    + [(name, "f8") for name in _ENERGY]
    + [("gain", "f8"), ("collision", "i8"), ("stable", "i8")]
    + [(name, "f8") for name in _PLACE]
    + [("rolling_resistance", "f8")]
)
# All that is needed to compute the motion inside the segment again, bit for bit.
SEGMENT = np.dtype(
    [("t", "f8"), ("t_end", "f8"), ("mode", "i8"), ("kind", "i8"), ("sigma", "i8"), ("level", "i8")]
    + [("way", "f8"), ("ref", "f8"), ("sine", "f8"), ("cosine", "f8"), ("extent", "f8")]
    + [("arm", "f8"), ("stiffness", "f8"), ("u", "f8"), ("xi", "f8"), ("opening", "f8")]
    + [("x", "f8"), ("height", "f8"), ("angle", "f8"), ("vy", "f8"), ("omega", "f8"), ("slip", "f8")]
    + [(name, "f8") for name in _ENERGY]
    + [("ref_low", "f8")]
    + [(name, "f8") for name in _PLACE]
    + [("rolling_resistance", "f8")]
)


def first_rows(table: np.ndarray, count: int) -> np.ndarray:
    """A copy of the first rows of a table, as bytes: NumPy copies records number by number, which takes three times as long."""
    return np.ndarray(count, table.dtype, bytearray(table[:count].tobytes()))
