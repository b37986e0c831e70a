"""What ends a panel, a flight or a phase without rotation."""

from __future__ import annotations

from enum import IntEnum


class Ending(IntEnum):
    """What the event loop meets. Where two come at once, the one that is first here counts.

    The two sides of the friction cone are one place where N comes to zero without F: the direction of rotation then decides.
    """

    CONE_FORWARD = 0
    """Rolling needs all friction, F > 0."""
    CONE_BACKWARD = 1
    """Rolling needs all friction, F < 0."""
    LIFT_OFF = 2
    """N comes to zero in slip."""
    SLIP_END = 3
    """v_t comes to zero."""
    LANDING = 4
    """The gap closes."""
    LOAD_STRIKE = 5
    """The load of a massless hoop strikes the plane."""
    ANGLE_LIMIT = 6
    """The motion has turned by its span."""
    TIME_LIMIT = 7
    """The duration is over."""
    TURNING_POINT = 8
    """θ̇ comes to zero at the end of a panel."""
    REST = 9
    """A hoop that does not turn stays so."""
    SINGULAR = 10
    """Slip cannot be followed further: p_σ comes to zero."""
    SEARCH_LIMIT = 11
    """Rolling, or the search for a landing, is given up."""
    CONTINUES = 12
    """Nothing: the phase goes on."""
