"""The rates of a scenario's numbers in SI units as a direction in kernel units: of the body, the start and the units."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.records import Cell


def direction(given, more):
    """Return the changes in kernel units: of the body and the duration, of the start, of the logarithms of the units.

    `given` is a cell and `more` holds the rates of its rows; the results are in the order of `layout`'s PARAMETERS and
    STATE_ROWS, and length, time and mass.
    """
    length = given[Cell.RADIUS]
    gravity = given[Cell.GRAVITY]
    weighs = gravity > 0.0
    second = math.sqrt(length / (gravity if weighs else 1.0))
    sine, cosine = sine_and_cosine(given[Cell.SLOPE])
    by_length = more[Cell.RADIUS] / length
    by_time = 0.5 * by_length
    if weighs:
        by_time -= 0.5 * more[Cell.GRAVITY] / gravity
        normal, tangential = -sine * more[Cell.SLOPE], cosine * more[Cell.SLOPE]
    else:
        normal, tangential = cosine * more[Cell.GRAVITY], sine * more[Cell.GRAVITY]
    by_speed = by_length - by_time
    parameter_tangents = (
        more[Cell.ECCENTRICITY],
        more[Cell.INERTIA_RATIO],
        more[Cell.MU_STATIC],
        more[Cell.MU_KINETIC],
        normal,
        tangential,
        more[Cell.RESTITUTION],
        (more[Cell.DURATION] - given[Cell.DURATION] * by_time) / second,
        more[Cell.ROLLING_RESISTANCE],
    )
    start = (
        0.0,
        (more[Cell.X] - given[Cell.X] * by_length) / length,
        (more[Cell.HEIGHT] - given[Cell.HEIGHT] * by_length) / length,
        more[Cell.ANGLE],
        (more[Cell.OMEGA] + given[Cell.OMEGA] * by_time) * second,
        (more[Cell.SLIP] - given[Cell.SLIP] * by_speed) * second / length,
        (more[Cell.VY] - given[Cell.VY] * by_speed) * second / length,
        0.0,
        0.0,
        0.0,
    )
    return parameter_tangents, start, (by_length, by_time, more[Cell.MASS] / given[Cell.MASS])
