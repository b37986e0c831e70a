"""Tables of numbers: the content of `tables.json`, which `tests/kernel_tables.py` computes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

FILE = Path(__file__).with_name("tables.json")
_numbers: dict[str, Any] = json.loads(FILE.read_bytes())


def _table(name: str) -> np.ndarray:
    """Return a table of numbers."""
    return np.array(_numbers[name])


def _complex(name: str) -> np.ndarray:
    """Return complex numbers from their parts along the last dimension."""
    return _table(name).view(np.complex128)[..., 0]


# 16 Gauss–Legendre nodes on [−1, 1], their weights, and matrices that act on values at the nodes, `_T` transposed
NODES, WEIGHTS = _table("NODES"), _table("WEIGHTS")
ANTIDERIVATIVE_T = _table("ANTIDERIVATIVE_T")
SERIES = _table("SERIES")  # Chebyshev coefficients
LEFT_T, RIGHT_T = _table("LEFT_T"), _table("RIGHT_T")  # Chebyshev coefficients of either half

# Panels of the widths 0.9 rad · 2^(−k/2): sine and 1 − cosine of the angles to their nodes and to their ends
WIDTHS = _table("WIDTHS")
NODE_SINES, NODE_VERSINES = _table("NODE_SINES"), _table("NODE_VERSINES")
END_SINES, END_VERSINES = _table("END_SINES"), _table("END_VERSINES")

# Radau IIA with 5 stages; see compliant/radau.py
RADAU_NODES, RADAU_A = _table("RADAU_NODES"), _table("RADAU_A")
RADAU_GAMMA: float = _numbers["RADAU_GAMMA"]
RADAU_LAMBDA = _complex("RADAU_LAMBDA")
RADAU_TO_REAL, RADAU_FROM_REAL = _table("RADAU_TO_REAL"), _table("RADAU_FROM_REAL")
RADAU_TO_PAIR, RADAU_FROM_PAIR = _complex("RADAU_TO_PAIR"), _complex("RADAU_FROM_PAIR")
RADAU_DEFECT, RADAU_ERROR, RADAU_POWERS = _table("RADAU_DEFECT"), _table("RADAU_ERROR"), _table("RADAU_POWERS")

# Elementary functions. A value in several doubles starts with those that have few bits, whose products are exact.
PI_HIGH, PI_LOW = _numbers["PI"]
ANGLE_INVERSE: float = _numbers["ANGLE_INVERSE"]
ANGLE_1, ANGLE_2, ANGLE_3 = _numbers["ANGLE"]  # π/256
SINES = _table("SINES")  # of multiples of π/256
REVOLUTIONS = np.array(_numbers["REVOLUTIONS"], dtype=np.int64)  # 1/2π in 30-bit digits, after 2 zeros
OCTAVE_INVERSE: float = _numbers["OCTAVE_INVERSE"]
OCTAVE_1, OCTAVE_2 = _numbers["OCTAVE"]  # ln 2/64
POWERS = _table("POWERS")  # of 2, in steps of 1/64
LN2_HIGH, LN2_LOW = _numbers["LN2"]
LOG2_E_HIGH, LOG2_E_LOW = _numbers["LOG2_E"]
LOGARITHMS = _table("LOGARITHMS")  # for m near j/128 from √½ to √2: c near 1/m, and −log c
ARCTANGENTS = _table("ARCTANGENTS")  # of multiples of 1/64
TANH_SERIES = _table("TANH_SERIES")  # tanh x = x + x³ (c0 + c1 x² + …)
SINH_SERIES = _table("SINH_SERIES")
