"""Contact: W, f, p_σ and the forces in roll and slip (docs/model.md#contact-space), rolling resistance
(docs/model.md#rolling-resistance), Painlevé's paradox (docs/model.md#painlevés-paradox) and the friction utilization.

ρ is the couple of the rolling resistance over R N, positive against a positive rotation: f sign θ̇ while the hoop rotates.
Without rotation the couple balances the torque, up to abs(ρ) = f. With ρ the arm of the normal force about G is ε sin θ − ρ in
the balance of moments, and ε sin θ in the motion of the rim.
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
def kappa_p_sigma(body, s, c, sigma, rho):
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


def force_ratio(body, s, c, u, rho):
    """Return F/N in rolling, infinite if N ≤ 0; 0 without a force."""
    friction, normal = rolling_forces(body, s, c, u, rho)
    if normal > 0.0:
        return friction / normal
    return math.copysign(math.inf, friction) if friction != 0.0 else 0.0


def required_ratio(body, s, c, u, rho):
    """Return F/N that rolling requires: of the massless hoop tan(θ/2), since the force points at the load also where it is 0.

    Where cos θ = −1 its load lies on the plane, at rest.
    """
    if body.kap == 0.0:
        return s / (1.0 + c) if c > -1.0 else 0.0
    return force_ratio(body, s, c, u, rho)


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


# --- rolling resistance


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


def kappa_p_sigma_slope(body, s, c, sigma, q):
    """Return dκp_σ/dθ."""
    return body.eps * c * q + body.eps * s * body.eps * (c - sigma * body.mu_k * s)


@inline
def slip_coefficients(body, s, c, sigma, rho):
    """Return (q, κ p_σ) in slip of direction σ with the rolling resistance ρ."""
    arm = slip_torque_arm(body, s, c, sigma) - rho
    return arm, body.kap + body.eps * s * arm


# --- friction utilization: the fraction of the available friction that acts (docs/model.md#modes)


def utilization(slips, friction, normal, mu_s, mu_k):
    """Return abs(F)/(μ N) with the μ of the phase: μk in slip, else μs.

    In slip N divides out of Coulomb's law, so the utilization is 1 also at the instant of lift-off. It is nan in slip without
    friction, and without slip if N = 0.
    """
    limit = (mu_k if slips else mu_s) * normal
    if limit > 0.0:
        return abs(friction) / limit
    if slips:
        return 1.0 if mu_k > 0.0 else math.nan
    if not normal > 0.0:
        return math.nan
    return 0.0 if friction == 0.0 else math.inf


def utilizations(slips, friction, normal, mu_s, mu_k, out):
    """Fill `out` with the `utilization` of many cases; all arguments are arrays of one length."""
    for i in range(out.shape[0]):
        out[i] = utilization(slips[i], friction[i], normal[i], mu_s[i], mu_k[i])
