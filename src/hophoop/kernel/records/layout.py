"""Layout of the kernels' results, one record per event and per segment; results of motions and maps; scratch arrays."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from typing import Any, NamedTuple, cast

import numpy as np

from hophoop.kernel.numerics.collocation import DEPTH, ORDER
from hophoop.kernel.panels.panel import ROWS
from hophoop.kernel.physics.body import MODE_LETTERS

_STATE = ["x", "height", "angle", "vx", "vy", "omega"]
# Low-order halves of the double-double time and position, and the angle as whole revolutions and θ within one.
_POSITION = ["t_low", "x_low", "revolutions", "theta", "theta_low"]
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
    + [(name, "f8") for name in _POSITION]
    + [("rolling_resistance", "f8")]
)
# All numbers needed to compute the motion inside the segment again, bit for bit; those of a panel are explained in
# panels.panel.Panel; `f_n` is that at the start of a flight.
SEGMENT = np.dtype(
    [("t", "f8"), ("t_end", "f8"), ("mode", "i8"), ("kind", "i8"), ("sigma", "i8"), ("level", "i8")]
    + [("direction", "f8"), ("ref", "f8"), ("sine", "f8"), ("cosine", "f8"), ("extent", "f8")]
    + [("torque", "f8"), ("curvature", "f8"), ("arm", "f8"), ("kappa_p_sigma", "f8"), ("u", "f8"), ("xi", "f8"), ("f_n", "f8")]
    + [("x", "f8"), ("height", "f8"), ("angle", "f8"), ("vy", "f8"), ("omega", "f8"), ("slip", "f8")]
    + [(name, "f8") for name in _ENERGY]
    + [("ref_low", "f8")]
    + [(name, "f8") for name in _POSITION]
    + [("rolling_resistance", "f8")]
)

# Columns of a sample, in kernel units.
COLUMNS = (
    "mode", "x", "height", "angle", "vx", "vy", "omega", "slip",
    "friction_force", "normal_force", "friction", "impact_normal", "impact_tangential", "theta", "theta_low",
    "rolling_resistance", "kinetic", "potential",
)  # fmt: skip

# A sequence of phases is packed into integers, three bits per letter (0: no letter).
LETTERS_PER_INTEGER = 21
MORE = 7  # the letter that marks a longer sequence, written as a plus sign


# Maximum of panels solved for one motion, including rejected ones: a few seconds, and 70 MB if all are kept.
MOST_PANELS = 500_000


# Indices into the counts of a motion; a count of −1 means that its table was too short.
EVENTS, SEGMENTS, PANELS, PANEL_LIMIT = range(4)


class Tables(NamedTuple):
    """One motion: its cell, and the tables that it fills."""

    cell: Any  # shape (len(CELL), 1)
    events: Any
    segments: Any


STOP_AT_TURN, STOP_AT_TAKEOFF = 1, 2


class Until(NamedTuple):
    """What ends a motion before its duration; one of these is given."""

    stop: int  # sum of STOP_AT_TURN, STOP_AT_TAKEOFF
    landings: int  # 0: no limit
    revolutions: float  # to either side of the start (nan: no limit)
    angle: float  # the next time that θ is this angle in any revolution [rad] (nan: no limit)


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
    """Result of a motion, apart from its tables."""

    status: int
    events: int  # number of events written; `segments` likewise
    segments: int
    doubt: float  # first time at which double precision did not suffice, nan if it always did
    events_full: bool


def unpacked_sequence(key: Iterable[int]) -> str:
    """Return the sequence packed into integers by `writing.add_letter`."""
    letters = []
    for integer in key:
        packed = int(integer)
        while packed:
            letter = packed & 7
            letters.append("+" if letter == MORE else MODE_LETTERS[letter - 1])
            packed >>= 3
    return "".join(letters)


def new_table(length: int, dtype: np.dtype[Any]) -> np.ndarray:
    """Return a table whose memory is a bytearray, for `first_rows`."""
    return np.ndarray(length, dtype, bytearray(length * dtype.itemsize))


def first_rows(table: np.ndarray, count: int) -> np.ndarray:
    """Return a copy of the first rows of a `new_table`, as bytes: NumPy copies records field by field, much more slowly."""
    dtype = table.dtype
    return np.ndarray(count, dtype, cast(bytearray, table.base)[: count * dtype.itemsize])


# --- scratch arrays

STACK_ROWS, STACK_COLUMNS = DEPTH + 3, ORDER + 2  # size of the stack of `first_downcrossing`


class Scratch(NamedTuple):
    """Scratch arrays of a kernel; one set per thread."""

    work: np.ndarray
    values: np.ndarray
    series: np.ndarray
    weights: np.ndarray
    stack: np.ndarray
    doubt: np.ndarray  # time of the first doubt of a motion, nan if there is none
    counts: np.ndarray  # numbers of events, segments and panels, and the limit of panels; see records.layout


def new_scratch():
    """Return a new set of scratch arrays."""
    return Scratch(
        np.zeros((ROWS, ORDER)),
        np.zeros((2, ORDER)),
        np.zeros(ORDER),
        np.zeros(ORDER),
        np.zeros((STACK_ROWS, STACK_COLUMNS)),
        np.full(1, np.nan),
        np.array([0, 0, 0, MOST_PANELS]),
    )


_own = threading.local()


def thread_scratch() -> Scratch:
    """Return the scratch arrays of this thread; allocating them takes 10 % of a short motion."""
    if not hasattr(_own, "scratch"):
        _own.scratch = new_scratch()
    scratch: Scratch = _own.scratch
    return scratch
