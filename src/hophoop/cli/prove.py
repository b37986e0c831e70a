"""`hophoop prove`: enclosures of every event; `--thresholds` encloses critical speeds and thresholds instead."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._output import print_json, write_json
from hophoop.cli._tables import print_table

if TYPE_CHECKING:
    from hophoop.prove import Proof, ProvedNumber

ALL = "all"


def prove(
    scenario: Any,
    file: Any = None,
    digits: int = 15,
    until: str = "duration",
    seconds: float | None = None,
    thresholds: str | None = None,
    out: Path | None = None,
    json: bool = False,
) -> None:
    """Prove the events of a motion and enclose them; status 1 if something is undecided.

    Options
    -------
    digits
        Digits that the enclosures determine.
    until
        duration, or revolution: the first of a revolution, a turning point and a take-off.
    seconds
        Time limit, s.
    thresholds : KEY,…
        Prove critical speeds and thresholds instead of a motion: first_slip_speed, first_hop_speed, immediate_hop_speed,
        painleve_friction, needed_friction or all.

    Output
    ------
    out
        Write the result as JSON.
    json
        Print the result as JSON.
    """
    from hophoop.cli import NO_ANSWER, say
    from hophoop.cli._output import check_outputs
    from hophoop.prove import prove as proof_of
    from hophoop.scenario import InputError

    if seconds is not None and thresholds is not None:
        raise InputError("--thresholds cannot be given together with --seconds.")
    check_outputs({"--out": (out, ())}, file)
    if thresholds is not None:
        _prove_thresholds(scenario, thresholds, digits, out, json)
        return
    proof = proof_of(scenario, digits, until, seconds=seconds)
    if out is not None:
        proof.save(out)
    if json:
        print_json(proof.to_dict(), indent=None)
    else:
        _show(proof)
    if not proof.proved:
        say(f"Undecided after {len(proof.events)} events: {proof.why}.")
        raise typer.Exit(NO_ANSWER)


def _show(proof: Proof) -> None:
    """Print the events with their enclosures."""
    from hophoop.cli._motion import ENDLESS, SPARE_DIGITS, TITLES_DIGITS, cells_in_digits, print_events
    from hophoop.vocabulary.names import plain

    print_events(TITLES_DIGITS, proof.events, cells_in_digits, True, SPARE_DIGITS, ENDLESS)
    typer.echo(f"phases  {proof.sequence}\nverdict {proof.verdict}")
    if proof.proved:
        typer.echo(f"status  {plain(proof.status)}\ndigits  {proof.digits_proved}")


def _prove_thresholds(scenario: Any, text: str, digits: int, out: Path | None, json: bool) -> None:
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
