"""A step in contact, as long as the error tolerance allows, up to the first change of regime or the lift-off."""

from __future__ import annotations

import math

from hophoop.kernel.compliant.motion import rates
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
    Phase,
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
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.exponentials import power
from hophoop.kernel.physics.body import AT_REST, FLIGHT, REST, SLIP_START, STICK, TAKEOFF, TURN, UNDETERMINED
from hophoop.kernel.physics.closed_forms import rest_curvature
from hophoop.kernel.physics.compliant import (
    BRISTLE,
    KELVIN_VOIGT,
    TANH,
    bristle_rate,
    creep_speed,
    friction_force,
    normal_force,
    resisting_couple,
)
from hophoop.kernel.physics.contact import delassus
from hophoop.kernel.records.layout import EVENTS
from hophoop.kernel.records.writing import has_room

# --- events in a step: the end of contact and the thresholds of friction, at which the step's regime ends

RELEASE, OPENING, FRICTION_CHANGE = 0, 1, 2
GUARDS = 3
NONE = -1
SAMPLES = 12  # samples per step of every guard
SLOPE_STEP = 1e-4  # fraction of a step: distance from its ends for the slope of a guard
NARROWINGS = 40  # steps of the golden-section search
GOLDEN = 0.3819660112501051  # (3 − √5)/2


def guard(comp, regime, which, y, vt, vn, z):
    """Return (value, floor) of a guard: positive inside the regime, on its surface if within ± floor of 0."""
    normal = normal_force(comp, y, vn)[0]
    if which == RELEASE:
        if comp.law == KELVIN_VOIGT:
            return normal, 1e-9 * (comp.k * abs(y) + comp.c * abs(vn)) + 1e-11
        return -comp.k * y, 1e-11
    if which == OPENING:
        if comp.law == KELVIN_VOIGT:
            return 1.0, 0.0
        return 1.0 - comp.d * vn, 1e-9
    if comp.friction == BRISTLE:
        if regime == 0:
            held = abs(comp.k_t * z + comp.c_t * vt)
            return comp.mu_s * normal - held, 1e-8 * (held + comp.mu_s * normal) + 1e-11
        rate = bristle_rate(comp, regime, normal, z, vt)
        size = abs(vt) + abs(rate) + comp.mu_s * abs(normal) / comp.c_t
        return regime * (vt - rate), 1e-8 * size + 1e-11 * comp.v_s
    limit = creep_speed(comp)
    return (limit - abs(vt) if regime == 0 else regime * vt - limit), 1e-8 * limit


def guard_at(comp, regime, which, poly, s):
    """Return `guard` on the dense output."""
    return guard(
        comp, regime, which,
        poly_value(poly, Y, s), poly_value(poly, VT, s), poly_value(poly, VN, s), poly_value(poly, Z, s),
    )  # fmt: skip


def first_exit(comp, regime, poly, armed):
    """Return (guard, s) of the first guard to fall through zero in the step, or NONE.

    A guard that starts on its surface, because the regime was entered there, is not armed until it has left the surface.
    `armed` is updated to the end of the step.
    """
    best = 1.0
    which = NONE
    for index in range(GUARDS):
        low = 0.0
        last = guard_at(comp, regime, index, poly, 0.0)[0]
        slope = (guard_at(comp, regime, index, poly, SLOPE_STEP)[0] - last) / SLOPE_STEP
        before = last - slope / SAMPLES  # linear extrapolation
        for i in range(1, SAMPLES + 1):
            high = i / SAMPLES
            if low - 1.0 / SAMPLES >= best:  # go one sample further, which shows a minimum before it
                break
            value, floor = guard_at(comp, regime, index, poly, high)
            if armed[index]:
                s = high
                if value >= 0.0 and before > last and _may_be_negative(comp, regime, index, poly, i, before, last, value):
                    low = max(low - 1.0 / SAMPLES, 0.0)
                    s = _point_below(comp, regime, index, poly, 1.0, 0.0, low, high)
                if value < 0.0 or s < high:
                    s = _downcrossing(comp, regime, index, poly, low, s)
                    if which == NONE or s < best:
                        best = s
                        which = index
                    break
            elif value > floor:
                armed[index] = True
            elif value < -floor:
                s = low
                if i == 1 and slope > 0.0:  # it may have risen from its surface and fallen in between
                    peak = _point_below(comp, regime, index, poly, -1.0, -floor, low, high)
                    if peak < high:
                        s = _downcrossing(comp, regime, index, poly, peak, high)
                if which == NONE or s < best:
                    best = s
                    which = index
                break
            low = high
            before, last = last, value
    return which, best


