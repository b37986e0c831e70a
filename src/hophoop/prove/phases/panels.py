"""Taylor panels in the angle, each with the remainder that Cauchy's bound on a complex disc gives."""

from __future__ import annotations

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, Jet, Undecided, arb, bits, coefficients, order, polynomial, series, symmetric
from hophoop.prove.enclosures import mean_value_form
from hophoop.prove.enclosures.mean_value_form import Varied, common, derivatives, moving
from hophoop.prove.enclosures.roots import exact
from hophoop.prove.phases.phase_equations import Disc, PhaseEquations, disc
from hophoop.prove.physics.equations import State

LARGEST = 0.5  # rad, of a disc
SMALLEST = 1e-9  # a smaller disc means p_σ → 0 or an endless approach
WIDE_STEP, WIDE_REACH = 0.5, 0.625  # of the radius, where a box needs few digits
SHARE = 4  # a panel's reach is the disc's radius over this: two bits a term


def terms_for(precision: int) -> int:
    """Terms whose remainder is below the working precision."""
    return precision // 2 + 6


class Panel:
    """u and t on [0, reach] in the way along θ from an exact angle, where u stays away from zero.

    Parameters
    ----------
    phase : PhaseEquations
    centre : Ball
        Exact angle.
    way : int
    u, t : Ball
        θ̇² and the time at the centre.
    """

    def __init__(self, phase: PhaseEquations, centre: Ball, way: int, u: Ball, t: Ball) -> None:
        self.phase, self.centre, self.way = phase, centre, way
        self.t = t
        terms = terms_for(bits()) * (2 if phase.model.varying else 1)
        radius = arb(LARGEST)
        while True:
            found = disc(phase, centre, radius)
            if found is not None:
                grown = (found.grow * radius).exp()
                moved = (grown - 1) * u.abs_upper() + radius * found.push * grown
                if moved < u.abs_lower() * 3 / 4:
                    break
            radius = radius * 5 / 8
            if radius < SMALLEST:
                raise Undecided(
                    "slip comes too close to p_σ = 0 or to θ̇ = 0"
                    if phase.sigma
                    else "rolling comes too close to an equilibrium"
                )
        least = u.abs_lower() - moved
        # a box of parameters smears an event: its panels hold farther than they are gone along, with fewer bits a term
        boxed = phase.model.varying > 0
        self.radius, self.reach = radius, exact(radius * (WIDE_STEP if boxed else arb(1) / SHARE))
        ratio = arb(WIDE_REACH) if boxed else arb(1) / SHARE
        self.farthest = exact(radius * ratio)
        tail = ratio**terms / (1 - ratio)
        most = u.abs_upper() + moved
        # ∂u/∂p obeys the same equation, with ∂A/∂p u + ∂B/∂p to drive it; of 1/√u it is −∂u/∂p/(2 u^(3/2))
        drives = [
            (one.abs_upper() + radius * (grow * most + push)) * grown
            for one, grow, push in zip(derivatives(u, len(found.grow_by)), found.grow_by, found.push_by, strict=True)
        ]
        slow = least.rsqrt()
        self.rest_u = _rest(most * tail, [one * tail for one in drives])
        self.rest_t = _rest(radius * slow * tail, [radius * slow / least * one / 2 * tail for one in drives])
        with order(terms):
            squares = phase.square(centre, u, way, terms)
            self.u_terms = coefficients(squares, terms)
            self.t_terms = coefficients(squares.rsqrt().integral(), terms)
        self.u_of, self.t_of = mean_value_form.polynomial(self.u_terms), mean_value_form.polynomial(self.t_terms)

    def square(self, x: Ball) -> Ball:
        """u; on an interval by the mean value theorem."""
        return moving(self._square, x, lambda at: self.way * self.phase.slope(self.angle(at), self._square(at)))

    def _square(self, x: Ball) -> Ball:
        rough = self.u_of(x) + self.rest_u
        if x.is_exact():
            return rough
        middle = exact(x)
        slope = self.way * self.phase.slope(self.angle(x), rough)
        return common(self.u_of(middle) + self.rest_u + slope * (x - middle), rough)

    def angle(self, x: Ball) -> Ball:
        """θ."""
        return self.centre + self.way * x

    def time(self, x: Ball) -> Ball:
        """t."""
        return moving(self._time, x, self.slowness)

    def _time(self, x: Ball) -> Ball:
        middle = exact(x)
        found = self.t + self.t_of(middle) + self.rest_t
        if not x.is_exact():
            found += self.square(x).rsqrt() * (x - middle)
        return found

    def spin(self, x: Ball) -> Ball:
        """θ̇."""
        return self.way * self.square(x).sqrt()

    def state(self, x: Ball, stops: bool = False) -> State:
        """The state at x."""
        return self.phase.state(self.time(x), self.angle(x), self.spin(x), stops)

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
        """Kinetic and potential energy in slip, which is stationary where v_t = 0, for friction then has no power."""
        return moving(self._energy, x, self._power)

    def _energy(self, x: Ball) -> Ball:
        model, middle = self.phase.model, exact(x)
        th, om, vt = self.angle(middle), self.spin(middle), self.phase.slides(self, middle)
        s, c = th.sin_cos()
        moving_along = vt * (om * (1 + model.eps * c) + vt / 2)
        found = model.inertia(c) * om * om / 2 + moving_along + model.height(th, s, c)
        return found if x.is_exact() else found + self._power(x) * (x - middle)

    def _power(self, x: Ball) -> Ball:
        """Of friction, over the rate of x."""
        u = self.square(x)
        return self.phase.forces(self.angle(x), u).friction * self.phase.slides(self, x) * u.rsqrt()

    def watch(self, x: Ball, terms: int) -> list[Jet]:
        """What must stay positive, as series in x."""
        return self.phase.along(self, x, terms)


