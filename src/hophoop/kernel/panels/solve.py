"""Contact on a panel: θ̇² of rolling in closed form or, with rolling resistance and in slip, from one linear equation.

Time and slip velocity follow by quadrature. See docs/model.md#rolling-in-closed-form, docs/model.md#rolling-resistance and
docs/model.md#slip-as-one-quadrature.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.circular import series_remainders, sine_cosine_change_by
from hophoop.kernel.numerics.collocation import (
    ORDER,
    antiderivative,
    divided_by_exponentials,
    exponentials,
    extremes,
    total,
    truncation_error,
)
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import (
    ARM,
    ARRIVE,
    COSINE,
    DAMPING,
    DRIVE,
    DRIVEN,
    ENERGY,
    EXPONENT,
    GROWTH,
    INERTIA,
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
    angle_at,
    away_from_reference,
    direction_from_reference,
    fill_geometry,
    fill_rolling_power,
    from_reference,
    rows_are_known,
    sine_versine_of_offset,
)
from hophoop.kernel.physics.contact import contact_arms, inertia_at_height, load_height, resisted_inertia, rolling_forces

# If D falls on a panel to less than this fraction of itself, θ̇² and the force vary more than the time shows: a
# nearly massless hoop near the angle where the load meets the plane.
STEEP = 0.25


@inline
def energy_gained(body, panel, sine, versine, offset):
    """Return the change of D θ̇² on a rolling panel over φ = offset from its reference, given sin φ and 1 − cos φ."""
    gained = sine * panel.torque + versine * panel.curvature
    if body.gt != 0.0:
        gained += body.gt * series_remainders(offset)[0]
    return 2.0 * gained


@inline
def u_on_panel(body, panel, sine, versine, offset):
    """Return θ̇² on a rolling panel at φ = offset from its reference, given sin φ and 1 − cos φ."""
    inertia = inertia_at_height(body, load_height(panel.sine, panel.cosine))
    energy = inertia * panel.u + energy_gained(body, panel, sine, versine, offset)
    return energy / (inertia + 2.0 * body.eps * sine_cosine_change_by(panel.sine, panel.cosine, sine, versine)[1])


@inline
def unsolved(tail, u):
    """Return the Totals of a panel that is not resolved: its error measure, and θ̇² at its far end or nan."""
    return Totals(tail, 0.0, u, 0.0, 0.0, 0.0)


@inline
def solve_roll(body, panel, work):
    """Fill the rows of a rolling panel without rolling resistance; return the Totals.

    D θ̇² stays smooth where it is negative, beyond a turning point.
    """
    if not rows_are_known(work):
        return unsolved(math.inf, math.nan)
    fill_geometry(panel, work)
    s0 = panel.sine
    c0 = panel.cosine
    # as a change from `ref`: near θ = π with γ = 1 direct evaluation would give only rounding
    inertia = inertia_at_height(body, load_height(s0, c0))
    start = inertia * panel.u
    sines = work[SINE]
    cosines = work[COSINE]
    us = work[U]
    rates = work[RATE]
    stretch = work[STRETCH]
    energies = work[ENERGY]
    for i in range(ORDER):
        sine = work[OFFSET_SINE, i]
        versine = work[OFFSET_VERSINE, i]
        offset = angle_at(panel, NODES[i]) if body.gt != 0.0 else 0.0
        energy = start + energy_gained(body, panel, sine, versine, offset)
        ds, dc = sine_cosine_change_by(s0, c0, sine, versine)
        u = energy / (inertia + 2.0 * body.eps * dc)
        sines[i] = s0 + ds
        cosines[i] = c0 + dc
        energies[i] = energy
        us[i] = u
        rates[i] = stretch[i] / math.sqrt(u if u > 0.0 else 0.0)  # infinite beyond a turning point
    size = truncation_error(rates, 0.0)
    if not size <= RESOLVED:
        return unsolved(size, us[ORDER - 1])
    first = energies[0] * us[ORDER - 1]
    last = energies[ORDER - 1] * us[0]
    if not STEEP * max(first, last) < min(first, last):
        size = truncation_error(us, 0.0)
        if not size <= RESOLVED:
            return unsolved(size, us[ORDER - 1])
    time = total(rates)
    far = -1.0 if panel.kind == ARRIVE else 1.0
    sine, versine = sine_versine_of_offset(panel, far)
    u = u_on_panel(body, panel, sine, versine, far * panel.direction * panel.extent)
    if not u > 0.0:
        size = math.inf
    return Totals(size, time, u, 0.0, 0.0, 0.0)


@noinline
def solve_resisted(body, panel, work):
    """Fill the rows of a rolling panel with rolling resistance; return the Totals.

    With D′ = D − ρ ε sin θ, the quantity E = D′ θ̇² obeys dE/dθ = (ρ ε cos θ/D′) E + 2 (torque − ρ g_n), whose factor is of
    order ρ. E stays smooth where it is negative, beyond a turning point.
    """
    fill_geometry(panel, work)
    s0 = panel.sine
    c0 = panel.cosine
    eps = body.eps
    rho = panel.direction * body.resist
    inertia0 = resisted_inertia(body, s0, c0, rho)
    lowest = math.inf
    for i in range(ORDER):
        # as changes from `ref`, as in rolling without resistance
        ds, dc = sine_cosine_change_by(s0, c0, work[OFFSET_SINE, i], work[OFFSET_VERSINE, i])
        inertia = inertia0 + eps * (2.0 * dc - rho * ds)
        lowest = min(lowest, inertia)
        stretch = work[STRETCH, i]
        work[SINE, i] = s0 + ds
        work[COSINE, i] = c0 + dc
        work[INERTIA, i] = inertia
        work[DAMPING, i] = rho * eps * (c0 + dc) / inertia * stretch
        work[DRIVE, i] = 2.0 * (panel.torque + eps * (body.gn * ds + body.gt * dc)) * stretch
    if not lowest > 0.0:
        return unsolved(math.inf, math.nan)
    size = truncation_error(work[DAMPING], 0.5)
    if not size <= RESOLVED:
        return unsolved(size, math.nan)
    growth_far = exponential(from_reference(panel, work[DAMPING], work[EXPONENT]))
    exponentials(work[EXPONENT], work[GROWTH])
    for i in range(ORDER):
        work[SCALED_DRIVE, i] = work[DRIVE, i] / work[GROWTH, i]
    driven = from_reference(panel, work[SCALED_DRIVE], work[DRIVEN])
    start = inertia0 * panel.u
    us = work[U]
    lowest = math.inf
    for i in range(ORDER):
        energy = work[GROWTH, i] * (start + work[DRIVEN, i])
        work[ENERGY, i] = energy
        us[i] = energy / work[INERTIA, i]
        lowest = min(lowest, energy)
    far = -1.0 if panel.kind == ARRIVE else 1.0
    ds, dc = sine_cosine_change_by(s0, c0, *sine_versine_of_offset(panel, far))
    u_far = growth_far * (start + driven) / (inertia0 + eps * (2.0 * dc - rho * ds))
    if not (lowest > 0.0 and u_far > 0.0):
        return unsolved(math.inf, u_far)
    for i in range(ORDER):
        work[RATE, i] = work[STRETCH, i] / math.sqrt(us[i])
        work[NORMAL, i] = rolling_forces(body, work[SINE, i], work[COSINE, i], us[i], rho)[1]
    lost = fill_rolling_power(body, work)
    size = max(size, truncation_error(work[RATE], 0.0), truncation_error(us, 0.0))
    if not size <= RESOLVED:
        return unsolved(size, u_far)
    return Totals(size, total(work[RATE]), u_far, 0.0, 0.0, lost)


@inline
def solve_slip(body, panel, work):
    """Fill the rows of a slip panel: du/dθ = a u + b by its integrating factor, then t, v_t and the friction work.

    Returns the Totals. If the panel extends beyond a turning point only row U is meaningful, and the tail is infinite.
    """
    if not rows_are_known(work):
        return unsolved(math.inf, math.nan)
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
        return unsolved(math.inf, math.nan)
    size = truncation_error(damping, 0.5)
    if not size <= RESOLVED:
        return unsolved(size, math.nan)
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
        return unsolved(math.inf, u_far)
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
        return unsolved(size, u_far)
    time = total(rates)
    slips = work[SLIP]
    vt = panel.vt + antiderivative(slip_rates, slips)
    power = work[POWER]
    for i in range(ORDER):
        slips[i] += panel.vt
        # without abs(), so that it stays smooth beyond the end of slip
        power[i] = sigma * body.mu_k * normals[i] * slips[i] * rates[i]
    rolling_loss = fill_rolling_power(body, work) if body.resist > 0.0 else 0.0
    return Totals(size, time, u_far, vt, total(power), rolling_loss)
