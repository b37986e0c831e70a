"""Controls of the page: sliders with their ranges, choices and axes of maps, from the table of parameters.

Their words are keys of the page's tables, which `tables.english` gives in English.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypedDict

from hophoop.vocabulary.parameters import TABLE, Parameter, Range, section_of

GRAVITIES = [
    ("Earth", 9.81),
    ("Moon", 1.62),
    ("Mars", 3.71),
    ("Jupiter", 24.79),
    ("Weightless", 0.0),
]

GROUPS = ("hoop", "plane", "start", "contact", "motion")


class AllowedRange(TypedDict):
    """Values that a number may have, in SI units: a range with both ends, and single values."""

    least: float
    most: float
    also: list[float | Literal["inf"]]


class SliderInfo(TypedDict):
    """A slider: its parameter, its words, its ends and step."""

    path: str
    label: str
    symbol: str
    unit: str
    help: str
    least: float
    most: float
    step: float
    logarithmic: bool
    degrees: bool
    allowed: AllowedRange


class ChoiceInfo(TypedDict):
    """A parameter with a word as its value."""

    path: str
    label: str
    options: Sequence[tuple[str, str]]
    help: str


class AxisInfo(TypedDict):
    """A parameter that a map may have as an axis."""

    path: str
    label: str
    unit: str
    degrees: bool
    range: tuple[float, float]
    allowed: tuple[float, float]


class ControlsInfo(TypedDict):
    """All controls: sliders by section, choices, gravities and axes of maps."""

    groups: dict[str, list[SliderInfo]]
    choices: list[ChoiceInfo]
    gravities: list[tuple[str, float]]
    map_axes: list[AxisInfo]


def _allowed(allowed: Range) -> AllowedRange:
    also: list[float | Literal["inf"]] = ["inf" if value == float("inf") else value for value in allowed.also]
    return {"least": allowed.least, "most": allowed.most, "also": also}


def controls() -> ControlsInfo:
    """Return everything that the page needs to show its controls.

    Returns
    -------
    controls : dict
        `groups` of sliders, `choices`, `gravities` and `map_axes`, ready for JSON.
    """
    return {
        "groups": {group: [_slider(row) for row in TABLE if section_of(row) == group and row.slider] for group in GROUPS},
        "choices": [
            {
                "path": row.path,
                "label": f"parameter.{row.path}",
                "options": tuple((value, f"choice.{row.path}.{value}") for value, _ in row.choices),
                "help": f"help.{row.path}",
            }
            for row in TABLE
            if row.choices
        ],
        "gravities": [(f"gravity.{name.lower()}", value) for name, value in GRAVITIES],
        "map_axes": [_axis(row) for row in sorted((row for row in TABLE if row.axis), key=_rank)],
    }


def _slider(row: Parameter) -> SliderInfo:
    assert row.slider is not None
    assert row.range is not None
    low, high, step = row.slider
    return {
        "path": row.path,
        "label": f"parameter.{row.path}",
        "symbol": row.symbol,
        "unit": _unit(row),
        "help": f"help.{row.path}",
        "least": low,
        "most": high,
        "step": step,
        "logarithmic": step == 0.0,
        "degrees": row.degrees,
        "allowed": _allowed(row.range),
    }


def _rank(row: Parameter) -> tuple[int, int]:
    # a map varies the start most often
    return ("start", "hoop", "plane").index(section_of(row)), row.axis.rank if row.axis else 0


def _axis(row: Parameter) -> AxisInfo:
    assert row.axis is not None
    assert row.range is not None
    least = min(row.range.least, 0.0) if 0.0 in row.range.also else row.range.least
    return {
        "path": row.path,
        "label": f"axis.{row.path}",
        "unit": _unit(row),
        "degrees": row.degrees,
        "range": (row.axis.low, row.axis.high),
        "allowed": (least, row.range.most),
    }


def _unit(row: Parameter) -> str:
    return "°" if row.degrees else "" if row.unit == "1" else row.unit