def _rest(bound: Ball, by: list[Ball]) -> Ball:
    """A remainder within a bound, and its derivatives within theirs."""
    rest = symmetric(bound)
    return Varied(rest, rest, tuple(symmetric(one) for one in by)) if by else rest


class TurnPanel:
    """A phase through θ̇ = 0, or up to it: θ = θ* − way w², where w grows with time and everything is smooth in w.

    Parameters
    ----------
    phase : PhaseEquations
    turn : Ball
        θ*.
    way : int
        Direction of rotation before it.
    """

    def __init__(self, phase: PhaseEquations, turn: Ball, way: int) -> None:
        self.phase, self.turn, self.way = phase, turn, way
        self.t = arb(0)
        terms = terms_for(bits())
        radius = arb(LARGEST)
        while True:
            found = disc(phase, turn, radius)
            if found is not None and self._bounded(found):
                break
            radius = radius * 5 / 8
            if radius < SMALLEST:
                raise Undecided("a turning point is too close to an equilibrium")
        self.reach = radius / SHARE  # of w²
        ratio = arb(1) / SHARE
        tail = ratio**terms / (1 - ratio)
        with order(terms + 1):
            squares = coefficients(phase.square(turn, arb(0), -way, terms + 1), terms + 1)
        with order(terms):
            over = series(squares[1:])
            self.g_terms = coefficients(over, terms)
            rates = coefficients(over.rsqrt(), terms)
        self.t_terms = [2 * rate / (2 * k + 1) for k, rate in enumerate(rates)]
        self.rest_g = symmetric(self.most * tail)
        self.rest_t = symmetric(2 * self.least.rsqrt() * tail * self.reach.sqrt())

    def _bounded(self, found: Disc) -> bool:
        """u(s)/s is a mean of du/ds, whose box on the disc must stay to the right of zero."""
        model = self.phase.model
        grown = (found.grow * found.radius).exp()
        most = found.radius * found.push * grown
        s, c = found.angle.sin_cos()
        box = _flint.acb(symmetric(most), symmetric(most))
        slope = -2 * self.way * _flint.acb(model.forces(s, c, box, self.phase.sigma).alpha)
        self.least, self.most = slope.real.lower(), abs(slope).abs_upper()
        return bool(self.least > 0)

    def over(self, w: Ball) -> Ball:
        """u/w²."""
        return polynomial(self.g_terms, w * w) + self.rest_g

    def square(self, w: Ball) -> Ball:
        """u."""
        return w * w * self.over(w)

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
        return self.phase.state(self.time(w), self.angle(w), self.spin(w), stops)

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
        """What must stay positive, with its slopes in w."""
        return self.phase.about(self, w, terms)
