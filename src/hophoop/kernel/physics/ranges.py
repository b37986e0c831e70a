"""Ranges of numbers that follow from others, so that kernels check them too: of a hoop, a plane, a start and a contact."""

from __future__ import annotations

from typing import Final

MASS: Final = (1e-12, 1e12)  # [kg]
INERTIA_RATIO: Final = (1e-12, 1e6)  # or 0
SLOPE: Final = (-1.57, 1.57)  # [rad]

# Of a start, so that no flight takes so many revolutions that its angle has no digits left.
MOST_SPEED: Final = 1e6  # of the centre and of the rim's rotation, in √(g R)
MOST_HEIGHT: Final = 1e6  # in radii

# Of a compliant contact relative to its hoop: stiffness in m g/R, slip speed in √(g R), and the depth in radii from the weight
# and the speeds of the start. A rim that sinks deeper has no contact with a plane in any physical sense.
STIFFNESS: Final = (1e-2, 1e15)
SLIP_SPEED: Final = (1e-12, 1e6)
MOST_DEPTH: Final = 100.0
