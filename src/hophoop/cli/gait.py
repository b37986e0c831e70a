"""`hophoop gait`: the periodic gaits of a hoop on a slope, as a table or JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._options import with_scenario
from hophoop.cli._output import print_json
from hophoop.cli._tables import print_table, table_of

if TYPE_CHECKING:
    from hophoop.gaits.gait import Gait

TITLES = ("word", "stable", "multiplier", "speed (m/s)", "hops", "revolutions", "hop (m)", "θ̇ (rad/s)", "next boundary")


@with_scenario
def gait(
    scenario: Any,
    period: Annotated[int, typer.Option(help="Passages after which the gait repeats itself, 1 to 64.")] = 1,
    near: Annotated[float | None, typer.Option(help="Look near this θ̇ at the passage (rad/s).")] = None,
    fastest: Annotated[float | None, typer.Option(help="Look up to this θ̇ (rad/s).")] = None,
    section: Annotated[str, typer.Option(help="bottom (load at the bottom) or landing.")] = "bottom",
    digits: Annotated[int | None, typer.Option(help="Compute the first one again with so many digits.")] = None,
    json: Annotated[bool, typer.Option("--json", help="Print JSON, in SI units and radians.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", help="Show no progress.")] = False,
) -> None:
    """Find the periodic gaits of a hoop on a slope, stable or not, the slowest first."""
    from hophoop._support.progress import bar
    from hophoop.gaits.finding import find

    with bar("looking for gaits", quiet=quiet, share=True) as progress:
        found = find(scenario, period, near=near, fastest=fastest, section=section, progress=progress)
    precise = None if digits is None else found[0].digits(digits)
    if json:
        rows = [one.to_dict() for one in found]
        if precise is not None:
            rows[0]["digits"] = {name: str(value) for name, value in precise.state.items()} | {
                "multiplier": None if precise.multiplier is None else str(precise.multiplier)
            }
        print_json({"schema": "hophoop-gaits/1", "gaits": rows})
        return
    print_table(table_of(TITLES, map(_cells, found), right=TITLES[2:8], wrap=("word",)), 140)
    if precise is not None:
        for name, value in precise.state.items():
            typer.echo(f"{name} = {value}")
        if precise.multiplier is not None:
            typer.echo(f"multiplier = {precise.multiplier} ± {precise.multiplier_error:.1e}")


def _cells(one: Gait) -> list[str]:
    first = one.multipliers[0]
    margin = one.margins[0]
    return [
        "·".join(one.word),
        "yes" if one.stable else "no",
        f"{first.real:.6g}" if first.imag == 0.0 else f"{first:.6g}",
        f"{one.speed:.6g}",
        str(one.hops),
        str(abs(one.revolutions)),
        f"{one.hop_height:.4g}" if one.hops else "–",
        f"{one.state.omega:.9g}",
        f"{margin.boundary}: {margin.value:.2g}",
    ]
