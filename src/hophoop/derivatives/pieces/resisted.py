"""Rolling resistance in the derivatives on a panel, and the derivatives of its loss (docs/derivatives.md#on-a-panel)."""

from __future__ import annotations

from typing import Any, NamedTuple

from hophoop.derivatives.layout import EPS, GN, OM, RESIST, TH
from hophoop.derivatives.workspace import (
    BEGIN,
    BY_EPS,
    BY_GN,
    BY_GT,
    BY_KAP,
    BY_MU,
    BY_RESIST,
    LOCAL,
    SHIFT,
    SLOPE,
    WEIGH,
    WEIGHED,
    integrate_row,
)
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_cosine, sine_cosine_change_by
from hophoop.kernel.numerics.collocation import ORDER, dot
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import (
    ARRIVE,
    COSINE,
    DRIVEN,
    GROWTH,
    INERTIA,
    KAPPA_P_SIGMA,
    OFFSET_SINE,
    OFFSET_VERSINE,
    SINE,
    STRETCH,
    U,
    angle_at,
    from_reference,
)
from hophoop.kernel.physics.contact import inertia_at_height, load_height, resisted_inertia


def resists(body, parameter_tangents):
    """Return True if there is rolling resistance, or a direction that changes it."""
    found = body.resist > 0.0
    for k in range(parameter_tangents.shape[1]):
        found = found or parameter_tangents[RESIST, k] != 0.0
    return found


@noinline
def resisted_rates(body, panel, work, local):
    """Rows of dθ̇²/d… on a rolling panel with rolling resistance, from θ̇²′ = 2 θ̈, which is linear in θ̇²."""
    eps = body.eps
    rho = panel.direction * body.resist
    growth = local[BEGIN]
    s0 = panel.sine
    c0 = panel.cosine
    inertia0 = resisted_inertia(body, s0, c0, rho)
    slope = 2.0 * (panel.torque + eps * (s0 + rho * c0) * panel.u) / inertia0
    for i in range(ORDER):
        ds, dc = sine_cosine_change_by(s0, c0, work[OFFSET_SINE, i], work[OFFSET_VERSINE, i])
        s = work[SINE, i]
        c = work[COSINE, i]
        u = work[U, i]
        more = 2.0 / work[INERTIA, i]
        growth[i] = work[GROWTH, i] * inertia0 / work[INERTIA, i]  # D′ θ̇² grows by the numerator
        alpha = 0.5 * more * (panel.torque + eps * (body.gn * ds + body.gt * dc + (s + rho * c) * u))
        local[SLOPE, i] = 2.0 * alpha
        local[SHIFT, i] = 2.0 * alpha - slope * growth[i]
        local[BY_EPS, i] = more * (s * (u + body.gn) + c * (body.gt + rho * u) - alpha * (2.0 * (eps + c) - rho * s))
        local[BY_KAP, i] = -more * alpha
        local[BY_MU, i] = 0.0
        local[BY_GN, i] = more * (eps * s - rho)
        local[BY_GT, i] = more * (1.0 + eps * c)
    integrate_row(panel, local[BY_EPS], growth, work)
    integrate_row(panel, local[BY_KAP], growth, work)
    integrate_row(panel, local[BY_GN], growth, work)
    integrate_row(panel, local[BY_GT], growth, work)


@noinline
def first_resistance(body, panel, work, local):
    """The row BY_RESIST of rolling without resistance: D θ̇² loses 2 ρ ∫ N dθ, which `lost_to_resistance` takes apart."""
    row = local[BY_RESIST]
    integral = work[DRIVEN]
    for i in range(ORDER):
        row[i] = work[COSINE, i] * work[U, i] * work[STRETCH, i]
    from_reference(panel, row, integral)
    for i in range(ORDER):
        s = work[SINE, i]
        swung = s * work[U, i] - panel.sine * panel.u + integral[i]
        pressed = body.gn * angle_at(panel, NODES[i]) - 0.5 * body.eps * swung
        row[i] = -2.0 * panel.direction * pressed / inertia_at_height(body, load_height(s, work[COSINE, i]))


