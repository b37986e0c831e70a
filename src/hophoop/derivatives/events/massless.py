"""Derivatives of the massless hoop that skims, and of the blow of its load on the plane."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import (
    BEFORE_OM,
    BEFORE_VN,
    BEFORE_VT,
    IMPACT_N,
    IMPACT_T,
    MU_K,
    OM,
    P_N,
    P_T,
    TH,
    VN,
    VT,
    T,
    X,
)
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import cosine, sine_and_cosine
from hophoop.kernel.physics.closed_forms import strike


def load_changes(begin, tangents, k):
    """Changes of the load: (its height at the start, its rate of sinking, its speed along the plane)."""
    s, c = sine_and_cosine(begin.th)
    dth = tangents[TH, k]
    fallen = s * dth
    sink = c * begin.om * dth + s * tangents[OM, k]
    along = tangents[VT, k] + tangents[OM, k] * (1.0 + c) - begin.om * s * dth
    return fallen, sink, along


def skim_rates(body, state):
    """(θ̈, v̇_t, v̇_n, 0) while the rim skims: the load falls freely, which gives θ̈ sin θ + θ̇² cos θ = g."""
    s, c = sine_and_cosine(state.th)
    turning = (body.gn - c * state.om * state.om) / s
    return turning, state.om * state.om * s - turning * (1.0 + c), 0.0, 0.0


@noinline
def follow_skim(body, begin, end, tau, tangents):
    """Propagate all directions over the time tau of skimming."""
    s1, c1 = sine_and_cosine(end.th)
    c0 = cosine(begin.th)
    if tau <= 0.0:
        return
    for k in range(tangents.shape[1]):
        fallen, sink, along = load_changes(begin, tangents, k)
        dth = (fallen + sink * tau) / s1
        dom = (sink - c1 * end.om * dth) / s1
        tangents[X, k] += c0 * tangents[TH, k] + along * tau - c1 * dth
        tangents[VT, k] = along - dom * (1.0 + c1) + end.om * s1 * dth
        tangents[TH, k] = dth
        tangents[OM, k] = dom


@noinline
def follow_strike(body, begin, tau, parameter_tangents, tangents, event_tangents):
    """Propagate all directions from the start of the skimming to just after the load has struck, at the time tau."""
    s, c = sine_and_cosine(begin.th)
    sink = s * begin.om + body.gn * tau
    speed = begin.vt + begin.om * (1.0 + c)
    after, _, _ = strike(body, speed, -sink)
    for k in range(tangents.shape[1]):
        fallen, dsink, dspeed = load_changes(begin, tangents, k)
        dt = -(fallen + dsink * tau) / sink
        dblow = dsink + body.gn * dt
        tangents[T, k] += dt
        tangents[X, k] += c * tangents[TH, k] + dspeed * tau + speed * dt
        dafter = 0.0
        if after != 0.0:
            dafter = dspeed - math.copysign(1.0, speed) * (parameter_tangents[MU_K, k] * sink + body.mu_k * dblow)
        event_tangents[BEFORE_OM, k] = math.nan
        event_tangents[BEFORE_VT, k] = dspeed
        event_tangents[BEFORE_VN, k] = -dblow
        event_tangents[P_N, k] = dblow
        event_tangents[P_T, k] = dafter - dspeed
        tangents[IMPACT_N, k] += sink * dblow
        tangents[IMPACT_T, k] += speed * dspeed - after * dafter
        tangents[TH, k] = 0.0
        tangents[OM, k] = 0.0
        tangents[VT, k] = dafter
        tangents[VN, k] = 0.0
