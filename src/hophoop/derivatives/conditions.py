"""What sets off an event, and when the changed motion meets it: dt = −dg/ġ of the quantity g that comes to zero."""

from __future__ import annotations

import math

from hophoop._jit import apart_jit, lean_jit
from hophoop.derivatives.layout import EPS, GN, GT, KAP, MU_K, MU_S, OM, TH, VT, Reason, T
from hophoop.derivatives.moving import step_along
from hophoop.derivatives.panels import momentum_change
from hophoop.numerics.trigonometry import sine_cosine
from hophoop.physics.contact import (
    free_acceleration,
    inertia_at_height,
    load_height,
    rolling_forces,
    slip_motion,
    slip_stiffness,
    slip_torque_arm,
)
from hophoop.physics.painleve import stiffness_slope

GRAZE, NONE, BORDER, SIDED = int(Reason.GRAZE), int(Reason.NONE), int(Reason.BORDER), -1
FLAT = 1e-9  # beside its natural size: a smaller rate is that of a quantity that only touches zero


@lean_jit
def fail(z, reasons, k, reason):
    """There is no derivative in a direction from here on; the first reason is kept."""
    for row in range(z.shape[0]):
        z[row, k] = math.nan
    if reasons[k] <= 0:
        reasons[k] = reason


@lean_jit
def fail_all(z, reasons, reason):
    """There is no derivative in any direction from here on."""
    for k in range(z.shape[1]):
        fail(z, reasons, k, reason)


@apart_jit
def meet_cone(body, state, rates, side, changes, z, reasons):
    """Rolling that comes to the friction cone, at side · F > 0: g = μs N − side · F, or N without a bound on F."""
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    eps = body.eps
    arm = 1.0 + eps * c
    inertia = inertia_at_height(body, load_height(s, c))
    alpha = rates[0]
    a_th = (eps * c * (u + body.gn) - body.gt * eps * s + 2.0 * alpha * eps * s) / inertia
    a_u = eps * s / inertia
    a_eps = (s * (u + body.gn) + body.gt * c - 2.0 * alpha * (eps + c)) / inertia
    a_kap = -alpha / inertia
    a_gt = arm / inertia
    bound = not math.isinf(body.mu_s)
    weight = body.mu_s if bound else 1.0
    normal = rolling_forces(body, s, c, u)[1]
    scale = (body.gn + abs(body.gt) + u) * (1.0 + weight) * (abs(state.om) + 1e-300)
    for k in range(z.shape[1]):
        dth = z[TH, k]
        deps = changes[EPS, k]
        du = 2.0 * state.om * z[OM, k]
        dalpha = a_th * dth + a_u * (du + changes[GN, k]) + a_eps * deps + a_kap * changes[KAP, k] + a_gt * changes[GT, k]
        dfriction = dalpha * arm + alpha * (deps * c - eps * s * dth) - deps * s * u - eps * (c * dth * u + s * du)
        dfriction -= changes[GT, k]
        dnormal = changes[GN, k] - deps * (s * alpha + c * u) - eps * (c * dth * alpha + s * dalpha - s * dth * u + c * du)
        dg = weight * dnormal - (side * dfriction if bound else 0.0)
        if bound:
            dg += changes[MU_S, k] * normal
        drate_u = 2.0 * state.om * alpha
        rise = a_th * state.om + a_u * drate_u
        friction_rate = rise * arm - alpha * eps * s * state.om - eps * (c * state.om * u + s * drate_u)
        normal_rate = -eps * (c * state.om * alpha + s * rise - s * state.om * u + c * drate_u)
        rate = weight * normal_rate - (side * friction_rate if bound else 0.0)
        if abs(rate) <= FLAT * scale:
            fail(z, reasons, k, GRAZE)
        else:
            step_along(z, k, -dg / rate, state, rates)


@apart_jit
def meet_opening(body, state, rates, changes, z, reasons):
    """Slip that lifts off: g = g_n − ε cos θ θ̇² comes to zero."""
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    rate = body.eps * (s * state.om * u - 2.0 * c * state.om * rates[0])
    for k in range(z.shape[1]):
        dg = changes[GN, k] - changes[EPS, k] * c * u
        dg += body.eps * (s * u * z[TH, k] - 2.0 * c * state.om * z[OM, k])
        if abs(rate) <= FLAT * (body.gn + u) * abs(state.om):
            fail(z, reasons, k, GRAZE)
        else:
            step_along(z, k, -dg / rate, state, rates)


