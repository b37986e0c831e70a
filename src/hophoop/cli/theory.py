"""`hophoop theory`: thresholds and closed forms for a hoop, as a table or JSON."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from hophoop.cli._output import print_json
from hophoop.cli._tables import print_table

if TYPE_CHECKING:
    from hophoop.theory import Quantity


def theory(scenario: Any, json: bool = False) -> None:
    """Print the thresholds and closed forms of a hoop on its plane.

    Options
    -------
    json
    """
    from hophoop.theory.summary import summary, summary_dict

    if json:
        print_json(summary_dict(scenario))
        return
    rows = summary(scenario)
    titles = ("quantity", "value", "unit", "")
    print_table(titles, map(_cells, rows), 120, (), right=("value",), wrap=("quantity", "unit", ""))


def _cells(row: Quantity) -> list[str]:
    value = math.degrees(row.value) if row.unit == "rad" and row.value is not None else row.value
    unit = {"1": "", "rad": "°"}.get(row.unit, row.unit)
    return [row.words, "–" if value is None else f"{value:.9g}", unit, row.note]
