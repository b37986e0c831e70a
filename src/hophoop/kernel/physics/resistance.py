"""Rolling resistance: a couple −f R N sign θ̇ while in contact (docs/model.md#rolling-resistance).

ρ is the couple over R N, counted against the rotation: f sign θ̇ while the hoop turns. One that does not turn is held by
the couple that it needs, up to f. With ρ the arm of the normal force about G is ε sin θ − ρ in the balance of moments,
and ε sin θ in the motion of the rim. The forces with ρ are in `contact`.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.physics.contact import contact_arms, rolling_acceleration, slip_motion, slip_torque_arm


@inline
def clamp(need, most):
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
        return clamp(slip_torque_arm(body, s, c, sigma), body.resist)
    return clamp(torque_at_rest(body, s, c) / body.gn, body.resist) if body.gn > 0.0 else 0.0


def acceleration_in_contact(body, s, c, om, sigma):
    """θ̈ in rolling (sigma = 0) or slip."""
    rho = resistance_arm(body, s, c, om, sigma)
    if sigma != 0:
        return slip_motion(body, s, c, om * om, sigma, rho)[0]
    return rolling_acceleration(body, s, c, om * om, rho)


def most_resistance(eps: float, kap: float) -> float:
    """The rolling resistance from which on D − ρ ε sin θ is zero at some angle; none is allowed where κ = 0.

    D − ρ ε sin θ = 1 + κ + ε² + ε (2 cos θ − ρ sin θ) is smallest as 1 + κ + ε² − ε √(4 + f²). Its square root of a
    difference is written as a product: (1 + κ + ε²)² − 4 ε² = ((1 − ε)² + κ) ((1 + ε)² + κ).
    """
    if eps == 0.0:
        return math.inf
    return math.sqrt(((1.0 - eps) * (1.0 - eps) + kap) * ((1.0 + eps) * (1.0 + eps) + kap)) / eps
