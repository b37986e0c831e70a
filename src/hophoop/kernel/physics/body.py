"""Dimensionless parameters of hoop and plane, and the codes of modes, events and statuses (docs/model.md#the-body).

Kernels work in units of R (length), m (mass) and √(R/g) (time). If g = 0, the unit of time is the one for which g would be 1
m/s².
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple


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
    strike: bool  # indeterminate Painlevé contact: impact (True) or flight (False)
    slope: float  # β, whose rounded cosine and sine are gn and gt; 0 without gravity [rad]
    ideal: bool = False  # True if κ = 1 − ε², which `kap` rounds
    resist: float = 0.0  # rolling resistance f


class Mode(IntEnum):
    """Modes of contact between rim and plane."""

    ROLL = 0
    SPIN = 1
    SKID = 2
    FLIGHT = 3
    SKIM = 4


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


EVENT_NAMES = tuple(event.name.lower() for event in Event)
# Events that do not end a phase: the mode stays.
PASSING = (int(Event.TURN), int(Event.APEX), int(Event.KANE_GAIN), int(Event.REST))


class Status(IntEnum):
    """How a motion ended; `BUFFER` is internal (the tables were too short, and the motion is run again)."""

    COMPLETED = 0
    AT_REST = 1
    JAMMED = 2
    UNDETERMINED = 3
    EVENT_LIMIT = 4
    BUFFER = 5


STATUS_NAMES = tuple(status.name.lower() for status in Status if status != Status.BUFFER)


class ImpactLaw(IntEnum):
    """Impact law: when the restitution of an impact ends."""

    NEWTON = 0
    POISSON = 1
    STRONGE = 2
