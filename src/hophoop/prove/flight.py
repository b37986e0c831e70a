"""Flight: the gap is a parabola minus a cosine, in closed form."""

from __future__ import annotations

from typing import Any

from hophoop.prove.formulas import State
from hophoop.prove.numbers import Number, Unclear, arb, ball, raw, sign
from hophoop.prove.roots import Function, first_root, positive_until


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
        self.s, self.c = body.sine_cosine(begin.th)

    def gap(self, tau: Any, terms: int) -> list[Any]:
        """Taylor coefficients of the gap on a ball of times; of the fourth derivative on they are those of the cosine."""
        body, begin, square = self.body, self.begin, raw(self.begin.om * self.begin.om)
        body.look_at_clock()
        rates = body.of.flight_rates(body, self.s, self.c, begin.om, begin.y, begin.vn, self.f_n, ball(tau))
        found = [raw(one) for one in rates]
        found.append(-square * (found[2] + raw(body.gn)))
        return [one / arb(k + 1).gamma() for k, one in enumerate(found[:terms])]

    def at(self, tau: Any) -> State:
        """The state after a time."""
        body, begin = self.body, self.begin
        along, vt = body.of.flight_displacement(body, begin.vt, begin.om, self.s, self.c, ball(tau))
        y, vn = (ball(one) for one in self.gap(tau, 2))
        t, th = begin.t + ball(tau), begin.th + begin.om * ball(tau)
        return begin._replace(t=t, x=begin.x + along, y=y, th=th, vt=vt, vn=vn)

    def fly(self, left: Any) -> tuple[State, bool, State | None]:
        """(the state before the landing or at the end of the time, whether it lands, the apex)."""
        end = left.upper()
        landing = first_root(self.gap, positive_until(self.gap, self.zeros, end) if self.zeros else arb(0), end)
        last = landing[0].union(landing[1]) if landing else left
        if landing and not last < left:
            raise Unclear("the rim lands before the end of the time")
        tops = self.tops(landing[0] if landing else end)
        if not all(top < last for top in tops):
            raise Unclear("an apex comes before the end of the time")
        after = self.at(last)
        if landing:
            after = after._replace(y=ball(0), vn=self.landing_rate(ball(last)))
            if not after.vn < 0:
                raise Unclear("the rim does not land with ẏ = 0")
        return after, landing is not None, self.highest(tops)

    def landing_rate(self, tau: Number) -> Number:
        """ẏ at the landing: as the gap is zero, f_n τ follows from v_n, and errors do not grow from bounce to bounce."""
        gap, rate, _, _ = self.body.of.flight_rates(self.body, self.s, self.c, self.begin.om, 0, 0, 0, tau)
        return rate - self.begin.vn - 2 * (gap + self.begin.y) / tau

    def tops(self, end: Any) -> list[Any]:
        """The times at which the gap has a maximum."""
        body, begin, found = self.body, self.begin, []
        if begin.vn == 0 and self.f_n == 0 and (begin.om == 0 or body.eps == 0):  # it is constant
            return []
        zeros = max(self.zeros - 1, 1 if begin.vn == 0 else 0)
        way = 1 if self.zeros else sign(ball(self.gap(arb(0), zeros + 2)[zeros + 1]))
        if way == 0:
            raise Unclear("the gap rises or falls at the start of a flight")

        def rate(way: int) -> Function:
            return lambda tau, terms: [way * k * one for k, one in enumerate(self.gap(tau, terms + 1))][1:]

        time = positive_until(rate(way), zeros, end) if zeros else arb(0)
        while bracket := first_root(rate(way), time, end):
            if way > 0:
                found.append(bracket[0].union(bracket[1]))
            way, time = -way, bracket[1]
        return found

    def highest(self, tops: list[Any]) -> State | None:
        """The state at the highest of the tops, if it is higher than the start; two that are equally high are no apex."""
        states = [self.at(top) for top in tops]
        if not states:
            return None
        best = max(states, key=lambda one: float(raw(one.y).mid()))
        if not all(one is best or one.y < best.y for one in states):
            raise Unclear("one top of a flight is the highest")
        return best._replace(vn=ball(0)) if best.y > self.begin.y else None
