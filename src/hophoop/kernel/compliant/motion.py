"""Equation of motion in compliant contact and its Jacobian (docs/model.md#contact-space); parameters and the loaded start."""

from __future__ import annotations

import math

from hophoop.kernel.compliant.records import DAMPING, DYNAMIC, FRICTION, OM, ROLLING_LOSS, TH, VN, VT, X, Y, Z
from hophoop.kernel.numerics.circular import sine, sine_and_cosine
from hophoop.kernel.physics.closed_forms import kinetic_energy, potential_energy
from hophoop.kernel.physics.compliant import (
    BRISTLE,
    KELVIN_VOIGT,
    LINEAR,
    STIFFNESS,
    TANH,
    Compliance,
    bristle_rate,
    damping_ratio,
    friction_force,
    hunt_crossley_number,
    normal_force,
    resisting_couple,
    spring_energy,
    static_excess,
)
from hophoop.kernel.physics.contact import (
    delassus,
    free_acceleration,
    kappa_p_sigma,
    resistance_arm,
    rolling_forces,
    slip_motion,
)


def contact_force(comp, regime, u):
    """Return (F, N) in contact."""
    normal = normal_force(comp, u[Y], u[VN])[0]
    return friction_force(comp, regime, normal, u[Z], u[VT])[0], normal


def rates(body, comp, regime, u, out):
    """Fill `out` with the time derivatives of the dynamic variables."""
    s, c = sine_and_cosine(u[TH])
    friction, normal = contact_force(comp, regime, u)
    W_tt, W_nn, W_tn = delassus(body, s, c)
    f_t, f_n = free_acceleration(body, s, c, u[OM] * u[OM])
    out[Y] = u[VN]
    out[TH] = u[OM]
    out[VT] = W_tt * friction + W_tn * normal + f_t
    out[VN] = W_tn * friction + W_nn * normal + f_n
    out[OM] = (body.eps * s * normal - (1.0 + body.eps * c) * friction) / body.kap
    if body.resist > 0.0:  # a couple acts on the rotation of the hoop, and so on the rim
        turned = resisting_couple(comp, body.resist, normal, u[OM])[0] / body.kap
        out[OM] += turned
        out[VT] -= (1.0 + body.eps * c) * turned
        out[VN] += body.eps * s * turned
    out[Z] = 0.0
    if comp.friction == BRISTLE:
        out[Z] = bristle_rate(comp, regime, normal, u[Z], u[VT])


def dissipation(body, comp, regime, u, out, begin):
    """Fill `out` from `begin` with ẋ and the power lost in friction, in the normal damper and to rolling resistance."""
    friction, normal = contact_force(comp, regime, u)
    out[begin + X - DYNAMIC] = u[VT] + u[OM]
    lost = -friction * u[VT]
    if comp.friction == BRISTLE:  # energy stored in the tangential spring is not lost
        lost -= comp.k_t * u[Z] * bristle_rate(comp, regime, normal, u[Z], u[VT])
    out[begin + FRICTION - DYNAMIC] = lost
    out[begin + DAMPING - DYNAMIC] = -(normal + comp.k * u[Y]) * u[VN]
    out[begin + ROLLING_LOSS - DYNAMIC] = 0.0
    if body.resist > 0.0:
        out[begin + ROLLING_LOSS - DYNAMIC] = -resisting_couple(comp, body.resist, normal, u[OM])[0] * u[OM]


def energies(body, comp, u):
    """Return (kinetic energy plus energy in the springs, potential energy at x = 0)."""
    moving = kinetic_energy(body, u[TH], u[OM], u[VT], u[VN], 0.0)
    return moving + spring_energy(comp, u[Y], u[Z]), potential_energy(body, 0.0, u[Y], u[TH])


