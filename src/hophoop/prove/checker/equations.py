"""The numbers of a certificate's scenario and the equations of docs/model.md, written with W and f."""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from hophoop.prove._flint import Ball, Jet, Series, arb, coefficients, order, rational, series
from hophoop.prove.deadline import Deadline


class Refused(Exception):
    """A step of a certificate that could not be verified; the text says what, as a clause."""


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
    divisor: Series


class Equations:
    """Hoop and plane as balls.

    Parameters
    ----------
    scenario : dict
        As in a scenario file.
    deadline : Deadline, optional
        Asked by whatever evaluates them again and again.
    """

    def __init__(self, scenario: dict[str, Any], deadline: Deadline | None = None) -> None:
        self.deadline = deadline or Deadline()
        hoop, plane, start = scenario["hoop"], scenario["plane"], scenario["start"]
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
        self.resist = rational(Fraction(plane.get("rolling_resistance", 0.0)))
        self.couple = arb(0)  # over N, against a hoop that turns as `turning` says
        self.held = False  # whether the couple keeps the hoop from turning
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

    def in_si(self, state: State) -> dict[str, tuple[Ball, Ball]]:
        """The numbers of an event, each with its unit made of R and g."""
        return {
            "t": (state.t * self.time, self.time), "x": (state.x * self.length, self.length),
            "height": (state.y * self.length, self.length), "angle": (state.th, arb(1)),
            "vx": ((state.vt + state.om) * self.speed, self.speed), "vy": (state.vn * self.speed, self.speed),
            "omega": (state.om / self.time, 1 / self.time),
        }  # fmt: skip

    def delassus(self, s: Series, c: Series) -> tuple[Series, Series, Series]:
        """κ (W_tt, W_nn, W_tn), without the couple: of impacts."""
        arm, lever = 1 + self.eps * c, self.eps * s
        return self.kap + arm * arm, self.kap + lever * lever, -lever * arm

    @property
    def resisted(self) -> bool:
        """True if there is rolling resistance."""
        return not self.resist.is_zero()

    def turning(self, way: int) -> Equations:
        """The equations while the hoop turns in a direction."""
        found = copy(self)
        found.couple = way * self.resist
        return found

    def just_after(self, th: Ball, om: Ball, sigma: int) -> Equations:
        """The equations just after an instant: of the direction in which the hoop turns, or is made to turn, or is held."""
        if not self.resisted:
            return self
        if om > 0 or om < 0:
            return self.turning(1 if om > 0 else -1)
        if not om.is_zero():
            raise Refused("the direction of rotation is certain")
        # at θ̇ = 0 the moment without the couple, over N or over g cos β, relative to the maximum of the couple
        s, c = th.sin_cos()
        moment, most = self.eps * s, self.resist
        if sigma:
            moment += sigma * self.mu_k * (1 + self.eps * c)
        else:
            moment, most = moment * self.gn + self.gt * (1 + self.eps * c), most * self.gn
        if abs(moment) > most:
            return self.turning(1 if moment > 0 else -1)
        if not abs(moment) <= most:
            raise Refused("whether the couple holds the hoop is certain")
        found = copy(self)
        found.held = True
        return found

    def contact(self, s: Series, c: Series, u: Series, sigma: int) -> Contact:
        """Rolling (σ = 0) or slip in the direction σ, with θ̇² = u; W has the couple, so that it is not symmetric."""
        self.deadline.ask()
        drag = sigma * self.mu_k if sigma else arb(0)
        if self.held:
            zero = s * 0
            friction = -drag * self.gn if sigma else -self.gt
            return Contact(zero, zero + self.gn, zero + friction, zero + friction + self.gt, zero - self.gn, zero + self.kap)
        arm, lever = 1 + self.eps * c, self.eps * s
        behind = lever - self.couple
        w_tt, w_nn, w_tn, w_nt = self.kap + arm * arm, self.kap + lever * behind, -behind * arm, -lever * arm
        f_t, f_n = self.gt + self.eps * s * u, self.eps * c * u - self.gn
        if sigma == 0:
            divisor = self.kap + lever * behind + arm * arm  # det W · κ
            normal = (w_nt * f_t - w_tt * f_n) / divisor
            friction = (w_tn * f_n - w_nn * f_t) / divisor
        else:
            divisor = w_nn - drag * w_nt
            normal = -self.kap * f_n / divisor
            friction = -drag * normal
        alpha = (behind * normal - arm * friction) / self.kap
        slip = (w_tt * friction + w_tn * normal) / self.kap + f_t
        return Contact(alpha, normal, friction, slip, f_n, divisor)

    def margins(self, contact: Contact) -> list[Series]:
        """What keeps a rolling hoop from slipping ahead and back: μ N − F and μ N + F; N if friction is infinite."""
        if self.mu_s is None:
            return [contact.normal]
        hold = self.mu_s * contact.normal
        return [hold - contact.friction, hold + contact.friction]

    def linear(self, s: Any, c: Any, sigma: int) -> tuple[Any, Any, Any]:
        """(d, a, b) of d θ̈ = a u + b, without a division: for polynomials as well as balls."""
        self.deadline.ask()
        arm, lever = 1 + c * self.eps, s * self.eps
        behind = lever - self.couple
        if sigma:
            torque = behind + arm * (sigma * self.mu_k)
            return lever * torque + self.kap, -(torque * c * self.eps), torque * self.gn
        divisor = lever * behind + arm * arm + self.kap
        return divisor, lever + c * (self.couple * self.eps), behind * self.gn + arm * self.gt

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
        after = self.just_after(th, om, sigma)
        with order(terms):
            angle, rate = series([th]), series([om])
            for _ in range(terms + 1):
                s, c = angle.sin_cos()
                found = after.contact(s, c, rate * rate, sigma)
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
