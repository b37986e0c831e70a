"""How the contact force of rolling changes with the state and the parameters."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import EPS, GN, GT, KAP, OM, RESIST, TH
from hophoop.kernel.native import noinline
from hophoop.kernel.physics.contact import resisted_inertia, rolling_acceleration, rolling_forces


@noinline
def rolling_slopes(body, s, c, om, rho):
    """(F, N, θ̈, slopes of F, slopes of N) in rolling, by θ, u = θ̇², ε, κ, g_n, g_t and f.

    From D′ θ̈ = ε s (u + g_n) + (1 + ε c) g_t − ρ (g_n − ε c u), D′ = D − ρ ε s, F = (1 + ε c) θ̈ − ε s u − g_t and
    N = g_n − ε s θ̈ − ε c u.
    """
    eps = body.eps
    u = om * om
    arm = 1.0 + eps * c
    alpha = rolling_acceleration(body, s, c, u, rho)
    inertia = resisted_inertia(body, s, c, rho)
    friction, normal = rolling_forces(body, s, c, u, rho)
    a_th = eps * (c * (u + body.gn) - s * (body.gt + rho * u) + alpha * (2.0 * s + rho * c)) / inertia
    a_u = eps * (s + rho * c) / inertia
    a_eps = (s * (u + body.gn) + c * (body.gt + rho * u) - alpha * (2.0 * (eps + c) - rho * s)) / inertia
    a_kap = -alpha / inertia
    a_gn = (eps * s - rho) / inertia
    a_gt = arm / inertia
    a_resist = -math.copysign(normal, rho if rho != 0.0 else om) / inertia
    of_friction = (
        a_th * arm - eps * (alpha * s + c * u), a_u * arm - eps * s, a_eps * arm + alpha * c - s * u,
        a_kap * arm, a_gn * arm, a_gt * arm - 1.0, a_resist * arm,
    )  # fmt: skip
    of_normal = (
        eps * (s * (u - a_th) - c * alpha), -eps * (s * a_u + c), -eps * s * a_eps - s * alpha - c * u,
        -eps * s * a_kap, 1.0 - eps * s * a_gn, -eps * s * a_gt, -eps * s * a_resist,
    )  # fmt: skip
    return friction, normal, alpha, of_friction, of_normal


def by_angle(slopes, alpha):
    """Return the rate by θ along the motion of a quantity with such slopes."""
    return slopes[0] + 2.0 * slopes[1] * alpha


def change_of(slopes, om, tangents, parameter_tangents, k):
    """Return the change of a quantity with such slopes in a direction."""
    by_th, by_u, by_eps, by_kap, by_gn, by_gt, by_resist = slopes
    by_state = by_th * tangents[TH, k] + 2.0 * by_u * om * tangents[OM, k]
    by_body = (
        by_eps * parameter_tangents[EPS, k]
        + by_kap * parameter_tangents[KAP, k]
        + by_gn * parameter_tangents[GN, k]
        + by_gt * parameter_tangents[GT, k]
    )
    return by_state + by_body + by_resist * parameter_tangents[RESIST, k]
