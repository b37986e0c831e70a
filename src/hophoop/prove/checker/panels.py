"""Panels of a phase that a certificate names: their polynomials satisfy the equations up to a small residual.

With u' = b − a u and a polynomial U for which Π U' − … is at most η Π in size, abs(u − U) grows from its value at the
start by at most e^(αL) L η over a length L (Grönwall).
"""

from __future__ import annotations

from typing import Any

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, Jet, arb, coefficients, order, polynomial, series, symmetric
from hophoop.prove.checker.equations import Equations
from hophoop.prove.checker.intervals import require
from hophoop.prove.checker.phase_equations import Roll, Slip


def poly(text: str, reach: Ball, bits: int) -> list[Ball]:
    """Coefficients from base-36 integers in units of 2^−bits, of a polynomial in x/reach."""
    scale = arb(2) ** -bits
    return [arb(int(number, 36)) * scale / reach**k for k, number in enumerate(text.split())]


def number(value: Any) -> Ball:
    """An exact number, which JSON has as a double."""
    require(isinstance(value, float), "places in a certificate are numbers")
    return arb(value)


def largest(values: list[Ball], reach: Ball) -> Ball:
    """Bound of a polynomial on [−reach, reach]."""
    return polynomial([abs(value).abs_upper() for value in values], reach).abs_upper()


class Panel:
    """θ̇² = U ± e and t = T ± … on a stretch about a centre; `way` is the direction of growing x."""

    def __init__(self, phase: Slip | Roll, record: dict[str, Any], way: int, bits: int) -> None:
        self.phase, self.way = phase, way
        self.centre, self.reach = number(record["centre"]), number(record["reach"])
        self.value_terms = poly(record["u"], self.reach, bits)
        self.time_terms = poly(record["t"], self.reach, bits) if record.get("t") else None

    def angle(self, x: Ball) -> Ball:
        """θ."""
        return self.centre + self.way * x

    def starts(self, th: Ball, u: Ball, t: Ball, end: Ball) -> None:
        """Bound the errors on the way from an angle to another, from the residual of the equations."""
        model, sigma, reach = self.phase.equations, self.phase.sigma, self.reach
        x = self.way * (th - self.centre)
        length = (end - x).abs_upper()
        require(bool(abs(x).abs_upper() <= reach) and bool(abs(end).abs_upper() <= reach), "a panel reaches far enough")
        value = _flint.arb_poly(self.value_terms)
        rate = value.derivative()
        left, stiff = left_over(model, sigma, self.centre, self.way, reach, value, rate)
        eta = left / stiff.abs_lower()
        grown = growth(model, sigma, self.centre, self.way, x.union(end)).exp()
        first = abs(polynomial(self.value_terms, x) - u).abs_upper()
        self.error_u = symmetric(grown * (first + length * eta))
        if self.time_terms is None:
            return
        slow = _flint.arb_poly(self.time_terms).derivative()
        rest = largest(coefficients_of(slow * slow * value - 1), reach)
        speed = largest(coefficients_of(slow), reach)
        spoilt = rest + speed * speed * self.error_u.abs_upper()
        lowest = self.lowest(x.union(end))
        require(bool(spoilt < arb(1) / 2), "the time of a panel is its own")
        self.error_t = symmetric(length * spoilt * lowest.rsqrt())
        self.offset = t - polynomial(self.time_terms, x)

    def lowest(self, whole: Ball) -> Ball:
        """A positive bound of θ̇² from below on a stretch."""
        least = least_of([self.square(part).lower() for part in parts(whole)])
        require(bool(least > 0), "θ̇ stays away from zero on a panel")
        return least

    def square(self, x: Ball) -> Ball:
        """θ̇²; on an interval about its middle."""
        rough = polynomial(self.value_terms, x) + self.error_u
        if x.is_exact():
            return rough
        middle = x.mid()
        s, c = self.angle(x).sin_cos()
        slope = 2 * self.way * self.phase.equations.contact(s, c, rough, self.phase.sigma).alpha
        better = polynomial(self.value_terms, middle) + self.error_u + slope * (x - middle)
        return rough.intersection(better)

    def time(self, x: Ball) -> Ball:
        """t."""
        assert self.time_terms is not None
        middle = x.mid()
        at = self.offset + polynomial(self.time_terms, middle) + self.error_t
        return at if x.is_exact() else at + self.square(x).rsqrt() * (x - middle)

    def spin(self, x: Ball) -> Ball:
        """θ̇."""
        return self.way * self.square(x).sqrt()

    def watch(self, x: Ball, terms: int) -> list[Jet]:
        """What must stay positive, as series in x."""
        return self.phase.along(self, x, terms)

    def limits(self, x: Ball, t_end: Ball) -> Jet:
        """The time that remains."""
        return [t_end - self.time(x), -self.square(x).rsqrt()]


