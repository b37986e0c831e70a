"""How much data scatter, told from themselves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

NORMAL = 1.4826  # standard deviation of normal numbers over the median of their distances from the middle


def spread(values: Floats) -> float:
    """Standard deviation of numbers, of which strangers make little.

    Parameters
    ----------
    values : ndarray, shape (n,)
        [1]

    Returns
    -------
    sigma : float
        In the values' own unit [1].
    """
    return NORMAL * float(np.median(np.abs(values - np.median(values))))


def third_differences(t: Floats, values: Floats) -> Floats:
    """What four values in a row differ from a parabola, in standard deviations of one of them.

    A smooth motion adds little to them, so that their spread is that of a single value.

    Parameters
    ----------
    t, values : ndarray, shape (n,)
        Times that increase [s] and what was measured then, nan where nothing was [1].

    Returns
    -------
    differences : ndarray, shape (m,)
        Of all fours without nan, in the values' own unit [1].
    """
    if len(t) < 4:
        return np.zeros(0)
    at = np.lib.stride_tricks.sliding_window_view(t, 4)
    fours = np.lib.stride_tricks.sliding_window_view(values, 4)
    apart = at[:, :, None] - at[:, None, :]
    apart[:, range(4), range(4)] = 1.0
    weights = 1.0 / apart.prod(axis=2)
    found: Floats = (weights * fours).sum(axis=1) / np.sqrt((weights**2).sum(axis=1))
    return found[np.isfinite(found)]
