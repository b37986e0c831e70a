"""The rule that selects the next mode, at the start and after every event (docs/model.md#which-mode-follows)."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.contact import cone_weights, free_acceleration, rolling_forces, slip_motion, slip_stiffness
from hophoop.kernel.physics.jets import candidate_series, leading_sign
from hophoop.kernel.physics.painleve import slip_coefficients
from hophoop.kernel.physics.resistance import resistance_arm

ROLL, SPIN, SKID, FLIGHT = int(Mode.ROLL), int(Mode.SPIN), int(Mode.SKID), int(Mode.FLIGHT)
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


@apart
def opening_sign(body, th, om):
    """Return the sign of f_n, or of its first nonzero derivative in free motion."""
    s, c = sine_and_cosine(th)
    u = om * om
    scale = body.gn + body.eps * u
    f_n = free_acceleration(body, s, c, u)[1]
    if abs(f_n) > TIE * scale:
        return 1 if f_n > 0.0 else -1
    first = -body.eps * s * om * u
    if abs(first) > TIE * scale * abs(om):
        return 1 if first > 0.0 else -1
    second = -body.eps * c * u * u
    if abs(second) > TIE * scale * u:
        return 1 if second > 0.0 else -1
    return 0


@apart
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
    if normal > tie and margin > close:
        return True
    if normal < -tie or margin < -close:
        return False
    series_n, series_p, series_m, _ = candidate_series(body, th, om, 0)
    scale = body.gn + abs(body.gt) + u
    return leading_sign(series_n, scale) > 0 and leading_sign(series_p, scale) >= 0 and leading_sign(series_m, scale) >= 0


@apart
def can_start_slip(body, th, om, sigma):
    """Return True if slip of direction σ can start from v_t = 0: N > 0 and σ v̇_t > 0."""
    s, c = sine_and_cosine(th)
    u = om * om
    scale = body.gn + abs(body.gt) + u
    tie = TIE * scale
    stiffness = slip_stiffness(body, s, c, sigma, resistance_arm(body, s, c, om, sigma))
    if stiffness <= 0.0:
        return False
    # N = κ load / stiffness; as κ → 0 the load, not N, must exceed its rounding
    load = body.gn - body.eps * c * u
    slip = slip_motion(body, s, c, om * om, sigma, resistance_arm(body, s, c, om, sigma))[2]
    if load < -tie or sigma * slip < -tie:
        return False
    if load > tie and sigma * slip > tie:
        return True
    series_n, _, _, series_v = candidate_series(body, th, om, sigma)
    return leading_sign(series_n, scale * body.kap / stiffness) > 0 and sigma * leading_sign(series_v, scale) > 0


@apart
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
    if drive == 0.0:
        return ROLL
    return slip_mode(1 if drive > 0.0 else -1)


@apart
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
    _, stiffness = slip_coefficients(body, th, th_low, s, c, sigma, rho)
    if stiffness > 0.0:
        return slip_mode(sigma) if opening < 0 else FLIGHT
    if rho != 0.0 and stiffness + body.eps * s * rho > 0.0 and (opening < 0 or body.strike):
        return UNDECIDED  # an impact, which has no rolling resistance, would change nothing
    if opening < 0:
        return INCONSISTENT
    return INDETERMINATE if stiffness < 0.0 else FLIGHT
