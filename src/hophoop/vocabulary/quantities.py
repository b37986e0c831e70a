"""Quantities of a motion, one row of a table each: unit, meaning, and which results hold them.

A new quantity needs a row of `TABLE` and its place in the result that holds it. Units in files, of axes and of the
kernel's numbers follow.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from hophoop.kernel.physics.body import Scales

PURE: Final = ""
UNITS: Final = {
    PURE: "1",
    "time": "s",
    "length": "m",
    "angle": "rad",
    "speed": "m/s",
    "rate": "rad/s",
    "force": "N",
    "impulse": "N s",
    "energy": "J",
}
"""SI units by the kernel's unit of the same kind, as `Scales` calls it, in the order in which events group their columns."""


class Quantity(NamedTuple):
    """A quantity of a motion."""

    name: str
    scale: str  # one of UNITS
    meaning: str
    held: tuple[str, ...]  # the results that have it: attributes of `Sample`, `EventRecord`, `Velocity` and so on
    lost: bool = False  # whether it is an energy that a rigid motion loses

    @property
    def unit(self) -> str:
        """SI unit."""
        return UNITS[self.scale]


_STATE = ("Sample", "EventRecord", "EventErrors")
_VELOCITY = (*_STATE, "Velocity")
_ENERGY = ("Sample", "Ledger")
_LOSS = (*_ENERGY, "EventRecord")
TABLE: Final = (
    Quantity("mode", PURE, "Mode", ("Sample",)),
    Quantity("t", "time", "Time", _STATE),
    Quantity("x", "length", "Position of the centre along the plane", _STATE),
    Quantity("height", "length", "Gap between rim and plane", _STATE),
    Quantity("angle", "angle", "Angle from the plane's normal to the centre of gravity", _STATE),
    Quantity("vx", "speed", "Velocity of the centre along the plane", _VELOCITY),
    Quantity("vy", "speed", "Velocity of the centre away from the plane", _VELOCITY),
    Quantity("omega", "rate", "Angular velocity", _VELOCITY),
    Quantity("slip", "speed", "Slip velocity of the lowest point", _VELOCITY),
    Quantity("friction_force", "force", "Friction force along the plane", ("Sample",)),
    Quantity("normal_force", "force", "Normal force", ("Sample",)),
    Quantity("impulse_normal", "impulse", "Normal impulse of an impact", ("EventRecord",)),
    Quantity("impulse_tangential", "impulse", "Impulse of an impact along the plane", ("EventRecord",)),
    Quantity("kinetic", "energy", "Kinetic energy", _ENERGY),
    Quantity("potential", "energy", "Potential energy", _ENERGY),
    Quantity("total", "energy", "Kinetic and potential energy", ("Sample",)),
    Quantity("friction", "energy", "Energy lost in slip so far", _LOSS, lost=True),
    Quantity("impact_normal", "energy", "Energy lost in the normal part of impacts so far", _LOSS, lost=True),
    Quantity("impact_tangential", "energy", "Energy lost in the tangential part of impacts so far", _LOSS, lost=True),
    Quantity("rolling_resistance", "energy", "Energy lost to rolling resistance so far", _LOSS, lost=True),
    Quantity("gain", "energy", "Energy that Newton's law of impact has created", ("EventRecord",)),
    Quantity("spring", "energy", "Energy stored in the compliant contact", _ENERGY),
    Quantity("damping", "energy", "Energy lost in the damper of the compliant contact so far", _ENERGY),
    Quantity("residual", "energy", "Energy that does not add up", ("Ledger",)),
    Quantity("range", "energy", "Size of the energies that took part", ("Ledger",)),
)
FRICTION_LOSS: Final = "Energy lost to friction, in slip and in the tangential part of impacts"
QUANTITIES: Final = {quantity.name: quantity for quantity in TABLE}


def held_by(result: str) -> tuple[str, ...]:
    """Return the names of a result's quantities.

    result: 'Sample', 'EventRecord', 'Velocity', 'EventErrors' or 'Ledger'; names: In the table's order.

    Examples
    --------
    >>> held_by("Velocity")
    ('vx', 'vy', 'omega', 'slip')
    """
    return tuple(name for name, quantity in QUANTITIES.items() if result in quantity.held)


COLUMNS: Final = {name: QUANTITIES[name] for name in held_by("Sample") if name != "t"}
"""Columns of a sample over time."""
LOSSES: Final = tuple(name for name, quantity in QUANTITIES.items() if quantity.lost)
"""Energies that a rigid motion loses."""
_ORDER = list(UNITS)
EVENT_NUMBERS: Final = tuple(sorted(held_by("EventRecord"), key=lambda name: _ORDER.index(QUANTITIES[name].scale)))
"""Numbers of an event, grouped by unit."""
EVENT_UNITS: Final = {
    **{name: QUANTITIES[name].unit for name in EVENT_NUMBERS},
    **{f"before_{name}": QUANTITIES[name].unit for name in held_by("Velocity")},
}
"""SI units of the numbers of an event, those just before it included."""


def sizes(scales: Scales) -> dict[str, float]:
    """Return the kernel units in SI units, by quantity.

    sizes: of all quantities that are numbers.
    """
    units = {**scales._asdict(), "angle": 1.0}
    return {name: units[quantity.scale] for name, quantity in QUANTITIES.items() if quantity.scale != PURE}


# Labels of axes.
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


def normal_loss(contact: str) -> str:
    """Return the name of the energy lost in the normal direction of the contact.

    contact: Model of the contact: rigid or compliant.

    Examples
    --------
    >>> normal_loss("rigid"), normal_loss("compliant")
    ('lost in impacts, normal part', 'lost in the damper')
    """
    return "lost in impacts, normal part" if contact == "rigid" else "lost in the damper"


def with_unit(text: str, unit: str) -> str:
    """Return a name with its unit, for axes and tables.

    text, unit: A pure number has the unit "1", a word none.

    Examples
    --------
    >>> with_unit("Duration", "s"), with_unit("Friction μ", "1")
    ('Duration (s)', 'Friction μ')
    """
    return text if unit in ("1", "") else f"{text} ({unit})"
