"""The highest value of a smooth function of θ: certified on panels, not on a grid.

The function is an angle atan2(·, ·) between −π and π, which stays smooth where a ratio would have a pole.
Each panel is halved until its Chebyshev series is resolved; its maxima are where the derivative's series
falls through zero. An error δ there changes the value by δ² only, so the value is right to rounding.

No motion is computed, so that speeds from which none rolls, and the limit of no speed at the top, have values too. The
largest abs(F)/N of a motion is found on its own panels, in `derivatives.pieces.required_friction`.
"""

from __future__ import annotations

import math

from hophoop.kernel.model import cone_weights, rolling_forces, rolling_inertia, rolling_u
from hophoop.kernel.numerics.arcs import arctangent2
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.collocation import NOT_FOUND, ORDER, coefficients, first_downcrossing_after
from hophoop.kernel.numerics.tables import NODES

# What is maximised; side = +1 for friction that pushes ahead (F > 0), −1 back.
FORCE_ANGLE, SPEED_ANGLE = 0, 1

WIDTH = math.pi / 16.0  # of the first panel
RESOLVED = 1e-11
NARROWEST = 1e-14  # rad
FLAT = 1e-14
MOST = 100_000


def relative_tail(series, scale):
    """The last coefficients of a Chebyshev series relative to the largest one or `scale`; nan where one is."""
    end = 0.0
    for k in range(ORDER):
        size = abs(series[k])
        if not size < math.inf:
            return math.nan
        scale = max(scale, size)
        if k >= ORDER - 3:
            end = max(end, size)
    return end / scale if scale > 0.0 else 0.0


def force_angle(body, w, th, side):
    """Angle between the contact force of rolling and the normal, F > 0 counted positive for side = 1."""
    u = rolling_u(body, 0.0, w, th)
    s, c = sine_and_cosine(th)
    friction, normal = rolling_forces(body, s, c, u, 0.0)
    return arctangent2(side * friction, normal)


def cone_margin_line(body, th, side):
    """(A, B): the margin to one side of the friction cone is A + B w, with w the square of v at θ = 0."""
    s, c = sine_and_cosine(th)
    a, b = cone_weights(body.mu_s)
    from_rest = rolling_u(body, 0.0, 0.0, th)
    growth = rolling_inertia(body, 1.0) / rolling_inertia(body, c)
    friction0, normal0 = rolling_forces(body, s, c, 0.0, 0.0)
    friction1, normal1 = rolling_forces(body, s, c, 1.0, 0.0)
    steady = a * normal0 - b * side * friction0
    rate = a * (normal1 - normal0) - b * side * (friction1 - friction0)
    return steady + rate * from_rest, rate * growth


def searched(what, body, w, th, side):
    """The function that is maximised."""
    if what == FORCE_ANGLE:
        return force_angle(body, w, th, side)
    steady, rate = cone_margin_line(body, th, side)
    return arctangent2(-rate, steady)


def derivative(series, out):
    """Chebyshev series of the derivative with respect to ξ."""
    above = 0.0
    current = 0.0
    for k in range(ORDER - 1, 0, -1):
        following = above + 2.0 * k * series[k]
        out[k - 1] = following
        above, current = current, following
    out[ORDER - 1] = 0.0
    out[0] *= 0.5


def highest(what, body, w, begin, end, side, scratch):
    """(largest value, θ where it is) on [begin, end]."""
    slope = scratch.weights
    best = searched(what, body, w, begin, side)
    place = begin
    at_end = searched(what, body, w, end, side)
    if at_end > best:
        best = at_end
        place = end
    low = begin
    width = WIDTH
    for _ in range(MOST):
        width = min(width, end - low)
        last = width == end - low
        for i in range(ORDER):
            scratch.values[0, i] = searched(what, body, w, low + 0.5 * width * (1.0 + NODES[i]), side)
        coefficients(scratch.values[0], scratch.series)
        if not relative_tail(scratch.series, 1.0) <= RESOLVED and width > NARROWEST:
            width *= 0.5
            continue
        derivative(scratch.series, slope)
        change = 0.0
        for k in range(ORDER):
            change += abs(slope[k])
        xi = -2.0
        while change > FLAT:  # what is constant has no root to be found
            xi = first_downcrossing_after(slope, xi, 0.0, scratch.stack)
            if xi == NOT_FOUND:
                break
            th = low + 0.5 * width * (1.0 + xi)
            value = searched(what, body, w, th, side)
            if value > best:
                best = value
                place = th
        low += width
        if last:
            break
        value = searched(what, body, w, low, side)
        if value > best:
            best = value
            place = low
        width *= 2.0
    return best, place
