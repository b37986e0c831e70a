"""Ranges of a scenario's numbers, within which a motion is computed or ends with a status that gives the reason.

The units of a motion are R, m and √(R/g). Outside these ranges its numbers exceed doubles or physical sense; such a value is
refused in one sentence.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from pydantic import AfterValidator, WithJsonSchema
from pydantic_core import PydanticCustomError

from hophoop.kernel.physics.ranges import SLIP_SPEED, STIFFNESS
from hophoop.scenario.base import quantity
from hophoop.scenario.texts import TEXTS
from hophoop.vocabulary.parameters import PARAMETERS, TABLE, Range

RANGES: dict[str, Range] = {
    **{row.path: row.range for row in TABLE if row.range is not None},
    # numbers of all parts of a hoop
    "hoop.parts.mass": Range(1e-12, 1e12),
    "hoop.parts.length": Range(1e-12, 1e6),
}
"""By path in a scenario."""

RELATIVE_STIFFNESS, RELATIVE_SLIP_SPEED = Range(*STIFFNESS), Range(*SLIP_SPEED)
"""Of a compliant contact, relative to its hoop."""


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


def inside(name: str, unit: str | None = None) -> Any:
    """An annotation that keeps a field to its range, in the schema too.

    Parameters
    ----------
    name : str
        A key of `RANGES`.
    unit : str, optional
        Of the field, for the sentence; by default that of the parameter.

    Returns
    -------
    annotation : pydantic.AfterValidator
    """
    return AfterValidator(Inside(RANGES[name], PARAMETERS[name].unit if unit is None else unit).kept)


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


def field_of(path: str, **limits: Any) -> Any:
    """A pydantic field with the default, meaning and unit of a parameter.

    Parameters
    ----------
    path : str
        A key of `vocabulary.parameters.PARAMETERS`.
    **limits
        Limits as pydantic's ``Field`` takes them.

    Returns
    -------
    field : pydantic.Field
    """
    row = PARAMETERS[path]
    return quantity(row.default, row.meaning, row.unit, **limits)
