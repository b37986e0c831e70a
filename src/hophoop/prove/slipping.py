"""Slip by Taylor panels in the angle, each with the remainder that Cauchy's bound on a complex disc gives.

In slip θ̇² = u obeys the linear equation du/dθ = 2 q (g cos β − ε cos θ u)/(κ p_σ), and the time is ∫ dθ/√u.
"""

from __future__ import annotations

from dataclasses import dataclass

from hophoop.prove import _flint
from hophoop.prove._flint import (
    Ball,
    Jet,
    Series,
    Undecided,
    arb,
    bits,
    coefficients,
    intersection,
    order,
    polynomial,
    series,
    symmetric,
)
from hophoop.prove.model import Model, State
from hophoop.prove.search import exact

LARGEST = 0.5  # rad, of a disc
SMALLEST = 1e-9  # a smaller disc means p_σ → 0 or an endless approach
SHARE = 4  # a panel's reach is the disc's radius over this: two bits a term


def terms_for(precision: int) -> int:
    """Terms whose remainder is below the working precision."""
    return precision // 2 + 6


@dataclass(frozen=True)
class Slip:
    """What a slip phase keeps: its direction, the state it began in, and v_t + θ̇ (1 + ε cos θ − σ μ ε sin θ) there."""

    model: Model
    sigma: int
    begin: State
    kept: Ball

    @classmethod
    def of(cls, model: Model, sigma: int, state: State) -> Slip:
        """The slip that begins in a state."""
        s, c = state.th.sin_cos()
        return cls(model, sigma, state, state.vt + state.om * model.arm(s, c, sigma))

    @property
    def steady(self) -> Ball:
        """How fast gravity changes what is kept."""
        return self.model.gt - self.sigma * self.model.mu_k * self.model.gn

    def velocity(self, t: Ball, th: Ball, om: Ball) -> Ball:
        """σ v_t."""
        s, c = th.sin_cos()
        return self.sigma * (self.kept + self.steady * (t - self.begin.t) - om * self.model.arm(s, c, self.sigma))

    def state(self, t: Ball, th: Ball, om: Ball, stops: bool) -> State:
        """The state at a time and angle."""
        begin, tau = self.begin, t - self.begin.t
        s0, c0 = begin.th.sin_cos()
        s, c = th.sin_cos()
        drag = self.sigma * self.model.mu_k
        shift = self.model.eps * ((s - s0) + drag * (c - c0))
        x = begin.x + self.kept * tau + self.steady * tau * tau / 2 - shift
        vt = arb(0) if stops else self.sigma * self.velocity(t, th, om)
        return State(t, x, arb(0), th, vt, arb(0), om)

    def slope(self, th: Ball, u: Ball) -> Ball:
        """du/dθ."""
        s, c = th.sin_cos()
        return 2 * self.model.slipping(s, c, u, self.sigma).alpha

    def square(self, th: Ball, u: Ball, way: int, terms: int) -> Series:
        """u as a series in way·θ from a value; call it within `order`."""
        model = self.model
        z = series([th, way])
        s, c = z.sin_cos()
        rate = 2 * way * model.torque(s, c, self.sigma) / model.stiffness(s, c, self.sigma)
        grown = (rate * (model.eps * c)).integral().exp()
        return ((rate * model.gn * grown).integral() + u) / grown


@dataclass(frozen=True)
class Disc:
    """Bounds on a complex disc: its radius, abs(2 q ε cos θ/Π), abs(2 q/Π) and both before the absolute value."""

    radius: Ball
    decay: Ball
    push: Ball
    angle: Ball


def disc(slip: Slip, th: Ball, radius: Ball) -> Disc | None:
    """Bounds on the disc about θ; None where p_σ may vanish in it."""
    model, flint = slip.model, _flint
    square = flint.acb(arb(th) + symmetric(radius), symmetric(radius))
    s, c = square.sin_cos()
    firm = model.stiffness(s, c, slip.sigma)
    if firm.contains(flint.acb(0)):
        return None
    rate = 2 * model.torque(s, c, slip.sigma) / firm
    return Disc(radius, abs(rate * c * model.eps).abs_upper(), abs(rate).abs_upper(), square)


