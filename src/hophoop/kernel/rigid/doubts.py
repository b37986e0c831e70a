"""Detection of doubts: a deciding quantity is zero within the rounding of the motion, so that double precision cannot decide.

The kernel records the time of the first doubt and continues with the values in double precision, by the written order of ties.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import ORDER, coefficients, series_value
from hophoop.kernel.numerics.roots import NOT_FOUND, first_downcrossing_after
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.panels.panel import A, B
from hophoop.kernel.physics.contact import cone_weights, free_acceleration, rolling_forces
from hophoop.kernel.physics.resistance import resistance_arm

CLOSE = 1e-11  # relative to the natural size of a quantity; a smaller value may have either sign
NEARBY = 0.015  # relative to the range of a margin on a panel: (half the distance of two nodes)² / half the panel's width


@inline
def record_doubt(scratch, t):
    """Record the time of the first doubt of a motion."""
    if math.isnan(scratch.doubt[0]):
        scratch.doubt[0] = t


@apart
def mode_is_in_doubt(body, state):
    """Return True if rounding of a state in contact may decide the mode that follows."""
    if body.kap == 0.0 or body.mu_s == 0.0 or math.isinf(body.mu_s):
        return False
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    scale = body.gn + abs(body.gt) + u
    if scale == 0.0:
        return False
    opening = abs(free_acceleration(body, s, c, u)[1])
    if state.vt != 0.0:
        # p_σ ≈ 0 is left to double precision: the force is unbounded there, and extended precision would never finish
        return opening <= CLOSE * (body.gn + body.eps * u)
    friction, normal = rolling_forces(body, s, c, state.om * state.om, resistance_arm(body, s, c, state.om, 0))
    a, b = cone_weights(body.mu_s)
    margin = a * normal - b * abs(friction)
    if abs(margin) <= CLOSE * scale or abs(normal) <= CLOSE * scale:
        return True
    return margin < 0.0 and opening <= CLOSE * scale


@apart
def touches_zero(row, scale, scratch):
    """Return True if a local minimum of a margin on a panel is zero within rounding."""
    series = scratch.series
    rate = scratch.values[1]
    coefficients(row, series)
    # minus the derivative; it has a downcrossing at each minimum of the margin
    after = 0.0
    here = 0.0
    for k in range(ORDER - 1, 0, -1):
        before = after - 2.0 * k * series[k]
        after = here
        here = before
        rate[k - 1] = before
    rate[0] *= 0.5
    rate[ORDER - 1] = 0.0
    begin = -2.0
    for _ in range(4):
        xi = first_downcrossing_after(rate, begin, 0.0, scratch.stack)
        if xi == NOT_FOUND:
            return False
        if abs(series_value(series, xi)) <= CLOSE * scale:
            return True
        begin = xi
    return False


@apart
def has_tangency(body, panel, state, scratch):
    """Return True if a margin of the phase has a minimum on the panel that is zero within rounding."""
    speed = abs(panel.vt) + abs(state.om)
    scale = body.gn + panel.u
    if panel.sigma == 0:
        scale += abs(body.gt)
        speed = scale
    return touches_zero(scratch.work[A], scale, scratch) or touches_zero(scratch.work[B], speed, scratch)
