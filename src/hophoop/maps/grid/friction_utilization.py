"""The maximum friction utilization of a motion."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.physics.body import Event, Mode
from hophoop.kernel.physics.closed_forms import rolling_u
from hophoop.kernel.physics.contact import required_ratio, rolling_acceleration, utilization

SAMPLES_PER_RADIAN = 24
RESISTED_SAMPLES_PER_RADIAN = 120


def resisted_slope(body, th, u, rho):
    """Return dθ̇²/dθ of rolling with rolling resistance."""
    s, c = sine_and_cosine(th)
    return 2.0 * rolling_acceleration(body, s, c, u, rho)


def resisted_u(body, th, u, rho, step):
    """Return θ̇² of resisted rolling after a small step of θ, by the classical Runge-Kutta method."""
    first = resisted_slope(body, th, u, rho)
    second = resisted_slope(body, th + 0.5 * step, u + 0.5 * step * first, rho)
    third = resisted_slope(body, th + 0.5 * step, u + 0.5 * step * second, rho)
    last = resisted_slope(body, th + step, u + step * third, rho)
    return u + step * (first + 2.0 * (second + third) + last) / 6.0


def required_friction(body, th, u, rho, step):
    """Return abs(F)/N of rolling after a step of θ, which is small with rolling resistance."""
    after = resisted_u(body, th, u, rho, step) if rho != 0.0 else rolling_u(body, th, u, step)
    s, c = sine_and_cosine(th + step)
    return abs(required_ratio(body, s, c, max(after, 0.0), rho))


def maximum_between(body, th, u, rho, low, high, greatest):
    """Return the maximum abs(F)/N between two offsets of θ, by golden section, or `greatest` if that is larger."""
    part = 0.5 * (math.sqrt(5.0) - 1.0)
    for _ in range(44):
        a = high - part * (high - low)
        b = low + part * (high - low)
        at_a, at_b = required_friction(body, th, u, rho, a), required_friction(body, th, u, rho, b)
        if at_a > at_b:
            high = b
        else:
            low = a
        greatest = max(greatest, at_a, at_b)
    return greatest


def resisted_maximum(body, th0, om0, turned):
    """Return the maximum abs(F)/N of a resisted rolling arc: samples, then golden section around the largest."""
    if om0 == 0.0 and turned == 0.0:
        # at rest the couple takes any value that holds the hoop
        return abs(body.gt) / body.gn if body.gn > 0.0 else math.inf
    rho = math.copysign(body.resist, turned)
    count = 4 + int(abs(turned) * RESISTED_SAMPLES_PER_RADIAN)
    step = turned / count
    th = th0
    u = om0 * om0
    greatest = required_friction(body, th, u, rho, 0.0)
    low_th = th0
    low_u = u
    for i in range(1, count + 1):
        need = required_friction(body, th, u, rho, step)
        if need > greatest:
            greatest = need
            low_th = th
            low_u = u
        u = resisted_u(body, th, u, rho, step)
        th = th0 + step * i
    high = 2.0 * step if abs(low_th + 2.0 * step - th0) <= abs(turned) else step
    return maximum_between(body, low_th, low_u, rho, 0.0, high, greatest)


def maximum_required_friction(body, th0, om0, turned):
    """Return the maximum abs(F)/N of a rolling arc: samples, then golden section around the largest."""
    if body.resist > 0.0:
        return resisted_maximum(body, th0, om0, turned)
    u0 = om0 * om0
    count = 2 + int(abs(turned) * SAMPLES_PER_RADIAN)
    step = turned / count
    best = 0
    greatest = -1.0
    for i in range(count + 1):
        need = required_friction(body, th0, u0, 0.0, step * i)
        if need > greatest:
            greatest = need
            best = i
    low = step * max(best - 1, 0)
    high = step * min(best + 1, count)
    return maximum_between(body, th0, u0, 0.0, low, high, greatest)


def greatest_utilization(body, events, last):
    """Return the maximum `utilization` in contact, from the events up to `last`; nan without contact."""
    result = math.nan
    for i in range(last + 1):
        row = events[i]
        if row["kind"] == Event.SLIP_START or (row["kind"] == Event.TAKEOFF and row["before_mode"] == Mode.ROLL):
            # rolling reaches the friction cone at its end
            return utilization(False, body.mu_s, 1.0, body.mu_s, body.mu_k) if body.mu_s < math.inf else 0.0
    for i in range(last):
        row = events[i]
        if not events[i + 1]["t"] > row["t"]:
            continue
        used = math.nan
        if row["after_mode"] == Mode.ROLL:
            used = 0.0
            if 0.0 < body.mu_s < math.inf:
                turned = events[i + 1]["angle"] - row["angle"]
                need = maximum_required_friction(body, row["angle"], row["omega"], turned)
                used = utilization(False, need, 1.0, body.mu_s, body.mu_k)
        elif row["after_mode"] == Mode.SPIN or row["after_mode"] == Mode.SKID:
            used = utilization(True, body.mu_k, 1.0, body.mu_s, body.mu_k)
        if not used <= result and not math.isnan(used):
            result = min(used, 1.0)
    return result
