"""Where an engine goes as its time step goes to 0: the limit of a quantity, and the order in which it gets there."""

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
        What the quantity goes to, in its own unit [1].
    order : float or None
        None where the quantity jumps about, or does not change any more [1].
    scatter : float
        How far the values lie from the fit, or from each other where there is none, in their own unit [1].
    """

    limit: float
    order: float | None
    scatter: float


def limit_of(steps: ArrayLike, values: ArrayLike) -> Limit | None:
    """Fit the limit of a quantity over the time step.

    The order is the one from 0.25 to 4 that fits the finest five values best. It is only stated where it is from 0.4 to 3,
    where the values go one way only, where the fit leaves less than a twentieth of what they change, and where they change
    by more than a millionth of themselves.

    Parameters
    ----------
    steps : array_like
        Time steps [s].
    values : array_like
        The quantity at each, in its own unit; what is not finite is left out [1].

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
