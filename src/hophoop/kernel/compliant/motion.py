"""Equation of motion in compliant contact, and its Jacobian (docs/model.md#contact-space)."""

from __future__ import annotations

from hophoop.kernel.compliant.records import DAMPING, DYNAMIC, FRICTION, OM, RESISTED, TH, VN, VT, X, Y, Z
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.physics.compliant import (
    BRISTLE,
    bristle_rate,
    friction_force,
    normal_force,
    resisting_couple,
    spring_energy,
)
from hophoop.kernel.physics.contact import delassus, free_acceleration
from hophoop.kernel.physics.energy import kinetic_energy, potential_energy


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
    out[begin + RESISTED - DYNAMIC] = 0.0
    if body.resist > 0.0:
        out[begin + RESISTED - DYNAMIC] = -resisting_couple(comp, body.resist, normal, u[OM])[0] * u[OM]


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