class Panel:
    """u and t on [0, reach] in the way along θ from an exact angle, where u stays away from zero.

    Parameters
    ----------
    slip : Slip
    centre : Ball
        Exact angle.
    way : int
    u, t : Ball
        θ̇² and the time at the centre.
    """

    def __init__(self, slip: Slip, centre: Ball, way: int, u: Ball, t: Ball) -> None:
        self.slip, self.centre, self.way = slip, centre, way
        self.t = t
        terms = terms_for(bits())
        radius = arb(LARGEST)
        while True:
            found = disc(slip, centre, radius)
            if found is not None:
                grown = (found.decay * radius).exp()
                moved = (grown - 1) * abs(u).abs_upper() + radius * found.push * abs(slip.model.gn) * grown
                if moved < u.abs_lower() * 3 / 4:
                    break
            radius = radius * 5 / 8
            if radius < SMALLEST:
                raise Undecided("slip comes too close to p_σ = 0 or to θ̇ = 0")
        least = u.abs_lower() - moved
        self.radius, self.reach = radius, exact(radius / SHARE)
        # a ball of parameters smears an event over more than the reach: its panels hold twice as far, with larger remainders
        self.farthest = 2 * self.reach if slip.model.free else self.reach
        ratio = arb(2 if slip.model.free else 1) / SHARE
        tail = ratio**terms / (1 - ratio)
        self.rest_u = symmetric((abs(u) + moved) * tail)
        self.rest_t = symmetric(radius * least.rsqrt() * tail)
        with order(terms):
            squares = slip.square(centre, u, way, terms)
            self.u_terms = coefficients(squares, terms)
            self.t_terms = coefficients(squares.rsqrt().integral(), terms)

    def square(self, x: Ball) -> Ball:
        """u; on an interval by the mean value theorem."""
        rough = polynomial(self.u_terms, x) + self.rest_u
        if x.is_exact():
            return rough
        middle = exact(x)
        slope = self.way * self.slip.slope(self.angle(x), rough)
        return (polynomial(self.u_terms, middle) + self.rest_u + slope * (x - middle)).intersection(rough)

    def angle(self, x: Ball) -> Ball:
        """θ."""
        return self.centre + self.way * x

    def time(self, x: Ball) -> Ball:
        """t."""
        middle = exact(x)
        found = self.t + polynomial(self.t_terms, middle) + self.rest_t
        if not x.is_exact():
            found += self.square(x).rsqrt() * (x - middle)
        return found

    def spin(self, x: Ball) -> Ball:
        """θ̇."""
        return self.way * self.square(x).sqrt()

    def state(self, x: Ball, stops: bool = False) -> State:
        """The state at x."""
        return self.slip.state(self.time(x), self.angle(x), self.spin(x), stops)

    def slowness(self, x: Ball) -> Ball:
        """dt/dx."""
        return self.square(x).rsqrt()

    def way_at(self, x: Ball) -> int:
        """Direction of rotation."""
        return self.way

    def angle_rate(self, x: Ball) -> Ball:
        """dθ/dx."""
        return arb(self.way)

    def energy(self, x: Ball) -> Ball:
        """½ D θ̇² + V, which is stationary where slip stops."""
        model, slip, middle = self.slip.model, self.slip, exact(x)
        found = []
        for at, terms in ((middle, 1), (x, 2)):
            with order(terms):
                z = series([self.angle(at), self.way])
                s, c = z.sin_cos()
                u = slip.square(self.angle(at), self.square(at), self.way, terms)
                found.append(coefficients(model.inertia(c) * u / 2 + model.height(z, s, c), terms))
        return found[0][0] + found[1][1] * (x - middle)

    def watch(self, x: Ball, terms: int) -> list[Jet]:
        """(−f_n, σ v_t) as series in x: N → 0, and the end of slip."""
        slip, model = self.slip, self.slip.model
        th, u = self.angle(x), self.square(x)
        middle = exact(x)
        here = self.slip.velocity(self.time(middle), self.angle(middle), self.spin(middle))
        with order(terms):
            z = series([th, self.way])
            s, c = z.sin_cos()
            squares = slip.square(th, u, self.way, terms) if terms > 1 else series([u])
            load = coefficients(series([0]) + (model.gn - model.eps * c * squares), terms)
            rate = coefficients(slip.sigma * model.slipping(s, c, squares, slip.sigma).slip * squares.rsqrt(), terms)
        velocity = [here + rate[0] * (x - middle)] + [rate[k - 1] / k for k in range(1, terms)]
        return [load, velocity]


