"""Rules of theory for the classes along a line, and for which of them can be neighbours.

Rounding decides within about 1e-12 of a border: there a line may show intervals that are not motions, or that lie between
two events that are exactly simultaneous. `Rules.remove_spurious` removes them. `explain` searches all borders for neighbours
that theory does not allow.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from hophoop.maps.boundaries.classes import Classifier
from hophoop.maps.survey.arrangement import Arrangement
from hophoop.maps.survey.coincidences import REVERSAL, REVOLUTIONS, TAKEOFF, Class, coincidence
from hophoop.maps.survey.slices import Ints, Slice
from hophoop.maps.survey.strips import across, may_hold_strips

MIRROR = 1e-3  # relative speed within which rounding may separate two simultaneous contacts with the cone
NEAR_MEETING = 1e-6  # relative μ around a meeting in which neighbours are not checked
ISLAND = 1e-9  # relative speed below which an interval amid one class counts as that class
TOP = 1e-11  # speed range in which rounding may decide whether a hoop that stops at the top passes it [m/s]

Place = tuple[float, float]


class Rules:
    """Rules of theory, by code."""

    def __init__(self, classify: Classifier) -> None:
        self._names = classify.names
        self.classes: list[Class] = []
        self._settled: dict[tuple[int, int], bool] = {}
        self._count = 0
        self._mirror: dict[tuple[int, int], frozenset[int]] = {}  # of each pair, the classes that may lie between

    def _class(self, code: int) -> Class:
        while len(self.classes) < len(self._names):
            sequence, ending = self._names[len(self.classes)].split(" ")
            self.classes.append((sequence, ending))
        return self.classes[code]

    def settled(self, below: Ints, above: Ints) -> NDArray[np.bool_]:
        """Return True where no strips can lie between two classes."""
        result = np.zeros(below.size, bool)
        for k, pair in enumerate(zip(below.tolist(), above.tolist(), strict=True)):
            if pair not in self._settled:
                self._settled[pair] = not may_hold_strips(self._class(pair[0]), self._class(pair[1]))
            result[k] = self._settled[pair]
        return result

    def is_motion(self, code: int) -> bool:
        """Return True if a class can exist: it ends, starts rolling or hopping, and has no phase twice in a row."""
        sequence, ending = self._class(code)
        if ending in ("undetermined", "event_limit") or not (sequence[0] == "R" or sequence == "H"):
            return False
        return all(mode != following for mode, following in itertools.pairwise(sequence))

    def remove_spurious(self, one: Slice) -> Slice:
        """Return the slice with spurious classes removed and simultaneous contacts with the cone merged into one border."""
        if self._count != len(self._names):
            self._mirror.clear()  # new classes may be halves
            self._count = len(self._names)
        codes = one.codes.tolist()
        keep = [self.is_motion(code) for code in codes]
        if not all(keep):
            one = _without(one, keep)
            codes = one.codes.tolist()
        # At small friction the class flickers within rounding error. An interval wider than a neighbour is not spurious:
        # else rounding at its border would remove a narrow class.
        while True:
            width = np.diff(one.y)
            narrow = (width[1:-1] < ISLAND * one.y[-1]) & (width[1:-1] <= width[:-2]) & (width[1:-1] <= width[2:])
            short = np.flatnonzero(narrow & (one.codes[2:] == one.codes[:-2])) + 1
            if not short.size:
                break
            apart = short[np.concatenate(([True], np.diff(short) > 1))]
            one = _without(one, [k not in apart for k in range(one.codes.size)])
        codes = one.codes.tolist()
        k = 0
        keep = [True] * len(codes)
        while k < len(codes) - 2:
            reach = k + 1
            while reach < len(codes) - 1 and one.y[reach + 1] - one.y[k + 1] < MIRROR * one.y[k + 1]:
                reach += 1
            last = next((j for j in range(reach, k + 1, -1) if self._is_one_border(one, codes, k, j)), k)
            for j in range(k + 1, last):
                keep[j] = False
            k = max(last, k + 1)
        return one if all(keep) else _without(one, keep)

    def _is_one_border(self, one: Slice, codes: list[int], k: int, j: int) -> bool:
        if self._is_mirror(codes[k], codes[j], codes[k + 1 : j]):
            return True
        # a narrow strip of a skid may also end in rolling to the top, but is wider than rounding
        return bool(one.y[j] - one.y[k + 1] < TOP) and self._is_top(codes[k], codes[j], codes[k + 1 : j])

    def _is_mirror(self, one: int, other: int, between: list[int]) -> bool:
        """Return True if two classes differ by two simultaneous contacts, and those between by one of the two."""
        if (one, other) not in self._mirror:
            first, last = self._class(one), self._class(other)
            self._mirror[one, other] = frozenset()
            if coincidence(first, last) == "mirror":
                self._mirror[one, other] = frozenset({one, other, *self._halves(first, last)})
        allowed = self._mirror[one, other]
        return bool(allowed) and allowed.issuperset(between)

    def _is_top(self, one: int, other: int, between: list[int]) -> bool:
        """Return True if the hoop comes to rest at the top between two classes, and those between are due to rounding."""
        first, last = self._class(one), self._class(other)
        if first[0] != last[0] or first[0][-1] != "R" or TAKEOFF in (first[1], last[1]):
            return False
        return all(
            name == first[0] or (ending == REVERSAL and name.startswith(first[0])) for name, ending in map(self._class, between)
        )

    def _halves(self, first: Class, last: Class) -> set[int]:
        found = set()
        for code in range(len(self._names)):
            half = self._class(code)
            if coincidence(first, half) == "cone" and coincidence(half, last) == "cone":
                found.add(code)
        return found


def _without(one: Slice, keep: list[bool]) -> Slice:
    """Return a slice without some intervals: borders move to their midpoints, equal neighbours merge."""
    kept = [k for k, is_kept in enumerate(keep) if is_kept]
    if not kept:
        return one
    codes, y = [int(one.codes[kept[0]])], [float(one.y[0])]
    for k, following in itertools.pairwise(kept):
        if one.codes[following] == codes[-1]:
            continue
        y.append(float(0.5 * (one.y[k + 1] + one.y[following])))
        codes.append(int(one.codes[following]))
    return Slice(one.x, np.array([*y, one.y[-1]]), np.array(codes, dtype=np.int64))


def explain(
    arrangement: Arrangement, classes: list[Class]
) -> tuple[dict[Class, list[Place]], list[tuple[Class, Class, float, float]]]:
    """Return the strips of skids, and the neighbours that no coincidence explains.

    Parameters
    ----------
    arrangement : Arrangement
        Of friction and speed.
    classes : list of tuple of str
        Meanings of its codes.

    Returns
    -------
    strips : dict
        For each strip of theory, the positions (μ, speed) of the borders at which it lies [1], [m/s].
    unexplained : list of tuple
        Neighbours that differ by more than one coincidence and between which no known class can lie, with a position.
    """
    strips: dict[Class, list[Place]] = {}
    unexplained = []
    borders = arrangement.borders
    # lines within rounding of a meeting may skip the classes that end there
    ends = np.array([-np.inf, *sorted(one.x for one in arrangement.meetings), np.inf])
    place = np.searchsorted(ends, borders.x)
    apart = np.minimum(borders.x - ends[place - 1], ends[place] - borders.x) > NEAR_MEETING * borders.x
    below, above, x, y = (column[apart] for column in borders)
    pairs, which = np.unique(np.stack([below, above]), axis=1, return_inverse=True)
    known = {classes[code] for code in np.unique(arrangement.seen.code)}
    skids = [name for name, ending in known if name.endswith("K") and ending == REVERSAL and (name, REVOLUTIONS) in known]
    for k, (one, other) in enumerate((classes[a], classes[b]) for a, b in pairs.T.tolist()):
        at = np.flatnonzero(which.reshape(-1) == k)
        row = next((row for row in map(across, skids) if one in row and other in row), ())
        if row:
            if one[1] != other[1]:
                for strip in row[1:-1]:
                    strips.setdefault(strip, []).extend(zip(x[at].tolist(), y[at].tolist(), strict=True))
        elif not coincidence(one, other) and not any(coincidence(one, mid) and coincidence(mid, other) for mid in known):
            unexplained.append((one, other, float(x[at[0]]), float(y[at[0]])))
    return strips, unexplained
