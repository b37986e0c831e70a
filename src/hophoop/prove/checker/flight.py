"""Flight: a parabola and a cosine."""

from __future__ import annotations

import math

from hophoop.prove._flint import Ball, Jet, arb, pi
from hophoop.prove.checker.equations import Equations, State
from hophoop.prove.checker.intervals import expanded, shown

MOST_PARTS = 40_000


def gap(equations: Equations, state: State, tau: Ball, terms: int) -> Jet:
    """The gap a time after a state and its derivatives, over factorials."""
    equations.deadline.ask()
    eps, om = equations.eps, state.om
    th = state.th + om * tau
    rise = state.vn - eps * om * state.th.sin()
    s, c = th.sin_cos()
    parabola = [state.y + eps * state.th.cos() + (rise - equations.gn * tau / 2) * tau, rise - equations.gn * tau]
    parabola += [-equations.gn / 2, *[arb(0)] * (terms - 3)]
    turned = [-c, s, c, -s]  # −cos θ and its derivatives, which θ̇^k/k! goes with
    return [parabola[k] + eps * turned[k % 4] * om**k / math.factorial(k) for k in range(terms)]


def flown(equations: Equations, state: State, tau: Ball) -> State:
    """The state after a time in flight: gravity alone changes the velocity of G along the plane."""
    eps, pull = equations.eps, equations.gt
    th = state.th + state.om * tau
    along = state.vt + state.om * (1 + eps * state.th.cos())
    x = state.x - eps * (th.sin() - state.th.sin()) + (along + pull * tau / 2) * tau
    vt = along + pull * tau - state.om * (1 + eps * th.cos())
    y, vn = gap(equations, state, tau, 2)
    return State(state.t + tau, x, y, th, vt, vn, state.om)


def skims(equations: Equations, state: State) -> bool:
    """Return True if, without gravity and with G at a constant height ε above the centre or less, the rim never comes down."""
    eps = equations.eps
    still = (state.vn - eps * state.om * state.th.sin()).is_zero() and equations.gn.is_zero()
    least = state.y + eps * (state.th.cos() - 1)
    return bool(still and (least.is_zero() or least > 0))


def without_apex(equations: Equations, state: State, tau: Ball, zeros: int) -> bool:
    """Return True if a flight without gravity is one of those with grazes that have no apex by their form.

    Lift-off with N = 0 is at cos θ = 0 there, so that ẏ = ε θ̇ (sin θ ∓ 1) keeps its sign; a hoop that
    hovers has no top; and where G stays at a constant height, all tops are equal, so that of two or more none is the highest.
    """
    if not equations.gn.is_zero():
        return False
    hovers = state.vn.is_zero() and (state.om.is_zero() or equations.eps.is_zero())
    if zeros >= 3 or hovers:
        return True
    still = (state.vn - equations.eps * state.om * state.th.sin()).is_zero()
    first, last = (((th - pi()) / (2 * pi())).floor() for th in (state.th, state.th + state.om * tau))
    return bool(still and abs(last - first) > 1)


def no_top(equations: Equations, state: State, begin: Ball, end: Ball, zeros: int, height: Ball | None) -> None:
    """Refuse unless the gap has no top from one time to another, or only such as are lower than a height.

    On each part the gap rises, or falls, or is convex, or is lower. `zeros` counts the derivatives of the gap that vanish
    at the start, its value included; there the first one that does not vanish gives the direction.
    """

    def moves(value: Ball, slope: Ball) -> bool:
        return bool(slope > 0) or bool(slope < 0) or (height is not None and bool(value < height))

    def no_top_on(a: Ball, b: Ball, starts: bool) -> bool:
        jet = gap(equations, state, a.union(b), 4)
        if jet[2] > 0 or moves(*jet[:2]) or (starts and _from_rest(state, jet, zeros)):
            return True
        return moves(*expanded(lambda x, terms: [gap(equations, state, x, terms)], 0, a.union(b)))

    low, high = begin.lower(), end.upper()
    if low < high:
        shown(no_top_on, low, high, "the flight has no other apex than is said", MOST_PARTS)


def _from_rest(state: State, jet: Jet, zeros: int) -> bool:
    """Return True if a flight that begins with ẏ = 0 goes one way on a part that begins there."""
    if zeros >= 3:
        return bool(jet[3] > 0)
    return bool(state.vn.is_zero() and jet[2] < 0)
