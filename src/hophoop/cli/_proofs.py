"""Boxes, thresholds, gaits, chaos and the article's statements of `hophoop prove`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._output import print_json, write_json
from hophoop.cli._tables import print_table, table_of

if TYPE_CHECKING:
    from hophoop.prove import ProvedChaos, ProvedGait, ProvedMap, ProvedNumber, ProvedStatement

ALL = "all"


def boxes(scenario: Any, texts: Sequence[str], depth: int, seconds: float | None, out: Path | None, json: bool) -> None:
    """Prove a window of parameters box by box; print the proved share of each sequence."""
    from hophoop._version import __version__
    from hophoop.cli._output import named_options
    from hophoop.prove import prove_map

    ranges = _ranges(texts)
    with named_options({"ranges": "--boxes"}):
        found = prove_map(scenario, ranges, depth, seconds)
    result = {
        "schema": "hophoop-boxes/1",
        "version": __version__,
        "scenario": scenario.to_dict(),
        "ranges": {path: list(ends) for path, ends in ranges.items()},
        **found.to_dict(),
    }
    _give(result, out, json)
    if not json:
        _print_boxes(found)
        left = sum(not cell.proved for cell in found.cells)
        typer.echo(
            f"proved  {100 * found.share():.4g} % of the window, in {len(found.cells) - left} boxes; {left} are undecided"
        )


def _ranges(texts: Sequence[str]) -> dict[str, tuple[float, float]]:
    """Read ranges such as `plane.mu=0.1:1.5`."""
    from hophoop.scenario import InputError

    ranges: dict[str, tuple[float, float]] = {}
    for text in texts:
        path, _, rest = text.partition("=")
        low, colon, high = rest.partition(":")
        try:
            ends = float(low), float(high)
        except ValueError:
            colon = ""
        if not colon:
            raise InputError(f"--boxes {text} must be PATH=LOW:HIGH, such as plane.mu=0.9:1.1.")
        if path in ranges:
            raise InputError(f"--boxes names {path} twice.")
        ranges[path] = ends
    return ranges


def _print_boxes(found: ProvedMap) -> None:
    titles = ("sequence", "boxes", "share of the window")
    rows = []
    for sequence in found.sequences():
        count = sum(cell.proved and cell.sequence == sequence for cell in found.cells)
        rows.append((sequence, str(count), f"{100 * found.share(sequence):.4g} %"))
    print_table(table_of(titles, rows, wrap=titles), 200)


def thresholds(scenario: Any, text: str, digits: int, out: Path | None, json: bool) -> None:
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
    _give(result, out, json)
    if not json:
        rows = [
            (number.key, str(number.enclosure), "" if number.unit == "1" else number.unit, number.statement)
            for number in numbers
        ]
        titles = ("threshold", "proved", "unit", "statement")
        print_table(table_of(titles, rows, wrap=("unit", "statement")), 200)
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


def gait(scenario: Any, text: str, seconds: float | None, out: Path | None, certify: Path | None, json: bool) -> None:
    """Prove a gait in an interval of θ̇; status 1 if it is not proved."""
    from hophoop.cli._output import named_options
    from hophoop.prove import prove_gait

    low, high = _interval("--gait", text)
    with named_options({"interval": "--gait"}):
        found = prove_gait(scenario, low, high, seconds, certify=certify is not None)
    _give_map("hophoop-gait-proof/1", scenario, found, out, json)
    if certify is not None and found.proved:
        found.save(certify)
    if found.proved and not json:
        typer.echo(
            f"proved      one gait, {' or '.join(found.words)}, which attracts all from {low:g} to {high:g} rad/s\n"
            f"θ̇           {found.omega} rad/s at the bottom\nmultiplier  {found.multiplier}"
        )
    _end_map(found)


def chaos(
    scenario: Any, texts: Sequence[str], seconds: float | None, out: Path | None, certify: Path | None, json: bool
) -> None:
    """Prove chaos by intervals of θ̇ that cover each other; status 1 if it is not proved."""
    from hophoop.cli._output import named_options
    from hophoop.prove import prove_chaos

    intervals = [_interval("--chaos", text) for text in texts]
    with named_options({"intervals": "--chaos"}):
        found = prove_chaos(scenario, intervals, seconds, certify=certify is not None)
    _give_map("hophoop-chaos-proof/1", scenario, found, out, json)
    if certify is not None and found.proved:
        found.save(certify)
    if found.proved and not json:
        typer.echo(f"proved      chaos, with a topological entropy of {found.entropy} a revolution at least")
        for k, words in enumerate(found.words):
            covered = " and ".join("{:g} to {:g}".format(*intervals[j]) for i, j in found.coverings if i == k)
            low, high = intervals[k]
            typer.echo(f"{' or '.join(words):11} {low:g} to {high:g} rad/s is taken over {covered or 'none'}")
    _end_map(found)


def _interval(option: str, text: str) -> tuple[float, float]:
    """Read an interval such as `3.1:3.2`."""
    from hophoop.scenario import InputError

    low, _, high = text.partition(":")
    try:
        return float(low), float(high)
    except ValueError:
        raise InputError(f"{option} {text} must be LOW:HIGH, such as 3.40:3.41.") from None


def _give_map(schema: str, scenario: Any, found: ProvedGait | ProvedChaos, out: Path | None, json: bool) -> None:
    from hophoop._version import __version__

    _give({"schema": schema, "version": __version__, "scenario": scenario.to_dict(), **found.to_dict()}, out, json)


def _end_map(found: ProvedGait | ProvedChaos) -> None:
    from hophoop.cli import NO_ANSWER, say

    if not found.proved:
        say(f"Not proved: {found.why}.")
        raise typer.Exit(NO_ANSWER)


def statements(out: Path | None, json: bool) -> None:
    """Prove the article's statements that are inequalities or sequences; status 1 if one is not proved."""
    from hophoop._version import __version__
    from hophoop.cli import NO_ANSWER
    from hophoop.prove import statements as proved

    found: list[ProvedStatement] = proved()
    rows = [{"key": one.key, "statement": one.statement, "proved": one.proved} for one in found]
    _give({"schema": "hophoop-statements/1", "version": __version__, "statements": rows}, out, json)
    if not json:
        verdicts = [("proved" if one.proved else "undecided", one.statement) for one in found]
        print_table(table_of(("", "statement"), verdicts, wrap=("statement",)), 200)
        typer.echo(f"proved  {sum(one.proved for one in found)} of {len(found)}")
    if not all(one.proved for one in found):
        raise typer.Exit(NO_ANSWER)


def _give(result: dict[str, Any], out: Path | None, json: bool) -> None:
    """Write and print a result as JSON, as asked."""
    if out is not None:
        write_json(result, out, indent=1)
    if json:
        print_json(result, indent=None)
