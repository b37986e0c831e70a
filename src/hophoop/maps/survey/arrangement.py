"""A plane of two parameters cut into the regions of its classes, by following all borders from slice to slice.

Along each line x = const the classes follow one another, with borders to rounding between them (`hophoop.maps.survey.slices`).
From one line to the next the borders move and the list stays the same, until two borders meet, one turns back or one
leaves the window: then the list differs. The line halfway differs from one of the two, and so the place where classes
meet is followed to rounding, looking only between two classes that go on undisturbed below and above.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.maps.survey.slices import Codes, Floats, Ints, Slice, middle, resolve

BESIDE = tuple(float(f"1e-{k}") for k in range(2, 11))  # parts of y beside each border at which the lines are looked at again
CLOSE = 1e-6  # parts of x
WITHIN = np.linspace(0.0, 1.0, 27)[1:-1]
CANDIDATES = 4  # classes below and above a difference at which it is tried to be enclosed
PASSES = 12  # in which the first lines learn from one another
BETWEEN = np.linspace(0.0, 1.0, 9)[1:-1]  # where classes are looked at first on a line halfway
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
        The classes about it [1].
    """

    x: float
    y: float
    codes: tuple[int, ...]


class Seen(NamedTuple):
    """Every stretch of one class between two borders on a line.

    Attributes
    ----------
    code : ndarray, shape (n,)
        Its class [1].
    x, y, length : ndarray, shape (n,)
        Its line, its middle and how long it is [SI].
    """

    code: Ints
    x: Floats
    y: Floats
    length: Floats


class Borders(NamedTuple):
    """Places at which one class follows another on a line.

    Attributes
    ----------
    below, above : ndarray, shape (n,)
        The classes [1].
    x, y : ndarray, shape (n,)
        The line, and the first place of the class above [SI].
    """

    below: Ints
    above: Ints
    x: Floats
    y: Floats


class Arrangement(NamedTuple):
    """What `arrange` finds.

    Attributes
    ----------
    slices : list of Slice
        Along the first lines.
    seen : Seen
        The stretches on all lines.
    areas : ndarray, shape (classes,)
        Area of each class [SI].
    meetings : list of Meeting
    borders : Borders
        Every border on every line.
    complete : bool
        Whether every difference has been followed as far as was asked for.
    """

    slices: list[Slice]
    seen: Seen
    areas: Floats
    meetings: list[Meeting]
    borders: Borders
    complete: bool


def arrange(
    codes_at: Codes,
    lines: Floats,
    seeds: Floats,
    part: float,
    thin: float = 0.0,
    settled: Callable[[Ints, Ints], NDArray[np.bool_]] | None = None,
    border_part: float = 0.0,
    tidy: Callable[[Slice], Slice] | None = None,
    most: int = 4000,
) -> Arrangement:
    """Cut the rectangle over `lines` and `seeds` into classes.

    Parameters
    ----------
    codes_at : callable
        Codes at pairs (x, y).
    lines : ndarray, shape (m,)
        Growing x of the first lines, the ends of the rectangle among them [SI].
    seeds : ndarray, shape (n,)
        Growing y at which each of them is looked at, the ends of the rectangle among them [SI].
    part : float
        Places where classes meet are followed to this part of x [1].
    thin : float
        Shorter stretches may be there on one line and not on the next: that alone is not followed [SI].
    settled, border_part
        As in `resolve`.
    tidy : callable, optional
        Takes out of a slice what is known to be rounding.
    most : int
        Most differences followed at once; where there are more, `complete` says so.

    Returns
    -------
    arrangement : Arrangement
    """
    work = _Work(codes_at, part, thin, settled, border_part, tidy)
    slices = work.resolved(lines, [seeds] * len(lines), None)
    slices = work.resolved(lines, [_beside(one) for one in slices], None)
    # what one line shows, the next may have missed
    for _ in range(PASSES):
        shown = [one.codes.size for one in slices]
        again = [_beside_others(slices, k) for k in range(len(slices))]
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
        if len(gaps) > most:
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
    return Arrangement(slices, seen, areas, _merged(work.meetings, part), borders, complete)


def _beside(one: Slice) -> Floats:
    """Places between and closely beside the borders of a slice."""
    inner = one.y[1:-1]
    offsets = np.array([sign * size for size in BESIDE for sign in (-1.0, 1.0)])
    near = (inner[:, None] * (1.0 + offsets)).reshape(-1)
    near = near[(near > one.y[0]) & (near < one.y[-1])]
    just_below = np.nextafter(inner, 0.0)
    return np.unique(np.concatenate([one.y, just_below, middle(one.y[:-1], one.y[1:]), near]))


