"""States at given times of a rigid motion, and the margins of its mode; panels are solved again, so memory stays small."""

from __future__ import annotations

import math

from hophoop.kernel.native import replaced
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.numerics.collocation import NOT_FOUND, ORDER, coefficients, first_downcrossing
from hophoop.kernel.panels.panel import FLY, HOLD, SKIMMING, STRUCK, TIME, Totals, fill_inside, no_panel
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.closed_forms import (
    flight_displacement,
    flight_gap,
    kinetic_energy,
    potential_energy,
    skim_state,
    strike_limit,
)
from hophoop.kernel.physics.contact import (
    free_acceleration,
    kappa_p_sigma,
    resistance_arm,
    rolling_forces,
    slip_coefficients,
    slip_load,
    slip_motion,
)
from hophoop.kernel.physics.modes import slip_direction
from hophoop.kernel.records.layout import new_scratch
from hophoop.kernel.records.state import flown, whole_angle
from hophoop.kernel.records.writing import find_segment, panel_of, state_of
from hophoop.kernel.rigid.contact_phase import state_on_panel, state_without_rotation
from hophoop.kernel.rigid.flight_phase import time_to_strike
from hophoop.kernel.rigid.panel_choice import solve

# Margins of a mode, in kernel units; documented in `hophoop.simulation.phases.Margins`.
MARGINS = ("normal_force", "friction_force", "friction_limit", "free_acceleration", "slip", "height", "p_sigma")


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
    _, stiffness = slip_coefficients(body, s, c, sigma, rho)
    normal = body.kap * slip_load(body, c, om * om, stiffness)
    return -sigma * body.mu_k * normal, normal


def load_energy(along, down):
    """Return the kinetic energy of the load alone, which stays finite when θ̇ of a massless rim is unbounded."""
    return 0.5 * (along * along + down * down)


def state_in_flight(body, f_n, state, tau):
    """Return the state at the time tau of a flight from `state`, where the acceleration of the gap is f_n."""
    s, c = sine_cosine(state.th, state.th_low)
    y, vn = flight_gap(body, s, c, state.om, state.y, state.vn, f_n, tau)
    along, vt = flight_displacement(body, state.vt, state.om, s, c, tau)
    return flown(state, along, max(y, 0.0), tau, vt, vn)


def state_in_skim(body, direction, state, t, tau, strikes):
    """Return (state, kinetic energy of the load) at the time t, by tau after `state`, of a skim; just before it `strikes`."""
    s, c = sine_cosine(state.th, 0.0)
    along = state.vt + state.om * (1.0 + c)
    if strikes:  # the limit, since rounding would move the state to either side
        tau = time_to_strike(body, state)
        x, th, vt = strike_limit(body, state.x, state.th, s, along, direction, tau)
        om = direction * math.inf
    else:
        x, th, vt, om = skim_state(body, state.x, state.th, state.vt, state.om, direction, tau)
    now = replaced(state, t=t, t_low=0.0, x=x, x_low=0.0, th=th, th_low=0.0, vt=vt, vn=0.0, om=om)
    return now, load_energy(along + body.gt * tau, s * state.om + body.gn * tau)


def sample(body, segments, times, left, out):
    """Fill `out`, shape (len(times), len(COLUMNS)), with the motion at these times (kernel units)."""
    scratch = new_scratch()
    solved = -1
    totals = Totals(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    panel = no_panel(FLY, 0, 0.0)
    for k in range(times.shape[0]):
        index = find_segment(segments["t"], times[k], left)
        segment = segments[index]
        kind, direction, sigma = segment["kind"], segment["direction"], segment["sigma"]
        state = state_of(segment)
        tau = (min(times[k], segment["t_end"]) - segment["t"]) - segment["t_low"]
        begins = times[k] == segment["t"]  # exactly at the event, whose time has more digits than `times`
        if begins:
            tau = 0.0
        friction = 0.0
        normal = 0.0
        kinetic = math.nan
        if kind == FLY:
            now = state_in_flight(body, segment["f_n"], state, tau)
        elif kind == HOLD:
            now = state_without_rotation(body, sigma, state, times[k], tau)
            normal = body.gn
            friction = -sigma * body.mu_k * body.gn if sigma != 0 else -body.gt
        elif kind == SKIMMING:
            strikes = segment["xi"] == STRUCK and times[k] >= segment["t_end"]
            now, kinetic = state_in_skim(body, direction, state, times[k], tau, strikes)
        else:
            now = state
            if not begins:
                if index != solved:
                    panel = panel_of(segment)
                    totals = solve(body, panel, scratch.work)
                    fill_inside(panel, scratch.work)
                    solved = index
                xi = xi_at_time(scratch.work[TIME], segment, tau, scratch)
                now = state_on_panel(body, panel, totals, state, xi, scratch)
            friction, normal = contact_force(body, sigma, now.th, now.th_low, now.om, direction * body.resist)
        if begins:
            now = state
        if kind != SKIMMING:
            kinetic = kinetic_energy(body, now.th, now.om, now.vt, now.vn, now.th_low)
        values = (
            float(segment["mode"]), now.x, now.y, whole_angle(now), now.vt + now.om, now.vn, now.om, now.vt, friction, normal,
            now.friction, now.impact_n, now.impact_t, now.th, now.th_low, now.rolling_loss, kinetic,
            potential_energy(body, now.x, now.y, now.th),
        )  # fmt: skip
        for i in range(len(values)):
            out[k, i] = values[i]


def margins_of(body, mode, theta, theta_low, omega, slip, height):
    """Return the margins in the order of `MARGINS`; nan if the mode has none."""
    s, c = sine_cosine(theta, theta_low)
    u = omega * omega
    normal = math.nan
    friction = math.nan
    p_sigma = math.nan
    mu = body.mu_s
    sigma = slip_direction(mode)
    if mode == Mode.ROLL:
        friction, normal = rolling_forces(body, s, c, u, resistance_arm(body, s, c, omega, 0))
    elif sigma != 0 and body.kap > 0.0 and math.isfinite(body.mu_k):
        rho = resistance_arm(body, s, c, omega, sigma)
        normal = slip_motion(body, s, c, u, sigma, rho)[1]
        friction = -sigma * body.mu_k * normal
        p_sigma = kappa_p_sigma(body, s, c, sigma, rho) / body.kap
        mu = body.mu_k
    elif mode in (Mode.FLIGHT, Mode.SKIM):
        friction = 0.0
        normal = 0.0
    limit = 0.0
    if normal != 0.0:
        limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal
    return normal, friction, limit, free_acceleration(body, s, c, u)[1], slip, height, p_sigma
