"""Limit of a quantity as the time step goes to 0, and the order of convergence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

ORDERS = np.arange(0.25, 4.01, 0.05)
LEAST = 4


@dataclass(frozen=True)
class Limit:
    """The fit q(dt) = limit + c dt^order.

    Attributes
    ----------
    limit : float
        Limit of the quantity, in its unit [1].
    order : float or None
        Order of convergence; None if the quantity scatters, or does not change [1].
    scatter : float
        Deviation of the values from the fit, or their range without a fit, in their unit [1].
    """

    limit: float
    order: float | None
    scatter: float


def limit_of(steps: ArrayLike, values: ArrayLike) -> Limit | None:
    """Fit the limit of a quantity over the time step.

    The order, from 0.25 to 4, is that of the best fit to the values of the five smallest steps. It is reported only if it is
    from 0.4 to 3, the values are monotonic, the fit leaves less than 5 % of their change, and their relative change is above
    1e-6.

    Parameters
    ----------
    steps : array_like
        Time steps [s].
    values : array_like
        The quantity at each, in its unit; values that are not finite are dropped [1].

    Returns
    -------
    limit : Limit or None
        None for fewer than four values.
    """
    dt, q = np.asarray(steps, dtype=float), np.asarray(values, dtype=float)
    good = np.isfinite(q)
    dt, q = dt[good], q[good]
    if len(dt) < LEAST:
        return None
    finest = np.argsort(dt)[:5]
    dt, q = dt[finest], q[finest]
    spread = float(np.ptp(q))
    if spread <= 1e-6 * max(abs(float(q[0])), 1e-12):
        return Limit(float(q[0]), None, spread)
    best: tuple[float, float, float] | None = None
    for order in ORDERS:
        columns = np.stack([np.ones_like(dt), (dt / dt[-1]) ** order], axis=1)
        solution, *_ = np.linalg.lstsq(columns, q, rcond=None)
        off = float(np.sqrt(np.mean((columns @ solution - q) ** 2)))
        if best is None or off < best[0]:
            best = off, float(order), float(solution[0])
    assert best is not None
    off, order, limit = best
    one_way = bool((np.diff(q) > 0.0).all() or (np.diff(q) < 0.0).all())
    if off > 0.05 * spread or not 0.4 <= order <= 3.0 or not one_way:
        return Limit(float(q[0]), None, float(np.std(q[:3])))
    return Limit(limit, order, off)
