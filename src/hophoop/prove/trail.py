"""Polynomials for θ̇² and t along a phase, as a certificate records them: Taylor series one after another.

None of it has to be trusted: the checker puts the polynomials into the equations. So they are made of middles of balls, and
what the series leave out is not bounded.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from hophoop.prove._flint import Ball, arb, bits, coefficients, order, polynomial, precision, series
from hophoop.prove.checker.equations import Equations, State

WIDE = 1e-8  # half width of a bracket, where nothing else is near
WIDEST = 0.5  # rad, of a polynomial
TURN_REACH = 0.25  # of w² about a turning point
BITS_A_TERM = 1.5
GUARD = 6  # bits of a polynomial beyond its last term
SPARE = 40  # bits of the series beyond those of the polynomials
PAST = 1.0625  # of the way to a turning point, that its polynomial goes
LEFT = 0.875  # of w about a turning point, where the next panel begins


class Trail:
    """The panels of a phase, from its start to the event that ends it.

    Parameters
    ----------
    equations : Equations
        Of the phase, with the couple of its direction.
    sigma : int
        0 in rolling with resistance.
    state : State
        At the start.
    way : int
        Direction of θ̇.
    bits : int
        Of the polynomials.
    wide : float
        Half width of brackets.
    """

    def __init__(self, equations: Equations, sigma: int, state: State, way: int, bits: int, wide: float) -> None:
        self.equations, self.sigma, self.way, self.bits, self.wide = equations, sigma, way, bits, wide
        self.terms = int(bits / BITS_A_TERM) + 8
        self.panels: list[dict[str, Any]] = []
        self.begin = state.th.mid()
        self.at = float(self.begin)  # up to where the panels go
        self.about: tuple[Ball, list[Ball]] | None = None  # the turning point that the last panel is about, and θ̇²/w² there
        if state.om.is_zero():
            self.way = -way  # the panel about a start with θ̇ = 0 has the direction that would lead there
            self._about(self.begin)
            self.way = way
        else:
            with precision(2 * bits):  # the panels begin at a double
                near = self._squares(self.begin, (state.om * state.om).mid(), 1, 8 + bits // 40)
                self.u = polynomial(near, arb(self.at) - self.begin).mid()

    def turn(self, goal: Ball, ends: bool) -> None:
        """Go up to a turning point near an angle, and pass it unless the record ends there."""
        self._leave_turn()
        while True:
            left = float(self.way * (goal - self.at))
            squares = self._squares(arb(self.at), self.u, self.way, self.terms)
            if left < TURN_REACH and left * PAST < extent(squares, self.bits + GUARD):
                with precision(self.bits + SPARE):
                    x = _zero(squares, arb(left), self.bits.bit_length())
                    turn = (arb(self.at) + self.way * x).mid()
                reach = float(x) * PAST
                wide = min(float(x) / 32.0, 100.0 * WIDE)
                link = {"centre": self.at, "reach": reach, "u": packed(squares, reach, self.bits), "bracket": around(x, wide)}
                one = self._about(turn)
                if float(x) < one["reach"]:
                    one |= {"link": link} | ({"ends": "turn"} if ends else {})
                    self.way = -self.way
                    return
                self.panels.pop()
                self.about = None
            self._step(goal, 0.5 * left)

    def to(self, goal: Ball) -> None:
        """Go on to the end of the phase near an angle."""
        wide = min(self.wide, 0.25 * abs(float(goal - self.begin))) or self.wide
        if self.about is not None:
            turn, one = self.about[0], self.panels[-1]
            w = (self.way * (goal - turn)).max(arb(0)).sqrt()
            if float(w) + WIDE < math.sqrt(one["reach"]):
                one |= {"ends": "after", "bracket": around(w, min(self.wide, 0.25 * float(w)) or self.wide)}
                return
            self._leave_turn()
        while not self._step(goal, math.inf):
            pass
        one = self.panels[-1]
        del one["to"]
        one["bracket"] = around(self.way * (goal - one["centre"]), wide)

    def record(self, mode: str, what: str) -> dict[str, Any]:
        """The record of the phase."""
        return {"mode": mode, "what": what, "bits": self.bits, "panels": self.panels}

    # --- panels --------------------------------------------------------------------------------

    def _squares(self, centre: Ball, u: Ball, way: int, terms: int) -> list[Ball]:
        """θ̇² about an angle, by the integrating factor of its linear equation."""
        with precision(self.bits + SPARE), order(terms):
            s, c = series([centre, way]).sin_cos()
            divisor, grow, push = self.equations.linear(s, c, self.sigma)
            spread = (series([0]) + -2 * way * grow / divisor).integral().exp()
            found = ((2 * way * push / divisor * spread).integral() + u) / spread
            return [one.mid() for one in coefficients(series([0]) + found, terms)]

    def _panel(self, centre: float, u: Ball) -> tuple[dict[str, Any], list[Ball]]:
        """A panel about an angle, and its θ̇²."""
        squares = self._squares(arb(centre), u, self.way, self.terms)
        with precision(self.bits + SPARE), order(self.terms):
            times = [one.mid() for one in coefficients(series(squares).rsqrt().integral(), self.terms)]
        reach = min(extent(squares, self.bits + GUARD), extent(times, self.bits + GUARD))
        found = {"centre": centre, "reach": reach}
        return found | {"u": packed(squares, reach, self.bits), "t": packed(times, reach, self.bits)}, squares

    def _widest(self, goal: Ball) -> tuple[dict[str, Any], list[Ball]]:
        """The widest panel that reaches back to where the panels go."""
        first, squares = self._panel(self.at, self.u)
        for share in (0.9, 0.6):
            ahead = min(share * first["reach"], float(self.way * (goal - self.at)))
            if ahead <= 0.0:
                break
            centre = self.at + self.way * ahead
            other, others = self._panel(centre, self._value(squares, self.at, centre))
            if other["reach"] >= abs(centre - self.at) * (1.0 + 1e-9):
                return other, others
        return first, squares

    def _value(self, squares: list[Ball], centre: float, angle: float) -> Ball:
        """θ̇² at an angle."""
        with precision(self.bits + SPARE):
            return polynomial(squares, self.way * (arb(angle) - centre)).mid()

    def _step(self, goal: Ball, most: float) -> bool:
        """One more panel towards an angle, no further than asked; return True if it is reached."""
        one, squares = self._widest(goal)
        centre, begin = one["centre"], self.way * (self.at - one["centre"])
        to, last = float(self.way * (goal - centre)), one["reach"] - 4.0 * WIDE
        farthest = min(last, begin + most)
        reached = bool(to <= farthest)
        one["to"] = to if reached else farthest if last > begin else 0.5 * (one["reach"] + begin)
        self.panels.append(one)
        self.at = centre + self.way * one["to"]
        self.u = self._value(squares, centre, self.at)
        return reached

    def _about(self, turn: Ball) -> dict[str, Any]:
        """A panel about a turning point; `way` is the direction before it."""
        ratio = self._squares(turn, arb(0), -self.way, self.terms + 1)[1:]
        with precision(self.bits + SPARE), order(self.terms):
            rates = coefficients(series(ratio).rsqrt(), self.terms)
            times = [(2 * rate / (2 * k + 1)).mid() for k, rate in enumerate(rates)]
        reach = min(TURN_REACH, extent(ratio, self.bits + GUARD), extent(times, self.bits + GUARD))
        one = {"reach": reach, "g": packed(ratio, reach, self.bits), "h": packed(times, reach, self.bits)}
        self.panels.append(one)
        self.about = turn, ratio
        return one

    def _leave_turn(self) -> None:
        """Leave the turning point that the last panel is about."""
        if self.about is None:
            return
        (turn, ratio), one = self.about, self.panels[-1]
        one["to"] = LEFT * math.sqrt(one["reach"])
        with precision(2 * self.bits):
            self.at = float(turn + self.way * arb(one["to"]) ** 2)
            s = self.way * (arb(self.at) - turn)
            self.u = (s * polynomial(ratio, s)).mid()
        self.about = None


def _zero(values: list[Ball], x: Ball, steps: int) -> Ball:
    """A zero of a polynomial by Newton's method."""
    slopes = [k * one for k, one in enumerate(values)][1:]
    for _ in range(steps):
        x = (x - polynomial(values, x) / polynomial(slopes, x)).mid()
    return x


def around(x: Ball, wide: float) -> list[str]:
    """A bracket about a place."""
    digits = max(20, bits() * 3 // 10)
    return [(x + way * arb(wide)).mid().str(digits, radius=False) for way in (-1, 1)]


def extent(values: list[Ball], precise: int) -> float:
    """The distance up to which the last terms of a series stay below 2^−precise."""
    found, size = WIDEST, len(values) - 1
    for k in range(size - 3, size + 1):
        value = abs(values[k].mid())
        if value > 0:
            found = min(found, 2.0 ** (-(precise + float(value.log()) / math.log(2)) / k))
    return found


def packed(values: list[Ball], reach: float, precise: int) -> str:
    """A polynomial in x/reach, to 2^−precise each, as integers to base 36."""
    numbers = []
    with precision(2 * precise + 300):  # so that the middle is rounded to an integer and to no other number
        scale, step = arb(2) ** precise, arb(reach)
        for k, value in enumerate(values):
            whole = ((value.mid() * scale * step**k).mid() + arb(0.5)).floor()
            numbers.append(int(whole.unique_fmpz()))
    while len(numbers) > 1 and numbers[-1] == 0:
        numbers.pop()
    return " ".join(np.base_repr(one, 36).lower() for one in numbers)
