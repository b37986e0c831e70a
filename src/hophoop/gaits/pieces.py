"""Pieces of the one-dimensional return map: where its word changes, and where it meets the diagonal."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

from hophoop.gaits.orbits import BottomMap, Image

Progress = Callable[[float], object]
ROUNDS = 80  # of bisection: more than doubles need


class Piece(NamedTuple):
    """A range of θ̇ over which the phases of the map are the same, in units of √(g/R).

    Attributes
    ----------
    low, high : float
        Its first and last double.
    at_low, at_high : float
        The map there.
    word : bytes
        As in `Image`.
    points : tuple of (float, float)
        The points inside that were computed, and the map there.
    """

    low: float
    high: float
    at_low: float
    at_high: float
    word: bytes
    points: tuple[tuple[float, float], ...]


def pieces(image: BottomMap, grid: list[float], depth: int = 1, progress: Progress | None = None) -> list[Piece]:
    """Return the pieces of a map that an increasing grid [√(g/R)] meets, with ends to rounding, and more between them.

    depth: how often what is between two pieces is halved in search of more; parts without a map are left out.
    """
    found: list[Piece] = []
    points: list[tuple[float, Image]] = []
    begin = _Known(grid[0], image(grid[0]))
    for k, omega in enumerate(grid):
        now = image(omega)
        if progress is not None:
            progress((k + 1) / len(grid))
        if points and now.word != points[-1][1].word:
            high, low = _edge(image, *points[-1], omega), _edge(image, omega, now, points[-1][0])
            found += _piece(begin, high, points)
            found += _between(image, high, low, depth)
            begin, points = low, []
        points.append((omega, now))
    found += _piece(begin, _Known(*points[-1]), points)
    return found


class _Known(NamedTuple):
    omega: float
    at: Image


def _piece(low: _Known, high: _Known, points: list[tuple[float, Image]]) -> list[Piece]:
    """Return a piece, or none where there is no map."""
    if math.isnan(low.at.omega):
        return []
    inside = tuple((omega, at.omega) for omega, at in points)
    return [Piece(low.omega, high.omega, low.at.omega, high.at.omega, low.at.word, inside)]


def _between(image: BottomMap, left: _Known, right: _Known, depth: int) -> list[Piece]:
    """Return the pieces between the ends of two others that a few halvings meet."""
    middle = 0.5 * (left.omega + right.omega)
    if depth == 0 or right.omega - left.omega <= 4.0 * math.ulp(middle):
        return []
    now = image(middle)
    if now.word in (left.at.word, right.at.word):  # a piece in two parts; one part is known
        return []
    low, high = _edge(image, middle, now, left.omega), _edge(image, middle, now, right.omega)
    inner = _piece(low, high, [(middle, now)])
    return _between(image, left, low, depth - 1) + inner + _between(image, high, right, depth - 1)


def _edge(image: BottomMap, inside: float, known: Image, outside: float) -> _Known:
    """Return the last double with the word of the inside, on the way to the outside, and the map there."""
    at_inside = known
    for _ in range(ROUNDS):
        middle = 0.5 * (inside + outside)
        if middle in (inside, outside):
            break
        tried = image(middle)
        if tried.word == known.word:
            inside, at_inside = middle, tried
        else:
            outside = middle
    return _Known(inside, at_inside)


def crossings(image: BottomMap, piece: Piece) -> Iterator[float]:
    """Yield the θ̇ of a piece that the map returns, to rounding [√(g/R)]."""
    points = [(piece.low, piece.at_low - piece.low)]
    points += [(omega, after - omega) for omega, after in piece.points if piece.low < omega < piece.high]
    points.append((piece.high, piece.at_high - piece.high))

    def excess(omega: float) -> float:
        return image(omega).omega - omega

    for k, (omega, value) in enumerate(points[:-1]):
        after, beyond = points[k + 1]
        if value == 0.0:
            yield omega
        elif value * beyond < 0.0:
            yield root(excess, omega, after, value, beyond)
        elif k > 0 and _is_nearest(points[k - 1][1], value, beyond):
            yield from _pair(excess, points[k - 1], points[k], points[k + 1])
    if points[-1][1] == 0.0:
        yield points[-1][0]


def _is_nearest(before: float, value: float, after: float) -> bool:
    """Return True if the middle one of three values of one sign is nearest to 0."""
    return before * value > 0.0 and after * value > 0.0 and abs(value) <= min(abs(before), abs(after))


def _pair(
    excess: Callable[[float], float], left: tuple[float, float], middle: tuple[float, float], right: tuple[float, float]
) -> Iterator[float]:
    """Yield two roots around an extremum that the points stop short of, if there are any."""
    sign = math.copysign(1.0, middle[1])
    a, b = left[0], right[0]
    for _ in range(ROUNDS):
        tried = [(sign * excess(place), place) for place in (a + (b - a) / 3.0, b - (b - a) / 3.0)]
        least, lowest = min(tried)
        if least < 0.0 or b - a < 1e-9 * abs(b):
            break
        a, b = (a, tried[1][1]) if lowest == tried[0][1] else (tried[0][1], b)
    if least < 0.0:
        yield root(excess, left[0], lowest, left[1], sign * least)
        yield root(excess, lowest, right[0], sign * least, right[1])


def root(excess: Callable[[float], float], a: float, b: float, at_a: float, at_b: float) -> float:
    """Return a root between two points of different sign, by the secant rule within a bracket, else by bisection."""
    for k in range(2 * ROUNDS):
        middle = 0.5 * (a + b)
        if middle in (a, b):
            break
        tried = b - at_b * (b - a) / (at_b - at_a) if k % 3 else middle
        if not min(a, b) < tried < max(a, b):
            tried = middle
        value = excess(tried)
        if value == 0.0:
            return tried
        if math.isnan(value):  # a narrow piece without a map between
            break
        if value * at_a < 0.0:
            b, at_b = tried, value
        else:
            a, at_a = tried, value
    return a if abs(at_a) < abs(at_b) else b
