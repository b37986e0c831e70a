"""The friction that rolling needs, abs(F)/N, on a piece of it: at the nodes of a panel, and at its maximum."""

from __future__ import annotations

import math

from hophoop.derivatives.layout import MU_S
from hophoop.derivatives.pieces.forces import by_angle, change_of, rolling_slopes
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_and_cosine, sine_cosine
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import COSINE, SINE, U, fill_inside
from hophoop.kernel.physics.contact import resistance_arm
from hophoop.kernel.records.writing import panel_of, state_of
from hophoop.kernel.rigid.contact_phase import state_on_panel
from hophoop.kernel.rigid.panel_choice import solve_noinline

HALVINGS = 60


@noinline
def need_of(body, s, c, om, rho, way):
    """(abs(F)/N, its rate by the angle turned, up to a positive factor)."""
    friction, normal, alpha, of_friction, of_normal = rolling_slopes(body, s, c, om, rho)
    if not normal > 0.0:
        return math.inf if friction != 0.0 else 0.0, 0.0
    side = 1.0 if friction > 0.0 else -1.0
    slope = side * (by_angle(of_friction, alpha) * normal - friction * by_angle(of_normal, alpha))
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
    friction, normal, _, of_friction, of_normal = rolling_slopes(body, s, c, om, rho)
    if om == 0.0 and abs(rho) < body.resist:  # held: F = −g_t and N = g_n
        of_friction = (0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0)
        of_normal = (0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    limit = body.mu_s * normal
    for k in range(tangents.shape[1]):
        pull = change_of(of_friction, om, tangents, parameter_tangents, k) / limit
        less = change_of(of_normal, om, tangents, parameter_tangents, k) / normal + parameter_tangents[MU_S, k] / body.mu_s
        less *= abs(friction) / limit
        if friction == 0.0:
            larger[k] = abs(pull) - less
            smaller[k] = -abs(pull) - less
        else:
            larger[k] = math.copysign(1.0, friction) * pull - less
            smaller[k] = larger[k]
