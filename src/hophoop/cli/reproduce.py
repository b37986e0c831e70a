"""`hophoop reproduce`: the article's figures, films and statements, computed again, in one report."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._output import console_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hophoop.article import Statement

STAGES = {
    "statements": "checking statements",
    "figures": "drawing figures",
    "films": "making films",
}
COLORS = {
    "agrees": "green",
    "agrees within reading accuracy": "cyan",
    "differs": "yellow",
    "fails": "bold white on red",
}


def reproduce(
    out: Annotated[Path, typer.Option(metavar="DIR", help="Folder for the report.")] = Path("article"),
    films: Annotated[bool, typer.Option(help="Make the films, where the extra 'films' is installed.")] = True,
    quiet: Annotated[bool, typer.Option("--quiet", help="Show no progress and no table.")] = False,
) -> None:
    """Compute the article again: figures, films, statements beside ours, one HTML report."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    from hophoop import article
    from hophoop.cli import NO_ANSWER, say

    console = Console(stderr=True)
    bars = Progress(
        TextColumn("{task.description:<20}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=console,
        disable=quiet or not console.is_terminal,
    )
    tasks: dict[str, Any] = {}

    def step(stage: str, done: int, total: int) -> None:
        if stage not in tasks:
            tasks[stage] = bars.add_task(STAGES[stage], total=total)
        bars.update(tasks[stage], completed=done)

    with bars:
        result = article.reproduce(out, step, films)
    if not quiet:
        _print(result.statements)
        if result.without_films:
            say(f"No films: {result.without_films}")
    say(f"The report: {result.folder / 'index.html'}")
    if result.failed:
        say(f"Not confirmed and not explained: {', '.join(one.key for one in result.failed)}.")
        raise typer.Exit(NO_ANSWER)


def _print(statements: Sequence[Statement]) -> None:
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for title, share in (("statement", 4), ("article", 2), ("ours", 5), ("verdict", None)):
        table.add_column(title, ratio=share, min_width=8)
    for one in statements:
        table.add_row(one.statement, one.article, one.ours, Text(one.verdict, COLORS[one.verdict]))
    console = console_of(140)
    console.print(table)
