"""Certificates of the return map: a gait that attracts an interval of θ̇, and chaos by intervals that cover each other.

A certificate divides each interval into boxes that share their ends, and names the phases of the motions from each. The
checker follows all motions of each box; what the map does with the intervals it concludes from them alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from decimal import InvalidOperation
from fractions import Fraction
from itertools import pairwise
from typing import Any

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, precision, rational
from hophoop.prove.checker.conventions import FASTEST, decimal
from hophoop.prove.checker.equations import Equations, Refused
from hophoop.prove.checker.family import Family
from hophoop.prove.checker.intervals import require
from hophoop.prove.checker.passages import Motions
from hophoop.prove.checker.scenarios import readable
from hophoop.prove.checker.verdict import Verdict
from hophoop.prove.deadline import Deadline, Late

MAP_SCHEMA = "hophoop-map-proof/1"
MOST_INTERVALS = 100
MOST_ENTROPY = 5  # above ln 100
BITS = 64  # for boxes
POINT_BITS = 144  # for θ̇ of a gait and its multiplier
BITS_A_TERM = 4  # of the polynomials of slip
COMMON = {"schema", "version", "scenario", "claim", "boxes", "words"}
KEYS = {
    "gait": COMMON | {"interval", "contraction", "gait"},
    "chaos": COMMON | {"intervals", "coverings", "entropy"},
}

Interval = tuple[Fraction, Fraction]


@dataclass
class MapCheck:
    """A certificate of the return map, as far as it is verified."""

    claim: dict[str, Any]
    deadline: Deadline
    seen: int = 0
    equations: dict[int, Equations] = field(default_factory=dict)

    def run(self) -> tuple[str, ...]:
        """Verify it; return what it says, in sentences without a capital."""
        claim = self.claim
        said = claim.get("claim")
        require(isinstance(said, str) and said in KEYS, "the claim is gait or chaos")
        require(set(claim) == KEYS[str(said)], "the certificate states nothing but what is checked, and all of that")
        readable(claim["scenario"])
        require(bool(claim["scenario"]["plane"]["gravity"]), "there is gravity")
        return self.gait() if said == "gait" else self.chaos()

    def image(self, low: Fraction, high: Fraction, phases: Any, bits: int = BITS) -> tuple[str, Family]:
        """(word, θ̇ at the next passage in rad/s) of all motions that begin in a box."""
        with precision(bits):
            if bits not in self.equations:
                self.equations[bits] = Equations(self.claim["scenario"], self.deadline)
            try:
                motions = Motions(self.equations[bits], low, high, bits // BITS_A_TERM)
                found = motions.follow(phases)
            except Refused as reason:
                where = f"{float(low):.9g}" if low == high else f"{float(low):.9g} to {float(high):.9g}"
                raise Refused(f"{reason}, for θ̇ = {where} rad/s") from None
        self.seen += len(motions.letters)
        return motions.word, found

    def images(self, boxes: Any, words: Any) -> Iterator[tuple[Interval, Family]]:
        """(ends, image) of each box; the words are those of the boxes."""
        found: dict[str, None] = {}
        for one in boxes:
            ends = _interval(one["from"])
            word, image = self.image(*ends, one["phases"])
            require(word in words, f"the phases from an interval are those that are named, not {word}")
            found[word] = None
            yield ends, image
        require(list(found) == words, "the phases from an interval are those that are named")

    # --- a gait --------------------------------------------------------------------------------

    def gait(self) -> tuple[str, ...]:
        """One gait passes the interval, attracts it, and is where it is said to be."""
        claim = self.claim
        low, high = interval = _interval(claim["interval"])
        contraction = decimal(claim["contraction"])
        require(0 < contraction < 1, "the slope of the return map is below 1 in size")
        _chain(interval, claim["boxes"])
        for ends, image in self.images(claim["boxes"], claim["words"]):
            where = f"for θ̇ = {float(ends[0]):.9g} to {float(ends[1]):.9g} rad/s"
            with precision(BITS):
                inside = image.over > rational(low) and image.over < rational(high)
                require(bool(inside), f"the return map leads into the interval, {where}")
                slow = bool(abs(image.by) <= rational(contraction))
                require(slow, f"the slope of the return map is {claim['contraction']} or less in size, {where}")
        gait = claim["gait"]
        require(set(gait) == {"omega", "multiplier", "phases"}, "a gait has its θ̇, its multiplier and its phases")
        begin, end = _enclosure(gait["omega"])
        require(low <= begin < end <= high, "θ̇ of the gait is in the interval")
        word, whole = self.image(begin, end, gait["phases"], POINT_BITS)
        require(word in claim["words"], "the phases of the gait are those of the interval")
        least, largest = _enclosure(gait["multiplier"])
        with precision(POINT_BITS):  # P(θ̇) − θ̇ falls, for the derivative of P is below 1
            way = whole.by * rational((end - begin) / 2)
            crossed = whole.at - way > rational(begin) and whole.at + way < rational(end)
            require(bool(crossed), "θ̇ of the gait is where it is said to be")
            known = whole.by >= rational(least) and whole.by <= rational(largest)
            require(bool(known), "the multiplier is where it is said to be")
        return (
            f"the return map takes all θ̇ from {float(low)!r} to {float(high)!r} rad/s into that interval",
            f"its slope there is {claim['contraction']} or less in size, so that one gait attracts all",
            f"θ̇ of the gait is {' ± '.join(gait['omega'])} rad/s",
            f"its multiplier is {' ± '.join(gait['multiplier'])}",
        )

    # --- chaos ---------------------------------------------------------------------------------

    def chaos(self) -> tuple[str, ...]:
        """The map is continuous on each interval and takes it over others; the coverings have the entropy."""
        claim = self.claim
        intervals = [_interval(one) for one in claim["intervals"]]
        count = len(intervals)
        require(2 <= count <= MOST_INTERVALS, f"there are 2 to {MOST_INTERVALS} intervals")
        require(len(claim["boxes"]) == len(claim["words"]) == count, "each interval has boxes and words")
        require(all(a[1] < b[0] for a, b in pairwise(sorted(intervals))), "no interval meets another")
        coverings = {(_index(i, count), _index(j, count)) for i, j in claim["coverings"]}
        _entropy(decimal(claim["entropy"]), coverings, count)
        for interval, boxes in zip(intervals, claim["boxes"], strict=True):
            _chain(interval, boxes)
        for k, (interval, boxes) in enumerate(zip(intervals, claim["boxes"], strict=True)):
            places = ((interval[0], boxes[0]), (interval[1], boxes[-1]))
            ends = [self.image(place, place, one["phases"])[1].over for place, one in places]
            for i, j in sorted(coverings):
                require(i != k or _beyond(ends, intervals[j]), f"interval {i} is taken over interval {j}, counted from 0")
        for boxes, words in zip(claim["boxes"], claim["words"], strict=True):
            for _ in self.images(boxes, words):
                pass
        return (
            f"the return map is continuous on {' and on '.join(f'{float(a)!r} to {float(b)!r}' for a, b in intervals)} rad/s",
            *(f"it takes interval {i} over interval {j}, counted from 0" for i, j in sorted(coverings)),
            f"its topological entropy is {claim['entropy']} a revolution at least",
        )


def checked_map(certificate: dict[str, Any], deadline: Deadline) -> Verdict:
    """The verdict on a statement about the return map."""
    check = MapCheck(certificate, deadline)
    try:
        lines = check.run()
    except (Refused, Late) as reason:
        return Verdict(False, str(reason), check.seen)
    except (ArithmeticError, ValueError, KeyError, TypeError, IndexError, AttributeError, InvalidOperation) as error:
        return Verdict(False, f"the certificate can be read and evaluated ({error!r})", check.seen)
    return Verdict(True, "", check.seen, lines)


def _place(value: Any) -> Fraction:
    require(isinstance(value, float) and 0.0 < value <= FASTEST, "θ̇ at the bottom is a number above 0")
    return Fraction(value)


def _chain(interval: Interval, boxes: Any) -> None:
    """Refuse unless boxes cover an interval and share their ends: so the map is continuous on it if it is on each."""
    require(len(boxes) > 0 and all(set(one) == {"from", "phases"} for one in boxes), "a box has two ends and its phases")
    ends = [_interval(one["from"]) for one in boxes]
    require(ends[0][0] == interval[0] and ends[-1][1] == interval[1], "the boxes cover the interval from end to end")
    require(all(a[1] == b[0] for a, b in pairwise(ends)), "each box begins where the one before it ends")


def _interval(value: Any) -> Interval:
    low, high = value
    found = _place(low), _place(high)
    require(found[0] < found[1], "an interval has its least θ̇ first")
    return found


def _enclosure(value: Any) -> Interval:
    middle, radius = (decimal(text) for text in value)
    require(radius > 0, "an enclosure has a radius")
    return middle - radius, middle + radius


def _index(value: Any, count: int) -> int:
    known = isinstance(value, int) and not isinstance(value, bool) and 0 <= value < count
    require(known, "coverings name intervals by their numbers, from 0")
    return int(value)


def _beyond(ends: list[Ball], other: Interval) -> bool:
    """Return True if the images of both ends of an interval lie beyond another one, on opposite sides."""
    with precision(BITS):
        low, high = (rational(place) for place in other)
        first, last = ends
        return bool((first < low and last > high) or (last < low and first > high))


def _strong(coverings: set[tuple[int, int]], count: int) -> list[list[int]]:
    """Sets of intervals of which each leads to each, by coverings."""
    reach = [{j for i, j in coverings if i == k} for k in range(count)]
    for via in range(count):
        for one in reach:
            if via in one:
                one |= reach[via]
    sets = {tuple(j for j in range(count) if j in reach[i] and i in reach[j]) for i in range(count)}
    return [list(one) for one in sets if one]


def _entropy(claim: Fraction, coverings: set[tuple[int, int]], count: int) -> None:
    """Refuse an entropy that is larger than the logarithm of all eigenvalues of the coverings' matrix A.

    det(x − A) grows beyond all bounds, so that it has a root from any x on at which it is not positive; for A, the coverings
    among intervals of which each leads to each.
    """
    require(0 < claim < MOST_ENTROPY, f"the entropy is above 0 and below {MOST_ENTROPY}")
    with precision(BITS):
        mantissa, exponent = (int(part) for part in rational(claim).exp().upper().man_exp())
    x, zero = _flint.fmpq(mantissa) * _flint.fmpq(2) ** exponent, _flint.fmpq(0)
    for some in _strong(coverings, count):
        size = len(some)
        entries = [(x if i == j else zero) - ((i, j) in coverings) for i in some for j in some]
        if _flint.fmpq_mat(size, size, entries).det() <= 0:
            return
    require(False, "the coverings have the entropy that is said")
