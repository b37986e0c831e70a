"""The equations of slip and of rolling with resistance: margins and state from θ, θ̇ and t."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hophoop.prove._flint import Ball, Jet, arb, coefficients, order, series
from hophoop.prove.checker.equations import Equations, State
from hophoop.prove.checker.intervals import require

LIFT, STOP, AHEAD, BACK, OPEN = "lift", "stop", "ahead", "back", "open"


@dataclass
class Slip:
    """Slip and the state it began in: gravity alone changes its momentum."""

    equations: Equations
    sigma: int
    begin: State

    @property
    def names(self) -> list[str]:
        """N → 0, v_t → 0."""
        return [LIFT, STOP]

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

    def along(self, panel: Any, x: Ball, terms: int) -> list[Jet]:
        """(N, σ v_t) as series in x."""
        model, sigma, middle = self.equations, self.sigma, x.mid()
        here = sigma * self.velocity(panel.time(middle), panel.angle(middle), panel.spin(middle))
        th = panel.angle(x)
        with order(terms):
            z = series([th, panel.way])
            s, c = z.sin_cos()
            u = model.square(th, panel.square(x), panel.way, sigma, terms - 1)
            contact = model.contact(s, c, u, sigma)
            free_normal = coefficients(series([0]) - contact.free, terms)
            rate = coefficients(sigma * contact.slip * (series([0]) + u).rsqrt(), terms)
        return [free_normal, [here + rate[0] * (x - middle)] + [rate[k - 1] / k for k in range(1, terms)]]

    def about(self, panel: Any, w: Ball, terms: int) -> list[Jet]:
        """(N, σ v_t) with their slopes in w."""
        require(terms <= 2, "slip from θ̇ = 0 begins with an acceleration")
        model, sigma, middle = self.equations, self.sigma, w.mid()
        here = sigma * self.velocity(panel.time(middle), panel.angle(middle), panel.spin(middle))
        over = panel.over(w)
        s, c = panel.angle(w).sin_cos()
        contact = model.contact(s, c, w * w * over, sigma)
        rate = 2 * sigma * contact.slip * over.rsqrt()
        # free_normal = g − ε cos θ u, with dθ/dw = −2 way w
        fall = -2 * panel.way * w * model.eps * (s * w * w * over - 2 * c * contact.alpha)
        return [[-contact.free, fall][:terms], [here + rate * (w - middle), rate][:terms]]


@dataclass
class Roll:
    """Rolling with resistance: v_t = 0, and the state it began in."""

    equations: Equations
    sigma: int
    begin: State

    @property
    def names(self) -> list[str]:
        """The friction used up on one side or the other; with infinite friction N → 0."""
        return [OPEN] if self.equations.mu_s is None else [AHEAD, BACK]

    def state(self, t: Ball, th: Ball, om: Ball) -> State:
        """The state at a time and angle."""
        return State(t, self.begin.x + (th - self.begin.th), arb(0), th, arb(0), arb(0), om)

    def along(self, panel: Any, x: Ball, terms: int) -> list[Jet]:
        """μ N − F and μ N + F, or N, as series in x."""
        th = panel.angle(x)
        with order(terms):
            u = self.equations.square(th, panel.square(x), panel.way, 0, terms - 1)
            return self._margins(series([th, panel.way]), u, terms)

    def about(self, panel: Any, w: Ball, terms: int) -> list[Jet]:
        """The same with slopes in w."""
        require(terms <= 2, "rolling from θ̇ = 0 begins with certain margins")
        th, u, turned = panel.angle(w), panel.square(w), -2 * panel.way * w
        s, c = th.sin_cos()
        rate = 2 * turned * self.equations.contact(s, c, u, 0).alpha
        with order(terms):
            return self._margins(series([th, turned]), series([u, rate]), terms)

    def _margins(self, z: Any, u: Any, terms: int) -> list[Jet]:
        s, c = z.sin_cos()
        found = self.equations.margins(self.equations.contact(s, c, u, 0))
        return [coefficients(series([0]) + one, terms) for one in found]
