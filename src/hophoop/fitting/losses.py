"""The soft loss: outliers count less than by their square."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

SOFT = 3.0  # standard deviations from which a residual counts less than its square


def soften(residuals: Floats, soft: bool) -> Floats:
    """Residuals whose square is the soft loss: as they are when small, growing as a root when large.

    Parameters
    ----------
    residuals : ndarray
        [standard deviations]
    soft : bool
        False leaves them as they are.

    Returns
    -------
    residuals : ndarray
        [1]
    """
    if not soft:
        return residuals
    root = np.sqrt(1.0 + (residuals / SOFT) ** 2)
    size: Floats = residuals * np.sqrt(2.0 / (root + 1.0))
    return size


def soften_slope(residuals: Floats) -> Floats:
    """Derivative of softened residuals by those that they come from.

    Parameters
    ----------
    residuals : ndarray
        [standard deviations]

    Returns
    -------
    slope : ndarray
        1 at 0, and less elsewhere [1].
    """
    root = np.sqrt(1.0 + (residuals / SOFT) ** 2)
    slope: Floats = np.sqrt(0.5 * (root + 1.0)) / root
    return slope


def influence(residuals: Floats) -> Floats:
    """Slope of half the soft loss: how much a residual pulls.

    Parameters
    ----------
    residuals : ndarray
        [standard deviations]

    Returns
    -------
    pull : ndarray
        The residual itself where it is small [1].
    """
    return np.asarray(residuals / np.sqrt(1.0 + (residuals / SOFT) ** 2), dtype=float)


def influence_slope(residuals: Floats) -> Floats:
    """Derivative of `influence`.

    Parameters
    ----------
    residuals : ndarray
        [standard deviations]

    Returns
    -------
    slope : ndarray
        1 at 0 [1].
    """
    return np.asarray((1.0 + (residuals / SOFT) ** 2) ** -1.5, dtype=float)
