"""Sums of products of NumPy arrays in a fixed order, whose bits do not depend on a BLAS."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def weighted_sum(weights: Sequence[Any] | Floats, values: Sequence[Any] | Floats) -> Any:
    """Return Σ weights[k] · values[k], from left to right; the entries may be arrays that broadcast."""
    total = weights[0] * values[0]
    for weight, value in zip(weights[1:], values[1:], strict=True):
        total = total + weight * value
    return total


def matrix_product(one: Floats, other: Floats) -> Floats:
    """Return the product of two matrices, each entry summed from left to right."""
    result: Floats = np.zeros((one.shape[0], other.shape[1]))
    for k in range(one.shape[1]):
        result = result + one[:, k, None] * other[None, k, :]
    return result
