"""Derivatives along what needs no panel: a flight, rest, slip without rotation; and a step along the motion itself."""

from __future__ import annotations

import math

from hophoop.derivatives.events.massless import skim_rates
from hophoop.derivatives.layout import OM, ROLLING_LOSS, STILL, TH, VN, VT, T, X, Y, body_tangent
from hophoop.derivatives.pieces.panels import follow_slip
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.model import (
    Mode,
    acceleration_in_contact,
    flight_displacement,
    flight_gap,
    free_acceleration,
    inertia_at_height,
    load_height,
    resistance_arm,
    rolling_acceleration,
    rolling_forces,
    slip_direction,
    slip_motion,
    torque_at_rest,
)
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine, versine_of
from hophoop.kernel.numerics.exponentials import hyperbolic_cosine, hyperbolic_sine
from hophoop.kernel.steps import (
    Flight,
    downcrossing_between,
    moment_of,
    rolling_anchor,
    rolling_panel_start,
)

d_free_acceleration = tangent_of(free_acceleration, "body", "s", "c", "u")
d_acceleration_in_contact = tangent_of(acceleration_in_contact, "body", "s", "c")
d_flight_displacement = tangent_of(flight_displacement, "body", "vt", "om", "s", "c")
d_flight_gap = tangent_of(flight_gap, "body", "s", "c", "om", "y", "vn", "fn")
SCAN = 0.3  # rad of rotation between two looks at the rate of the gap
NEAR_REST = 1e-6  # relative to the weight: a smaller torque has lost digits to rounding
TOUCH = 1e-9  # of the radius: a smaller gap is none


@noinline
def rolling_torque(body, state, s, c):
    """Return −dV/dθ in rolling without resistance, relative to the nearest equilibrium where it is close to zero."""
    torque = torque_at_rest(body, s, c)
    if abs(torque) > NEAR_REST * (body.gn + abs(body.gt)):
        return torque
    return rolling_panel_start(body, rolling_anchor(body, state, s, c), state, s, c)[0]


@noinline
def resisted_motion(body, sigma, state, way):
    """(θ̈, v̇_t, 0, power lost to rolling resistance) in rolling (sigma = 0) or slip.

    `way` is where a hoop turns that is at rest, 0 where it is held or not known.
    """
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    rho = way * body.resist
    if state.om != 0.0 or way == 0.0:
        rho = resistance_arm(body, s, c, state.om, sigma)
    if sigma == 0 and rho == 0.0:
        torque = rolling_torque(body, state, s, c) + body.eps * s * u
        return torque / inertia_at_height(body, load_height(s, c)), 0.0, 0.0, 0.0
    if sigma == 0:
        return rolling_acceleration(body, s, c, u, rho), 0.0, 0.0, rho * state.om * rolling_forces(body, s, c, u, rho)[1]
    turning, normal, along = slip_motion(body, s, c, u, sigma, rho)
    return turning, along, 0.0, rho * state.om * normal


@noinline
def accelerations(body, mode, state, way):
    """(θ̈, v̇_t, v̇_n, power lost to rolling resistance) of a state in a mode; `way` as in `resisted_motion`."""
    if mode == Mode.SKIM:
        return skim_rates(body, state)
    if mode == Mode.FLIGHT:
        s, c = sine_cosine(state.th, state.th_low)
        along, away = free_acceleration(body, s, c, state.om * state.om)
        return 0.0, along, away, 0.0
    sigma = slip_direction(mode)
    if body.kap == 0.0 and sigma != 0:  # the massless hoop that slides with its load on the plane
        return 0.0, body.gt - sigma * body.mu_k * body.gn, 0.0, 0.0
    return resisted_motion(body, sigma, state, way)


def step_along(tangents, k, dt, state, rates):
    """Express the change of a direction at a moment that is later by the small dt."""
    turning, along, away, lost = rates
    tangents[T, k] += dt
    tangents[X, k] += (state.vt + state.om) * dt
    tangents[Y, k] += state.vn * dt
    tangents[TH, k] += state.om * dt
    tangents[OM, k] += turning * dt
    tangents[VT, k] += along * dt
    tangents[VN, k] += away * dt
    tangents[ROLLING_LOSS, k] += lost * dt


