"""What sets off an event, and when the changed motion meets it: dt = −dg/ġ of the quantity g that comes to zero."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import EPS, GN, KAP, MU_K, MU_S, OM, RESIST, RESISTED, TH, VT, Reason, T
from hophoop.derivatives.pieces.flight_and_rest import resisted_motion, step_along
from hophoop.derivatives.pieces.forces import by_angle, changed, rolling_slopes
from hophoop.derivatives.pieces.panels import momentum_change
from hophoop.kernel.native import apart
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.physics.contact import free_acceleration, rolling_forces, slip_motion, slip_stiffness, slip_torque_arm
from hophoop.kernel.physics.painleve import stiffness_slope
from hophoop.kernel.physics.resistance import resistance_arm, torque_at_rest

GRAZE, NONE, BORDER, SIDED = int(Reason.GRAZE), int(Reason.NONE), int(Reason.BORDER), -1
FLAT = 1e-9  # beside its natural size: a smaller rate is that of a quantity that only touches zero


def fail(z, reasons, k, reason):
    """There is no derivative in a direction from here on; the first reason is kept."""
    for row in range(z.shape[0]):
        z[row, k] = math.nan
    if reasons[k] <= 0:
        reasons[k] = reason


def fail_all(z, reasons, reason):
    """There is no derivative in any direction from here on."""
    for k in range(z.shape[1]):
        fail(z, reasons, k, reason)


@apart
def meet_cone(body, state, rates, side, changes, z, reasons):
    """Rolling that comes to the friction cone, at side · F > 0: g = μs N − side · F, or N without a bound on F."""
    s, c = sine_cosine(state.th, state.th_low)
    rho = resistance_arm(body, s, c, state.om, 0)
    _, normal, alpha, of_friction, of_normal = rolling_slopes(body, s, c, state.om, rho)
    bound = not math.isinf(body.mu_s)
    weight = body.mu_s if bound else 1.0
    share = side if bound else 0.0
    scale = (body.gn + abs(body.gt) + state.om * state.om) * (1.0 + weight) * (abs(state.om) + 1e-300)
    rate = state.om * (weight * by_angle(of_normal, alpha) - share * by_angle(of_friction, alpha))
    for k in range(z.shape[1]):
        dg = weight * changed(of_normal, state.om, z, changes, k) - share * changed(of_friction, state.om, z, changes, k)
        if bound:
            dg += changes[MU_S, k] * normal
        if abs(rate) <= FLAT * scale:
            fail(z, reasons, k, GRAZE)
        else:
            step_along(z, k, -dg / rate, state, rates)


@apart
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


@apart
def meet_row(row, rate, scale, state, rates, z, reasons):
    """A component of the state that comes to zero: the slip at its end, v_n at the apex, the gap at the landing."""
    for k in range(z.shape[1]):
        if abs(rate) <= FLAT * scale:
            fail(z, reasons, k, GRAZE)
        else:
            step_along(z, k, -z[row, k] / rate, state, rates)
            z[row, k] = 0.0


@apart
def meet_time(changes, row, state, rates, z):
    """The end of time, which itself may change."""
    for k in range(z.shape[1]):
        step_along(z, k, changes[row, k] - z[T, k], state, rates)


def jam_angle_change(body, sigma, s, c, om, changes, k):
    """Change of the angle at which p_σ = 0."""
    signed_mu = sigma * body.mu_k
    q = slip_torque_arm(body, s, c, sigma) - resistance_arm(body, s, c, om, sigma)
    slope = stiffness_slope(body, s, c, sigma, q)
    q_more = changes[EPS, k] * (s + signed_mu * c) + sigma * changes[MU_K, k] * (1.0 + body.eps * c)
    q_more -= math.copysign(changes[RESIST, k], om)
    return -(changes[KAP, k] + changes[EPS, k] * s * q + body.eps * s * q_more) / slope


@apart
def go_with_jam(body, sigma, begin, jam, changes, z):
    """Tell each change of the moment at which it is as far from the jam as the motion itself.

    So the panels move along with the angle of the jam, beside which θ̇² is a power of the distance from it.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    rates = resisted_motion(body, sigma, begin, 0.0)
    for k in range(z.shape[1]):
        dth = jam_angle_change(body, sigma, s, c, jam.om, changes, k)
        step_along(z, k, (dth - z[TH, k]) / begin.om, begin, rates)
        z[TH, k] = dth


