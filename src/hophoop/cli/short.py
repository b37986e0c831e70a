"""Short commands: `hophoop plan`, `hophoop theory` and `hophoop reproduce`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._output import print_json
from hophoop.cli._tables import print_parameters, print_table, verdict

if TYPE_CHECKING:
    from hophoop.theory import Quantity

STAGES = {
    "statements": "checking statements",
    "figures": "drawing figures",
    "films": "making films",
}


def plan(
    scenario: Any,
    how: Annotated[Any, "hophoop.fitting:plan"],
    no_marker: bool = False,
    json: bool = False,
) -> None:
    """Predict which parameters a film, or a phone in the hoop, determines, and how accurately.

    The film
    --------
    rate
        Frames per second.
    sigma
        Standard deviation of each coordinate in a frame, m.
    sigma_angle
        Standard deviation of the angle, rad.
    sigma_scale
        Relative standard deviation of the scale, one error for all frames; 0 if known.
    sigma_omega
        Standard deviation of the angular velocity from a phone in the hoop, rad/s; its record instead of a film.
    no_marker
        Without marker, so without angle.
    free : NAME
        Another parameter to fit, such as slope.
    fixed : --fix NAME
        A known parameter.
    hoop_known
        The hoop is known from its parts.
    json
        Print the plan as JSON.
    """
    from hophoop.fitting import plan as make
    from hophoop.tracking.table import plain

    found = make(scenario, **(how | {"sigma_angle": None} if no_marker else how))
    if json:
        print_json(plain({key: value for key, value in found.to_dict().items() if key != "tracks"}), indent=1)
        return
    print_parameters(found.rows(given=False))
    for sentence in (*found.sentences()[1:], *found.details()[1:]):
        typer.echo(sentence)


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
        titles = ("statement", "article", "ours", "verdict")
        rows = ((one.statement, one.article, one.ours, verdict(one.verdict)) for one in result.statements)
        print_table(titles, rows, 140, (), wrap=titles)
        if result.without_films:
            say(f"No films: {result.without_films}")
    say(f"The report: {result.folder / 'index.html'}")
    if result.failed:
        say(f"Not confirmed and not explained: {', '.join(one.key for one in result.failed)}.")
        raise typer.Exit(NO_ANSWER)
