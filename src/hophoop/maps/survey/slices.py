"""Classes along lines of one parameter: every change from one class to another, bisected to rounding.

Between two places of different classes something changes. The place in the middle is of the one class, of the other
or of a third, and then there are two changes to look for: whatever lies between two different classes is found as
long as it is wider than neighbouring numbers.
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
        Where the line lies [SI].
    y : ndarray, shape (n + 1,)
        The ends of the line and the borders between them, growing [SI].
    codes : ndarray, shape (n,)
        Class between one and the next [1].
    """

    x: float
    y: Floats
    codes: Ints


def middle(low: Floats, high: Floats) -> Floats:
    """Between two positive numbers; by ratio where they are far apart."""
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
    """Slices along lines, from the places on each where the classes are looked at first.

    Parameters
    ----------
    codes_at : callable
        Codes at pairs (x, y).
    x : sequence of float
        Of the lines [SI].
    seeds : sequence of ndarray
        Growing y on each line, its ends first and last [SI].
    seen : sequence of ndarray, optional
        Classes at the seeds where they are known already.
    settled : callable, optional
        Whether nothing can lie between two classes: such a border is bisected to `part` only.
    part : float
        Part of y to which settled borders are bisected; 0 is to rounding, as all others are [1].

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
            # its place is the first of the class above, so that no two borders of a line are at one place
            done.append((row[ready], high[ready], below[ready], above[ready]))
            left = ~ready
            row, below, above = row[left], below[left], above[left]
            low, high, between = low[left], high[left], between[left]
        if not row.size:
            break
        found = codes_at(x[row], between)
        as_below, as_above = found == below, found == above
        third = ~as_below & ~as_above
        # a third class: its border to the class above is looked for as well
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
