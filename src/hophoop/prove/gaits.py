"""Gaits and chaos proved: an interval of θ̇ that the return map takes into itself, and intervals that cover each other."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from hophoop.prove._flint import Ball, Undecided, arb, precision
from hophoop.prove.deadline import Late
from hophoop.prove.map_certificates import MapCertificate
from hophoop.prove.proof import Enclosure, decimal_of, save_certificate
from hophoop.prove.return_map import BITS, Piece, ReturnMap, check_interval
from hophoop.scenario import InputError, Scenario

LONGER_BITS = 128  # to locate a gait
NEWTON_STEPS = 6
DIGITS = 20
ENTROPY_DIGITS = 6
MOST_INTERVALS = 100

Progress = Callable[[float], None]


@dataclass(frozen=True)
class ProvedGait:
    """An interval of θ̇ at the bottom that the return map takes into itself; made by `prove_gait`.

    Where it is proved, exactly one gait passes the interval, with one revolution for its period, and every motion
    that rolls past the bottom in the interval tends to it.

    Attributes
    ----------
    low, high : float
        The interval [rad/s].
    proved : bool
    why : str
        What could not be shown, as a clause; empty where all is.
    words : tuple of str
        Phases of the revolutions that start in the interval: one letter per phase.
    image : Enclosure or None
        Holds θ̇ at the next passage of every start in the interval [rad/s].
    omega : Enclosure or None
        θ̇ of the gait at the bottom [rad/s].
    multiplier : Enclosure or None
        Its multiplier [1].
    contraction : Enclosure or None
        Holds the derivative of the return map on the whole interval [1].
    boxes : int
        Into which the interval was divided [1].
    certificate : dict or None
        What `check` verifies, where it was asked for.
    """

    low: float
    high: float
    proved: bool
    why: str
    words: tuple[str, ...] = ()
    image: Enclosure | None = None
    omega: Enclosure | None = None
    multiplier: Enclosure | None = None
    contraction: Enclosure | None = None
    boxes: int = 0
    certificate: dict[str, Any] | None = None

    def to_dict(self) -> dict[str, Any]:
        """The result as JSON.

        Returns
        -------
        result : dict
            Enclosures as [middle, radius] in exact decimals.
        """
        names = ("image", "omega", "multiplier", "contraction")
        return {
            "interval": [self.low, self.high], "proved": self.proved, "why": self.why, "words": list(self.words),
            "boxes": self.boxes, **{name: _pair(getattr(self, name)) for name in names},
        }  # fmt: skip

    def save(self, path: str | Path) -> None:
        """Write the certificate as JSON.

        Parameters
        ----------
        path : str or Path

        Raises
        ------
        ValueError
            If there is none: it is not proved, or no certificate was asked for.
        """
        save_certificate(self.certificate, self.why or "certify=True was not given", path)


@dataclass(frozen=True)
class ProvedChaos:
    """Intervals of θ̇ at the bottom that the return map takes over each other; made by `prove_chaos`.

    Where it is proved, the return map is continuous on each interval, and for every sequence of intervals that follows
    `coverings` there is a motion whose passages follow it; for every loop, a gait that does.

    Attributes
    ----------
    intervals : tuple of tuple of float
        Minimum and maximum of each [rad/s].
    proved : bool
        True if two different loops pass one interval, so that the topological entropy is positive.
    why : str
        What could not be shown, as a clause; empty where all is.
    coverings : tuple of tuple of int
        (i, j) where the ends of interval i are taken to opposite sides beyond interval j; counted from 0. They are
        shown even if the rest is not.
    images : tuple of tuple of Enclosure
        θ̇ at the next passage, of both ends of each interval [rad/s].
    entropy : Decimal
        The topological entropy of the return map is at least so large [1].
    words : tuple of tuple of str
        Phases of the revolutions that start in each interval.
    boxes : int
        Into which the intervals were divided [1].
    certificate : dict or None
        What `check` verifies, where it was asked for.
    """

    intervals: tuple[tuple[float, float], ...]
    proved: bool
    why: str
    coverings: tuple[tuple[int, int], ...] = ()
    images: tuple[tuple[Enclosure, Enclosure], ...] = ()
    entropy: Decimal = Decimal(0)
    words: tuple[tuple[str, ...], ...] = ()
    boxes: int = 0
    certificate: dict[str, Any] | None = None

    def to_dict(self) -> dict[str, Any]:
        """The result as JSON.

        Returns
        -------
        result : dict
            Enclosures as [middle, radius] in exact decimals.
        """
        return {
            "intervals": [list(ends) for ends in self.intervals], "proved": self.proved, "why": self.why,
            "coverings": [list(one) for one in self.coverings], "images": [[_pair(e) for e in ends] for ends in self.images],
            "entropy": str(self.entropy), "words": [list(words) for words in self.words], "boxes": self.boxes,
        }  # fmt: skip

    def save(self, path: str | Path) -> None:
        """Write the certificate as JSON.

        Parameters
        ----------
        path : str or Path

        Raises
        ------
        ValueError
            If there is none: it is not proved, or no certificate was asked for.
        """
        save_certificate(self.certificate, self.why or "certify=True was not given", path)


def _pair(found: Enclosure | None) -> list[str] | None:
    return None if found is None else [str(found.middle), str(found.radius)]


def _enclosure(value: Ball, digits: int = DIGITS) -> Enclosure:
    """Decimal numbers that hold all of a ball, as narrow as it allows."""
    with precision(LONGER_BITS):
        low, high = value.lower(), value.upper()
        middle = decimal_of(((low + high) / 2).mid(), ROUND_HALF_EVEN, digits)
    radius = max(abs(_fraction(end) - Fraction(middle)) for end in (low, high))
    up = Context(prec=3, rounding=ROUND_CEILING)
    return Enclosure(middle, up.divide(Decimal(radius.numerator), Decimal(radius.denominator)))


def _fraction(exact: Ball) -> Fraction:
    man, exponent = (int(part) for part in exact.man_exp())
    return Fraction(2) ** exponent * man


# --- a gait ----------------------------------------------------------------------------------------


def prove_gait(
    scenario: Scenario,
    low: float,
    high: float,
    seconds: float | None = None,
    progress: Progress | None = None,
    certify: bool = False,
) -> ProvedGait:
    """Prove that one gait passes the bottom with θ̇ in an interval, and that it attracts all motions that do.

    Shown are: from every θ̇ in the interval, rolling with the load at the bottom, the hoop comes to the bottom again after one
    revolution, rolling, with θ̇ inside the interval; and there the derivative of the return map is less than 1 in size.

    Parameters
    ----------
    scenario : Scenario
        Hoop and plane; start and duration do not count.
    low, high : float
        The interval [rad/s].
    seconds : float, optional
        It stays unproved if it is not proved after this time [s].
    progress : callable, optional
        Called with the share of the interval that is done [1].
    certify : bool, default False
        Make a certificate too; then it is proved only if the checker accepts that.

    Returns
    -------
    gait : ProvedGait

    Raises
    ------
    ValueError
        If the interval is empty or not above 0, the contact is compliant, or there is no gravity.
    ImportError
        If python-flint is not installed.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> slope = hh.Scenario(plane=hh.Plane(gravity=1.0, slope=math.radians(3)), hoop=hh.Hoop.ideal(0.5))
    >>> gait = hh.prove.prove_gait(slope, 2.7714, 2.7716)
    >>> gait.proved, gait.words
    (True, ('RSHKR',))
    """
    check_interval("interval", low, high)
    returns = ReturnMap(scenario, seconds)
    pieces: list[Piece] = []
    try:
        for piece in returns.pieces(low, high, sharp=True):
            pieces.append(piece)
            if progress is not None:
                progress((piece.high - low) / (high - low))
            with precision(BITS):
                _check_piece(piece, low, high)
        found = _gait(returns, pieces, low, high)
        if certify:
            assert found.omega is not None
            assert found.multiplier is not None
            certificate = MapCertificate(returns).gait(pieces, found.omega, found.multiplier)
            found = replace(found, certificate=certificate)
        return found
    except (Undecided, Late) as reason:
        return ProvedGait(low, high, False, str(reason), boxes=len(pieces))


def _check_piece(piece: Piece, low: float, high: float) -> None:
    where = f"for θ̇ = {piece.low:.9g} to {piece.high:.9g} rad/s"
    if not piece.slope.abs_lower() < 1:
        raise Undecided(f"the derivative of the return map is 1 or more in size {where}")
    if piece.image < arb(low) or piece.image > arb(high):
        raise Undecided(f"the return map leads out of the interval {where}")
    if not (piece.image > arb(low) and piece.image < arb(high)):
        raise Undecided(f"the return map may lead out of the interval {where}")
    if not piece.slope.abs_upper() < 1:
        raise Undecided(f"the derivative of the return map may be 1 or more in size {where}")


def _gait(returns: ReturnMap, pieces: list[Piece], low: float, high: float) -> ProvedGait:
    with precision(BITS):
        image, slope = pieces[0].image, pieces[0].slope
        for piece in pieces[1:]:
            image, slope = image.union(piece.image), slope.union(piece.slope)
    omega, multiplier = _located(returns, image.intersection(arb(low).union(arb(high))), slope)
    words = tuple(dict.fromkeys(piece.word for piece in pieces))
    return ProvedGait(
        low, high, True, "", words, _enclosure(image), _enclosure(omega), _enclosure(multiplier, 12), _enclosure(slope, 12),
        len(pieces),
    )  # fmt: skip


def _located(returns: ReturnMap, omega: Ball, slope: Ball) -> tuple[Ball, Ball]:
    """θ̇ of the gait and its multiplier, by the interval Newton method on P(θ̇) − θ̇."""
    for _ in range(NEWTON_STEPS):
        with precision(LONGER_BITS):
            middle = float(omega.mid())
            _, value = returns.point(middle, LONGER_BITS)
            narrower = omega.intersection(arb(middle) + (value - arb(middle)) / (1 - slope))
            done = not narrower.rad() < omega.rad() / 2
            omega = narrower
            ends = math.nextafter(float(omega.lower()), -math.inf), math.nextafter(float(omega.upper()), math.inf)
        try:
            found = returns.piece(*ends)
        except Undecided:
            break
        with precision(BITS):
            slope = slope.intersection(found.slope)
        if done:
            break
    return omega, slope


# --- chaos -----------------------------------------------------------------------------------------


def prove_chaos(
    scenario: Scenario,
    intervals: Sequence[tuple[float, float]],
    seconds: float | None = None,
    progress: Progress | None = None,
    certify: bool = False,
) -> ProvedChaos:
    """Prove chaos of the return map: that it takes intervals of θ̇ at the bottom over each other in more than one loop.

    Shown are, for every interval: from all of its θ̇, rolling with the load at the bottom, the hoop comes to the bottom again
    after one revolution, rolling, by events that depend continuously on θ̇; and its ends are taken to opposite sides beyond the
    intervals that it covers. By the intermediate value theorem there is a motion for every sequence of coverings, and a
    gait for every loop.

    Parameters
    ----------
    scenario : Scenario
        Hoop and plane; start and duration do not count.
    intervals : sequence of tuple of float
        Minimum and maximum of each; none may meet another [rad/s].
    seconds : float, optional
        It stays unproved if it is not proved after this time [s].
    progress : callable, optional
        Called with the share of the intervals that is done [1].
    certify : bool, default False
        Make a certificate too; then it is proved only if the checker accepts that.

    Returns
    -------
    chaos : ProvedChaos

    Raises
    ------
    ValueError
        If there are not 2 to 100 intervals, one is empty or not above 0, two meet, the contact is compliant, or there is no
        gravity.
    ImportError
        If python-flint is not installed.
    """
    found = tuple((float(low), float(high)) for low, high in intervals)
    _check_intervals(found)
    returns = ReturnMap(scenario, seconds)
    proved = ProvedChaos(found, False, "")
    words: list[tuple[str, ...]] = []
    pieces: list[list[Piece]] = []
    try:
        with precision(BITS):
            images = [(returns.point(low)[1], returns.point(high)[1]) for low, high in found]
            covered = [[j for j, other in enumerate(found) if _covers(ends, other)] for ends in images]
        coverings = tuple((i, j) for i, some in enumerate(covered) for j in some)
        enclosures = tuple((_enclosure(a), _enclosure(b)) for a, b in images)
        proved = replace(proved, coverings=coverings, images=enclosures)
        loops = _loops(coverings, len(found))
        if not loops:
            raise Undecided("the coverings have no two different loops through one interval")
        for some in _followed(returns, found, progress):
            pieces.append(some)
            words.append(tuple(dict.fromkeys(piece.word for piece in some)))
            proved = replace(proved, words=tuple(words), boxes=proved.boxes + len(some))
        entropy = max(_entropy(coverings, loop) for loop in loops)
        if certify:
            proved = replace(proved, certificate=MapCertificate(returns).chaos(pieces, coverings, entropy))
    except (Undecided, Late) as reason:
        return replace(proved, why=str(reason))
    return replace(proved, proved=True, entropy=entropy)


def _followed(
    returns: ReturnMap, intervals: tuple[tuple[float, float], ...], progress: Progress | None
) -> Iterator[list[Piece]]:
    """Pieces of each interval, on which the map is shown to be continuous: on boxes that share their ends."""
    length, done = sum(high - low for low, high in intervals), 0.0
    for low, high in intervals:
        found = []
        for piece in returns.pieces(low, high):
            found.append(piece)
            if progress is not None:
                progress((done + piece.high - low) / length)
        done += high - low
        yield found


def _check_intervals(intervals: tuple[tuple[float, float], ...]) -> None:
    if not 2 <= len(intervals) <= MOST_INTERVALS:
        raise InputError.of_field("intervals", len(intervals), f"2 to {MOST_INTERVALS} of them")
    for k, (low, high) in enumerate(intervals):
        check_interval(f"intervals[{k}]", low, high)
    for (_, end), (begin, _) in pairwise(sorted(intervals)):
        if not end < begin:
            said = f"intervals meet at {begin:g} rad/s, and must be apart."
            raise InputError(said, field="intervals", value=begin)


def _covers(ends: tuple[Ball, Ball], other: tuple[float, float]) -> bool:
    """Return True if the images of two ends lie beyond another interval, on opposite sides."""
    below, above = arb(other[0]), arb(other[1])
    return bool((ends[0] < below and ends[1] > above) or (ends[1] < below and ends[0] > above))


def _loops(coverings: Sequence[tuple[int, int]], count: int) -> list[list[int]]:
    """Sets of intervals that reach each other, with more coverings among them than intervals: so with two loops."""
    reach = np.eye(count, dtype=bool)
    for i, j in coverings:
        reach[i, j] = True
    for k in range(count):
        reach |= reach[:, k : k + 1] & reach[k : k + 1]
    sets = {tuple(int(k) for k in np.flatnonzero(reach[i] & reach[:, i])) for i in range(count)}
    return [list(one) for one in sets if sum(i in one and j in one for i, j in coverings) > len(one)]


def _entropy(coverings: Sequence[tuple[int, int]], loop: list[int]) -> Decimal:
    """A number below the logarithm of the largest eigenvalue of the coverings: the least (A v)_i/v_i of any positive v."""
    matrix = np.array([[(i, j) in coverings for j in loop] for i in loop], float)
    vector = np.ones(len(loop))
    for _ in range(2000):
        vector = matrix @ vector + vector  # with 1 on the diagonal it settles, whatever the periods of the loops
        vector /= vector.max()
    exact = [Fraction(float(one)) for one in vector]
    rows = [sum((exact[k] for k, one in enumerate(row) if one), Fraction(0)) for row in matrix]
    least = min(row / one for row, one in zip(rows, exact, strict=True))
    with precision(BITS):
        low = (arb(least.numerator) / arb(least.denominator)).log().lower()
        return decimal_of(low, ROUND_FLOOR, ENTROPY_DIGITS)
