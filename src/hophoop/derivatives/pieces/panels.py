"""Derivatives on a panel of rolling or slip.

Over θ, u = θ̇² obeys u′ = 2 θ̈, which is linear in u, so that its changes have the same integrating factor. They are taken at
fixed ξ of the panel, which moves with its start, and with the turning point at its end: so dt/dξ stays smooth. The changes by
the start of a panel serve all directions.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from hophoop.derivatives.layout import OM, RESIST, ROLLING_LOSS, TH, VT, T, X, body_tangent
from hophoop.derivatives.transform import tangent_of
from hophoop.derivatives.workspace import BEGIN, INTEGRATE, INTERPOLATE, OWN, RESISTED, SHIFT, SLOPE, WEIGH, integrate_row
from hophoop.kernel.model import (
    contact_arms,
    inertia_at_height,
    kappa_p_sigma,
    load_height,
    resisted_inertia,
    rolling_acceleration,
    slip_displacement,
    slip_load,
    slip_torque_arm,
)
from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.circular import sine_cosine, sine_cosine_change_by
from hophoop.kernel.numerics.collocation import ORDER, dot, lagrange, product
from hophoop.kernel.numerics.tables import ANTIDERIVATIVE_T, NODES, WEIGHTS
from hophoop.kernel.steps import (
    ARM,
    ARRIVE,
    COSINE,
    DRIVEN,
    GROWTH,
    KAPPA_P_SIGMA,
    OFFSET_SINE,
    OFFSET_VERSINE,
    RATE,
    SINE,
    STRETCH,
    U,
    angle_at,
    from_reference,
    sine_versine_of_offset,
)

FROM_BEGIN = np.ascontiguousarray(ANTIDERIVATIVE_T.T)
AT_BEGIN = np.empty(ORDER)  # weights of the nodes in the value at ξ = −1
lagrange(-1.0, AT_BEGIN)


class Stretch(NamedTuple):
    """A panel from its start to ξ, and the states there."""

    panel: Any
    xi: float
    begin: Any
    end: Any


# --- formulas of a panel, of which the tangents are taken


def rolled_u(body, s, c, u, ds, dc, angle):
    """Return θ̇² after rolling by an angle over which sin θ and cos θ change by ds and dc: D θ̇² + 2 V is conserved."""
    inertia = inertia_at_height(body, load_height(s, c))
    energy = inertia * u + 2.0 * (body.eps * (body.gt * ds - body.gn * dc) + body.gt * angle)
    return energy / (inertia + 2.0 * body.eps * dc)


def slip_acceleration(body, c, u, q, stiffness):
    """Return θ̈ in slip from q and κ p_σ."""
    return q * slip_load(body, c, u, stiffness)


def slip_after(body, sigma, vt, om, s, c, om_end, s_end, c_end, tau):
    """Return v_t after the time tau of slip: gravity alone changes v_t + θ̇ (1 + ε c − σ μ ε s)."""
    signed_mu = sigma * body.mu_k
    arm, lever = contact_arms(body, s, c)
    arm_end, lever_end = contact_arms(body, s_end, c_end)
    momentum = vt + om * (arm - signed_mu * lever) + (body.gt - signed_mu * body.gn) * tau
    return momentum - om_end * (arm_end - signed_mu * lever_end)


def pressed(body, turned, s, u, s_end, u_end, integral):
    """Return ∫ N dθ over an angle, given ∫ cos θ θ̇² dθ: N = g_n − ε (sin θ θ̈ + cos θ θ̇²) and θ̈ = ½ dθ̇²/dθ."""
    return body.gn * turned - 0.5 * body.eps * (s_end * u_end - s * u + integral)


def resisted_loss(body, turned, s, u, s_end, u_end, integral):
    """Return f ∫ N dθ."""
    return body.resist * pressed(body, turned, s, u, s_end, u_end, integral)


d_rolled_u = tangent_of(rolled_u, "body")
d_rolling_acceleration = tangent_of(rolling_acceleration, "body", "rho")
d_slip_torque_arm = tangent_of(slip_torque_arm, "body")
d_kappa_p_sigma = tangent_of(kappa_p_sigma, "body", "rho")
d_slip_acceleration = tangent_of(slip_acceleration, "body", "q", "stiffness")
d_slip_displacement = tangent_of(slip_displacement, "body", "vt", "om", "s", "c", "ds", "dc", "tau")
d_slip_after = tangent_of(slip_after, "body", "vt", "om", "s", "c", "om_end", "s_end", "c_end", "tau")
d_resisted_loss = tangent_of(resisted_loss, "body", "turned", "s", "u", "s_end", "u_end", "integral")


# --- rates at the nodes


@inline
def roll_rates_at(body, panel, sine, versine, u, growth):
    """Return dθ̇²/dθ, and dθ̇²/d… by θ̇² and θ at the reference, at φ from there, given sin φ and 1 − cos φ.

    As changes from the reference, as the panel itself. `growth` is that of D′ θ̇², by rolling resistance.
    """
    eps = body.eps
    rho = panel.direction * body.resist
    s0 = panel.sine
    c0 = panel.cosine
    inertia0 = resisted_inertia(body, s0, c0, rho)
    torque = panel.torque + eps * (s0 + rho * c0) * panel.u
    ds, dc = sine_cosine_change_by(s0, c0, sine, versine)
    inertia = inertia0 + eps * (2.0 * dc - rho * ds)
    more = eps * (body.gn * ds + body.gt * dc + (s0 + ds) * u - s0 * panel.u)
    more += eps * rho * ((c0 + dc) * u - c0 * panel.u)
    return 2.0 * (torque + more) / inertia, growth * inertia0 / inertia, 2.0 * (more - (growth - 1.0) * torque) / inertia


@noinline
def fill_roll(body, panel, work, local):
    """Fill the rows SLOPE, BEGIN and SHIFT of a rolling panel."""
    for i in range(ORDER):
        growth = work[GROWTH, i] if body.resist > 0.0 else 1.0
        rates = roll_rates_at(body, panel, work[OFFSET_SINE, i], work[OFFSET_VERSINE, i], work[U, i], growth)
        local[SLOPE, i], local[BEGIN, i], local[SHIFT, i] = rates


@noinline
def fill_slip(body, panel, work, local):
    """Fill the same rows of a slip panel."""
    slope = 2.0 * slip_acceleration(body, panel.cosine, panel.u, panel.arm, panel.kappa_p_sigma)
    for i in range(ORDER):
        growth = work[GROWTH, i]
        local[SLOPE, i] = 2.0 * slip_acceleration(body, work[COSINE, i], work[U, i], work[ARM, i], work[KAPPA_P_SIGMA, i])
        local[BEGIN, i] = growth
        local[SHIFT, i] = local[SLOPE, i] - slope * growth


@noinline
def fill_own(body, panel, d_body, work, local, row):
    """Fill the change of θ̇² by the parameters of a direction, with θ and θ̇² at the reference fixed."""
    rho = panel.direction * body.resist
    drho = panel.direction * d_body.resist
    if is_closed(body, panel):
        for i in range(ORDER):
            own = own_at(body, panel, work[OFFSET_SINE, i], work[OFFSET_VERSINE, i], angle_at(panel, NODES[i]), d_body)
            row[i] = own + drho * local[RESISTED, i]
        return
    for i in range(ORDER):
        s = work[SINE, i]
        c = work[COSINE, i]
        u = work[U, i]
        if panel.sigma == 0:
            row[i] = 2.0 * d_rolling_acceleration(body, s, c, u, rho, d_body, drho)[1]
        else:
            dq = d_slip_torque_arm(body, s, c, panel.sigma, d_body)[1] - drho
            dstiffness = d_kappa_p_sigma(body, s, c, panel.sigma, rho, d_body, drho)[1]
            q = work[ARM, i]
            row[i] = 2.0 * d_slip_acceleration(body, c, u, q, work[KAPPA_P_SIGMA, i], d_body, dq, dstiffness)[1]
    integrate_row(panel, row, local[BEGIN], work)


@inline
def is_closed(body, panel):
    """Return True if θ̇² has a closed form: in rolling without resistance."""
    return panel.sigma == 0 and body.resist == 0.0


@inline
def own_at(body, panel, sine, versine, offset, d_body):
    """Return the same without resistance at φ = offset from the reference, given sin φ and 1 − cos φ."""
    ds, dc = sine_cosine_change_by(panel.sine, panel.cosine, sine, versine)
    return d_rolled_u(body, panel.sine, panel.cosine, panel.u, ds, dc, offset, d_body)[1]


@noinline
def fill_resisted(body, panel, work, row):
    """Fill the change of θ̇² by ρ in rolling without resistance: D θ̇² loses 2 ρ ∫ N dθ."""
    integral = work[DRIVEN]
    for i in range(ORDER):
        row[i] = work[COSINE, i] * work[U, i] * work[STRETCH, i]
    from_reference(panel, row, integral)
    for i in range(ORDER):
        s = work[SINE, i]
        push = pressed(body, angle_at(panel, NODES[i]), panel.sine, panel.u, s, work[U, i], integral[i])
        row[i] = -2.0 * push / inertia_at_height(body, load_height(s, work[COSINE, i]))


def moves_body(d_body):
    """Return True if a direction changes what acts on a panel."""
    others = d_body.gn != 0.0 or d_body.gt != 0.0 or d_body.resist != 0.0
    return d_body.eps != 0.0 or d_body.kap != 0.0 or d_body.mu_k != 0.0 or others


@noinline
def prepare_panel(body, panel, parameter_tangents, workspace):
    """Compute what `follow_panel` needs of a solved panel."""
    work, local = workspace.scratch.work, workspace.local
    if panel.sigma == 0:
        fill_roll(body, panel, work, local)
    else:
        fill_slip(body, panel, work, local)
    if is_closed(body, panel) and resists(body, parameter_tangents):
        fill_resisted(body, panel, work, local[RESISTED])
    for k in range(parameter_tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        if moves_body(d_body):
            fill_own(body, panel, d_body, work, local, local[OWN + k])
        else:
            local[OWN + k] = 0.0
    if panel.kind == ARRIVE:
        for i in range(ORDER):
            part = 0.5 * (1.0 - NODES[i])
            local[BEGIN, i] = local[SLOPE, i] * part * part
            local[SHIFT, i] -= local[BEGIN, i]


# --- changes at a place


@noinline
def fill_weights(panel, xi, resisting, work, local):
    """Fill the rows INTERPOLATE, of a value at ξ; INTEGRATE, of the time by θ̇²; WEIGH, of ∫ cos θ θ̇² dθ. Return the time."""
    weights = local[INTERPOLATE]
    quadrature = local[INTEGRATE]
    lagrange(xi, weights)
    if xi < 1.0:
        product(FROM_BEGIN, weights, quadrature)
    else:
        for i in range(ORDER):
            quadrature[i] = WEIGHTS[i]
    time = dot(quadrature, work[RATE])
    if resisting:
        for i in range(ORDER):
            local[WEIGH, i] = quadrature[i] * panel.direction * work[COSINE, i] * work[STRETCH, i]
    for i in range(ORDER):
        quadrature[i] *= -0.5 * work[RATE, i] / work[U, i]
    return time


def slope_weighed(panel, local):
    """Return ∫ cos θ dθ̇²/dθ dθ times how places at fixed ξ move, (with the reference, with the start of an arriving panel)."""
    moved = 0.0
    fixed = 0.0
    for i in range(ORDER):
        part = 0.0
        if panel.kind == ARRIVE:
            part = 0.5 * (1.0 - NODES[i])
            part *= part
        moved += local[WEIGH, i] * local[SLOPE, i] * (1.0 - part)
        fixed += local[WEIGH, i] * local[SLOPE, i] * part
    return moved, fixed


def resists(body, parameter_tangents):
    """Return True if there is rolling resistance, or a direction that changes it."""
    found = body.resist > 0.0
    for k in range(parameter_tangents.shape[1]):
        found = found or parameter_tangents[RESIST, k] != 0.0
    return found


@noinline
def follow_slip(body, sigma, time, begin, end, before, dt, d_body, tangents, k):
    """Propagate v_t and x of a direction through a time of slip; the tangents of t, θ and θ̇ are those at its end.

    `before` are those of (θ, θ̇) at its start, and `dt` is the change of its duration.
    """
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    s1, c1 = sine_cosine(end.th, end.th_low)
    dth0, dom0 = before
    dth1 = tangents[TH, k]
    dvt = tangents[VT, k]
    ds0, dc0, ds1, dc1 = c0 * dth0, -s0 * dth0, c1 * dth1, -s1 * dth1
    tangents[X, k] += d_slip_displacement(
        body, sigma, begin.vt, begin.om, s0, c0, s1 - s0, c1 - c0, time, d_body, dvt, dom0, ds0, dc0, ds1 - ds0, dc1 - dc0, dt
    )[1]
    tangents[VT, k] = d_slip_after(
        body, sigma, begin.vt, begin.om, s0, c0, end.om, s1, c1, time,
        d_body, dvt, dom0, ds0, dc0, tangents[OM, k], ds1, dc1, dt,
    )[1]  # fmt: skip


class Rates(NamedTuple):
    """Changes of θ̇² at a place of a panel: by the start, as the rows BEGIN and SHIFT; how to get those by the parameters."""

    begin: float
    shift: float
    sine: float  # of the angle from the reference, for the closed form
    versine: float
    offset: float
    resisted: float  # by ρ, where that is 0


@noinline
def rates_at(body, panel, xi, s, c, u, push, weights, local):
    """Return the Rates at ξ, from the nodes by their weights or, where there is one, from the closed form.

    `push` is ∫ N dθ from the start of the panel.
    """
    if not is_closed(body, panel):
        return Rates(dot(weights, local[BEGIN]), dot(weights, local[SHIFT]), 0.0, 0.0, 0.0, 0.0)
    sine, versine = sine_versine_of_offset(panel, xi)
    slope, begin, shift = roll_rates_at(body, panel, sine, versine, u, 1.0)
    if panel.kind == ARRIVE:
        part = 0.5 * (1.0 - xi)
        begin = slope * part * part
        shift -= begin
        resisted = dot(weights, local[RESISTED])
    else:
        resisted = -2.0 * push / inertia_at_height(body, load_height(s, c))
    return Rates(begin, shift, sine, versine, angle_at(panel, xi), resisted)


@noinline
def own_change(body, panel, rates, d_body, weights, own):
    """Return the change of θ̇² at a place by the parameters of a direction."""
    if not is_closed(body, panel):
        return dot(weights, own)
    resisted = panel.direction * d_body.resist * rates.resisted
    return own_at(body, panel, rates.sine, rates.versine, rates.offset, d_body) + resisted


@noinline
def follow_panel(body, stretch, parameter_tangents, tangents, workspace):
    """Propagate all directions from the start of a prepared panel to ξ."""
    panel, xi, begin, end = stretch
    work, local = workspace.scratch.work, workspace.local
    arrives = panel.kind == ARRIVE
    resisting = resists(body, parameter_tangents)
    time = fill_weights(panel, xi, resisting, work, local)
    weights = local[INTERPOLATE]
    quadrature = local[INTEGRATE]
    longer = panel.direction * time / panel.extent if arrives else 0.0  # an arriving panel becomes longer
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    s1, c1 = sine_cosine(end.th, end.th_low)
    u0 = begin.om * begin.om
    u1 = end.om * end.om
    turned = angle_at(panel, xi) - angle_at(panel, -1.0)
    moved = fixed = integral = push = 0.0
    if resisting:
        moved, fixed = slope_weighed(panel, local)
        integral = dot(local[WEIGH], work[U])
        push = pressed(body, turned, s0, u0, s1, u1, integral)
    rates = rates_at(body, panel, xi, s1, c1, u1, push, weights, local)
    at_begin = rates_at(body, panel, -1.0, s0, c0, u0, 0.0, AT_BEGIN, local) if arrives else rates
    time_by_first = dot(quadrature, local[BEGIN]) - longer
    time_by_second = dot(quadrature, local[SHIFT]) + longer
    part = 0.5 * (1.0 - xi)
    part *= part
    for k in range(tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        own = local[OWN + k]
        moves = moves_body(d_body)
        dth0 = tangents[TH, k]
        dom0 = tangents[OM, k]
        du0 = 2.0 * begin.om * dom0
        if arrives:  # θ̇² at the start gives the turning point
            first = dth0
            known = at_begin.begin * dth0
            if moves:
                known += own_change(body, panel, at_begin, d_body, AT_BEGIN, own)
            second = (du0 - known) / at_begin.shift
            tangents[TH, k] = dth0 * part + second * (1.0 - part)
        else:
            first = du0
            second = dth0
        du = first * rates.begin + second * rates.shift
        dt = first * time_by_first + second * time_by_second
        if moves:
            du += own_change(body, panel, rates, d_body, weights, own)
            dt += dot(quadrature, own)
        tangents[OM, k] = 0.5 * du / end.om if end.om != 0.0 else 0.0
        tangents[T, k] += dt
        dth1 = tangents[TH, k]
        if resisting:
            weigh = local[WEIGH]
            dintegral = first * dot(weigh, local[BEGIN]) + second * dot(weigh, local[SHIFT]) + dot(weigh, own)
            dintegral += c1 * u1 * dth1 - c0 * u0 * dth0 - first * fixed - second * moved
            tangents[ROLLING_LOSS, k] += (
                panel.direction
                * d_resisted_loss(
                    body, turned, s0, u0, s1, u1, integral, d_body,
                    dth1 - dth0, c0 * dth0, du0, c1 * dth1, 2.0 * end.om * tangents[OM, k], dintegral,
                )[1]
            )  # fmt: skip
        if panel.sigma == 0:
            tangents[X, k] += dth1 - dth0
        else:
            follow_slip(body, panel.sigma, time, begin, end, (dth0, dom0), dt, d_body, tangents, k)
