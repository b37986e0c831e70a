"""The friction that rolling requires, abs(F)/N: its maxima inside a phase, and its changes."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import OM, STILL, TH, body_tangent
from hophoop.derivatives.transform import tangent_of
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import fill_inside
from hophoop.kernel.physics.contact import force_ratio, required_ratio, rolling_acceleration
from hophoop.kernel.records.writing import panel_of, state_of
from hophoop.kernel.rigid.contact_phase import state_on_panel
from hophoop.kernel.rigid.panel_choice import solve_noinline

HALVINGS = 60

d_force_ratio = tangent_of(force_ratio, "body", "s", "c", "u", "rho")
d_required_ratio = tangent_of(required_ratio, "body", "s", "c", "u", "rho")


@noinline
def requirement(body, state, way):
    """(abs(F)/N of a rolling state, True if it rises as the hoop turns on)."""
    s, c = sine_cosine(state.th, state.th_low)
    u = state.om * state.om
    rho = way * body.resist
    alpha = rolling_acceleration(body, s, c, u, rho)
    ratio, slope = d_required_ratio(body, s, c, u, rho, STILL, c, -s, 2.0 * alpha, 0.0)
    return abs(ratio), way * math.copysign(1.0, ratio) * slope > 0.0


def fill_peaks(body, segments, first, last, scratch, peaks):
    """Fill in (abs(F)/N, time) of the maxima inside a rolling phase, segments `first` to before `last`; return how many."""
    count = 0
    rises = False
    for index in range(first, last):
        row = segments[index]
        panel = panel_of(row)
        totals = solve_noinline(body, panel, scratch.work)
        fill_inside(panel, scratch.work)
        begin = state_of(row)
        low = -1.0
        for i in range(ORDER + 2):
            high = -1.0 if i == 0 else min(NODES[i - 1], row["xi"]) if i <= ORDER else row["xi"]
            need, goes_on = requirement(body, state_on_panel(body, panel, totals, begin, high, scratch), row["direction"])
            if rises and not goes_on and count < peaks.shape[0]:
                end = high
                state = begin
                for _ in range(HALVINGS):
                    middle = 0.5 * (low + end)
                    state = state_on_panel(body, panel, totals, begin, middle, scratch)
                    need, above = requirement(body, state, row["direction"])
                    if above:
                        low = middle
                    else:
                        end = middle
                peaks[count, 0] = need
                peaks[count, 1] = state.t
                count += 1
            rises = goes_on
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
        if ratio == 0.0:
            larger[k] = abs(change) / body.mu_s - less
            smaller[k] = -abs(change) / body.mu_s - less
        else:
            larger[k] = math.copysign(1.0, ratio) * change / body.mu_s - less
            smaller[k] = larger[k]
