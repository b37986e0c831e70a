"""`hophoop gait`: the periodic gaits of a hoop on a slope, as a table or JSON."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._options import assigned, numbers
from hophoop.cli._output import print_json, save_picture
from hophoop.cli._tables import print_table

if TYPE_CHECKING:
    from hophoop.gaits.branch import Branch, Special
    from hophoop.gaits.gait import Gait
    from hophoop.scenario import Scenario

TITLES = ("sequence", "stable", "multiplier", "speed (m/s)", "hops", "revolutions", "hop (m)", "θ̇ (rad/s)")
SPARE = ("hop (m)", "revolutions", "θ̇ (rad/s)", "hops", "speed (m/s)")


def gait(
    scenario: Any,
    search: Annotated[Any, "hophoop.gaits.search:find"],
    digits: int | None = None,
    follow: str | None = None,
    plot: Path | None = None,
    json: bool = False,
    quiet: bool = False,
) -> None:
    """Find the periodic gaits of a hoop on a slope, stable or not, the slowest first, and follow one over a parameter.

    Options
    -------
    period
        Passages after which the gait repeats itself, 1 to 64.
    near
        Look near this θ̇ at the passage, rad/s.
    fastest
        Look up to this θ̇, rad/s.
    section
        bottom (load at the bottom) or landing.
    digits
        Compute the first one again with so many digits.
    follow : PATH=LOW:HIGH
        Follow the first one over a parameter: print the branch's special points.
    plot, json, quiet
    """
    from hophoop._support.progress import bar
    from hophoop.cli._output import PICTURES, check_outputs
    from hophoop.gaits.search import find
    from hophoop.scenario import InputError

    if plot is not None and follow is None:
        raise InputError("--plot needs --follow: it draws the branch.")
    check_outputs({"--plot": (plot, PICTURES)})
    path, bounds = ("", (0.0, 0.0)) if follow is None else _range(scenario, follow)
    if digits is not None:
        from hophoop.gaits.digits import check_digits

        check_digits(digits)
    with bar("looking for gaits", quiet=quiet, share=True) as progress:
        found = find(scenario, progress=progress, **search)
    precise = None if digits is None else found[0].digits(digits)
    branch = None
    if follow is not None:
        with bar("following", quiet=quiet, share=True) as progress:
            branch = found[0].follow(path, bounds, progress)
    if json:
        rows = [one.to_dict() for one in found]
        if precise is not None:
            rows[0]["digits"] = {name: str(value) for name, value in precise.state.items()} | {
                "multiplier": None if precise.multiplier is None else str(precise.multiplier)
            }
        followed = {} if branch is None else {"branch": branch.to_dict()}
        print_json({"schema": "hophoop-gaits/1", "gaits": rows} | followed)
        _finish(branch, plot)
        return
    print_table(TITLES, map(_cells, found), 140, SPARE, right=TITLES[2:8], wrap=("sequence",))
    if precise is not None:
        for name, value in precise.state.items():
            typer.echo(f"{name} = {value}")
        if precise.multiplier is not None:
            typer.echo(f"multiplier = {precise.multiplier} ± {precise.multiplier_error:.1e}")
    if branch is not None:
        rows_of = ([one.kind, f"{one.parameter:.12g}", f"{one.omega:.9g}", _factors(one), one.event] for one in branch.special)
        titles = ("special point", path, "θ̇ (rad/s)", "multiplier", "boundary and sequences")
        print_table(titles, rows_of, 140, right=titles[1:4], wrap=titles[4:])
    _finish(branch, plot)


def _range(scenario: Scenario, text: str) -> tuple[str, tuple[float, float]]:
    """Return path and range of --follow; refuse what cannot be followed before the search, which takes seconds."""
    from hophoop.gaits.following import range_of

    wanted = "PATH=LOW:HIGH, such as plane.slope=0.001:0.1"
    path, span = assigned("--follow", text, wanted)
    low, high = numbers("--follow", span, 2, wanted, ":")
    range_of(scenario, path, (low, high))
    return path, (low, high)


def _factors(one: Special) -> str:
    return " to ".join(f"{factor:.6g}" for factor in one.multipliers)


def _finish(branch: Branch | None, plot: Path | None) -> None:
    """Draw the branch, and end with the status of a stop if it is not whole."""
    if branch is None:
        return
    if plot is not None:
        from hophoop.plots.branch import branch as drawn

        save_picture(drawn(branch), plot)
    if not branch.complete:
        raise KeyboardInterrupt


def _cells(one: Gait) -> list[str]:
    return [
        one.sequence,
        "yes" if one.stable else "no",
        f"{one.multipliers[0]:.6g}",
        f"{one.speed:.6g}",
        str(one.hops),
        str(abs(one.revolutions)),
        f"{one.hop_height:.4g}" if one.hops else "–",
        f"{one.state.omega:.9g}",
    ]
