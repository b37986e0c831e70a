"""`hophoop plan`: predicted uncertainties of a fit to a planned film or record of a phone."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from hophoop.cli._options import panel, with_scenario
from hophoop.cli._output import print_json
from hophoop.cli._tables import print_parameters

in_film = panel("The film")


@with_scenario
def plan(
    scenario: Any,
    rate: Annotated[float, in_film(help="Frames per second.")] = 240.0,
    sigma: Annotated[float, in_film(help="Standard deviation of each coordinate in a frame, m.")] = 2e-4,
    sigma_angle: Annotated[float, in_film(help="Standard deviation of the angle, rad.")] = 2e-3,
    sigma_scale: Annotated[
        float,
        in_film(help="Relative standard deviation of the scale, one error for all frames; 0 if known."),
    ] = 1e-3,
    sigma_omega: Annotated[
        float | None,
        in_film(
            help="Standard deviation of the angular velocity from a phone in the hoop, rad/s; its record instead of a film.",
        ),
    ] = None,
    no_marker: Annotated[bool, in_film("--no-marker", help="Without marker, so without angle.")] = False,
    free: Annotated[
        list[str] | None,
        in_film(metavar="NAME", help="Another parameter to fit, such as slope; may be repeated."),
    ] = None,
    fix: Annotated[list[str] | None, in_film(metavar="NAME", help="A known parameter; may be repeated.")] = None,
    hoop_known: Annotated[bool, in_film("--hoop-known", help="The hoop is known from its parts.")] = False,
    json: Annotated[bool, in_film("--json", help="Print the plan as JSON.")] = False,
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
