"""The rates of a scenario's numbers in SI units as a direction in kernel units: of the body, the start and the units."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.circular import sine_and_cosine

# A scenario's numbers, in SI units, and in the same order how each changes with a parameter.
NUMBERS = (
    "radius", "mass", "gravity", "slope", "eccentricity", "inertia_ratio", "mu_static", "mu_kinetic", "restitution",
    "rolling_resistance", "duration", "x", "height", "angle", "omega", "slip", "vy",
)  # fmt: skip
(
    RADIUS, MASS, GRAVITY, SLOPE, ECCENTRICITY, INERTIA_RATIO, MU_STATIC, MU_KINETIC, RESTITUTION,
    ROLLING_RESISTANCE, DURATION, X, HEIGHT, ANGLE, OMEGA, SLIP, VY,
) = range(len(NUMBERS))  # fmt: skip


def direction(given, more):
    """Return the changes in kernel units: of the body and the duration, of the start, of the logarithms of the units.

    `given` holds the numbers of `NUMBERS` and `more` their rates; the results are in the order of `layout`'s PARAMETERS and
    STATE_ROWS, and length, time and mass.
    """
    length = given[RADIUS]
    gravity = given[GRAVITY]
    weighs = gravity > 0.0
    second = math.sqrt(length / (gravity if weighs else 1.0))
    sine, cosine = sine_and_cosine(given[SLOPE])
    by_length = more[RADIUS] / length
    by_time = 0.5 * by_length
    if weighs:
        by_time -= 0.5 * more[GRAVITY] / gravity
        normal, tangential = -sine * more[SLOPE], cosine * more[SLOPE]
    else:
        normal, tangential = cosine * more[GRAVITY], sine * more[GRAVITY]
    by_speed = by_length - by_time
    parameter_tangents = (
        more[ECCENTRICITY],
        more[INERTIA_RATIO],
        more[MU_STATIC],
        more[MU_KINETIC],
        normal,
        tangential,
        more[RESTITUTION],
        (more[DURATION] - given[DURATION] * by_time) / second,
        more[ROLLING_RESISTANCE],
    )
    start = (
        0.0,
        (more[X] - given[X] * by_length) / length,
        (more[HEIGHT] - given[HEIGHT] * by_length) / length,
        more[ANGLE],
        (more[OMEGA] + given[OMEGA] * by_time) * second,
        (more[SLIP] - given[SLIP] * by_speed) * second / length,
        (more[VY] - given[VY] * by_speed) * second / length,
        0.0,
        0.0,
        0.0,
    )
    return parameter_tangents, start, (by_length, by_time, more[MASS] / given[MASS])
