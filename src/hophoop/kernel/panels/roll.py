"""Rolling on a panel: θ̇² in closed form, time by quadrature (docs/model.md#rolling-in-closed-form)."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.collocation import ORDER, total, truncation_error
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.numerics.trigonometry import rotated, turn_deficits
from hophoop.kernel.panels.panel import (
    ARRIVE,
    COSINE,
    NORMAL,
    RATE,
    RESOLVED,
    SINE,
    STRETCH,
    A,
    B,
    Totals,
    U,
    angle_at,
    fill_geometry,
    rows_are_known,
    sine_versine_of_offset,
)
from hophoop.kernel.physics.contact import cone_weights, inertia_at_height, load_height, rolling_forces

# If D falls on a panel to less than this fraction of itself, θ̇² and the force vary in a way that the time does not show: a
# nearly massless hoop near the angle where the load meets the plane.
STEEP = 0.25


@inline
def energy_gained(body, panel, sine, versine, offset):
    """Return the change of D θ̇² on a rolling panel over φ = offset from its reference, given sin φ and 1 − cos φ."""
    gained = sine * panel.arm + versine * panel.stiffness
    if body.gt != 0.0:
        gained += body.gt * turn_deficits(offset)[0]
    return 2.0 * gained


@inline
def u_on_panel(body, panel, sine, versine, offset):
    """Return θ̇² on a rolling panel at φ = offset from its reference, given sin φ and 1 − cos φ."""
    inertia = inertia_at_height(body, load_height(panel.sine, panel.cosine))
    energy = inertia * panel.u + energy_gained(body, panel, sine, versine, offset)
    return energy / (inertia + 2.0 * body.eps * rotated(panel.sine, panel.cosine, sine, versine)[1])


@inline
def solve_roll(body, panel, work):
    """Fill `work` for a rolling panel.

    Row A holds D θ̇², which stays smooth where it is negative, beyond a turning point.
    """
    if not rows_are_known(work):
        return Totals(math.inf, 0.0, math.nan, 0.0, 0.0, math.nan, 0.0)
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
    energies = work[A]
    versines = work[B]
    for i in range(ORDER):
        sine = energies[i]
        versine = versines[i]
        offset = angle_at(panel, NODES[i]) if body.gt != 0.0 else 0.0
        energy = start + energy_gained(body, panel, sine, versine, offset)
        ds, dc = rotated(s0, c0, sine, versine)
        u = energy / (inertia + 2.0 * body.eps * dc)
        sines[i] = s0 + ds
        cosines[i] = c0 + dc
        energies[i] = energy
        us[i] = u
        rates[i] = stretch[i] / math.sqrt(u if u > 0.0 else 0.0)  # infinite beyond a turning point
    size = truncation_error(rates, 0.0)
    if not size <= RESOLVED:
        return Totals(size, 0.0, us[ORDER - 1], 0.0, 0.0, math.nan, 0.0)
    first = energies[0] * us[ORDER - 1]
    last = energies[ORDER - 1] * us[0]
    if not STEEP * max(first, last) < min(first, last):
        size = truncation_error(us, 0.0)
        if not size <= RESOLVED:
            return Totals(size, 0.0, us[ORDER - 1], 0.0, 0.0, math.nan, 0.0)
    time = total(rates)
    far = -1.0 if panel.kind == ARRIVE else 1.0
    sine, versine = sine_versine_of_offset(panel, far)
    u = u_on_panel(body, panel, sine, versine, far * panel.way * panel.extent)
    if not u > 0.0:
        size = math.inf
    return Totals(size, time, u, 0.0, 0.0, math.nan, 0.0)


@inline
def roll_margins(body, panel, work):
    """Fill rows A and B with the margins to both sides of the friction cone, positive inside, and NORMAL with N."""
    a, b = cone_weights(body.mu_s)
    rho = panel.way * body.resist
    for i in range(ORDER):
        friction, normal = rolling_forces(body, work[SINE, i], work[COSINE, i], work[U, i], rho)
        work[NORMAL, i] = normal
        work[A, i] = a * normal - b * friction
        work[B, i] = a * normal + b * friction
