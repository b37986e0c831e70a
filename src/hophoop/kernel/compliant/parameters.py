"""The numbers of a contact: units, defaults, a start with the spring loaded."""

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

SLIP_SPEED, LEAST_SLIP_SPEED = 1e-3, 1e-9  # √(g R)
RTOL = 1e-9
ROUNDING = 1e-13  # of f_n, beside gravity and θ̇²


def least_restitution(k):
    """The restitution that stands for all smaller ones, which no finite damping gives.

    `k` is the stiffness over m g / R. It is 1/√k, at most 0.1: it vanishes with the other errors of a compliant contact.
    """
    return min(0.1, 1.0 / math.sqrt(k))


def compliance_of(body, length, second, mass, law, friction, stiffness, damping, restitution, slip_speed, tangential):
    """The contact's numbers in the kernel's units from those in SI units; nan stands for what it chooses by itself."""
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
    if body.mu_s == 0.0:  # nothing for a bristle to hold
        friction = LINEAR
    k_t = k if math.isnan(tangential) else tangential * (second * second) / mass
    excess = static_excess(body.mu_s, body.mu_k) if friction == TANH else 0.0
    om_s = usual if friction == BRISTLE else v_s
    return Compliance(law, friction, k, c, d, v_s, body.mu_s, body.mu_k, excess, k_t, body.mu_s / v_s, om_s)


def chosen_in_si(comp, length, second, mass):
    """The stiffness [N/m] and the slip speed [m/s] of a contact in kernel units."""
    return comp.k * mass / (second * second), comp.v_s * length / second


def load_contact(body, comp, start):
    """Whether the contact acts at a start, which is changed in place to have its spring loaded.

    A start at rest on the plane (height 0, vy 0) has its spring compressed by the normal force that rigid
    contact would have, and its bristle stretched: otherwise every motion would begin with a drop.
    """
    if start[Y] > 0.0 or start[VN] != 0.0:
        return False
    friction, normal = rigid_force(body, start)
    s, c = sine_and_cosine(start[TH])
    opening = free_acceleration(body, s, c, start[OM] * start[OM])[1]
    if not normal > 0.0:
        u = start[OM] * start[OM]
        if abs(opening) <= ROUNDING * (body.gn + u):  # zero: its rate decides
            opening = -body.eps * start[OM] * u * sine(start[TH])
        return opening < 0.0
    start[Y] = -normal / comp.k
    if start[VT] == 0.0 and comp.friction == BRISTLE:
        start[Z] = -friction / comp.k_t
    return True


def rigid_force(body, start):
    """(F, N) that rigid contact would have in a state without approach."""
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
        # Painlevé's indeterminate contact: beyond twice the unstable equilibrium the spring strikes
        return 0.0, 2.0 * slip_motion(body, s, c, u, sigma, rho)[1]
    return 0.0, 0.0


def direction(value):
    """Its sign, −1, 0 or 1."""
    return 1 if value > 0.0 else (-1 if value < 0.0 else 0)
