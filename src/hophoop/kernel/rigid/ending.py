"""Reasons why a panel, a flight or a phase without rotation ends."""

from __future__ import annotations

from enum import IntEnum


class Ending(IntEnum):
    """Endings in the order of their priority: of simultaneous ones, the first in this list counts.

    If N reaches zero without F, both sides of the friction cone are reached at once. The direction of rotation then decides
    between them.
    """

    CONE_FORWARD = 0
    """Rolling needs all available friction, F > 0."""
    CONE_BACKWARD = 1
    """Rolling needs all available friction, F < 0."""
    LIFT_OFF = 2
    """N reaches zero in slip."""
    SLIP_END = 3
    """v_t reaches zero."""
    LANDING = 4
    """The gap closes."""
    LOAD_STRIKE = 5
    """The load of a massless hoop strikes the plane."""
    ANGLE_LIMIT = 6
    """θ has changed by the angle span of the motion."""
    TIME_LIMIT = 7
    """The duration is over."""
    TURNING_POINT = 8
    """θ̇ reaches zero at the end of a panel."""
    REST = 9
    """A hoop with θ̇ = 0 stays at rest."""
    SINGULAR = 10
    """Slip cannot be resolved further: p_σ reaches zero."""
    SEARCH_LIMIT = 11
    """Rolling could not be resolved, or the search for a landing was given up."""
    CONTINUES = 12
    """No ending: the phase continues."""
