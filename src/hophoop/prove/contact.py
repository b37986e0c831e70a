"""Rolling and slip, step by step in time: a Taylor polynomial, what it leaves of the equations, and how errors grow.

A step is a polynomial for θ and θ̇ on [0, h]. Put into the equations, it leaves a residual δ, bounded by Taylor models. With e
the distance of (θ, θ̇) from the motion and μ the logarithmic norm of the equations' Jacobian, e′ ≤ μ e + δ (docs/method.md).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

from hophoop.prove.formulas import Ending, State
from hophoop.prove.models import Model, cut, modelled, over_all, padded, rates, sine_cosine, size
from hophoop.prove.numbers import Number, Unclear, arb, arb_poly, arb_series, ball, flint, precision, raw, setting
from hophoop.prove.roots import first_root, positive_until

BITS_A_TERM = 2.5
WIDEST, LONGEST = 0.6, 0.5  # rad, and √(R/g), of a step
FARTHEST = 1e-6  # between a polynomial and its motion
SMALLEST = 1e-12  # of a step; the box of its slopes, FARTHEST to each side, gets no smaller with it
ROUNDED_UP = 1 + 2.0**-40
SMALL = "errors stay small"  # which more bits change


class Contact:
    """A phase of rolling (σ = 0) or slip, between two turning points.

    Parameters
    ----------
    body : Body
    sigma : int
        Sign of the slip.
    begin : State
    zeros : int
        Derivatives of v_t that vanish at the start, itself included.
    origin : Number, optional
        A revolution from this angle ends the phase.
    """

    def __init__(self, body: Any, sigma: int, begin: State, zeros: int, origin: Number | None) -> None:
        self.body, self.sigma, self.begin, self.origin = body, sigma, begin, origin
        s, c = body.sine_cosine(begin.th)
        self.rho = body.of.resistance_arm(body, s, c, begin.om, sigma)
        self.motion = body.of.slip_motion if sigma else body.of.rolling_acceleration
        self.finite = body.mu_s != math.inf
        # what ends the phase, with the number of derivatives of its watched function that vanish at the start
        self.endings = dict.fromkeys([Ending.CONE_FORWARD, Ending.CONE_BACKWARD][: 1 + self.finite], 0)
        if sigma:
            self.endings = {Ending.LIFT_OFF: 0, Ending.SLIP_END: zeros}
            self.drag = sigma * body.mu_k
            self.speed = begin.om * self.arm(s, c) + begin.vt  # ẋ_G + σ μ ẏ_G, which gravity alone changes
            self.pull = body.gt - self.drag * body.gn
        start = begin.om if begin.om != 0 else ball(self.alpha(raw(s), raw(c), arb(0)))
        self.way = 1 if start > 0 else -1
        self.endings[Ending.TURNING_POINT] = 0 if begin.om != 0 else 1
        if origin is not None:
            self.endings[Ending.ANGLE_LIMIT] = 0

    def arm(self, s: Any, c: Any) -> Any:
        """1 + ε cos θ − σ μ ε sin θ."""
        return 1 + self.body.eps * (c - self.drag * s)

    def alpha(self, s: Any, c: Any, w: Any) -> Any:
        """θ̈."""
        if self.sigma:
            return raw(self.motion(self.body, s, c, w * w, self.sigma, self.rho)[0])
        return raw(self.motion(self.body, s, c, w * w, self.rho))

    def functions(self, tau: Any, th: Any, s: Any, c: Any, w: Any) -> list[Any]:
        """θ̈, and what ends the phase where it falls to zero."""
        u, body = w * w, self.body
        if self.sigma:
            alpha, normal, _ = self.motion(body, s, c, u, self.sigma, self.rho)
            ends = [normal, self.sigma * (self.speed + self.pull * tau - self.arm(s, c) * w)]
        else:
            alpha, (friction, normal) = self.motion(body, s, c, u, self.rho), body.of.rolling_forces(body, s, c, u, self.rho)
            ends = [body.mu_s * normal - friction, body.mu_s * normal + friction] if self.finite else [normal]
        ends.append(self.way * w)
        if self.origin is not None:
            ends.append(2 * flint.arb.pi() - self.way * (th - self.origin))
        return [raw(one) for one in (alpha, *ends)]

    def taylor(self, k: int, tau: Any, th: Any, om: Any, terms: int) -> list[Any]:
        """Taylor coefficients in time of a watched function, on balls."""
        w, angle = arb_series([om]), arb_series([th, om])
        for known in range(2, terms + 1):
            with setting(terms=known):
                s, c = angle.sin_cos()
                w = (arb_series([0]) + self.alpha(s, c, w)).integral() + om
                angle = w.integral() + th
        with setting(terms=terms):
            s, c = angle.sin_cos()
            found = self.functions(arb_series([tau, 1]), angle, s, c, w)
            return padded(arb_series([0]) + found[1 + k], terms)

    def state(self, tau: Any, th: Any, om: Any, rolled: Any) -> State:
        """The state after a time, from angle, rate and the work of rolling resistance in slip; energies give what is lost."""
        body, begin = self.body, self.begin
        th, om, tau = ball(th), ball(om), ball(tau)
        after = begin._replace(t=begin.t + tau, th=th, om=om)
        if self.sigma == 0:
            after = after._replace(x=begin.x + (th - begin.th), vt=ball(0))
            lost = body.energy(begin) - body.energy(after)
            return after._replace(rolling_loss=begin.rolling_loss + lost) if body.resist > 0 else after
        (s0, c0), (s, c) = body.sine_cosine(begin.th), body.sine_cosine(th)
        along = body.of.slip_displacement(body, self.sigma, begin.vt, begin.om, s0, c0, s - s0, c - c0, tau)
        after = after._replace(x=begin.x + along, vt=self.speed + self.pull * tau - om * self.arm(s, c))
        lost = body.energy(begin) - body.energy(after) - ball(rolled)
        return after._replace(friction=begin.friction + lost, rolling_loss=begin.rolling_loss + ball(rolled))


def length(a: Any, b: Any) -> Any:
    """Bound of √(a² + b²)."""
    return (a.abs_upper() ** 2 + b.abs_upper() ** 2).sqrt().upper()


class Step:
    """A polynomial for θ and θ̇ over a time, with bounds of their errors and models of the watched functions.

    Parameters
    ----------
    contact : Contact
    before : Step, optional
        The one before it in the phase.
    longest : arb
        Time that is left.
    """

    def __init__(self, contact: Contact, before: Step | None, longest: Any) -> None:
        self.contact, begin, one = contact, contact.begin, arb(1)
        self.terms = int(precision() / BITS_A_TERM) + 6
        if before is None:
            self.tau, th, om, guess = arb(0), raw(begin.th), raw(begin.om), LONGEST / 2
        else:
            self.tau, th, om, guess = before.tau + before.h, before.th(one), before.om(one), float(before.h)
        series = rates(contact.alpha, th.mid(), om.mid(), math.frexp(guess)[1] + 1, self.terms)
        h = min(_reach(series), WIDEST / max(1.0, abs(float(om.mid()))), LONGEST)
        if h > float(longest.lower()):
            h = float(longest.upper()) * ROUNDED_UP

        def error(weight: Any) -> Any:
            """The weighted distance of the polynomials from the motion at the start."""
            carried = before.error * (weight / before.weight).max(one) if before else arb(0)
            return length(weight * (th - self.th(arb(0))), om - self.om(arb(0))) + carried

        with setting(terms=self.terms):
            while not self._build(th.mid(), series, arb(h), error):
                h *= 0.5
                if not error(one) < FARTHEST / 2:
                    raise Unclear(SMALL)
                if h < SMALLEST:
                    raise Unclear("slip stays away from p_σ = 0" if contact.sigma else "the margins of rolling are bounded")

    def _build(self, th: Any, series: list[Any], h: Any, error: Callable[[Any], Any]) -> bool:
        """Return True if the polynomials over a time h are shown to be close to the motion."""
        self.h, contact = h, self.contact
        self.om = cut([one * h**k for k, one in enumerate(series)])[0]
        self.th = cut([th, *(self.om * h).integral().coeffs()[1:]])[0]
        s, c = sine_cosine(self.th)
        try:
            found = contact.functions(Model(arb_poly([self.tau, h])), Model(self.th), s, c, Model(self.om))
            by_angle, by_rate = self._slopes()
        except (ZeroDivisionError, ValueError):
            return False
        alpha, *self.models = map(modelled, found)
        left, turned = size(self.om.derivative() - alpha.p * h) + h * alpha.e, size(self.th.derivative() - self.om * h)
        # θ is weighted, so that θ and θ̇ of an oscillation turn into each other
        self.weight = weight = arb(max(1.0, math.sqrt(abs(float(by_angle[0].mid())))))
        norm = ((by_rate[0] + length(by_rate[0], weight + by_angle[0] / weight)) / 2).upper().max(arb(0))
        self.error = ((norm * h).exp() * (error(weight) + left + weight * turned)).upper()
        if not self.error < FARTHEST:
            return False
        self.th_off = (self.error / weight).upper()
        for model, angle, rate in zip(self.models, by_angle[1:], by_rate[1:], strict=True):
            model.e = (model.e + angle.abs_upper() * self.th_off + rate.abs_upper() * self.error).abs_upper()
        return True

    def _slopes(self) -> list[list[Any]]:
        """Derivatives of θ̈ and of the margins by θ and by θ̇, on a box about the polynomials."""
        near, contact = arb(0, FARTHEST), self.contact
        th, om = over_all(self.th) + near, over_all(self.om) + near
        tau = self.tau + self.h * arb(0.5, 0.5)
        with setting(terms=2):
            angle, rate = arb_series([th, 1]), arb_series([om, 1])
            s, c = angle.sin_cos()
            by_angle = contact.functions(tau, angle, s, c, om)
            s, c = th.sin_cos()
            by_rate = contact.functions(tau, th, s, c, rate)
            return [[padded(arb_series([0]) + one, 2)[1] for one in several] for several in (by_angle, by_rate)]

    def at(self, x: Any) -> tuple[Any, Any, Any]:
        """(τ, θ, θ̇) at a part of the step."""
        return self.tau + self.h * x, self.th(x) + arb(0, self.th_off), self.om(x) + arb(0, self.error)

    def rolled(self, x: Any) -> Any:
        """The work of rolling resistance in slip up to a part of the step."""
        if not (self.contact.sigma and self.contact.body.resist > 0):
            return arb(0)
        with setting(terms=self.terms):
            power = self.models[0] * self.models[2] * abs(raw(self.contact.rho)) * self.h
        return power.p.integral()(x) + arb(0, power.e)

    def taylor(self, k: int, x: Any, terms: int) -> list[Any]:
        """Coefficients in time of a watched function on a part of the step."""
        return self.contact.taylor(k, *self.at(x), terms)

    def first_event(self, zeros: list[int], end: Any) -> tuple[int, Any] | None:
        """(which watched function falls to zero first, the part of the step where it does)."""
        found = []
        for k, (model, known) in enumerate(zip(self.models, zeros, strict=True)):
            begin = positive_until(partial(self.taylor, k), known, end) if known else arb(0)
            bracket = first_root(model, begin, end) if begin < end else None
            if bracket is not None:
                found.append((k, *bracket))
        if not found:
            return None
        k, low, high = min(found, key=lambda one: float(one[1]))
        if not all(other[0] == k or high < other[1] for other in found):
            raise Unclear("one of two events comes first")
        x = low.union(high)
        if not self.taylor(k, x, 2)[1] < 0:
            raise Unclear("a margin does not only touch zero")
        return k, x


def _reach(series: list[Any]) -> float:
    """The time up to which the last terms of a series stay below the precision."""
    found, bits = math.inf, precision()
    for k in range(max(len(series) - 3, 1), len(series)):
        value = abs(series[k]).mid()
        if value > 0:
            found = min(found, 2.0 ** (-(bits + float(value.log()) / math.log(2)) / k))
    return found


def advance(body: Any, sigma: int, begin: State, zeros: int, t_end: Number, origin: Number | None) -> tuple[Ending, State]:
    """Roll or slip from a state up to the first event, a turning point or the end of the time."""
    repeats = sigma == 0 and origin is None and body.gt == 0 and body.resist == 0
    contact = Contact(body, sigma, begin, zeros, begin.th if repeats else origin)
    known, step, rolled = list(contact.endings.values()), None, arb(0)
    while True:
        body.look_at_clock()
        left = raw(t_end - begin.t) - (step.tau + step.h if step else 0)
        if not left > 0:
            raise Unclear("an event comes before the end of the time")
        step = Step(contact, step, left)
        part = left / step.h
        final = bool(part <= 1)
        found = step.first_event(known, part.upper() if final else arb(1))
        if found is not None:
            k, x = found
            if not x < part:
                raise Unclear("an event comes before the end of the time")
            after, ending = contact.state(*step.at(x), rolled + step.rolled(x)), list(contact.endings)[k]
            if ending == Ending.ANGLE_LIMIT:
                after = _whole_turn(contact, after, t_end if repeats else None)
                if repeats:
                    return advance(body, sigma, after, 0, t_end, None)
            if ending == Ending.TURNING_POINT:
                after = after._replace(om=ball(0))
            return ending, after._replace(vt=ball(0)) if ending == Ending.SLIP_END else after
        if final:
            return Ending.TIME_LIMIT, contact.state(*step.at(part), rolled + step.rolled(part))._replace(t=t_end)
        rolled, known = rolled + step.rolled(arb(1)), [0] * len(known)


def _whole_turn(contact: Contact, after: State, t_end: Number | None) -> State:
    """The state after exactly one revolution; with an end of the time, after all that it has room for, which are equal."""
    begin, turn = contact.begin, ball(2 * flint.arb.pi()) * contact.way
    angle = contact.origin + turn
    after = after._replace(th=angle, x=after.x + (angle - after.th) if contact.sigma == 0 else after.x)
    if t_end is None:
        return after
    period = after.t - begin.t
    more = max(0, int(raw((t_end - after.t) / period).lower().floor().unique_fmpz()))
    return after._replace(t=after.t + more * period, om=begin.om, th=angle + more * turn, x=after.x + more * turn)