def _beside_others(slices: list[Slice], k: int) -> Floats | None:
    """Where to look again on a line, from what its neighbours show; None where they show the same."""
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
    """What grows while the plane is cut."""

    def __init__(
        self,
        codes_at: Codes,
        part: float,
        thin: float,
        settled: Callable[[Ints, Ints], NDArray[np.bool_]] | None,
        border_part: float,
        tidy: Callable[[Slice], Slice] | None,
    ) -> None:
        self.codes_at = codes_at
        self.part = part
        self.thin = thin
        self.settled = settled
        self.border_part = border_part
        self.tidy = tidy
        self.stretches: list[tuple[Any, ...]] = []
        self.cut: list[tuple[Any, ...]] = []
        self.areas: list[tuple[Ints, Floats]] = []
        self.meetings: list[Meeting] = []
        self.borders: list[tuple[Ints, Ints, Floats, Floats]] = []

    def resolved(self, x: Sequence[float] | Floats, seeds: list[Floats], seen: list[Ints] | None) -> list[Slice]:
        """`resolve` with the options of this work."""
        slices = resolve(self.codes_at, x, seeds, seen, self.settled, self.border_part)
        return slices if self.tidy is None else [self.tidy(one) for one in slices]

    def note(self, slices: list[Slice], whole: bool) -> None:
        """Keep the stretches of slices; the first and the last one of those that are not whole go on outside."""
        for one in slices:
            low, high = one.y[:-1], one.y[1:]
            columns = one.codes, np.full(one.codes.size, one.x), middle(low, high), high - low
            ends = np.zeros(one.codes.size, bool)
            if not whole:
                ends[[0, -1]] = True
                self.cut.append(tuple(column[ends] for column in columns))
            self.stretches.append(tuple(column[~ends] for column in columns))
            inner = one.y[1:-1]
            self.borders.append((one.codes[:-1], one.codes[1:], np.full(inner.size, one.x), inner))

    def seen(self) -> Seen:
        """All whole stretches, and of classes that have none the others."""
        whole = Seen(*(np.concatenate(column) for column in zip(*self.stretches, strict=True)))
        if not self.cut:
            return whole
        cut = Seen(*(np.concatenate(column) for column in zip(*self.cut, strict=True)))
        alone = ~np.isin(cut.code, whole.code)
        return Seen(*(np.concatenate([column, more[alone]]) for column, more in zip(whole, cut, strict=True)))

    def fill(self, left: Slice, right: Slice) -> None:
        """Area between two slices, by trapezoids."""
        half = 0.5 * (right.x - left.x)
        for one in (left, right):
            self.areas.append((one.codes, half * np.diff(one.y)))

    def halve(self, gaps: list[tuple[Slice, Slice]]) -> list[tuple[Slice, Slice]]:
        """Fill the gaps between slices of one list; cut the others in two beside the differences."""
        open_gaps = []
        for left, right in gaps:
            matched = self.match(left, right)
            if matched is None:
                self.fill(left, right)
                if right.x - left.x <= CLOSE * right.x and left.codes.tolist() != right.codes.tolist():
                    # followed to where what ends there is too short to go on
                    self.meet(left, right, ([], []))
            elif right.x - left.x <= self.part * right.x:
                self.fill(left, right)
                self.meet(left, right, matched)
            else:
                open_gaps.append((left, right, matched))
        if not open_gaps:
            return []
        x = middle(np.array([left.x for left, _, _ in open_gaps]), np.array([right.x for _, right, _ in open_gaps]))
        looked = [
            _places(left, right, matched, self.thin, float(at)) for (left, right, matched), at in zip(open_gaps, x, strict=True)
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
        """A slice between two places; what is cut off goes into the areas."""
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
        """Stretches of both slices that are the same from below and from above; None where all are."""
        if left.codes.size == right.codes.size and (left.codes == right.codes).all():
            return None
        light = [_is_light(one, self.thin) for one in (left, right)]
        codes = [one.codes for one in (left, right)]
        below = _pairs(codes[0], codes[1], light[0], light[1])
        if below[1]:
            return None
        above = _pairs(codes[0][::-1], codes[1][::-1], light[0][::-1], light[1][::-1])
        sizes = codes[0].size - 1, codes[1].size - 1
        upper = [(sizes[0] - i, sizes[1] - j) for i, j in above[0]]
        if below[0]:
            i, j = below[0][-1]
            upper = [pair for pair in upper if pair[0] >= i and pair[1] >= j and pair != (i, j)]
        return below[0], upper

    def meet(self, left: Slice, right: Slice, matched: Matched) -> None:
        """Keep the place of a difference that has been followed to its end."""
        below, above = matched
        places, codes = [], set()
        for k, one in enumerate((left, right)):
            first = below[-1][k] if below else 0
            last = above[-1][k] if above else one.codes.size - 1
            codes |= set(one.codes[first : last + 1].tolist())
            places += one.y[first + 1 : last + 1].tolist()
        place = float(np.mean(places)) if places else float(0.5 * (left.y[0] + left.y[-1]))
        self.meetings.append(Meeting(0.5 * (left.x + right.x), place, tuple(sorted(codes))))


def _is_light(one: Slice, thin: float) -> NDArray[np.bool_]:
    """Stretches that may be there on one line and not on the next."""
    return np.asarray(np.diff(one.y) < thin + FEW_ULPS * one.y[1:])


def _pairs(one: Ints, other: Ints, light: NDArray[np.bool_], lighter: NDArray[np.bool_]) -> tuple[Pairs, bool]:
    """Equal stretches from the first on, light ones left out where they stand alone; and whether that is all."""
    found: Pairs = []
    i = j = 0
    while i < one.size and j < other.size:
        if one[i] == other[j]:
            found.append((i, j))
            i, j = i + 1, j + 1
        elif light[i]:
            i += 1
        elif lighter[j]:
            j += 1
        else:
            return found, False
    return found, bool(light[i:].all() and lighter[j:].all())


Chosen = list[tuple[float, float, float, int]]


def _places(left: Slice, right: Slice, matched: Matched, thin: float, x: float) -> tuple[Floats, Chosen, Chosen]:
    """Where to look on the line between two slices, and the places among them that may enclose the difference."""
    share = (x - left.x) / (right.x - left.x)
    light = [_is_light(one, thin) for one in (left, right)]
    below, above = matched

    def between(a: float, b: float) -> float:
        return a + share * (b - a)

    def candidates(pairs: Pairs, others: Pairs) -> Chosen:
        # a stretch that goes on both below and above the difference must not be left through its middle
        shared = [{pair[k] for pair in others} for k in (0, 1)]
        result = []
        firm = [(i, j) for i, j in pairs if not (light[0][i] or light[1][j])]
        for i, j in firm[-CANDIDATES:]:
            floor, roof = max(left.y[i], right.y[j]), min(left.y[i + 1], right.y[j + 1])
            if floor < roof:
                a = b = float(middle(floor, roof))
            elif i in shared[0] or j in shared[1]:
                continue
            else:
                a = float(middle(left.y[i], left.y[i + 1]))
                b = float(middle(right.y[j], right.y[j + 1]))
            result.append((a, b, between(a, b), int(left.codes[i])))
        return result

    # from the farthest to the nearest
    low, high = candidates(below, above), candidates(above, below)
    ends = between(left.y[0], right.y[0]), between(left.y[-1], right.y[-1])
    near = low[-1][2] if low else ends[0]
    far = high[-1][2] if high else ends[1]
    rows = [np.array(ends), np.array([row[2] for row in low + high]), near + (far - near) * BETWEEN]
    for k, one in enumerate((left, right)):
        first = below[-1][k] if below else 0
        last = above[-1][k] if above else one.codes.size - 1
        if first <= last:
            inner = one.y[first + 1 : last + 1]
            rows += [inner, middle(one.y[first : last + 1], one.y[first + 1 : last + 2])]
            # between two stretches of one class nothing leads to the one that ends between the lines
            for m in range(max(first, 1), min(last, one.codes.size - 2) + 1):
                if one.codes[m - 1] == one.codes[m + 1]:
                    rows.append(one.y[m] + (one.y[m + 1] - one.y[m]) * WITHIN)
    places = np.unique(np.concatenate(rows))
    return places[(places >= ends[0]) & (places <= ends[1])], low, high


def _enclosing(left: Slice, right: Slice, chosen: Chosen, row: Floats, codes: Ints, end: int) -> tuple[float, float, float]:
    """Places on both slices and between them below (or above) which nothing differs: the nearest seen to hold."""
    for a, b, place, code in reversed(chosen):
        k = int(np.searchsorted(row, place))
        if k < row.size and row[k] == place and codes[k] == code:
            return a, b, place
    return float(left.y[end]), float(right.y[end]), float(row[end])


def _merged(meetings: list[Meeting], part: float) -> list[Meeting]:
    """Meetings at one place as one."""
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
