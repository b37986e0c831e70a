"""Classes along lines of one parameter: every change from one class to another, bisected to rounding.

Between two positions of different classes there is a change. The midpoint has the one class, the other or a third. A third
class means two changes to find. Bisection finds a class between two different ones if it contains a bisection point.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Codes = Callable[[Floats, Floats], Ints]


class Slice(NamedTuple):
    """The classes along a line x = const, from y[0] to y[-1].

    Attributes
    ----------
    x : float
        Position of the line [SI].
    y : ndarray, shape (n + 1,)
        Ends of the line and the borders between them, increasing [SI].
    codes : ndarray, shape (n,)
        Class between each and the next [1].
    """

    x: float
    y: Floats
    codes: Ints


def middle(low: Floats, high: Floats) -> Floats:
    """Return the midpoint of two positive numbers; the geometric mean if they are far apart."""
    with np.errstate(invalid="ignore"):
        return np.where(high > 2.0 * low, np.sqrt(low) * np.sqrt(high), 0.5 * (low + high))


def resolve(
    codes_at: Codes,
    x: Sequence[float] | Floats,
    seeds: Sequence[Floats],
    seen: Sequence[Ints] | None = None,
    settled: Callable[[Ints, Ints], NDArray[np.bool_]] | None = None,
    part: float = 0.0,
) -> list[Slice]:
    """Return slices along lines, from the first samples on each.

    Parameters
    ----------
    codes_at : callable
        Codes at pairs (x, y).
    x : sequence of float
        Positions of the lines [SI].
    seeds : sequence of ndarray
        Increasing y on each line, its ends first and last [SI].
    seen : sequence of ndarray, optional
        Classes at the seeds, if known already.
    settled : callable, optional
        True where no class can lie between two classes: such a border is bisected to `part` only.
    part : float
        Relative precision of settled borders; 0 means rounding, as for all others [1].

    Returns
    -------
    slices : list of Slice
    """
    place = np.concatenate([np.asarray(row, float) for row in seeds])
    line = np.repeat(np.arange(len(seeds)), [len(row) for row in seeds])
    x = np.asarray(x, float)
    codes = codes_at(x[line], place) if seen is None else np.concatenate([np.asarray(row) for row in seen])
    changes = np.flatnonzero((line[1:] == line[:-1]) & (codes[1:] != codes[:-1]))
    row, low, high = line[changes], place[changes], place[changes + 1]
    below, above = codes[changes], codes[changes + 1]
    done: list[tuple[Ints, Floats, Ints, Ints]] = []
    while row.size:
        between = middle(low, high)
        ready = (between <= low) | (between >= high)
        if settled is not None and part > 0.0:
            near = ~ready & (high - low <= part * high)
            ready[near] = settled(below[near], above[near])
        if ready.any():
            # its position is the first of the class above, so that borders of a line are distinct
            done.append((row[ready], high[ready], below[ready], above[ready]))
            left = ~ready
            row, below, above = row[left], below[left], above[left]
            low, high, between = low[left], high[left], between[left]
        if not row.size:
            break
        found = codes_at(x[row], between)
        as_below, as_above = found == below, found == above
        third = ~as_below & ~as_above
        # a third class: find its border to the class above as well
        row = np.concatenate([row, row[third]])
        below_more, above_more = found[third], above[third]
        low_more, high_more = between[third], high[third]
        low, high = np.where(as_below, between, low), np.where(as_below, high, between)
        above = np.where(third, found, above)
        low, high = np.concatenate([low, low_more]), np.concatenate([high, high_more])
        below, above = np.concatenate([below, below_more]), np.concatenate([above, above_more])
    if done:
        row, border, below, above = (np.concatenate(column) for column in zip(*done, strict=True))
    else:
        border, above = np.empty(0), np.empty(0, np.int64)
    slices = []
    order = np.lexsort((border, row))
    row, border, above = row[order], border[order], above[order]
    first = np.searchsorted(row, np.arange(len(seeds) + 1))
    at = np.concatenate(([0], np.cumsum([len(one) for one in seeds])))
    for k in range(len(seeds)):
        part_of = slice(int(first[k]), int(first[k + 1]))
        ends = place[at[k]], place[at[k + 1] - 1]
        slices.append(
            Slice(
                float(x[k]),
                np.concatenate(([ends[0]], border[part_of], [ends[1]])),
                np.concatenate((codes[at[k] : at[k] + 1], above[part_of])),
            )
        )
    return slices
