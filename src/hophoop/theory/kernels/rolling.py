"""Rolling, case by case: each function fills a column of answers, in the kernels' units."""

from __future__ import annotations

import math

from hophoop.kernel.model import cone_weights, rolling_forces, rolling_inertia, rolling_u
from hophoop.kernel.numerics.arcs import arccosine, arcsine
from hophoop.kernel.numerics.circular import cosine, sine_and_cosine, tangent
from hophoop.kernel.records import new_scratch
from hophoop.theory.kernels.arcs import TURN, blocking, turning_point
from hophoop.theory.kernels.extrema import FORCE_ANGLE, highest


def speeds(body, angles, speeds, out):
    for k in range(angles.shape[0]):
        w = speeds[k] * speeds[k]
        u = rolling_u(body, 0.0, w, angles[k])
        reached = math.isnan(blocking(body, 0.0, w, angles[k]))
        out[k] = math.copysign(math.sqrt(u), speeds[k]) if reached else math.nan


def forces(body, angles, rates, out):
    for k in range(angles.shape[0]):
        rate = rates[k]
        s, c = sine_and_cosine(angles[k])
        out[k, 0], out[k, 1] = rolling_forces(body, s, c, rate * rate, 0.0)


def kinetic(body, angles, rates, out):
    for k in range(angles.shape[0]):
        inertia = rolling_inertia(body, cosine(angles[k]))
        out[k] = 0.5 * inertia * rates[k] * rates[k]


def needed_friction(body, speed, scratch):
    """(the largest abs(F)/N in the first turn of rolling, θ where it is), from the speed at θ = 0."""
    w = speed * speed
    # on the level both halves of a turn are alike
    end = math.copysign(math.pi if body.gt == 0.0 else TURN, speed)
    if body.kap == 0.0:  # rolling loses N at 90° at the latest
        return math.inf, math.copysign(math.pi, end)
    blocked = blocking(body, 0.0, w, end)
    if not math.isnan(blocked):
        end = turning_point(body, 0.0, w, blocked)
    low = min(end, 0.0)
    high = max(end, 0.0)
    largest, place = highest(FORCE_ANGLE, body, w, low, high, 1.0, scratch)
    other, elsewhere = highest(FORCE_ANGLE, body, w, low, high, -1.0, scratch)
    if other > largest:
        largest = other
        place = elsewhere
    return tangent(largest) if largest < 0.5 * math.pi else math.inf, place


def needed_frictions(body, speeds, out):
    scratch = new_scratch()
    for k in range(speeds.shape[0]):
        out[k, 0], out[k, 1] = needed_friction(body, speeds[k], scratch)


def contact_loss(body, speed):
    """(θ and θ̇ where rolling of the massless hoop ends, whether by friction), from the speed at θ = 0."""
    w = speed * speed
    # F/N = tan(θ/2) is at its limit at 2 atan μs; before that N falls to zero where cos θ = w/gn.
    angle = 0.0 if w >= body.gn else arccosine(w / body.gn)
    a, _ = cone_weights(body.mu_s)
    slides = 2.0 * arcsine(min(a, 1.0))
    by_friction = slides < angle
    if by_friction:
        angle = slides
    rate = math.copysign(math.sqrt(rolling_u(body, 0.0, w, angle)), speed)
    return math.copysign(angle, speed), rate, by_friction


def contact_losses(body, speeds, out):
    for k in range(speeds.shape[0]):
        angle, rate, by_friction = contact_loss(body, speeds[k])
        out[k, 0] = angle
        out[k, 1] = rate
        out[k, 2] = 1.0 if by_friction else 0.0