@apart_jit
def meet_row(row, rate, scale, state, rates, z, reasons):
    """A component of the state that comes to zero: the slip at its end, v_n at the apex, the gap at the landing."""
    for k in range(z.shape[1]):
        if abs(rate) <= FLAT * scale:
            fail(z, reasons, k, GRAZE)
        else:
            step_along(z, k, -z[row, k] / rate, state, rates)
            z[row, k] = 0.0


@apart_jit
def meet_time(changes, row, state, rates, z):
    """The end of time, which itself may change."""
    for k in range(z.shape[1]):
        step_along(z, k, changes[row, k] - z[T, k], state, rates)


@lean_jit
def jam_angle_change(body, sigma, s, c, changes, k):
    """Change of the angle at which p_σ = 0."""
    signed_mu = sigma * body.mu_k
    q = slip_torque_arm(body, s, c, sigma)
    slope = stiffness_slope(body, s, c, sigma, q)
    q_more = changes[EPS, k] * (s + signed_mu * c) + sigma * changes[MU_K, k] * (1.0 + body.eps * c)
    return -(changes[KAP, k] + changes[EPS, k] * s * q + body.eps * s * q_more) / slope


@apart_jit
def go_with_jam(body, sigma, begin, jam, changes, z):
    """Tell each change of the moment at which it is as far from the jam as the motion itself.

    So the panels move along with the angle of the jam, beside which θ̇² is a power of the distance from it.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    turning, _, along = slip_motion(body, s0, c0, begin.om * begin.om, sigma)
    for k in range(z.shape[1]):
        dth = jam_angle_change(body, sigma, s, c, changes, k)
        step_along(z, k, (dth - z[TH, k]) / begin.om, begin, (turning, along, 0.0))
        z[TH, k] = dth


@apart_jit
def meet_jam(body, sigma, jam, before, changes, z):
    """The dynamic jam: p_σ = 0 says where, f_n = 0 how fast; `before` is the state that comes near.

    What gravity alone changes, the momentum v_t + θ̇ (1 + ε c − σ μ ε s), does not see the force without bound.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    for k in range(z.shape[1]):
        deps = changes[EPS, k]
        dmu = changes[MU_K, k]
        dth = jam_angle_change(body, sigma, s, c, changes, k)
        momentum = momentum_change(body, sigma, s, c, before.om, z[VT, k], z[OM, k], z[TH, k], deps, dmu)
        # θ̇² = g_n/(ε cos θ)
        z[OM, k] = 0.5 * jam.om * (changes[GN, k] / body.gn - deps / body.eps + s / c * dth)
        z[VT, k] = momentum - momentum_change(body, sigma, s, c, jam.om, 0.0, z[OM, k], dth, deps, dmu)
        z[TH, k] = dth


@apart_jit
def is_on_border(body, state):
    """Whether the mode after a state in contact is decided by a quantity that is zero but for rounding."""
    if body.kap == 0.0 or body.mu_s == 0.0:
        return False
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    scale = FLAT * (body.gn + abs(body.gt) + u)
    if scale == 0.0:
        return False
    opening = abs(free_acceleration(body, s, c, u)[1])
    if state.vt != 0.0:
        if math.isinf(body.mu_k):
            return False
        stiffness = slip_stiffness(body, s, c, 1.0 if state.vt > 0.0 else -1.0)
        return opening <= scale or abs(stiffness) <= FLAT
    friction, normal = rolling_forces(body, s, c, u)
    if math.isinf(body.mu_s):
        return abs(normal) <= scale
    margin = body.mu_s * normal - abs(friction)
    return abs(margin) <= scale * (1.0 + body.mu_s) or abs(normal) <= scale or (margin < 0.0 and opening <= scale)


@apart_jit
def lose_slip(body, state, mode_sigma, changes, z, reasons):
    """A slip that is no more than the change of a start without slip: friction ends it at once, or it goes on.

    What it does before it ends depends on its direction, so that such a change holds for one side only.
    """
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    for k in range(z.shape[1]):
        given = z[VT, k]
        sigma = 1 if given > 0.0 else -1
        if given == 0.0 or math.isnan(given) or (body.mu_k == 0.0 and mode_sigma != 0):
            continue
        if sigma == mode_sigma:
            if reasons[k] == NONE:
                reasons[k] = SIDED
            continue
        if body.kap == 0.0 or math.isinf(body.mu_k):
            fail(z, reasons, k, BORDER)
            continue
        turning, normal, along = slip_motion(body, s, c, u, sigma)
        if not (normal > 0.0 and sigma * along < 0.0 and slip_stiffness(body, s, c, sigma) > 0.0):
            fail(z, reasons, k, BORDER)
            continue
        step_along(z, k, -given / along, state, (turning, along, 0.0))
        z[VT, k] = 0.0
        if reasons[k] == NONE:
            reasons[k] = SIDED
