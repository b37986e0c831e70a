"""Power series with fixed-point coefficients: Python integers in units of 2^-bits.

A series in s = τ/h, with h chosen so that its terms shrink, loses nothing to a fixed point, and a product of two costs
a few microseconds without any library. Roots are looked for by what the coefficients prove, never by samples: an
interval is left when its constant term outweighs all others, searched when the series is proven to be monotone or bent
one way there, and halved otherwise.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import accumulate
from operator import mul
from typing import Any

Series = Sequence[int]

# Halvings before an interval that stays undecided counts as one with a root of a high order.
DEEPEST = 60


TOO_MANY = "the motion needs more steps than are allowed."


class TooManySteps(ArithmeticError):
    """More steps are needed than were allowed."""


class Work:
    """The steps that several computations of one motion may take together.

    Parameters
    ----------
    left : float
        In steps of 106 bits, about 1 ms each [1].
    """

    def __init__(self, left: float) -> None:
        self.left = left

    def take(self, bits: int) -> None:
        """Count a step of so many bits."""
        self.left -= work_of_step(bits)
        if self.left < 0.0:
            raise TooManySteps(TOO_MANY)

    def need(self, work: float) -> None:
        """Give up at once where more will be needed than is left."""
        if work > self.left:
            raise TooManySteps(TOO_MANY)

    @contextmanager
    def kept_back(self, part: float) -> Iterator[None]:
        """Let less than all that is left be taken inside."""
        kept = part * self.left if math.isfinite(self.left) else 0.0
        self.left -= kept
        try:
            yield
        finally:
            self.left += kept


def work_of_step(bits: int) -> float:
    """Return the cost of a step relative to one of 106 bits, as measured from 106 to 900 bits, to 15 %."""
    return 0.7 + (bits / 160.0) ** 3


class MorePrecision(Exception):
    """A quantity that decides how the motion goes on cannot be told from zero at the present precision."""


class Judge:
    """Tells the sign of what decides.

    A quantity below half of the working bits asks for more bits; where there are to be no more, it is zero.

    Parameters
    ----------
    bits : int
        Working precision.
    last : bool
        Whether no higher precision will be tried.
    """

    def __init__(self, bits: int, last: bool) -> None:
        self.bits = bits
        self.last = last

    def sign(self, value: int, scale: int) -> int:
        """Sign of a fixed-point number relative to another one, which is its natural size."""
        return self.sign_beyond(value, abs(scale) >> (self.bits // 2))

    def sign_beyond(self, value: Any, rounding: Any) -> int:
        """Sign of a number that may be zero if it is not larger than `rounding`."""
        if abs(value) > rounding:
            return 1 if value > 0 else -1
        if not self.last:
            raise MorePrecision
        return 0

    def leading(self, series: Series, scale: int, known: int = 0, orders: int = 10) -> tuple[int, int]:
        """(order, sign) of the first coefficient that is not zero; the first `known` ones are; (orders, 0) if all are."""
        for k in range(known, min(orders, len(series))):
            sign = self.sign(series[k], scale)
            if sign:
                return k, sign
        return orders, 0


def value(series: Series, s: int, bits: int) -> int:
    """Value at s, by Horner's rule."""
    total = 0
    for coefficient in reversed(series):
        total = (total * s >> bits) + coefficient
    return total


def slope_at(series: Series, s: int, bits: int) -> int:
    """Derivative at s."""
    total = 0
    for k in range(len(series) - 1, 0, -1):
        total = (total * s >> bits) + k * series[k]
    return total


def product(a: Series, b: Series, bits: int) -> list[int]:
    """Product of two series, cut at the shorter one."""
    return [sum(map(mul, a[: k + 1], b[k::-1])) >> bits for k in range(min(len(a), len(b)))]


