"""`hophoop plan`: predicted uncertainties of a fit to a planned film or record of a phone."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from hophoop.cli._output import print_json
from hophoop.cli._tables import print_parameters


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
    from hophoop.fitting.result import GIVEN
    from hophoop.tracking.table import plain

    found = make(scenario, **(how | {"sigma_angle": None} if no_marker else how))
    if json:
        print_json(plain({key: value for key, value in found.to_dict().items() if key != "tracks"}), indent=1)
        return
    print_parameters([row for row in found.rows() if not row[1].endswith(GIVEN)])
    for sentence in (*found.sentences()[1:], *found.details()[1:]):
        typer.echo(sentence)
