"""The input of the kernels: one column of numbers per motion, its units, its body and its start; hoops assembled from parts."""

from __future__ import annotations

import math
from enum import IntEnum

from hophoop.kernel.numerics.arcs import hypotenuse
from hophoop.kernel.numerics.arithmetic import plus
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.physics.body import Body, scales_from
from hophoop.kernel.records.state import start_state

# Rows of the array of cells, in SI units: the only list of the numbers that the kernels take. The rows of hoop and plane come
# first, in the order of the table of parameters; they alone make a body. `MODE` is −1 if the rule selects it; `ALLOWED` is 0 if
# the values contradict each other.
Cell = IntEnum(
    "Cell",
    """
    ECCENTRICITY INERTIA_RATIO RADIUS MASS MU_STATIC MU_KINETIC SLOPE GRAVITY RESTITUTION ROLLING_RESISTANCE LAW
    PAINLEVE_IMPACT IDEAL X HEIGHT ANGLE VY OMEGA SLIP MODE DURATION MAX_EVENTS ALLOWED
    """,
    start=0,
)
CELL = tuple(row.name.lower() for row in Cell)

# Numbers of a compliant contact, in SI units; nan selects the default.
Contact = IntEnum("Contact", "LAW FRICTION_LAW STIFFNESS DAMPING RESTITUTION SLIP_SPEED TANGENTIAL_STIFFNESS RTOL", start=0)
CONTACT = tuple(row.name.lower() for row in Contact)


# --- mass properties of a hoop: the ideal hoop, and hoops assembled from parts (docs/model.md#the-body)

RING, DISK, POINT_MASS, RADIAL_ROD, TANGENTIAL_ROD = range(5)
# Columns of a table of parts: shape, mass, two lengths, and the position of the centre on the line from C to the load. The
# lengths are the inner and outer radius of a ring, the radius of a disk, or the length of a rod.
SHAPE, PART_MASS, FIRST, SECOND, AT = range(5)

ROUNDED = 2e-12  # of ε: up to it beyond the rim, G is on the rim


def ideal_inertia(load_fraction):
    """Return κ of a thin ring with a point load: 1 − γ², with G at ε = γ."""
    return (1.0 - load_fraction) * (1.0 + load_fraction)


def part_inertia(shape, mass, first, second):
    """Return the moment of inertia about the part's own centre."""
    if shape == RING:
        return 0.5 * mass * (first * first + second * second)
    if shape == DISK:
        return 0.5 * mass * (first * first)
    if shape == POINT_MASS:
        return 0.0
    return mass * (first * first) / 12.0


def part_reach(shape, first, second, at):
    """Return the distance of the part's farthest point from C."""
    if shape == RING:
        return second
    if shape == DISK:
        return abs(at) + first
    if shape == POINT_MASS:
        return abs(at)
    if shape == RADIAL_ROD:
        return abs(at) + 0.5 * first
    return hypotenuse(at, 0.5 * first)


def combined(radius, parts):
    """Return (mass, ε, κ) of parts, each a row of the table; sums are double-doubles.

    A part of negative mass is a hole. Without mass there is no body: ε and κ are then 0. Positions are relative to the first
    part, so that parts at one position have exactly that centre and no moment of inertia.
    """
    mass = 0.0
    low = 0.0
    for k in range(parts.shape[0]):
        mass, low = plus(mass, low, parts[k, PART_MASS])
    if not mass > 0.0:
        return mass, 0.0, 0.0
    first = parts[0, AT] / radius
    moment = 0.0
    low = 0.0
    for k in range(parts.shape[0]):
        moment, low = plus(moment, low, parts[k, PART_MASS] * (parts[k, AT] / radius - first))
    centre = first + moment / mass
    inertia = 0.0
    low = 0.0
    for k in range(parts.shape[0]):
        own = part_inertia(parts[k, SHAPE], parts[k, PART_MASS], parts[k, FIRST], parts[k, SECOND])
        arm = parts[k, AT] / radius - centre
        inertia, low = plus(inertia, low, own / (radius * radius) + parts[k, PART_MASS] * (arm * arm))
    distance = abs(centre)
    return mass, 1.0 if 1.0 < distance < 1.0 + ROUNDED else distance, inertia / mass


# --- units, body and start of a cell


def scales_of(cell):
    """Return the units of a cell."""
    return scales_from(cell[Cell.RADIUS], second_of(cell), cell[Cell.MASS])


def body_of(cell):
    """Return hoop and plane of a cell, of which the rows up to IDEAL are enough."""
    weight = 1.0 if cell[Cell.GRAVITY] > 0.0 else 0.0
    s, c = sine_and_cosine(cell[Cell.SLOPE])
    return Body(
        eps=cell[Cell.ECCENTRICITY],
        kap=cell[Cell.INERTIA_RATIO],
        mu_s=cell[Cell.MU_STATIC],
        mu_k=cell[Cell.MU_KINETIC],
        gn=weight * c,
        gt=weight * s,
        rest=cell[Cell.RESTITUTION],
        law=int(cell[Cell.LAW]),
        painleve_impact=cell[Cell.PAINLEVE_IMPACT] != 0.0,
        slope=weight * cell[Cell.SLOPE],
        resist=cell[Cell.ROLLING_RESISTANCE],
    )


def second_of(cell):
    """Return the unit of time of a cell [s]."""
    gravity = cell[Cell.GRAVITY]
    return math.sqrt(cell[Cell.RADIUS] / (gravity if gravity > 0.0 else 1.0))


def start_of(cell, second):
    """Return the start of a cell in kernel units."""
    radius = cell[Cell.RADIUS]
    speed = radius / second
    return start_state(
        cell[Cell.X] / radius,
        cell[Cell.HEIGHT] / radius,
        cell[Cell.ANGLE],
        cell[Cell.SLIP] / speed,
        cell[Cell.VY] / speed,
        cell[Cell.OMEGA] * second,
    )


def mode_of(cell):
    """Return the mode at the start of a cell, −1 if the rule selects it."""
    return int(cell[Cell.MODE])
