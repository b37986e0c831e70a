"""Special points of branches in a second parameter, and gaits of twice the period."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.equation import GaitEquation, Pair, bounds_around, value_of
from hophoop.gaits.finding import LONGEST, find
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait
    from hophoop.gaits.special import Special

CRITICAL = {"fold": 1.0, "period doubling": -1.0}
DISTANCES = (1e-4, -1e-4, 1e-3, -1e-3)  # of the scaled parameter from a point at which a doubled gait is born
MOST_POINTS = 10_000
SMALLEST = 1e-4  # share of a step in the second parameter
NEARBY = 0.1  # of θ̇ within which a doubled gait is looked for


def follow_special(special: Special, path: str, bounds: tuple[float, float], points: int) -> NDArray[np.float64]:
    """Follow a fold or a period doubling in a second parameter; `Special.follow` calls this and describes it."""
    if special.kind not in CRITICAL:
        raise InputError.of_field("kind", special.kind, f"one of {', '.join(CRITICAL)} for a point to be followed")
    if isinstance(points, bool) or not isinstance(points, int) or not 2 <= points <= MOST_POINTS:
        raise InputError.of_field("points", points, f"an integer from 2 to {MOST_POINTS}")
    one = special.equation
    if path == one.path:
        raise InputError.of_field("path", path, "a parameter other than that of the branch")
    value = value_of(special.gait, path)
    low, high = bounds_around(path, value, bounds)
    place = np.array([special.omega / one.unit, special.parameter / one.scale])
    rows = [(value, special.parameter, special.omega)]
    for end in (low, high):
        count = max(2, round(points * abs(end - value) / (high - low)) + 1)
        part = _half(special, path, place, np.linspace(value, end, count)[1:])
        rows = [*reversed(part), *rows] if end == low else [*rows, *part]
    return np.array(rows)


def _half(special: Special, path: str, place: Pair, values: NDArray[np.float64]) -> list[tuple[float, float, float]]:
    """Return the rows of one direction, as far as the point is found."""
    one, critical = special.equation, CRITICAL[special.kind]
    found: list[tuple[float, float, float]] = []
    known = [(value_of(special.gait, path), place)]
    for value in values.tolist():
        while known[-1][0] != value:
            target, share = value, 1.0
            solution = None
            while solution is None and share > SMALLEST:
                target = value if share == 1.0 else known[-1][0] + share * (value - known[-1][0])
                equation = GaitEquation(one.scenario.replace(path, target), one.period, one.path, one.scale)
                solution = equation.solve_with(_extrapolated(known, target), critical)
                share *= 0.5
            if solution is None:
                return found
            known.append((target, solution[0]))
        found.append((value, float(known[-1][1][1]) * one.scale, float(known[-1][1][0]) * one.unit))
    return found


def _extrapolated(known: list[tuple[float, Pair]], value: float) -> Pair:
    """Return the place of a line through the last two known ones."""
    if len(known) < 2:
        return known[-1][1]
    (first, one), (last, other) = known[-2:]
    extrapolated: Pair = other + (value - last) / (last - first) * (other - one)
    return extrapolated


def doubled(special: Special) -> Gait:
    """Return a gait of twice the period next to a special point; `Special.switch` calls this.

    Parameters
    ----------
    special : Special

    Returns
    -------
    gait : Gait

    Raises
    ------
    ValueError
        If none is found near the point, or its period would be above 64.
    """
    one = special.equation
    period = 2 * one.period
    if period > LONGEST:
        raise InputError.of_field("period", period, f"at most {LONGEST}")
    for distance in DISTANCES:
        try:
            scenario = one.scenario.replace(one.path, special.parameter + distance * one.scale)
            found = find(scenario, period, near=special.omega)
        except InputError:
            continue
        nearest = min(found, key=lambda gait: float(np.min(np.abs(gait.passages.omega - special.omega))))
        if float(np.min(np.abs(nearest.passages.omega / special.omega - 1.0))) < NEARBY:
            return nearest
    raise InputError(f"No gait of period {period} was found near {one.path} = {special.parameter:.9g}.")
