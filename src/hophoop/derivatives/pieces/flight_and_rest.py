"""Derivatives along what needs no panel: a flight, rest, slip without rotation; and a step along the motion itself."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import EPS, GN, GT, MU_K, OM, ROLLING_LOSS, TH, VN, VT, T, X, Y
from hophoop.derivatives.pieces.panels import SlipTime, follow_slip
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import series_remainders, sine, sine_and_cosine, sine_cosine, versine_of
from hophoop.kernel.numerics.exponentials import hyperbolic_cosine, hyperbolic_sine
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.closed_forms import flight_gap
from hophoop.kernel.physics.contact import (
    free_acceleration,
    inertia_at_height,
    kappa_p_sigma,
    load_height,
    resistance_arm,
    rolling_acceleration,
    rolling_forces,
    slip_motion,
)
from hophoop.kernel.physics.modes import slip_direction

SCAN = 0.3  # rad of rotation between two looks at the rate of the gap
TOUCH = 1e-9  # of the radius: a smaller gap is none


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
    if sigma == 0:
        return rolling_acceleration(body, s, c, u, rho), 0.0, 0.0, rho * state.om * rolling_forces(body, s, c, u, rho)[1]
    turning, normal, along = slip_motion(body, s, c, u, sigma, rho)
    return turning, along, 0.0, rho * state.om * normal


@noinline
def accelerations(body, mode, state, way):
    """(θ̈, v̇_t, v̇_n, power lost to rolling resistance) of a state in a mode; `way` as in `resisted_motion`."""
    if mode != Mode.FLIGHT and body.resist > 0.0:
        return resisted_motion(body, slip_direction(mode), state, way)
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    if mode == Mode.ROLL:
        return rolling_acceleration(body, s, c, u, 0.0), 0.0, 0.0, 0.0
    if mode == Mode.FLIGHT:
        along, away = free_acceleration(body, s, c, u)
        return 0.0, along, away, 0.0
    if body.kap == 0.0:  # the massless hoop that slides with its load on the plane
        return 0.0, body.gt - slip_direction(mode) * body.mu_k * body.gn, 0.0, 0.0
    turning, _, along = slip_motion(body, s, c, u, slip_direction(mode), 0.0)
    return turning, along, 0.0, 0.0


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
def follow_flight(body, opening, begin, end, tau, parameter_tangents, tangents):
    """Propagate all directions over the time tau of a flight whose f_n at the start is `opening`, 0 after a lift-off."""
    s0, c0 = sine_cosine(begin.th, begin.th_low)
    s1, c1 = sine_cosine(end.th, end.th_low)
    om = begin.om
    phi = om * tau
    sine_part, cosine_part, versine = series_remainders(phi)
    turned = sine(phi)
    half = 0.5 * tau * tau
    for k in range(tangents.shape[1]):
        deps = parameter_tangents[EPS, k]
        dth = tangents[TH, k]
        dom = tangents[OM, k]
        dopening = 0.0
        if opening != 0.0:
            dopening = -parameter_tangents[GN, k] + om * (deps * c0 * om - body.eps * s0 * om * dth + 2.0 * body.eps * c0 * dom)
        # the gap without cancellation, as in `closed_forms.flight_rates`
        tangents[Y, k] += tangents[VN, k] * tau + dopening * half - deps * (c0 * cosine_part + s0 * sine_part)
        tangents[Y, k] -= body.eps * ((c0 * sine_part - s0 * cosine_part) * dth + (c0 * sine_part + s0 * versine) * tau * dom)
        tangents[VN, k] += dopening * tau - (deps * om + body.eps * dom) * (c0 * sine_part + s0 * versine)
        tangents[VN, k] -= body.eps * om * ((c0 * versine - s0 * sine_part) * dth + (c0 * versine + s0 * turned) * tau * dom)
        dth1 = dth + tau * dom
        # G moves on a parabola
        along = tangents[VT, k] + dom * (1.0 + body.eps * c0) + om * (deps * c0 - body.eps * s0 * dth)
        shift = deps * (s0 - s1) + body.eps * (c0 * dth - c1 * dth1)
        tangents[X, k] += shift + along * tau + parameter_tangents[GT, k] * half
        tangents[VT, k] = (
            along + parameter_tangents[GT, k] * tau - dom * (1.0 + body.eps * c1) - om * (deps * c1 - body.eps * s1 * dth1)
        )
        tangents[TH, k] = dth1


@noinline
def skims_plane(body, opening, begin, tau):
    """Return True if the minimum of the gap of a flight is 0 to rounding: a touch without approach."""
    s, c = sine_cosine(begin.th, begin.th_low)
    om = begin.om
    if not body.eps * om * om > body.gn:
        return False  # the gap has no minimum
    steps = int(abs(om) * tau / SCAN) + 1
    low = 0.0
    falls = False
    for i in range(1, steps + 1):
        high = tau * i / steps
        rises = flight_gap(body, s, c, om, begin.y, begin.vn, opening, high)[1] > 0.0
        if falls and rises:
            left, right = low, high
            for _ in range(60):
                middle = 0.5 * (left + right)
                if flight_gap(body, s, c, om, begin.y, begin.vn, opening, middle)[1] > 0.0:
                    right = middle
                else:
                    left = middle
            gap = flight_gap(body, s, c, om, begin.y, begin.vn, opening, left)[0]
            if gap <= TOUCH * (begin.y + body.eps):
                return True
        falls = not rises
        low = high
    return False


def perturbed_rest(stiffness, drive, angle, rate, tau):
    """(δθ, δθ̇) after the time tau of δθ̈ = stiffness · δθ + drive."""
    pull = abs(stiffness)
    pace = math.sqrt(pull)
    phase = pace * tau
    if phase < 1e-3:  # to rounding
        square = stiffness * tau * tau
        even = 1.0 + 0.5 * square * (1.0 + square / 12.0)
        odd = tau * (1.0 + square / 6.0 * (1.0 + square / 20.0))
        bent = 0.5 * tau * tau * (1.0 + square / 12.0)
    elif stiffness > 0.0:
        even = hyperbolic_cosine(phase)
        odd = hyperbolic_sine(phase) / pace
        half = hyperbolic_sine(0.5 * phase)
        bent = 2.0 * half * half / pull
    else:
        odd, even = sine_and_cosine(phase)
        odd /= pace
        bent = versine_of(phase) / pull
    return angle * even + rate * odd + drive * bent, stiffness * angle * odd + rate * even + drive * odd


@noinline
def follow_hold(body, sigma, begin, end, tau, parameter_tangents, tangents):
    """Propagate all directions over the time tau of rest (sigma = 0), or of slip without rotation."""
    s, c = sine_cosine(begin.th, begin.th_low)
    signed_mu = sigma * body.mu_k
    for k in range(tangents.shape[1]):
        deps = parameter_tangents[EPS, k]
        dth0 = tangents[TH, k]
        dom0 = tangents[OM, k]
        if body.resist > 0.0:  # what is held stays, and a little rotation is stopped at once
            if tau > 0.0:
                tangents[OM, k] = 0.0
            if sigma != 0:
                follow_slip(body, SlipTime(sigma, begin, end, tau), (dth0, dom0), 0.0, k, parameter_tangents, tangents)
            continue
        if body.kap == 0.0:
            stiffness = 0.0
            drive = 0.0
        elif sigma == 0:
            inertia = inertia_at_height(body, load_height(s, c))
            stiffness = body.eps * (body.gn * c - body.gt * s) / inertia
            drive = (body.gn * s + body.gt * c) * deps + body.eps * s * parameter_tangents[GN, k]
            drive = (drive + (1.0 + body.eps * c) * parameter_tangents[GT, k]) / inertia
        else:
            load = body.gn / kappa_p_sigma(body, s, c, sigma, 0.0)
            stiffness = body.eps * (c - signed_mu * s) * load
            drive = load * ((s + signed_mu * c) * deps + sigma * (1.0 + body.eps * c) * parameter_tangents[MU_K, k])
        tangents[TH, k], tangents[OM, k] = perturbed_rest(stiffness, drive, dth0, dom0, tau)
        if sigma == 0:
            tangents[X, k] += tangents[TH, k] - dth0
        else:
            follow_slip(body, SlipTime(sigma, begin, end, tau), (dth0, dom0), 0.0, k, parameter_tangents, tangents)
