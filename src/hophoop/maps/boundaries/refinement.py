"""Refinement: cells only where the class changes, halved repeatedly."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.maps.boundaries.classes import Classifier, Window, make_window
from hophoop.scenario import InputError, Scenario

Ints = NDArray[np.int64]
MOST_LEVELS = 24


class Refined(NamedTuple):
    """A plane of two parameters divided into squares of one class each, as small as necessary.

    Attributes
    ----------
    window : Window
        The plane.
    classes : list of str
        Meanings of the codes.
    x, y : ndarray, shape (n,)
        Lower corners of the squares, in the parameters' units [SI].
    width, height : ndarray, shape (n,)
        Their sides, in the parameters' units [SI].
    level : ndarray, shape (n,)
        Number of halvings of each [1].
    codes : ndarray, shape (n, 4)
        Classes at its corners: (low x, low y), (high, low), (low, high), (high, high) [1].
    evaluated : int
        Motions computed [1].
    """

    window: Window
    classes: list[str]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    width: NDArray[np.float64]
    height: NDArray[np.float64]
    level: Ints
    codes: Ints
    evaluated: int

    @property
    def mixed(self) -> NDArray[np.bool_]:
        """True for squares whose corners have different classes [1]."""
        return np.asarray((self.codes != self.codes[:, :1]).any(axis=1))

    def shares(self) -> dict[str, tuple[float, float]]:
        """Return the share of the window of each class, with its uncertainty.

        Returns
        -------
        shares : dict of str to tuple of float
            Share and uncertainty by class, largest first [1], measured in the window, also along a logarithmic
            axis. The uncertainty is the share of the squares that a border crosses.
        """
        area = np.ldexp(1.0, -2 * self.level) * self._unit
        mixed = self.mixed
        found = {}
        for code, name in enumerate(self.classes):
            corners = (self.codes == code).sum(axis=1)
            share = float((area * corners).sum() / 4.0)
            doubt = float(area[mixed & (corners > 0)].sum())
            if corners.any():
                found[name] = (share, doubt)
        return dict(sorted(found.items(), key=lambda item: -item[1][0]))

    @property
    def _unit(self) -> float:
        # a square of level 0, relative to the window
        top = np.ldexp(1.0, -2 * self.level)
        return float(1.0 / top.sum())


def refine(
    base: Scenario | None,
    ranges: dict[str, tuple[float, float]],
    levels: int = 6,
    cells: int = 64,
    quantity: str | Sequence[str] = "sequence",
    span: str = "first_revolution",
    logarithmic: Sequence[str] = (),
    progress: Callable[[int, int], None] | None = None,
) -> Refined:
    """Divide a window into squares of one class each, halving those whose corners or neighbours differ.

    Parameters
    ----------
    base : Scenario or None
        The scenario to vary; None is the reference hoop.
    ranges : dict of str to tuple of float
        The two parameters by path, x first, and their ranges [SI].
    levels : int, default 6
        Maximum number of halvings, from 0 to 24 [1].
    cells : int, default 64
        Initial number of squares along each side [1].
    quantity : str or sequence of str, default 'sequence'
        Quantities that define the classes.
    span : str, default 'first_revolution'
        As in `sweep`.
    logarithmic : sequence of str
        Parameters with a logarithmic axis.
    progress : callable, optional
        Called with each level and its number of squares.

    Returns
    -------
    refined : Refined

    Raises
    ------
    ValueError
        If an option is not allowed.

    Examples
    --------
    >>> refined = refine(None, {"plane.mu": (0.02, 2.0), "start.speed": (0.05, 5.0)}, levels=3, cells=16)
    >>> refined.evaluated < 129**2 / 2
    True
    """
    if not 0 <= levels <= MOST_LEVELS:
        raise InputError.of_field("levels", levels, f"from 0 to {MOST_LEVELS}")
    if not 1 <= cells <= 4096:
        raise InputError.of_field("cells", cells, "from 1 to 4096")
    base = Scenario() if base is None else base
    window = make_window(base, ranges, logarithmic)
    names = [quantity] if isinstance(quantity, str) else list(quantity)
    classify = Classifier(base, window, names, span)
    lattice = _Lattice(classify, cells << levels)
    size = 1 << levels
    start = np.arange(cells, dtype=np.int64) * size
    i, j = (array.reshape(-1) for array in np.meshgrid(start, start, indexing="ij"))
    kept: list[tuple[Ints, Ints, Ints, Ints]] = []
    for level in range(levels + 1):
        if progress is not None:
            progress(level, i.size)
        size = 1 << (levels - level)
        codes = lattice.corners(i, j, size)
        split = (codes != codes[:, :1]).any(axis=1) if level < levels else np.zeros(i.size, bool)
        if level < levels:
            split |= lattice.next_to_split(i, j, size, split)
        whole = ~split
        kept.append((i[whole], j[whole], np.full(int(whole.sum()), level), codes[whole]))
        half = size >> 1
        i, j = i[split], j[split]
        i = np.concatenate([i, i + half, i, i + half])
        j = np.concatenate([j, j, j + half, j + half])
    i, j, level_of, codes = (np.concatenate(part) for part in zip(*kept, strict=True))
    sides = (1 << levels) >> level_of
    total = cells << levels
    x, y = window.values(i / total, j / total)
    x_end, y_end = window.values((i + sides) / total, (j + sides) / total)
    return Refined(window, classify.names, x, y, x_end - x, y_end - y, level_of, codes, classify.evaluated)


class _Lattice:
    """Classes at the points of a fine lattice, each computed once."""

    def __init__(self, classify: Classifier, total: int) -> None:
        self.classify = classify
        self.total = total
        self.keys = np.empty(0, np.int64)
        self.codes = np.empty(0, np.int64)

    def at(self, i: Ints, j: Ints) -> Ints:
        """Return the codes at lattice points."""
        keys = i * (self.total + 1) + j
        asked = np.unique(keys)
        place = np.searchsorted(self.keys, asked)
        known = np.zeros(asked.size, bool)
        inside = place < self.keys.size
        known[inside] = self.keys[place[inside]] == asked[inside]
        fresh = asked[~known]
        if fresh.size:
            u, v = fresh // (self.total + 1) / self.total, fresh % (self.total + 1) / self.total
            keys_all = np.concatenate([self.keys, fresh])
            codes_all = np.concatenate([self.codes, self.classify(u, v)])
            order = np.argsort(keys_all, kind="stable")
            self.keys, self.codes = keys_all[order], codes_all[order]
        return self.codes[np.searchsorted(self.keys, keys)]

    def corners(self, i: Ints, j: Ints, size: int) -> Ints:
        """Return the codes at the four corners of squares."""
        return np.stack([self.at(i, j), self.at(i + size, j), self.at(i, j + size), self.at(i + size, j + size)], axis=1)

    def next_to_split(self, i: Ints, j: Ints, size: int, split: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Return which unsplit squares are next to a split one: a border may cross their side between two corners."""
        step = self.total + 1
        places = np.sort((i // size)[split] * step + (j // size)[split])
        result = np.zeros(i.size, bool)
        for a in (-1, 0, 1):
            for b in (-1, 0, 1):
                keys = (i // size + a) * step + (j // size + b)
                place = np.minimum(np.searchsorted(places, keys), max(places.size - 1, 0))
                if places.size:
                    result |= places[place] == keys
        return result & ~split
