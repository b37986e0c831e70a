"""Controls of the page: sliders with their ranges, choices and axes of maps, from the table of parameters.

Their words are keys of the page's tables, which `tables.english` gives in English.
"""

from __future__ import annotations

from typing import Any

from hophoop.vocabulary.parameters import TABLE, Parameter, Range, section_of

GRAVITIES = [
    ("Earth", 9.81),
    ("Moon", 1.62),
    ("Mars", 3.71),
    ("Jupiter", 24.79),
    ("Weightless", 0.0),
]

# name, words, span of the quantities that a map in the lab can show
MAP_QUANTITIES: dict[str, tuple[str, str]] = {
    "sequence": ("what happens in the first turn", "first_revolution"),
    "hop_height": ("height of the first hop", "takeoff"),
    "takeoff_angle": ("angle of take-off", "takeoff"),
    "flight_time": ("duration of the first hop", "takeoff"),
    "greatest_utilization": ("greatest friction utilization", "first_revolution"),
    "energy_lost": ("energy lost", "duration"),
    "end_angle": ("angle at the end", "duration"),
    "painleve": ("Painlevé’s paradox or jam met", "duration"),
    "ending": ("how it ends", "duration"),
}

GROUPS = ("hoop", "plane", "start", "contact", "motion")


def _allowed(allowed: Range) -> dict[str, Any]:
    also = ["inf" if value == float("inf") else value for value in allowed.also]
    return {"least": allowed.least, "most": allowed.most, "also": also}


def controls() -> dict[str, Any]:
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


def _slider(row: Parameter) -> dict[str, Any]:
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


def _axis(row: Parameter) -> dict[str, Any]:
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
