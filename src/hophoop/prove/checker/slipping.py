"""A phase of slip that a certificate names: its polynomials, put into the equations, leave so little over.

With u' = b − a u and a polynomial U for which Π U' − … is at most η Π in size, abs(u − U) grows from what it is at the
begin by at most e^(αL) L η on a way L (Grönwall).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, Jet, arb, coefficients, order, polynomial, series, symmetric
from hophoop.prove.checker.equations import Equations, Refused, State
from hophoop.prove.checker.intervals import positive, require, root

LIFT, STOP, LIMIT, SPAN, TURN = "lift", "stop", "limit", "span", "turn"


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


@dataclass
class Kept:
    """What slip keeps, and the state it began in."""

    equations: Equations
    sigma: int
    begin: State

    def arm(self, th: Ball) -> Ball:
        """1 + ε cos θ − σ μ ε sin θ."""
        eps, drag = self.equations.eps, self.sigma * self.equations.mu_k
        return 1 + eps * (th.cos() - drag * th.sin())

    @property
    def steady(self) -> Ball:
        """Gravity's pull on ẋ_G + σ μ ẏ_G."""
        return self.equations.gt - self.sigma * self.equations.mu_k * self.equations.gn

    def velocity(self, t: Ball, th: Ball, om: Ball) -> Ball:
        """v_t, from ẋ_G + σ μ ẏ_G."""
        begin = self.begin
        return begin.vt + begin.om * self.arm(begin.th) + self.steady * (t - begin.t) - om * self.arm(th)

    def state(self, t: Ball, th: Ball, om: Ball) -> State:
        """The state at a time and angle; x from the place of x_G + σ μ y_G."""
        begin, tau, eps = self.begin, t - self.begin.t, self.equations.eps
        drag = self.sigma * self.equations.mu_k
        moved = (begin.vt + begin.om * self.arm(begin.th)) * tau + self.steady * tau * tau / 2
        x = begin.x + moved - eps * (th.sin() - begin.th.sin()) - drag * eps * (th.cos() - begin.th.cos())
        return State(t, x, arb(0), th, self.velocity(t, th, om), arb(0), om)


