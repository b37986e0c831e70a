"""Slip: θ̇²(θ) from one linear ODE, the rest by quadrature (docs/model.md#slip-as-one-quadrature)."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import (
    ORDER,
    antiderivative,
    divided_by_exponentials,
    integrals,
    remainders,
    smallest,
    total,
    truncation_error,
)
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.numerics.trigonometry import rotated
from hophoop.kernel.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    NORMAL,
    POWER,
    RATE,
    RESIST,
    RESOLVED,
    SINE,
    SLIP,
    SLIP_RATE,
    STIFFNESS,
    STRETCH,
    TIME,
    A,
    B,
    Totals,
    U,
    fill_geometry,
    rows_are_known,
)
from hophoop.kernel.physics.contact import contact_arms


@inline
def direction_from_reference(panel):
    """Return ±1, the direction of θ from `ref` to the far end of a panel."""
    return -panel.way if panel.kind == ARRIVE else panel.way


@inline
def away_from_reference(panel, values, out):
    """Integrate values abs(dξ) from `ref` to each node; return the integral from `ref` to the far end."""
    if panel.kind == ARRIVE:
        remainders(values, out)
    else:
        integrals(values, out)
    return total(values)


@inline
def from_reference(panel, values, out):
    """Integrate as `away_from_reference`, with the sign of dθ."""
    whole = away_from_reference(panel, values, out)
    way = direction_from_reference(panel)
    for i in range(ORDER):
        out[i] *= way
    return way * whole


@apart
def slip_resisted(body, work):
    """Return the energy lost to rolling resistance on a solved slip panel, and fill its power."""
    for i in range(ORDER):
        work[RESIST, i] = body.resist * work[NORMAL, i] * work[STRETCH, i]
    return total(work[RESIST])


@inline
def solve_slip(body, panel, work):
    """Fill `work` for a slip panel: du/dθ = a u + b by its integrating factor, then t, v_t and the friction work.

    If the panel extends beyond a turning point only row U is meaningful, and the tail is infinite.
    """
    if not rows_are_known(work):
        return Totals(math.inf, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    fill_geometry(panel, work)
    sigma = panel.sigma
    s0 = panel.sine
    c0 = panel.cosine
    eps = body.eps
    sines = work[SINE]
    cosines = work[COSINE]
    stretch = work[STRETCH]
    damping = work[A]
    drive = work[B]
    growth = work[NORMAL]
    integral = work[TIME]
    arms = work[ARM]
    heights = work[POWER]  # height of G above the plane, until the power is known
    stiffnesses = work[STIFFNESS]
    signed_mu = sigma * body.mu_k
    height0 = contact_arms(body, s0, c0)[0]
    arm0 = panel.arm
    stiffness0 = panel.stiffness
    way = direction_from_reference(panel)
    for i in range(ORDER):
        # as changes from `ref`: near p_σ = 0 direct evaluation would give only rounding
        ds, dc = rotated(s0, c0, damping[i], drive[i])
        s = s0 + ds
        c = c0 + dc
        turned = eps * (ds + signed_mu * dc)
        arm = arm0 + turned
        stiffness = stiffness0 + eps * (ds * arm + s0 * turned)
        share = 2.0 * arm / stiffness * stretch[i] * way
        sines[i] = s
        cosines[i] = c
        arms[i] = arm
        heights[i] = height0 + eps * dc
        stiffnesses[i] = stiffness
        damping[i] = -eps * c * share
        drive[i] = body.gn * share
    least = smallest(stiffnesses)
    if not least > 0.0:
        return Totals(math.inf, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    size = truncation_error(damping, 0.5)
    if not size <= RESOLVED:
        return Totals(size, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    exponent = away_from_reference(panel, damping, integral)
    divided_by_exponentials(integral, growth, drive)
    driven = away_from_reference(panel, drive, integral)
    us = work[U]
    for i in range(ORDER):
        us[i] = growth[i] * (panel.u + integral[i])
    growth_far = exponential(exponent)
    u_far = growth_far * (panel.u + driven)
    if not (smallest(us) > 0.0 and (panel.kind == ARRIVE or u_far > 0.0)):
        return Totals(math.inf, 0.0, u_far, 0.0, 0.0, growth_far, 0.0)
    rates = work[RATE]
    normals = work[NORMAL]
    slip_rates = work[SLIP_RATE]
    for i in range(ORDER):
        u = us[i]
        load = (body.gn - eps * cosines[i] * u) / stiffnesses[i]
        friction_part = signed_mu * body.kap + heights[i] * arms[i]
        rate = stretch[i] / math.sqrt(u)
        rates[i] = rate
        normals[i] = body.kap * load
        slip_rates[i] = (body.gt + eps * sines[i] * u - load * friction_part) * rate
    # near p_σ = 0 the force is dominated by the rounding of f_n, so a lower smoothness is accepted there
    weight = body.gn + panel.u
    size = max(size, truncation_error(rates, 0.0), truncation_error(normals, max(weight, 2e-3 * body.kap * weight / least)))
    if not size <= RESOLVED:
        return Totals(size, 0.0, u_far, 0.0, 0.0, growth_far, 0.0)
    time = total(rates)
    slips = work[SLIP]
    vt = panel.vt + antiderivative(slip_rates, slips)
    power = work[POWER]
    for i in range(ORDER):
        slips[i] += panel.vt
        # without abs(), so that it stays smooth beyond the end of slip
        power[i] = sigma * body.mu_k * normals[i] * slips[i] * rates[i]
    resisted = slip_resisted(body, work) if body.resist > 0.0 else 0.0
    return Totals(size, time, u_far, vt, total(power), growth_far, resisted)
