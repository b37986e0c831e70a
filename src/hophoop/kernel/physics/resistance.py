"""Rolling resistance: a couple −f R N sign θ̇ while in contact (docs/model.md#rolling-resistance).

ρ is the couple over R N, counted against the rotation: f sign θ̇ while the hoop turns. One that does not turn is held by
the couple that it needs, up to f. With ρ the arm of the normal force about G is ε sin θ − ρ in the balance of moments,
and ε sin θ as before in the motion of the rim. At f = 0 all is as in `contact`.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.physics.contact import (
    contact_arms,
    inertia_at_height,
    load_height,
    rolling_acceleration,
    rolling_forces,
    slip_motion,
    slip_stiffness,
    slip_torque_arm,
)


@inline
def held(need, most):
    """The part of what is needed that a couple of at most `most` gives."""
    return min(max(need, -most), most)


@inline
def torque_at_rest(body, s, c):
    """ε sin θ g_n + (1 + ε cos θ) g_t: the torque about the contact point of a rolling hoop that does not turn."""
    arm, lever = contact_arms(body, s, c)
    return lever * body.gn + arm * body.gt


def resistance_arm(body, s, c, om, sigma):
    """ρ in rolling (sigma = 0) or slip; 0 without rolling resistance."""
    if body.resist == 0.0:
        return 0.0
    if om != 0.0:
        return math.copysign(body.resist, om)
    if sigma != 0:
        return held(slip_torque_arm(body, s, c, sigma), body.resist)
    return held(torque_at_rest(body, s, c) / body.gn, body.resist) if body.gn > 0.0 else 0.0


@inline
def resisted_inertia(body, s, c, rho):
    """D − ρ ε sin θ."""
    return inertia_at_height(body, load_height(s, c)) - rho * body.eps * s


@inline
def resisted_acceleration(body, s, c, u, rho):
    """θ̈ in rolling."""
    arm, lever = contact_arms(body, s, c)
    torque = lever * (u + body.gn) + body.gt * arm - rho * (body.gn - body.eps * c * u)
    return torque / resisted_inertia(body, s, c, rho)


@inline
def resisted_forces(body, s, c, u, rho):
    """(F, N) in rolling."""
    alpha = resisted_acceleration(body, s, c, u, rho)
    arm, lever = contact_arms(body, s, c)
    return alpha * arm - lever * u - body.gt, body.gn - lever * alpha - body.eps * c * u


@inline
def resisted_slip(body, s, c, u, sigma, rho):
    """(θ̈, N, v̇_t) in slip of direction σ."""
    arm, lever = contact_arms(body, s, c)
    q = lever + sigma * body.mu_k * arm - rho
    load = (body.gn - body.eps * c * u) / (body.kap + lever * q)
    return q * load, body.kap * load, body.gt + lever * u - load * (sigma * body.mu_k * body.kap + arm * q)


def forces_rolling(body, s, c, om):
    """(F, N) in rolling, with or without rolling resistance."""
    if body.resist == 0.0:
        return rolling_forces(body, s, c, om * om)
    return resisted_forces(body, s, c, om * om, resistance_arm(body, s, c, om, 0))


def motion_slipping(body, s, c, om, sigma):
    """(θ̈, N, v̇_t) in slip of direction σ, with or without rolling resistance."""
    if body.resist == 0.0:
        return slip_motion(body, s, c, om * om, sigma)
    return resisted_slip(body, s, c, om * om, sigma, resistance_arm(body, s, c, om, sigma))


def stiffness_slipping(body, s, c, om, sigma):
    """κ p_σ in slip of direction σ, with or without rolling resistance."""
    stiffness = slip_stiffness(body, s, c, sigma)
    if body.resist == 0.0:
        return stiffness
    return stiffness - body.eps * s * resistance_arm(body, s, c, om, sigma)


def acceleration_in_contact(body, s, c, om, sigma):
    """θ̈ in rolling (sigma = 0) or slip, with or without rolling resistance."""
    if sigma != 0:
        return motion_slipping(body, s, c, om, sigma)[0]
    if body.resist == 0.0:
        return rolling_acceleration(body, s, c, om * om)
    return resisted_acceleration(body, s, c, om * om, resistance_arm(body, s, c, om, 0))


def most_resistance(eps: float, kap: float) -> float:
    """The rolling resistance from which on D − ρ ε sin θ is zero at some angle; none is allowed where κ = 0.

    D − ρ ε sin θ = 1 + κ + ε² + ε (2 cos θ − ρ sin θ) is smallest as 1 + κ + ε² − ε √(4 + f²). Its square root of a
    difference is written as a product: (1 + κ + ε²)² − 4 ε² = ((1 − ε)² + κ) ((1 + ε)² + κ).
    """
    if eps == 0.0:
        return math.inf
    return math.sqrt(((1.0 - eps) * (1.0 - eps) + kap) * ((1.0 + eps) * (1.0 + eps) + kap)) / eps
