"""A step in contact, as long as the error tolerance allows, up to the first change of regime or the lift-off."""

from __future__ import annotations

import math

from hophoop.kernel.compliant.motion import jacobian, rates
from hophoop.kernel.compliant.radau import FAILED, attempt, make_poly, poly_value, predict
from hophoop.kernel.compliant.records import (
    DYNAMIC,
    OM,
    RESTING,
    SIZE,
    STAGES,
    STEP,
    TH,
    VN,
    VT,
    Y,
    Z,
    append_segment,
    begin_phase,
    end_motion,
    mode_of,
    with_step,
    within_revolution,
    write_plain_event,
)
from hophoop.kernel.native import inline, replaced
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.collocation import (
    NOT_FOUND,
    ORDER,
    PARTS,
    margin_downcrossing,
)
from hophoop.kernel.numerics.exponentials import power
from hophoop.kernel.physics.body import AT_REST, FLIGHT, REST, SLIP_START, STICK, TAKEOFF, TURN, UNDETERMINED
from hophoop.kernel.physics.closed_forms import rest_curvature
from hophoop.kernel.physics.compliant import (
    BRISTLE,
    KELVIN_VOIGT,
    TANH,
    bristle_rate,
    creep_speed,
    normal_force,
)
from hophoop.kernel.records.layout import EVENTS
from hophoop.kernel.records.writing import has_room

# --- events in a step: the end of contact and the thresholds of friction, at which the step's regime ends
# Each margin is a polynomial of at most degree 10 along a step, which its values at the nodes of a panel determine.

RELEASE, OPENING, AHEAD, BACK = 0, 1, 2, 3  # AHEAD and BACK: to friction against slip forwards and backwards
MARGINS = 4
NONE = -1
SLOPE_STEP = 1e-3  # fraction of a step: distance from its end for the slope of a margin


@inline
def margin(comp, regime, which, y, vt, vn, z):
    """Return (value, floor) of a margin: positive inside the regime, on its surface if within ± floor of 0."""
    normal = normal_force(comp, y, vn)[0]
    if which == RELEASE:
        if comp.law == KELVIN_VOIGT:
            return normal, 1e-9 * (comp.k * abs(y) + comp.c * abs(vn)) + 1e-11
        return -comp.k * y, 1e-11
    if which == OPENING:
        return (1.0, 0.0) if comp.law == KELVIN_VOIGT else (1.0 - comp.d * vn, 1e-9)
    side = 1.0 if which == AHEAD else -1.0
    if regime == -side:
        return 1.0, 0.0
    if comp.friction != BRISTLE:
        limit = creep_speed(comp)
        return (limit - side * vt if regime == 0 else regime * vt - limit), 1e-8 * limit
    if regime == 0:
        held = comp.k_t * z + comp.c_t * vt
        return comp.mu_s * normal - side * held, 1e-8 * (abs(held) + comp.mu_s * normal) + 1e-11
    rate = bristle_rate(comp, regime, normal, z, vt)
    size = abs(vt) + abs(rate) + comp.mu_s * abs(normal) / comp.c_t
    return regime * (vt - rate), 1e-8 * size + 1e-11 * comp.v_s


def margin_at(comp, regime, which, poly, s):
    """Return `margin` on the dense output."""
    return margin(
        comp, regime, which,
        poly_value(poly, Y, s), poly_value(poly, VT, s), poly_value(poly, VN, s), poly_value(poly, Z, s),
    )  # fmt: skip


@inline
def fill_nodes(work):
    """Fill the dynamic variables at the nodes of a panel along the step."""
    for m in range(DYNAMIC):
        row = work.nodes[m]
        for i in range(ORDER):
            row[i] = work.poly[m, STAGES]
        for j in range(STAGES - 1, -1, -1):
            for i in range(ORDER):
                row[i] = row[i] * PARTS[i] + work.poly[m, j]


@inline
def fall(comp, regime, which, work):
    """Return the point of the step at which a margin falls through zero; more than 1 if it does not. Needs `fill_nodes`."""
    row, nodes, poly = work.values[0], work.nodes, work.poly
    for i in range(ORDER):
        row[i] = margin(comp, regime, which, nodes[Y, i], nodes[VT, i], nodes[VN, i], nodes[Z, i])[0]
    value, floor = margin(comp, regime, which, poly[Y, 0], poly[VT, 0], poly[VN, 0], poly[Z, 0])
    return 0.5 * (1.0 + margin_downcrossing(row, False, floor if value <= floor else 0.0, work)[0])