@noinline
def follow_flight(body, opening, begin, tau, parameter_tangents, tangents):
    """Propagate all directions over the time tau of a flight whose f_n at the start is `opening`, 0 after a lift-off."""
    s, c = sine_cosine(begin.th, begin.th_low)
    om = begin.om
    for k in range(tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        dom = tangents[OM, k]
        ds = c * tangents[TH, k]
        dc = -s * tangents[TH, k]
        dopening = 0.0
        if opening != 0.0:
            dopening = d_free_acceleration(body, s, c, om * om, d_body, ds, dc, 2.0 * om * dom)[1][1]
        dx, dvt = d_flight_displacement(body, begin.vt, om, s, c, tau, d_body, tangents[VT, k], dom, ds, dc)[1]
        dy, dvn = d_flight_gap(
            body, s, c, om, begin.y, begin.vn, opening, tau, d_body, ds, dc, dom, tangents[Y, k], tangents[VN, k], dopening
        )[1]
        tangents[X, k] += dx
        tangents[Y, k] = dy
        tangents[TH, k] += tau * dom
        tangents[VT, k] = dvt
        tangents[VN, k] = dvn


@noinline
def skims_plane(body, opening, begin, tau):
    """Return True if the minimum of the gap of a flight is 0 to rounding: a touch without approach."""
    s, c = sine_cosine(begin.th, begin.th_low)
    om = begin.om
    if not body.eps * om * om > body.gn:
        return False  # the gap has no minimum
    flight = Flight(s, c, om, begin.y, begin.vn, opening)
    steps = int(abs(om) * tau / SCAN) + 1
    first = moment_of(body, flight, 0.0)
    for i in range(1, steps + 1):
        last = moment_of(body, flight, tau * i / steps)
        if first.rate < 0.0 < last.rate:
            lowest = moment_of(body, flight, downcrossing_between(body, flight, first, last, True))
            if lowest.gap <= TOUCH * (begin.y + body.eps):
                return True
        first = last
    return False


def perturbed_rest(stiffness, drive, angle, rate, tau):
    """(δθ, δθ̇) after the time tau of δθ̈ = stiffness · δθ + drive."""
    pull = max(abs(stiffness), 1e-200)  # a smaller one does nothing
    pace = math.sqrt(pull)
    phase = pace * tau
    if stiffness > 0.0:
        even = hyperbolic_cosine(phase)
        odd = hyperbolic_sine(phase)
        half = hyperbolic_sine(0.5 * phase)
        bent = 2.0 * half * half
    else:
        odd, even = sine_and_cosine(phase)
        bent = versine_of(phase)
    odd /= pace
    bent /= pull
    return angle * even + rate * odd + drive * bent, stiffness * angle * odd + rate * even + drive * odd


@noinline
def follow_hold(body, sigma, begin, end, tau, parameter_tangents, tangents):
    """Propagate all directions over the time tau of rest (sigma = 0), or of slip without rotation."""
    s, c = sine_cosine(begin.th, begin.th_low)
    stiffness = 0.0
    if body.kap > 0.0:
        stiffness = d_acceleration_in_contact(body, s, c, 0.0, sigma, STILL, c, -s)[1]
    for k in range(tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        before = (tangents[TH, k], tangents[OM, k])
        if body.resist > 0.0:  # what is held stays, and a little rotation is stopped at once
            if tau > 0.0:
                tangents[OM, k] = 0.0
        else:
            drive = d_acceleration_in_contact(body, s, c, 0.0, sigma, d_body, 0.0, 0.0)[1] if body.kap > 0.0 else 0.0
            tangents[TH, k], tangents[OM, k] = perturbed_rest(stiffness, drive, before[0], before[1], tau)
        if sigma != 0:
            follow_slip(body, sigma, tau, begin, end, before, 0.0, d_body, tangents, k)
        elif body.resist == 0.0:
            tangents[X, k] += tangents[TH, k] - before[0]
