"""Rolling in closed form: margins as functions of the angle alone, time as a rigorous integral."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from hophoop.prove import _flint
from hophoop.prove._flint import Ball, Jet, Undecided, arb, coefficients, order, series, sign
from hophoop.prove.deadline import Deadline
from hophoop.prove.enclosures.mean_value_form import common, located, ranges
from hophoop.prove.enclosures.roots import exact, first_root
from hophoop.prove.physics.equations import Forces, Model, State

AHEAD, BACK, OPEN, TURN, SPAN = "ahead", "back", "open", "turn", "span"
FIRST_STEP = 0.15


@dataclass(frozen=True)
class Rolled:
    """The end of a piece of rolling: an event, or the end of the searched angle without one."""

    what: str | None
    th: Ball
    bracket: tuple[Ball, Ball] | None = None


class Rolling:
    """Rolling from a state: ½ D θ̇² + V = E.

    Parameters
    ----------
    model : Model
    state : State
        With v_t = 0.
    way : int
        Direction of rotation.
    at_turn : bool
        Whether θ̇ = 0 at the state.
    energy : Ball, optional
        E, if it is known more narrowly than from the state.
    """

    def __init__(self, model: Model, state: State, way: int, at_turn: bool, energy: Ball | None = None) -> None:
        self.model, self.begin, self.way, self.at_turn = model, state, way, at_turn
        s, c = state.th.sin_cos()
        self.energy = model.height(state.th, s, c)
        if not at_turn:
            self.energy += model.inertia(c) * state.om * state.om / 2
        if energy is not None:
            self.energy = common(self.energy, energy)
        self.names = [AHEAD, BACK, TURN] if model.mu_s is not None else [OPEN, TURN]

    def square(self, th: Ball) -> Ball:
        """θ̇² at an angle."""
        s, c = th.sin_cos()
        return 2 * (self.energy - self.model.height(th, s, c)) / self.model.inertia(c)

    def forces(self, th: Ball) -> Forces:
        """Forces at an angle."""
        s, c = th.sin_cos()
        return self.model.rolling(s, c, self.square(th))

    def margins(self, th: Ball, terms: int) -> list[Jet]:
        """μ N − F, μ N + F (or N) and the energy above V, as series in the way along θ."""
        model = self.model
        model.deadline.ask()
        with order(terms):
            z = series([th, self.way])
            s, c = z.sin_cos()
            excess = self.energy - model.height(z, s, c)
            forces = model.rolling(s, c, 2 * excess / model.inertia(c))
            if model.mu_s is None:
                found = [forces.normal, excess]
            else:
                hold = model.mu_s * forces.normal
                found = [hold - forces.friction, hold + forces.friction, excess]
            return [coefficients(series([0]) + one, terms) for one in found]

    def first(self, reach: Ball, zeros: Sequence[int], base: Ball | None = None, limit: Ball | None = None) -> Rolled:
        """The first event within `reach` of the start (or of `base`, which was reached without one).

        `limit` is the angle to go from the middle of that: `base` may vary over a box.
        """
        origin = exact(self.begin.th if base is None else base)
        spread = (self.begin.th if base is None else base) - origin

        def evaluate(x: Ball, terms: int) -> list[Jet]:
            found = self.margins(origin + self.way * x, terms)
            if limit is not None:
                found.append([limit - x, arb(-1)] + [arb(0)] * (terms - 2) if terms > 1 else [limit - x])
            return found

        known = list(zeros) + ([0] if limit is not None else [])
        start = -spread.abs_upper() if not spread.is_zero() else arb(0)

        def values(x: Ball, terms: int) -> list[Jet]:
            return ranges(evaluate(x, terms))

        root = first_root(values, known, start, exact(reach), arb(FIRST_STEP).mid(), self.model.varying > 0)
        if root is None:
            return Rolled(None, origin + self.way * exact(reach))
        names = [*self.names, SPAN]
        ends = tuple(origin + self.way * x for x in (root.low, root.high))
        return Rolled(names[root.index], origin + self.way * located(evaluate, root), (ends[0], ends[1]))

    # --- time ------------------------------------------------------------------------------------

    def duration(self, th_a: Ball, th_b: Ball, turn_a: bool = False, turn_b: bool = False) -> Ball:
        """Time from one angle to another further on; `turn_a`, `turn_b`: θ̇ = 0 there."""
        if turn_a and turn_b:
            middle = exact((th_a + th_b) / 2)
            return self.duration(th_a, middle, True) + self.duration(middle, th_b, False, True)
        if turn_a:
            return self._from_turn(th_a, th_b, self.way)
        if turn_b:
            return self._from_turn(th_b, th_a, -self.way)
        model, energy = self.model, self.energy

        def slowness(z: Ball, analytic: bool) -> Ball:
            s, c = z.sin(), z.cos()
            return (model.inertia(c) / (2 * (energy - model.height(z, s, c)))).sqrt(analytic=analytic)

        return self.way * _integral(slowness, th_a, th_b, model.deadline)

    def _from_turn(self, turn: Ball, other: Ball, way: int) -> Ball:
        """With θ = turn + way w² the slowness has no singularity."""
        model = self.model
        extent = (way * (other - turn)).sqrt()

        def slowness(w: Ball, analytic: bool) -> Ball:
            d = way * w * w
            middle = turn + d / 2
            drop = model.eps * (d / 2).sinc() * (model.gn * middle.sin() + model.gt * middle.cos()) + model.gt
            return 2 * (model.inertia((turn + d).cos()) / (2 * way * drop)).sqrt(analytic=analytic)

        return _integral(slowness, arb(0), extent, model.deadline)


def _integral(function: Callable[[Ball, bool], Ball], a: Ball, b: Ball, deadline: Deadline) -> Ball:
    flint = _flint

    def watched(z: Ball, analytic: bool) -> Ball:
        """Zero when the time is over, which ends the integral: no exception gets through it."""
        return flint.acb(0) if deadline.over() else function(z, analytic)

    value = flint.acb.integral(watched, flint.acb(a), flint.acb(b))
    deadline.ask()
    if not value.is_finite():
        raise Undecided("a time along rolling has no enclosure")
    return value.real


def still(model: Model, state: State) -> int:
    """Direction in which rolling begins from θ̇ = 0; 0 for rest, which only exact zeros show."""
    s, c = state.th.sin_cos()
    return sign(model.rolling(s, c, arb(0)).alpha, "θ̈ of the hoop at rest")
