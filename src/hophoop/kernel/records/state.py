"""The state that passes through the event loop, and changes of it (docs/model.md#coordinates)."""

from __future__ import annotations

from typing import NamedTuple

from hophoop.kernel.native import inline, noinline, replaced
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI, TWO_PI_LOW, add, plus, revolutions_and_rest

# Maximum of abs(θ) in a revolution, so that θ keeps all its digits near the unstable equilibria on both sides.
FARTHEST = TWO_PI - 0.5


class State(NamedTuple):
    """Position, velocities (v_t instead of ẋ, so that small slip keeps its digits) and energy dissipated so far.

    Times and angles accumulate over thousands of revolutions, so they are double-doubles: each has a low-order half. The angle
    is split into whole revolutions (`revolutions`) and θ within one, which stays between −2π and 2π.
    """

    t: float
    t_low: float
    x: float
    x_low: float
    y: float
    revolutions: float
    th: float
    th_low: float
    vt: float
    vn: float
    om: float
    friction: float
    impact_n: float
    impact_t: float
    rolling_loss: float  # energy lost to rolling resistance


@noinline
def start_state(x, y, angle, vt, vn, om):
    """Return a state at t = 0; `angle` includes all revolutions."""
    revolutions, th, th_low = revolutions_and_rest(angle)
    return State(0.0, 0.0, x, 0.0, y, revolutions, th, th_low, vt, vn, om, 0.0, 0.0, 0.0, 0.0)


@inline
def whole_angle(state):
    """Return θ including all revolutions."""
    return state.revolutions * TWO_PI + (state.th + (state.th_low + state.revolutions * TWO_PI_LOW))


@inline
def later(state, tau):
    """Return (time, its low-order half) after the duration tau."""
    return plus(state.t, state.t_low, tau)


@inline
def time_left(state, t_end):
    """Return the time from the state to t_end."""
    return (t_end - state.t) - state.t_low


@noinline
def rotated_by(state, angle):
    """Return (revolutions, θ, its low-order half) after a rotation by any angle, with abs(θ) ≤ π."""
    more, th, low = revolutions_and_rest(angle)
    th, low = add((th, low), (state.th, state.th_low))
    revolutions = state.revolutions + more
    if th > PI:
        revolutions += 1.0
        th, low = add((th, low), (-TWO_PI, -TWO_PI_LOW))
    elif th < -PI:
        revolutions -= 1.0
        th, low = add((th, low), (TWO_PI, TWO_PI_LOW))
    return revolutions, th, low


@noinline
def flown(state, along, y, tau, vt, vn):
    """Return the state after a flight of duration tau, with θ̇ unchanged."""
    t, t_low = later(state, tau)
    x, x_low = plus(state.x, state.x_low, along)
    revolutions, th, th_low = rotated_by(state, state.om * tau)
    return replaced(state, t=t, t_low=t_low, x=x, x_low=x_low, y=y, revolutions=revolutions, th=th, th_low=th_low, vt=vt, vn=vn)