@apart
def meet_jam(body, sigma, jam, before, changes, z):
    """The dynamic jam: p_σ = 0 says where, f_n = 0 how fast; `before` is the state that comes near.

    What gravity alone changes, the momentum v_t + θ̇ (1 + ε c − σ μ ε s), does not see the force without bound. Nor does
    the momentum away from the plane, −ε s θ̇, which tells the last impulse P_n, and with it the loss ½ ρ (θ̇ + θ̇_jam) P_n.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    rho = resistance_arm(body, s, c, jam.om, sigma)
    faster = jam.om * jam.om - before.om * before.om
    for k in range(z.shape[1]):
        deps = changes[EPS, k]
        dmu = changes[MU_K, k]
        dth = jam_angle_change(body, sigma, s, c, jam.om, changes, k)
        momentum = momentum_change(body, sigma, s, c, before.om, z[VT, k], z[OM, k], z[TH, k], deps, dmu)
        dom = z[OM, k]
        # θ̇² = g_n/(ε cos θ)
        z[OM, k] = 0.5 * jam.om * (changes[GN, k] / body.gn - deps / body.eps + s / c * dth)
        dfaster = 2.0 * (jam.om * z[OM, k] - before.om * dom)
        dlever = deps * s + body.eps * c * dth
        drho = math.copysign(changes[RESIST, k], jam.om)
        z[RESISTED, k] -= 0.5 * (body.eps * s * (rho * dfaster + drho * faster) + rho * dlever * faster)
        z[VT, k] = momentum - momentum_change(body, sigma, s, c, jam.om, 0.0, z[OM, k], dth, deps, dmu)
        z[TH, k] = dth


@apart
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
    at_rest = state.om == 0.0 and body.resist > 0.0  # where the couple holds the hoop, or just does not
    if state.vt != 0.0:
        if math.isinf(body.mu_k):
            return False
        sigma = 1 if state.vt > 0.0 else -1
        if at_rest and abs(abs(slip_torque_arm(body, s, c, sigma)) - body.resist) <= FLAT:
            return True
        stiffness = slip_stiffness(body, s, c, sigma, resistance_arm(body, s, c, state.om, sigma))
        return opening <= scale or abs(stiffness) <= FLAT
    if at_rest and abs(abs(torque_at_rest(body, s, c)) - body.resist * body.gn) <= scale:
        return True
    friction, normal = rolling_forces(body, s, c, state.om * state.om, resistance_arm(body, s, c, state.om, 0))
    if math.isinf(body.mu_s):
        return abs(normal) <= scale
    margin = body.mu_s * normal - abs(friction)
    return abs(margin) <= scale * (1.0 + body.mu_s) or abs(normal) <= scale or (margin < 0.0 and opening <= scale)


@apart
def lose_slip(body, state, mode_sigma, changes, z, reasons):
    """A slip that is no more than the change of a start without slip: friction ends it at once, or it goes on.

    What it does before it ends depends on its direction, so that such a change holds for one side only.
    """
    s, c = sine_cosine(state.th, state.th_low)
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
        if state.om == 0.0 and body.resist > 0.0 and z[OM, k] != 0.0:  # which of both ends first is not gone into
            fail(z, reasons, k, BORDER)
            continue
        rho = resistance_arm(body, s, c, state.om, sigma)
        normal = slip_motion(body, s, c, state.om * state.om, sigma, rho)[1]
        rates = resisted_motion(body, sigma, state, 0.0)
        braking = rates[1]
        if not (normal > 0.0 and sigma * braking < 0.0 and slip_stiffness(body, s, c, sigma, rho) > 0.0):
            fail(z, reasons, k, BORDER)
            continue
        step_along(z, k, -given / braking, state, rates)
        z[VT, k] = 0.0
        if reasons[k] == NONE:
            reasons[k] = SIDED


@apart
def part_at_rest(body, sigma, state, z, reasons):
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
    for k in range(z.shape[1]):
        given = z[OM, k]
        if given == 0.0 or math.isnan(given) or abs(turning) <= FLAT * body.gn:
            continue
        if given * way < 0.0 and not keeps_mode:
            fail(z, reasons, k, BORDER)
        elif reasons[k] == NONE:
            reasons[k] = SIDED
