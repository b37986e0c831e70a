"""The rule that selects the next mode, at the start and after every event (docs/model.md#which-mode-follows)."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine
from hophoop.kernel.physics.body import FLIGHT, ROLL, SKID, SPIN
from hophoop.kernel.physics.contact import (
    cone_weights,
    free_acceleration,
    kappa_p_sigma,
    resistance_arm,
    rolling_forces,
    slip_coefficients,
    slip_motion,
)

# --- time derivatives at an instant: truncated Taylor series along a candidate motion
# They decide ties: if a quantity that selects the next mode is zero, its first or second derivative decides. A series is a
# tuple of its first 3 coefficients.

TERMS = 3
ZERO = 1e-11  # relative to the scale of the others; a smaller coefficient counts as zero


def _times(a, b):
    """Return the series a b."""
    return a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0]


def _over(a, b):
    """Return the series a / b."""
    q0 = a[0] / b[0]
    q1 = (a[1] - q0 * b[1]) / b[0]
    return q0, q1, (a[2] - q0 * b[2] - q1 * b[1]) / b[0]


def _sum(x, a, y, b):
    """Return the series x a + y b."""
    return x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]


def _shifted(value, x, a):
    """Return the series value + x a."""
    return x * a[0] + value, x * a[1], x * a[2]


def _sine_cosine(th, rate):
    """Return the series of sin θ and cos θ from that of θ̇: s′ = c θ′ and c′ = −s θ′, coefficient by coefficient."""
    s0, c0 = sine_and_cosine(th)
    s1 = rate[0] * c0
    c1 = -(rate[0] * s0)
    s2 = rate[0] * c1 / 2 + rate[1] * c0 / 2
    c2 = -(rate[0] * s1 / 2) - rate[1] * s0 / 2
    return (s0, s1, s2), (c0, c1, c2)


@noinline
def candidate_series(body, th, om, sigma):
    """Return Taylor coefficients of (N, cone margin at F > 0, at F < 0, v̇_t) in rolling (sigma = 0) or slip."""
    eps = body.eps
    drag = sigma * body.mu_k
    sine, cosine = sine_and_cosine(th)
    rho = resistance_arm(body, sine, cosine, om, sigma)
    a, b = cone_weights(body.mu_s)
    normal = (0.0, 0.0, 0.0)
    friction = normal
    slip = normal
    rate = (om, 0.0, 0.0)
    for _ in range(TERMS):  # each pass determines one more coefficient of the angular velocity
        s, c = _sine_cosine(th, rate)
        u = _times(rate, rate)
        arm = _shifted(1.0, eps, c)
        centrifugal = _shifted(0.0, eps, _times(s, u))
        if sigma == 0:
            inertia = _shifted(1.0 + body.kap + eps * eps, 2.0 * eps, c)
            torque = _sum(1.0, _sum(1.0, centrifugal, eps * body.gn, s), body.gt, arm)
            if rho != 0.0:
                inertia = _sum(1.0, inertia, -rho * eps, s)
                torque = _shifted(-rho * body.gn, 1.0, _sum(1.0, torque, rho * eps, _times(c, u)))
            alpha = _over(torque, inertia)
            friction = _shifted(-body.gt, 1.0, _sum(1.0, _times(alpha, arm), -1.0, centrifugal))
            normal = _shifted(body.gn, -eps, _sum(1.0, _times(s, alpha), 1.0, _times(c, u)))
        else:
            q = _shifted(-rho, 1.0, _sum(eps, s, drag, arm)) if rho != 0.0 else _sum(eps, s, drag, arm)
            stiffness = _shifted(body.kap, eps, _times(s, q))
            load = _over(_shifted(body.gn, -eps, _times(c, u)), stiffness)
            alpha = _times(q, load)
            normal = _shifted(0.0, body.kap, load)
            part = _shifted(drag * body.kap, 1.0, _times(arm, q))
            slip = _shifted(body.gt, 1.0, _sum(1.0, centrifugal, -1.0, _times(load, part)))
        rate = om, alpha[0], alpha[1] / 2
    return normal, _sum(a, normal, -b, friction), _sum(a, normal, b, friction), slip


@inline
def sign_beyond(value, rounding):
    """Return the sign of a quantity, 0 if it is not larger than its rounding."""
    if abs(value) > rounding:
        return 1 if value > 0.0 else -1
    return 0


def leading_sign(series, scale):
    """Return the sign of the first nonzero coefficient, 0 if all are zero."""
    for value in series:
        sign = sign_beyond(value, ZERO * scale)
        if sign != 0:
            return sign
    return 0


# --- the rule

# Results other than modes: rule 4 records them before the motion continues.
INCONSISTENT, INDETERMINATE, UNDECIDED = 10, 11, 12

ROUNDING = 2e-15  # rounding of forces, relative to gravity and centrifugal acceleration
TIE = 1e-13  # relative to gravity and centrifugal acceleration; a smaller quantity counts as zero


def slip_mode(sigma):
    """Return SKID for forward slip (v_t > 0), SPIN for over-rotation."""
    return SKID if sigma > 0 else SPIN


@inline
def slip_direction(mode):
    """Return σ = sign(v_t) of a slip mode, 0 for any other mode."""
    if mode == SKID:
        return 1
    if mode == SPIN:
        return -1
    return 0


@noinline
def opening_sign(body, th, om):
    """Return the sign of f_n, or of its first nonzero derivative in free motion."""
    s, c = sine_and_cosine(th)
    u = om * om
    scale = body.gn + body.eps * u
    sign = sign_beyond(free_acceleration(body, s, c, u)[1], TIE * scale)
    if sign == 0:
        sign = sign_beyond(-body.eps * s * om * u, TIE * scale * abs(om))
    if sign == 0:
        sign = sign_beyond(-body.eps * c * u * u, TIE * scale * u)
    return sign


@noinline
def can_roll(body, th, om):
    """Return True if rolling from this state has N > 0 and abs(F) ≤ μs N, now or, in a tie, just after."""
    s, c = sine_and_cosine(th)
    u = om * om
    friction, normal = rolling_forces(body, s, c, om * om, resistance_arm(body, s, c, om, 0))
    a, b = cone_weights(body.mu_s)
    tie = TIE * (body.gn + abs(body.gt) + u)
    margin = a * normal - b * abs(friction)
    # with little friction a small force decides, enough to start a light ring; above its own rounding this is no tie
    close = min(tie, TIE * (a * abs(normal) + b * abs(friction)) + ROUNDING * (body.gn + abs(body.gt) + u))
    pressed, held = sign_beyond(normal, tie), sign_beyond(margin, close)
    if pressed > 0 and held > 0:
        return True
    if pressed < 0 or held < 0:
        return False
    series_n, series_p, series_m, _ = candidate_series(body, th, om, 0)
    scale = body.gn + abs(body.gt) + u
    return leading_sign(series_n, scale) > 0 and leading_sign(series_p, scale) >= 0 and leading_sign(series_m, scale) >= 0


@noinline
def can_start_slip(body, th, om, sigma):
    """Return True if slip of direction σ can start from v_t = 0: N > 0 and σ v̇_t > 0."""
    s, c = sine_and_cosine(th)
    u = om * om
    scale = body.gn + abs(body.gt) + u
    tie = TIE * scale
    stiffness = kappa_p_sigma(body, s, c, sigma, resistance_arm(body, s, c, om, sigma))
    if stiffness <= 0.0:
        return False
    # N = κ load / stiffness; as κ → 0 the load, not N, must exceed its rounding
    load = body.gn - body.eps * c * u
    slip = slip_motion(body, s, c, om * om, sigma, resistance_arm(body, s, c, om, sigma))[2]
    pressed, starts = sign_beyond(load, tie), sigma * sign_beyond(slip, tie)
    if pressed < 0 or starts < 0:
        return False
    if pressed > 0 and starts > 0:
        return True
    series_n, _, _, series_v = candidate_series(body, th, om, sigma)
    return leading_sign(series_n, scale * body.kap / stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0


@noinline
def frictionless_mode(body, th, th_low, om):
    """Return the mode from v_t = 0 without friction, by the sign of v̇_t, exact also near an equilibrium.

    On the level v̇_t is s times a factor that is not near zero close to an equilibrium, so sin θ gives its sign.
    """
    s, c = sine_cosine(th, th_low)
    u = om * om
    if body.gt == 0.0 and body.resist == 0.0:
        bend = body.eps * (u - (body.gn - body.eps * c * u) * (1.0 + body.eps * c) / (body.kap + body.eps * s * body.eps * s))
        drive = s * bend if s != 0.0 else om * c * bend
    else:
        drive = slip_motion(body, s, c, om * om, 0, resistance_arm(body, s, c, om, 0))[2]
    sign = sign_beyond(drive, 0.0)
    return ROLL if sign == 0 else slip_mode(sign)


@noinline
def next_mode(body, th, th_low, om, vt):
    """Return the mode that follows a state in contact (y = 0, v_n = 0): rules 1, 3 and 4.

    Returns INCONSISTENT or INDETERMINATE instead of a mode if Painlevé's paradox occurs, UNDECIDED if the model has no answer.
    """
    if vt == 0.0 and body.mu_s == 0.0 and opening_sign(body, th, om) < 0:
        return frictionless_mode(body, th, th_low, om)
    if vt == 0.0:
        if can_roll(body, th, om):
            return ROLL
        if not math.isinf(body.mu_k):
            for sigma in (-1, 1):
                if can_start_slip(body, th, om, sigma):
                    return slip_mode(sigma)
        if opening_sign(body, th, om) >= 0:
            return FLIGHT
        if math.isinf(body.mu_k):
            return UNDECIDED  # rolling needs N < 0, and free motion would penetrate the plane
        # for f_n < 0 exactly one of roll and slip exists, and rounding hides which
        s, c = sine_and_cosine(th)
        friction, normal = rolling_forces(body, s, c, om * om, resistance_arm(body, s, c, om, 0))
        a, b = cone_weights(body.mu_s)
        if a * normal >= b * abs(friction):
            return ROLL
        return slip_mode(-1 if friction > 0.0 else 1)
    sigma = 1 if vt > 0.0 else -1
    s, c = sine_and_cosine(th)
    opening = opening_sign(body, th, om)
    if math.isinf(body.mu_k):  # infinite friction stops any slip at once
        return FLIGHT if opening >= 0 else INCONSISTENT
    rho = resistance_arm(body, s, c, om, sigma)
    _, stiffness = slip_coefficients(body, s, c, sigma, rho)
    if stiffness > 0.0:
        return slip_mode(sigma) if opening < 0 else FLIGHT
    if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening < 0 or body.painleve_impact):
        return UNDECIDED  # an impact, which has no rolling resistance, would change nothing
    if opening < 0:
        return INCONSISTENT
    return INDETERMINATE if stiffness < 0.0 else FLIGHT
