"""Derivatives on a panel of rolling or slip (docs/derivatives.md#on-a-panel).

Over θ, u = θ̇² obeys u′ = a u + b, so that its derivatives have the same integrating factor. They are taken at fixed
ξ of the panel, which moves with its start, and with the turning point at its end: so dt/dξ stays smooth. Eight of them, by
the start of the panel and by the parameters, serve all directions.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from hophoop.derivatives.layout import EPS, GN, GT, KAP, MU_K, OM, RESIST, ROLLING_LOSS, TH, VT, T, X
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
from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.circular import sine_cosine, sine_cosine_change_by
from hophoop.kernel.numerics.collocation import ORDER, dot, lagrange, product
from hophoop.kernel.numerics.tables import ANTIDERIVATIVE_T, NODES, WEIGHTS
from hophoop.kernel.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    GROWTH,
    KAPPA_P_SIGMA,
    OFFSET_SINE,
    OFFSET_VERSINE,
    RATE,
    SINE,
    U,
    angle_at,
    sine_versine_of_offset,
)
from hophoop.kernel.physics.contact import inertia_at_height, load_height

FROM_BEGIN = np.ascontiguousarray(ANTIDERIVATIVE_T.T)


def roll_rates_at(body, panel, sine, versine, offset, u):
    """dθ̇²/dθ and dθ̇²/d… by θ̇² and θ at the reference, ε, κ, g_n and g_t, at φ = offset from there, in rolling.

    From D θ̇² = D₀ θ̇₀² + 2 (V₀ − V); `sine` and `versine` are sin φ and 1 − cos φ.
    """
    s0 = panel.sine
    c0 = panel.cosine
    ds, dc = sine_cosine_change_by(s0, c0, sine, versine)
    inertia = inertia_at_height(body, load_height(s0, c0))
    here = 1.0 / (inertia + 2.0 * body.eps * dc)
    growth = inertia * here
    more = body.eps * (body.gn * ds + body.gt * dc + (s0 + ds) * u - s0 * panel.u)
    shift = 2.0 * more * here
    slope = shift + 2.0 * (panel.torque + body.eps * s0 * panel.u) / inertia * growth
    by_eps = 2.0 * (body.gt * ds - body.gn * dc + (body.eps + c0) * panel.u - (body.eps + c0 + dc) * u) * here
    return (
        slope, growth, shift, by_eps, (panel.u - u) * here, -2.0 * body.eps * dc * here, 2.0 * (body.eps * ds + offset) * here,
    )  # fmt: skip


@noinline
def roll_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a rolling panel."""
    for i in range(ORDER):
        rates = roll_rates_at(body, panel, work[OFFSET_SINE, i], work[OFFSET_VERSINE, i], angle_at(panel, NODES[i]), work[U, i])
        local[SLOPE, i], local[BEGIN, i], local[SHIFT, i], local[BY_EPS, i], local[BY_KAP, i] = rates[:5]
        local[BY_MU, i] = 0.0
        local[BY_GN, i], local[BY_GT, i] = rates[5:]


@noinline
def refine_rates(body, panel, xi, u, row):
    """Replace interpolated rates at ξ by the closed forms of rolling."""
    sine, versine = sine_versine_of_offset(panel, xi)
    rates = roll_rates_at(body, panel, sine, versine, angle_at(panel, xi), u)
    slope, growth, shift, row[BY_EPS], row[BY_KAP], row[BY_GN], row[BY_GT] = rates
    if panel.kind == ARRIVE:
        part = 0.5 * (1.0 - xi)
        growth = slope * part * part
        shift -= growth
    row[BEGIN] = growth
    row[SHIFT] = shift


