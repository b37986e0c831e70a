"""Radau IIA with five stages, order 9: its constants, computed at import (Hairer & Wanner, IV.8)."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import Polynomial

STAGES = 5
PAIRS = (STAGES - 1) // 2


def _nodes() -> np.ndarray:
    # zeros of the (s−1)th derivative of x^(s−1) (x−1)^s, polished by Newton's method
    polynomial = (Polynomial([0, 1]) ** (STAGES - 1) * Polynomial([-1, 1]) ** STAGES).deriv(STAGES - 1)
    slope = polynomial.deriv()
    roots = np.sort(polynomial.roots().real)
    for _ in range(4):
        roots = roots - polynomial(roots) / slope(roots)
    roots[-1] = 1.0
    return roots


def _collocation(c: np.ndarray) -> np.ndarray:
    powers = np.arange(STAGES)
    return np.linalg.solve(
        (c[:, None] ** powers).T, (c[:, None] ** (powers + 1) / (powers + 1)).T
    ).T  # Σ_j a_ij c_j^q = c_i^(q+1)/(q+1)


NODES = _nodes()
A = _collocation(NODES)
A_INVERSE = np.linalg.inv(A)
_values, _vectors = np.linalg.eig(A_INVERSE)
_real = int(np.argmin(np.abs(_values.imag)))
_upper = [i for i in np.argsort(_values.real) if _values[i].imag > 1e-6]
# A⁻¹ has one real eigenvalue and two pairs; one of each pair is enough, the other is its conjugate.
GAMMA = float(_values[_real].real)
LAMBDA = np.ascontiguousarray(_values[_upper])
_inverse = np.linalg.inv(_vectors)
TO_REAL = np.ascontiguousarray((_inverse[_real] * _vectors[-1, _real]).real)
FROM_REAL = np.ascontiguousarray((_vectors[:, _real] / _vectors[-1, _real]).real)
TO_PAIR = np.ascontiguousarray(_inverse[_upper])
FROM_PAIR = np.ascontiguousarray(2.0 * _vectors[:, _upper])  # the conjugate's share is in the factor 2

# The solution of order 5 that also uses f at the start with weight 1/γ; its difference from the method,
# h f(y0)/γ + Σ DEFECT_i h f_i = h f(y0)/γ + Σ ERROR_i Z_i, estimates the error.
_moments = np.zeros(STAGES)
_moments[0] = -1.0 / GAMMA
DEFECT = np.linalg.solve((NODES[:, None] ** np.arange(STAGES)).T, _moments)
ERROR = np.ascontiguousarray(DEFECT @ A_INVERSE)

# Coefficients of s, s², …, s⁵ of the polynomial through (0, 0) and (c_i, Z_i).
POWERS = np.ascontiguousarray(np.linalg.inv(NODES[:, None] ** np.arange(1, STAGES + 1)))
