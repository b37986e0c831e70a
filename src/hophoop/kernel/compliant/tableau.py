"""Radau IIA with 5 stages, order 9: its constants (Hairer & Wanner, IV.8)."""

from __future__ import annotations

import numpy as np

from hophoop.kernel.numerics.tables import RADAU_A as A
from hophoop.kernel.numerics.tables import RADAU_A_INVERSE as A_INVERSE
from hophoop.kernel.numerics.tables import RADAU_DEFECT as DEFECT
from hophoop.kernel.numerics.tables import RADAU_ERROR as ERROR
from hophoop.kernel.numerics.tables import RADAU_FROM_PAIR, RADAU_LAMBDA, RADAU_TO_PAIR
from hophoop.kernel.numerics.tables import RADAU_FROM_REAL as FROM_REAL
from hophoop.kernel.numerics.tables import RADAU_GAMMA as GAMMA
from hophoop.kernel.numerics.tables import RADAU_NODES as NODES
from hophoop.kernel.numerics.tables import RADAU_POWERS as POWERS
from hophoop.kernel.numerics.tables import RADAU_TO_REAL as TO_REAL

STAGES = len(NODES)
PAIRS = len(RADAU_LAMBDA)


def _complex(parts: np.ndarray) -> np.ndarray:
    """Return complex numbers from their parts along the last dimension."""
    return np.ascontiguousarray(parts).view(np.complex128)[..., 0]


# A⁻¹ has one real eigenvalue, GAMMA, and two conjugate pairs, of which one member each is stored.
LAMBDA = _complex(RADAU_LAMBDA)
TO_PAIR = _complex(RADAU_TO_PAIR)
FROM_PAIR = _complex(RADAU_FROM_PAIR)  # twice the eigenvectors, to include the conjugates

# DEFECT and ERROR: the solution of order 5 that also uses f at the start with weight 1/γ; its difference from the method,
# h f(y0)/γ + Σ DEFECT_i h f_i = h f(y0)/γ + Σ ERROR_i Z_i, estimates the error.
# POWERS: coefficients of s, s², …, s⁵ of the polynomial through (0, 0) and (c_i, Z_i).

__all__ = [
    "A_INVERSE",
    "DEFECT",
    "ERROR",
    "FROM_PAIR",
    "FROM_REAL",
    "GAMMA",
    "LAMBDA",
    "NODES",
    "PAIRS",
    "POWERS",
    "STAGES",
    "TO_PAIR",
    "TO_REAL",
    "A",
]
