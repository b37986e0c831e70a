"""The robust loss: outliers count less than by their square."""

from __future__ import annotations

import numpy as np

from hophoop.fitting.channels import Floats

SOFT = 3.0  # scale of the robust loss [standard deviations]


def loss(residuals: Floats, robust: bool) -> float:
    """Return the sum of squares, or the robust loss: SciPy's soft_l1 with the scale `SOFT`, twice.

    residuals [standard deviations].
    """
    squares = residuals**2
    if robust:
        squares = 2.0 * squares / (np.sqrt(1.0 + squares / SOFT**2) + 1.0)
    return float(squares.sum())


def influence(residuals: Floats) -> Floats:
    """Return the slope of half the robust loss.

    residuals [standard deviations]; pull: for small residuals the residual itself [1].
    """
    return np.asarray(residuals / np.sqrt(1.0 + (residuals / SOFT) ** 2), dtype=float)
