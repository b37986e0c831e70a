"""Derivatives on a panel of rolling or slip (docs/derivatives.md#on-a-panel).

Over θ, u = θ̇² obeys u′ = a u + b, so that its derivatives have the same integrating factor. They are taken at fixed
places ξ of the panel, which goes along with its begin, and with the turning point that it arrives at: so dt/dξ stays
smooth. Seven of them, by the begin of the panel and by the parameters, serve all directions.
"""

from __future__ import annotations

import numpy as np

from hophoop._jit import apart_jit, inline_jit, lean_jit
from hophoop.derivatives.layout import EPS, GN, GT, KAP, MU_K, OM, TH, VT, T, X
from hophoop.numerics.collocation import (
    ANTIDERIVATIVE_T,
    NODES,
    ORDER,
    WEIGHTS,
    dot,
    exponentials,
    lagrange,
    product,
)
from hophoop.numerics.trigonometry import rotated, sine_cosine
from hophoop.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    RATE,
    SINE,
    STIFFNESS,
    STRETCH,
    TIME,
    A,
    B,
    U,
    angle_at,
    fill_geometry,
)
from hophoop.panels.slip import from_reference
from hophoop.physics.contact import inertia_at_height, load_height

# By θ̇² at the begin (of an arriving panel: by θ there), by θ at the begin (by the turning point), by the parameters.
BEGIN, SHIFT, BY_EPS, BY_KAP, BY_MU, BY_GN, BY_GT = range(7)
LOCAL = 7
# Rows of the array that a panel is worked out in.
SLOPE, INTERPOLATE, INTEGRATE, AT_BEGIN, RATES, TIMES = range(LOCAL, LOCAL + 6)
ROWS = LOCAL + 6

FROM_BEGIN = np.ascontiguousarray(ANTIDERIVATIVE_T.T)


@apart_jit
def roll_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a rolling panel, from D θ̇² = D₀ θ̇₀² + 2 (V₀ − V)."""
    fill_geometry(panel, work)
    s0 = panel.sine
    c0 = panel.cosine
    inertia = inertia_at_height(body, load_height(s0, c0))
    slope = 2.0 * (panel.arm + body.eps * s0 * panel.u) / inertia
    for i in range(ORDER):
        ds, dc = rotated(s0, c0, work[A, i], work[B, i])
        u = work[U, i]
        here = 1.0 / (inertia + 2.0 * body.eps * dc)
        more = body.eps * (body.gn * ds + body.gt * dc + work[SINE, i] * u - s0 * panel.u)
        local[BEGIN, i] = inertia * here
        local[SHIFT, i] = 2.0 * more * here
        local[BY_EPS, i] = (
            2.0 * (body.gt * ds - body.gn * dc + (body.eps + c0) * panel.u - (body.eps + work[COSINE, i]) * u) * here
        )
        local[BY_KAP, i] = (panel.u - u) * here
        local[BY_MU, i] = 0.0
        local[BY_GN, i] = -2.0 * body.eps * dc * here
        local[BY_GT, i] = 2.0 * (body.eps * ds + angle_at(panel, NODES[i])) * here
        local[SLOPE, i] = local[SHIFT, i] + slope * local[BEGIN, i]


@apart_jit
def slip_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a slip panel, from θ̇²′ = 2 q (g_n − ε c θ̇²)/(κ p) by its integrating factor."""
    eps = body.eps
    sigma = float(panel.sigma)
    growth = local[BEGIN]
    integral = work[TIME]
    from_reference(panel, work[A], integral)
    exponentials(integral, growth)
    slope = 2.0 * panel.arm * (body.gn - eps * panel.cosine * panel.u) / panel.stiffness
    for i in range(ORDER):
        s = work[SINE, i]
        c = work[COSINE, i]
        q = work[ARM, i]
        firm = 1.0 / work[STIFFNESS, i]
        load = (body.gn - eps * c * work[U, i]) * firm
        q_eps = s + sigma * body.mu_k * c
        q_mu = sigma * (1.0 + eps * c)
        local[SLOPE, i] = 2.0 * q * load
        local[SHIFT, i] = 2.0 * q * load - slope * growth[i]
        local[BY_EPS, i] = 2.0 * (q_eps * load - q * firm * (c * work[U, i] + load * (s * q + eps * s * q_eps)))
        local[BY_KAP, i] = -2.0 * q * load * firm
        local[BY_MU, i] = 2.0 * q_mu * load * (1.0 - q * eps * s * firm)
        local[BY_GN, i] = 2.0 * q * firm
        local[BY_GT, i] = 0.0
    for row in range(BY_EPS, BY_GT):
        values = local[row]
        for i in range(ORDER):
            values[i] *= work[STRETCH, i] / growth[i]
        from_reference(panel, values, integral)
        for i in range(ORDER):
            values[i] = growth[i] * integral[i]


@apart_jit
def fill_rates(body, panel, work, local):
    """The rows BEGIN to BY_GT at fixed ξ of a solved panel: dθ̇²/d…."""
    if panel.sigma == 0:
        roll_rates(body, panel, work, local)
    else:
        slip_rates(body, panel, work, local)
    if panel.kind == ARRIVE:
        for i in range(ORDER):
            part = 0.5 * (1.0 - NODES[i])
            local[BEGIN, i] = local[SLOPE, i] * part * part
            local[SHIFT, i] -= local[BEGIN, i]


