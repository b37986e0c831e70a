"""Subdivision of a plane of two parameters into the regions of its classes, following all borders from slice to slice.

Along each line x = const the classes form a list, with borders located to rounding (`hophoop.maps.survey.slices`).
From one line to the next the borders move and the list stays the same, until two borders meet, a border turns back or one
leaves the window: then the list differs. The line halfway differs from one of the two, so that bisection locates the meeting
of classes to rounding. It searches only between two classes that continue below and above.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.maps.survey.slices import Codes, Floats, Ints, Slice, middle, resolve

NEAR_BORDERS = tuple(float(f"1e-{k}") for k in range(2, 11))  # relative distances from each border sampled again
CLOSE = 1e-6  # relative to x
WITHIN = np.linspace(0.0, 1.0, 27)[1:-1]
CANDIDATES = 4  # classes below and above a difference tried as its enclosure
PASSES = 12  # over the first lines, each resampled where its neighbours differ
BETWEEN = np.linspace(0.0, 1.0, 9)[1:-1]  # first samples on a line halfway
FEW_ULPS = 64.0 * np.finfo(float).eps

Pairs = list[tuple[int, int]]
Matched = tuple[Pairs, Pairs]


class Meeting(NamedTuple):
    """Where the list of classes along x = const changes: classes meet, or a border turns back or leaves the window.

    Attributes
    ----------
    x, y : float
        [SI].
    codes : tuple of int
        The classes around it [1].
    """

    x: float
    y: float
    codes: tuple[int, ...]


class Seen(NamedTuple):
    """Intervals of one class between two borders on a line.

    Attributes
    ----------
    code : ndarray, shape (n,)
        Its class [1].
    x, y, length : ndarray, shape (n,)
        Its line, its midpoint and its length [SI].
    """

    code: Ints
    x: Floats
    y: Floats
    length: Floats


class Borders(NamedTuple):
    """Positions at which one class follows another on a line.

    Attributes
    ----------
    below, above : ndarray, shape (n,)
        The classes [1].
    x, y : ndarray, shape (n,)
        The line, and the first position of the class above [SI].
    """

    below: Ints
    above: Ints
    x: Floats
    y: Floats


class Arrangement(NamedTuple):
    """Result of `arrange`.

    Attributes
    ----------
    slices : list of Slice
        Along the first lines.
    seen : Seen
        The intervals on all lines.
    areas : ndarray, shape (classes,)
        Area of each class [SI].
    meetings : list of Meeting
    borders : Borders
        Every border on every line.
    complete : bool
        Whether every difference was followed to the requested precision.
    """

    slices: list[Slice]
    seen: Seen
    areas: Floats
    meetings: list[Meeting]
    borders: Borders
    complete: bool


class Options(NamedTuple):
    """How a plane is subdivided.

    Attributes
    ----------
    part : float
        Meetings of classes are located to this part of x [1].
    thin : float
        Shorter intervals may exist on one line and not on the next: that alone is not followed [SI].
    settled, border_part
        As in `resolve`.
    remove_spurious : callable, optional
        Removes from a slice what is known to be rounding.
    most : int
        Maximum number of differences followed at once; with more, the result is not `complete`.
    """

    part: float
    thin: float = 0.0
    settled: Callable[[Ints, Ints], NDArray[np.bool_]] | None = None
    border_part: float = 0.0
    remove_spurious: Callable[[Slice], Slice] | None = None
    most: int = 4000


def arrange(codes_at: Codes, lines: Floats, seeds: Floats, options: Options) -> Arrangement:
    """Subdivide the rectangle over `lines` and `seeds` into classes.

    Parameters
    ----------
    codes_at : callable
        Codes at pairs (x, y).
    lines : ndarray, shape (m,)
        Increasing x of the first lines, both ends of the rectangle included [SI].
    seeds : ndarray, shape (n,)
        Increasing y of the first samples on each line, both ends of the rectangle included [SI].
    options : Options

    Returns
    -------
    arrangement : Arrangement
    """
    work = _Work(codes_at, options)
    slices = work.resolved(lines, [seeds] * len(lines), None)
    slices = work.resolved(lines, [_samples_near_borders(one) for one in slices], None)
    # a line may have missed classes that its neighbours show
    for _ in range(PASSES):
        shown = [one.codes.size for one in slices]
        again = [_samples_from_neighbours(slices, k) for k in range(len(slices))]
        changed = [k for k, row in enumerate(again) if row is not None]
        if not changed:
            break
        looked = work.resolved(lines[changed], [row for row in again if row is not None], None)
        for k, one in zip(changed, looked, strict=True):
            slices[k] = one
        if [one.codes.size for one in slices] == shown:
            break
    work.note(slices, True)
    gaps = list(itertools.pairwise(slices))
    complete = True
    while gaps:
        if len(gaps) > options.most:
            complete = False
            for left, right in gaps:
                work.fill(left, right)
            break
        gaps = work.halve(gaps)
    seen = work.seen()
    borders = Borders(*(np.concatenate(column) for column in zip(*work.borders, strict=True)))
    code, area = (np.concatenate(column) for column in zip(*work.areas, strict=True))
    areas = np.zeros(int(seen.code.max()) + 1)
    np.add.at(areas, code, area)
    return Arrangement(slices, seen, areas, _merged(work.meetings, options.part), borders, complete)


def _samples_near_borders(one: Slice) -> Floats:
    """Return positions between and close to the borders of a slice."""
    inner = one.y[1:-1]
    offsets = np.array([sign * size for size in NEAR_BORDERS for sign in (-1.0, 1.0)])
    near = (inner[:, None] * (1.0 + offsets)).reshape(-1)
    near = near[(near > one.y[0]) & (near < one.y[-1])]
    just_below = np.nextafter(inner, 0.0)
    return np.unique(np.concatenate([one.y, just_below, middle(one.y[:-1], one.y[1:]), near]))


def _samples_from_neighbours(slices: list[Slice], k: int) -> Floats | None:
    """Return positions to sample again on a line, from its neighbours; None if they have the same classes."""
    own = slices[k]
    rows = [own.y, np.nextafter(own.y[1:-1], 0.0), middle(own.y[:-1], own.y[1:])]
    for way in (-1, 1):
        if not 0 <= k + way < len(slices):
            continue
        near = slices[k + way]
        if near.codes.size == own.codes.size and (near.codes == own.codes).all():
            continue
        places = middle(near.y[:-1], near.y[1:])
        rows += [near.y, places]
        if 0 <= k + 2 * way < len(slices):
            far = slices[k + 2 * way]
            if far.codes.size == near.codes.size and (far.codes == near.codes).all():
                share = (own.x - near.x) / (near.x - far.x)
                rows.append(places + share * (places - middle(far.y[:-1], far.y[1:])))
    if len(rows) == 3:
        return None
    places = np.unique(np.concatenate(rows))
    return np.asarray(places[(places >= own.y[0]) & (places <= own.y[-1])])


class _Work:
    """State of a subdivision in progress."""

    def __init__(self, codes_at: Codes, options: Options) -> None:
        self.codes_at = codes_at
        self.options = options
        self.intervals: list[tuple[Any, ...]] = []
        self.cut: list[tuple[Any, ...]] = []
        self.areas: list[tuple[Ints, Floats]] = []
        self.meetings: list[Meeting] = []
        self.borders: list[tuple[Ints, Ints, Floats, Floats]] = []

    def resolved(self, x: Sequence[float] | Floats, seeds: list[Floats], seen: list[Ints] | None) -> list[Slice]:
        """Resolve slices with the options of this subdivision."""
        options = self.options
        slices = resolve(self.codes_at, x, seeds, seen, options.settled, options.border_part)
        return slices if options.remove_spurious is None else [options.remove_spurious(one) for one in slices]

    def note(self, slices: list[Slice], whole: bool) -> None:
        """Record the intervals of slices; the outer two of a partial slice continue beyond it."""
        for one in slices:
            low, high = one.y[:-1], one.y[1:]
            columns = one.codes, np.full(one.codes.size, one.x), middle(low, high), high - low
            ends = np.zeros(one.codes.size, bool)
            if not whole:
                ends[[0, -1]] = True
                self.cut.append(tuple(column[ends] for column in columns))
            self.intervals.append(tuple(column[~ends] for column in columns))
            inner = one.y[1:-1]
            self.borders.append((one.codes[:-1], one.codes[1:], np.full(inner.size, one.x), inner))

    def seen(self) -> Seen:
        """Return all complete intervals, and the cut ones of classes without complete intervals."""
        whole = Seen(*(np.concatenate(column) for column in zip(*self.intervals, strict=True)))
        if not self.cut:
            return whole
        cut = Seen(*(np.concatenate(column) for column in zip(*self.cut, strict=True)))
        alone = ~np.isin(cut.code, whole.code)
        return Seen(*(np.concatenate([column, more[alone]]) for column, more in zip(whole, cut, strict=True)))

    def fill(self, left: Slice, right: Slice) -> None:
        """Add the area between two slices, by trapezoids."""
        half = 0.5 * (right.x - left.x)
        for one in (left, right):
            self.areas.append((one.codes, half * np.diff(one.y)))

    def halve(self, gaps: list[tuple[Slice, Slice]]) -> list[tuple[Slice, Slice]]:
        """Fill the gaps between slices with equal lists; bisect the others around their differences."""
        open_gaps = []
        for left, right in gaps:
            matched = self.match(left, right)
            if matched is None:
                self.fill(left, right)
                if right.x - left.x <= CLOSE * right.x and left.codes.tolist() != right.codes.tolist():
                    # the class that ends here has become too short to follow
                    self.meet(left, right, ([], []))
            elif right.x - left.x <= self.options.part * right.x:
                self.fill(left, right)
                self.meet(left, right, matched)
            else:
                open_gaps.append((left, right, matched))
        if not open_gaps:
            return []
        x = middle(np.array([left.x for left, _, _ in open_gaps]), np.array([right.x for _, right, _ in open_gaps]))
        looked = [
            _places(left, right, matched, self.options.thin, float(at))
            for (left, right, matched), at in zip(open_gaps, x, strict=True)
        ]
        sizes = [row.size for row, _, _ in looked]
        flat = self.codes_at(np.repeat(x, sizes), np.concatenate([row for row, _, _ in looked]))
        codes = np.split(flat, np.cumsum(sizes)[:-1])
        seeds, seen, parts = [], [], []
        for (left, right, _), (row, below, above), found in zip(open_gaps, looked, codes, strict=True):
            low = _enclosing(left, right, below, row, found, 0)
            high = _enclosing(left, right, above, row, found, -1)
            first, last = int(np.searchsorted(row, low[2])), int(np.searchsorted(row, high[2]))
            seeds.append(row[first : last + 1])
            seen.append(found[first : last + 1])
            parts.append((self.trim(left, low[0], high[0], right), self.trim(right, low[1], high[1], left)))
        slices = self.resolved(x, seeds, seen)
        self.note(slices, False)
        return [pair for (left, right), mid in zip(parts, slices, strict=True) for pair in ((left, mid), (mid, right))]

    def trim(self, one: Slice, low: float, high: float, other: Slice) -> Slice:
        """Trim a slice to an interval, and add the rest to the areas."""
        half = 0.5 * abs(other.x - one.x)
        first = int(np.searchsorted(one.y, low, "right")) - 1
        last = int(np.searchsorted(one.y, high, "left"))
        first = max(first, 0)
        last = min(max(last, first + 1), one.codes.size)
        kept = Slice(one.x, np.concatenate(([low], one.y[first + 1 : last], [high])), one.codes[first:last])
        below = np.diff(np.concatenate((one.y[: first + 1], [low])))
        above = np.diff(np.concatenate(([high], one.y[last:])))
        self.areas.append((one.codes[: first + 1], half * below))
        self.areas.append((one.codes[last - 1 :], half * above))
        return kept

    def match(self, left: Slice, right: Slice) -> Matched | None:
        """Return the intervals of both slices that agree from below and from above; None if all agree."""
        if left.codes.size == right.codes.size and (left.codes == right.codes).all():
            return None
        negligible = [_is_negligible(one, self.options.thin) for one in (left, right)]
        codes = [one.codes for one in (left, right)]
        below = _pairs(codes[0], codes[1], *negligible)
        if below[1]:
            return None
        above = _pairs(codes[0][::-1], codes[1][::-1], negligible[0][::-1], negligible[1][::-1])
        sizes = codes[0].size - 1, codes[1].size - 1
        upper = [(sizes[0] - i, sizes[1] - j) for i, j in above[0]]
        if below[0]:
            i, j = below[0][-1]
            upper = [pair for pair in upper if pair[0] >= i and pair[1] >= j and pair != (i, j)]
        return below[0], upper

    def meet(self, left: Slice, right: Slice, matched: Matched) -> None:
        """Record the position of a difference that has been located."""
        below, above = matched
        places, codes = [], set()
        for k, one in enumerate((left, right)):
            first = below[-1][k] if below else 0
            last = above[-1][k] if above else one.codes.size - 1
            codes |= set(one.codes[first : last + 1].tolist())
            places += one.y[first + 1 : last + 1].tolist()
        place = float(np.mean(places)) if places else float(0.5 * (left.y[0] + left.y[-1]))
        self.meetings.append(Meeting(0.5 * (left.x + right.x), place, tuple(sorted(codes))))


def _is_negligible(one: Slice, thin: float) -> NDArray[np.bool_]:
    """Return which intervals are so short that the next line may lack them."""
    return np.asarray(np.diff(one.y) < thin + FEW_ULPS * one.y[1:])


def _pairs(one: Ints, other: Ints, negligible: NDArray[np.bool_], other_negligible: NDArray[np.bool_]) -> tuple[Pairs, bool]:
    """Pair equal intervals from the first on, skipping negligible ones without a partner; and return True if none is left."""
    found: Pairs = []
    i = j = 0
    while i < one.size and j < other.size:
        if one[i] == other[j]:
            found.append((i, j))
            i, j = i + 1, j + 1
        elif negligible[i]:
            i += 1
        elif other_negligible[j]:
            j += 1
        else:
            return found, False
    return found, bool(negligible[i:].all() and other_negligible[j:].all())


class Enclosure(NamedTuple):
    """A position in a class that may bound a difference from below or above."""

    left: float  # y on the left slice
    right: float  # y on the right slice
    between: float  # y on the line between them
    code: int


Enclosures = list[Enclosure]


def _places(left: Slice, right: Slice, matched: Matched, thin: float, x: float) -> tuple[Floats, Enclosures, Enclosures]:
    """Return the positions to sample on the line between two slices, and those that may enclose the difference."""
    share = (x - left.x) / (right.x - left.x)
    negligible = [_is_negligible(one, thin) for one in (left, right)]
    below, above = matched

    def between(a: float, b: float) -> float:
        return a + share * (b - a)

    def candidates(pairs: Pairs, others: Pairs) -> Enclosures:
        # an interval that continues below and above the difference must not be cut in its middle
        shared = [{pair[k] for pair in others} for k in (0, 1)]
        result = []
        reliable = [(i, j) for i, j in pairs if not (negligible[0][i] or negligible[1][j])]
        for i, j in reliable[-CANDIDATES:]:
            lower, upper = max(left.y[i], right.y[j]), min(left.y[i + 1], right.y[j + 1])
            if lower < upper:
                a = b = float(middle(lower, upper))
            elif i in shared[0] or j in shared[1]:
                continue
            else:
                a = float(middle(left.y[i], left.y[i + 1]))
                b = float(middle(right.y[j], right.y[j + 1]))
            result.append(Enclosure(a, b, between(a, b), int(left.codes[i])))
        return result

    # farthest first
    low, high = candidates(below, above), candidates(above, below)
    ends = between(left.y[0], right.y[0]), between(left.y[-1], right.y[-1])
    bottom = low[-1].between if low else ends[0]
    top = high[-1].between if high else ends[1]
    rows = [np.array(ends), np.array([row.between for row in low + high]), bottom + (top - bottom) * BETWEEN]
    for k, one in enumerate((left, right)):
        first = below[-1][k] if below else 0
        last = above[-1][k] if above else one.codes.size - 1
        if first <= last:
            inner = one.y[first + 1 : last + 1]
            rows += [inner, middle(one.y[first : last + 1], one.y[first + 1 : last + 2])]
            # an interval amid one class may end between the lines, where bisection has no second class to find it by
            for m in range(max(first, 1), min(last, one.codes.size - 2) + 1):
                if one.codes[m - 1] == one.codes[m + 1]:
                    rows.append(one.y[m] + (one.y[m + 1] - one.y[m]) * WITHIN)
    places = np.unique(np.concatenate(rows))
    return places[(places >= ends[0]) & (places <= ends[1])], low, high


def _enclosing(left: Slice, right: Slice, chosen: Enclosures, row: Floats, codes: Ints, end: int) -> tuple[float, float, float]:
    """Return the nearest confirmed positions, on both slices and between, below (or above) which nothing differs."""
    for enclosure in reversed(chosen):
        k = int(np.searchsorted(row, enclosure.between))
        if k < row.size and row[k] == enclosure.between and codes[k] == enclosure.code:
            return enclosure[:3]
    return float(left.y[end]), float(right.y[end]), float(row[end])


def _merged(meetings: list[Meeting], part: float) -> list[Meeting]:
    """Merge meetings at one position."""
    result: list[Meeting] = []
    for one in sorted(meetings):
        for k in range(len(result) - 1, -1, -1):
            other = result[k]
            near = one.x - other.x <= 8.0 * part * one.x
            if near and abs(one.y - other.y) <= 1e3 * part * one.y:
                result[k] = Meeting(other.x, other.y, tuple(sorted({*one.codes, *other.codes})))
                break
            if not near:
                result.append(one)
                break
        else:
            result.append(one)
    return result
