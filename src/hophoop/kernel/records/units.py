"""SI values of the kernel units, in one order of operations for Python and the browser's module."""

from __future__ import annotations

from typing import NamedTuple


class Scales(NamedTuple):
    """SI values of the kernel units."""

    length: float  # [m]
    time: float  # [s]
    mass: float  # [kg]
    speed: float  # [m/s]
    rate: float  # [rad/s]
    acceleration: float  # [m/s²]
    force: float  # [N]
    impulse: float  # [N s]
    energy: float  # [J]


def scales_from(length, second, mass):
    """Return all units, from those of length, time and mass."""
    speed = length / second
    acceleration = speed / second
    impulse = mass * speed
    return Scales(length, second, mass, speed, 1.0 / second, acceleration, mass * acceleration, impulse, impulse * speed)
