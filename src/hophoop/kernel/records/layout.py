"""What the kernels are given, a column of numbers a motion, and what they write: one record an event, one a segment."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

# Rows of the array of cells, in SI units; `allowed` is 0 where the values do not go together.
CELL = (
    "radius", "mass", "eccentricity", "inertia_ratio", "gravity", "slope", "mu_static", "mu_kinetic",
    "restitution", "law", "strike", "x", "height", "angle", "vy", "omega", "slip", "duration", "max_events",
    "ideal", "rolling_resistance", "allowed",
)  # fmt: skip
(
    RADIUS, MASS, ECCENTRICITY, INERTIA_RATIO, GRAVITY, SLOPE, MU_STATIC, MU_KINETIC,
    RESTITUTION, LAW, STRIKE, X, HEIGHT, ANGLE, VY, OMEGA, SLIP, DURATION, MAX_EVENTS,
    IDEAL, ROLLING_RESISTANCE, ALLOWED,
) = range(len(CELL))  # fmt: skip

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


# Panels solved for one motion, those given up for narrower ones included: a few seconds, and 70 MB where all are kept.
MOST_PANELS = 500_000


# What the counts of a motion are of; −1 stands for a table that was too short.
EVENTS, SEGMENTS, PANELS, PANEL_LIMIT = range(4)


class Tables(NamedTuple):
    """One motion: its cell, and what it is written into."""

    cell: Any  # of shape (len(CELL), 1)
    events: Any
    segments: Any


class MapRequest(NamedTuple):
    """What a map needs of each motion."""

    angle_span: float  # largest rotation from the start, nan for no limit [rad]
    stop: int  # flags of the events that end the motion
    timed: bool  # whether the cell's duration ends it
    quantities: int  # flags of the quantities that take extra time


class MapResults(NamedTuple):
    """Results of a map, one row per cell."""

    numbers: Any
    words: Any
    sequences: Any  # packed


class Outcome(NamedTuple):
    """What a motion told beside its tables."""

    status: int
    events: int  # that were written, and so on
    segments: int
    doubt: float  # the first time at which doubles did not suffice, nan where they did
    doubt_until: float
    events_full: bool
    panels_used: bool  # as many as a motion may have


def first_rows(table: np.ndarray, count: int) -> np.ndarray:
    """A copy of the first rows of a table, as bytes: NumPy copies records number by number, which takes three times as long."""
    return np.ndarray(count, table.dtype, bytearray(table[:count].tobytes()))