@inline
def first_exit(comp, regime, work):
    """Return (margin, s) of the first margin to fall through zero in the step, or NONE."""
    fill_nodes(work)
    best = 1.0
    first = NONE
    for which in range(MARGINS):
        s = fall(comp, regime, which, work)
        if s < best or (s == best and first == NONE):
            best = s
            first = which
    return first, best


def remaining(comp, regime, which, work):
    """Return the factor for the length of a step that should end where a margin falls; 1 if it does."""
    value, floor = margin_at(comp, regime, which, work.poly, 1.0)
    if abs(value) <= 0.1 * floor:
        return 1.0
    if value < 0.0:
        fill_nodes(work)
        return min(fall(comp, regime, which, work), 1.0)
    slope = (value - margin_at(comp, regime, which, work.poly, 1.0 - SLOPE_STEP)[0]) / SLOPE_STEP
    return min(max(1.0 - value / slope, 0.5), 1.5) if slope < 0.0 else 1.0


def turning_point(direction, work):
    """Return the point of the step at which the rotation in a direction ends; its start if it has none."""
    fill_nodes(work)
    row = work.nodes[OM]
    for i in range(ORDER):
        row[i] *= direction
    xi = margin_downcrossing(row, True, 0.0, work)[0]
    return 0.5 * (1.0 + xi) if xi != NOT_FOUND else 0.0


# --- the step

SAFETY, SLOWER, FASTER = 0.9, 0.1, 6.0
ORDER_OF_ERROR = STAGES + 1
# A shorter step means that the method has failed.
SHORTEST = 1e-40
# Velocities and accelerations (of order 1 in a motion) below which a stable equilibrium counts as rest.
STILL = 1e-11
ROUNDED = 1e-13  # rounding of v_t near zero, relative to the slip velocities in the step


def first_step(body, comp, regime, u, rtol, work):
    """Return the length of a step that resolves the fastest transient of a contact that starts."""
    slopes = work.jacobian
    jacobian(body, comp, regime, u, slopes)
    speed = math.sqrt(abs(slopes[VN, Y])) + abs(slopes[VN, VN]) + math.sqrt(abs(slopes[VT, Z])) + abs(slopes[VT, VT])
    return 0.3 * power(rtol, 1.0 / ORDER_OF_ERROR) / (speed + abs(slopes[OM, OM]) + 1.0 + abs(u[OM]))


def at_rest(body, comp, regime, u, work):
    """Return (True if the hoop rests, True if stably)."""
    speed = max(abs(u[VT]), abs(u[VN]), abs(u[OM]))
    if speed > STILL:
        return False, False
    rates(body, comp, regime, u, work.trial)
    speed = max(speed, abs(work.trial[VT]), abs(work.trial[VN]), abs(work.trial[OM]))
    if speed > STILL:
        return False, False
    s, c = sine_and_cosine(u[TH])
    bend = rest_curvature(body, s, c)
    stable = bend > 0.0 or (body.eps == 0.0 and body.gt == 0.0)
    return stable or speed < 1e-15, stable


def come_to_rest(phase, t_end, stable, log, work):
    """End the motion at rest; return the phase."""
    write_plain_event(log, REST, phase.mode, phase.mode, phase.t, phase.revolutions, work.state)
    if has_room(log):
        log.events[log.counts[EVENTS] - 1]["stable"] = 1 if stable else 0
    append_segment(log, phase, t_end, RESTING, 0.0, work)
    return end_motion(phase, t_end, AT_REST)


def shorten(body, comp, regime, which, s, length, rtol, work):
    """Repeat the step, shortened until its end is where a guard falls to its floor; return (length, True if no step failed)."""
    for _ in range(6):
        predict(work, 0.0, s)
        if not attempt(body, comp, regime, work, work.state, s * length, rtol) < FAILED:
            return 0.5 * s * length, False
        length *= s
        make_poly(work, work.state)
        s = remaining(comp, regime, which, work)
        if s == 1.0:
            break
    return length, True


