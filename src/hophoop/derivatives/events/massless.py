"""Derivatives of the massless hoop that skims, and of the blow of its load on the plane."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import (
    BEFORE_OM,
    BEFORE_VN,
    BEFORE_VT,
    IMPACT_N,
    IMPACT_T,
    OM,
    P_N,
    P_T,
    TH,
    VN,
    VT,
    T,
    X,
    body_tangent,
)
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.model import skim_duration, skim_state, strike
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_and_cosine


def struck_load(body, x, th, vt, om):
    """Return (time, x, v_t after, velocities before, impulses, losses) of the strike of the load, from a state of skimming."""
    s, c = sine_and_cosine(th)
    speed = vt + om * (1.0 + c)
    tau = skim_duration(body, 1.0 + c, s * om)
    sink = s * om + body.gn * tau
    after, p_n, p_t = strike(body, speed, -sink)
    lost = 0.5 * (speed * speed - after * after)
    return tau, x + s + speed * tau, after, speed, -sink, p_n, p_t, 0.5 * sink * sink, lost


d_skim_state = tangent_of(skim_state, "x", "th", "vt", "om")
d_skim_state_by_time = tangent_of(skim_state, "tau")
d_struck_load = tangent_of(struck_load, "body", "x", "th", "vt", "om")


@noinline
def skim_rates(body, state):
    """Return (θ̈, v̇_t, v̇_n, 0) while the rim skims."""
    direction = math.copysign(1.0, state.om)
    _, _, along, turning = d_skim_state_by_time(body, 0.0, state.th, state.vt, state.om, direction, 0.0, 1.0)[1]
    return turning, along, 0.0, 0.0


@noinline
def follow_skim(body, begin, direction, tau, tangents):
    """Propagate all directions over the time tau of skimming."""
    if tau <= 0.0:
        return
    for k in range(tangents.shape[1]):
        change = d_skim_state(
            body, begin.x, begin.th, begin.vt, begin.om, direction, tau,
            tangents[X, k], tangents[TH, k], tangents[VT, k], tangents[OM, k],
        )[1]  # fmt: skip
        tangents[X, k], tangents[TH, k], tangents[VT, k], tangents[OM, k] = change


@noinline
def follow_strike(body, begin, parameter_tangents, tangents, event_tangents):
    """Propagate all directions from the start of the skimming to just after the load has struck."""
    for k in range(tangents.shape[1]):
        dt, dx, dafter, dspeed, drise, dp_n, dp_t, dlost_n, dlost_t = d_struck_load(
            body, begin.x, begin.th, begin.vt, begin.om,
            body_tangent(parameter_tangents, k), tangents[X, k], tangents[TH, k], tangents[VT, k], tangents[OM, k],
        )[1]  # fmt: skip
        tangents[T, k] += dt
        tangents[X, k] = dx
        event_tangents[BEFORE_OM, k] = math.nan
        event_tangents[BEFORE_VT, k] = dspeed
        event_tangents[BEFORE_VN, k] = drise
        event_tangents[P_N, k] = dp_n
        event_tangents[P_T, k] = dp_t
        tangents[IMPACT_N, k] += dlost_n
        tangents[IMPACT_T, k] += dlost_t
        tangents[TH, k] = 0.0
        tangents[OM, k] = 0.0
        tangents[VT, k] = dafter
        tangents[VN, k] = 0.0
