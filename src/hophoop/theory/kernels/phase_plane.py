"""The (θ, θ̇) plane, case by case."""

from __future__ import annotations

import math

from hophoop.kernel.model import Mode, can_roll, cone_weights, free_acceleration, next_mode, rolling_forces
from hophoop.kernel.numerics.circular import sine_and_cosine

ROLL, SKIM, NONE = int(Mode.ROLL), int(Mode.SKIM), len(Mode)


def mode_without_slip(body, angle, rate):
    """The mode that follows a state of contact without slip; NONE if there is none."""
    if body.kap > 0.0:
        mode = next_mode(body, angle, 0.0, rate, 0.0)
        return mode if mode <= SKIM else NONE
    if can_roll(body, angle, rate):
        return ROLL
    s, c = sine_and_cosine(angle)
    return SKIM if s * rate > 0.0 or c == 1.0 else NONE


def modes(body, angles, rates, out):
    for k in range(angles.shape[0]):
        out[k] = mode_without_slip(body, angles[k], rates[k])


def narrowed(low, high, at_rest, moving):
    """The part of [low, high] where at_rest + (moving − at_rest) u ≥ 0."""
    rate = moving - at_rest
    if rate > 0.0:
        return max(low, -at_rest / rate), high
    if rate < 0.0:
        return low, min(high, -at_rest / rate)
    return low, high if at_rest >= 0.0 else -1.0


def rolling_ranges(body, angles, out):
    """Rolling needs N ≥ 0 and two cone margins ≥ 0, each a line in u = θ̇²."""
    for k in range(angles.shape[0]):
        s, c = sine_and_cosine(angles[k])
        a, b = cone_weights(body.mu_s)
        friction0, normal0 = rolling_forces(body, s, c, 0.0, 0.0)
        friction1, normal1 = rolling_forces(body, s, c, 1.0, 0.0)
        low, high = narrowed(0.0, math.inf, normal0, normal1)
        for side in (1.0, -1.0):
            low, high = narrowed(low, high, a * normal0 - b * side * friction0, a * normal1 - b * side * friction1)
        out[k, 0] = math.sqrt(low) if low <= high else math.nan
        out[k, 1] = math.sqrt(high) if low <= high else math.nan


def lift_off(body, th):
    """Magnitude of θ̇ at which f_n = 0, infinite where the load is not up; f_n is linear in θ̇²."""
    s, c = sine_and_cosine(th)
    _, at_rest = free_acceleration(body, s, c, 0.0)
    _, moving = free_acceleration(body, s, c, 1.0)
    return math.sqrt(-at_rest / (moving - at_rest)) if moving > at_rest else math.inf


def lift_off_speeds(body, angles, out):
    for k in range(angles.shape[0]):
        out[k] = lift_off(body, angles[k])