class TurnPanel(Panel):
    """About a turning point: θ = θ* − way w², θ̇² = w² G(w²), t = t* + w H(w²); polynomials in s = w²."""

    def __init__(self, phase: Slip | Roll, record: dict[str, Any], way: int, bits: int, turn: Ball) -> None:
        self.phase, self.way, self.centre = phase, way, turn
        self.reach = number(record["reach"])  # of s
        self.value_terms, self.time_terms = (poly(record[name], self.reach, bits) for name in ("g", "h"))
        model, sigma = phase.equations, phase.sigma
        ratio = _flint.arb_poly(self.value_terms)
        along = _flint.arb_poly([0, 1])
        value = along * ratio
        left, divisor = left_over(model, sigma, turn, -way, self.reach, value, value.derivative())
        grown = growth(model, sigma, turn, -way, arb(0).union(self.reach)).exp()
        self.error_g = symmetric(left / divisor.abs_lower() * grown)
        timing = _flint.arb_poly(self.time_terms)
        slow = timing + 2 * along * timing.derivative()
        rest = largest(coefficients_of(slow * slow * ratio - 4), self.reach)
        speed = largest(coefficients_of(slow), self.reach)
        spoilt = rest + speed * speed * self.error_g.abs_upper()
        least = least_of(
            [(polynomial(self.value_terms, part) + self.error_g).lower() for part in parts(arb(0).union(self.reach))]
        )
        require(bool(least > 0) and bool(spoilt < 1), "θ̇² has a simple zero at a turning point")
        self.error_t = symmetric(spoilt * least.rsqrt() * self.reach.sqrt())
        self.offset = arb(0)

    def over(self, w: Ball) -> Ball:
        """θ̇²/w²."""
        return polynomial(self.value_terms, w * w) + self.error_g

    def angle(self, w: Ball) -> Ball:
        """θ."""
        return self.centre - self.way * w * w

    def square(self, w: Ball) -> Ball:
        """θ̇²."""
        return w * w * self.over(w)

    def spin(self, w: Ball) -> Ball:
        """θ̇."""
        return -self.way * w * self.over(w).sqrt()

    def time(self, w: Ball) -> Ball:
        """t."""
        assert self.time_terms is not None
        middle = w.mid()
        at = self.offset + middle * polynomial(self.time_terms, middle * middle) + self.error_t
        return at if w.is_exact() else at + 2 * self.over(w).rsqrt() * (w - middle)

    def watch(self, w: Ball, terms: int) -> list[Jet]:
        """What must stay positive, with its slopes in w."""
        return self.phase.about(self, w, terms)

    def limits(self, w: Ball, t_end: Ball) -> Jet:
        """The time that remains."""
        return [t_end - self.time(w), -2 * self.over(w).rsqrt()]


def parts(whole: Ball, count: int = 16) -> list[Ball]:
    """Intervals that cover one."""
    low = whole.lower()
    width = (whole.upper() - low) / count
    return [(low + width * k).union(low + width * (k + 1)) for k in range(count)]


def least_of(values: list[Ball]) -> Ball:
    """The smallest."""
    least = values[0]
    for value in values[1:]:
        least = least.min(value)
    return least


def growth(model: Equations, sigma: int, centre: Ball, way: int, whole: Ball) -> Ball:
    """Bound of ∫ a over any part of a stretch, where the error e of θ̇² has e' = a e + …."""
    total, stretch = arb(0), parts(whole)
    for part in stretch:
        s, c = (centre + way * part).sin_cos()
        divisor, grow, _ = model.linear(s, c, sigma)
        total += (2 * way * grow / divisor).upper().max(arb(0))
    width = (whole.upper() - whole.lower()) / len(stretch)
    return (total * width).upper()


def left_over(model: Equations, sigma: int, centre: Ball, way: int, reach: Ball, value: Any, rate: Any) -> tuple[Ball, Ball]:
    """(bound of d (U' − 2 way θ̈) on the stretch, d there): zero for θ̇² itself; d θ̈ is linear in θ̇²."""
    terms = max(value.length() + 8, 24)
    tail = reach**terms / arb(terms).gamma() / terms * 2
    with order(terms):
        sine, cosine = (coefficients(one, terms) for one in series([centre, way]).sin_cos())
    sine[0], cosine[0] = sine[0] + symmetric(tail), cosine[0] + symmetric(tail)
    divisor, grow, push = model.linear(_flint.arb_poly(sine), _flint.arb_poly(cosine), sigma)
    left = divisor * rate - (grow * value + push) * (2 * way)
    sine_all, cosine_all = (centre + symmetric(reach)).sin_cos()
    stiff = model.linear(sine_all, cosine_all, sigma)[0]
    require(bool(stiff > 0), "what θ̈ is divided by stays positive")
    return largest(coefficients_of(left), reach), stiff


def coefficients_of(value: Any) -> list[Ball]:
    """Of an arb_poly."""
    return list(value.coeffs())
