"""Derivatives of functions that are known next to a point only within a piece: of polynomials fitted to their values."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from itertools import product, takewhile
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Kept = TypeVar("Kept")
Values = Callable[[float], "Floats | None"]  # of a function at a distance from a point where it is 0; None on another piece


class Fit(NamedTuple):
    """How a polynomial is fitted: distances that are tried, number of values, degree."""

    steps: tuple[float, ...]
    values: int
    degree: int


CENTRAL = Fit(tuple(2.0 ** -(12 + 3 * k) for k in range(5)), 5, 3)
SIDED = Fit(tuple(2.0 ** -(10 + 3 * k) for k in range(5)), 8, 6)
EXACT_CENTRAL = Fit(tuple(2.0 ** -(6 + k) for k in range(20)), 32, 10)
EXACT_SIDED = SIDED._replace(values=16)
OBLIQUE = (4.0, -4.0, 64.0, -64.0)  # of another direction, in which a piece is wide where it is narrow in one
KNOWN, ENOUGH = 1e-3, 1e-8  # estimated errors: the largest, and one that is small enough


def derivative_matrix(
    shifted: Callable[[Floats], Values], count: int, size: int, *, exact: bool = False, sided: bool = True
) -> Floats:
    """Return the derivative at a point, one column for each coordinate; `shifted` returns the function along a direction.

    exact, sided: as in `difference`.
    """
    units = np.eye(count)
    columns = [difference(shifted(unit), size, exact=exact, sided=sided) for unit in units]
    known = [k for k, column in enumerate(columns) if np.isfinite(column).all()]
    for k, i, share in product(range(count), known, OBLIQUE if sided else ()):
        if not np.isfinite(columns[k]).all():
            oblique = difference(shifted(units[k] + share * units[i]), size, exact=exact)
            columns[k] = oblique - share * columns[i]
    return np.column_stack(columns)


def difference(at: Values, size: int, *, exact: bool = False, sided: bool = True) -> Floats:
    """Return the derivative at 0 of a function that is 0 there; nan without one.

    It is central where the function exists on both sides, else one-sided, unless `sided` is False.
    """
    best, error = np.full(size, math.nan), KNOWN
    for way in (0.0, 1.0, -1.0) if sided else (0.0,):
        before = math.inf
        fit = (EXACT_SIDED if way else EXACT_CENTRAL) if exact else SIDED if way else CENTRAL
        for step in fit.steps:
            found, now = _fitted(at, step, way, fit)
            if now < error:
                best, error = found, now
            if before < now < math.inf or (error < ENOUGH and not exact):  # a narrower fit is one to rounding
                break
            before = now
        if error < ENOUGH:
            break
    return best


def last_kept(first: Kept, inside: float, outside: float, keeps: Callable[[float], Kept | None], nearest: float = 0.0) -> Kept:
    """Return the last one from `first`, at one number, on the way to another that is kept, by bisection."""
    last = first
    while (middle := 0.5 * (inside + outside)) not in (inside, outside) and abs(outside - inside) > nearest:
        tried = keeps(middle)
        if tried is None:
            outside = middle
        else:
            inside, last = middle, tried
    return last


def _fitted(at: Values, step: float, way: float, fit: Fit) -> tuple[Floats, float]:
    """Return the derivative at 0 of a polynomial through values to both sides or one way, and its estimated error."""
    nodes, powers, inverse = _basis(fit, bool(way))
    width = (way or 1.0) * step
    known = list(takewhile(lambda value: value is not None, (at(width * node) for node in nodes)))
    if len(known) < fit.values:
        return np.empty(0), math.inf
    values = np.array(known)
    found = inverse @ values
    slope: Floats = found[1] / width
    off = fit.degree * np.abs(powers @ found - values).max(axis=0) / step
    return slope, float((off / (1.0 + np.abs(slope))).max())


@lru_cache
def _basis(fit: Fit, sided: bool) -> tuple[list[float], Floats, Floats]:
    """Return where a function is taken, the powers there, and their pseudoinverse.

    The powers are those of the distance, or to one side of its root, with which a hop or a phase opens.
    """
    nodes = np.cos(np.pi * (np.arange(fit.values) + 0.5) / fit.values)
    nodes = nodes[np.argsort(-np.abs(nodes), kind="stable")]  # the farthest first: they are beyond the piece, if any are
    exponents = np.arange(fit.degree + 1.0)
    if sided:
        nodes, exponents = 0.5 * (1.0 + nodes), np.concatenate([[0.0], 0.5 * exponents[2:]])
    powers = nodes[:, None] ** exponents
    return nodes.tolist(), powers, np.linalg.pinv(powers)
