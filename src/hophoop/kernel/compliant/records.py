"""The state of a compliant motion, and the record of every accepted step."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.kernel.compliant.tableau import PAIRS, STAGES
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.roots import DEPTH

# Variables of the state array, in kernel units; `bristle` is z; `friction`, `damping`, `rolling_resistance`: energy lost so
# far.
VARIABLES = ("height", "angle", "slip", "vy", "omega", "bristle", "x", "friction", "damping", "rolling_resistance")
Y, TH, VT, VN, OM, Z, X, FRICTION, DAMPING, RESISTED = range(10)
DYNAMIC = 6  # the first 6; the others are integrals along the motion, on which nothing depends
SIZE = len(VARIABLES)
MEASURED = 9  # number of variables in the mean error of a step

# Kinds of segments.
STEP, FLY, HOLD = 0.0, 1.0, 2.0
# Columns of a segment. A STEP is the polynomial Σ_j p_j s^j, s = (t − its start)/step. FLY and HOLD only keep p_0, and FLY has
# f_n at its start in `step`. The angle is θ within one revolution; `turns` counts whole ones.
T, T_END, KIND, MODE, REGIME, TURNS, LENGTH, FIRST = range(8)  # FIRST: where the polynomials start
WIDTH = FIRST + SIZE * (STAGES + 1)
SEGMENT = np.dtype(
    [(name, "f8") for name in ("t", "t_end", "kind", "mode", "regime", "turns", "step")]
    + [(f"{name}_{power}", "f8") for name in VARIABLES for power in range(STAGES + 1)]
)


class Work(NamedTuple):
    """Scratch arrays of a step."""

    state: np.ndarray
    stages: np.ndarray  # Z_i, increments of the dynamic variables
    integrals: np.ndarray  # increments of the integrals
    rates: np.ndarray  # f at the stages
    powers: np.ndarray  # integrands at the stages
    start_rate: np.ndarray
    trial: np.ndarray
    jacobian: np.ndarray
    real: np.ndarray
    pairs: np.ndarray
    real_pivots: np.ndarray
    pair_pivots: np.ndarray
    real_side: np.ndarray
    pair_side: np.ndarray
    real_form: np.ndarray
    pair_form: np.ndarray
    error: np.ndarray
    scale: np.ndarray
    atol: np.ndarray
    poly: np.ndarray  # Σ_j poly[:, j] s^j
    start: np.ndarray
    values: np.ndarray  # for flight
    series: np.ndarray
    stack: np.ndarray


def new_work():
    """Return a new set of scratch arrays."""
    return Work(
        np.zeros(SIZE),
        np.zeros((STAGES, DYNAMIC)),
        np.zeros((STAGES, SIZE - DYNAMIC)),
        np.zeros((STAGES, DYNAMIC)),
        np.zeros((STAGES, SIZE - DYNAMIC)),
        np.zeros(SIZE),
        np.zeros(DYNAMIC),
        np.zeros((DYNAMIC, DYNAMIC)),
        np.zeros((DYNAMIC, DYNAMIC)),
        np.zeros((PAIRS, DYNAMIC, DYNAMIC), np.complex128),
        np.zeros(DYNAMIC, np.int64),
        np.zeros((PAIRS, DYNAMIC), np.int64),
        np.zeros(DYNAMIC),
        np.zeros(DYNAMIC, np.complex128),
        np.zeros(DYNAMIC),
        np.zeros((PAIRS, DYNAMIC), np.complex128),
        np.zeros(SIZE),
        np.zeros(SIZE),
        np.zeros(SIZE),
        np.zeros((SIZE, STAGES + 1)),
        np.zeros(SIZE),
        np.zeros((2, ORDER)),
        np.zeros(ORDER),
        np.zeros((DEPTH + 3, ORDER + 2)),
    )


def grow_rows(rows, count):
    """Return `rows`, or a copy twice as long if `count` rows fill it."""
    if count < rows.shape[0]:
        return rows
    larger = np.empty((2 * rows.shape[0], rows.shape[1]))
    for i in range(count):  # a loop compiles 10 times faster than a slice
        for j in range(rows.shape[1]):
            larger[i, j] = rows[i, j]
    return larger
