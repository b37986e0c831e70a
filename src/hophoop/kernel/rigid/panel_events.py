"""What ends a panel of rolling or slip: the friction cone, lift-off, the end of slip, a limit."""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import ORDER, PARTS, antiderivative, coefficients, extremes, left_value
from hophoop.kernel.numerics.constants import NODES
from hophoop.kernel.numerics.roots import NOT_FOUND, first_downcrossing
from hophoop.kernel.numerics.trigonometry import rotated
from hophoop.kernel.panels.panel import (
    ARRIVE,
    COSINE,
    RATE,
    SLIP,
    TIME,
    A,
    B,
    U,
    angle_at,
    place_of,
    sine_versine_of_offset,
)
from hophoop.kernel.panels.roll import roll_margins, u_on_panel
from hophoop.kernel.physics.contact import cone_weights, rolling_forces
from hophoop.kernel.records.state import time_left
from hophoop.kernel.rigid.doubts import CLOSE, NEARBY, has_graze, note_doubt
from hophoop.kernel.rigid.ending import Ending
from hophoop.kernel.rigid.limits import angle_left

SMALLEST_SQUARE = 1e-290  # a smaller square of a speed is on the way to underflow
MARGIN_ROUNDING = 4e-16  # of the margin to the friction cone, beside the forces
MISPLACED = 5e-13  # of the forces: a margin to the friction cone that is not zero where that of its series is
NEXT = 1e-6  # of ξ: how far from there its slope is taken
# A margin whose values at the nodes stay this part of their range away from zero has none: between them and at the ends a
# function that the panel resolves goes beyond their range by less than a tenth of it.
FAR_FROM_ZERO = 0.25
SAME_PLACE = 1e-13  # of ξ: events of a panel that are nearer to each other come at once, for all that doubles show
GRAZE_ROUNDING = 1e-14  # of v_t in slip without friction, beside the speeds


@inline
def margin_downcrossing(row, state_is_fresh, floor, scratch):
    """Where in the panel a margin falls through zero; at its very start if it has fallen there already.

    Between −`floor` and `floor` a margin counts as the zero that it would be without rounding. One that starts there has fallen
    if the first node outside is below; so the sign of the rounding at the start decides nothing.

    Returns
    -------
    xi : float
    near : bool
        Whether the margin may touch zero between the nodes: a parabola that does has a node beside it as near as that.
    """
    lowest, highest = extremes(row)
    if lowest > FAR_FROM_ZERO * (highest - lowest):
        return NOT_FOUND, False
    near = abs(lowest) < NEARBY * (highest - lowest)
    coefficients(row, scratch.series)
    if not state_is_fresh:
        start = left_value(scratch.series)
        if start < -floor or (start <= 0.0 and floor == 0.0):
            return -1.0, near
        if start <= floor:
            for i in range(ORDER):
                if row[i] < -floor:
                    return -1.0, near
                if row[i] > floor:
                    break
    return first_downcrossing(scratch.series, floor, scratch.stack), near


@apart
def cone_margin(body, panel, side, xi):
    """(margin to a side of the friction cone, forces that it is a difference of) at ξ of rolling without rolling resistance."""
    offset = angle_at(panel, xi)
    sine, versine = sine_versine_of_offset(panel, xi)
    u = u_on_panel(body, panel, sine, versine, offset)
    ds, dc = rotated(panel.sine, panel.cosine, sine, versine)
    friction, normal = rolling_forces(body, panel.sine + ds, panel.cosine + dc, u, 0.0)
    a, b = cone_weights(body.mu_s)
    return a * normal - side * b * friction, body.gn + abs(body.gt) + u


@apart
def on_cone(body, panel, side, xi):
    """ξ where a margin is zero, from a zero of its series: of a light hoop it may be off by more than rounding.

    A panel is resolved in time, not in its forces.
    """
    margin, size = cone_margin(body, panel, side, xi)
    if not abs(margin) > MISPLACED * size:
        return xi
    further = xi - NEXT if xi > 0.0 else xi + NEXT
    slope = (cone_margin(body, panel, side, further)[0] - margin) / (further - xi)
    if not abs(margin) < NEXT * abs(slope):
        return xi
    better = min(max(xi - margin / slope, -1.0), 1.0)
    return better if abs(cone_margin(body, panel, side, better)[0]) < abs(margin) else xi


@inline
def end_of_rolling(body, panel, fresh, scratch):
    """(ξ, what, whether it may depend on rounding) where rolling needs all friction; NOT_FOUND where it does not."""
    work = scratch.work
    roll_margins(body, panel, work)
    rounding = MARGIN_ROUNDING * (body.gn + abs(body.gt) + panel.u)
    ahead, near_ahead = margin_downcrossing(work[A], fresh, rounding, scratch)
    back, near_back = margin_downcrossing(work[B], fresh, rounding, scratch)
    doubtful = (near_ahead or near_back) and 0.0 < body.mu_s < math.inf
    # both at once where N comes to zero without F: the mirrored motion must then come to the mirrored edge
    side = 1.0  # of F
    if back < ahead or (back == ahead and panel.way < 0.0):
        side = -1.0
    xi = back if side < 0.0 else ahead
    if -1.0 < xi < 1.0 and body.resist == 0.0:
        xi = on_cone(body, panel, side, xi)
    return xi, Ending.CONE_BACKWARD if side < 0.0 else Ending.CONE_FORWARD, doubtful


