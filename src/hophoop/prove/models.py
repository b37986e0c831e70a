"""Polynomials with a bound of what they leave out, on [0, 1] (Taylor models), and series in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from operator import mul
from typing import Any

from hophoop.prove.numbers import arb, arb_poly, arb_series, flint, precision, raw

Poly = Any  # a flint.arb_poly


def over_all(p: Poly) -> Any:
    """A ball of all values of a polynomial on [0, 1]."""
    return p(arb(0.5, 0.5))


def size(p: Poly) -> Any:
    """Bound of a polynomial on [0, 1]."""
    return over_all(p).abs_upper()


def cut(values: Sequence[Any]) -> tuple[Poly, Any]:
    """(polynomial of the middles of the leading coefficients, bound of the rest on [0, 1])."""
    cap = flint.ctx.cap
    lost = sum((one.rad() for one in values[:cap]), size(arb_poly(values[cap:])))
    return arb_poly([one.mid() for one in values[:cap]]), lost.abs_upper()


def padded(series: Any, terms: int) -> list[Any]:
    """So many coefficients."""
    values = series.coeffs()[:terms]
    return [*values, *[arb(0)] * (terms - len(values))]


class Model:
    """A function on [0, 1] within `e` of a polynomial `p`."""

    def __init__(self, p: Poly, e: Any = 0) -> None:
        self.p, self.e = p, arb(e).abs_upper()

    def __call__(self, x: Any, terms: int) -> list[Any]:
        """The value on a ball and, with more than one term, the slope of the polynomial there."""
        return [self.p(x) + arb(0, self.e), self.slope(x)] if terms > 1 else [self.p(x) + arb(0, self.e)]

    @cached_property
    def slope(self) -> Poly:
        """The derivative of the polynomial."""
        return self.p.derivative()

    @cached_property
    def size(self) -> Any:
        """Bound of the polynomial."""
        return size(self.p)

    def __add__(self, other: Any) -> Model:
        other = modelled(other)
        return Model(self.p + other.p, self.e + other.e)

    def __neg__(self) -> Model:
        return Model(-self.p, self.e)

    def __sub__(self, other: Any) -> Model:
        return self + -modelled(other)

    def __rsub__(self, other: Any) -> Model:
        return modelled(other) - self

    def __mul__(self, other: Any) -> Model:
        if not isinstance(other, Model):
            factor = arb(raw(other))
            return Model(self.p * factor, self.e * factor.abs_upper())
        p, lost = cut((self.p * other.p).coeffs())
        return Model(p, lost + self.size * other.e + (other.size + other.e) * self.e)

    def __truediv__(self, other: Any) -> Model:
        return self * (other.inverse() if isinstance(other, Model) else 1 / arb(raw(other)))

    def __rtruediv__(self, other: Any) -> Model:
        return modelled(other) * self.inverse()

    __radd__, __rmul__ = __add__, __mul__

    def inverse(self) -> Model:
        """1/f: where f q = 1 + r with r below 1/2, the reciprocal is within 2 r q of q."""
        p, _ = cut((1 / arb_series(self.p.coeffs())).coeffs())
        left = size(self.p * p - 1) + size(p) * self.e
        if not left < 0.5:
            raise ZeroDivisionError
        return Model(p, 2 * left * size(p))


def modelled(value: Any) -> Model:
    """A number or a model as a model."""
    return value if isinstance(value, Model) else Model(arb_poly([arb(raw(value))]))


def sine_cosine(angle: Poly) -> tuple[Model, Model]:
    """(sin, cos) of a polynomial.

    What s′ = c θ′ and c′ = −s θ′ leave, adds up over [0, 1], for a rotation changes no length.
    """
    s, c = (cut(one.coeffs())[0] for one in arb_series(angle.coeffs()).sin_cos())
    rate, zero = angle.derivative(), arb(0)
    sine, cosine = angle(zero).sin_cos()
    lost = size(s.derivative() - c * rate) + size(c.derivative() + s * rate)
    lost += (s(zero) - sine).abs_upper() + (c(zero) - cosine).abs_upper()
    return Model(s, lost), Model(c, lost)


# --- coefficients in time, one after the other: not rigorous, in integers of 2^−bits ------------------------------------


class Online:
    """A series of which each coefficient follows from those of its operands, its `parts`."""

    __slots__ = ("a", "following", "parts")

    def __init__(self, following: Callable[[int], int], *parts: Online) -> None:
        self.a: list[int] = []
        self.following, self.parts = following, parts

    def __add__(self, other: Any) -> Online:
        a = self.a
        if isinstance(other, Online):
            b = other.a
            return Online(lambda k: a[k] + b[k], self, other)
        c = _fixed(other)
        return Online(lambda k: a[k] if k else a[0] + c, self) if c else self

    def __mul__(self, other: Any) -> Online:
        a, bits = self.a, precision()
        if isinstance(other, Online):
            b = other.a
            return Online(lambda k: _last(a, b) >> bits, self, other)
        c = _fixed(other)
        return Online(lambda k: a[k] * c >> bits, self) if c else Online(lambda k: 0)

    def __neg__(self) -> Online:
        return self * -1

    def __sub__(self, other: Any) -> Online:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Online:
        return (-self).__add__(other)

    def __truediv__(self, other: Any) -> Online:
        if not isinstance(other, Online):
            return self.__mul__(1 / other)
        q: list[int] = []
        a, b, bits = self.a, other.a, precision()

        def following(k: int) -> int:
            if b[0] <= 0:
                raise ZeroDivisionError
            q.append(((a[k] << bits) - _last(b[1:], q)) // b[0])
            return q[k]

        return Online(following, self, other)

    __radd__, __rmul__ = __add__, __mul__

    def order(self, found: dict[Online, None]) -> None:
        """Put what it needs, and then itself, behind what is found already."""
        if self not in found:
            for part in self.parts:
                part.order(found)
            found[self] = None


def _fixed(value: Any) -> int:
    return int((arb(raw(value)).mid() * arb(2) ** precision()).floor().unique_fmpz())


def _last(a: Sequence[int], b: Sequence[int]) -> int:
    return sum(map(mul, a, reversed(b)))


def rates(alpha: Callable[[Any, Any, Any], Any], th: Any, om: Any, exponent: int, terms: int) -> list[Any]:
    """Coefficients of θ̇ in time from a state, by θ̈ = alpha(sin θ, cos θ, θ̇); 2^exponent is about the reach of the series."""
    bits = precision()
    sine, cosine = (_fixed(one) for one in th.sin_cos())
    w, s, c = start = tuple(Online(int) for _ in range(3))
    found = modelled_online(alpha(s, c, w))
    ordered: dict[Online, None] = dict.fromkeys(start)
    found.order(ordered)
    nodes = list(ordered)[3:]
    turning: list[int] = []
    w.a.append(_fixed(om))
    for k in range(terms - 1):
        s.a.append((_last(c.a, turning) >> bits) // k if k else sine)
        c.a.append(-(_last(s.a[:-1], turning) >> bits) // k if k else cosine)
        turning.append(w.a[k] << exponent if exponent > 0 else w.a[k] >> -exponent)
        for node in nodes:
            node.a.append(node.following(k))
        rate = found.a[k]
        w.a.append((rate << exponent if exponent > 0 else rate >> -exponent) // (k + 1))
    return [arb(one) * arb(2) ** (-bits - exponent * k) for k, one in enumerate(w.a)]


def modelled_online(value: Any) -> Online:
    """A number or a series as a series."""
    if isinstance(value, Online):
        return value
    c = _fixed(value)
    return Online(lambda k: 0 if k else c)
