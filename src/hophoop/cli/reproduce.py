"""`hophoop reproduce`: the article's figures, films and statements, in one report."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from hophoop.cli._tables import print_table, verdict

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hophoop.article import Statement

STAGES = {
    "statements": "checking statements",
    "figures": "drawing figures",
    "films": "making films",
}


def reproduce(out: Path = Path("article"), films: bool = True, quiet: bool = False) -> None:
    """Reproduce the article: figures, films, checked statements, one HTML report.

    Options
    -------
    out : DIR
        Folder for the report.
    films
        Make the films, if the extra 'films' is installed.
    quiet
        Show no progress and no table.
    """
    from hophoop import article
    from hophoop._support.progress import bar
    from hophoop.cli import NO_ANSWER, say

    with bar("", quiet=quiet) as report:
        progress = None if report is None else lambda stage, done, total: report(done, total, STAGES[stage])
        result = article.reproduce(out, progress, films)
    if not quiet:
        _print(result.statements)
        if result.without_films:
            say(f"No films: {result.without_films}")
    say(f"The report: {result.folder / 'index.html'}")
    if result.failed:
        say(f"Not confirmed and not explained: {', '.join(one.key for one in result.failed)}.")
        raise typer.Exit(NO_ANSWER)


def _print(statements: Sequence[Statement]) -> None:
    titles = ("statement", "article", "ours", "verdict")
    rows = ((one.statement, one.article, one.ours, verdict(one.verdict)) for one in statements)
    print_table(titles, rows, 140, (), wrap=titles)
