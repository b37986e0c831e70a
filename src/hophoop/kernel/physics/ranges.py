"""Ranges of numbers that follow from others, so that kernels check them too: of a hoop, a plane and a compliant contact."""

from __future__ import annotations

from typing import Final

MASS: Final = (1e-12, 1e12)  # [kg]
INERTIA_RATIO: Final = (1e-12, 1e6)  # or 0
SLOPE: Final = (-1.57, 1.57)  # [rad]

# Of a compliant contact relative to its hoop: stiffness in m g/R, slip speed in √(g R), and the depth in radii from the weight
# and the speeds of the start. A rim that sinks deeper has no contact with a plane in any physical sense.
STIFFNESS: Final = (1e-2, 1e15)
SLIP_SPEED: Final = (1e-12, 1e6)
MOST_DEPTH: Final = 100.0
