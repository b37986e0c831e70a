"""Scatter of data, estimated from the data; kinds of arrays."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Flags = NDArray[np.bool_]

NOWHERE = complex(np.nan, np.nan)
NORMAL = 1.4826  # standard deviation of a normal distribution over its median absolute deviation


def spread(values: Floats) -> float:
    """Robust standard deviation of numbers.

    values shape (n,) [1]; sigma: in the unit of the values [1].
    """
    return NORMAL * float(np.median(np.abs(values - np.median(values))))


def third_differences(t: Floats, values: Floats) -> Floats:
    """Deviations of four values in a row from a parabola, scaled to the standard deviation of one value.

    A smooth motion adds little to them, so their spread is that of a single value.

    t, values: shape (n,), increasing times [s] and measured values, nan where missing [1]; differences: shape (m,), of all
    groups of four without nan, in the unit of the values [1].
    """
    if len(t) < 4:
        return np.zeros(0)
    at, fours = np.lib.stride_tricks.sliding_window_view((t, values), 4, axis=1)
    weights = 1.0 / (at[:, :, None] - at[:, None, :] + np.eye(4)).prod(axis=2)
    found: Floats = (weights * fours).sum(axis=1) / np.linalg.norm(weights, axis=1)
    return found[np.isfinite(found)]
