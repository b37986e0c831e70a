"""Flight in closed form: the gap between take-off and landing is shown to be positive."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from hophoop.prove._flint import Ball, Jet, Undecided, arb, sign
from hophoop.prove.enclosures.roots import Root, exact, first_root
from hophoop.prove.physics.equations import Model, State


@dataclass(frozen=True)
class Flight:
    """Flight from a state.

    Attributes
    ----------
    zeros : int
        How many derivatives of the gap are zero at the start, its value included.
    """

    model: Model
    begin: State
    zeros: int

    def gap(self, tau: Ball, terms: int) -> Jet:
        """Taylor coefficients of the gap at τ."""
        model, begin = self.model, self.begin
        model.deadline.ask()
        eps, om = model.eps, begin.om
        s0, c0 = begin.th.sin_cos()
        s, c = (begin.th + om * tau).sin_cos()
        rise = begin.vn - eps * om * s0
        found = [
            begin.y + rise * tau - model.gn * tau * tau / 2 + eps * (c0 - c),
            rise - model.gn * tau + eps * om * s,
            (eps * om * om * c - model.gn) / 2,
        ]
        wave = [-eps * c, eps * om * s]  # of these two each derivative is −θ̇² times the one before the last
        for k in range(2, terms):
            wave.append(-om * om * wave[-2] / (k * (k - 1)))
        return [*found, *wave[3:]][:terms]

    def state(self, tau: Ball) -> State:
        """The state after τ."""
        model, begin = self.model, self.begin
        s0, c0 = begin.th.sin_cos()
        th = begin.th + begin.om * tau
        s, c = th.sin_cos()
        along = begin.vt + begin.om * (1 + model.eps * c0)
        y, vn = self.gap(tau, 2)
        x = begin.x + along * tau + model.gt * tau * tau / 2 - model.eps * (s - s0)
        vt = begin.vt + model.gt * tau - model.eps * begin.om * (c - c0)
        return State(begin.t + tau, x, y, th, vt, vn, begin.om)

    def hovers(self) -> bool:
        """Return True if the rim stays on the plane without force."""
        bare = self.begin.y.is_zero() and self.begin.vn.is_zero() and self.model.gn.is_zero()
        return bool(bare and (self.begin.om.is_zero() or self.model.eps.is_zero()))

    def skims(self) -> bool:
        """Return True if the gap never falls below zero, though it may touch it: without gravity, G at a constant height."""
        model, begin = self.model, self.begin
        s, c = begin.th.sin_cos()
        rise, least = begin.vn - model.eps * begin.om * s, begin.y + model.eps * (c - 1)
        return bool(model.gn.is_zero() and rise.is_zero() and (least.is_zero() or least > 0))

    def lands(self, longest: Ball) -> Root | None:
        """The first landing, None where there is none within `longest`."""
        if not longest > 0:
            raise Undecided("an event and the end of the time come together")
        if self.skims():
            return None
        step = exact((longest / 64).union(arb(0)).upper())
        step = arb(0.125) if step > 0.125 else step
        root = first_root(lambda tau, terms: [self.gap(tau, terms)], [self.zeros], arb(0), exact(longest.upper()), step)
        if root is None:
            return None
        if not self.gap(root.x, 2)[1] < 0:
            raise Undecided("the rim grazes the plane")
        return root

    def apex(self, until: Ball) -> tuple[State, Root] | None:
        """The state, and τ, where the gap is largest inside the flight."""
        end = exact(until.lower())
        way = 1
        at, zeros = arb(0), max(self.zeros - 1, 0)
        if self.zeros == 0 or self.zeros == 1:
            zeros, way = 0, sign(self.begin.vn, "ẏ at the start of a flight")
            if way == 0:
                zeros, way = 1, sign(self.gap(arb(0), 3)[2], "ÿ at the start of a flight")
        best: tuple[State, Root] | None = None
        while True:
            root = first_root(partial(self._rate, way), [zeros], at, end, arb(0.125))
            if root is None:
                return best
            if way > 0:
                top = self.state(root.x)
                if best is None or top.y > best[0].y:
                    best = top, root
                elif not top.y < best[0].y:
                    raise Undecided("two tops of a flight are equally high")
            # just beyond the bracket of the only root the rate has the other sign
            at, way, zeros = root.high, -way, 0

    def _rate(self, way: int, tau: Ball, terms: int) -> list[Jet]:
        """The derivative of the gap with the sign that makes it positive."""
        gap = self.gap(tau, terms + 1)
        return [[way * k * gap[k] for k in range(1, min(terms, len(gap) - 1) + 1)]]
