"""Flight: the gap is a parabola minus a cosine, in closed form."""

from __future__ import annotations

from typing import Any

from hophoop.prove.formulas import State
from hophoop.prove.numbers import Number, Unclear, arb, ball, raw, root, sign
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
        force = 0 if after_slip else body.of.free_acceleration(body, self.s, self.c, begin.om * begin.om)[1]
        if self.zeros == 3 and force != 0:
            raise Unclear("the gap opens at the start of a flight")

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
        """(the state before the landing or at the end of the time, whether it lands, the apex if it is before the end)."""
        end = self.longest(left)
        landing = first_root(self.gap, positive_until(self.gap, self.zeros, end) if self.zeros else arb(0), end)
        landed = landing[0].union(landing[1]) if landing else end
        lands = landing is not None and first_is_less(landed, left, "the rim lands before the end of the time")
        after = self.at(landed if lands else left)
        if lands:
            after = after._replace(y=ball(0), vn=self.landing_rate(ball(landed)))
            if not after.vn < 0:
                raise Unclear("the rim does not land with ẏ = 0")
        top = self.highest(self.tops(landing[0] if landing else end))
        if top is None or not (lands or first_is_less(top, left, "an apex comes before the end of the time")):
            return after, lands, None
        return after, lands, self.at(top)._replace(vn=ball(0))

    def longest(self, left: Any) -> Any:
        """A time before which the rim lands; without gravity that which is left."""
        body, begin = self.body, self.begin
        if not body.gn > 0:
            return left.upper()
        rise = abs(begin.vn) + body.eps * abs(begin.om)
        reach = begin.y + 2 * body.eps + ball(1)
        return raw((rise + root(rise * rise + 2 * body.gn * reach)) / body.gn).upper()

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

    def highest(self, tops: list[Any]) -> Any:
        """The time of the highest of the tops, None if none is higher than the start; two that are equally high are no apex."""
        heights = [(self.at(top).y, top) for top in tops]
        if not heights:
            return None
        high, best = max(heights, key=lambda one: float(raw(one[0]).mid()))
        if not all(top is best or y < high for y, top in heights):
            raise Unclear("one top of a flight is the highest")
        return best if high > self.begin.y else None


def first_is_less(a: Any, b: Any, what: str) -> bool:
    """Return True if a ball is below another; Unclear where they overlap."""
    if not (a < b or a > b):
        raise Unclear(what)
    return bool(a < b)