def accept(phase, after, behind, length, log, work):
    """Accept a step and write a turning point inside it; return the phase."""
    u = work.state
    direction = phase.direction
    append_segment(log, phase, after, STEP, length, work)
    spin = poly_value(work.poly, OM, 1.0)
    if direction * spin < 0.0:
        s = turning_point(direction, work)
        for m in range(SIZE):
            work.start[m] = poly_value(work.poly, m, s)
        work.start[OM] = 0.0
        when = min(phase.t + s * length, after)  # rounding could put it after the step
        write_plain_event(log, TURN, phase.mode, phase.mode, when, phase.revolutions, work.start)
    if spin != 0.0:
        direction = 1.0 if spin > 0.0 else -1.0
    for m in range(SIZE):
        u[m] += work.stages[STAGES - 1, m] if m < DYNAMIC else work.integrals[STAGES - 1, m - DYNAMIC]
    revolutions, u[TH] = within_revolution(phase.revolutions, u[TH])
    return replaced(phase, t=after, revolutions=revolutions, behind=behind, begins=False, before=length, direction=direction)


def meet_threshold(comp, regime, work):
    """Set v_t exactly to the end of slip if it differs only by rounding.

    v_t may have come from 10¹² slip speeds, and its rounding would mean friction outside the cone.
    """
    u = work.state
    value, floor = margin(comp, regime, AHEAD if regime > 0 else BACK, u[Y], u[VT], u[VN], u[Z])
    if comp.friction == TANH or abs(value) <= floor:
        return
    threshold = regime * creep_speed(comp)
    if comp.friction == BRISTLE:
        threshold = bristle_rate(comp, regime, normal_force(comp, u[Y], u[VN])[0], u[Z], u[VT])
    size = 0.0
    for j in range(STAGES + 1):
        size += abs(work.poly[VT, j])
    if abs(u[VT] - threshold) <= ROUNDED * size:
        u[VT] = threshold


def change(comp, phase, which, log, work):
    """Return the phase after a margin has fallen: another regime of friction, or flight."""
    u = work.state
    if which in (RELEASE, OPENING):
        write_plain_event(log, TAKEOFF, phase.mode, FLIGHT, phase.t, phase.revolutions, u)
        if comp.k * abs(u[Y]) < 1e-8:
            u[Y] = 0.0
        return begin_phase(phase, phase.t, FLIGHT, phase.regime)
    if phase.regime != 0:
        regime = 0
        meet_threshold(comp, phase.regime, work)
    else:
        regime = 1 if which == AHEAD else -1
    mode = mode_of(regime)
    write_plain_event(log, STICK if regime == 0 else SLIP_START, phase.mode, mode, phase.t, phase.revolutions, u)
    if comp.friction != TANH:
        return begin_phase(phase, phase.t, mode, regime)
    return replaced(phase, mode=mode, regime=regime)  # the tanh law is smooth across its threshold, so the step size stays


def contact_step(body, comp, phase, t_end, rtol, log, work):
    """Try one step; return the next phase. After a failed step only the length of the next step changes."""
    u = work.state
    regime = phase.regime
    if phase.begins:
        phase = with_step(phase, first_step(body, comp, regime, u, rtol, work), 0.0)
        rests, stable = at_rest(body, comp, regime, u, work)
        if rests:
            return come_to_rest(phase, t_end, stable, log, work)
    h = phase.h
    if h < SHORTEST:
        return end_motion(phase, phase.t, UNDETERMINED)
    left = t_end - phase.t
    last = h >= 0.999 * left
    length = left if last else h
    predict(work, 1.0, length / phase.before if phase.before > 0.0 else 0.0)
    error = attempt(body, comp, regime, work, u, length, rtol)
    if error >= FAILED:
        # Newton's iteration may have diverged because of its first guess
        return with_step(phase, (0.25 if phase.before == 0.0 else 0.5) * length, 0.0)
    factor = SAFETY * power(max(error, 1e-10), -1.0 / ORDER_OF_ERROR)
    if error > 1.0:
        return with_step(phase, max(factor, SLOWER) * length, phase.before)
    phase = with_step(phase, min(factor, FASTER) * length, phase.before)
    make_poly(work, u)
    which, s = first_exit(comp, regime, work)
    if which != NONE and s * length < SHORTEST:
        return change(comp, phase, which, log, work)
    if which != NONE:
        length, done = shorten(body, comp, regime, which, s, length, rtol, work)
        if not done:
            return with_step(phase, length, 0.0)
        last = False
    after = t_end if last else phase.t + (length + phase.behind)
    behind = phase.behind if length == 0.0 else (length + phase.behind) - (after - phase.t)
    phase = accept(phase, after, behind, length, log, work)
    if which != NONE:
        return change(comp, phase, which, log, work)
    rests, stable = at_rest(body, comp, regime, u, work)
    if rests:
        return come_to_rest(phase, t_end, stable, log, work)
    return phase
