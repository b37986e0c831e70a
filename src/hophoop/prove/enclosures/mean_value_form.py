"""Quantities over a box of parameters to first order: a ball alone does not keep how its parts depend on the parameters.

A `Varied` has its value at the centre of the box, all its values over the box, and its derivatives over the box. By the
mean value theorem the second lies in the first plus the third times the distance from the centre, which is narrower than what
balls alone give by one order of the width of the box. A plain ball next to it is a number that is unknown within it
but is the same for all parameters, or for one that is treated so: the statements hold for each such number.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, Jet, Undecided, arb, ball_type, intersection, symmetric
from hophoop.prove.enclosures.roots import Root, exact, refined


class Varied:
    """A number, or a power series, over a box.

    Parameters
    ----------
    at : Ball or Series
        At the centre of the box.
    over : Ball or Series
        Over the box.
    by : tuple of Ball or Series
        Derivatives over the box, one for each parameter, whose unit is half the width of the box.
    """

    __slots__ = ("at", "by", "over")

    def __init__(self, at: Any, over: Any, by: tuple[Any, ...]) -> None:
        self.at, self.by, self.over = at, by, over
        if isinstance(over, ball_type()):
            reach = arb(0)
            for one in by:
                reach += one.abs_upper()
            self.over = intersection(over, at + symmetric(reach))

    # --- arithmetic ------------------------------------------------------------------------------

    def __neg__(self) -> Varied:
        return Varied(-self.at, -self.over, tuple(-one for one in self.by))

    def __add__(self, other: Any) -> Varied:
        if isinstance(other, Varied):
            by = tuple(a + b for a, b in zip(self.by, other.by, strict=True))
            return Varied(self.at + other.at, self.over + other.over, by)
        return Varied(self.at + other, self.over + other, self.by)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Varied:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Varied:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Varied:
        if isinstance(other, Varied):
            by = tuple(a * other.over + self.over * b for a, b in zip(self.by, other.by, strict=True))
            return Varied(self.at * other.at, self.over * other.over, by)
        return Varied(self.at * other, self.over * other, tuple(one * other for one in self.by))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Varied:
        if not isinstance(other, Varied):
            return Varied(self.at / other, self.over / other, tuple(one / other for one in self.by))
        over = self.over / other.over
        by = tuple((a - over * b) / other.over for a, b in zip(self.by, other.by, strict=True))
        return Varied(self.at / other.at, over, by)

    def __rtruediv__(self, other: Any) -> Varied:
        over = other / self.over
        return Varied(other / self.at, over, tuple(-(over * one) / self.over for one in self.by))

    def __abs__(self) -> Varied:
        if self.over > 0:
            return self
        if self.over < 0:
            return -self
        return Varied(abs(self.at), abs(self.over), tuple(symmetric(one) for one in self.by))

    # --- functions -------------------------------------------------------------------------------

    def _chain(self, at: Any, over: Any, slope: Any) -> Varied:
        return Varied(at, over, tuple(slope * one for one in self.by))

    def sqrt(self) -> Varied:
        """√."""
        over = self.over.sqrt()
        return self._chain(self.at.sqrt(), over, 1 / (2 * over))

    def rsqrt(self) -> Varied:
        """1/√."""
        over = self.over.rsqrt()
        return self._chain(self.at.rsqrt(), over, over / (-2 * self.over))

    def exp(self) -> Varied:
        """e^."""
        over = self.over.exp()
        return self._chain(self.at.exp(), over, over)

    def sin_cos(self) -> tuple[Varied, Varied]:
        """Sine and cosine."""
        (s0, c0), (s, c) = self.at.sin_cos(), self.over.sin_cos()
        return self._chain(s0, s, c), self._chain(c0, c, -s)

    def sin(self) -> Varied:
        """Sine."""
        return self.sin_cos()[0]

    def cos(self) -> Varied:
        """Cosine."""
        return self.sin_cos()[1]

    def integral(self) -> Varied:
        """Of a power series."""
        at, whole, *by = (_as_series(part).integral() for part in (self.at, self.over, *self.by))
        return Varied(at, whole, tuple(by))

    def coeffs(self) -> list[Varied]:
        """Coefficients of a power series."""
        parts = [list(_as_series(part).coeffs()) for part in (self.at, self.over, *self.by)]
        count = max(map(len, parts))
        padded = [part + [arb(0)] * (count - len(part)) for part in parts]
        return [Varied(at, over, tuple(by)) for at, over, *by in zip(*padded, strict=True)]

    # --- what is certain over the box ------------------------------------------------------------

    def __lt__(self, other: Any) -> bool:
        return bool((self - other).over < 0)

    def __gt__(self, other: Any) -> bool:
        return bool((self - other).over > 0)

    def __le__(self, other: Any) -> bool:
        return bool((self - other).over <= 0)

    def __ge__(self, other: Any) -> bool:
        return bool((self - other).over >= 0)

    def is_zero(self) -> bool:
        """Return True if it is exactly 0 for all parameters."""
        return bool(self.over.is_zero())

    def mid(self) -> Ball:
        """A number near the value at the centre."""
        return self.at.mid()

    def lower(self) -> Ball:
        """The least value over the box."""
        return self.over.lower()

    def upper(self) -> Ball:
        """The maximum over the box."""
        return self.over.upper()

    def abs_lower(self) -> Ball:
        """A bound of the size from below."""
        return self.over.abs_lower()

    def abs_upper(self) -> Ball:
        """A bound of the size from above."""
        return self.over.abs_upper()

    def contains(self, other: Any) -> bool:
        """Return True if a number may be its value."""
        return bool(self.over.contains(other))


def _as_series(part: Any) -> Any:
    return part if hasattr(part, "coeffs") else _flint.series([part])


def parameter(low: float, high: float, index: int, count: int) -> Varied:
    """One of the parameters of a box."""
    whole = arb(low).union(arb(high))
    return Varied(whole.mid(), whole, tuple(whole.rad() if k == index else arb(0) for k in range(count)))


def over(value: Any) -> Any:
    """All values over the box, as a ball."""
    return value.over if isinstance(value, Varied) else value


def at_centre(value: Any) -> Any:
    """The value at the centre of the box."""
    return value.at if isinstance(value, Varied) else value


def derivatives(value: Any, count: int) -> tuple[Any, ...]:
    """The derivatives over the box, which a plain ball has not."""
    return value.by if isinstance(value, Varied) else (arb(0),) * count


def count_of(*values: Any) -> int:
    """The number of parameters that vary in any of these: 0 if all are plain."""
    return next((len(value.by) for value in values if isinstance(value, Varied)), 0)


def series(coefficients: list[Any]) -> Any:
    """A power series, of which some coefficients may vary."""
    count = count_of(*coefficients)
    if not count:
        return _flint.series(coefficients)
    parts = [_flint.series([pick(one) for one in coefficients]) for pick in (at_centre, over)]
    by = zip(*(derivatives(one, count) for one in coefficients), strict=True)
    return Varied(parts[0], parts[1], tuple(_flint.series(list(one)) for one in by))


def polynomial(values: Jet) -> Callable[[Ball], Any]:
    """A polynomial, of which the coefficients may vary, as a function of a plain number."""
    count = count_of(*values)
    if not count:
        return lambda x: _flint.polynomial(values, x)
    make = _flint.arb_poly
    at, whole = make([at_centre(one) for one in values]), make([over(one) for one in values])
    by = [make([derivatives(one, count)[k] for one in values]) for k in range(count)]
    return lambda x: Varied(at(x), whole(x), tuple(one(x) for one in by))


def moving(function: Callable[[Ball], Any], x: Any, rate: Callable[[Ball], Ball]) -> Any:
    """A function of x at an x that varies; `rate` is its derivative."""
    if not isinstance(x, Varied):
        return function(x)
    whole, slope = function(x.over), over(rate(x.over))
    by = tuple(a + slope * b for a, b in zip(derivatives(whole, len(x.by)), x.by, strict=True))
    return Varied(at_centre(function(x.at)), over(whole), by)


def common(a: Any, b: Any) -> Any:
    """The intersection of two enclosures of one number."""
    if isinstance(a, Varied) and isinstance(b, Varied):
        by = tuple(intersection(one, other) for one, other in zip(a.by, b.by, strict=True))
        return Varied(intersection(a.at, b.at), intersection(a.over, b.over), by)
    return intersection(a, b)


def ranges(jets: Sequence[Jet]) -> list[Jet]:
    """Jets as plain balls."""
    return [[over(value) for value in jet] for jet in jets]


def located(evaluate: Callable[[Ball, int], Sequence[Jet]], root: Root) -> Any:
    """A root as it varies: dx/dp = −(∂f/∂p)/(∂f/∂x)."""
    value, slope = evaluate(root.x, 2)[root.index]
    if not isinstance(value, Varied):
        return root.x
    steep, by = over(slope), value.by
    bent = True
    try:  # both by the mean value theorem in x too
        bend = over(evaluate(root.x, 3)[root.index][2])
        middle, here = evaluate(exact(root.x), 2)[root.index]
    except Undecided:
        bent = False
    else:
        way, count = root.x - exact(root.x), len(by)
        steep = intersection(steep, over(here) + 2 * bend * way)
        slants = zip(derivatives(middle, count), derivatives(slope, count), strict=True)
        by = tuple(intersection(one, a + b * way) for one, (a, b) in zip(by, slants, strict=True))
    by = tuple(-one / steep for one in by)

    def centre(x: Ball, terms: int) -> list[Jet]:
        return [[at_centre(one) for one in jet] for jet in evaluate(x, terms)]

    return Varied(refined(centre, root.index, root.low, root.high, bent), root.x, by)