class Piece:
    """θ̇² = U ± e and t = T ± … on a stretch about a centre; `way` is the direction of growing x."""

    def __init__(self, kept: Kept, record: dict[str, Any], way: int, bits: int) -> None:
        self.kept, self.way = kept, way
        self.centre, self.reach = number(record["centre"]), number(record["reach"])
        self.value_terms = poly(record["u"], self.reach, bits)
        self.time_terms = poly(record["t"], self.reach, bits) if record.get("t") else None

    def angle(self, x: Ball) -> Ball:
        """θ."""
        return self.centre + self.way * x

    def starts(self, th: Ball, u: Ball, t: Ball, end: Ball) -> None:
        """Bound the errors on the way from an angle to another, from what is left over of the equations."""
        model, sigma, reach = self.kept.equations, self.kept.sigma, self.reach
        x = self.way * (th - self.centre)
        length = (end - x).abs_upper()
        require(bool(abs(x).abs_upper() <= reach) and bool(abs(end).abs_upper() <= reach), "a panel reaches far enough")
        flint = _flint
        value = flint.arb_poly(self.value_terms)
        rate = value.derivative()
        left, stiff = left_over(model, sigma, self.centre, self.way, reach, value, rate)
        eta = left / stiff.abs_lower()
        grown = growth(model, sigma, self.centre, self.way, x.union(end)).exp()
        first = abs(polynomial(self.value_terms, x) - u).abs_upper()
        self.error_u = symmetric(grown * (first + length * eta))
        if self.time_terms is None:
            return
        slow = flint.arb_poly(self.time_terms).derivative()
        rest = largest(coefficients_of(slow * slow * value - 1), reach)
        speed = largest(coefficients_of(slow), reach)
        spoilt = rest + speed * speed * self.error_u.abs_upper()
        lowest = self.lowest(x.union(end))
        require(bool(spoilt < arb(1) / 2), "the time of a panel is its own")
        self.error_t = symmetric(length * spoilt * lowest.rsqrt())
        self.offset = t - polynomial(self.time_terms, x)

    def lowest(self, whole: Ball) -> Ball:
        """A positive bound of θ̇² from below on a stretch."""
        values = [self.square(part).lower() for part in parts(whole)]
        for value in values:
            require(bool(value > 0), "θ̇ stays away from zero on a panel")
        return least_of(values)

    def square(self, x: Ball) -> Ball:
        """θ̇²; on an interval about its middle."""
        rough = polynomial(self.value_terms, x) + self.error_u
        if x.is_exact():
            return rough
        middle = x.mid()
        s, c = self.angle(x).sin_cos()
        slope = 2 * self.way * self.kept.equations.contact(s, c, rough, self.kept.sigma).alpha
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
        """(N, σ v_t) as series in x."""
        model, sigma, middle = self.kept.equations, self.kept.sigma, x.mid()
        here = sigma * self.kept.velocity(self.time(middle), self.angle(middle), self.spin(middle))
        th = self.angle(x)
        with order(terms):
            z = series([th, self.way])
            s, c = z.sin_cos()
            u = model.square(th, self.square(x), self.way, sigma, terms - 1)
            contact = model.contact(s, c, u, sigma)
            load = coefficients(series([0]) - contact.free, terms)
            rate = coefficients(sigma * contact.slip * (series([0]) + u).rsqrt(), terms)
        return [load, [here + rate[0] * (x - middle)] + [rate[k - 1] / k for k in range(1, terms)]]

    def limits(self, x: Ball, t_end: Ball) -> Jet:
        """What is left of the time."""
        return [t_end - self.time(x), -self.square(x).rsqrt()]


class Turn(Piece):
    """About a turning point: θ = θ* − way w², θ̇² = w² G(w²), t = t* + w H(w²); polynomials in s = w²."""

    def __init__(self, kept: Kept, record: dict[str, Any], way: int, bits: int, turn: Ball) -> None:
        self.kept, self.way, self.centre = kept, way, turn
        self.reach = number(record["reach"])  # of s
        self.value_terms, self.time_terms = (poly(record[name], self.reach, bits) for name in ("g", "h"))
        flint, model, sigma = _flint, kept.equations, kept.sigma
        ratio = flint.arb_poly(self.value_terms)
        along = flint.arb_poly([0, 1])
        value = along * ratio
        left, firm = left_over(model, sigma, turn, -way, self.reach, value, value.derivative())
        grown = growth(model, sigma, turn, -way, arb(0).union(self.reach)).exp()
        self.error_g = symmetric(left / firm.abs_lower() * grown)
        timing = flint.arb_poly(self.time_terms)
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
        """(N, σ v_t) with their slopes in w."""
        require(terms <= 2, "slip from θ̇ = 0 begins with an acceleration")
        model, sigma, middle = self.kept.equations, self.kept.sigma, w.mid()
        here = sigma * self.kept.velocity(self.time(middle), self.angle(middle), self.spin(middle))
        over = self.over(w)
        s, c = self.angle(w).sin_cos()
        contact = model.contact(s, c, w * w * over, sigma)
        rate = 2 * sigma * contact.slip * over.rsqrt()
        # load = g − ε cos θ u, with dθ/dw = −2 way w
        fall = -2 * self.way * w * model.eps * (s * w * w * over - 2 * c * contact.alpha)
        return [[-contact.free, fall][:terms], [here + rate * (w - middle), rate][:terms]]

    def limits(self, w: Ball, t_end: Ball) -> Jet:
        """What is left of the time."""
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
    """Bound of −∫ a over any part of a stretch, where the error e of θ̇² has e' = −a e + …, a = 2 way ε cos θ q/(κ p_σ)."""
    drag, total, stretch = sigma * model.mu_k, arb(0), parts(whole)
    for part in stretch:
        s, c = (centre + way * part).sin_cos()
        torque = model.eps * s + drag * (1 + model.eps * c)
        decay = 2 * way * model.eps * c * torque / (model.kap + model.eps * s * torque)
        total += (-decay).upper().max(arb(0))
    width = (whole.upper() - whole.lower()) / len(stretch)
    return (total * width).upper()


