"""Flight: a parabola and a cosine."""

from __future__ import annotations

from hophoop.prove._flint import Ball, Jet
from hophoop.prove.checker.equations import Equations, State


def gap(equations: Equations, state: State, tau: Ball, terms: int) -> Jet:
    """The gap a time after a state and its derivatives, over factorials."""
    eps, om = equations.eps, state.om
    th = state.th + om * tau
    rise = state.vn - eps * om * state.th.sin()
    jet = [
        state.y + eps * (state.th.cos() - th.cos()) + (rise - equations.gn * tau / 2) * tau,
        rise - equations.gn * tau + eps * om * th.sin(),
        (eps * om * om * th.cos() - equations.gn) / 2,
        -eps * om * om * om * th.sin() / 6,
    ]
    return jet[:terms]


def flown(equations: Equations, state: State, tau: Ball) -> State:
    """The state after a time in flight: G keeps its velocity along the plane but for gravity."""
    eps, pull = equations.eps, equations.gt
    th = state.th + state.om * tau
    along = state.vt + state.om * (1 + eps * state.th.cos())
    x = state.x - eps * (th.sin() - state.th.sin()) + (along + pull * tau / 2) * tau
    vt = along + pull * tau - state.om * (1 + eps * th.cos())
    y, vn = gap(equations, state, tau, 2)
    return State(state.t + tau, x, y, th, vt, vn, state.om)


def skims(equations: Equations, state: State) -> bool:
    """Whether, without gravity and with G at a constant height ε above the centre or less, the rim never comes down."""
    eps = equations.eps
    still = (state.vn - eps * state.om * state.th.sin()).is_zero() and equations.gn.is_zero()
    least = state.y + eps * (state.th.cos() - 1)
    return bool(still and (least.is_zero() or least > 0))
