"""Rolling with rolling resistance on a panel: θ̇²(θ) from one linear ODE, as in slip (docs/model.md#rolling-resistance)."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart
from hophoop.kernel.numerics.collocation import ORDER, exponentials, total, truncation_error
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.numerics.trigonometry import rotated
from hophoop.kernel.panels.panel import (
    ARRIVE,
    COSINE,
    NORMAL,
    RATE,
    RESIST,
    RESOLVED,
    SINE,
    STIFFNESS,
    STRETCH,
    TIME,
    A,
    B,
    Totals,
    U,
    fill_geometry,
    sine_versine_of_offset,
)
from hophoop.kernel.panels.slip import from_reference
from hophoop.kernel.physics.contact import resisted_inertia, rolling_forces


@apart
def solve_resisted(body, panel, work):
    """Fill `work` for a rolling panel with rolling resistance.

    With D′ = D − ρ ε sin θ, the quantity E = D′ θ̇² obeys dE/dθ = (ρ ε cos θ/D′) E + 2 (torque − ρ g_n), whose factor is of
    order ρ. Row A holds E, which stays smooth where it is negative, beyond a turning point.
    """
    fill_geometry(panel, work)
    s0 = panel.sine
    c0 = panel.cosine
    eps = body.eps
    rho = panel.way * body.resist
    firm0 = resisted_inertia(body, s0, c0, rho)
    firms = work[STIFFNESS]
    growth = work[NORMAL]
    integral = work[TIME]
    factor = work[A]
    drive = work[B]
    lowest = math.inf
    for i in range(ORDER):
        # as changes from `ref`, as in rolling without resistance
        ds, dc = rotated(s0, c0, factor[i], drive[i])
        firm = firm0 + eps * (2.0 * dc - rho * ds)
        lowest = min(lowest, firm)
        stretch = work[STRETCH, i]
        work[SINE, i] = s0 + ds
        work[COSINE, i] = c0 + dc
        firms[i] = firm
        factor[i] = rho * eps * (c0 + dc) / firm * stretch
        drive[i] = 2.0 * (panel.arm + eps * (body.gn * ds + body.gt * dc)) * stretch
    if not lowest > 0.0:
        return Totals(math.inf, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    size = truncation_error(factor, 0.5)
    if not size <= RESOLVED:
        return Totals(size, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
    grown = exponential(from_reference(panel, factor, integral))
    exponentials(integral, growth)
    for i in range(ORDER):
        drive[i] /= growth[i]
    driven = from_reference(panel, drive, integral)
    start = firm0 * panel.u
    us = work[U]
    lowest = math.inf
    for i in range(ORDER):
        energy = growth[i] * (start + integral[i])
        work[A, i] = energy
        us[i] = energy / firms[i]
        lowest = min(lowest, energy)
    far = -1.0 if panel.kind == ARRIVE else 1.0
    ds, dc = rotated(s0, c0, *sine_versine_of_offset(panel, far))
    u_far = grown * (start + driven) / (firm0 + eps * (2.0 * dc - rho * ds))
    if not (lowest > 0.0 and u_far > 0.0):
        return Totals(math.inf, 0.0, u_far, 0.0, 0.0, math.nan, 0.0)
    for i in range(ORDER):
        work[RATE, i] = work[STRETCH, i] / math.sqrt(us[i])
        normal = rolling_forces(body, work[SINE, i], work[COSINE, i], us[i], rho)[1]
        work[RESIST, i] = body.resist * normal * work[STRETCH, i]
    size = max(size, truncation_error(work[RATE], 0.0), truncation_error(us, 0.0))
    if not size <= RESOLVED:
        return Totals(size, 0.0, u_far, 0.0, 0.0, math.nan, 0.0)
    return Totals(size, total(work[RATE]), u_far, 0.0, 0.0, math.nan, total(work[RESIST]))
