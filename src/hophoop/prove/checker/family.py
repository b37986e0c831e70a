"""Numbers of a family of motions that start with θ̇ in an interval: how each depends on that θ̇ is kept to first order.

q(ω) lies in q(m) + q′ (ω − m), with q′ over the whole interval: the mean value theorem.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from hophoop.prove._flint import Ball, arb, symmetric
from hophoop.prove.checker.intervals import require


class Family:
    """A number that differs from motion to motion.

    Parameters
    ----------
    at : Ball
        Of the motion that starts in the middle of the interval.
    by : Ball
        Its derivative by the first θ̇, for all motions.
    reach : Ball
        ω − m of all motions.
    over : Ball, optional
        Holds it for all motions, if that is known besides.
    """

    __slots__ = ("at", "by", "over", "reach")

    def __init__(self, at: Ball, by: Ball, reach: Ball, over: Ball | None = None) -> None:
        self.at, self.by, self.reach = at, by, reach
        self.over = at + by * reach
        if over is not None:
            require(bool(self.over.is_finite()) and bool(over.overlaps(self.over)), "a number of all motions is finite")
            self.over = over.intersection(self.over)

    def _through(self, at: Ball, over: Ball, slope: Ball) -> Family:
        """A function of it, by the chain rule."""
        return Family(at, slope * self.by, self.reach, over)

    def __neg__(self) -> Family:
        return Family(-self.at, -self.by, self.reach, -self.over)

    def __add__(self, other: Any) -> Family:
        if isinstance(other, Family):
            return Family(self.at + other.at, self.by + other.by, self.reach, self.over + other.over)
        return Family(self.at + other, self.by, self.reach, self.over + other)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Family:
        found: Family = self + (-other)
        return found

    def __rsub__(self, other: Any) -> Family:
        found: Family = (-self) + other
        return found

    def __mul__(self, other: Any) -> Family:
        if isinstance(other, Family):
            by = self.by * other.over + self.over * other.by
            return Family(self.at * other.at, by, self.reach, self.over * other.over)
        return Family(self.at * other, self.by * other, self.reach, self.over * other)

    __rmul__ = __mul__

    def inverse(self) -> Family:
        """1/q."""
        require(not self.over.contains(0), "a divisor is not zero")
        over = 1 / self.over
        return self._through(1 / self.at, over, -over * over)

    def __truediv__(self, other: Any) -> Family:
        found: Family = self * (other.inverse() if isinstance(other, Family) else 1 / other)
        return found

    def __rtruediv__(self, other: Any) -> Family:
        found: Family = self.inverse() * other
        return found

    def __pow__(self, power: int) -> Family:
        slope = power * self.over ** (power - 1) if power else arb(0)
        return self._through(self.at**power, self.over**power, slope)

    def __abs__(self) -> Family:
        if self.over < 0:
            return -self
        if self.over > 0:
            return self
        return Family(abs(self.at), symmetric(self.by), self.reach, abs(self.over))

    def sqrt(self) -> Family:
        """√q."""
        require(bool(self.over > 0), "what a root is taken of is positive")
        over = self.over.sqrt()
        return self._through(self.at.sqrt(), over, 1 / (2 * over))

    def sin_cos(self) -> tuple[Family, Family]:
        """Sine and cosine."""
        (sine, cosine), (s, c) = self.at.sin_cos(), self.over.sin_cos()
        return self._through(sine, s, c), self._through(cosine, c, -s)

    def sin(self) -> Family:
        """Sine."""
        return self.sin_cos()[0]

    def cos(self) -> Family:
        """Cosine."""
        return self.sin_cos()[1]

    def __gt__(self, other: Any) -> bool:
        return bool((self - other).over > 0)

    def __lt__(self, other: Any) -> bool:
        return bool((self - other).over < 0)

    def __ge__(self, other: Any) -> bool:
        return bool((self - other).over >= 0)

    def __le__(self, other: Any) -> bool:
        return bool((self - other).over <= 0)

    def is_zero(self) -> bool:
        """Return True if it is zero for all motions."""
        return bool(self.over.is_zero())


Pick = Callable[[Any], Ball]


def middle(value: Any) -> Ball:
    """Of the motion in the middle."""
    return value.at if isinstance(value, Family) else value


def every(value: Any) -> Ball:
    """Of all motions."""
    return value.over if isinstance(value, Family) else value


def change(value: Any) -> Ball:
    """The derivative by the first θ̇."""
    return value.by if isinstance(value, Family) else arb(0)
