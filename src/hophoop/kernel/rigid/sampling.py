"""States at given times of a computed rigid motion; panels are solved again, so memory stays small."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.collocation import ORDER, coefficients
from hophoop.kernel.numerics.double_double import plus
from hophoop.kernel.numerics.roots import NOT_FOUND, first_downcrossing
from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.panels.panel import FLY, HOLD, SKIMMING, STRUCK, TIME, Totals, fill_inside, no_panel
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.contact import rolling_forces, slip_load
from hophoop.kernel.physics.energy import kinetic_energy, potential_energy
from hophoop.kernel.physics.flight import flight_displacement, flight_gap
from hophoop.kernel.physics.massless import skim_state, strike_limit
from hophoop.kernel.physics.painleve import slip_coefficients
from hophoop.kernel.records.scratch import new_scratch
from hophoop.kernel.records.state import flown, moved, whole_angle, with_losses, with_velocities
from hophoop.kernel.records.writing import panel_of, state_of
from hophoop.kernel.rigid.contact_phase import state_on_panel
from hophoop.kernel.rigid.panel_choice import solve

FLIGHT = int(Mode.FLIGHT)


def find_segment(segments, t, left):
    """Return the index of the segment that contains the time t; at a boundary the earlier one if `left`."""
    low = 0
    high = segments.shape[0]
    while high - low > 1:
        middle = (low + high) // 2
        begin = segments[middle]["t"]
        if begin < t or (begin == t and not left):
            low = middle
        else:
            high = middle
    return low


def xi_at_time(panel_time, segment, tau, scratch):
    """Return ξ at the time tau after the start of the panel."""
    if tau <= 0.0:
        return -1.0
    for i in range(ORDER):
        scratch.values[0, i] = tau - panel_time[i]
    coefficients(scratch.values[0], scratch.series)
    xi = first_downcrossing(scratch.series, 0.0, scratch.stack)
    if xi == NOT_FOUND:  # next to one of the ends, within the rounding of the series
        xi = segment["xi"] if tau > panel_time[0] else -1.0
    return min(xi, segment["xi"])


def contact_force(body, sigma, th, th_low, om, rho):
    """Return (F, N) in rolling (sigma = 0) or slip, with the rolling resistance ρ."""
    s, c = sine_cosine(th, th_low)
    if sigma == 0:
        return rolling_forces(body, s, c, om * om, rho)
    _, stiffness = slip_coefficients(body, th, th_low, s, c, sigma, rho)
    normal = body.kap * slip_load(body, c, om * om, stiffness)
    return -sigma * body.mu_k * normal, normal


def load_energy(along, down):
    """Return the kinetic energy of the load alone, which stays finite when θ̇ of a massless rim is unbounded."""
    return 0.5 * (along * along + down * down)


def sample(body, segments, times, left, out):
    """Fill `out`, shape (len(times), len(COLUMNS)), with the motion at these times (kernel units)."""
    scratch = new_scratch()
    solved = -1
    totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    panel = no_panel(FLY, 0, 0.0)
    for k in range(times.shape[0]):
        index = find_segment(segments, times[k], left)
        segment = segments[index]
        state = state_of(segment)
        tau = (min(times[k], segment["t_end"]) - segment["t"]) - segment["t_low"]
        begins = times[k] == segment["t"]  # exactly at the event, whose time has more digits than `times`
        if begins:
            tau = 0.0
        friction = 0.0
        normal = 0.0
        moving = math.nan
        if segment["kind"] == FLY:
            s, c = sine_cosine(state.th, state.th_low)
            y, vn = flight_gap(body, s, c, state.om, state.y, state.vn, segment["opening"], tau)
            along, vt = flight_displacement(body, state.vt, state.om, s, c, tau)
            now = flown(state, along, max(y, 0.0), tau, vt, vn)
        elif segment["kind"] == HOLD and state.om == 0.0:
            rate = segment["opening"]
            slid = state.vt * tau + 0.5 * rate * tau * tau
            loss = segment["sigma"] * body.mu_k * body.gn * slid if segment["sigma"] != 0 else 0.0
            vt = state.vt + rate * tau
            normal = body.gn
            friction = -segment["sigma"] * body.mu_k * body.gn if segment["sigma"] != 0 else -body.gt
            x, x_low = plus(state.x, state.x_low, slid)
            now = moved(state, times[k], 0.0, x, x_low, 0.0, state.turns, state.th, state.th_low)
            now = with_losses(with_velocities(now, vt, 0.0, 0.0), state.friction + loss, state.impact_n, state.impact_t)
        elif segment["kind"] == SKIMMING:
            x, th, vt, om = skim_state(body, state.x, state.th, state.vt, state.om, segment["way"], tau)
            s, c = sine_cosine(state.th, 0.0)
            along = state.vt + state.om * (1.0 + c)
            if segment["xi"] == STRUCK and times[k] >= segment["t_end"]:
                # the limit just before the strike; rounding would move it to either side
                tau = segment["opening"]
                x, th, vt = strike_limit(body, state.x, state.th, s, along, segment["way"], tau)
                om = segment["way"] * math.inf
            now = moved(state, times[k], 0.0, x, 0.0, 0.0, state.turns, th, 0.0)
            now = with_velocities(now, vt, 0.0, om)
            moving = load_energy(along + body.gt * tau, s * state.om + body.gn * tau)
        else:
            now = state
            if not begins and segment["kind"] != HOLD:  # a HOLD segment of a rotating hoop is too short to be resolved
                if index != solved:
                    panel = panel_of(segment)
                    totals = solve(body, panel, scratch.work)
                    fill_inside(panel, scratch.work)
                    solved = index
                xi = xi_at_time(scratch.work[TIME], segment, tau, scratch)
                now = state_on_panel(body, panel, totals, state, xi, scratch)
            rho = segment["way"] * body.resist
            friction, normal = contact_force(body, segment["sigma"], now.th, now.th_low, now.om, rho)
        if begins:
            now = state
        row = out[k]
        row[0] = segment["mode"]
        row[1] = now.x
        row[2] = now.y
        row[3] = whole_angle(now)
        row[4] = now.vt + now.om
        row[5] = now.vn
        row[6] = now.om
        row[7] = now.vt
        row[8] = friction
        row[9] = normal
        row[10] = now.friction
        row[11] = now.impact_n
        row[12] = now.impact_t
        row[13] = now.th
        row[14] = now.th_low
        row[15] = now.resisted
        row[16] = kinetic_energy(body, now.th, now.om, now.vt, now.vn, now.th_low) if math.isnan(moving) else moving
        row[17] = potential_energy(body, now.x, now.y, now.th)
