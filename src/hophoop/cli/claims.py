"""`hophoop claims`: claims of the literature, our numbers computed now, verdicts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from hophoop.cli._output import print_json
from hophoop.cli._tables import print_table, table_of, verdict

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hophoop.claims import Finding


def claims(
    works: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[WORK]...",
            help="Works by key, such as Littlewood1953; all by default.",
            show_default=False,
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print JSON, numbers in full precision.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Print no table; see the exit status.")] = False,
) -> None:
    """Compare claims of the literature with numbers computed now; status 1 if a number of ours has changed."""
    from hophoop._support.progress import bar
    from hophoop.claims import findings
    from hophoop.cli import NO_ANSWER, say

    with bar("computing our numbers", quiet=quiet) as progress:
        found = findings(works or [], progress)
    if json:
        print_json(_as_json(found))
    elif not quiet:
        _print(found)
        _print_hint(found)
    failed = [one.key for one in found if not one.holds]
    if failed:
        say(f"Numbers of ours that have changed: {', '.join(failed)}.")
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
    titles = ("work", "claim", "theirs", "ours, computed now", "verdict")
    rows, before = [], ""
    for one in found:
        rows.append(("" if one.work == before else one.work, one.claim, one.theirs, one.ours, verdict(one.verdict)))
        before = one.work
    print_table(table_of(titles, rows, wrap=titles, widths={"work": 19, "theirs": 15, "verdict": 15}), 150)


def _print_hint(found: Sequence[Finding]) -> None:
    from hophoop.claims.literature import ARTICLE
    from hophoop.cli import say

    if any(one.work == ARTICLE for one in found):
        say("This table has some statements of the article; hophoop reproduce checks all of them.")
