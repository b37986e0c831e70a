"""The condition of an event, and when the changed motion meets it: dt = −dg/ġ of the quantity g that comes to zero."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import EPS, GN, KAP, MU_K, MU_S, OM, RESIST, ROLLING_LOSS, TH, VT, Reason, T
from hophoop.derivatives.pieces.flight_and_rest import resisted_motion, step_along
from hophoop.derivatives.pieces.forces import by_angle, change_of, rolling_slopes
from hophoop.derivatives.pieces.panels import momentum_change
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.physics.contact import (
    free_acceleration,
    kappa_p_sigma,
    kappa_p_sigma_slope,
    resistance_arm,
    rolling_forces,
    slip_torque_arm,
    torque_at_rest,
)

GRAZE, NONE, BORDER, SIDED = int(Reason.GRAZE), int(Reason.NONE), int(Reason.BORDER), -1
FLAT = 1e-9  # relative to its natural size: a smaller rate belongs to a quantity that only touches zero


def fail(tangents, reasons, k, reason):
    """There is no derivative in a direction from here on; the first reason is kept."""
    for row in range(tangents.shape[0]):
        tangents[row, k] = math.nan
    if reasons[k] <= 0:
        reasons[k] = reason


def fail_all(tangents, reasons, reason):
    """There is no derivative in any direction from here on."""
    for k in range(tangents.shape[1]):
        fail(tangents, reasons, k, reason)


@noinline
def meet_cone(body, state, rates, side, parameter_tangents, tangents, reasons):
    """Rolling that comes to the friction cone, at side · F > 0: g = μs N − side · F, or N without a bound on F."""
    s, c = sine_cosine(state.th, state.th_low)
    rho = resistance_arm(body, s, c, state.om, 0)
    _, normal, alpha, of_friction, of_normal = rolling_slopes(body, s, c, state.om, rho)
    bound = not math.isinf(body.mu_s)
    weight = body.mu_s if bound else 1.0
    share = side if bound else 0.0
    scale = (body.gn + abs(body.gt) + state.om * state.om) * (1.0 + weight) * (abs(state.om) + 1e-300)
    rate = state.om * (weight * by_angle(of_normal, alpha) - share * by_angle(of_friction, alpha))
    for k in range(tangents.shape[1]):
        dnormal = change_of(of_normal, state.om, tangents, parameter_tangents, k)
        dg = weight * dnormal - share * change_of(of_friction, state.om, tangents, parameter_tangents, k)
        if bound:
            dg += parameter_tangents[MU_S, k] * normal
        if abs(rate) <= FLAT * scale:
            fail(tangents, reasons, k, GRAZE)
        else:
            step_along(tangents, k, -dg / rate, state, rates)


@noinline
def meet_opening(body, state, rates, parameter_tangents, tangents, reasons):
    """Slip that lifts off: g = g_n − ε cos θ θ̇² comes to zero."""
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    rate = body.eps * (s * state.om * u - 2.0 * c * state.om * rates[0])
    for k in range(tangents.shape[1]):
        dg = parameter_tangents[GN, k] - parameter_tangents[EPS, k] * c * u
        dg += body.eps * (s * u * tangents[TH, k] - 2.0 * c * state.om * tangents[OM, k])
        if abs(rate) <= FLAT * (body.gn + u) * abs(state.om):
            fail(tangents, reasons, k, GRAZE)
        else:
            step_along(tangents, k, -dg / rate, state, rates)


@noinline
def meet_row(row, rate, scale, state, rates, tangents, reasons):
    """A component of the state that comes to zero: the slip at its end, v_n at the apex, the gap at the landing."""
    for k in range(tangents.shape[1]):
        if abs(rate) <= FLAT * scale:
            fail(tangents, reasons, k, GRAZE)
        else:
            step_along(tangents, k, -tangents[row, k] / rate, state, rates)
            tangents[row, k] = 0.0


@noinline
def meet_time(parameter_tangents, row, state, rates, tangents):
    """The end of time, which itself may change."""
    for k in range(tangents.shape[1]):
        step_along(tangents, k, parameter_tangents[row, k] - tangents[T, k], state, rates)


def jam_angle_change(body, sigma, s, c, om, parameter_tangents, k):
    """Change of the angle at which p_σ = 0."""
    signed_mu = sigma * body.mu_k
    q = slip_torque_arm(body, s, c, sigma) - resistance_arm(body, s, c, om, sigma)
    slope = kappa_p_sigma_slope(body, s, c, sigma, q)
    q_more = parameter_tangents[EPS, k] * (s + signed_mu * c) + sigma * parameter_tangents[MU_K, k] * (1.0 + body.eps * c)
    q_more -= math.copysign(parameter_tangents[RESIST, k], om)
    return -(parameter_tangents[KAP, k] + parameter_tangents[EPS, k] * s * q + body.eps * s * q_more) / slope


@noinline
def go_with_jam(body, sigma, begin, jam, parameter_tangents, tangents):
    """Express each change at the moment at which it is as far from the jam as the motion itself.

    So the panels move along with the angle of the jam, near which θ̇² is a power of the distance from it.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    rates = resisted_motion(body, sigma, begin, 0.0)
    for k in range(tangents.shape[1]):
        dth = jam_angle_change(body, sigma, s, c, jam.om, parameter_tangents, k)
        step_along(tangents, k, (dth - tangents[TH, k]) / begin.om, begin, rates)
        tangents[TH, k] = dth