@apart_jit
def changes_at(panel, xi, work, local):
    """Fill the rows RATES and TIMES: dθ̇²/d… at ξ and dt/d… from the begin to there. Returns the time itself."""
    weights = local[INTERPOLATE]
    quadrature = local[INTEGRATE]
    lagrange(xi, weights)
    if xi < 1.0:
        product(FROM_BEGIN, weights, quadrature)
    else:
        for i in range(ORDER):
            quadrature[i] = WEIGHTS[i]
    time = dot(quadrature, work[RATE])
    for i in range(ORDER):
        quadrature[i] *= -0.5 * work[RATE, i] / work[U, i]
    for row in range(LOCAL):
        local[RATES, row] = dot(weights, local[row])
        local[TIMES, row] = dot(quadrature, local[row])
    if panel.kind == ARRIVE:  # the panel becomes longer
        longer = panel.way * time / panel.extent
        local[TIMES, BEGIN] -= longer
        local[TIMES, SHIFT] += longer
    return time


@lean_jit
def momentum_change(body, sigma, s, c, om, dvt, dom, dth, deps, dmu):
    """Change of v_t + θ̇ (1 + ε c − σ μ ε s), which gravity alone changes in slip."""
    signed_mu = sigma * body.mu_k
    arm = 1.0 + body.eps * (c - signed_mu * s)
    return (
        dvt + dom * arm + om * (deps * (c - signed_mu * s) - sigma * dmu * body.eps * s - dth * body.eps * (s + signed_mu * c))
    )


@lean_jit
def place_change(body, sigma, s, c, dth, deps, dmu):
    """Change of ε s + σ μ ε c: added to x it makes the place that goes with that momentum."""
    signed_mu = sigma * body.mu_k
    return deps * (s + signed_mu * c) + sigma * dmu * body.eps * c + body.eps * (c - signed_mu * s) * dth


@apart_jit
def follow_slip(body, sigma, begin, end, time, before, dt, k, changes, z):
    """The changes of v_t and x of a direction over a time of slip, by its `momentum`; those of t, θ, θ̇ stand in z."""
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    s1, c1 = sine_cosine(end.th, end.th_low)
    signed_mu = sigma * body.mu_k
    deps = changes[EPS, k]
    dmu = changes[MU_K, k]
    dth0, dom0 = before
    steady = body.gt - signed_mu * body.gn
    dsteady = changes[GT, k] - sigma * dmu * body.gn - signed_mu * changes[GN, k]
    momentum = begin.vt + begin.om * (1.0 + body.eps * (c0 - signed_mu * s0))
    dmomentum = momentum_change(body, sigma, s0, c0, begin.om, z[VT, k], dom0, dth0, deps, dmu)
    dplace = place_change(body, sigma, s0, c0, dth0, deps, dmu) - place_change(body, sigma, s1, c1, z[TH, k], deps, dmu)
    z[X, k] += dplace + dmomentum * time + momentum * dt + 0.5 * dsteady * time * time + steady * time * dt
    rest = momentum_change(body, sigma, s1, c1, end.om, 0.0, z[OM, k], z[TH, k], deps, dmu)
    z[VT, k] = dmomentum + dsteady * time + steady * dt - rest


@inline_jit
def by_parameters(row, changes, k):
    """The part of a row of local derivatives that is by the parameters."""
    return (
        row[BY_EPS] * changes[EPS, k]
        + row[BY_KAP] * changes[KAP, k]
        + row[BY_MU] * changes[MU_K, k]
        + row[BY_GN] * changes[GN, k]
        + row[BY_GT] * changes[GT, k]
    )


@apart_jit
def prepare_panel(body, panel, work, local):
    """What `follow_panel` needs of a solved panel, whatever the place on it."""
    fill_rates(body, panel, work, local)
    lagrange(-1.0, local[INTERPOLATE])
    for row in range(LOCAL):
        local[AT_BEGIN, row] = dot(local[INTERPOLATE], local[row])


@apart_jit
def follow_panel(body, panel, xi, begin, end, changes, z, work, local):
    """Carry all directions from the state at the begin of a prepared panel to the one at ξ.

    `changes` are those of the parameters; z is changed in place.
    """
    arrives = panel.kind == ARRIVE
    time = changes_at(panel, xi, work, local)
    rates = local[RATES]
    times = local[TIMES]
    part = 0.5 * (1.0 - xi)
    part *= part
    for k in range(z.shape[1]):
        dth0 = z[TH, k]
        dom0 = z[OM, k]
        given = 2.0 * begin.om * dom0
        if arrives:  # what θ̇² is at the begin says where the turning point is
            first = dth0
            given -= local[AT_BEGIN, BEGIN] * dth0 + by_parameters(local[AT_BEGIN], changes, k)
            second = given / local[AT_BEGIN, SHIFT]
            z[TH, k] = dth0 * part + second * (1.0 - part)
        else:
            first = given
            second = dth0
        dt = first * times[BEGIN] + second * times[SHIFT] + by_parameters(times, changes, k)
        du = first * rates[BEGIN] + second * rates[SHIFT] + by_parameters(rates, changes, k)
        z[OM, k] = 0.5 * du / end.om if end.om != 0.0 else 0.0
        z[T, k] += dt
        if panel.sigma == 0:
            z[X, k] += z[TH, k] - dth0
        else:
            follow_slip(body, panel.sigma, begin, end, time, (dth0, dom0), dt, k, changes, z)