@noinline
def resistance_rates(body, panel, work, local):
    """The row BY_RESIST: the couple changes θ̈ by −N over κ p_σ in slip, over D − ρ ε sin θ in rolling."""
    if panel.sigma == 0 and body.resist == 0.0:
        first_resistance(body, panel, work, local)
        return
    weights = work[INERTIA if panel.sigma == 0 else KAPPA_P_SIGMA]
    for i in range(ORDER):
        normal = body.gn - body.eps * (0.5 * work[SINE, i] * local[SLOPE, i] + work[COSINE, i] * work[U, i])
        local[BY_RESIST, i] = -2.0 * panel.direction * normal / weights[i]
    integrate_row(panel, local[BY_RESIST], local[BEGIN], work)


@noinline
def weigh(panel, work, local):
    """Fill the row WEIGHED: how ∫ cos θ θ̇² dθ, of which the angles stay, changes from the start of a panel to a position on it.

    `changes_at` has left the weights of that place, without the integrand. Returns the integral itself.
    """
    weights = local[WEIGH]
    moved = 0.0
    fixed = 0.0
    for i in range(ORDER):
        weights[i] *= panel.direction * work[COSINE, i] * work[STRETCH, i]
        part = 0.0
        if panel.kind == ARRIVE:
            part = 0.5 * (1.0 - NODES[i])
            part *= part
        moved += weights[i] * local[SLOPE, i] * (1.0 - part)
        fixed += weights[i] * local[SLOPE, i] * part
    for row in range(LOCAL):
        local[WEIGHED, row] = dot(weights, local[row])
    local[WEIGHED, SHIFT] -= moved
    local[WEIGHED, BEGIN] -= fixed
    return dot(weights, work[U])


class Stretch(NamedTuple):
    """A panel from its start to ξ, and the states there."""

    panel: Any
    xi: float
    begin: Any
    end: Any


def pressed_on(body, stretch, integral):
    """(Δ(sin θ θ̇²) + ∫ cos θ θ̇² dθ, ∫ N dθ) on a stretch; `integral` is that of the first.

    From N = g_n − ε (sin θ θ̈ + cos θ θ̇²) and θ̈ = ½ dθ̇²/dθ: ∫ N dθ = g_n Δθ − ½ ε times the first.
    """
    panel, xi, begin, end = stretch
    s0, _ = sine_cosine(begin.th, begin.th_low)
    s1, _ = sine_cosine(end.th, end.th_low)
    swung = s1 * end.om * end.om - s0 * begin.om * begin.om + integral
    return swung, body.gn * (angle_at(panel, xi) - angle_at(panel, -1.0)) - 0.5 * body.eps * swung


def loss_change(body, stretch, pressing, before, weighed, k, parameter_tangents, tangents):
    """Change of the loss f ∫ N abs(dθ) on a stretch, where the other tangents are those at its end.

    `pressing` is the result of `pressed_on`, `weighed` the change of ∫ cos θ θ̇² dθ between fixed angles.
    """
    panel, xi, begin, end = stretch
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    s1, c1 = sine_cosine(end.th, end.th_low)
    swung, pressed = pressing
    dth0, dom0 = before
    dth1 = tangents[TH, k]
    dswung = end.om * (c1 * end.om * dth1 + s1 * tangents[OM, k]) - begin.om * (c0 * begin.om * dth0 + s0 * dom0)
    dpressed = parameter_tangents[GN, k] * (angle_at(panel, xi) - angle_at(panel, -1.0)) + body.gn * (dth1 - dth0)
    dpressed -= 0.5 * (parameter_tangents[EPS, k] * swung + body.eps * (2.0 * dswung + weighed))
    return panel.direction * (body.resist * dpressed + parameter_tangents[RESIST, k] * pressed)