def jacobian(body, comp, regime, u, out):
    """Fill `out` with ∂(rates)/∂u."""
    s, c = sine_and_cosine(u[TH])
    eps, kap, om = body.eps, body.kap, u[OM]
    arm = 1.0 + eps * c
    normal, normal_y, normal_vn = normal_force(comp, u[Y], u[VN])
    friction, friction_n, friction_vt, friction_z = friction_force(comp, regime, normal, u[Z], u[VT])
    W_tt, W_nn, W_tn = delassus(body, s, c)
    for i in range(DYNAMIC):
        for j in range(DYNAMIC):
            out[i, j] = 0.0
    out[Y, VN] = 1.0
    out[TH, OM] = 1.0
    # through N (and F, which follows N)
    t_n = W_tt * friction_n + W_tn
    n_n = W_tn * friction_n + W_nn
    o_n = (eps * s - arm * friction_n) / kap
    out[VT, Y] = t_n * normal_y
    out[VT, VN] = t_n * normal_vn
    out[VN, Y] = n_n * normal_y
    out[VN, VN] = n_n * normal_vn
    out[OM, Y] = o_n * normal_y
    out[OM, VN] = o_n * normal_vn
    # through F
    out[VT, VT] = W_tt * friction_vt
    out[VN, VT] = W_tn * friction_vt
    out[OM, VT] = -arm * friction_vt / kap
    out[VT, Z] = W_tt * friction_z
    out[VN, Z] = W_tn * friction_z
    out[OM, Z] = -arm * friction_z / kap
    # through θ and θ̇
    W_tn_th = -eps * (c + eps * (c * c - s * s)) / kap
    out[VT, TH] = -2.0 * eps * s * arm / kap * friction + W_tn_th * normal + eps * c * om * om
    out[VN, TH] = W_tn_th * friction + 2.0 * eps * eps * s * c / kap * normal - eps * s * om * om
    out[OM, TH] = eps * (c * normal + s * friction) / kap
    out[VT, OM] = 2.0 * eps * s * om
    out[VN, OM] = 2.0 * eps * c * om
    if body.resist > 0.0:
        couple, couple_n, couple_om = resisting_couple(comp, body.resist, normal, u[OM])
        for row, share in ((OM, 1.0 / kap), (VT, -arm / kap), (VN, eps * s / kap)):
            out[row, Y] += share * couple_n * normal_y
            out[row, VN] += share * couple_n * normal_vn
            out[row, OM] += share * couple_om
        out[VT, TH] += eps * s * couple / kap
        out[VN, TH] += eps * c * couple / kap
    if comp.friction == BRISTLE:
        if regime == 0:
            out[Z, VT] = 1.0
        else:
            share = regime * comp.mu_k / comp.c_t
            out[Z, Y] = share * normal_y
            out[Z, VN] = share * normal_vn
            out[Z, Z] = -comp.k_t / comp.c_t


# --- parameters: units, defaults, and a start with a loaded spring

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
    v_s = min(max(1.0 / k, LEAST_SLIP_SPEED), SLIP_SPEED)
    if not math.isnan(slip_speed):
        v_s = slip_speed * second / length
    elif friction == BRISTLE:  # it may relax as slowly as the hoop moves: c_t = μ k_t
        v_s = min(1.0 / k, 1.0)
    if body.mu_s == 0.0:  # no friction for a bristle to transmit
        friction = LINEAR
    k_t = k if math.isnan(tangential) else tangential * (second * second) / mass
    excess = static_excess(body.mu_s, body.mu_k) if friction == TANH else 0.0
    return Compliance(law, friction, k, c, d, v_s, body.mu_s, body.mu_k, excess, k_t, body.mu_s / v_s)


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
    stiffness = kappa_p_sigma(body, s, c, sigma, rho)
    if opening < 0.0 < stiffness:
        normal = slip_motion(body, s, c, u, sigma, rho)[1]
        return -sigma * body.mu_k * normal, normal
    if opening > 0.0 > stiffness and body.painleve_impact:
        # Painlevé's indeterminate contact: from twice the compression of the unstable equilibrium the spring strikes
        return 0.0, 2.0 * slip_motion(body, s, c, u, sigma, rho)[1]
    return 0.0, 0.0


def direction(value):
    """Return the sign of a number, −1, 0 or 1."""
    return 1 if value > 0.0 else (-1 if value < 0.0 else 0)