def left_over(model: Equations, sigma: int, centre: Ball, way: int, reach: Ball, value: Any, rate: Any) -> tuple[Ball, Ball]:
    """(bound of κ p_σ U' + 2 way q f_n on the stretch, κ p_σ there): zero for θ̇² itself."""
    flint = _flint
    terms = max(value.length() + 8, 24)
    tail = reach**terms / arb(terms).gamma() / terms * 2
    with order(terms):
        sine, cosine = (coefficients(one, terms) for one in series([centre, way]).sin_cos())
    sine[0], cosine[0] = sine[0] + symmetric(tail), cosine[0] + symmetric(tail)
    s, c = flint.arb_poly(sine), flint.arb_poly(cosine)
    drag = sigma * model.mu_k
    torque = s * model.eps + drag + c * (drag * model.eps)
    firm = s * torque * model.eps + model.kap
    left = firm * rate - torque * (c * value * (-model.eps) + model.gn) * (2 * way)
    sine_all, cosine_all = (centre + symmetric(reach)).sin_cos()
    stiff = model.kap + model.eps * sine_all * (model.eps * sine_all + drag * (1 + model.eps * cosine_all))
    require(bool(stiff > 0), "p_σ stays positive")
    return largest(coefficients_of(left), reach), stiff


def coefficients_of(value: Any) -> list[Ball]:
    """Of an arb_poly."""
    return list(value.coeffs())


@dataclass
class Way:
    """How far a certified slip phase is verified."""

    th: Ball
    u: Ball
    t: Ball
    way: int
    known: list[int]
    turns: list[State]


def slip(
    equations: Equations, sigma: int, state: State, zeros: int, record: dict[str, Any], limits: dict[str, Any]
) -> tuple[str, State, list[State]]:
    """(what ends a certified slip phase, the state there, the turning points before it)."""
    kept = Kept(equations, sigma, state)
    bits, what = int(record["bits"]), record["what"]
    at = Way(state.th, state.om * state.om, state.t, _direction(equations, sigma, state), [0, zeros], [])
    panels = record["panels"]
    for k, one in enumerate(panels):
        ends = what if k == len(panels) - 1 else None
        verify = _through_turn if "g" in one else _along
        found = verify(kept, at, one, bits, limits, ends)
        if found is not None:
            return what, found, at.turns
    raise Refused("the last panel ends the phase")


def _along(kept: Kept, at: Way, one: dict[str, Any], bits: int, limits: dict[str, Any], what: str | None) -> State | None:
    """A panel between turning points; the state at the event that ends it, if one does."""
    piece = Piece(kept, one, at.way, bits)
    begin = at.way * (at.th - piece.centre)
    end = arb(one["bracket"][1]) if what else number(one["to"])
    require(bool(end > begin), "panels go on")
    piece.starts(at.th, at.u, at.t, end)
    stop = _stretch(piece, at.known, begin, end, limits, what, one)
    if stop is not None:
        return kept.state(piece.time(stop), piece.angle(stop), piece.spin(stop))
    at.th, at.u, at.t, at.known = piece.angle(end), piece.square(end), piece.time(end), [0, 0]
    return None


