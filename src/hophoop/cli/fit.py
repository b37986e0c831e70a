"""`hophoop fit`: parameters of a filmed hoop."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._output import named_options, print_json
from hophoop.cli._tables import print_comparison, print_parameters
from hophoop.vocabulary.names import NAMED_LAWS

OUTPUT, DATA, MODEL = "Output", "Data", "Model"


def fit(
    data: Annotated[
        list[Path],
        typer.Argument(
            metavar="DATA...",
            help="A track of `hophoop track` (.json, .csv), or a table with named columns of any program; several runs of one "
            "hoop on one plane share its parameters.",
            show_default=False,
        ),
    ],
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Folder for index.html, fit.json, scenario.toml.", rich_help_panel=OUTPUT)
    ] = None,
    film: Annotated[
        Path | None,
        typer.Option(metavar="VIDEO", help="The film, to draw the motion over; with --out or --lab.", rich_help_panel=OUTPUT),
    ] = None,
    save: Annotated[
        Path | None, typer.Option(metavar="FILE", help="File for the fit with its data, .json.", rich_help_panel=OUTPUT)
    ] = None,
    lab: Annotated[
        bool, typer.Option("--lab", help="Open the lab with the fitted motion, over --film if given.", rich_help_panel=OUTPUT)
    ] = False,
    json: Annotated[
        bool, typer.Option("--json", help="Print the fit as JSON, without the data.", rich_help_panel=OUTPUT)
    ] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Show no progress.", rich_help_panel=OUTPUT)] = False,
    radius: Annotated[
        float | None, typer.Option(help="Radius of the rim, m, if the data lack it.", rich_help_panel=DATA)
    ] = None,
    sigma: Annotated[
        float | None,
        typer.Option(help="Standard deviation of each coordinate, m; found in the data by default.", rich_help_panel=DATA),
    ] = None,
    sigma_angle: Annotated[float | None, typer.Option(help="Standard deviation of angles, rad.", rich_help_panel=DATA)] = None,
    sigma_omega: Annotated[
        float | None, typer.Option(help="Standard deviation of angular velocities, rad/s.", rich_help_panel=DATA)
    ] = None,
    since: Annotated[
        float | None, typer.Option("--from", help="Time from which the motion is free, s.", rich_help_panel=DATA)
    ] = None,
    until: Annotated[float | None, typer.Option("--to", help="Time up to which it is free, s.", rich_help_panel=DATA)] = None,
    column: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=HEAD",
            help="Column of t, frame, x, y, marker_x, marker_y, angle or omega, as the table spells it; may be repeated.",
            rich_help_panel=DATA,
        ),
    ] = None,
    rate: Annotated[
        float | None, typer.Option(help="Frames per second, if the table has frames instead of times.", rich_help_panel=DATA)
    ] = None,
    centre: Annotated[str | None, typer.Option(help="Name of the point at the centre.", rich_help_panel=DATA)] = None,
    marker: Annotated[str | None, typer.Option(help="Name of the point at the marker.", rich_help_panel=DATA)] = None,
    angle_unit: Annotated[
        str | None,
        typer.Option(help="Unit of angles and angular velocities, rad or deg, if the data lack it.", rich_help_panel=DATA),
    ] = None,
    hoop: Annotated[
        str, typer.Option(help="ideal, general, or a scenario file with the hoop's measured parts.", rich_help_panel=MODEL)
    ] = "ideal",
    start: Annotated[str, typer.Option(help="auto, rolling, sliding or flying.", rich_help_panel=MODEL)] = "auto",
    fix: Annotated[
        list[str] | None, typer.Option(metavar="NAME=VALUE", help="A known parameter; may be repeated.", rich_help_panel=MODEL)
    ] = None,
    free: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            help="Fit also rolling_resistance, slope, scale, tilt, origin_y, row_delay, marker_angle or marker_ratio; "
            "may be repeated.",
            rich_help_panel=MODEL,
        ),
    ] = None,
    bound: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=LOW:HIGH", help="Range of a parameter; may be repeated.", rich_help_panel=MODEL),
    ] = None,
    tie: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=EXPRESSION", help="A parameter as an expression of others; may be repeated.", rich_help_panel=MODEL
        ),
    ] = None,
    gravity: Annotated[float, typer.Option(help="Gravity, m/s².", rich_help_panel=MODEL)] = 9.81,
    law: Annotated[str, typer.Option(help=f"Impact law: {NAMED_LAWS}.", rich_help_panel=MODEL)] = "stronge",
    sample: Annotated[
        int | None,
        typer.Option(metavar="STEPS", help="Sample the posterior with emcee, about 1000 steps.", rich_help_panel=MODEL),
    ] = None,
    squares: Annotated[
        bool, typer.Option("--squares", help="Least squares without a robust loss for outliers.", rich_help_panel=MODEL)
    ] = False,
) -> None:
    """Fit the exact motion to a track; status 1 if the fit is not good."""
    from hophoop._support.progress import waiting
    from hophoop.cli import NO_ANSWER
    from hophoop.cli._output import check_ending, check_folder
    from hophoop.fitting import fit as find
    from hophoop.scenario import InputError, Plane
    from hophoop.tracking import Reading, read_track

    for option, path in (("--save", save), ("--out", out)):
        if path is not None:
            check_folder(option, path)
    if save is not None:
        check_ending("--save", save, (".json",))
    if film is not None and out is None and not lab:
        raise InputError("--film needs --out, the folder of the page, or --lab.")
    if film is not None and len(data) > 1:
        raise InputError("--film is for one run; fit that run alone to see it over its film.")
    columns = dict(_pairs("--column", column))
    with named_options({"since": "--from", "until": "--to", "columns": "--column"}):
        reading = Reading(
            centre=centre,
            marker=marker,
            columns=columns,
            rate=rate,
            since=since,
            until=until,
            angle_unit=angle_unit,
            radius=radius,
        )
        tracks = [read_track(one, reading) for one in data]
    with waiting("fitting", quiet=quiet or json):
        found = find(
            tracks,
            hoop=_hoop(hoop),
            start=start,
            fixed={name: _number("--fix", name, text) for name, text in _pairs("--fix", fix)},
            free=tuple(free or ()),
            bounds={name: _range(name, text) for name, text in _pairs("--bound", bound)},
            tied=dict(_pairs("--tie", tie)),
            plane=Plane(gravity=gravity, impact_law=law),
            sigma=sigma,
            sigma_angle=sigma_angle,
            sigma_omega=sigma_omega,
            robust=not squares,
        )
    if sample is not None:
        found = _sample(found, sample, quiet)
    _show(found, json)
    if save is not None:
        found.save(save)
    if out is not None:
        _write(found, out, film, quiet)
    if lab:
        from hophoop.cli.lab import open_fit

        open_fit(found, film, browser=True)
    if not found.good:
        raise typer.Exit(NO_ANSWER)


def _sample(found: Any, steps: int, quiet: bool) -> Any:
    from hophoop._support.progress import bar
    from hophoop.fitting import sample

    with bar("sampling", quiet=quiet) as progress:
        return sample(found, steps, progress=progress)


def _hoop(text: str) -> Any:
    from hophoop.scenario import Scenario

    return text if text in ("ideal", "general") else Scenario.load(text).hoop


def _pairs(option: str, given: list[str] | None) -> list[tuple[str, str]]:
    from hophoop.scenario import InputError

    result = []
    for text in given or ():
        name, sign, value = text.partition("=")
        if not sign or not name.strip() or not value.strip():
            raise InputError(f"{option} {text} must be a name and a value, such as restitution=0.3.")
        result.append((name.strip(), value.strip()))
    return result


def _number(option: str, name: str, text: str) -> float:
    from hophoop.scenario import InputError

    try:
        return float(text)
    except ValueError:
        raise InputError(f"{option} {name}={text} must be a number.") from None


def _range(name: str, text: str) -> tuple[float, float]:
    from hophoop.scenario import InputError

    low, sign, high = text.partition(":")
    if not sign:
        raise InputError(f"--bound {name}={text} must be two numbers, such as 0:0.5.")
    return _number("--bound", name, low), _number("--bound", name, high)


def _show(found: Any, json: bool) -> None:
    from hophoop.fitting.result import plain

    if json:
        print_json(plain({key: value for key, value in found.to_dict().items() if key != "tracks"}), indent=1)
        return
    print_parameters(found.rows())
    if found.alone:
        print_comparison(found.comparison())
    for sentence in (*found.sentences(), "", "Details", *found.details()):
        typer.echo(sentence)


def _write(found: Any, out: Path, film: Path | None, quiet: bool) -> None:
    from hophoop._support.progress import bar
    from hophoop.cli import say
    from hophoop.fitting import report

    with bar("drawing", quiet=quiet or film is None) as progress:
        say(f"The page: {report(found, out, film, progress)}")
