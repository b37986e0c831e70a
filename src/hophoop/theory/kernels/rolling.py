"""Rolling, case by case: each function fills a column of answers, in the kernels' units."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.arcs import arccosine, arcsine
from hophoop.kernel.numerics.circular import cosine, sine_and_cosine, tangent
from hophoop.kernel.physics.closed_forms import rolling_u
from hophoop.kernel.physics.contact import cone_weights, rolling_forces, rolling_inertia
from hophoop.kernel.records.layout import new_scratch
from hophoop.theory.kernels.arcs import TURN, blocking, rocking_time, time_from_top, turning_point
from hophoop.theory.kernels.extrema import FORCE_ANGLE, highest
from hophoop.theory.kernels.rows import body_of


def speeds(bodies, angles, speeds, out):
    for k in range(angles.shape[0]):
        body = body_of(bodies[k])
        w = speeds[k] * speeds[k]
        u = rolling_u(body, 0.0, w, angles[k])
        reached = math.isnan(blocking(body, 0.0, w, angles[k]))
        out[k] = math.copysign(math.sqrt(u), speeds[k]) if reached else math.nan


def forces(bodies, angles, rates, out):
    for k in range(angles.shape[0]):
        body = body_of(bodies[k])
        rate = rates[k]
        s, c = sine_and_cosine(angles[k])
        out[k, 0], out[k, 1] = rolling_forces(body, s, c, rate * rate, 0.0)


def kinetic(bodies, angles, rates, out):
    for k in range(angles.shape[0]):
        inertia = rolling_inertia(body_of(bodies[k]), cosine(angles[k]))
        out[k] = 0.5 * inertia * rates[k] * rates[k]


def times(bodies, angles, speeds, out):
    for k in range(angles.shape[0]):
        body = body_of(bodies[k])
        w = speeds[k] * speeds[k]
        if angles[k] == 0.0:
            out[k] = 0.0
        elif math.isnan(blocking(body, 0.0, w, angles[k])):
            time = time_from_top(body, w, angles[k])
            out[k] = -time if speeds[k] * angles[k] < 0.0 else time
        else:
            out[k] = math.nan


def rocking_periods(bodies, angles, out):
    for k in range(angles.shape[0]):
        out[k] = rocking_time(body_of(bodies[k]), angles[k])


def needed_frictions(bodies, speeds, out):
    scratch = new_scratch()
    for k in range(speeds.shape[0]):
        body = body_of(bodies[k])
        w = speeds[k] * speeds[k]
        # on the level both halves of a turn are alike
        end = math.copysign(math.pi if body.gt == 0.0 else TURN, speeds[k])
        if body.kap == 0.0:  # rolling loses N at 90° at the latest
            out[k, 0] = math.inf
            out[k, 1] = math.copysign(math.pi, end)
            continue
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
        out[k, 0] = tangent(largest) if largest < 0.5 * math.pi else math.inf
        out[k, 1] = place


def contact_losses(bodies, speeds, out):
    for k in range(speeds.shape[0]):
        body = body_of(bodies[k])
        w = speeds[k] * speeds[k]
        # F/N = tan(θ/2) is at its limit at 2 atan μs; before that N falls to zero where cos θ = w/gn.
        if w >= body.gn:
            angle = 0.0
        else:
            angle = arccosine(w / body.gn)
        a, _ = cone_weights(body.mu_s)
        slides = 2.0 * arcsine(min(a, 1.0))
        by_friction = slides < angle
        if by_friction:
            angle = slides
        out[k, 0] = math.copysign(angle, speeds[k])
        out[k, 1] = math.copysign(math.sqrt(rolling_u(body, 0.0, w, angle)), speeds[k])
        out[k, 2] = 1.0 if by_friction else 0.0
