"""Mass properties of a hoop: the ideal hoop, and hoops assembled from parts (docs/model.md#the-body)."""

from __future__ import annotations

from hophoop.kernel.numerics.arcs import hypotenuse
from hophoop.kernel.numerics.double_double import plus

RING, DISK, POINT_MASS, RADIAL_ROD, TANGENTIAL_ROD = range(5)
# Columns of a table of parts: shape, mass, two lengths, and the position of the centre on the line from C to the load. The
# lengths are the inner and outer radius of a ring, the radius of a disk, or the length of a rod.
SHAPE, MASS, FIRST, SECOND, AT = range(5)

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
        mass, low = plus(mass, low, parts[k, MASS])
    if not mass > 0.0:
        return mass, 0.0, 0.0
    first = parts[0, AT] / radius
    moment = 0.0
    low = 0.0
    for k in range(parts.shape[0]):
        moment, low = plus(moment, low, parts[k, MASS] * (parts[k, AT] / radius - first))
    centre = first + moment / mass
    inertia = 0.0
    low = 0.0
    for k in range(parts.shape[0]):
        own = part_inertia(parts[k, SHAPE], parts[k, MASS], parts[k, FIRST], parts[k, SECOND])
        arm = parts[k, AT] / radius - centre
        inertia, low = plus(inertia, low, own / (radius * radius) + parts[k, MASS] * (arm * arm))
    distance = abs(centre)
    return mass, 1.0 if 1.0 < distance < 1.0 + ROUNDED else distance, inertia / mass
