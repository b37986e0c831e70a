"""`hophoop prove --thresholds`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._output import print_json, write_json
from hophoop.cli._tables import print_table

if TYPE_CHECKING:
    from hophoop.prove import ProvedNumber

ALL = "all"


def prove_thresholds(scenario: Any, text: str, digits: int, out: Path | None, json: bool) -> None:
    """Prove critical speeds and thresholds; status 1 if one of them is not proved."""
    from hophoop._version import __version__
    from hophoop.cli import NO_ANSWER, say
    from hophoop.prove.thresholds import KEYS, decided
    from hophoop.scenario import InputError

    wanted = list(KEYS) if text == ALL else text.split(",")
    unknown = [key for key in wanted if key not in KEYS]
    if unknown:
        raise InputError(f"--thresholds has {unknown[0]!r}, which must be {ALL} or names of {', '.join(KEYS)}.")
    numbers, reasons = decided(scenario, digits, wanted)
    result = {
        "schema": "hophoop-thresholds/1",
        "version": __version__,
        "scenario": scenario.to_dict(),
        "thresholds": [_as_json(number) for number in numbers],
    }
    if out is not None:
        write_json(result, out, indent=1)
    if json:
        print_json(result, indent=None)
    else:
        rows = [
            (number.key, str(number.enclosure), "" if number.unit == "1" else number.unit, number.statement)
            for number in numbers
        ]
        titles = ("threshold", "proved", "unit", "statement")
        print_table(titles, rows, 200, ("statement", "unit"), wrap=("unit", "statement"))
    for key, why in reasons.items():
        say(f"Undecided: {key}: {why}.")
    if reasons:
        raise typer.Exit(NO_ANSWER)


def _as_json(number: ProvedNumber) -> dict[str, str]:
    return {
        "key": number.key,
        "statement": number.statement,
        "unit": number.unit,
        "middle": str(number.enclosure.middle),
        "radius": str(number.enclosure.radius),
    }
