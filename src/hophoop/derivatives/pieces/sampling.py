"""Derivatives of the state at any time."""

from __future__ import annotations

import numpy as np

from hophoop.derivatives.events.massless import skim_rates
from hophoop.derivatives.layout import T
from hophoop.derivatives.pieces.flight_and_rest import accelerations, step_along
from hophoop.derivatives.pieces.panels import prepare_panel
from hophoop.derivatives.pieces.pieces import follow_prepared, follow_without_panel, is_panel
from hophoop.kernel.panels.panel import FLY, HOLD, SKIMMING, TIME, Totals, fill_inside, no_panel
from hophoop.kernel.records.writing import panel_of
from hophoop.kernel.rigid.panel_choice import solve
from hophoop.kernel.rigid.sampling import find_segment, xi_at_time

STATE = ("x", "height", "theta", "omega", "slip", "vy")


def sample_changes(body, segments, at_segments, changes, clock, times, left, states, out, scratch, local):
    """Fill `states`, shape (times, 6), and `out`, shape (times, CARRIED, directions), with the motion at these times.

    `clock` is by how much each direction changes a time, per unit of it.
    """
    z = np.empty(at_segments.shape[1:])
    solved = -1
    totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    panel = no_panel(FLY, 0, 0.0)
    for i in range(times.shape[0]):
        index = find_segment(segments, times[i], left)
        row = segments[index]
        z[:] = at_segments[index]
        tau = (min(times[i], row["t_end"]) - row["t"]) - row["t_low"]
        if times[i] == row["t"]:
            tau = 0.0
        if is_panel(row):
            if index != solved:
                panel = panel_of(row)
                totals = solve(body, panel, scratch.work)
                prepare_panel(body, panel, row["omega"] * row["omega"], changes, scratch.work, local)
                solved = index
            fill_inside(panel, scratch.work)
            xi = xi_at_time(scratch.work[TIME], row, tau, scratch)
            end = follow_prepared(body, row, panel, totals, xi, changes, z, scratch, local)
        else:
            end = follow_without_panel(body, row, tau, changes, z)
        rates = (0.0, 0.0, 0.0, 0.0)
        if row["kind"] != SKIMMING and not (row["kind"] == HOLD and row["sigma"] == 0):
            rates = accelerations(body, row["mode"], end, row["way"])
        elif row["kind"] == SKIMMING:
            rates = skim_rates(body, end)
        for k in range(z.shape[1]):
            step_along(z, k, clock[k] * times[i] - z[T, k], end, rates)
        out[i] = z
        states[i, 0] = end.x
        states[i, 1] = end.y
        states[i, 2] = end.th + end.th_low
        states[i, 3] = end.om
        states[i, 4] = end.vt
        states[i, 5] = end.vn
