"""Names of quantities with their units: for axes, files and tables."""

from __future__ import annotations

from typing import Final

from hophoop.vocabulary.parameters import TABLE

TIME: Final = "Time (s)"
ANGLE: Final = "Rotation angle θ (°)"
ROTATION: Final = r"Angular velocity $\dot\theta$ (rad/s)"
VELOCITY: Final = "Velocity (m/s)"
ENERGY: Final = "Energy (J)"
FORCE: Final = "Force (N)"
UTILIZATION: Final = "Friction utilization"
GAP: Final = "Gap under the rim (m)"
PLACE: Final = "Place along the plane (m)"
DISTANCE: Final = "Level distance (m)"  # in pictures with a tilted slope
HEIGHT: Final = "Height (m)"
POINT_SPEED: Final = "Speed of the ring's points (m/s)"

PARAMETERS: Final = {row.path: row.figure for row in TABLE if row.figure}
"""Short names of parameters by path, for the axes of maps."""


def normal_loss(contact: str) -> str:
    """Return the name of the energy lost in the normal direction of the contact.

    Parameters
    ----------
    contact : str
        Model of the contact: rigid or compliant.

    Returns
    -------
    label : str

    Examples
    --------
    >>> normal_loss("rigid"), normal_loss("compliant")
    ('lost in impacts, normal part', 'lost in the damper')
    """
    return "lost in impacts, normal part" if contact == "rigid" else "lost in the damper"


def with_unit(text: str, unit: str) -> str:
    """Return a name with its unit, for axes and tables.

    Parameters
    ----------
    text, unit : str
        A pure number has the unit "1", a word none.

    Returns
    -------
    label : str

    Examples
    --------
    >>> with_unit("Duration", "s"), with_unit("Friction μ", "1")
    ('Duration (s)', 'Friction μ')
    """
    return text if unit in ("1", "") else f"{text} ({unit})"
