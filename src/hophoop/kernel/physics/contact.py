"""Contact-space quantities: W, f, p_σ, and the forces in roll and slip (docs/model.md#contact-space).

ρ is the couple of the rolling resistance over R N, from `resistance.resistance_arm`; 0.0 without resistance.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline


@inline
def free_acceleration(body, s, c, u):
    """Return (f_t, f_n), the acceleration of the lowest rim point without contact force; u = θ̇²."""
    return body.gt + body.eps * s * u, -body.gn + body.eps * c * u


@inline
def delassus(body, s, c):
    """Return (W_tt, W_nn, W_tn), the acceleration of the lowest rim point per unit force in units of 1/m; requires κ > 0."""
    arm, lever = contact_arms(body, s, c)
    return 1.0 + arm * arm / body.kap, 1.0 + lever * lever / body.kap, -lever * arm / body.kap


@inline
def contact_arms(body, s, c):
    """Return (1 + ε cos θ, ε sin θ), the arms of a tangential and a normal force about G, with all digits."""
    return (1.0 - body.eps) + body.eps * load_height(s, c), body.eps * s


@inline
def slip_torque_arm(body, s, c, sigma):
    """Return q = ε sin θ + σ μk (1 + ε cos θ), the torque about G over N in slip."""
    arm, lever = contact_arms(body, s, c)
    return lever + sigma * body.mu_k * arm


@inline
def slip_stiffness(body, s, c, sigma, rho):
    """Return κ p_σ = κ + ε sin θ (q − ρ); Painlevé's paradox occurs where it is not positive."""
    return body.kap + body.eps * s * slip_torque_arm(body, s, c, sigma) - body.eps * s * rho


@inline
def load_height(s, c):
    """Return 1 + cos θ with all digits, also near θ = π."""
    return s * s / (1.0 - c) if c < 0.0 else 1.0 + c


@inline
def inertia_at_height(body, height):
    """Return D = 1 + κ + ε² + 2 ε cos θ, the moment of inertia about the contact point, from 1 + cos θ."""
    gap = 1.0 - body.eps
    return (body.kap + gap * gap) + 2.0 * body.eps * height


@inline
def rolling_inertia(body, c):
    """Return D from cos θ; near θ = π it is only as accurate as cos θ (see `inertia_at_height`)."""
    return inertia_at_height(body, 1.0 + c)


@inline
def resisted_inertia(body, s, c, rho):
    """Return D − ρ ε sin θ, the effective moment of inertia in rolling with resistance."""
    return inertia_at_height(body, load_height(s, c)) - rho * body.eps * s


@inline
def rolling_acceleration(body, s, c, u, rho):
    """Return θ̈ in rolling."""
    arm, lever = contact_arms(body, s, c)
    torque = lever * (u + body.gn) + body.gt * arm - rho * (body.gn - body.eps * c * u)
    return torque / resisted_inertia(body, s, c, rho)


@inline
def rolling_forces(body, s, c, u, rho):
    """Return (F, N) in rolling, without division by κ."""
    alpha = rolling_acceleration(body, s, c, u, rho)
    arm, lever = contact_arms(body, s, c)
    return alpha * arm - lever * u - body.gt, body.gn - lever * alpha - body.eps * c * u


@inline
def cone_weights(mu):
    """Return (a, b) with a N ≥ b abs(F) inside the friction cone; (1, 0) if μ is infinite."""
    if math.isinf(mu):
        return 1.0, 0.0
    norm = math.sqrt(1.0 + mu * mu)
    return mu / norm, 1.0 / norm


@inline
def slip_load(body, c, u, stiffness):
    """Return N/κ = −f_n/(κ p_σ) in slip."""
    return (body.gn - body.eps * c * u) / stiffness


@inline
def slip_motion(body, s, c, u, sigma, rho):
    """Return (θ̈, N, v̇_t) in slip of direction σ."""
    arm, lever = contact_arms(body, s, c)
    q = lever + sigma * body.mu_k * arm - rho
    load = slip_load(body, c, u, body.kap + lever * q)
    friction_part = sigma * body.mu_k * body.kap + arm * q
    return q * load, body.kap * load, body.gt + lever * u - load * friction_part
