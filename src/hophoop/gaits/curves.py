"""Folds and period doublings in a second parameter, and gaits of twice the period."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hophoop._support.errors import check_whole
from hophoop.gaits.continuation import JOINED
from hophoop.gaits.equation import GaitEquation, Pair, bounds_around, value_of
from hophoop.gaits.finding import LONGEST
from hophoop.gaits.special import DOUBLING, FOLD
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait
    from hophoop.gaits.special import Special

CRITICAL = {FOLD: 1.0, DOUBLING: -1.0}
AMPLITUDES = (1e-4, -1e-4, 1e-3, -1e-3, 1e-2, -1e-2)  # of a doubled gait about the shorter one
SHIFT = 1e-6  # of the scaled parameter from a corner, where the map has no derivative
MOST_POINTS = 10_000
SMALLEST = 1e-4  # share of a step in the second parameter
NEARBY = 0.1  # in the same units: within it a doubled gait is looked for


def follow_special(special: Special, path: str, bounds: tuple[float, float], points: int) -> NDArray[np.float64]:
    """Follow a fold or a period doubling in a second parameter; `Special.follow` calls this and describes it."""
    if special.kind not in CRITICAL:
        raise InputError.of_field("kind", special.kind, f"one of {', '.join(CRITICAL)}, to be followed in a second parameter")
    check_whole("points", points, 2, MOST_POINTS)
    one = special.equation
    if path == one.path:
        raise InputError.of_field("path", path, "a parameter other than that of the branch")
    value = value_of(special.gait.scenario, path)
    low, high = bounds_around(path, value, bounds)
    rows = [(value, special.parameter, special.omega)]
    for end in (low, high):
        count = max(2, round(points * abs(end - value) / (high - low)) + 1)
        part = _half(special, path, np.linspace(value, end, count)[1:])
        rows = [*reversed(part), *rows] if end == low else [*rows, *part]
    return np.array(rows)


def _half(special: Special, path: str, values: NDArray[np.float64]) -> list[tuple[float, float, float]]:
    """Return the rows of one direction, as far as the point is found."""
    one, critical = special.equation, CRITICAL[special.kind]
    found: list[tuple[float, float, float]] = []
    known = [(value_of(special.gait.scenario, path), special.place)]
    for value in values.tolist():
        while known[-1][0] != value:
            target, share = value, 1.0
            solution = None
            while solution is None and share > SMALLEST:
                target = value if share == 1.0 else known[-1][0] + share * (value - known[-1][0])
                solution = one.of(path, target).solve_with(_extrapolated(known, target), critical)
                share *= 0.5
            if solution is None:
                return found
            known.append((target, solution[0]))
        found.append((value, one.parameter(known[-1][1]), one.omega(known[-1][1])))
    return found


def _extrapolated(known: list[tuple[float, Pair]], value: float) -> Pair:
    """Return the place of a line through the last two known ones."""
    if len(known) < 2:
        return known[-1][1]
    (first, one), (last, other) = known[-2:]
    extrapolated: Pair = other + (value - last) / (last - first) * (other - one)
    return extrapolated


def doubled(special: Special) -> Gait:
    """Return a gait of twice the period next to a special point; `Special.switch` calls and describes this."""
    one = special.equation
    period = 2 * one.period
    if period > LONGEST:
        raise InputError.of_field("period", period, f"at most {LONGEST}")
    twice = GaitEquation(one.scenario, period, one.path, one.scale, one.section, one.mode)
    shifts = [np.zeros(len(special.place)), *(sign * SHIFT * np.eye(len(special.place))[-1] for sign in (1.0, -1.0))]
    for values in (found for shift in shifts if (found := one(special.place + shift)) is not None):
        direction = np.append(_flipping(values.matrix), 0.0)
        for amplitude in AMPLITUDES:
            place = special.place + amplitude * direction
            solution = twice.solve(place, direction, float(direction @ place))
            if solution is not None and solution[1].apart > JOINED and np.abs(solution[0] - special.place).max() < NEARBY:
                return twice.gait(solution[0])
    raise InputError(f"No gait of period {period} was found near {one.path} = {special.parameter:.9g}.")


def _flipping(matrix: Pair) -> Pair:
    """Return the unit vector of the coordinates that changes its sign in a period: that of the least real eigenvalue."""
    values, vectors = np.linalg.eig(matrix)
    found: Pair = vectors[:, np.argmin(values.real)].real
    return found / np.linalg.norm(found)