@noinline
def slip_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a slip panel, from θ̇²′ = 2 q (g_n − ε c θ̇²)/(κ p) by its integrating factor."""
    eps = body.eps
    sigma = float(panel.sigma)
    growth = local[BEGIN]
    slope = 2.0 * panel.arm * (body.gn - eps * panel.cosine * panel.u) / panel.kappa_p_sigma
    for i in range(ORDER):
        s = work[SINE, i]
        c = work[COSINE, i]
        q = work[ARM, i]
        compliance = 1.0 / work[KAPPA_P_SIGMA, i]
        growth[i] = work[GROWTH, i]
        over_p = (body.gn - eps * c * work[U, i]) * compliance
        q_eps = s + sigma * body.mu_k * c
        q_mu = sigma * (1.0 + eps * c)
        local[SLOPE, i] = 2.0 * q * over_p
        local[SHIFT, i] = 2.0 * q * over_p - slope * growth[i]
        local[BY_EPS, i] = 2.0 * (q_eps * over_p - q * compliance * (c * work[U, i] + over_p * (s * q + eps * s * q_eps)))
        local[BY_KAP, i] = -2.0 * q * over_p * compliance
        local[BY_MU, i] = 2.0 * q_mu * over_p * (1.0 - q * eps * s * compliance)
        local[BY_GN, i] = 2.0 * q * compliance
        local[BY_GT, i] = 0.0
    for row in range(BY_EPS, BY_GT):
        integrate_row(panel, local[row], growth, work)


@noinline
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


@noinline
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
        longer = panel.direction * time / panel.extent
        local[TIMES, BEGIN] -= longer
        local[TIMES, SHIFT] += longer
    return time


def momentum_change(body, sigma, s, c, om, of_state, of_body):
    """Change of v_t + θ̇ (1 + ε c − σ μ ε s), which gravity alone changes in slip.

    `of_state` are the changes of (v_t, θ̇, θ), `of_body` those of (ε, μk).
    """
    dvt, dom, dth = of_state
    deps, dmu = of_body
    signed_mu = sigma * body.mu_k
    arm = 1.0 + body.eps * (c - signed_mu * s)
    return (
        dvt + dom * arm + om * (deps * (c - signed_mu * s) - sigma * dmu * body.eps * s - dth * body.eps * (s + signed_mu * c))
    )


def place_change(body, sigma, s, c, dth, deps, dmu):
    """Change of ε s + σ μ ε c: added to x it makes the place that goes with that momentum."""
    signed_mu = sigma * body.mu_k
    return deps * (s + signed_mu * c) + sigma * dmu * body.eps * c + body.eps * (c - signed_mu * s) * dth


class SlipTime(NamedTuple):
    """Slip of a direction σ that lasts a time, between two states."""

    sigma: int
    begin: Any
    end: Any
    time: float


@noinline
def follow_slip(body, slip, before, dt, k, parameter_tangents, tangents):
    """Propagate v_t and x of a direction through slip by its momentum; the tangents of t, θ and θ̇ are those at its end.

    `before` are those of (θ, θ̇) at its start, and `dt` is the change of its duration.
    """
    sigma, begin, end, time = slip
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    s1, c1 = sine_cosine(end.th, end.th_low)
    signed_mu = sigma * body.mu_k
    deps = parameter_tangents[EPS, k]
    dmu = parameter_tangents[MU_K, k]
    dth0, dom0 = before
    steady = body.gt - signed_mu * body.gn
    dsteady = parameter_tangents[GT, k] - sigma * dmu * body.gn - signed_mu * parameter_tangents[GN, k]
    momentum = begin.vt + begin.om * (1.0 + body.eps * (c0 - signed_mu * s0))
    dmomentum = momentum_change(body, sigma, s0, c0, begin.om, (tangents[VT, k], dom0, dth0), (deps, dmu))
    dplace = place_change(body, sigma, s0, c0, dth0, deps, dmu) - place_change(body, sigma, s1, c1, tangents[TH, k], deps, dmu)
    tangents[X, k] += dplace + dmomentum * time + momentum * dt + 0.5 * dsteady * time * time + steady * time * dt
    rest = momentum_change(body, sigma, s1, c1, end.om, (0.0, tangents[OM, k], tangents[TH, k]), (deps, dmu))
    tangents[VT, k] = dmomentum + dsteady * time + steady * dt - rest


@inline
def by_parameters(row, parameter_tangents, k):
    """The part of a row of local derivatives that is by the parameters."""
    return (
        row[BY_EPS] * parameter_tangents[EPS, k]
        + row[BY_KAP] * parameter_tangents[KAP, k]
        + row[BY_MU] * parameter_tangents[MU_K, k]
        + row[BY_GN] * parameter_tangents[GN, k]
        + row[BY_GT] * parameter_tangents[GT, k]
        + row[BY_RESIST] * parameter_tangents[RESIST, k]
    )


@noinline
def prepare_panel(body, panel, u, parameter_tangents, workspace):
    """Compute what `follow_panel` needs of a solved panel that begins with θ̇² = u."""
    work, local = workspace.scratch.work, workspace.local
    fill_rates(body, panel, resists(body, parameter_tangents), work, local)
    lagrange(-1.0, local[INTERPOLATE])
    for row in range(LOCAL):
        local[AT_BEGIN, row] = dot(local[INTERPOLATE], local[row])
    if panel.sigma == 0 and body.resist == 0.0:
        refine_rates(body, panel, -1.0, u, local[AT_BEGIN])


@noinline
def follow_panel(body, stretch, parameter_tangents, tangents, workspace):
    """Propagate all directions from the start of a prepared panel to ξ."""
    panel, xi, begin, end = stretch
    work, local = workspace.scratch.work, workspace.local
    arrives = panel.kind == ARRIVE
    time = changes_at(panel, xi, work, local)
    rates = local[RATES]
    times = local[TIMES]
    freely = panel.sigma == 0 and body.resist == 0.0
    if freely:
        refine_rates(body, panel, xi, end.om * end.om, rates)
    resisting = resists(body, parameter_tangents)
    pressing = (0.0, 0.0)
    if resisting:
        pressing = pressed_on(body, stretch, weigh(panel, work, local))
        if freely and not arrives:  # as `first_resistance`
            s, c = sine_cosine(end.th, end.th_low)
            rates[BY_RESIST] = -2.0 * panel.direction * pressing[1] / inertia_at_height(body, load_height(s, c))
    part = 0.5 * (1.0 - xi)
    part *= part
    for k in range(tangents.shape[1]):
        dth0 = tangents[TH, k]
        dom0 = tangents[OM, k]
        given = 2.0 * begin.om * dom0
        if arrives:  # θ̇² at the start gives the turning point
            first = dth0
            given -= local[AT_BEGIN, BEGIN] * dth0 + by_parameters(local[AT_BEGIN], parameter_tangents, k)
            second = given / local[AT_BEGIN, SHIFT]
            tangents[TH, k] = dth0 * part + second * (1.0 - part)
        else:
            first = given
            second = dth0
        dt = first * times[BEGIN] + second * times[SHIFT] + by_parameters(times, parameter_tangents, k)
        du = first * rates[BEGIN] + second * rates[SHIFT] + by_parameters(rates, parameter_tangents, k)
        tangents[OM, k] = 0.5 * du / end.om if end.om != 0.0 else 0.0
        tangents[T, k] += dt
        if resisting:
            row = local[WEIGHED]
            weighed = first * row[BEGIN] + second * row[SHIFT] + by_parameters(row, parameter_tangents, k)
            tangents[ROLLING_LOSS, k] += loss_change(
                body, stretch, pressing, (dth0, dom0), weighed, k, parameter_tangents, tangents
            )
        if panel.sigma == 0:
            tangents[X, k] += tangents[TH, k] - dth0
        else:
            slip = SlipTime(panel.sigma, begin, end, time)
            follow_slip(body, slip, (dth0, dom0), dt, k, parameter_tangents, tangents)
