"""Where double precision cannot tell what follows: a quantity that decides is zero but for the rounding of the motion.

A doubt is noted, and the motion goes on with what the doubles say. `hophoop.simulation.exact_start` takes the decision in more
digits, where someone asks.
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

CLOSE = 1e-11  # beside the natural size of a quantity: nearer to zero it may be on either side
NEARBY = 0.015  # of the range of a margin on a panel: half the distance of two nodes, squared, beside half the panel


@inline
def note_doubt(scratch, begin, end):
    """Keep the times of the first doubt of a motion."""
    if math.isnan(scratch.doubt[0]):
        scratch.doubt[0] = begin
        scratch.doubt[1] = end


@apart
def mode_is_in_doubt(body, state):
    """Whether the mode that follows a state in contact depends on the rounding of the state."""
    if body.kap == 0.0 or body.mu_s == 0.0 or math.isinf(body.mu_s):
        return False
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    scale = body.gn + abs(body.gt) + u
    if scale == 0.0:
        return False
    opening = abs(free_acceleration(body, s, c, u)[1])
    if state.vt != 0.0:
        # p_σ = 0 is left to the doubles: beside it the force has no bound, and the longer computation no end
        return opening <= CLOSE * (body.gn + body.eps * u)
    friction, normal = rolling_forces(body, s, c, state.om * state.om, resistance_arm(body, s, c, state.om, 0))
    a, b = cone_weights(body.mu_s)
    margin = a * normal - b * abs(friction)
    if abs(margin) <= CLOSE * scale or abs(normal) <= CLOSE * scale:
        return True
    return margin < 0.0 and opening <= CLOSE * scale


@apart
def grazes_zero(row, scale, scratch):
    """Whether the smallest value of a margin on a panel is zero but for rounding."""
    series = scratch.series
    rate = scratch.values[1]
    coefficients(row, series)
    # minus the derivative, which falls where the margin is smallest
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
def has_graze(body, panel, state, scratch):
    """Whether a margin of the phase has a smallest value on the panel that is zero but for rounding."""
    speed = abs(panel.vt) + abs(state.om)
    scale = body.gn + panel.u
    if panel.sigma == 0:
        scale += abs(body.gt)
        speed = scale
    return grazes_zero(scratch.work[A], scale, scratch) or grazes_zero(scratch.work[B], speed, scratch)
