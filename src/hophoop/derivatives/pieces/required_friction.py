"""The friction that rolling needs, abs(F)/N, on a piece of it: at the nodes of a panel, and at its maximum."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import body_tangent
from hophoop.derivatives.pieces.forces import change_of_forces, forces_by_angle
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import COSINE, SINE, U, fill_inside
from hophoop.kernel.physics.contact import resistance_arm, rolling_forces
from hophoop.kernel.records.writing import panel_of, state_of
from hophoop.kernel.rigid.contact_phase import state_on_panel
from hophoop.kernel.rigid.panel_choice import solve_noinline

HALVINGS = 60


@noinline
def need_of(body, s, c, om, rho, way):
    """(abs(F)/N, its rate by the angle turned, up to a positive factor)."""
    friction, normal = rolling_forces(body, s, c, om * om, rho)
    if not normal > 0.0:
        return math.inf if friction != 0.0 else 0.0, 0.0
    side = 1.0 if friction > 0.0 else -1.0
    friction_by_angle, normal_by_angle = forces_by_angle(body, s, c, om, rho)
    slope = side * (friction_by_angle * normal - friction * normal_by_angle)
    return abs(friction) / normal, way * slope


def needs_on_panel(body, segments, index, scratch, places, needs, slopes):
    """Fill in the friction needed at the ends and the nodes of a rolling piece, with its slopes; returns how many."""
    row = segments[index]
    panel = panel_of(row)
    totals = solve_noinline(body, panel, scratch.work)
    fill_inside(panel, scratch.work)
    begin = state_of(row)
    rho = row["direction"] * body.resist
    count = 1
    for i in range(ORDER):
        if NODES[i] < row["xi"]:
            places[count] = NODES[i]
            om = row["direction"] * math.sqrt(scratch.work[U, i])
            s, c = scratch.work[SINE, i], scratch.work[COSINE, i]
            needs[count], slopes[count] = need_of(body, s, c, om, rho, row["direction"])
            count += 1
    places[0] = -1.0
    places[count] = row["xi"]
    for i in (0, count):
        state = state_on_panel(body, panel, totals, begin, places[i], scratch)
        s, c = sine_cosine(state.th, state.th_low)
        needs[i], slopes[i] = need_of(body, s, c, state.om, rho, row["direction"])
    return count + 1


def peak_on_panel(body, segments, index, low, high, scratch):
    """(abs(F)/N, time) of the peak between two places of a rolling piece."""
    row = segments[index]
    panel = panel_of(row)
    totals = solve_noinline(body, panel, scratch.work)
    fill_inside(panel, scratch.work)
    begin = state_of(row)
    rho = row["direction"] * body.resist
    need = 0.0
    state = begin
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        state = state_on_panel(body, panel, totals, begin, middle, scratch)
        s, c = sine_cosine(state.th, state.th_low)
        need, slope = need_of(body, s, c, state.om, rho, row["direction"])
        if slope > 0.0:
            low = middle
        else:
            high = middle
    return need, state.t


def need_at_rest(body, th):
    """(abs(F)/N, ρ) of a hoop that rests in contact."""
    s, c = sine_and_cosine(th)
    rho = resistance_arm(body, s, c, 0.0, 0)
    return need_of(body, s, c, 0.0, rho, 1.0)[0], rho


def use_changes(body, th, om, rho, tangents, parameter_tangents, larger, smaller):
    """Fill in how abs(F)/(μs N) changes in each direction at an angle of rolling, and to the other side."""
    s, c = sine_and_cosine(th)
    friction, normal = rolling_forces(body, s, c, om * om, rho)
    held = om == 0.0 and abs(rho) < body.resist
    limit = body.mu_s * normal
    for k in range(tangents.shape[1]):
        d_body = body_tangent(parameter_tangents, k)
        dfriction, dnormal = change_of_forces(body, s, c, om, rho, d_body, tangents, k)
        if held:  # F = −g_t and N = g_n
            dfriction, dnormal = -d_body.gt, d_body.gn
        pull = dfriction / limit
        less = (dnormal / normal + d_body.mu_s / body.mu_s) * abs(friction) / limit
        if friction == 0.0:
            larger[k] = abs(pull) - less
            smaller[k] = -abs(pull) - less
        else:
            larger[k] = math.copysign(1.0, friction) * pull - less
            smaller[k] = larger[k]
