"""Derivatives on a panel of rolling or slip (docs/derivatives.md#on-a-panel).

Over θ, u = θ̇² obeys u′ = a u + b, so that its derivatives have the same integrating factor. They are taken at fixed
places ξ of the panel, which goes along with its begin, and with the turning point that it arrives at: so dt/dξ stays
smooth. Eight of them, by the begin of the panel and by the parameters, serve all directions.
"""

from __future__ import annotations

import numpy as np

from hophoop.derivatives.layout import EPS, GN, GT, KAP, MU_K, OM, RESIST, RESISTED, TH, VT, T, X
from hophoop.derivatives.pieces.resisted import loss_change, pressed_on, resistance_rates, resisted_rates, resists, weigh
from hophoop.derivatives.workspace import (
    AT_BEGIN,
    BEGIN,
    BY_EPS,
    BY_GN,
    BY_GT,
    BY_KAP,
    BY_MU,
    BY_RESIST,
    INTEGRATE,
    INTERPOLATE,
    LOCAL,
    RATES,
    SHIFT,
    SLOPE,
    TIMES,
    WEIGH,
    WEIGHED,
    integrate_row,
)
from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import ORDER, dot, exponentials, lagrange, product
from hophoop.kernel.numerics.constants import ANTIDERIVATIVE_T, NODES, WEIGHTS
from hophoop.kernel.numerics.trigonometry import rotated, sine_cosine
from hophoop.kernel.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    RATE,
    SINE,
    STIFFNESS,
    TIME,
    A,
    B,
    U,
    angle_at,
    fill_geometry,
    sine_versine_of_offset,
)
from hophoop.kernel.panels.slip import away_from_reference
from hophoop.kernel.physics.contact import inertia_at_height, load_height

FROM_BEGIN = np.ascontiguousarray(ANTIDERIVATIVE_T.T)


def roll_rates_at(body, panel, sine, versine, offset, u):
    """dθ̇²/dθ and dθ̇²/d… by θ̇² and θ at the reference, ε, κ, g_n and g_t, at φ = offset from there, in rolling.

    From D θ̇² = D₀ θ̇₀² + 2 (V₀ − V); `sine` and `versine` are sin φ and 1 − cos φ.
    """
    s0 = panel.sine
    c0 = panel.cosine
    ds, dc = rotated(s0, c0, sine, versine)
    inertia = inertia_at_height(body, load_height(s0, c0))
    here = 1.0 / (inertia + 2.0 * body.eps * dc)
    growth = inertia * here
    more = body.eps * (body.gn * ds + body.gt * dc + (s0 + ds) * u - s0 * panel.u)
    shift = 2.0 * more * here
    slope = shift + 2.0 * (panel.arm + body.eps * s0 * panel.u) / inertia * growth
    by_eps = 2.0 * (body.gt * ds - body.gn * dc + (body.eps + c0) * panel.u - (body.eps + c0 + dc) * u) * here
    return (
        slope, growth, shift, by_eps, (panel.u - u) * here, -2.0 * body.eps * dc * here, 2.0 * (body.eps * ds + offset) * here,
    )  # fmt: skip


@apart
def roll_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a rolling panel."""
    fill_geometry(panel, work)
    for i in range(ORDER):
        rates = roll_rates_at(body, panel, work[A, i], work[B, i], angle_at(panel, NODES[i]), work[U, i])
        local[SLOPE, i], local[BEGIN, i], local[SHIFT, i], local[BY_EPS, i], local[BY_KAP, i] = rates[:5]
        local[BY_MU, i] = 0.0
        local[BY_GN, i], local[BY_GT, i] = rates[5:]


@apart
def refine_rates(body, panel, xi, u, row):
    """What rolling has in closed form at ξ, in place of what is interpolated."""
    sine, versine = sine_versine_of_offset(panel, xi)
    rates = roll_rates_at(body, panel, sine, versine, angle_at(panel, xi), u)
    slope, growth, shift, row[BY_EPS], row[BY_KAP], row[BY_GN], row[BY_GT] = rates
    if panel.kind == ARRIVE:
        part = 0.5 * (1.0 - xi)
        growth = slope * part * part
        shift -= growth
    row[BEGIN] = growth
    row[SHIFT] = shift


@apart
def slip_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a slip panel, from θ̇²′ = 2 q (g_n − ε c θ̇²)/(κ p) by its integrating factor."""
    eps = body.eps
    sigma = float(panel.sigma)
    growth = local[BEGIN]
    integral = work[TIME]
    away_from_reference(panel, work[A], integral)  # which `solve_slip` has left there, signed along θ
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
        integrate_row(panel, local[row], growth, work)


