"""`hophoop fit`: parameters of a filmed hoop."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._options import assigned, numbers, panel
from hophoop.cli._output import check_outputs, named_options, print_json
from hophoop.cli._tables import print_comparison, print_parameters
from hophoop.vocabulary.names import NAMED_LAWS

in_output, in_data, in_model = panel("Output"), panel("Data"), panel("Model")
RANGE = "two numbers, such as 0:0.5"


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
    out: Annotated[Path | None, in_output(metavar="DIR", help="Folder for index.html, fit.json, scenario.toml.")] = None,
    film: Annotated[
        Path | None,
        in_output(metavar="VIDEO", help="The film, to draw the motion over; with --out or --lab."),
    ] = None,
    save: Annotated[Path | None, in_output(metavar="FILE", help="File for the fit with its data, .json.")] = None,
    lab: Annotated[bool, in_output("--lab", help="Open the lab with the fitted motion, over --film if given.")] = False,
    json: Annotated[bool, in_output("--json", help="Print the fit as JSON, without the data.")] = False,
    quiet: Annotated[bool, in_output("--quiet", help="Show no progress.")] = False,
    radius: Annotated[float | None, in_data(help="Radius of the rim, m, if the data lack it.")] = None,
    sigma: Annotated[
        float | None,
        in_data(help="Standard deviation of each coordinate, m; found in the data by default."),
    ] = None,
    sigma_angle: Annotated[float | None, in_data(help="Standard deviation of angles, rad.")] = None,
    sigma_omega: Annotated[float | None, in_data(help="Standard deviation of angular velocities, rad/s.")] = None,
    since: Annotated[float | None, in_data("--from", help="Time from which the motion is free, s.")] = None,
    until: Annotated[float | None, in_data("--to", help="Time up to which it is free, s.")] = None,
    column: Annotated[
        list[str] | None,
        in_data(
            metavar="NAME=HEAD",
            help="Column of t, frame, x, y, marker_x, marker_y, angle or omega, as the table spells it; may be repeated.",
        ),
    ] = None,
    rate: Annotated[float | None, in_data(help="Frames per second, if the table has frames instead of times.")] = None,
    centre: Annotated[str | None, in_data(help="Name of the point at the centre.")] = None,
    marker: Annotated[str | None, in_data(help="Name of the point at the marker.")] = None,
    angle_unit: Annotated[
        str | None,
        in_data(help="Unit of angles and angular velocities, rad or deg, if the data lack it."),
    ] = None,
    hoop: Annotated[str, in_model(help="ideal, general, or a scenario file with the hoop's measured parts.")] = "ideal",
    start: Annotated[str, in_model(help="auto, rolling, sliding or flying.")] = "auto",
    fix: Annotated[list[str] | None, in_model(metavar="NAME=VALUE", help="A known parameter; may be repeated.")] = None,
    free: Annotated[
        list[str] | None,
        in_model(
            metavar="NAME",
            help="Fit also rolling_resistance, slope, scale, tilt, origin_y, row_delay, marker_angle or marker_ratio; "
            "may be repeated.",
        ),
    ] = None,
    bound: Annotated[
        list[str] | None,
        in_model(metavar="NAME=LOW:HIGH", help="Range of a parameter; may be repeated."),
    ] = None,
    tie: Annotated[
        list[str] | None,
        in_model(metavar="NAME=EXPRESSION", help="A parameter as an expression of others; may be repeated."),
    ] = None,
    gravity: Annotated[float, in_model(help="Gravity, m/s².")] = 9.81,
    law: Annotated[str, in_model(help=f"Impact law: {NAMED_LAWS}.")] = "stronge",
    sample: Annotated[
        int | None,
        in_model(metavar="STEPS", help="Sample the posterior with emcee, about 1000 steps."),
    ] = None,
    squares: Annotated[bool, in_model("--squares", help="Least squares without a robust loss for outliers.")] = False,
) -> None:
    """Fit the exact motion to a track; status 1 if the fit is not good."""
    from hophoop._support.progress import waiting
    from hophoop.cli import NO_ANSWER
    from hophoop.fitting import fit as find
    from hophoop.scenario import InputError, Plane
    from hophoop.tracking import Reading, read_track

    check_outputs({"--save": (save, (".json",)), "--out": (out, ())})
    if film is not None and out is None and not lab:
        raise InputError("--film needs --out, the folder of the page, or --lab.")
    if film is not None and len(data) > 1:
        raise InputError("--film is for one run; fit that run alone to see it over its film.")
    with named_options({"since": "--from", "until": "--to", "columns": "--column"}):
        reading = Reading(
            centre=centre,
            marker=marker,
            columns=_pairs("--column", column),
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
            fixed={name: numbers(f"--fix {name}", text, 1, "a number")[0] for name, text in _pairs("--fix", fix).items()},
            free=tuple(free or ()),
            bounds={name: numbers(f"--bound {name}", text, 2, RANGE, ":") for name, text in _pairs("--bound", bound).items()},
            tied=_pairs("--tie", tie),
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


def _pairs(option: str, given: list[str] | None) -> dict[str, str]:
    return dict(assigned(option, text) for text in given or ())


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
