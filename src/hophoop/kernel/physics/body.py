"""Dimensionless parameters of hoop and plane, and the codes of modes, events and statuses (docs/model.md#the-body).

Kernels work in units of R (length), m (mass) and √(R/g) (time). If g = 0, the unit of time is the one for which g would be 1
m/s².
"""

from __future__ import annotations

from enum import IntEnum
from typing import Final, NamedTuple


class Body(NamedTuple):
    """Dimensionless parameters of hoop and plane."""

    eps: float  # eccentricity
    kap: float  # moment of inertia about G over m R²
    mu_s: float  # static friction
    mu_k: float  # kinetic friction
    gn: float  # gravity into the plane (cos β, or 0)
    gt: float  # gravity along the plane, downhill positive (sin β, or 0)
    rest: float  # restitution e
    law: int  # ImpactLaw
    painleve_impact: bool  # indeterminate Painlevé contact: impact (True) or flight (False)
    slope: float  # β, whose rounded cosine and sine are gn and gt; 0 without gravity [rad]
    resist: float = 0.0  # rolling resistance f


# Kernels use the members of the three enums below as plain integers, by the names that follow each.


class Mode(IntEnum):
    """Modes of contact between rim and plane."""

    ROLL = 0
    SPIN = 1
    SKID = 2
    FLIGHT = 3
    SKIM = 4


ROLL, SPIN, SKID, FLIGHT, SKIM = map(int, Mode)
MODE_LETTERS = ("R", "S", "K", "H", "M")  # S: v_t < 0, K: v_t > 0


class Event(IntEnum):
    """Kinds of events, in the order in which simultaneous ones are written."""

    START = 0
    SLIP_START = 1
    STICK = 2
    SLIP_REVERSAL = 3
    TAKEOFF = 4
    IMPACT = 5
    TURN = 6
    APEX = 7
    BOUNCE_LIMIT = 8
    PAINLEVE_INCONSISTENT = 9
    PAINLEVE_INDETERMINATE = 10
    JAM = 11
    KANE_GAIN = 12
    SKIM = 13
    REST = 14
    END = 15


(
    START, SLIP_START, STICK, SLIP_REVERSAL, TAKEOFF, IMPACT, TURN, APEX, BOUNCE_LIMIT, PAINLEVE_INCONSISTENT,
    PAINLEVE_INDETERMINATE, JAM, KANE_GAIN, SKIM_START, REST, END,
) = map(int, Event)  # fmt: skip
EVENT_NAMES = tuple(event.name.lower() for event in Event)
# Events that do not end a phase: the mode stays.
PASSING = (TURN, APEX, KANE_GAIN, REST)


class Status(IntEnum):
    """How a motion ended; `BUFFER` is internal (the tables were too short, and the motion is run again)."""

    COMPLETED = 0
    AT_REST = 1
    JAMMED = 2
    UNDETERMINED = 3
    EVENT_LIMIT = 4
    BUFFER = 5


COMPLETED, AT_REST, JAMMED, UNDETERMINED, EVENT_LIMIT, BUFFER = map(int, Status)
STATUS_NAMES = tuple(status.name.lower() for status in Status if status != Status.BUFFER)


class ImpactLaw(IntEnum):
    """Impact law: when the restitution of an impact ends."""

    NEWTON = 0
    POISSON = 1
    STRONGE = 2


# --- SI values of the kernel units, in one order of operations for Python and the browser's module


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


# --- ranges of numbers that follow from others, so that kernels check them too

MASS_RANGE: Final = (1e-12, 1e12)  # [kg]
INERTIA_RANGE: Final = (1e-12, 1e6)  # or 0
SLOPE_RANGE: Final = (-1.57, 1.57)  # [rad]

# Of a start, so that no flight takes so many revolutions that its angle has no digits left.
MOST_SPEED: Final = 1e6  # of the centre and of the rim's rotation, in √(g R)
MOST_HEIGHT: Final = 1e6  # in radii

# Of a compliant contact relative to its hoop: stiffness in m g/R, slip speed in √(g R), and the depth in radii from the weight
# and the speeds of the start. A rim that sinks deeper has no contact with a plane in any physical sense.
STIFFNESS_RANGE: Final = (1e-2, 1e15)
SLIP_SPEED_RANGE: Final = (1e-12, 1e6)
MOST_DEPTH: Final = 100.0
