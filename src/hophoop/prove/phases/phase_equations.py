"""The equations of one phase of contact: a linear one of θ̇² over θ, and what follows from it.

In slip du/dθ = 2 q (g cos β − ε cos θ u)/(κ p_σ) for u = θ̇², in rolling with resistance it is as linear; the time is
∫ dθ/√u.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, Protocol

from hophoop.prove import _flint
from hophoop.prove._flint import (
    Ball,
    Jet,
    Series,
    Undecided,
    arb,
    coefficients,
    intersection,
    order,
    symmetric,
)
from hophoop.prove.enclosures.mean_value_form import at_centre, derivatives, over, series
from hophoop.prove.enclosures.roots import exact
from hophoop.prove.physics.equations import Forces, Model, State

LIFT, STOP = "lift", "stop"
AHEAD, BACK, OPEN = "ahead", "back", "open"


class Place(Protocol):
    """What the equations read of a panel: functions of its own variable."""

    way: int

    def angle(self, x: Ball) -> Ball:
        """θ."""

    def square(self, x: Ball) -> Ball:
        """θ̇²."""

    def time(self, x: Ball) -> Ball:
        """t."""

    def spin(self, x: Ball) -> Ball:
        """θ̇."""


@dataclass(frozen=True)
class PhaseEquations(ABC):
    """A phase of contact: its equations for the direction in which the hoop turns, σ, and the state it began in."""

    model: Model
    sigma: int
    begin: State

    @property
    @abstractmethod
    def names(self) -> list[str]:
        """What ends the phase, in the order of `along`."""

    @property
    def ends_at_turn(self) -> bool:
        """True if the equations change at a turning point."""
        return self.model.resisted

    def plain(self) -> PhaseEquations:
        """The same as balls, which do not keep how they depend on the parameters of a box."""
        return phase_equations(self.model.plain(), self.sigma, _each(self.begin, over))

    def central(self) -> PhaseEquations:
        """At the centre of a box."""
        return phase_equations(self.model.central(), self.sigma, _each(self.begin, at_centre))

    def forces(self, th: Ball, u: Ball) -> Forces:
        """Forces at an angle."""
        self.model.deadline.ask()
        s, c = th.sin_cos()
        return self.model.forces(s, c, u, self.sigma)

    def slope(self, th: Ball, u: Ball) -> Ball:
        """du/dθ."""
        return 2 * self.forces(th, u).alpha

    def square(self, th: Ball, u: Ball, way: int, terms: int) -> Series:
        """u as a series in way·θ from a value; call it within `order`."""
        ask = self.model.deadline.ask
        ask()
        s, c = series([th, way]).sin_cos()
        ask()
        grow, push = self.model.rates(s, c, self.sigma)
        ask()
        shrunk = (-way * grow).integral().exp()
        ask()
        return ((way * push * shrunk).integral() + u) / shrunk

    @abstractmethod
    def state(self, t: Ball, th: Ball, om: Ball, stops: bool) -> State:
        """The state at a time and angle."""

    @abstractmethod
    def along(self, panel: Place, x: Ball, terms: int) -> list[Jet]:
        """What must stay positive, as series in x, where x is an angle."""

    @abstractmethod
    def about(self, panel: Place, w: Ball, terms: int) -> list[Jet]:
        """The same with slopes in w, where θ = θ* − way w²."""

    def slides(self, panel: Place, x: Ball) -> Ball:
        """v_t, where x is an angle."""
        return self.sigma * self.along(panel, x, 1)[1][0] if self.sigma else arb(0)


@dataclass(frozen=True)
class Slip(PhaseEquations):
    """A slip phase, in which gravity alone changes v_t + θ̇ (1 + ε cos θ − σ μ ε sin θ)."""

    kept: Ball

    @classmethod
    def of(cls, model: Model, sigma: int, state: State) -> Slip:
        """The slip that begins in a state."""
        s, c = state.th.sin_cos()
        return cls(model, sigma, state, state.vt + state.om * model.arm(s, c, sigma))

    @property
    def names(self) -> list[str]:
        """N → 0, v_t → 0."""
        return [LIFT, STOP]

    @property
    def steady(self) -> Ball:
        """The rate at which gravity changes `kept`."""
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

    def along(self, panel: Place, x: Ball, terms: int) -> list[Jet]:
        """(−f_n, σ v_t): N → 0, and the end of slip."""
        model, way = self.model, panel.way
        th, u = panel.angle(x), panel.square(x)
        middle = exact(x)
        here = self.velocity(panel.time(middle), panel.angle(middle), panel.spin(middle))
        with order(terms):
            z = series([th, way])
            s, c = z.sin_cos()
            squares = self.square(th, u, way, terms) if terms > 1 else series([u])
            free_normal = coefficients(series([0]) + (model.gn - model.eps * c * squares), terms)
            rate = coefficients(self.sigma * model.slipping(s, c, squares, self.sigma).slip * squares.rsqrt(), terms)
        velocity = [here + rate[0] * (x - middle)] + [rate[k - 1] / k for k in range(1, terms)]
        return [free_normal, velocity]

    def about(self, panel: Any, w: Ball, terms: int) -> list[Jet]:
        """(−f_n, σ v_t) with their slopes in w."""
        model = self.model
        if terms > 2:
            raise Undecided("slip begins with θ̇ = 0 and no acceleration")
        middle = exact(w)
        here = self.velocity(panel.time(middle), panel.angle(middle), panel.spin(middle))
        th, over = panel.angle(w), panel.over(w)
        u = w * w * over
        s, c = th.sin_cos()
        forces = model.slipping(s, c, u, self.sigma)
        rate = self.sigma * forces.slip * 2 * over.rsqrt()
        fall = -2 * panel.way * w * (model.eps * s * u - 2 * model.eps * c * forces.alpha)
        return [[forces.free_normal, fall][:terms], [here + rate * (w - middle), rate][:terms]]


@dataclass(frozen=True)
class Roll(PhaseEquations):
    """Rolling with resistance, which keeps nothing: its margins are those of the friction cone."""

    @property
    def names(self) -> list[str]:
        """The friction used up on one side or the other; with infinite friction N → 0."""
        return [AHEAD, BACK] if self.model.mu_s is not None else [OPEN]

    def state(self, t: Ball, th: Ball, om: Ball, stops: bool) -> State:
        """The state at a time and angle."""
        begin, zero = self.begin, arb(0)
        return State(t, begin.x + th - begin.th, zero, th, zero, zero, om)

    def margins(self, s: Series, c: Series, u: Series, terms: int) -> list[Jet]:
        """μ N − F and μ N + F, or N."""
        forces, zero = self.model.rolling(s, c, u), series([0])
        if self.model.mu_s is None:
            return [coefficients(zero + forces.normal, terms)]
        hold = self.model.mu_s * forces.normal
        return [coefficients(zero + hold - forces.friction, terms), coefficients(zero + hold + forces.friction, terms)]

    def along(self, panel: Place, x: Ball, terms: int) -> list[Jet]:
        """The margins as series in x."""
        th = panel.angle(x)
        with order(terms):
            s, c = series([th, panel.way]).sin_cos()
            return self.margins(s, c, self.square(th, panel.square(x), panel.way, terms), terms)

    def about(self, panel: Any, w: Ball, terms: int) -> list[Jet]:
        """The margins with their slopes in w."""
        th, u = panel.angle(w), panel.square(w)
        if terms > 2:
            raise Undecided("rolling begins with θ̇ = 0 in a tie")
        with order(terms):
            turned = -2 * panel.way * w
            s, c = series([th, turned]).sin_cos()
            return self.margins(s, c, series([u, self.slope(th, u) * turned]), terms)


def phase_equations(model: Model, sigma: int, state: State) -> Slip | Roll:
    """Return the equations from a state; `model` has those for the direction in which the hoop turns."""
    return Slip.of(model, sigma, state) if sigma else Roll(model, 0, state)


def _each(state: State, pick: Callable[[Any], Ball]) -> State:
    return State(*(pick(getattr(state, one.name)) for one in fields(state)))


@dataclass(frozen=True)
class Disc:
    """Bounds on a complex disc of du/dθ = A u + B: its radius, abs(A), abs(B), the angle, and of ∂A/∂p, ∂B/∂p in a box."""

    radius: Ball
    grow: Ball
    push: Ball
    angle: Ball
    grow_by: list[Ball]
    push_by: list[Ball]


def disc(phase: PhaseEquations, th: Ball, radius: Ball) -> Disc | None:
    """Bounds on the disc about θ; None where what θ̈ is divided by may vanish in it."""
    model, flint = phase.model, _flint
    model.deadline.ask()
    square = flint.acb(arb(th) + symmetric(radius), symmetric(radius))
    s, c = square.sin_cos()
    if model.divisor(s, c, phase.sigma).contains(flint.acb(0)):
        return None
    grow, push = model.rates(s, c, phase.sigma)
    count = model.varying

    def size(value: Ball) -> Ball:
        return abs(flint.acb(value)).abs_upper()

    by = ([size(one) for one in derivatives(rate, count)] for rate in (grow, push))
    return Disc(radius, size(over(grow)), size(over(push)), square, *by)


def square_at(phase: PhaseEquations, th: Ball, u: Ball, centre: Ball, energy: Ball | None = None) -> tuple[Ball, Ball]:
    """u at an exact angle inside the ball of the angle where it is known, and on the way there.

    Where slip begins out of rolling of this energy, both have the same slope there, or nearly so: u is that of
    rolling up to the second order of the ball.
    """
    spread = centre - th
    if spread.is_zero():
        return u, u
    box = u
    for _ in range(20):
        slope = phase.slope(th.union(centre), box)
        found = u + slope * spread
        if box.contains(found.union(u)):
            break
        box = (u + 2 * slope * symmetric(spread)).union(box)
    else:
        raise Undecided("the start of a phase has no enclosure")
    if energy is None:
        return found, box
    # d/dθ* of u(centre), for slip that begins in θ*: what the slopes differ by, carried on by exp(∫ A)
    model = phase.model
    s, c = th.union(centre).sin_cos()
    rolled = 2 * model.rolling(s, c, box).alpha
    carried = (model.rates(s, c, phase.sigma)[0] * symmetric(spread)).exp()
    s, c = centre.sin_cos()
    there = 2 * (energy - model.height(centre, s, c)) / model.inertia(c)
    return intersection(found, there + (rolled - slope) * carried * symmetric(spread)), box


def begin_at(phase: PhaseEquations, centre: Ball, u: Ball, way: int) -> State:
    """The state that the phase has, or would have had, at an exact angle next to the one where it began."""
    begin, spread = phase.begin, centre - phase.begin.th
    th, square = begin.th.union(centre), u.union(begin.om * begin.om)
    slowness = square.rsqrt()
    vt = begin.vt
    if phase.sigma:
        vt = vt + phase.forces(th, square).slip * slowness * way * spread
    moved = (1 + way * begin.vt.union(vt) * slowness) * spread
    return State(begin.t + way * spread * slowness, begin.x + moved, begin.y, centre, vt, begin.vn, way * u.sqrt())
