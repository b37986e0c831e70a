"""The range of every number of a scenario: within it a motion is computed, or ends with a status that says why not.

The units of a motion are R, m and √(R/g). Outside these ranges its numbers leave what doubles can hold or what a body, a
plane and a clock can be; a value there is refused in one sentence.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from pydantic import AfterValidator, WithJsonSchema
from pydantic_core import PydanticCustomError

from hophoop.scenario.texts import TEXTS


class Range(NamedTuple):
    """What a number may be.

    Attributes
    ----------
    least, most : float
        The range itself, both ends included, in the number's SI unit.
    also : tuple of float
        Single values besides: 0 or inf.
    """

    least: float
    most: float
    also: tuple[float, ...] = ()

    def holds(self, value: float) -> bool:
        """Whether a value is allowed.

        Parameters
        ----------
        value : float
            In the number's SI unit.

        Returns
        -------
        allowed : bool
        """
        return self.least <= value <= self.most or value in self.also

    def words(self, unit: str = "") -> str:
        """The range in words.

        Parameters
        ----------
        unit : str, default ''
            Of its numbers; "1" for a pure number.

        Returns
        -------
        words : str
            Such as '0 or from 1e-06 to 1e+06 m/s²'.
        """
        span = f"from {self.least:g} to {self.most:g}" + (f" {unit}" if unit not in ("", "1") else "")
        zero = "0 or " if 0.0 in self.also else ""
        return zero + span + (", or inf" if float("inf") in self.also else "")


_LENGTH = Range(1e-12, 1e6)
_SPEED = Range(-1e6, 1e6)

RANGES: dict[str, Range] = {
    "duration": Range(1e-9, 1e9),
    "hoop.radius": Range(1e-6, 1e6),
    "hoop.mass": Range(1e-12, 1e12),
    "hoop.load_fraction": Range(0.0, 1.0),
    "hoop.eccentricity": Range(0.0, 1.0),
    "hoop.inertia_ratio": Range(1e-12, 1e6, (0.0,)),
    "hoop.parts.mass": Range(1e-12, 1e12),
    "hoop.parts.length": _LENGTH,
    "plane.gravity": Range(1e-6, 1e6, (0.0,)),
    "plane.slope": Range(-1.57, 1.57),
    "plane.mu": Range(0.0, 1e6, (float("inf"),)),
    "plane.restitution": Range(0.0, 1.0),
    "plane.rolling_resistance": Range(0.0, 1.0),
    "start.x": Range(-1e9, 1e9),
    "start.height": Range(0.0, 1e6),
    "start.angle": Range(-1e6, 1e6),
    "start.speed": _SPEED,
    "start.vx": _SPEED,
    "start.vy": _SPEED,
    "start.omega": Range(-1e9, 1e9),
    "contact.stiffness": Range(1e-6, 1e18),
    "contact.damping": Range(0.0, 1e12),
    "contact.restitution": Range(0.0, 1.0),
    "contact.slip_speed": Range(1e-12, 1e6),
    "contact.tangential_stiffness": Range(1e-6, 1e18),
    "contact.rtol": Range(1e-10, 0.1),
    "contact.max_events": Range(1, 1e7),
}
"""By path in a scenario; the lengths of a hoop's parts share one, their masses another."""

# What a compliant contact must be beside its hoop: stiffness in m g/R, slip speed in √(g R), and the depth in radii that the
# speeds of the start and the weight give. What sinks deeper is no contact between a rim and a plane.
RELATIVE_STIFFNESS = Range(1e-2, 1e15)
RELATIVE_SLIP_SPEED = Range(1e-12, 1e6)
MOST_DEPTH = 100.0


class Inside(NamedTuple):
    """Keeps a number to its range.

    Attributes
    ----------
    allowed : Range
    unit : str
        Of the number, for the sentence.
    """

    allowed: Range
    unit: str

    def kept(self, value: float) -> float:
        """The number itself.

        Raises
        ------
        PydanticCustomError
            If it is not in the range.
        """
        if not self.allowed.holds(value):
            raise PydanticCustomError("value", TEXTS["range"], {"words": self.allowed.words(self.unit)})
        return value


def inside(name: str, unit: str = "") -> Any:
    """An annotation that keeps a field to its range, in the schema too.

    Parameters
    ----------
    name : str
        A key of `RANGES`.
    unit : str, default ''
        Of the field, for the sentence.

    Returns
    -------
    annotation : pydantic.AfterValidator
    """
    return AfterValidator(Inside(RANGES[name], unit).kept)


def schema_of(name: str) -> Any:
    """The schema of a field with a range: a number between its ends.

    Parameters
    ----------
    name : str
        A key of `RANGES`.

    Returns
    -------
    annotation : pydantic.WithJsonSchema
    """
    allowed = RANGES[name]
    least = min(allowed.least, *allowed.also) if allowed.also else allowed.least
    return WithJsonSchema({"type": "number", "minimum": least, "maximum": allowed.most})