def _may_be_negative(comp, regime, which, poly, i, before, last, value):
    """Return True if a guard with these values at three samples may be negative between them, as its tangents are."""
    if value >= last:
        return 2.0 * last < max(before, value)
    if i < SAMPLES:
        return False
    return value - (value - guard_at(comp, regime, which, poly, 1.0 - SLOPE_STEP)[0]) / (SLOPE_STEP * SAMPLES) < 0.0


def _point_below(comp, regime, which, poly, sign, least, low, high):
    """Return a point where sign × guard, with a minimum between `low` and `high`, is below `least`; `high` if there is none."""
    end = high
    left = low + GOLDEN * (high - low)
    right = high - GOLDEN * (high - low)
    f_left = sign * guard_at(comp, regime, which, poly, left)[0]
    f_right = sign * guard_at(comp, regime, which, poly, right)[0]
    for _ in range(NARROWINGS):
        if f_left < least:
            return left
        if f_right < least:
            return right
        if f_left < f_right:
            high, right, f_right = right, left, f_left
            left = low + GOLDEN * (high - low)
            f_left = sign * guard_at(comp, regime, which, poly, left)[0]
        else:
            low, left, f_left = left, right, f_right
            right = high - GOLDEN * (high - low)
            f_right = sign * guard_at(comp, regime, which, poly, right)[0]
    return end


def _downcrossing(comp, regime, which, poly, low, high):
    """Return the root of a guard that is positive at `low` and negative at `high`, by the Illinois method."""
    f_low = guard_at(comp, regime, which, poly, low)[0]
    f_high = guard_at(comp, regime, which, poly, high)[0]
    if f_low <= 0.0:
        return low
    side = 0
    for _ in range(100):
        if high - low <= 4e-16 * high:
            break
        middle = (low * f_high - high * f_low) / (f_high - f_low)
        if not low < middle < high:
            middle = 0.5 * (low + high)
            if not low < middle < high:
                break
        f_middle = guard_at(comp, regime, which, poly, middle)[0]
        if f_middle > 0.0:
            low, f_low = middle, f_middle
            if side == 1:
                f_high *= 0.5
            side = 1
        else:
            high, f_high = middle, f_middle
            if f_middle == 0.0:
                break
            if side == -1:
                f_low *= 0.5
            side = -1
    return high


def remaining(comp, regime, which, poly):
    """Return the factor for the length of a step that should end where a guard falls; 1 if it does."""
    value, floor = guard_at(comp, regime, which, poly, 1.0)
    if abs(value) <= 0.1 * floor:
        return 1.0
    if value < 0.0 and guard_at(comp, regime, which, poly, 0.0)[0] > 0.0:
        return _downcrossing(comp, regime, which, poly, 0.0, 1.0)
    slope = (value - guard_at(comp, regime, which, poly, 1.0 - 1e-3)[0]) / 1e-3
    if slope >= 0.0:
        return 1.0
    return min(max(1.0 - value / slope, 0.5), 1.5)


def sign_change(poly, m):
    """Return the point in the step where a variable that changes sign is zero."""
    low = 0.0
    high = 1.0
    positive = poly[m, 0] > 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if (poly_value(poly, m, middle) > 0.0) == positive:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


# --- the step

SAFETY, SLOWER, FASTER = 0.9, 0.1, 6.0
ORDER_OF_ERROR = STAGES + 1
# A shorter step means that the method has failed.
SHORTEST = 1e-40
# Velocities and accelerations (of order 1 in a motion) below which a stable equilibrium counts as rest.
STILL = 1e-11
ROUNDED = 1e-13  # rounding of v_t near zero, relative to the slip velocities in the step


