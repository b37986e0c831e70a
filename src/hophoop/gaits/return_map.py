"""The return map of rolling at the bottom over a range of θ̇: its pieces, and what is between them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.errors import check_whole
from hophoop.gaits.computing import check
from hophoop.gaits.differences import last_kept
from hophoop.gaits.kernels.layout import OMEGA, TURNS
from hophoop.gaits.maps import FASTEST, SectionMap, slowest_over_top
from hophoop.kernel.records import unpacked_sequence
from hophoop.scenario import InputError, Scenario, Start

Progress = Callable[[float], object]

POINTS, DEPTH = 600, 8
MOST_POINTS = 1_000_000
CONTINUOUS = 1e-6  # √(g/R): the least difference of two pieces at their common end that is a jump


class MapPiece(NamedTuple):
    """A part of the map with the same phases throughout.

    Attributes
    ----------
    omega, after : ndarray, shape (n,)
        θ̇ at a passage and at the next one, from end to end of the piece; both ends to rounding [rad/s].
    sequence : str
        Phases between the passages.
    """

    omega: NDArray[np.float64]
    after: NDArray[np.float64]
    sequence: str


class MapEnd(NamedTuple):
    """An end that two pieces have in common.

    Attributes
    ----------
    omega : float
        [rad/s].
    kind : {'corner', 'jump'}
        Whether the map is continuous there.
    before, after : str
        The sequences on both sides.
    """

    omega: float
    kind: str
    before: str
    after: str


@dataclass(frozen=True)
class ReturnMap:
    """The map from θ̇ at a passage of the bottom to θ̇ at the next one; made by `hophoop.gaits.return_map`.

    Attributes
    ----------
    scenario : Scenario
        Its hoop and plane count.
    pieces : tuple of MapPiece
        In the order of θ̇. Between them the hoop slips at the bottom, does not come back to it, or the pieces are narrower than
        the distance of the points.
    """

    scenario: Scenario
    pieces: tuple[MapPiece, ...]

    @property
    def ends(self) -> tuple[MapEnd, ...]:
        """Corners and jumps of the map."""
        unit = self._unit
        found = []
        for one, other in pairwise(self.pieces):
            place = float(one.omega[-1])
            if abs(float(other.omega[0]) - place) <= 4.0 * np.spacing(place):
                kind = "corner" if abs(float(other.after[0] - one.after[-1])) < CONTINUOUS * unit else "jump"
                found.append(MapEnd(place, kind, one.sequence, other.sequence))
        return tuple(found)

    def __call__(self, omega: float) -> float:
        """Return θ̇ at the next passage.

        Parameters
        ----------
        omega : float
            At a passage in rolling [rad/s].

        Returns
        -------
        after : float
            nan if the hoop slips at the next passage, or there is none [rad/s].
        """
        return known(self._map, omega / self._unit).after * self._unit

    @property
    def _unit(self) -> float:
        return self._map.unit

    @cached_property
    def _map(self) -> SectionMap:
        return SectionMap(self.scenario)

    def __repr__(self) -> str:
        low, high = float(self.pieces[0].omega[0]), float(self.pieces[-1].omega[-1])
        kinds = [end.kind for end in self.ends]
        return (
            f"<ReturnMap: {len(self.pieces)} pieces from {low:.6g} to {high:.6g} rad/s, "
            f"{kinds.count('corner')} corners, {kinds.count('jump')} jumps>"
        )


def return_map(
    scenario: Scenario,
    low: float | None = None,
    high: float | None = None,
    points: int = POINTS,
    *,
    progress: Callable[[float], object] | None = None,
) -> ReturnMap:
    """Compute the return map of rolling with the load at the bottom.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count; with rigid contact.
    low, high : float, optional
        Range of θ̇ [rad/s]. By default from what may get over the top up to 10 √(g/R), or twice the first, downhill.
    points : int, default 600
        Equally spaced θ̇ at which the map is computed, besides the ends of its pieces [1].
    progress : callable, optional
        Called with the computed fraction, 0 to 1.

    Returns
    -------
    map : ReturnMap

    Raises
    ------
    ValueError
        If an argument is not allowed, or the map has no point in the range.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> plane = hh.Plane(slope=math.radians(1), gravity=1.0)
    >>> found = hh.gaits.return_map(hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=plane), 3.3, 3.5)
    >>> [piece.sequence for piece in found.pieces], [end.kind for end in found.ends]
    (['RSRKR', 'RSHSRKR', 'RSHRKR', 'RSHKR'], ['corner', 'corner', 'corner'])
    """
    check(scenario, "bottom")
    image = SectionMap(scenario.replace("start", Start()))
    ahead = -1.0 if scenario.plane.slope < 0.0 else 1.0
    slowest = slowest_over_top(scenario)
    ends = sorted(ahead * size * image.unit for size in (slowest, max(FASTEST["bottom"], 2.0 * slowest)))
    first, last = (ends[k] if given is None else given for k, given in enumerate((low, high)))
    check_whole("points", points, 2, MOST_POINTS)
    if not (math.isfinite(first) and math.isfinite(last) and first < last):
        raise InputError(f"low = {first!r} and high = {last!r} must be finite, and low below high.")
    grid = (np.linspace(first, last, points) / image.unit).tolist()
    found = []
    for piece in pieces(image, grid, DEPTH, progress):
        omega, after = np.array([(one.omega, one.after) for one in piece]).T * image.unit
        phases = np.frombuffer(piece[0].word[0], np.uint64).tolist()
        found.append(MapPiece(omega, after, unpacked_sequence(phases)))
    if not found:
        raise InputError(f"The hoop does not come back to the bottom in rolling with θ̇ from {first:.6g} to {last:.6g} rad/s.")
    return ReturnMap(image.scenario, tuple(found))


# --- pieces of the map


class Known(NamedTuple):
    """θ̇ at a passage and at the next one, nan if it does not come back in rolling [√(g/R)].

    The word holds the phases, packed, and the revolutions as the kernel counts them.
    """

    omega: float
    after: float
    word: tuple[bytes, float]

    @property
    def excess(self) -> float:
        """The change of θ̇ [√(g/R)]."""
        return self.after - self.omega


def known(image: SectionMap, omega: float) -> Known:
    """Return the map at θ̇."""
    found = image(np.array([omega]))
    after, turns = math.nan, 0.0
    if image.comes_back(found):
        after, turns = float(found.rows[-1, OMEGA]), float(found.rows[-1, TURNS])
    return Known(omega, after, (found.words.tobytes(), turns))


def pieces(image: SectionMap, grid: list[float], depth: int, progress: Progress | None = None) -> list[list[Known]]:
    """Return the pieces of a map that an increasing grid [√(g/R)] meets, and more between them, without parts without a map.

    The phases are the same from the first to the last double of a piece. depth: how often what is between two pieces is halved.
    """
    places = [known(image, grid[0])]
    for k, omega in enumerate(grid):
        before, now = places[-1], known(image, omega)
        if now.word != before.word:
            high = _edge(image, before, omega)
            low = known(image, math.nextafter(high.omega, omega))
            if low.word != now.word:
                low = _edge(image, now, before.omega)
            places += [high, *_between(image, high, low, depth), low]
        places.append(now)
        if progress is not None:
            progress((k + 1) / len(grid))
    found = [list(piece) for _, piece in groupby(sorted(set(places)), lambda one: one.word)]
    return [piece for piece in found if not math.isnan(piece[0].after)]


def _between(image: SectionMap, left: Known, right: Known, depth: int) -> list[Known]:
    """Return places and ends of the pieces between the ends of two others that a few halvings meet."""
    middle = 0.5 * (left.omega + right.omega)
    now = known(image, middle)
    if depth == 0 or right.omega - left.omega <= 4.0 * math.ulp(middle) or now.word in (left.word, right.word):
        return []
    low, high = _edge(image, now, left.omega), _edge(image, now, right.omega)
    return [*_between(image, left, low, depth - 1), low, now, high, *_between(image, high, right, depth - 1)]


def _edge(image: SectionMap, inside: Known, outside: float) -> Known:
    """Return the last double with the phases of the inside, on the way to the outside, and the map there."""

    def kept(omega: float) -> Known | None:
        tried = known(image, omega)
        return tried if tried.word == inside.word else None

    return last_kept(inside, inside.omega, outside, kept)