@apart
def fill_rates(body, panel, resisting, work, local):
    """The rows BEGIN to BY_RESIST at fixed ξ of a solved panel: dθ̇²/d…."""
    if panel.sigma != 0:
        slip_rates(body, panel, work, local)
    elif body.resist > 0.0:
        resisted_rates(body, panel, work, local)
    else:
        roll_rates(body, panel, work, local)
    if resisting:
        resistance_rates(body, panel, work, local)
    else:
        for i in range(ORDER):
            local[BY_RESIST, i] = 0.0
    if panel.kind == ARRIVE:
        for i in range(ORDER):
            part = 0.5 * (1.0 - NODES[i])
            local[BEGIN, i] = local[SLOPE, i] * part * part
            local[SHIFT, i] -= local[BEGIN, i]


@apart
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
        local[WEIGH, i] = quadrature[i]
        quadrature[i] *= -0.5 * work[RATE, i] / work[U, i]
    for row in range(LOCAL):
        local[RATES, row] = dot(weights, local[row])
        local[TIMES, row] = dot(quadrature, local[row])
    if panel.kind == ARRIVE:  # the panel becomes longer
        longer = panel.way * time / panel.extent
        local[TIMES, BEGIN] -= longer
        local[TIMES, SHIFT] += longer
    return time


def momentum_change(body, sigma, s, c, om, dvt, dom, dth, deps, dmu):
    """Change of v_t + θ̇ (1 + ε c − σ μ ε s), which gravity alone changes in slip."""
    signed_mu = sigma * body.mu_k
    arm = 1.0 + body.eps * (c - signed_mu * s)
    return (
        dvt + dom * arm + om * (deps * (c - signed_mu * s) - sigma * dmu * body.eps * s - dth * body.eps * (s + signed_mu * c))
    )


def place_change(body, sigma, s, c, dth, deps, dmu):
    """Change of ε s + σ μ ε c: added to x it makes the place that goes with that momentum."""
    signed_mu = sigma * body.mu_k
    return deps * (s + signed_mu * c) + sigma * dmu * body.eps * c + body.eps * (c - signed_mu * s) * dth


@apart
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


@inline
def by_parameters(row, changes, k):
    """The part of a row of local derivatives that is by the parameters."""
    return (
        row[BY_EPS] * changes[EPS, k]
        + row[BY_KAP] * changes[KAP, k]
        + row[BY_MU] * changes[MU_K, k]
        + row[BY_GN] * changes[GN, k]
        + row[BY_GT] * changes[GT, k]
        + row[BY_RESIST] * changes[RESIST, k]
    )


@apart
def prepare_panel(body, panel, u, changes, work, local):
    """What `follow_panel` needs of a solved panel that begins with θ̇² = u, whatever the place on it."""
    fill_rates(body, panel, resists(body, changes), work, local)
    lagrange(-1.0, local[INTERPOLATE])
    for row in range(LOCAL):
        local[AT_BEGIN, row] = dot(local[INTERPOLATE], local[row])
    if panel.sigma == 0 and body.resist == 0.0:
        refine_rates(body, panel, -1.0, u, local[AT_BEGIN])


@apart
def follow_panel(body, panel, xi, begin, end, changes, z, work, local):
    """Carry all directions from the state at the begin of a prepared panel to the one at ξ.

    `changes` are those of the parameters; z is changed in place.
    """
    arrives = panel.kind == ARRIVE
    time = changes_at(panel, xi, work, local)
    rates = local[RATES]
    times = local[TIMES]
    freely = panel.sigma == 0 and body.resist == 0.0
    if freely:
        refine_rates(body, panel, xi, end.om * end.om, rates)
    resisting = resists(body, changes)
    pressing = (0.0, 0.0)
    if resisting:
        pressing = pressed_on(body, panel, xi, begin, end, weigh(panel, work, local))
        if freely and not arrives:  # as `first_resistance`
            s, c = sine_cosine(end.th, end.th_low)
            rates[BY_RESIST] = -2.0 * panel.way * pressing[1] / inertia_at_height(body, load_height(s, c))
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
        if resisting:
            row = local[WEIGHED]
            weighed = first * row[BEGIN] + second * row[SHIFT] + by_parameters(row, changes, k)
            z[RESISTED, k] += loss_change(body, panel, xi, begin, end, pressing, (dth0, dom0), weighed, k, changes, z)
        if panel.sigma == 0:
            z[X, k] += z[TH, k] - dth0
        else:
            follow_slip(body, panel.sigma, begin, end, time, (dth0, dom0), dt, k, changes, z)
