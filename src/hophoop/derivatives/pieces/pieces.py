"""Propagate derivatives from the start of a piece of a motion to a place in it."""

from __future__ import annotations

import math

from hophoop.derivatives.events.massless import follow_skim
from hophoop.derivatives.layout import OM
from hophoop.derivatives.pieces.flight_and_rest import accelerations, follow_flight, follow_hold, step_along
from hophoop.derivatives.pieces.panels import Stretch, follow_panel, prepare_panel
from hophoop.kernel.native import noinline
from hophoop.kernel.records import panel_of, state_of
from hophoop.kernel.steps import (
    FLY,
    HOLD,
    LEAVE,
    SKIMMING,
    fill_inside,
    solve,
    state_in_flight,
    state_in_skim,
    state_on_panel,
    state_without_rotation,
)


@noinline
def follow_without_panel(body, row, tau, parameter_tangents, tangents):
    """Propagate all directions to the time tau after the start of a piece without panel; return the state there."""
    begin = state_of(row)
    if row["kind"] == FLY:
        end = state_in_flight(body, row["f_n"], begin, tau)
        follow_flight(body, row["f_n"], begin, tau, parameter_tangents, tangents)
    elif row["kind"] == HOLD:
        end = state_without_rotation(body, row["sigma"], begin, begin.t + tau, tau)
        follow_hold(body, row["sigma"], begin, end, tau, parameter_tangents, tangents)
    else:
        end = state_in_skim(body, row["direction"], begin, begin.t + tau, tau, False)[0]
        follow_skim(body, begin, row["direction"], tau, tangents)
    return end


@noinline
def turn_at_begin(body, mode, begin, tangents):
    """At a turning point, express the perturbation as a shift of the angle of rest rather than of time."""
    for k in range(tangents.shape[1]):
        if tangents[OM, k] != 0.0:
            rates = accelerations(body, mode, begin, math.copysign(1.0, tangents[OM, k]))
            step_along(tangents, k, -tangents[OM, k] / rates[0], begin, rates)
            tangents[OM, k] = 0.0


@noinline
def follow_prepared(body, row, panel, totals, xi, parameter_tangents, tangents, workspace):
    """Propagate all directions to ξ of a prepared panel; returns the state there."""
    scratch = workspace.scratch
    begin = state_of(row)
    if -1.0 < xi < 1.0:
        fill_inside(panel, scratch.work)
    end = state_on_panel(body, panel, totals, begin, xi, scratch)
    if panel.kind == LEAVE:
        turn_at_begin(body, row["mode"], begin, tangents)
    if xi > -1.0:
        follow_panel(body, Stretch(panel, xi, begin, end), parameter_tangents, tangents, workspace)
    return end


@noinline
def is_panel(row):
    """Return True if a piece is a panel."""
    return row["kind"] != FLY and row["kind"] != HOLD and row["kind"] != SKIMMING


@noinline
def length_of(row):
    """Return the duration of a piece."""
    return (row["t_end"] - row["t"]) - row["t_low"]


@noinline
def is_before(t, t_low, row):
    """Return True if a time of two doubles is before an event."""
    return (t - row["t"]) + (t_low - row["t_low"]) < 0.0


@noinline
def follow_piece(body, row, parameter_tangents, tangents, workspace):
    """Propagate all directions over a whole piece; returns the state at its end."""
    if is_panel(row):
        panel = panel_of(row)
        totals = solve(body, panel, workspace.scratch.work)
        prepare_panel(body, panel, parameter_tangents, workspace)
        return follow_prepared(body, row, panel, totals, row["xi"], parameter_tangents, tangents, workspace)
    tau = length_of(row)
    return follow_without_panel(body, row, tau, parameter_tangents, tangents)
