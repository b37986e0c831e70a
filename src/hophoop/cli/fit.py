"""`hophoop fit`: parameters of a filmed hoop."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from hophoop.cli._output import check_outputs, print_json
from hophoop.cli._tables import print_parameters, print_table


def fit(
    data: list[Path],
    reading: Annotated[Any, "hophoop.tracking:Reading"],
    how: Annotated[Any, "hophoop.fitting:fit"],
    out: Path | None = None,
    film: Path | None = None,
    save: Path | None = None,
    lab: bool = False,
    json: bool = False,
    quiet: bool = False,
    hoop: str = "ideal",
    gravity: float = 9.81,
    law: str = "stronge",
    squares: bool = False,
) -> None:
    """Fit the exact motion to a track; status 1 if the fit is not good.

    Arguments
    ---------
    data : DATA...
        A track of `hophoop track` (.json, .csv), or a table with named columns of any program; several runs of one hoop on one
        plane share its parameters.

    Output
    ------
    out : DIR
        Folder for index.html, fit.json, scenario.toml.
    film : VIDEO
        The film, to draw the motion over; with --out or --lab.
    save
        File for the fit with its data, .json.
    lab
        Open the lab with the fitted motion, over --film if given.
    json
        Print the fit as JSON, without the data.
    quiet

    Data
    ----
    radius
    sigma
        Standard deviation of each coordinate, m; found in the data by default.
    sigma_angle
        Standard deviation of angles, rad.
    sigma_omega
        Standard deviation of angular velocities, rad/s.
    since : --from
    until : --to
    columns : --column NAME=HEAD
        Column of t, frame, x, y, marker_x, marker_y, angle or omega, as the table spells it or by its number.
    units : --unit NAME=UNIT
        Unit of t, x, y, angle or omega: s, ms, us, ns; m, cm, mm; rad, deg; deg/s, or the size of one in SI units.
    rate
    centre, marker

    Model
    -----
    hoop
        ideal, general, or a scenario file with the hoop's measured parts.
    start
    fixed : --fix NAME=VALUE
        A known parameter.
    free : NAME
        Fit also rolling_resistance, slope, scale, stretch, tilt, origin_y, row_delay, marker_angle or marker_ratio.
    bounds : --bound NAME=LOW:HIGH
        Range of a parameter.
    tied : --tie NAME=EXPRESSION
        A parameter as an expression of others.
    gravity
    law
    squares
        Least squares without a robust loss for outliers.
    """
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
    tracks = [read_track(one, Reading(**reading)) for one in data]
    with waiting("fitting", quiet=quiet or json):
        plane = Plane(gravity=gravity, impact_law=law)
        found = find(tracks, hoop=_hoop(hoop), plane=plane, robust=not squares, **how)
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


def _hoop(text: str) -> Any:
    from hophoop.scenario import Scenario

    return text if text in ("ideal", "general") else Scenario.load(text).hoop


def _show(found: Any, json: bool) -> None:
    from hophoop.tracking.table import plain

    if json:
        print_json(plain({key: value for key, value in found.to_dict().items() if key != "tracks"}), indent=1)
        return
    for sentence in found.sentences():
        typer.echo(sentence)
    print_parameters(found.rows())
    if found.alone:
        titles, *rows = found.comparison()
        print_table(titles, rows, 200, ())
    for sentence in ("Details", *found.details()):
        typer.echo(sentence)


def _write(found: Any, out: Path, film: Path | None, quiet: bool) -> None:
    from hophoop._support.progress import bar
    from hophoop.cli import say
    from hophoop.fitting import report

    with bar("drawing", quiet=quiet or film is None) as progress:
        say(f"The page: {report(found, out, film, progress)}")
