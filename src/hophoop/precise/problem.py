"""A scenario as exact numbers: every given double is the rational number that it is."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from mpmath import MPContext

from hophoop.kernel.model import MODE_LETTERS
from hophoop.kernel.records import State, combined
from hophoop.precise.kernels import Kernels, Number, numbers_of
from hophoop.precise.series import Work
from hophoop.scenario import Hoop, Scenario
from hophoop.vocabulary.names import LAW_CODES


@dataclass(frozen=True)
class Problem:
    """The exact numbers of a scenario, in SI units; friction is None where it is infinite."""

    radius: Fraction
    mass: Fraction
    eps: Fraction
    kap: Fraction
    gravity: Fraction
    slope: Fraction
    mu_s: Fraction | None
    mu_k: Fraction | None
    rest: Fraction
    resist: Fraction
    law: int
    painleve_impact: bool
    x: Fraction
    height: Fraction
    angle: Fraction
    slip: Fraction
    vy: Fraction
    omega: Fraction
    duration: Fraction
    max_events: int
    mode: int | None = None  # of the start, if it is given

    @classmethod
    def of(cls, scenario: Scenario) -> Problem:
        """The problem of a rigid scenario.

        κ of an ideal hoop is 1 − γ² without rounding, and ε and κ of a hoop of parts follow from the parts' numbers
        without rounding, though the scenario itself rounds both to doubles.
        """
        hoop, plane, start = scenario.hoop, scenario.plane, scenario.start
        radius = Fraction(hoop.radius)
        mass, eps, kap = _body(hoop)
        if start.speed is not None:
            slip, omega = Fraction(0), Fraction(start.speed) / radius
        else:
            omega = Fraction(start.omega or 0.0)
            slip = Fraction(start.vx) - radius * omega if start.slip is None else Fraction(start.slip)
        return cls(
            radius=radius,
            mass=mass,
            eps=eps,
            kap=kap,
            gravity=Fraction(plane.gravity),
            slope=Fraction(plane.slope),
            mu_s=_friction(plane.mu_static),
            mu_k=_friction(plane.mu_kinetic),
            rest=Fraction(plane.restitution),
            resist=Fraction(plane.rolling_resistance),
            law=LAW_CODES[plane.impact_law],
            painleve_impact=plane.painleve == "impact",
            x=Fraction(start.x),
            height=Fraction(start.height),
            angle=Fraction(start.angle),
            slip=slip,
            vy=Fraction(start.vy),
            omega=omega,
            duration=Fraction(scenario.duration),
            max_events=scenario.contact.max_events,
            mode=None if start.mode is None else MODE_LETTERS.index(start.mode),
        )

    def tiny(self) -> int:
        """The bits by which the smallest number other than 0 is below 1, in units of the kernel."""
        unit = self.gravity / self.radius if self.gravity else 1 / self.radius
        speeds = (self.slip / self.radius, self.vy / self.radius, self.omega)
        sizes = [number**2 / unit for number in speeds if number]
        sizes += [number**2 for number in (self.angle, self.slope, self.height / self.radius) if number]
        sizes += [number for number in (1 - self.eps, self.kap, self.eps, self.mu_k or Fraction(0), self.resist) if number]
        return max([0, *(-(_exponent(size) // 2) for size in sizes)])


def _exponent(number: Fraction) -> int:
    return number.numerator.bit_length() - number.denominator.bit_length()


def _friction(mu: float) -> Fraction | None:
    return Fraction(mu) if math.isfinite(mu) else None


def _body(hoop: Hoop) -> tuple[Fraction, Fraction, Fraction]:
    """(mass, ε, κ) without rounding."""
    if hoop.parts is not None:
        rows = np.array([list(map(Fraction, part.row)) for part in hoop.parts], dtype=object)
        exact = Kernels(Fraction, {"plus": lambda high, low, value: (high + value, low)})
        found: tuple[Fraction, Fraction, Fraction] = exact(combined)(Fraction(hoop.radius), rows)
        return found
    mass = Fraction(hoop.mass)
    if hoop.load_fraction is not None:
        gamma = Fraction(hoop.load_fraction)
        return mass, gamma, 1 - gamma * gamma
    return mass, Fraction(hoop.eccentricity), Fraction(hoop.inertia_ratio)


class Fixed(NamedTuple):
    """The body as fixed-point integers."""

    bits: int
    eps: int
    kap: int
    mu_k: int  # 0 if it is infinite: then there is no slip
    gn: int
    gt: int


class Body:
    """The body at one working precision, in units of R, m and √(R/g).

    Parameters
    ----------
    problem : Problem
    bits : int
        Working precision.
    work : Work, optional
        What its steps of contact and flight are taken from; without end by default.
    """

    def __init__(self, problem: Problem, bits: int, work: Work | None = None) -> None:
        self.bits = bits
        self.work = Work(math.inf) if work is None else work
        self.ctx = ctx = MPContext()
        ctx.prec = bits
        self.zero, self.one = ctx.mpf(0), ctx.mpf(1)
        self.take(problem, ctx.inf, ctx.sqrt, lambda angle: (ctx.sin(angle), ctx.cos(angle)))
        self.kernels = Kernels(ctx.mpf, numbers_of(ctx))
        self.fixed = Fixed(bits, *map(self.integer, (self.eps, self.kap, self.mu_k, self.gn, self.gt)))

    def take(
        self, problem: Problem, infinite: Number, root: Callable[[Number], Number], sine_cosine: Callable[[Number], Any]
    ) -> None:
        """Take the numbers of a problem, by functions of the numbers that it works with."""
        self.problem, self.law, self.painleve_impact = problem, problem.law, problem.painleve_impact
        self.eps, self.kap, self.rest = (self.number(n) for n in (problem.eps, problem.kap, problem.rest))
        self.mu_s, self.mu_k = (infinite if mu is None else self.number(mu) for mu in (problem.mu_s, problem.mu_k))
        self.mass, self.length, self.resist = (self.number(n) for n in (problem.mass, problem.radius, problem.resist))
        self.time = root(self.length / self.number(problem.gravity or Fraction(1)))
        s, c = sine_cosine(self.number(problem.slope))
        self.gn, self.gt = (c, s) if problem.gravity else (self.zero, self.zero)

    def number(self, value: Fraction) -> Number:
        """A rational number, rounded once."""
        return self.ctx.mpf(value.numerator) / value.denominator

    def integer(self, value: Number) -> int:
        """The fixed-point integer of a number."""
        sign, man, exp, _ = value._mpf_
        shift = exp + self.bits
        man = int(man)
        whole: int = man << shift if shift >= 0 else man >> -shift
        return -whole if sign else whole

    def of_integer(self, value: int) -> Number:
        """The number of a fixed-point integer."""
        return self.ctx.ldexp(self.ctx.mpf(value), -self.bits)

    def start(self) -> State:
        """The state at t = 0; its low-order halves and its count of revolutions are and remain 0."""
        problem, zero = self.problem, self.zero
        speed = self.length / self.time
        x, y = self.number(problem.x / problem.radius), self.number(problem.height / problem.radius)
        vt, vn = self.number(problem.slip) / speed, self.number(problem.vy) / speed
        th, om = self.number(problem.angle), self.number(problem.omega) * self.time
        return State(zero, zero, x, zero, y, zero, th, zero, vt, vn, om, zero, zero, zero, zero)
