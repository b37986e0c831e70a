"""One piece of a motion, as it is written, with its derivatives carried from its begin to a place in it."""

from __future__ import annotations

import math

from hophoop.derivatives.events.massless import follow_skim
from hophoop.derivatives.layout import OM
from hophoop.derivatives.pieces.flight_and_rest import accelerations, follow_flight, follow_hold, step_along
from hophoop.derivatives.pieces.panels import follow_panel, prepare_panel
from hophoop.kernel.native import apart
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.panels.panel import FLY, HOLD, LEAVE, SKIMMING, fill_inside
from hophoop.kernel.physics.flight import flight_displacement, flight_gap
from hophoop.kernel.physics.massless import skim_state
from hophoop.kernel.records.state import flown, moved, with_velocities
from hophoop.kernel.records.writing import panel_of, state_of
from hophoop.kernel.rigid.contact_phase import state_on_panel
from hophoop.kernel.rigid.panel_choice import solve


@apart
def held(body, row, begin, tau):
    """The state after the time tau of rest, or of slip without rotation."""
    after = moved(begin, begin.t + tau, 0.0, begin.x, begin.x_low, 0.0, begin.turns, begin.th, begin.th_low)
    return with_velocities(after, begin.vt + row["opening"] * tau, 0.0, 0.0)


@apart
def fallen(body, row, begin, tau):
    """The state after the time tau of a flight."""
    s, c = sine_cosine(begin.th, begin.th_low)
    y, vn = flight_gap(body, s, c, begin.om, begin.y, begin.vn, row["opening"], tau)
    along, vt = flight_displacement(body, begin.vt, begin.om, s, c, tau)
    return flown(begin, along, max(y, 0.0), tau, vt, vn)


@apart
def skimmed(body, row, begin, tau):
    """The state after the time tau of skimming."""
    x, th, vt, om = skim_state(body, begin.x, begin.th, begin.vt, begin.om, row["way"], tau)
    after = moved(begin, begin.t + tau, 0.0, x, 0.0, 0.0, begin.turns, th, 0.0)
    return with_velocities(after, vt, 0.0, om)


@apart
def follow_without_panel(body, row, tau, changes, z):
    """Carry all directions to the time tau after the begin of a piece that needs no panel; returns the state there."""
    begin = state_of(row)
    if row["kind"] == FLY:
        end = fallen(body, row, begin, tau)
        follow_flight(body, row["opening"], begin, end, tau, changes, z)
    elif row["kind"] == HOLD:
        end = held(body, row, begin, tau)
        follow_hold(body, row["sigma"], begin, end, tau, changes, z)
    else:
        end = skimmed(body, row, begin, tau)
        follow_skim(body, begin, end, tau, z)
    return end


@apart
def from_rest(body, mode, begin, z):
    """A changed motion that turns at a panel's begin is told of where it is at rest, not of when it was elsewhere."""
    for k in range(z.shape[1]):
        if z[OM, k] != 0.0:
            rates = accelerations(body, mode, begin, math.copysign(1.0, z[OM, k]))
            step_along(z, k, -z[OM, k] / rates[0], begin, rates)
            z[OM, k] = 0.0


@apart
def follow_prepared(body, row, panel, totals, xi, changes, z, scratch, local):
    """Carry all directions to ξ of a prepared panel; returns the state there."""
    begin = state_of(row)
    if -1.0 < xi < 1.0:
        fill_inside(panel, scratch.work)
    end = state_on_panel(body, panel, totals, begin, xi, scratch)
    if panel.kind == LEAVE:
        from_rest(body, row["mode"], begin, z)
    if xi > -1.0:
        follow_panel(body, panel, xi, begin, end, changes, z, scratch.work, local)
    return end


@apart
def is_panel(row):
    """Whether a piece is a panel."""
    return row["kind"] != FLY and row["kind"] != HOLD and row["kind"] != SKIMMING


@apart
def length_of(row):
    """How long a piece lasts."""
    return (row["t_end"] - row["t"]) - row["t_low"]


@apart
def is_before(t, t_low, row):
    """Whether a time of two doubles lies before an event."""
    return (t - row["t"]) + (t_low - row["t_low"]) < 0.0


@apart
def follow_piece(body, row, changes, z, scratch, local):
    """Carry all directions over a whole piece; returns the state at its end."""
    if is_panel(row):
        panel = panel_of(row)
        totals = solve(body, panel, scratch.work)
        prepare_panel(body, panel, row["omega"] * row["omega"], changes, scratch.work, local)
        return follow_prepared(body, row, panel, totals, row["xi"], changes, z, scratch, local)
    tau = length_of(row)
    return follow_without_panel(body, row, tau, changes, z)
