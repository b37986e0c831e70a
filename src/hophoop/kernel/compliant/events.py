"""Events in a step: the end of contact and the thresholds of friction, at which the step's regime ends."""

from __future__ import annotations

from hophoop.kernel.compliant.records import VN, VT, Y, Z
from hophoop.kernel.compliant.step import poly_value
from hophoop.kernel.physics.compliant import BRISTLE, KELVIN_VOIGT, bristle_rate, creep_speed, normal_force

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
