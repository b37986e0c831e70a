"""Rolling resistance: a couple −f R N sign θ̇ while in contact (docs/model.md#rolling-resistance).

ρ is the couple over R N, positive against a positive rotation: f sign θ̇ while the hoop rotates. Without rotation the couple
balances the torque, up to abs(ρ) = f. With ρ the arm of the normal force about G is ε sin θ − ρ in the balance of moments, and
ε sin θ in the motion of the rim. The forces with ρ are in `contact`.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.physics.contact import contact_arms, rolling_acceleration, slip_motion, slip_torque_arm


@inline
def clamp(need, most):
    """Return the needed couple, limited to ±`most`."""
    return min(max(need, -most), most)


@inline
def torque_at_rest(body, s, c):
    """Return ε sin θ g_n + (1 + ε cos θ) g_t, the torque about the contact point of a hoop with θ̇ = 0 in rolling contact."""
    arm, lever = contact_arms(body, s, c)
    return lever * body.gn + arm * body.gt


def resistance_arm(body, s, c, om, sigma):
    """Return ρ in rolling (sigma = 0) or slip; 0 without rolling resistance."""
    if body.resist == 0.0:
        return 0.0
    if om != 0.0:
        return math.copysign(body.resist, om)
    if sigma != 0:
        return clamp(slip_torque_arm(body, s, c, sigma), body.resist)
    return clamp(torque_at_rest(body, s, c) / body.gn, body.resist) if body.gn > 0.0 else 0.0


def acceleration_in_contact(body, s, c, om, sigma):
    """Return θ̈ in rolling (sigma = 0) or slip."""
    rho = resistance_arm(body, s, c, om, sigma)
    if sigma != 0:
        return slip_motion(body, s, c, om * om, sigma, rho)[0]
    return rolling_acceleration(body, s, c, om * om, rho)


def most_resistance(eps: float, kap: float) -> float:
    """Return the rolling resistance at which D − ρ ε sin θ first reaches zero at some angle; 0 if κ = 0 with ε = 1.

    The minimum of D − ρ ε sin θ = 1 + κ + ε² + ε (2 cos θ − ρ sin θ) is 1 + κ + ε² − ε √(4 + f²). The difference of squares
    under the root is written as a product: (1 + κ + ε²)² − 4 ε² = ((1 − ε)² + κ) ((1 + ε)² + κ).
    """
    if eps == 0.0:
        return math.inf
    return math.sqrt(((1.0 - eps) * (1.0 - eps) + kap) * ((1.0 + eps) * (1.0 + eps) + kap)) / eps
