"""`hophoop plan`: predicted uncertainties of a fit to a planned film or record of a phone."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from hophoop.cli._options import with_scenario
from hophoop.cli._output import print_json
from hophoop.cli._tables import print_parameters

FILM = "The film"


@with_scenario
def plan(
    scenario: Any,
    rate: Annotated[float, typer.Option(help="Frames per second.", rich_help_panel=FILM)] = 240.0,
    sigma: Annotated[
        float, typer.Option(help="Standard deviation of each coordinate in a frame, m.", rich_help_panel=FILM)
    ] = 2e-4,
    sigma_angle: Annotated[float, typer.Option(help="Standard deviation of the angle, rad.", rich_help_panel=FILM)] = 2e-3,
    sigma_scale: Annotated[
        float,
        typer.Option(
            help="Relative standard deviation of the scale, one error for all frames; 0 if known.", rich_help_panel=FILM
        ),
    ] = 1e-3,
    sigma_omega: Annotated[
        float | None,
        typer.Option(
            help="Standard deviation of the angular velocity from a phone in the hoop, rad/s; its record instead of a film.",
            rich_help_panel=FILM,
        ),
    ] = None,
    no_marker: Annotated[
        bool, typer.Option("--no-marker", help="Without marker, so without angle.", rich_help_panel=FILM)
    ] = False,
    free: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME", help="Another parameter to fit, such as slope; may be repeated.", rich_help_panel=FILM),
    ] = None,
    fix: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="A known parameter; may be repeated.", rich_help_panel=FILM)
    ] = None,
    hoop_known: Annotated[
        bool, typer.Option("--hoop-known", help="The hoop is known from its parts.", rich_help_panel=FILM)
    ] = False,
    json: Annotated[bool, typer.Option("--json", help="Print the plan as JSON.", rich_help_panel=FILM)] = False,
) -> None:
    """Predict which parameters a film, or a phone in the hoop, determines, and how accurately."""
    from dataclasses import asdict

    from hophoop.fitting import plan as make
    from hophoop.fitting.result import plain

    found = make(
        scenario,
        rate=rate,
        sigma=sigma,
        sigma_angle=None if no_marker else sigma_angle,
        sigma_scale=sigma_scale,
        sigma_omega=sigma_omega,
        free=tuple(free or ()),
        fixed=tuple(fix or ()),
        hoop_known=hoop_known,
    )
    if json:
        print_json(plain(asdict(found)), indent=1)
        return
    print_parameters(found.rows())
    for sentence in found.sentences():
        typer.echo(sentence)
