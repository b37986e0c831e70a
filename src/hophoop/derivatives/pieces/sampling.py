"""Derivatives of the state at any time."""

from __future__ import annotations

import numpy as np

from hophoop.derivatives.layout import T
from hophoop.derivatives.pieces.flight_and_rest import accelerations, step_along
from hophoop.derivatives.pieces.panels import prepare_panel
from hophoop.derivatives.pieces.pieces import follow_prepared, follow_without_panel, is_panel
from hophoop.kernel.records import find_segment, panel_of
from hophoop.kernel.steps import FLY, HOLD, TIME, Totals, fill_inside, no_panel, solve, xi_at_time


def sample_tangents(body, pieces, clock, times, left, samples, workspace):
    """Fill in the motion and its tangents at some times.

    `clock` is the change of the unit of time in each direction, over the unit.
    """
    segments, at_segments, parameter_tangents = pieces
    states = samples.states
    scratch = workspace.scratch
    tangents = np.empty(at_segments.shape[1:])
    solved = -1
    totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    panel = no_panel(FLY, 0, 0.0)
    for i in range(times.shape[0]):
        index = find_segment(segments["t"], times[i], left)
        row = segments[index]
        tangents[:] = at_segments[index]
        tau = (min(times[i], row["t_end"]) - row["t"]) - row["t_low"]
        if times[i] == row["t"]:
            tau = 0.0
        if is_panel(row):
            if index != solved:
                panel = panel_of(row)
                totals = solve(body, panel, scratch.work)
                prepare_panel(body, panel, parameter_tangents, workspace)
                solved = index
            fill_inside(panel, scratch.work)
            xi = xi_at_time(scratch.work[TIME], row, tau, scratch)
            end = follow_prepared(body, row, panel, totals, xi, parameter_tangents, tangents, workspace)
        else:
            end = follow_without_panel(body, row, tau, parameter_tangents, tangents)
        rates = (0.0, 0.0, 0.0, 0.0)
        if not (row["kind"] == HOLD and row["sigma"] == 0):
            rates = accelerations(body, row["mode"], end, row["direction"])
        for k in range(tangents.shape[1]):
            step_along(tangents, k, clock[k] * times[i] - tangents[T, k], end, rates)
        samples.tangents[i] = tangents
        for column, value in enumerate((end.x, end.y, end.th + end.th_low, end.om, end.vt, end.vn)):
            states[i, column] = value
