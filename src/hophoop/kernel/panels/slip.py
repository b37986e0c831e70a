"""Slip: θ̇²(θ) from one linear ODE, the rest by quadrature (docs/model.md#slip-as-one-quadrature)."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.circular import sine_cosine_change_by
from hophoop.kernel.numerics.collocation import (
    ORDER,
    antiderivative,
    divided_by_exponentials,
    extremes,
    total,
    truncation_error,
)
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    DAMPING,
    DRIVE,
    DRIVEN,
    EXPONENT,
    GROWTH,
    KAPPA_P_SIGMA,
    LEVER,
    NORMAL,
    OFFSET_SINE,
    OFFSET_VERSINE,
    POWER,
    RATE,
    RESOLVED,
    SCALED_DRIVE,
    SINE,
    SLIP,
    SLIP_RATE,
    STRETCH,
    Totals,
    U,
    away_from_reference,
    direction_from_reference,
    fill_geometry,
    fill_rolling_power,
    rows_are_known,
)
from hophoop.kernel.physics.contact import contact_arms


@inline
def solve_slip(body, panel, work):
    """Fill the rows of a slip panel: du/dθ = a u + b by its integrating factor, then t, v_t and the friction work.

    Returns the Totals. If the panel extends beyond a turning point only row U is meaningful, and the tail is infinite.
    """
    if not rows_are_known(work):
        return Totals(math.inf, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    fill_geometry(panel, work)
    sigma = panel.sigma
    s0 = panel.sine
    c0 = panel.cosine
    eps = body.eps
    signed_mu = sigma * body.mu_k
    direction = direction_from_reference(panel)
    lever0 = contact_arms(body, s0, c0)[0]
    arm0 = panel.arm
    kappa_p_sigma0 = panel.kappa_p_sigma
    sines = work[SINE]
    cosines = work[COSINE]
    stretch = work[STRETCH]
    levers = work[LEVER]
    arms = work[ARM]
    kappa_p_sigmas = work[KAPPA_P_SIGMA]
    damping = work[DAMPING]
    drive = work[DRIVE]
    for i in range(ORDER):
        # as changes from `ref`: near p_σ = 0 direct evaluation would give only rounding
        ds, dc = sine_cosine_change_by(s0, c0, work[OFFSET_SINE, i], work[OFFSET_VERSINE, i])
        s = s0 + ds
        c = c0 + dc
        turned = eps * (ds + signed_mu * dc)
        arm = arm0 + turned
        kappa_p_sigma = kappa_p_sigma0 + eps * (ds * arm + s0 * turned)
        share = 2.0 * arm / kappa_p_sigma * stretch[i] * direction
        sines[i] = s
        cosines[i] = c
        levers[i] = lever0 + eps * dc
        arms[i] = arm
        kappa_p_sigmas[i] = kappa_p_sigma
        damping[i] = -eps * c * share
        drive[i] = body.gn * share
    least = extremes(kappa_p_sigmas)[0]
    if not least > 0.0:
        return Totals(math.inf, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    size = truncation_error(damping, 0.5)
    if not size <= RESOLVED:
        return Totals(size, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    growth = work[GROWTH]
    driven = work[DRIVEN]
    growth_far = exponential(away_from_reference(panel, damping, work[EXPONENT]))
    divided_by_exponentials(work[EXPONENT], growth, drive, work[SCALED_DRIVE])
    driven_far = away_from_reference(panel, work[SCALED_DRIVE], driven)
    us = work[U]
    for i in range(ORDER):
        us[i] = growth[i] * (panel.u + driven[i])
    u_far = growth_far * (panel.u + driven_far)
    if not (extremes(us)[0] > 0.0 and (panel.kind == ARRIVE or u_far > 0.0)):
        return Totals(math.inf, 0.0, u_far, 0.0, 0.0, growth_far, 0.0)
    rates = work[RATE]
    normals = work[NORMAL]
    slip_rates = work[SLIP_RATE]
    for i in range(ORDER):
        u = us[i]
        load = (body.gn - eps * cosines[i] * u) / kappa_p_sigmas[i]
        friction_part = signed_mu * body.kap + levers[i] * arms[i]
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
    rolling_loss = fill_rolling_power(body, work) if body.resist > 0.0 else 0.0
    return Totals(size, time, u_far, vt, total(power), growth_far, rolling_loss)