class TurnPanel:
    """Slip through θ̇ = 0: θ = θ* − way w², where w grows with time and everything is smooth in w.

    Parameters
    ----------
    slip : Slip
    turn : Ball
        θ*.
    way : int
        Direction of rotation before it.
    """

    def __init__(self, slip: Slip, turn: Ball, way: int) -> None:
        self.slip, self.turn, self.way = slip, turn, way
        self.t = arb(0)
        terms = terms_for(bits())
        radius = arb(LARGEST)
        while True:
            found = disc(slip, turn, radius)
            if found is not None and self._bounded(found):
                break
            radius = radius * 5 / 8
            if radius < SMALLEST:
                raise Undecided("a turning point in slip is too close to an equilibrium")
        self.reach = radius / SHARE  # of w²
        ratio = arb(1) / SHARE
        tail = ratio**terms / (1 - ratio)
        with order(terms + 1):
            squares = coefficients(slip.square(turn, arb(0), -way, terms + 1), terms + 1)
        with order(terms):
            over = series(squares[1:])
            self.g_terms = coefficients(over, terms)
            rates = coefficients(over.rsqrt(), terms)
        self.t_terms = [2 * rate / (2 * k + 1) for k, rate in enumerate(rates)]
        self.rest_g = symmetric(self.most * tail)
        self.rest_t = symmetric(2 * self.least.rsqrt() * tail * self.reach.sqrt())

    def _bounded(self, found: Disc) -> bool:
        """u(s)/s is a mean of du/ds, whose box on the disc must stay to the right of zero."""
        model = self.slip.model
        grown = (found.decay * found.radius).exp()
        most = found.radius * found.push * abs(model.gn) * grown
        s, c = found.angle.sin_cos()
        box = _flint.acb(symmetric(most), symmetric(most))
        slope = -2 * self.way * model.slipping(s, c, box, self.slip.sigma).alpha
        self.least, self.most = slope.real.lower(), abs(slope).abs_upper()
        return bool(self.least > 0)

    def over(self, w: Ball) -> Ball:
        """u/w²."""
        return polynomial(self.g_terms, w * w) + self.rest_g

    def angle(self, w: Ball) -> Ball:
        """θ."""
        return self.turn - self.way * w * w

    def spin(self, w: Ball) -> Ball:
        """θ̇."""
        return -self.way * w * self.over(w).sqrt()

    def time(self, w: Ball) -> Ball:
        """t."""
        middle = exact(w)
        found = self.t + middle * polynomial(self.t_terms, middle * middle) + self.rest_t
        if not w.is_exact():
            found += 2 * self.over(w).rsqrt() * (w - middle)
        return found

    def state(self, w: Ball, stops: bool = False) -> State:
        """The state at w."""
        return self.slip.state(self.time(w), self.angle(w), self.spin(w), stops)

    def slowness(self, w: Ball) -> Ball:
        """dt/dw."""
        return 2 * self.over(w).rsqrt()

    def way_at(self, w: Ball) -> int:
        """Direction of rotation."""
        return self.way if w < 0 else -self.way

    def angle_rate(self, w: Ball) -> Ball:
        """dθ/dw."""
        return -2 * self.way * w

    def watch(self, w: Ball, terms: int) -> list[Jet]:
        """(−f_n, σ v_t) with their slopes in w."""
        slip, model = self.slip, self.slip.model
        if terms > 2:
            raise Undecided("slip begins with θ̇ = 0 and no acceleration")
        middle = exact(w)
        here = slip.velocity(self.time(middle), self.angle(middle), self.spin(middle))
        th, over = self.angle(w), self.over(w)
        u = w * w * over
        s, c = th.sin_cos()
        forces = model.slipping(s, c, u, slip.sigma)
        rate = slip.sigma * forces.slip * 2 * over.rsqrt()
        fall = -2 * self.way * w * (model.eps * s * u - 2 * model.eps * c * forces.alpha)
        return [[forces.load, fall][:terms], [here + rate * (w - middle), rate][:terms]]


def square_at(slip: Slip, th: Ball, u: Ball, centre: Ball, energy: Ball | None = None) -> Ball:
    """u at an exact angle inside the ball of the angle where it is known.

    Where slip begins out of rolling of this energy, both have the same slope there, or nearly so: u is that of
    rolling up to the second order of the ball.
    """
    spread = centre - th
    if spread.is_zero():
        return u
    box = u
    for _ in range(20):
        slope = slip.slope(th.union(centre), box)
        found = u + slope * spread
        if box.contains(found.union(u)):
            break
        box = (u + 2 * slope * symmetric(spread)).union(box)
    else:
        raise Undecided("the begin of a slip phase has no enclosure")
    if energy is None:
        return found
    # d/dθ* of u(centre), for slip that begins in θ*: what the slopes differ by, carried on by exp(∫ −a)
    model = slip.model
    s, c = th.union(centre).sin_cos()
    rolled = 2 * model.rolling(s, c, box).alpha
    rate = 2 * model.torque(s, c, slip.sigma) * model.eps * c / model.stiffness(s, c, slip.sigma)
    carried = (-rate * symmetric(spread)).exp()
    s, c = centre.sin_cos()
    there = 2 * (energy - model.height(centre, s, c)) / model.inertia(c)
    return intersection(found, there + (rolled - slope) * carried * symmetric(spread))


def begin_at(slip: Slip, centre: Ball, u: Ball, way: int) -> State:
    """The state that slip has, or would have had, at an exact angle beside the one where it began."""
    begin, spread = slip.begin, centre - slip.begin.th
    th, square = begin.th.union(centre), u.union(begin.om * begin.om)
    slowness = square.rsqrt()
    s, c = th.sin_cos()
    rate = slip.model.slipping(s, c, square, slip.sigma).slip * slowness * way
    vt = begin.vt + rate * spread
    moved = (1 + way * begin.vt.union(vt) * slowness) * spread
    return State(begin.t + way * spread * slowness, begin.x + moved, begin.y, centre, vt, begin.vn, way * u.sqrt())
