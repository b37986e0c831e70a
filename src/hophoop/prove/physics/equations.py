"""The equations of docs/model.md on balls and series, in units of R, m and √(R/g)."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass
from fractions import Fraction

from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Jet, Series, Undecided, coefficients, order, rational, sign
from hophoop.prove.deadline import Deadline
from hophoop.prove.enclosures.mean_value_form import at_centre, count_of, over, series

# Parameters that may be balls instead of the scenario's numbers, in SI units.
FREE = ("hoop.load_fraction", "plane.mu", "plane.mu_static", "plane.mu_kinetic", "plane.slope", "start.speed", "start.omega")


@dataclass(frozen=True)
class State:
    """An instant; `vt` and `vn` are exact zeros where the contact makes them so."""

    t: Ball
    x: Ball
    y: Ball
    th: Ball
    vt: Ball
    vn: Ball
    om: Ball


@dataclass(frozen=True)
class Forces:
    """At an angle, in roll or slip: θ̈, N, F, v̇_t and −f_n."""

    alpha: Series
    normal: Series
    friction: Series
    slip: Series
    free_normal: Series


class Model:
    """Hoop, plane and start as balls.

    Parameters
    ----------
    problem : Problem
        The exact numbers of a scenario.
    free : mapping of str to Ball
        Balls in the place of some of them.
    deadline : Deadline, optional
        Asked by whatever evaluates the equations again and again.
    """

    def __init__(self, problem: Problem, free: Mapping[str, Ball] | None = None, deadline: Deadline | None = None) -> None:
        self.problem, self.deadline = problem, deadline or Deadline()
        self.free = dict(free or {})
        self.varying = count_of(*self.free.values())
        self.eps, self.kap = rational(problem.eps), rational(problem.kap)
        if "hoop.load_fraction" in self.free:
            self.eps = self.free["hoop.load_fraction"]
            self.kap = 1 - self.eps * self.eps
        self.mu_s, self.mu_k = self._friction("static", problem.mu_s), self._friction("kinetic", problem.mu_k)
        self.equal_friction = problem.mu_s == problem.mu_k and not {"plane.mu_static", "plane.mu_kinetic"} & set(self.free)
        self.rest = rational(problem.rest)
        self.resist = rational(problem.resist)
        self.rho = rational(0)  # the couple over N, in the direction given to `toward`
        slope: Ball = self.free.get("plane.slope", rational(problem.slope))
        weight = 1 if problem.gravity else 0
        self.gn, self.gt = slope.cos() * weight, slope.sin() * weight
        self.level = bool(self.gt.is_zero())
        self.length, self.mass = rational(problem.radius), rational(problem.mass)
        self.time = (self.length / rational(problem.gravity or Fraction(1))).sqrt()
        self.speed = self.length / self.time
        self.t_end = rational(problem.duration) / self.time

    def _friction(self, kind: str, value: Fraction | None) -> Ball:
        for name in (f"plane.mu_{kind}", "plane.mu"):
            if name in self.free:
                return self.free[name]
        return None if value is None else rational(value)

    def start(self) -> State:
        """The state at t = 0."""
        problem = self.problem
        omega, slip = rational(problem.omega), rational(problem.slip)
        if "start.speed" in self.free:
            omega = self.free["start.speed"] / self.length
        elif "start.omega" in self.free:
            slip = slip + (omega - self.free["start.omega"]) * self.length
            omega = self.free["start.omega"]
        zero = rational(0)
        return State(
            zero,
            rational(problem.x) / self.length,
            rational(problem.height) / self.length,
            rational(problem.angle),
            slip / self.speed if not slip.is_zero() else zero,
            rational(problem.vy) / self.speed if problem.vy else zero,
            omega * self.time if not omega.is_zero() else zero,
        )

    # --- rolling resistance ----------------------------------------------------------------------

    @property
    def resisted(self) -> bool:
        """True if there is rolling resistance."""
        return not self.resist.is_zero()

    def toward(self, way: int) -> Model:
        """The equations of a hoop that turns in a direction."""
        if not self.resisted:
            return self
        found = copy(self)
        found.rho = way * self.resist
        return found

    def after(self, th: Ball, om: Ball, sigma: int) -> Model:
        """The equations just after an instant of rolling (σ = 0) or slip; `Still` where the couple holds the hoop.

        At θ̇ = 0 the couple is what keeps the hoop from turning, up to f N.
        """
        if not self.resisted:
            return self
        way = sign(om, "θ̇")
        if way == 0:
            s, c = th.sin_cos()
            if sigma:
                need, most = self.torque(s, c, sigma), self.resist
            else:
                need, most = self.eps * s * self.gn + self.gt * (1 + self.eps * c), self.resist * self.gn
            ahead, back = need - most, need + most
            if (ahead < 0 or ahead.is_zero()) and (back > 0 or back.is_zero()):
                return Still(self)
            if not (ahead > 0 or back < 0):
                raise Undecided("whether the rolling resistance holds the hoop is not certain")
            way = 1 if ahead > 0 else -1
        return self.toward(way)

    # --- boxes of parameters ---------------------------------------------------------------------

    def plain(self) -> Model:
        """The same as balls, which do not keep how they depend on the parameters."""
        found = copy(self)
        found.__dict__ |= {name: over(value) for name, value in vars(self).items()} | {"varying": 0}
        return found

    def central(self) -> Model:
        """At the centre of the box."""
        found = copy(self)
        found.__dict__ |= {name: at_centre(value) for name, value in vars(self).items()} | {"varying": 0}
        return found

    # --- formulas, for numbers and series alike --------------------------------------------------

    def inertia(self, c: Series) -> Series:
        """D = (1 − ε)² + κ + 2 ε (1 + cos θ)."""
        gap = 1 - self.eps
        return 2 * self.eps * (1 + c) + (gap * gap + self.kap)

    def height(self, z: Series, s: Series, c: Series) -> Series:
        """V with ½ D θ̇² + V constant in rolling."""
        return self.eps * (self.gn * c - self.gt * s) - self.gt * z

    def stiffness(self, s: Series, c: Series, sigma: int) -> Series:
        """κ p_σ."""
        return self.eps * s * self.torque(s, c, sigma) + self.kap

    def torque(self, s: Series, c: Series, sigma: int) -> Series:
        """q = ε sin θ − ρ + σ μ (1 + ε cos θ)."""
        return self.eps * s - self.rho + sigma * self.mu_k * (1 + self.eps * c)

    def rolling(self, s: Series, c: Series, u: Series) -> Forces:
        """Rolling with θ̇² = u."""
        eps = self.eps
        torque = eps * s * (u + self.gn) + self.gt * (1 + eps * c)
        if self.rho.is_zero():
            alpha = torque / self.inertia(c)
        else:
            alpha = (torque - self.rho * (self.gn - eps * c * u)) / self.divisor(s, c, 0)
        friction = alpha * (1 + eps * c) - eps * s * u - self.gt
        normal = self.gn - eps * s * alpha - eps * c * u
        return Forces(alpha, normal, friction, s * 0, self.gn - eps * c * u)

    def slipping(self, s: Series, c: Series, u: Series, sigma: int) -> Forces:
        """Slip in the direction σ with θ̇² = u."""
        eps, drag = self.eps, sigma * self.mu_k
        q = self.torque(s, c, sigma)
        free_normal = self.gn - eps * c * u
        part = free_normal / self.stiffness(s, c, sigma)
        normal = self.kap * part
        slip = self.gt + eps * s * u - part * (drag * self.kap + (1 + eps * c) * q)
        return Forces(q * part, normal, -drag * normal, slip, free_normal)

    def divisor(self, s: Series, c: Series, sigma: int) -> Series:
        """The divisor of θ̈: D − ρ ε sin θ in rolling, κ p_σ in slip."""
        return self.stiffness(s, c, sigma) if sigma else self.inertia(c) - self.rho * self.eps * s

    def rates(self, s: Series, c: Series, sigma: int) -> tuple[Series, Series]:
        """(A, B) of du/dθ = A u + B for u = θ̇², in rolling (σ = 0) or slip."""
        eps, divisor = self.eps, self.divisor(s, c, sigma)
        if sigma:
            rate = 2 * self.torque(s, c, sigma) / divisor
            return -(rate * (eps * c)), rate * self.gn
        push = eps * s * self.gn + self.gt * (1 + eps * c) - self.rho * self.gn
        return 2 * eps * (s + self.rho * c) / divisor, 2 * push / divisor

    def forces(self, s: Series, c: Series, u: Series, sigma: int) -> Forces:
        """Rolling (σ = 0) or slip."""
        return self.rolling(s, c, u) if sigma == 0 else self.slipping(s, c, u, sigma)

    def arm(self, s: Ball, c: Ball, sigma: int) -> Ball:
        """1 + ε cos θ − σ μ ε sin θ: v_t + θ̇ times this feels gravity alone in slip."""
        return 1 + self.eps * c - sigma * self.mu_k * self.eps * s

    def candidate(self, th: Ball, om: Ball, sigma: int, terms: int) -> tuple[Jet, Jet, Jet, Jet]:
        """Time series of (N, F, v̇_t, θ̇) along rolling or slip from here."""
        with order(terms):
            angle, rate = series([th]), series([om])
            found = None
            for _ in range(terms + 1):
                s, c = angle.sin_cos()
                found = self.forces(s, c, rate * rate, sigma)
                rate = (series([0]) + found.alpha).integral() + om
                angle = rate.integral() + th
            assert found is not None
            return (
                coefficients(series([0]) + found.normal, terms),
                coefficients(series([0]) + found.friction, terms),
                coefficients(series([0]) + found.slip, terms),
                coefficients(rate, terms),
            )


class Still(Model):
    """A hoop that the rolling resistance keeps from turning: at rest, or sliding at a constant angle.

    Parameters
    ----------
    model : Model
        Of the same hoop and plane.
    """

    def __init__(self, model: Model) -> None:
        self.__dict__.update(model.__dict__)

    def stiffness(self, s: Series, c: Series, sigma: int) -> Series:
        """κ p_σ, where q = 0."""
        return s * 0 + self.kap

    def rolling(self, s: Series, c: Series, u: Series) -> Forces:
        """Rest."""
        zero = s * 0
        return Forces(zero, zero + self.gn, zero - self.gt, zero, zero + self.gn)

    def slipping(self, s: Series, c: Series, u: Series, sigma: int) -> Forces:
        """Slip without rotation."""
        zero, drag = s * 0, sigma * self.mu_k
        normal = zero + self.gn
        return Forces(zero, normal, -drag * normal, self.gt - drag * normal, normal)
