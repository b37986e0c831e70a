"""`hophoop compare`: physics engines on the hoop's motions, scored against the exact ones."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._output import print_json
from hophoop.cli._tables import print_table, table_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hophoop.engines.registry import Engine


def _engine_names() -> list[str]:
    from hophoop.engines.registry import engines

    return list(engines())


def _scenario_names() -> list[str]:
    from hophoop.engines.scenarios import bench_scenarios

    return list(bench_scenarios())


def compare(
    engine: Annotated[
        list[str] | None, typer.Argument(metavar="[ENGINE …]", help="All by default.", autocompletion=_engine_names)
    ] = None,
    scenario: Annotated[
        list[str] | None, typer.Option(help="A motion; may be repeated; by default all.", autocompletion=_scenario_names)
    ] = None,
    dt: Annotated[list[float] | None, typer.Option(help="Time step instead of the usual ones, s; may be repeated.")] = None,
    out: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder for index.html, film and scores.json.")] = None,
    command: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=COMMAND", help="An engine that reads JSON and writes CSV; may be repeated."),
    ] = None,
    npm: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder with node_modules of installed engines.")] = None,
    score: Annotated[Path | None, typer.Option(metavar="FILE.csv", help="Score a record, without any engine.")] = None,
    ladder: Annotated[bool, typer.Option(help="Run the hop over ten time steps, for the limits and orders.")] = True,
    film: Annotated[bool, typer.Option(help="Make the film.")] = True,
    json: Annotated[bool, typer.Option("--json", help="Print all scores as JSON.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Show no progress and no table.")] = False,
) -> None:
    """Run physics engines on the benchmark hophoop-bench/1, or score a record of any program."""
    from hophoop.cli import NO_ANSWER, say
    from hophoop.engines.adapters.npm import FOLDER
    from hophoop.engines.registry import command_engine, engines, physics_engines
    from hophoop.engines.registry import engine as one_engine
    from hophoop.engines.scenarios import scenarios_named
    from hophoop.scenario import InputError

    if score is not None:
        if engine or command or out or dt:
            raise InputError("--score cannot be given together with engines, --command, --dt or --out.")
        _score(score, scenario, json)
        return
    if npm is not None:
        if not npm.is_dir():
            raise InputError(f"--npm = {npm} must be an existing folder.", field="--npm", value=npm)
        os.environ[FOLDER] = str(npm.absolute())
    for step in dt or ():
        if not 0.0 < step <= 0.1:
            raise InputError.of_field("--dt", step, "above 0 and at most 0.1 s")
    if not engine and not command and not physics_engines():
        say('No engine is installed: pip install "hophoop[engines]".')
        raise typer.Exit(NO_ANSWER)
    known = [one_engine(name) for name in engine] if engine else [] if command else list(engines().values())
    known += [command_engine(text) for text in command or ()]
    result = _run(known, scenarios_named(scenario), dt, ladder, quiet or json)
    if json:
        print_json(result.to_dict(), indent=1)
    elif not quiet:
        _show(result)
    if out is not None:
        from hophoop.engines.report import write

        say(f"The report: {write(result, out, film)}")
    if not any(row.scores is not None for row in result.rows):
        say('No engine ran: pip install "hophoop[engines]".')
        raise typer.Exit(NO_ANSWER)


def _run(known: Sequence[Engine], scenarios: Any, dt: list[float] | None, ladder: bool, quiet: bool) -> Any:
    from hophoop._support.progress import bar
    from hophoop.engines.comparing import compare as run

    with bar("starting", quiet=quiet) as report:
        progress = None if report is None else lambda job, done, total: report(done, total, job)
        return run(known, scenarios, dt, ladder, progress)


def _show(result: Any) -> None:
    from hophoop.engines.tables import cells, heads, scenario_rows, summary

    names = list(dict.fromkeys(row.scenario for row in result.rows))
    if len(names) == 1:
        titles, rows = heads(), [cells(result, row) for row in scenario_rows(result, names[0])]
    else:
        titles, rows = summary(result)
    name = names[0] if len(names) == 1 else "hophoop-bench/1"
    print_table(table_of(titles, rows, right=titles[3:], wrap=titles[3:], name=name), 4000)


def _score(path: Path, scenario: list[str] | None, json: bool) -> None:
    from hophoop.engines.comparing import score_file
    from hophoop.engines.recording import load_csv
    from hophoop.engines.tables import COLUMNS, number
    from hophoop.engines.truth import truths
    from hophoop.scenario import InputError

    if scenario and len(scenario) > 1:
        raise InputError("--scenario must name one motion with --score.")
    name, found, measures = score_file(load_csv(path), scenario[0] if scenario else None)
    if json:
        print_json({"scenario": name, "scores": found.to_dict(), "measures": measures.to_dict()}, indent=1)
        return
    right = truths()[name].measures.sequence
    verdict = "right" if found.sequence_right else f"should be {right}"
    typer.echo(f"{name}: {measures.sequence} ({verdict})")
    for column in COLUMNS:
        value = getattr(found, column.field)
        if value is not None:
            typer.echo(f"  {column.head:22} {number(value, column)}")
