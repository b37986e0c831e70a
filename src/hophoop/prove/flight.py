"""Flight: the gap is a parabola minus a cosine; its pieces are Taylor polynomials."""

from __future__ import annotations

import math
from typing import Any

from hophoop.prove.formulas import State
from hophoop.prove.models import Model, first_root
from hophoop.prove.numbers import Number, Unclear, arb, arb_poly, ball, precision, raw, sign

WIDEST, LONGEST, SLOWEST = 1.0, 1.0, 1e-3  # rad, and √(R/g), of a piece
MOST_TERMS = 2000
AMPLE = 4.0  # of a first estimate of the time of a short flight


class Flight:
    """A flight from a state.

    Parameters
    ----------
    body : Body
    begin : State
    after_slip : bool
        The flight begins with a lift-off from slip, where f_n = 0.
    """

    def __init__(self, body: Any, begin: State, after_slip: bool) -> None:
        self.body, self.begin = body, begin
        self.f_n, self.zeros = body.of.flight_start(body, begin, after_slip)
        self.rates, self.om = body.of.flight_rates, begin.om
        self.s, self.c = body.sine_cosine(begin.th)

    def jet(self, tau: Any, terms: int) -> list[Any]:
        """Taylor coefficients of the gap about a time; of the fourth derivative on they are those of the cosine."""
        body, begin = self.body, self.begin
        found = [raw(one) for one in self.rates(body, self.s, self.c, self.om, begin.y, begin.vn, self.f_n, ball(tau))]
        square = raw(self.om * self.om)
        if terms > 4:
            found.append(-square * (found[2] + raw(body.gn)))
        while len(found) < terms:
            found.append(-square * found[-2])
        if tau.is_zero():
            found[:3] = [raw(begin.y), raw(begin.vn), raw(self.f_n)]
        return [one / arb(k + 1).gamma() for k, one in enumerate(found[:terms])]

    def pieces(self, tau: Any, h: Any) -> tuple[list[Any], Any, Any]:
        """(coefficients of the gap in the part of [τ, τ + h], bounds of what they leave of the gap and of its rate)."""
        turn, terms = raw(abs(self.om * ball(h))), 5
        small = math.log2(max(float(turn.upper()), 1e-300))
        while small * terms - math.lgamma(terms) / math.log(2) > -precision() and terms < MOST_TERMS:
            terms += 1
        rest = raw(self.body.eps) * turn**terms / arb(terms).gamma()
        return [one * h**k for k, one in enumerate(self.jet(tau, terms))], rest / terms, rest

    def at(self, tau: Any) -> State:
        """The state after a time."""
        body, begin = self.body, self.begin
        along, vt = body.of.flight_displacement(body, begin.vt, begin.om, self.s, self.c, ball(tau))
        y, vn = (ball(one) for one in self.jet(tau, 2))
        t, th = begin.t + ball(tau), begin.th + begin.om * ball(tau)
        return begin._replace(t=t, x=begin.x + along, y=y, th=th, vt=vt, vn=vn)

    def fly(self, left: Any) -> tuple[State, bool, State | None]:
        """(the state before the landing or at the end of the time, whether it lands, the apex)."""
        tau, known, tops = arb(0), self.zeros, []
        way, rising = None, 0  # of the gap's rate, and how many of its derivatives vanish at the start
        while True:
            self.body.look_at_clock()
            h = arb(min(self.first(known), WIDEST / max(SLOWEST, abs(float(raw(self.om).mid()))), LONGEST))
            h = (h * (1 - arb(1) / precision())).mid()  # others at each precision: no event is at an end of all of them
            final = not h < left - tau
            values, rest, slower = self.pieces(tau, h)
            if known and not values[known] > 0:
                raise Unclear("the gap opens at the start of a flight")
            end = ((left - tau) / h).upper() if final else arb(1)
            bracket = first_root(modelled(values[known:], rest), arb(0), end)
            lands = bracket is not None
            end, whole = (bracket[0], bracket[0].union(bracket[1])) if bracket else (end, (left - tau) / h if final else arb(1))
            if way is None:
                rising = max(known - 1, 1 if self.begin.vn == 0 else 0)
                way = sign(ball(values[rising + 1])) if self.moves() else 0
                if way == 0 and self.moves():
                    raise Unclear("the gap rises or falls at the start of a flight")
            found, way = self._tops(values, slower, rising, way, end)
            tops += [tau + h * x for x in found]
            last = tau + h * whole
            if lands and final and not last < left:
                raise Unclear("the rim lands before the end of the time")
            if final and not lands and not all(top < left for top in tops):
                raise Unclear("an apex comes before the end of the time")
            if lands or final:
                break
            tau, known, rising = tau + h, 0, 0
        after = self.at(last)
        if lands:
            after = after._replace(y=ball(0), vn=self.landing_rate(ball(last)))
            if not after.vn < 0:
                raise Unclear("the rim does not land with ẏ = 0")
        return after, lands, self.highest(tops)

    def landing_rate(self, tau: Number) -> Number:
        """ẏ at the landing: as the gap is zero, f_n τ follows from v_n, and errors do not grow from bounce to bounce."""
        gap, rate, _, _ = self.rates(self.body, self.s, self.c, self.om, 0, 0, 0, tau)
        return rate - self.begin.vn - 2 * (gap + self.begin.y) / tau

    def first(self, known: int) -> float:
        """A time of the order of the landing's, where the flight is short; inf elsewhere."""
        if not known:
            return math.inf
        rise, fall = (float(one.mid()) for one in self.jet(arb(0), known + 2)[known:])
        return AMPLE * rise / -fall if rise > 0 > fall else math.inf

    def moves(self) -> bool:
        """Return True if the gap is not constant."""
        return not (self.begin.vn == 0 and self.f_n == 0 and (self.om == 0 or self.body.eps == 0))

    def _tops(self, values: list[Any], rest: Any, known: int, way: int, end: Any) -> tuple[list[Any], int]:
        """(parts of a piece where the gap is highest, sign of its rate at the end)."""
        rate = [k * one for k, one in enumerate(values)][1 + known :]
        found, begin = [], arb(0)
        while way:
            bracket = first_root(modelled([way * one for one in rate], rest), begin, end)
            if bracket is None:
                break
            if way > 0:
                found.append(bracket[0].union(bracket[1]))
            way, begin = -way, bracket[1]
        return found, way

    def highest(self, tops: list[Any]) -> State | None:
        """The state at the highest of the tops, if it is higher than the start; two that are equally high are no apex."""
        states = [self.at(top) for top in tops]
        if not states:
            return None
        best = max(states, key=lambda one: float(raw(one.y).mid()))
        if not all(one is best or one.y < best.y for one in states):
            raise Unclear("one top of a flight is the highest")
        return best._replace(vn=ball(0)) if best.y > self.begin.y else None


def modelled(values: list[Any], rest: Any) -> Model:
    """A model from coefficients and a bound of the rest."""
    lost = sum((one.rad() for one in values), arb(0))
    return Model(arb_poly([one.mid() for one in values]), rest + lost)
