"""The condition of an event, and when the changed motion meets it: dt = −dg/ġ of the quantity g that comes to zero."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import OM, ROLLING_LOSS, STILL, TH, VT, Reason, T, body_tangent
from hophoop.derivatives.pieces.flight_and_rest import resisted_motion, step_along
from hophoop.derivatives.pieces.panels import d_kappa_p_sigma, d_slip_after
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.model import (
    free_acceleration,
    kappa_p_sigma,
    resistance_arm,
    rolling_forces,
    slip_torque_arm,
    torque_at_rest,
)
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_cosine

d_kappa_p_sigma_by_angle = tangent_of(kappa_p_sigma, "s", "c")
GRAZE, NONE, BORDER, SIDED = int(Reason.GRAZE), int(Reason.NONE), int(Reason.BORDER), -1
FLAT = 1e-9  # relative to its natural size: a smaller rate belongs to a quantity that only touches zero


def fail(tangents, reasons, k, reason):
    """There is no derivative in a direction from here on; the first reason is kept."""
    tangents[:, k] = math.nan
    if reasons[k] <= 0:
        reasons[k] = reason


def fail_all(tangents, reasons, reason):
    """There is no derivative in any direction from here on."""
    for k in range(tangents.shape[1]):
        fail(tangents, reasons, k, reason)


def meet(dg, rate, scale, state, rates, tangents, reasons, k):
    """Express the change of a direction at the time at which g, changed by dg, comes to zero with its rate."""
    if abs(rate) <= FLAT * scale:
        fail(tangents, reasons, k, GRAZE)
    else:
        step_along(tangents, k, -dg / rate, state, rates)


def contact_margin(body, slips, s, c, om):
    """Return what comes to zero as contact ends: f_n in slip, in rolling μs N − abs(F), or N without a bound on F."""
    if slips:
        return free_acceleration(body, s, c, om * om)[1]
    friction, normal = rolling_forces(body, s, c, om * om, math.copysign(body.resist, om))
    if math.isinf(body.mu_s):
        return normal
    return body.mu_s * normal - abs(friction)


d_contact_margin = tangent_of(contact_margin, "body", "s", "c", "om")


@noinline
def meet_margin(body, slips, state, rates, parameter_tangents, tangents, reasons):
    """The end of rolling or of the contact in slip."""
    s, c = sine_cosine(state.th, state.th_low)
    om = state.om
    rate = d_contact_margin(body, slips, s, c, om, STILL, c * om, -s * om, rates[0])[1]
    weight = 0.0 if slips or math.isinf(body.mu_s) else body.mu_s
    scale = (body.gn + abs(body.gt) + om * om) * (1.0 + weight) * (abs(om) + 1e-300)
    for k in range(tangents.shape[1]):
        dth = tangents[TH, k]
        d_body = body_tangent(parameter_tangents, k)
        dg = d_contact_margin(body, slips, s, c, om, d_body, c * dth, -s * dth, tangents[OM, k])[1]
        meet(dg, rate, scale, state, rates, tangents, reasons, k)


@noinline
def meet_row(row, rate, scale, state, rates, tangents, reasons):
    """A component of the state that comes to zero: the slip at its end, v_n at the apex, the gap at the landing."""
    for k in range(tangents.shape[1]):
        meet(tangents[row, k], rate, scale, state, rates, tangents, reasons, k)
        if abs(rate) > FLAT * scale:
            tangents[row, k] = 0.0


@noinline
def meet_time(parameter_tangents, row, state, rates, tangents):
    """The end of time, which itself may change."""
    for k in range(tangents.shape[1]):
        step_along(tangents, k, parameter_tangents[row, k] - tangents[T, k], state, rates)


def jam_angle_change(body, sigma, s, c, om, d_body):
    """Change of the angle at which p_σ = 0."""
    way = math.copysign(1.0, om)
    rho = resistance_arm(body, s, c, om, sigma)
    slope = d_kappa_p_sigma_by_angle(body, s, c, sigma, rho, c, -s)[1]
    return -d_kappa_p_sigma(body, s, c, sigma, rho, d_body, way * d_body.resist)[1] / slope


@noinline
def go_with_jam(body, sigma, begin, jam, parameter_tangents, tangents):
    """Express each change at the moment at which it is as far from the jam as the motion itself.

    So the panels move along with the angle of the jam, near which θ̇² is a power of the distance from it.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    rates = resisted_motion(body, sigma, begin, 0.0)
    for k in range(tangents.shape[1]):
        dth = jam_angle_change(body, sigma, s, c, jam.om, body_tangent(parameter_tangents, k))
        step_along(tangents, k, (dth - tangents[TH, k]) / begin.om, begin, rates)
        tangents[TH, k] = dth


def jam_speed(body, c, way):
    """Return θ̇ of the jam, where f_n = 0."""
    return way * math.sqrt(body.gn / (body.eps * c))


def last_loss(body, s, om, om_end, way):
    """Return the loss ½ ρ (θ̇ + θ̇_end) P_n by rolling resistance, of the impulse P_n that changes −ε s θ̇, with signs."""
    return 0.5 * way * body.resist * (om + om_end) * body.eps * s * (om - om_end)


d_jam_speed = tangent_of(jam_speed, "body", "c")
d_last_loss = tangent_of(last_loss, "body", "s", "om", "om_end")


@noinline
def meet_jam(body, sigma, jam, before, parameter_tangents, tangents):
    """The dynamic jam: p_σ = 0 says where, f_n = 0 how fast; `before` is the state that comes near.

    What gravity alone changes, the momentum v_t + θ̇ (1 + ε c − σ μ ε s), does not see the force without bound. Nor does
    the momentum away from the plane, −ε s θ̇, which gives the last impulse P_n, and with it the loss ½ ρ (θ̇ + θ̇_jam) P_n.
    """
    s, c = sine_cosine(jam.th, jam.th_low)
    way = math.copysign(1.0, jam.om)
    for k in range(tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        dth = jam_angle_change(body, sigma, s, c, jam.om, d_body)
        ds, dc = c * dth, -s * dth
        dom = tangents[OM, k]
        jam_om, djam_om = d_jam_speed(body, c, way, d_body, dc)
        tangents[ROLLING_LOSS, k] += d_last_loss(body, s, before.om, jam_om, way, d_body, ds, dom, djam_om)[1]
        tangents[VT, k] = d_slip_after(
            body, sigma, before.vt, before.om, s, c, jam_om, s, c, 0.0,
            d_body, tangents[VT, k], dom, ds, dc, djam_om, ds, dc, 0.0,
        )[1]  # fmt: skip
        tangents[OM, k] = djam_om
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