@apart
def graze_rounding(body, state):
    """Rounding of v_t in slip without friction, from the speeds that it has been through since the last hilltop.

    On the way down the load gains 4 ε g_n at most, all of it in the rotation at the bottom, where the arm of θ̇ is 1 − ε.
    """
    fallen = body.eps * body.gn
    lowest = (1.0 - body.eps) * math.sqrt(4.0 * fallen / body.kap) if body.kap > 0.0 else 0.0
    return GRAZE_ROUNDING * (abs(state.vt) + abs(state.om) + 2.0 * math.sqrt(fallen) + lowest)


@inline
def end_of_slip(body, panel, totals, state, fresh, zeros, scratch):
    """(ξ, what, whether it may depend on rounding) where N or v_t comes to zero; lift-off where both do."""
    work = scratch.work
    for i in range(ORDER):
        work[A, i] = body.gn - body.eps * work[COSINE, i] * work[U, i]
        work[B, i] = panel.sigma * work[SLIP, i]
    if fresh:
        for _ in range(zeros):
            for i in range(ORDER):
                work[B, i] /= PARTS[i]
    lift, near_lift = margin_downcrossing(work[A], fresh, 0.0, scratch)
    # without friction v_t comes back to zero at each hilltop, if it was zero at one, and touches it only
    rounding = graze_rounding(body, state) if body.mu_k == 0.0 else 0.0
    stop, near_stop = margin_downcrossing(work[B], fresh, rounding, scratch)
    doubtful = body.mu_k > 0.0 and (near_lift or (near_stop and not fresh))
    if fresh and zeros == 0 and work[B, 0] < 0.0 and (stop > NODES[0] or state.vt * state.vt < SMALLEST_SQUARE):
        stop = -1.0  # slip that ends before it can be told from none on the panel
    elif fresh and zeros > 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(work[B])[1] < 0.0:
        stop = -1.0  # the other direction: without friction the rounding of θ may decide where slip begins
    if stop != NOT_FOUND and lift != NOT_FOUND and abs(stop - lift) < CLOSE and body.mu_k > 0.0:
        note_doubt(scratch, state.t, state.t + totals.time)
    if stop < lift - SAME_PLACE:
        return stop, Ending.SLIP_END, doubtful
    return lift, Ending.LIFT_OFF, doubtful


@inline
def end_of_span(panel, state, limits):
    """ξ where the motion has turned by its span, or NOT_FOUND."""
    ahead = angle_left(limits, state, panel.way)
    if not ahead <= panel.extent:  # also without a span
        return NOT_FOUND
    if not ahead > 0.0:
        return -1.0  # an event fell on the angle itself
    return place_of(panel, panel.extent - ahead if panel.kind == ARRIVE else ahead)


@inline
def end_of_time(left, scratch):
    """ξ where the time is over on a panel that lasts that long."""
    if left <= 0.0:
        return -1.0
    work = scratch.work
    antiderivative(work[RATE], work[TIME])
    for i in range(ORDER):
        work[A, i] = left - work[TIME, i]
    coefficients(work[A], scratch.series)
    found = first_downcrossing(scratch.series, 0.0, scratch.stack)
    return 1.0 if found == NOT_FOUND else found


@inline
def earliest_event(body, panel, totals, state, fresh, blind, zeros, limits, scratch):
    """(ξ, what) of the first event on the panel; ξ = 1 with CONTINUES or TURNING_POINT where there is none.

    Of simultaneous events those of the contact come before the limits of angle and time.
    """
    xi = NOT_FOUND
    what = Ending.CONTINUES
    if not blind:
        if panel.sigma == 0:
            xi, what, doubtful = end_of_rolling(body, panel, fresh, scratch)
        else:
            xi, what, doubtful = end_of_slip(body, panel, totals, state, fresh, zeros, scratch)
        if doubtful and has_graze(body, panel, state, scratch):
            note_doubt(scratch, state.t, state.t + totals.time)
    if not math.isnan(limits.span):
        found = end_of_span(panel, state, limits)
        if found < xi:
            xi = found
            what = Ending.ANGLE_LIMIT
    left = time_left(state, limits.t_end)
    if totals.time >= left:
        found = end_of_time(left, scratch)
        if found < xi:
            xi = found
            what = Ending.TIME_LIMIT
    if xi == NOT_FOUND:
        return 1.0, Ending.TURNING_POINT if panel.kind == ARRIVE else Ending.CONTINUES
    return xi, what
