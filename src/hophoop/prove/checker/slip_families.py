"""Slip of a family of motions, stretch by stretch: Taylor polynomials with Lagrange's remainder.

By θ, u = θ̇² obeys u′ = A u + B, and v_t obeys v_t′ = g = v̇_t/√u. A and B are the same for all motions, so that a change of u
spreads by Φ = exp ∫ A alone, and one of v_t by ∫ ∂g/∂u Φ. No time is asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from hophoop.prove._flint import Ball, Jet, Series, arb, coefficients, order, polynomial, series
from hophoop.prove.checker.equations import Equations
from hophoop.prove.checker.family import Family, Pick, change, every, middle
from hophoop.prove.checker.intervals import require

TRIES = 30


class Field:
    """The equations of slip in a direction as functions of θ."""

    def __init__(self, equations: Equations, sigma: int) -> None:
        self.equations, self.sigma = equations, sigma

    def rates(self, s: Any, c: Any) -> tuple[Any, Any]:
        """(A, B)."""
        divisor, grow, push = self.equations.linear(s, c, self.sigma)
        return 2 * grow / divisor, 2 * push / divisor

    def sliding(self, s: Any, c: Any) -> tuple[Any, Any]:
        """(p, q) of v̇_t = p + q u."""
        zero = s * 0
        still = self.equations.contact(s, c, zero, self.sigma).slip
        return still, self.equations.contact(s, c, zero + 1, self.sigma).slip - still

    def slope(self, th: Any, u: Any) -> Any:
        """u′."""
        grow, push = self.rates(*th.sin_cos())
        return grow * u + push

    def pull(self, th: Any, u: Any) -> Any:
        """g."""
        still, turned = self.sliding(*th.sin_cos())
        return (still + turned * u) / u.sqrt()

    def pull_by(self, th: Ball, u: Ball) -> Ball:
        """∂g/∂u."""
        still, turned = self.sliding(*th.sin_cos())
        return (turned * u - still) / (2 * u * u.sqrt())

    def holds(self, th: Ball) -> None:
        """Refuse unless slip has a force that pushes: κ p_σ > 0."""
        s, c = th.sin_cos()
        divisor = self.equations.contact(s, c, arb(0), self.sigma).divisor
        require(bool(divisor > 0), "p_σ is positive in slip")

    def enclosed(self, th: Ball, u: Ball, stretch: Ball) -> Ball:
        """u on a stretch of angles from where it is known; `th` holds all of the stretch."""
        self.holds(th)
        whole = u
        for _ in range(TRIES):
            found = u + stretch * self.slope(th, whole)
            if whole.contains(found):
                require(bool(found > 0), "θ̇ stays away from zero in slip")
                return found.union(u)
            whole = whole.union(u + 1.25 * stretch * self.slope(th, whole)).union(found)
        require(False, "θ̇ on a stretch of slip is enclosed")
        return whole

    def series(self, th: Ball, u: list[Ball], terms: int) -> tuple[Series, list[tuple[Series, Series, Series]]]:
        """(Φ, and for each u (u, g, ∂g/∂u Φ)) as series from an angle; called within `order`."""
        s, c = series([th, 1]).sin_cos()
        grow, push = self.rates(s, c)
        spread = (series([0]) + grow).integral().exp()
        driven = (push / spread).integral()
        still, turned = self.sliding(s, c)
        found = []
        for one in u:
            square = spread * (driven + one)
            slow = (series([0]) + square).rsqrt()
            found.append((square, (still + turned * square) * slow, (turned * square - still) * slow**3 / 2 * spread))
        return spread, found


class Stretch:
    """Slip of all motions on angles about an exact one.

    Parameters
    ----------
    field : Field
    centre : Ball
        Exact.
    u, v : Family
        θ̇² and v_t there.
    begin, end : Ball
        Of the angles from there.
    terms : int
    """

    def __init__(self, field: Field, centre: Ball, u: Family, v: Family, begin: Ball, end: Ball, terms: int) -> None:
        self.field, self.centre, self.u, self.v, self.terms = field, centre, u, v, terms
        way = begin.union(end).union(arb(0))
        whole = centre + way
        self.most = field.enclosed(whole, u.over, way)
        with order(terms):
            spread, (one, all_) = field.series(centre, [u.at, u.over], terms)
            self.spread = coefficients(spread, terms)
            self.squares = coefficients(series([0]) + one[0], terms)
            self.speeds = coefficients(one[1].integral(), terms)
            self.carried = coefficients(all_[2].integral(), terms)
        grown = (field.rates(*whole.sin_cos())[0] * way).exp()
        with order(terms + 1):  # Lagrange: the next term, somewhere on the stretch
            spread, (all_,) = field.series(whole, [self.most], terms + 1)
            self.spread.append(grown * coefficients(spread, terms + 1)[terms])
            self.squares.append(coefficients(series([0]) + all_[0], terms + 1)[terms])
            self.speeds.append(coefficients(all_[1].integral(), terms + 1)[terms])
            self.carried.append(grown * coefficients(all_[2].integral(), terms + 1)[terms])

    def square(self, x: Ball) -> Family:
        """θ̇² at a fixed angle."""
        return Family(polynomial(self.squares, x), polynomial(self.spread, x) * self.u.by, self.u.reach, self.most)

    def velocity(self, x: Ball) -> Family:
        """v_t at a fixed angle."""
        by = self.v.by + polynomial(self.carried, x) * self.u.by
        return Family(self.v.at + polynomial(self.speeds, x), by, self.v.reach)

    def rest(self, x: Ball) -> Ball:
        """Bound of the remainders up to a distance."""
        return abs(x) ** self.terms * abs(self.squares[-1]).max(abs(self.speeds[-1])).abs_upper()

    def functions(self, pick: Pick) -> Callable[[Ball, int], list[Jet]]:
        """(−f_n, σ v_t) as series in x: what must stay positive; of the motion in the middle or of all."""
        equations, sigma = self.field.equations, self.field.sigma

        def found(x: Ball, terms: int) -> list[Jet]:
            exact = x.mid()
            way, th = x - exact, self.centre + x
            square, here = pick(self.square(exact)), sigma * pick(self.velocity(exact))
            if not x.is_exact():
                rough = square + self.field.slope(th, self.most) * way
                square = square + self.field.slope(th, rough) * way
            require(bool(square > 0), "θ̇ stays away from zero in slip")
            with order(terms):
                z = series([th, 1])
                s, c = z.sin_cos()
                u = equations.square(th, square, 1, sigma, terms - 1)
                contact = equations.contact(s, c, u, sigma)
                free = coefficients(series([0]) - contact.free, terms)
                rate = coefficients(sigma * contact.slip * (series([0]) + u).rsqrt(), terms)
            return [free, [here + rate[0] * way] + [rate[k - 1] / k for k in range(1, terms)]]

        return found

    def crossing(self, index: int, x: Ball, exact: Ball, reach: Ball) -> tuple[Family, Family, Family]:
        """(θ, θ̇², v_t) where one of the functions vanishes: at x for all motions, at `exact` for the middle one."""
        field, th = self.field, self.centre + x
        u, v = self.square(x.mid()), self.velocity(x.mid())
        whole = u.over + field.slope(th, self.most) * (x - x.mid())
        whole = whole.intersection(self.most)
        u_by, v_by = self.square(x).by, self.velocity(x).by
        slope, pull = field.slope(th, whole), field.pull(th, whole)
        steep = self.functions(every)(x, 2)[index][1]
        if index:  # σ v_t
            by = -field.sigma * v_by / steep
        else:
            by = field.equations.eps * th.cos() * u_by / steep
        angle = Family(self.centre + exact, by, reach, th)
        squares, speeds = self._at(exact)
        return (
            angle,
            Family(squares, u_by + slope * by, reach, whole),
            Family(speeds, v_by + pull * by, reach, v.over + pull * (x - x.mid())),
        )

    def _at(self, x: Ball) -> tuple[Ball, Ball]:
        """(θ̇², v_t) of the motion in the middle, at a narrow ball."""
        field, th, way = self.field, self.centre + x, x - x.mid()
        square = middle(self.square(x.mid()))
        square = square + field.slope(th, square + field.slope(th, self.most) * way) * way
        return square, middle(self.velocity(x.mid())) + field.pull(th, square) * way


def moved(field: Field, th: Any, u: Any, v: Any, reach: Ball, drive: Ball | None) -> tuple[Ball, Family, Family]:
    """(an exact angle, θ̇² and v_t there) of slip that begins nearby, at an angle that differs from motion to motion.

    The slip of each motion goes on backwards to there. `drive` is ∂u/∂ω at a fixed angle, for slip that begins smoothly: its
    u′ and v_t′ are those of the rolling before, so that where it begins does not count.
    """
    centre = middle(th).mid()
    angles, squares = every(th), every(u)
    spread = centre - angles
    way = spread.union(arb(0))
    whole = angles.union(centre)
    most = field.enclosed(whole, squares, way)
    if drive is None:
        shift = change(u) - field.slope(angles, squares) * change(th)
        speed = change(v) - field.pull(angles, squares) * change(th)
    else:
        shift, speed = drive, change(v)
    carried = (field.rates(*whole.sin_cos())[0] * way).exp() * shift
    ahead = centre - middle(th)
    near = middle(th).union(centre)
    square = field.enclosed(near, middle(u), ahead.union(arb(0)))
    at_u = middle(u) + field.slope(near, square) * ahead
    at_v = middle(v) + field.pull(near, square) * ahead
    by_v = speed + way * field.pull_by(whole, most) * carried
    return centre, Family(at_u, carried, reach, most), Family(at_v, by_v, reach)