def _through_turn(
    kept: Kept, at: Way, one: dict[str, Any], bits: int, limits: dict[str, Any], what: str | None
) -> State | None:
    """A panel about a turning point, or about the begin where θ̇ = 0 there."""
    if at.u.is_zero():
        piece, begin = Turn(kept, one, -at.way, bits, at.th), arb(0)
        piece.offset = at.t
    else:
        turn = _turning_angle(kept, at, one["link"], bits)
        piece, begin = Turn(kept, one, at.way, bits, turn), -(at.way * (turn - at.th)).sqrt()
        require(bool(begin * begin <= piece.reach), "a panel reaches back to the begin")
        piece.offset = at.t - piece.time(begin)
        early = what if what is not None and one["ends"] == "before" else None
        stop = _stretch(piece, at.known, begin, arb(0), limits, early, one)
        if stop is not None:
            require(bool(stop < 0), "the end of the phase comes before the turning point")
            return kept.state(piece.time(stop), piece.angle(stop), piece.spin(stop))
        after = kept.state(piece.time(arb(0)), turn, arb(0))
        if what == TURN:
            return after
        at.turns.append(after)
        at.known, begin, at.way = [0, 0], arb(0), -at.way
    end = arb(one["bracket"][1]) if what else number(one["to"])
    require(bool(end > 0) and bool(end * end <= piece.reach), "a panel reaches far enough")
    stop = _stretch(piece, at.known, begin, end, limits, what, one)
    if stop is not None:
        return kept.state(piece.time(stop), piece.angle(stop), piece.spin(stop))
    at.th, at.u, at.t, at.known = piece.angle(end), piece.square(end), piece.time(end), [0, 0]
    return None


def _turning_angle(kept: Kept, at: Way, record: dict[str, Any], bits: int) -> Ball:
    """θ* as the first root of θ̇²."""
    link = Piece(kept, record, at.way, bits)
    low, high = (arb(text) for text in record["bracket"])
    begin = at.way * (at.th - link.centre)
    require(bool(low > begin), "a turning point is ahead")
    link.starts(at.th, at.u, at.t, high)

    def square(x: Ball, terms: int) -> list[Jet]:
        s, c = link.angle(x).sin_cos()
        value = link.square(x)
        slope = 2 * link.way * kept.equations.contact(s, c, value, kept.sigma).alpha
        return [[value, slope][:terms] + [arb(0)] * (terms - 2)]

    positive(square, begin, low, "θ̇ stays away from zero before a turning point")
    return link.angle(root(square, 0, low, high, "θ̇ = 0"))


def _direction(equations: Equations, sigma: int, state: State) -> int:
    rate = state.om
    if rate.is_zero():
        s, c = state.th.sin_cos()
        rate = equations.contact(s, c, arb(0), sigma).alpha
    require(bool(rate > 0) or bool(rate < 0), "the hoop turns one way")
    return 1 if rate > 0 else -1


def _stretch(
    piece: Piece, zeros: list[int], begin: Ball, end: Ball, limits: dict[str, Any], what: str | None, one: dict[str, Any]
) -> Ball | None:
    """Nothing happens on the stretch; or the event in its bracket, before which nothing does."""
    names = [LIFT, STOP]
    if "t_end" in limits:
        names.append(LIMIT)
    if "turn_end" in limits:
        names.append(SPAN)

    def functions(x: Ball, terms: int) -> list[Jet]:
        found = piece.watch(x, terms)
        if "t_end" in limits:
            found.append(piece.limits(x, limits["t_end"])[:terms] + [arb(0)] * (terms - 2))
        if "turn_end" in limits:
            found.append(limits["turn_end"](piece, x)[:terms] + [arb(0)] * (terms - 2))
        return found

    known = zeros + [0] * (len(names) - 2)
    if what is None:
        positive(functions, begin, end, "slip goes on", known)
        return None
    low, high = (arb(text) for text in one["bracket"])
    require(bool(low > begin), "an event is ahead")
    positive(functions, begin, low, f"slip goes on up to its end ({what})", known)
    return root(functions, names.index(what), low, high, f"slip ends ({what})")
