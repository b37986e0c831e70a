"""Parameters of a compliant contact: units, defaults, and a start with a loaded spring."""

from __future__ import annotations

import math

from hophoop.kernel.compliant.records import OM, TH, VN, VT, Y, Z
from hophoop.kernel.numerics.circular import sine, sine_and_cosine
from hophoop.kernel.physics.compliant import (
    BRISTLE,
    KELVIN_VOIGT,
    LINEAR,
    STIFFNESS,
    TANH,
    Compliance,
    damping_ratio,
    hunt_crossley_number,
    static_excess,
)
from hophoop.kernel.physics.contact import free_acceleration, rolling_forces, slip_motion, slip_stiffness
from hophoop.kernel.physics.resistance import resistance_arm

SLIP_SPEED, LEAST_SLIP_SPEED = 1e-3, 1e-9  # in √(g R)
RTOL = 1e-9
ROUNDING = 1e-13  # of f_n, relative to gravity and θ̇²


def least_restitution(k):
    """Return the minimum restitution of a compliant contact; smaller ones, which no finite damping gives, are raised to it.

    `k` is the stiffness over m g / R. The minimum is 1/√k, at most 0.1, so it vanishes as k → ∞ like the other errors of a
    compliant contact.
    """
    return min(0.1, 1.0 / math.sqrt(k))


def compliance_of(body, length, second, mass, law, friction, stiffness, damping, restitution, slip_speed, tangential):
    """Return the parameters of a contact in kernel units from those in SI units; nan selects the default."""
    k = STIFFNESS if math.isnan(stiffness) else stiffness * (second * second) / mass
    c = 0.0
    d = 0.0
    if not math.isnan(damping):
        if law == KELVIN_VOIGT:
            c = damping * second / mass
        else:
            d = damping * length / second
    else:
        rebound = max(body.rest if math.isnan(restitution) else restitution, least_restitution(k))
        if law == KELVIN_VOIGT:
            c = 2.0 * damping_ratio(rebound) * math.sqrt(k)
        else:
            d = hunt_crossley_number(rebound)
    usual = min(max(1.0 / k, LEAST_SLIP_SPEED), SLIP_SPEED)
    v_s = usual
    if not math.isnan(slip_speed):
        v_s = slip_speed * second / length
    elif friction == BRISTLE:  # it may relax as slowly as the hoop moves: c_t = μ k_t
        v_s = min(1.0 / k, 1.0)
    if body.mu_s == 0.0:  # no friction for a bristle to transmit
        friction = LINEAR
    k_t = k if math.isnan(tangential) else tangential * (second * second) / mass
    excess = static_excess(body.mu_s, body.mu_k) if friction == TANH else 0.0
    om_s = usual if friction == BRISTLE else v_s
    return Compliance(law, friction, k, c, d, v_s, body.mu_s, body.mu_k, excess, k_t, body.mu_s / v_s, om_s)


def chosen_in_si(comp, length, second, mass):
    """Return the stiffness [N/m] and the slip speed [m/s] of a contact in kernel units."""
    return comp.k * mass / (second * second), comp.v_s * length / second


def load_contact(body, comp, start):
    """Load the spring of a start, in place; return True if the contact acts.

    At a start at rest on the plane (height 0, vy 0) the spring is compressed by the normal force of rigid contact, and the
    bristle is stretched likewise. Otherwise every motion would start with a drop.
    """
    if start[Y] > 0.0 or start[VN] != 0.0:
        return False
    friction, normal = rigid_force(body, start)
    s, c = sine_and_cosine(start[TH])
    opening = free_acceleration(body, s, c, start[OM] * start[OM])[1]
    if not normal > 0.0:
        u = start[OM] * start[OM]
        if abs(opening) <= ROUNDING * (body.gn + u):  # zero within rounding: its rate decides
            opening = -body.eps * start[OM] * u * sine(start[TH])
        return opening < 0.0
    start[Y] = -normal / comp.k
    if start[VT] == 0.0 and comp.friction == BRISTLE:
        start[Z] = -friction / comp.k_t
    return True


def rigid_force(body, start):
    """Return (F, N) of rigid contact in a state without approach."""
    s, c = sine_and_cosine(start[TH])
    u = start[OM] * start[OM]
    sigma = direction(start[VT])
    if sigma == 0:
        friction, normal = rolling_forces(body, s, c, u, resistance_arm(body, s, c, start[OM], 0))
        if normal > 0.0 and abs(friction) <= body.mu_s * normal:
            return friction, normal
        sigma = -direction(friction)
    opening = free_acceleration(body, s, c, u)[1]
    rho = resistance_arm(body, s, c, start[OM], sigma)
    stiffness = slip_stiffness(body, s, c, sigma, rho)
    if opening < 0.0 < stiffness:
        normal = slip_motion(body, s, c, u, sigma, rho)[1]
        return -sigma * body.mu_k * normal, normal
    if opening > 0.0 > stiffness and body.strike:
        # Painlevé's indeterminate contact: from twice the compression of the unstable equilibrium the spring strikes
        return 0.0, 2.0 * slip_motion(body, s, c, u, sigma, rho)[1]
    return 0.0, 0.0


def direction(value):
    """Return the sign of a number, −1, 0 or 1."""
    return 1 if value > 0.0 else (-1 if value < 0.0 else 0)
