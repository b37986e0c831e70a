"""Ends of a kind of gaits on a branch, such as a border collision, found again for other values of a second parameter."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.gaits.continuation import JOINED, ROUNDS, Point, advance
from hophoop.gaits.equation import GaitEquation, Pair
from hophoop.gaits.special import Special

DISTANCES = tuple(10.0**power for power in range(-7, -1))  # along the branch, at which gaits next to the border are looked for
BEYOND = 4.0  # of these distances, from the gait found to where the border is passed for sure
SHIFT = 1e-6  # of a coordinate or the parameter, where the map has no derivative at the border
NEAR = 1e-3  # largest margin at the border of the boundary that is met there

Kind = tuple[tuple[tuple[str, ...], float], bool, tuple[bool, ...] | None]


class Border(NamedTuple):
    """Where gaits of one kind end.

    Attributes
    ----------
    place : ndarray
        The last one of the kind.
    kind : tuple
        What they have in common: word and revolutions, whether their period is prime and, where this is what changes, which
        landings stop the slip.
    way : ndarray
        Unit vector along the branch, towards the border.
    boundaries : frozenset of str
        Those that are met, as in `GaitMargin`.
    """

    place: Pair
    kind: Kind
    way: Pair
    boundaries: frozenset[str]


def border_of(special: Special) -> Border | None:
    """Return the border at a special point, or None if none is found there.

    Parameters
    ----------
    special : Special

    Returns
    -------
    border : Border or None
    """
    equation, place = special.equation, special.place
    shifts = [np.zeros(len(place)), *(sign * unit for unit in SHIFT * np.eye(len(place)) for sign in (1.0, -1.0))]
    tangent = next((found.tangent for shift in shifts if (found := equation(place + shift)) is not None), None)
    if tangent is None:
        return None
    for landings in (False, True):
        for distance in DISTANCES:
            for way in (tangent, -tangent):
                border = _last(equation, place, way, distance, landings, None)
                if border is not None:
                    return border
    return None


def border_near(equation: GaitEquation, border: Border, guess: Pair) -> Border | None:
    """Return the border of the same kind near a place, or None if none is found there.

    Parameters
    ----------
    equation : GaitEquation
        With another value of the second parameter.
    border : Border
        Of a value before.
    guess : ndarray
        Near the place.

    Returns
    -------
    border : Border or None
    """
    for distance in DISTANCES:
        found = _last(equation, guess, border.way, distance, border.kind[2] is not None, border.kind)
        if found is not None and (found.boundaries & border.boundaries or not border.boundaries):
            return found
    return None


def _last(equation: GaitEquation, place: Pair, way: Pair, distance: float, landings: bool, kind: Kind | None) -> Border | None:
    """Return the border between a point at a distance before a place and one beyond it, to rounding."""
    before = place - distance * way
    solved = equation.solve(before, way, float(way @ before))
    if solved is None or (kind is not None and _kind_of(Point(*solved, equation), landings) != kind):
        return None
    here = Point(*solved, equation)
    kind = _kind_of(here, landings)
    tangent = here.values.tangent if here.values.tangent @ way > 0.0 else -here.values.tangent
    low, high, last = 0.0, BEYOND * distance, here
    beyond = advance(here, tangent, high)
    if beyond is not None and _kind_of(beyond, landings) == kind:
        return None
    for _ in range(ROUNDS):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        tried = advance(here, tangent, middle)
        if tried is not None and _kind_of(tried, landings) == kind:
            low, last = middle, tried
        else:
            high = middle
    names = frozenset(margin.boundary for margin in equation.gait(last.place).margins if margin.value < NEAR)
    return Border(last.place, kind, tangent, names)


def _kind_of(point: Point, landings: bool) -> Kind:
    stopped = (
        tuple(event.slip == 0.0 for event in point.equation.gait(point.place).motion().find("impact")) if landings else None
    )
    return point.values.key, point.values.apart > JOINED, stopped
