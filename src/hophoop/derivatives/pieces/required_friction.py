"""The friction that rolling requires, abs(F)/N: its maxima inside a phase, and its changes."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import OM, TH, body_tangent
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.model import force_ratio, required_ratio, rolling_acceleration
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.records import panel_of, state_of
from hophoop.kernel.steps import COSINE, SINE, U, fill_inside, solve_noinline, state_on_panel

MOST_STEPS = 60  # towards a maximum
CONVERGED = 1e-14  # in ξ

d_force_ratio = tangent_of(force_ratio, "body", "s", "c", "u", "rho")
d_required_ratio = tangent_of(required_ratio, "body", "s", "c", "u", "rho")
d_required_ratio_on_path = tangent_of(required_ratio, "s", "c", "u")


@noinline
def requirement(body, s, c, u, way):
    """(abs(F)/N of rolling, its rate as the hoop turns on)."""
    rho = way * body.resist
    alpha = rolling_acceleration(body, s, c, u, rho)
    ratio, slope = d_required_ratio_on_path(body, s, c, u, rho, c, -s, 2.0 * alpha)
    return abs(ratio), way * math.copysign(1.0, ratio) * slope


def requirement_at(body, state, way):
    """The same of a state."""
    s, c = sine_cosine(state.th, state.th_low)
    return requirement(body, s, c, state.om * state.om, way)


@noinline
def peak_between(body, panel, totals, begin, low, high, slope_low, slope_high, scratch):
    """(abs(F)/N, time) of the maximum between two places of a solved panel, by the Illinois method."""
    need, state, slope = 0.0, begin, 0.0
    xi = low
    for _ in range(MOST_STEPS):
        before = xi
        xi = (low * slope_high - high * slope_low) / (slope_high - slope_low)
        if not low < xi < high:
            xi = 0.5 * (low + high)
        state = state_on_panel(body, panel, totals, begin, xi, scratch)
        last = slope
        need, slope = requirement_at(body, state, panel.direction)
        if abs(xi - before) <= CONVERGED or slope == 0.0:
            break
        if slope > 0.0:
            low, slope_low = xi, slope
            if last > 0.0:
                slope_high *= 0.5
        else:
            high, slope_high = xi, slope
            if last < 0.0:
                slope_low *= 0.5
    return need, state.t


def fill_peaks(body, segments, first, last, scratch, peaks):
    """Fill in (abs(F)/N, time) of the maxima inside a rolling phase, segments `first` to before `last`; return how many."""
    work = scratch.work
    count = 0
    before = 0.0  # rate of the last sample
    for index in range(first, last):
        row = segments[index]
        way = row["direction"]
        panel = panel_of(row)
        totals = solve_noinline(body, panel, work)
        fill_inside(panel, work)
        begin = state_of(row)
        if index == first:
            before = requirement_at(body, begin, way)[1]
        low = -1.0
        for i in range(ORDER + 1):
            if i < ORDER and NODES[i] >= row["xi"]:
                continue
            if i < ORDER:
                high = NODES[i]
                slope = requirement(body, work[SINE, i], work[COSINE, i], work[U, i], way)[1]
            else:
                high = row["xi"]
                known = index + 1 < last
                end = state_of(segments[index + 1]) if known else state_on_panel(body, panel, totals, begin, high, scratch)
                slope = requirement_at(body, end, way)[1]
            if before > 0.0 and not slope > 0.0 and count < peaks.shape[0]:
                found = peak_between(body, panel, totals, begin, low, high, before, slope, scratch)
                peaks[count, 0], peaks[count, 1] = found
                count += 1
            before = slope
            low = high
    return count


def use_changes(body, th, om, rho, tangents, parameter_tangents, larger, smaller):
    """Fill in how abs(F)/(μs N) changes in each direction at an angle of rolling, and to the other side."""
    s, c = sine_and_cosine(th)
    u = om * om
    ratio = required_ratio(body, s, c, u, rho)
    held = om == 0.0 and abs(rho) < body.resist
    if held:
        ratio = -body.gt / body.gn
    for k in range(tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        ds, dc, du = c * tangents[TH, k], -s * tangents[TH, k], 2.0 * om * tangents[OM, k]
        drho = math.copysign(1.0, rho if rho != 0.0 else om) * d_body.resist
        if held:
            change = -(d_body.gt + ratio * d_body.gn) / body.gn
        elif d_body.kap != 0.0:  # the massless hoop gets mass
            change = d_force_ratio(body, s, c, u, rho, d_body, ds, dc, du, drho)[1]
        else:
            change = d_required_ratio(body, s, c, u, rho, d_body, ds, dc, du, drho)[1]
        less = abs(ratio) * d_body.mu_s / (body.mu_s * body.mu_s)
        way = math.copysign(1.0, ratio if ratio != 0.0 else change)
        larger[k] = way * change / body.mu_s - less
        smaller[k] = larger[k] if ratio != 0.0 else -larger[k]
