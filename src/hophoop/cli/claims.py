"""`hophoop claims`: what the literature claims, our number computed now, the verdict."""

from __future__ import annotations

import json as json_text
from typing import TYPE_CHECKING, Annotated

import typer

from hophoop.cli._output import console_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hophoop.claims import Finding

COLORS = {
    "agrees": "green",
    "agrees within reading accuracy": "cyan",
    "differs": "yellow",
    "not read": "dim",
    "fails": "bold white on red",
}


def claims(
    works: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[WORK]...",
            help="Works to look at, by their keys, such as Littlewood1953; all of them if none is named.",
            show_default=False,
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print JSON, numbers in full precision.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Print no table: the exit status tells.")] = False,
) -> None:
    """What the literature claims, our number computed now, the verdict; status 1 where a number does not hold."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    from hophoop.claims import count, findings
    from hophoop.cli import NO_ANSWER, say

    chosen = works or []
    total = count(chosen)
    console = Console(stderr=True)
    bars = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=console,
        transient=True,
        disable=quiet or not console.is_terminal,
    )
    with bars:
        task = bars.add_task("computing our numbers", total=total)
        found = findings(chosen, lambda done, of: bars.update(task, completed=done, total=of))
    if json:
        typer.echo(json_text.dumps(_as_json(found), indent=2, ensure_ascii=False, allow_nan=False))
    elif not quiet:
        _print(found)
        _print_hint(found)
    failed = [one.key for one in found if not one.holds]
    if failed:
        say(f"A number of ours no longer holds: {', '.join(failed)}.")
        raise typer.Exit(NO_ANSWER)


def _as_json(found: Sequence[Finding]) -> dict[str, object]:
    from hophoop._version import __version__

    return {
        "schema": "hophoop-claims/1",
        "version": __version__,
        "holds": all(one.holds for one in found),
        "claims": [one.to_dict() for one in found],
    }


def _print(found: Sequence[Finding]) -> None:
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for title, width in (("work", 19), ("claim", None), ("theirs", 15), ("ours, computed now", None), ("verdict", 15)):
        table.add_column(title, width=width, overflow="fold")
    before = ""
    for one in found:
        table.add_row(
            "" if one.work == before else one.work, one.claim, one.theirs, one.ours, Text(one.verdict, COLORS[one.verdict])
        )
        before = one.work
    console = console_of(150)
    console.print(table)


def _print_hint(found: Sequence[Finding]) -> None:
    from hophoop.claims.literature import ARTICLE
    from hophoop.cli import say

    if any(one.work == ARTICLE for one in found):
        say("Of the article only some statements stand here; hophoop reproduce checks all of them.")
