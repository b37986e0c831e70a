"""Events on a panel of rolling or slip: the friction cone, lift-off, the end of slip, limits."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.collocation import (
    NOT_FOUND,
    ORDER,
    PARTS,
    antiderivative,
    coefficients,
    extremes,
    first_downcrossing,
    first_downcrossing_after,
    margin_downcrossing,
    series_value,
)
from hophoop.kernel.panels.panel import (
    ARRIVE,
    BACKWARD_MARGIN,
    COSINE,
    FORWARD_MARGIN,
    LIFT_OFF_MARGIN,
    RATE,
    SINE,
    SLIP,
    SLIP_END_MARGIN,
    TIME,
    TIME_LEFT,
    U,
    xi_of_offset,
)
from hophoop.kernel.physics.contact import cone_weights, rolling_forces
from hophoop.kernel.records.state import time_left
from hophoop.kernel.records.writing import record_doubt
from hophoop.kernel.rigid.phase import ROUNDING, Ending, angle_left

SMALLEST_SQUARE = 1e-290  # the square of a speed below this is close to underflow
MARGIN_ROUNDING = 4e-16  # rounding of the margin to the friction cone, relative to the forces
SIMULTANEOUS = 1e-13  # in ξ: events of a panel that are closer than this are simultaneous in double precision
TANGENCY_ROUNDING = 1e-14  # rounding of v_t in slip without friction, relative to the speeds
CLOSE = 1e-11  # relative to the natural size of a quantity; a smaller value may have either sign


@noinline
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


@noinline
def record_tangency(first, first_scale, second, second_scale, t, scratch):
    """Record a doubt if one of two margins on a panel has a minimum that is zero within rounding of its scale."""
    if touches_zero(first, first_scale, scratch) or touches_zero(second, second_scale, scratch):
        record_doubt(scratch.doubt, t)


@inline
def fill_cone_margins(body, panel, work):
    """Fill the margins to both sides of the friction cone, positive inside."""
    a, b = cone_weights(body.mu_s)
    rho = panel.direction * body.resist
    for i in range(ORDER):
        friction, normal = rolling_forces(body, work[SINE, i], work[COSINE, i], work[U, i], rho)
        work[FORWARD_MARGIN, i] = a * normal - b * friction
        work[BACKWARD_MARGIN, i] = a * normal + b * friction


@inline
def end_of_rolling(body, panel, state, begins, scratch):
    """Return (ξ, ending) where rolling needs all available friction; ξ is NOT_FOUND if it does not."""
    forward, backward = scratch.work[FORWARD_MARGIN], scratch.work[BACKWARD_MARGIN]
    fill_cone_margins(body, panel, scratch.work)
    scale = body.gn + panel.u + abs(body.gt)
    rounding = MARGIN_ROUNDING * (body.gn + abs(body.gt) + panel.u)
    ahead, near_ahead = margin_downcrossing(forward, begins, rounding, scratch)
    back, near_back = margin_downcrossing(backward, begins, rounding, scratch)
    if (near_ahead or near_back) and 0.0 < body.mu_s < math.inf:
        record_tangency(forward, scale, backward, scale, state.t, scratch)
    # if N reaches zero without F, both margins do; the mirrored motion must then reach the mirrored side
    side = 1.0  # of F
    if back < ahead or (back == ahead and panel.direction < 0.0):
        side = -1.0
    return back if side < 0.0 else ahead, Ending.CONE_BACKWARD if side < 0.0 else Ending.CONE_FORWARD


@noinline
def tangency_rounding(body, state):
    """Return the rounding of v_t in slip without friction, from the speeds since the last unstable equilibrium.

    Descending, the load gains at most 4 ε g_n, all of it in rotation at the bottom, where the arm of θ̇ is 1 − ε.
    """
    fallen = body.eps * body.gn
    lowest = (1.0 - body.eps) * math.sqrt(4.0 * fallen / body.kap) if body.kap > 0.0 else 0.0
    return TANGENCY_ROUNDING * (abs(state.vt) + abs(state.om) + 2.0 * math.sqrt(fallen) + lowest)


@inline
def end_of_slip(body, panel, state, begins, vanishing, scratch):
    """Return (ξ, ending) where N or v_t reaches zero, lift-off if both do; ξ is NOT_FOUND if none does.

    `vanishing` is the number of derivatives of v_t that vanish at the start of the phase.
    """
    work = scratch.work
    lift_off, slip_end = work[LIFT_OFF_MARGIN], work[SLIP_END_MARGIN]
    for i in range(ORDER):
        lift_off[i] = body.gn - body.eps * work[COSINE, i] * work[U, i]
        slip_end[i] = panel.sigma * work[SLIP, i]
    if begins:
        for _ in range(vanishing):
            for i in range(ORDER):
                slip_end[i] /= PARTS[i]
    lift, near_lift = margin_downcrossing(lift_off, begins, 0.0, scratch)
    # without friction v_t only touches zero at each unstable equilibrium, if it was zero at one
    rounding = tangency_rounding(body, state) if body.mu_k == 0.0 else 0.0
    stop, near_stop = margin_downcrossing(slip_end, begins, rounding, scratch)
    if body.mu_k > 0.0 and (near_lift or (near_stop and not begins)):
        record_tangency(lift_off, body.gn + panel.u, slip_end, abs(panel.vt) + abs(state.om), state.t, scratch)
    if begins and vanishing == 0 and slip_end[0] < 0.0:
        stop = -1.0  # the square of v_t underflows, or the panel would be narrower
    elif begins and vanishing > 0 and body.mu_k == 0.0 and stop == NOT_FOUND and extremes(slip_end)[1] < 0.0:
        stop = -1.0  # without friction rounding of θ may decide the direction of slip; here it is the other one
    if stop != NOT_FOUND and lift != NOT_FOUND and abs(stop - lift) < CLOSE and body.mu_k > 0.0:
        record_doubt(scratch.doubt, state.t)
    if stop < lift - SIMULTANEOUS:
        return stop, Ending.SLIP_END
    return lift, Ending.LIFT_OFF


@inline
def end_of_span(panel, state, limits):
    """Return ξ where θ has changed by the span, or NOT_FOUND."""
    ahead = angle_left(limits, state, panel.direction)
    reach = panel.extent + ROUNDING if panel.kind == ARRIVE else panel.extent  # a turn at this angle counts
    if not ahead <= reach:  # also if the span is nan
        return NOT_FOUND
    if not ahead > 0.0:
        return -1.0  # an event was exactly at this angle
    return xi_of_offset(panel, max(panel.extent - ahead, 0.0) if panel.kind == ARRIVE else ahead)


@inline
def end_of_time(left, scratch):
    """Return ξ where the time is over, on a panel that lasts that long."""
    if left <= 0.0:
        return -1.0
    work = scratch.work
    antiderivative(work[RATE], work[TIME])
    for i in range(ORDER):
        work[TIME_LEFT, i] = left - work[TIME, i]
    coefficients(work[TIME_LEFT], scratch.series)
    found = first_downcrossing(scratch.series, 0.0, scratch.stack)
    return 1.0 if found == NOT_FOUND else found


@inline
def earliest_event(body, panel, totals, state, begins, vanishing, limits, scratch):
    """Return (ξ, ending) of the first event on the panel; (1, CONTINUES or TURNING_POINT) if there is none.

    Of simultaneous events those of the contact come before the limits of angle and time.
    """
    if panel.sigma == 0:
        xi, ending = end_of_rolling(body, panel, state, begins, scratch)
    else:
        xi, ending = end_of_slip(body, panel, state, begins, vanishing, scratch)
    if not math.isnan(limits.span):
        found = end_of_span(panel, state, limits)
        if found < xi:
            xi = found
            ending = Ending.ANGLE_LIMIT
    left = time_left(state, limits.t_end)
    if totals.time >= left:
        found = end_of_time(left, scratch)
        if found < xi:
            xi = found
            ending = Ending.TIME_LIMIT
    if xi == NOT_FOUND:
        return 1.0, Ending.TURNING_POINT if panel.kind == ARRIVE else Ending.CONTINUES
    return xi, ending
