"""Rolling: θ̇²(θ) in closed form, time by quadrature (physics.md, 'Rolling in closed form')."""

from __future__ import annotations

import math

from hophoop._collocation import NODES, ORDER, tail, total
from hophoop._jit import lean_jit
from hophoop.physics.contact import cone_weights, inertia_at_height, load_height, rolling_forces
from hophoop.physics.panel import (
    A,
    ARRIVE,
    B,
    COSINE,
    LINEAR,
    NORMAL,
    RATE,
    RESOLVED,
    SINE,
    STRETCH,
    U,
    Totals,
    angle_at,
    fill_geometry,
    turn,
    turn_over,
)


@lean_jit
def rolling_energy_change(body, ds, dc, offset):
    """Change of D θ̇² when sin θ, cos θ and θ change by these."""
    return 2.0 * (body.eps * (body.gt * ds - body.gn * dc) + body.gt * offset)


@lean_jit
def rolling_u(body, th0, u0, offset):
    """θ̇² at th0 + offset of a hoop that rolls with θ̇² = u0 at th0; negative where it does not get there."""
    s0 = math.sin(th0)
    c0 = math.cos(th0)
    ds, dc = turn(s0, c0, offset)
    inertia = inertia_at_height(body, load_height(s0, c0))
    energy = inertia * u0 + rolling_energy_change(body, ds, dc, offset)
    return energy / (inertia + 2.0 * body.eps * dc)


@lean_jit
def u_on_panel(body, panel, ds, dc, offset):
    """θ̇² on a rolling panel, from sin θ − sin θ_ref, cos θ − cos θ_ref and θ − θ_ref."""
    inertia = inertia_at_height(body, load_height(panel.sine, panel.cosine))
    energy = inertia * panel.u + rolling_energy_change(body, ds, dc, offset)
    return energy / (inertia + 2.0 * body.eps * dc)


@lean_jit
def solve_roll(body, panel, work):
    """Fill `work` for a rolling panel.

    The row A holds D θ̇², which is smooth also where it turns negative beyond a turning point.
    """
    fill_geometry(panel, work)
    s0 = panel.sine
    c0 = panel.cosine
    # as a change from `ref`: near θ = π and γ = 1 rounding would else be all that the panel shows
    inertia = inertia_at_height(body, load_height(s0, c0))
    start = inertia * panel.u
    sines = work[SINE]
    cosines = work[COSINE]
    us = work[U]
    rates = work[RATE]
    stretch = work[STRETCH]
    energies = work[A]
    dcs = work[B]
    for i in range(ORDER):
        ds = energies[i]
        dc = dcs[i]
        offset = angle_at(panel, NODES[i]) if body.gt != 0.0 else 0.0
        energy = start + rolling_energy_change(body, ds, dc, offset)
        u = energy / (inertia + 2.0 * body.eps * dc)
        sines[i] = s0 + ds
        cosines[i] = c0 + dc
        energies[i] = energy
        us[i] = u
    for i in range(ORDER):
        rates[i] = stretch[i] / math.sqrt(max(us[i], 0.0))  # infinite beyond a turning point
    size = tail(rates, 0.0)
    if not size <= RESOLVED:
        return Totals(size, 0.0, us[ORDER - 1], 0.0, 0.0)
    time = total(rates)
    if panel.kind == ARRIVE:
        u = 0.0
    else:
        offset = panel.way * panel.extent
        if panel.kind == LINEAR:
            ds, dc = turn_over(panel)
        else:
            ds, dc = turn(s0, c0, offset)
        u = u_on_panel(body, panel, ds, dc, offset)
        if not u > 0.0:
            size = math.inf
    return Totals(size, time, u, 0.0, 0.0)


@lean_jit
def roll_margins(body, work):
    """Rows A and B become the margins to the two sides of the friction cone, positive inside; NORMAL is N."""
    a, b = cone_weights(body.mu_s)
    for i in range(ORDER):
        friction, normal = rolling_forces(body, work[SINE, i], work[COSINE, i], work[U, i])
        work[NORMAL, i] = normal
        work[A, i] = a * normal - b * friction
        work[B, i] = a * normal + b * friction