def integral(series: Series) -> list[int]:
    """Integral from 0."""
    return [0, *(coefficient // (k + 1) for k, coefficient in enumerate(series))]


def stretched(series: Series, part: int, bits: int) -> list[int]:
    """The series in x = s / part, so that x = 1 is s = part."""
    if part == 1 << bits:
        return list(series)
    result = []
    power = 1 << bits
    for coefficient in series:
        result.append(coefficient * power >> bits)
        power = power * part >> bits
    return result


def shifted(series: Series) -> list[int]:
    """The series about 1."""
    rest = list(reversed(series))
    result = []
    while rest:
        rest = list(accumulate(rest))
        result.append(rest.pop())
    return result


def halved(series: Series) -> list[int]:
    """The series in x with 0 … 1 over the first half of the interval."""
    return [coefficient >> k for k, coefficient in enumerate(series)]


def _newton(series: Series, bits: int, sign: int, begin: int = 0) -> int:
    """Root in [begin, 1] of a series that is monotone there and goes from `sign` to its opposite."""
    low, high = begin, 1 << bits
    s = begin + ((high - begin) >> 1) if begin else 0  # the slope is zero at an extremum
    for _ in range(4 * bits):
        here = sign * value(series, s, bits)
        if here > 0:
            low = s
        elif here < 0:
            high = s
        else:
            return s
        rate = sign * slope_at(series, s, bits)
        following = s - (here << bits) // rate if rate else -1
        if not low <= following <= high:
            following = (low + high) >> 1
        if abs(following - s) <= 1 or high - low <= 1:
            return min(max(following, low), high)
        s = following
    return s


def sign_changes(series: Series, sign: int, bits: int, judge: Judge, first: bool = True) -> list[int]:
    """Roots in (0, 1] at which a series changes its sign, in order; only the first one if asked so.

    Parameters
    ----------
    series : sequence of int
        With its known leading zeros divided out.
    sign : int
        Sign just after 0.
    bits : int
        Of the fixed point.
    judge : Judge
        Tells whether an extremum reaches zero.
    first : bool
        Whether the first root is enough.

    Returns
    -------
    roots : list of int
        Fixed-point numbers.
    """
    scale = max(map(abs, series))
    found: list[int] = []
    # (series on the interval, where it begins, width as a shift)
    work = [(list(series), 0, 0)]
    while work:
        part, begin, depth = work.pop()
        # what a coefficient has lost to the fixed point is not worth carrying
        while len(part) > 2 and abs(part[-1]) <= 1:
            part.pop()
        here = sign * part[0]
        total = sum(map(abs, part)) - abs(part[0])
        if here > total:
            continue
        roots: list[int] = []
        slopes = [k * part[k] for k in range(1, len(part))]
        bends = [k * slopes[k] for k in range(1, len(slopes))]
        rest = sum(map(abs, slopes)) - abs(slopes[0])
        bent = sum(map(abs, bends)) - abs(bends[0]) if bends else 0
        end = sign * sum(part)
        if abs(slopes[0]) > rest or depth >= DEEPEST:
            # monotone
            if end <= 0:
                roots.append(_newton(part, bits, sign))
        elif bends and abs(bends[0]) > bent:
            if sign * bends[0] < 0:  # an arch: it falls through zero once or not at all
                if end <= 0:
                    roots.append(_arch(part, slopes, bits, sign))
            elif sign * slopes[0] >= 0:
                pass
            elif sign * sum(slopes) <= 0:
                if end <= 0:
                    roots.append(_newton(part, bits, sign))
            else:
                lowest = _newton(slopes, bits, -sign)
                if judge.sign(sign * value(part, lowest, bits), scale) < 0:
                    roots.append(_newton(stretched(part, lowest, bits), bits, sign) * lowest >> bits)
                    if not first and end > 0:
                        roots.append(_newton(part, bits, -sign, lowest))
        else:
            left = halved(part)
            middle = begin + ((1 << bits) >> (depth + 1))
            work.append((shifted(left), middle, depth + 1))
            work.append((left, begin, depth + 1))
            continue
        for root in roots:
            found.append(begin + (root >> depth))
            if first:
                return found
            sign = -sign
    return found


def _arch(part: Series, slopes: Series, bits: int, sign: int) -> int:
    """The root of a series that bends away from its sign on [0, 1] and ends beyond zero."""
    if sign * slopes[0] <= 0:
        return _newton(part, bits, sign)
    top = _newton(slopes, bits, sign)
    return _newton(part, bits, sign, top)