def first_step(body, comp, regime, u, rtol):
    """Return the length of a step that resolves the fastest transient of a contact that starts."""
    s, c = sine_and_cosine(u[TH])
    W_tt, W_nn, _ = delassus(body, s, c)
    normal, normal_y, normal_vn = normal_force(comp, u[Y], u[VN])
    friction_vt = friction_force(comp, regime, normal, u[Z], u[VT])[2]
    speed = math.sqrt(max(-normal_y, comp.k) * W_nn) + abs(normal_vn) * W_nn + abs(friction_vt) * W_tt
    if comp.friction == BRISTLE:
        speed += math.sqrt(comp.k_t * W_tt)
    speed += 1.0 + abs(u[OM])
    if body.resist > 0.0:
        speed += abs(resisting_couple(comp, body.resist, normal, u[OM])[2]) / body.kap
    return 0.3 * power(rtol, 1.0 / ORDER_OF_ERROR) / speed


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


def arm_guards(comp, regime, armed, work):
    """Arm the guards that can fall from this state."""
    u = work.state
    for which in range(GUARDS):
        value, floor = guard(comp, regime, which, u[Y], u[VT], u[VN], u[Z])
        armed[which] = value > floor


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
        s = remaining(comp, regime, which, work.poly)
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
        s = sign_change(work.poly, OM) if work.poly[OM, 0] * spin < 0.0 else 0.0
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
    return Phase(after, revolutions, behind, phase.mode, phase.regime, False, phase.h, length, direction, phase.status)


def meet_threshold(comp, regime, work):
    """Set v_t exactly to the end of slip if it differs only by rounding.

    v_t may have come from 10¹² slip speeds, and its rounding would mean friction outside the cone.
    """
    u = work.state
    value, floor = guard(comp, regime, FRICTION_CHANGE, u[Y], u[VT], u[VN], u[Z])
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


def change(comp, phase, which, armed, log, work):
    """Return the phase after a guard has fallen: another regime of friction, or flight."""
    u = work.state
    if which != FRICTION_CHANGE:
        write_plain_event(log, TAKEOFF, phase.mode, FLIGHT, phase.t, phase.revolutions, u)
        if comp.k * abs(u[Y]) < 1e-8:
            u[Y] = 0.0
        return begin_phase(phase, phase.t, FLIGHT, phase.regime)
    if phase.regime != 0:
        regime = 0
        meet_threshold(comp, phase.regime, work)
    elif comp.friction == BRISTLE:
        regime = 1 if comp.k_t * u[Z] + comp.c_t * u[VT] > 0.0 else -1
    else:
        regime = 1 if u[VT] > 0.0 else -1
    mode = mode_of(regime)
    write_plain_event(log, STICK if regime == 0 else SLIP_START, phase.mode, mode, phase.t, phase.revolutions, u)
    if comp.friction != TANH:
        return begin_phase(phase, phase.t, mode, regime)
    arm_guards(comp, regime, armed, work)  # the tanh law is smooth across its threshold, so the step size stays
    return Phase(
        phase.t, phase.revolutions, phase.behind, mode, regime, False, phase.h, phase.before, phase.direction, phase.status
    )


def contact_step(body, comp, phase, t_end, rtol, armed, log, work):
    """Try one step; return the next phase. After a failed step only the length of the next step changes."""
    u = work.state
    regime = phase.regime
    if phase.begins:
        arm_guards(comp, regime, armed, work)
        phase = with_step(phase, first_step(body, comp, regime, u, rtol), 0.0)
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
    which, s = first_exit(comp, regime, work.poly, armed)
    if which != NONE and s * length < SHORTEST:
        return change(comp, phase, which, armed, log, work)
    if which != NONE:
        length, done = shorten(body, comp, regime, which, s, length, rtol, work)
        if not done:
            return with_step(phase, length, 0.0)
        last = False
    after = t_end if last else phase.t + (length + phase.behind)
    behind = phase.behind if length == 0.0 else (length + phase.behind) - (after - phase.t)
    phase = accept(phase, after, behind, length, log, work)
    if which != NONE:
        return change(comp, phase, which, armed, log, work)
    rests, stable = at_rest(body, comp, regime, u, work)
    if rests:
        return come_to_rest(phase, t_end, stable, log, work)
    return phase