@noinline
def meet_jam(body, sigma, jam, before, parameter_tangents, tangents):
    """The dynamic jam: p_σ = 0 says where, f_n = 0 how fast; `before` is the state that comes near.

    What gravity alone changes, the momentum v_t + θ̇ (1 + ε c − σ μ ε s), does not see the force without bound. Nor does
    the momentum away from the plane, −ε s θ̇, which gives the last impulse P_n, and with it the loss ½ ρ (θ̇ + θ̇_jam) P_n.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    rho = resistance_arm(body, s, c, jam.om, sigma)
    faster = jam.om * jam.om - before.om * before.om
    for k in range(tangents.shape[1]):
        deps = parameter_tangents[EPS, k]
        dmu = parameter_tangents[MU_K, k]
        dth = jam_angle_change(body, sigma, s, c, jam.om, parameter_tangents, k)
        momentum = momentum_change(
            body, sigma, s, c, before.om, (tangents[VT, k], tangents[OM, k], tangents[TH, k]), (deps, dmu)
        )
        dom = tangents[OM, k]
        # θ̇² = g_n/(ε cos θ)
        tangents[OM, k] = 0.5 * jam.om * (parameter_tangents[GN, k] / body.gn - deps / body.eps + s / c * dth)
        dfaster = 2.0 * (jam.om * tangents[OM, k] - before.om * dom)
        dlever = deps * s + body.eps * c * dth
        drho = math.copysign(parameter_tangents[RESIST, k], jam.om)
        tangents[ROLLING_LOSS, k] -= 0.5 * (body.eps * s * (rho * dfaster + drho * faster) + rho * dlever * faster)
        tangents[VT, k] = momentum - momentum_change(body, sigma, s, c, jam.om, (0.0, tangents[OM, k], dth), (deps, dmu))
        tangents[TH, k] = dth


@noinline
def is_on_border(body, state):
    """Return True if the mode after a state in contact is decided by a quantity that is zero to rounding."""
    if body.kap == 0.0 or body.mu_s == 0.0:
        return False
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    scale = FLAT * (body.gn + abs(body.gt) + u)
    if scale == 0.0:
        return False
    opening = abs(free_acceleration(body, s, c, u)[1])
    at_rest = state.om == 0.0 and body.resist > 0.0  # where the couple holds the hoop, or just does not
    if state.vt != 0.0:
        if math.isinf(body.mu_k):
            return False
        sigma = 1 if state.vt > 0.0 else -1
        if at_rest and abs(abs(slip_torque_arm(body, s, c, sigma)) - body.resist) <= FLAT:
            return True
        stiffness = kappa_p_sigma(body, s, c, sigma, resistance_arm(body, s, c, state.om, sigma))
        return opening <= scale or abs(stiffness) <= FLAT
    if at_rest and abs(abs(torque_at_rest(body, s, c)) - body.resist * body.gn) <= scale:
        return True
    friction, normal = rolling_forces(body, s, c, state.om * state.om, resistance_arm(body, s, c, state.om, 0))
    if math.isinf(body.mu_s):
        return abs(normal) <= scale
    margin = body.mu_s * normal - abs(friction)
    return abs(margin) <= scale * (1.0 + body.mu_s) or abs(normal) <= scale or (margin < 0.0 and opening <= scale)


@noinline
def part_at_rest(body, sigma, state, tangents, reasons):
    """A hoop that does not turn, and is about to: a little rotation has to do with another couple if it goes the other way."""
    if body.resist == 0.0 or state.om != 0.0:
        return
    s, c = sine_cosine(state.th, state.th_low)
    turning = resisted_motion(body, sigma, state, 0.0)[0]
    way = math.copysign(1.0, turning)
    rho = -way * body.resist
    if sigma == 0:
        friction, normal = rolling_forces(body, s, c, 0.0, rho)
        keeps_mode = normal > 0.0 and (math.isinf(body.mu_s) or abs(friction) < body.mu_s * normal)
    else:
        keeps_mode = body.kap + body.eps * s * (slip_torque_arm(body, s, c, sigma) - rho) > 0.0
    for k in range(tangents.shape[1]):
        given = tangents[OM, k]
        if given == 0.0 or math.isnan(given) or abs(turning) <= FLAT * body.gn:
            continue
        if given * way < 0.0 and not keeps_mode:
            fail(tangents, reasons, k, BORDER)
        elif reasons[k] == NONE:
            reasons[k] = SIDED
