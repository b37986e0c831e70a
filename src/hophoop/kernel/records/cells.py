"""Units, body and start of a cell."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.physics.body import Body
from hophoop.kernel.records.layout import (
    ANGLE,
    ECCENTRICITY,
    GRAVITY,
    HEIGHT,
    IDEAL,
    INERTIA_RATIO,
    LAW,
    MASS,
    MU_KINETIC,
    MU_STATIC,
    OMEGA,
    RADIUS,
    RESTITUTION,
    ROLLING_RESISTANCE,
    SLIP,
    SLOPE,
    START_MODE,
    STRIKE,
    VY,
    X,
)  # fmt: skip
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.units import scales_from


def scales_of(cells, k):
    """Return the units of a cell."""
    return scales_from(cells[RADIUS, k], second_of(cells, k), cells[MASS, k])


def body_of(cells, k):
    """Return hoop and plane of a cell, as `scenario.to_body` does."""
    weight = 1.0 if cells[GRAVITY, k] > 0.0 else 0.0
    s, c = sine_and_cosine(cells[SLOPE, k])
    return Body(
        cells[ECCENTRICITY, k],
        cells[INERTIA_RATIO, k],
        cells[MU_STATIC, k],
        cells[MU_KINETIC, k],
        weight * c,
        weight * s,
        cells[RESTITUTION, k],
        int(cells[LAW, k]),
        cells[STRIKE, k] != 0.0,
        weight * cells[SLOPE, k],
        cells[IDEAL, k] != 0.0,
        cells[ROLLING_RESISTANCE, k],
    )


def second_of(cells, k):
    """Return the unit of time of a cell, as `scenario.time_unit` does."""
    gravity = cells[GRAVITY, k]
    return math.sqrt(cells[RADIUS, k] / (gravity if gravity > 0.0 else 1.0))


def start_of(cells, k, second):
    """Return the start of a cell in kernel units."""
    radius = cells[RADIUS, k]
    speed = radius / second
    return start_state(
        cells[X, k] / radius,
        cells[HEIGHT, k] / radius,
        cells[ANGLE, k],
        cells[SLIP, k] / speed,
        cells[VY, k] / speed,
        cells[OMEGA, k] * second,
    )


def mode_of(cells, k):
    """Return the mode at the start of a cell, −1 if the rule selects it."""
    return int(cells[START_MODE, k])
