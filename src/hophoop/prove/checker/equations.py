"""The numbers of a certificate's scenario and the equations of docs/model.md, written with W and f."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from hophoop.prove._flint import Ball, Jet, Series, arb, coefficients, order, rational, series


class Refused(Exception):
    """A step of a certificate that could not be verified; the text says which, as a clause."""


@dataclass
class State:
    """An instant, in units of R, m and √(R/g)."""

    t: Ball
    x: Ball
    y: Ball
    th: Ball
    vt: Ball
    vn: Ball
    om: Ball


@dataclass
class Contact:
    """(θ̇̇, N, F, v̇_t, v̇_n without contact, κ p_σ) at an instant."""

    alpha: Series
    normal: Series
    friction: Series
    slip: Series
    free: Series
    firm: Series


class Equations:
    """Hoop and plane as balls.

    Parameters
    ----------
    scenario : dict
        As in a scenario file.
    """

    def __init__(self, scenario: dict[str, Any]) -> None:
        hoop, plane, start = scenario["hoop"], scenario["plane"], scenario["start"]
        if plane.get("rolling_resistance", 0.0) != 0.0:
            raise Refused("the plane has no rolling resistance")
        radius = Fraction(hoop["radius"])
        mass, eps, kap = _body(hoop, radius)
        static, kinetic = (plane.get(f"mu_{kind}", plane.get("mu")) for kind in ("static", "kinetic"))
        self.equal_friction = static == kinetic
        self.eps, self.kap, self.mass, self.length = rational(eps), rational(kap), rational(mass), rational(radius)
        self.mu_s, self.mu_k = _friction(static), _friction(kinetic)
        gravity = Fraction(plane["gravity"])
        slope = rational(Fraction(plane["slope"]))
        self.gn, self.gt = (slope.cos(), slope.sin()) if gravity else (arb(0), arb(0))
        self.rest, self.law = rational(Fraction(plane["restitution"])), plane["impact_law"]
        self.strike = plane["painleve"] == "impact"
        self.time = (self.length / rational(gravity or Fraction(1))).sqrt()
        self.speed = self.length / self.time
        self.t_end = rational(Fraction(scenario["duration"])) / self.time
        self.start = self._start(start, radius)

    def _start(self, start: dict[str, Any], radius: Fraction) -> State:
        at = {name: Fraction(start.get(name, 0.0)) for name in ("x", "height", "angle", "vx", "vy", "omega")}
        if "speed" in start:  # rolling: v_t = 0 exactly
            at["omega"], slip = Fraction(start["speed"]) / radius, Fraction(0)
        else:
            slip = at["vx"] - radius * at["omega"]
        return State(
            arb(0),
            rational(at["x"] / radius),
            rational(at["height"] / radius),
            rational(at["angle"]),
            rational(slip) / self.speed if slip else arb(0),
            rational(at["vy"]) / self.speed if at["vy"] else arb(0),
            rational(at["omega"]) * self.time if at["omega"] else arb(0),
        )

    def delassus(self, s: Series, c: Series) -> tuple[Series, Series, Series]:
        """κ (W_tt, W_nn, W_tn)."""
        arm, lever = 1 + self.eps * c, self.eps * s
        return self.kap + arm * arm, self.kap + lever * lever, -lever * arm

    def contact(self, s: Series, c: Series, u: Series, sigma: int) -> Contact:
        """Rolling (σ = 0) or slip in the direction σ, with θ̇² = u."""
        w_tt, w_nn, w_tn = self.delassus(s, c)
        f_t, f_n = self.gt + self.eps * s * u, self.eps * c * u - self.gn
        arm, lever = 1 + self.eps * c, self.eps * s
        if sigma == 0:
            firm = self.kap + lever * lever + arm * arm  # det W · κ
            normal = (w_tn * f_t - w_tt * f_n) / firm
            friction = (w_tn * f_n - w_nn * f_t) / firm
        else:
            drag = sigma * self.mu_k
            firm = w_nn - drag * w_tn
            normal = -self.kap * f_n / firm
            friction = -drag * normal
        alpha = (lever * normal - arm * friction) / self.kap
        slip = (w_tt * friction + w_tn * normal) / self.kap + f_t
        return Contact(alpha, normal, friction, slip, f_n, firm)

    def height(self, z: Series, s: Series, c: Series) -> Series:
        """What ½ D θ̇² lacks to a constant in rolling."""
        return self.eps * (self.gn * c - self.gt * s) - self.gt * z

    def inertia(self, c: Series) -> Series:
        """D."""
        return self.kap + (1 - self.eps) * (1 - self.eps) + 2 * self.eps * (1 + c)

    def square(self, th: Ball, u: Ball, way: int, sigma: int, terms: int) -> Series:
        """θ̇² as a series in way·θ: u ← u(0) + ∫ 2 way θ̈; call it within `order`."""
        z = series([th, way])
        s, c = z.sin_cos()
        found = series([u])
        for _ in range(terms):
            found = (series([0]) + 2 * way * self.contact(s, c, found, sigma).alpha).integral() + u
        return found

    def in_time(self, th: Ball, om: Ball, sigma: int, terms: int) -> dict[str, Jet]:
        """Time series of N, F and v̇_t from an instant."""
        with order(terms):
            angle, rate = series([th]), series([om])
            for _ in range(terms + 1):
                s, c = angle.sin_cos()
                found = self.contact(s, c, rate * rate, sigma)
                rate = (series([0]) + found.alpha).integral() + om
                angle = rate.integral() + th
            wanted = {"normal": found.normal, "friction": found.friction, "slip": found.slip}
            return {name: coefficients(series([0]) + value, terms) for name, value in wanted.items()}


def _friction(value: Any) -> Ball:
    number = float(value)
    return None if math.isinf(number) else rational(Fraction(number))


def _body(hoop: dict[str, Any], radius: Fraction) -> tuple[Fraction, Fraction, Fraction]:
    """(mass, ε, κ) without rounding."""
    if "parts" in hoop:
        parts = [(Fraction(part["mass"]), Fraction(part.get("at", 0)) / radius, part) for part in hoop["parts"]]
        mass = sum((one[0] for one in parts), Fraction(0))
        centre = sum((m * at for m, at, _ in parts), Fraction(0)) / mass
        inertia = sum((m * (_gyration(part) / radius**2 + (at - centre) ** 2) for m, at, part in parts), Fraction(0))
        return mass, min(abs(centre), Fraction(1)), inertia / mass
    if "load_fraction" in hoop:
        gamma = Fraction(hoop["load_fraction"])
        return Fraction(hoop["mass"]), gamma, 1 - gamma * gamma
    return Fraction(hoop["mass"]), Fraction(hoop["eccentricity"]), Fraction(hoop["inertia_ratio"])


def _gyration(part: dict[str, Any]) -> Fraction:
    """Square of a part's radius of gyration."""
    if part["shape"] == "ring":
        return (Fraction(part["inner_radius"]) ** 2 + Fraction(part["outer_radius"]) ** 2) / 2
    if part["shape"] == "disk":
        return Fraction(part["radius"]) ** 2 / 2
    if part["shape"] == "rod":
        return Fraction(part["length"]) ** 2 / 12
    return Fraction(0)
