"""`hophoop theory`: thresholds and closed forms for a hoop, as a table or JSON."""

from __future__ import annotations

import json as json_text
import math
from collections.abc import Callable, Iterator
from typing import Annotated, Any, NamedTuple

import typer

from hophoop.cli._options import with_scenario


class Row(NamedTuple):
    """One quantity: its name in JSON, in words, its unit and its value, None where there is none."""

    key: str
    words: str
    unit: str
    value: float | None
    note: str = ""


@with_scenario
def theory(
    scenario: Any,
    json: Annotated[bool, typer.Option("--json", help="Print JSON, in SI units and radians.")] = False,
) -> None:
    """Print the thresholds and closed forms of a hoop on its plane."""
    rows = list(rows_of(scenario))
    if json:
        typer.echo(json_text.dumps(as_json(scenario, rows), indent=2, ensure_ascii=False, allow_nan=False))
        return
    from rich import box
    from rich.console import Console
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for title in ("quantity", "value", "unit", ""):
        table.add_column(title, justify="right" if title == "value" else "left")
    for row in rows:
        degrees = row.unit == "rad" and row.value is not None
        value = math.degrees(row.value) if degrees and row.value is not None else row.value
        unit = {"1": "", "rad": "°"}.get(row.unit, row.unit)
        table.add_row(row.words, "–" if value is None else f"{value:.9g}", unit, row.note)
    console = Console(highlight=False)
    if not console.is_terminal:
        console = Console(highlight=False, width=120)
    console.print(table)


def as_json(scenario: Any, rows: list[Row]) -> dict[str, Any]:
    """The rows as JSON: numbers in SI units, "inf" where there is no bound, null where there is no value."""
    import hophoop

    def plain(value: float | None) -> float | str | None:
        if value is None or math.isnan(value):
            return None
        return value if math.isfinite(value) else "inf" if value > 0.0 else "-inf"

    return {
        "schema": "hophoop-theory/1",
        "version": hophoop.__version__,
        "scenario": scenario.to_dict(),
        "theory": {row.key: plain(row.value) for row in rows},
        "notes": {row.key: row.note for row in rows if row.note},
    }


def rows_of(scenario: Any) -> Iterator[Row]:
    """All quantities; one that a hoop or plane does not have says why."""
    from hophoop import theory as closed

    hoop, plane = scenario.hoop, scenario.plane
    yield Row("eccentricity", "eccentricity ε", "1", hoop.eccentricity)
    yield Row("inertia_ratio", "moment of inertia κ", "1", hoop.inertia_ratio)
    yield _row(
        "first_slip_speed",
        "slips in the first turn from v₀ =",
        "m/s",
        lambda: closed.first_slip_speed(hoop, plane),
    )
    yield _row(
        "first_hop_speed",
        "hops in the first turn from v₀ =",
        "m/s",
        lambda: closed.first_hop_speed(hoop, plane),
    )
    yield _row(
        "immediate_hop_speed",
        "hops at once from v₀ =",
        "m/s",
        lambda: closed.immediate_hop_speed(hoop, plane),
    )
    yield from _painleve(closed, hoop)
    yield from _start(closed, scenario)
    yield from _rest(closed, hoop, plane)
    if hoop.massless and plane.slope == 0.0:
        speed = scenario.start.speed or 0.0
        yield _row(
            "massless_loss_angle", "the massless hoop loses its contact force at θ =", "rad",
            lambda: closed.massless_loss(speed, hoop.radius, plane).angle,
        )  # fmt: skip


def _painleve(closed: Any, hoop: Any) -> Iterator[Row]:
    if hoop.massless:
        return
    least = closed.painleve_minimum(hoop)
    yield _row("painleve_friction", "Painlevé's paradox from μ =", "1", lambda: least.mu)
    yield _row("painleve_angle", "    there at θ =", "rad", lambda: least.angle)


def _start(closed: Any, scenario: Any) -> Iterator[Row]:
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start
    if start.speed is None or start.angle != 0.0:
        note = "for a rolling start with the load at the top: --v0, --angle 0"
        yield Row("start_speed", "rolling from v₀", "m/s", None, note)
        return
    speed = start.speed
    yield Row("start_speed", "rolling from v₀ =", "m/s", speed)
    yield _row("needed_friction", "    needs μ =", "1", lambda: closed.needed_friction(hoop, speed, plane).mu)
    yield _row(
        "needed_friction_angle",
        "    there at θ =",
        "rad",
        lambda: closed.needed_friction(hoop, speed, plane).angle,
    )
    yield _row("slip_angle", "    slips first at θ =", "rad", lambda: closed.slip_angle(hoop, speed, plane))
    yield _row("hop_angle", "    hops first at θ =", "rad", lambda: closed.hop_angle(hoop, speed, plane))
    yield _row(
        "max_rolling_speed",
        "    largest θ̇ if it rolled",
        "rad/s",
        lambda: closed.max_rolling_speed(hoop, speed, plane),
    )
    yield _row(
        "rolling_period",
        "    a whole turn if it rolled",
        "s",
        lambda: closed.rolling_period(hoop, speed, plane),
    )


def _rest(closed: Any, hoop: Any, plane: Any) -> Iterator[Row]:
    for rest in closed.equilibria(hoop, plane):
        kind = "stable" if rest.stable else "unstable"
        note = "" if rest.holds else "more than friction holds"
        yield Row(f"{kind}_angle", f"{kind} equilibrium at θ =", "rad", rest.angle, note)
        if rest.stable:
            yield Row("rocking_period", "    small rocking", "s", rest.period)


def _row(key: str, words: str, unit: str, quantity: Callable[[], Any]) -> Row:
    try:
        value = float(quantity())
    except ValueError as error:
        return Row(key, words, unit, None, str(error))
    note = ""
    if math.isnan(value):
        note = "not within the first turn" if key in ("slip_angle", "hop_angle") else "does not get that far"
        return Row(key, words, unit, None, note)
    if math.isinf(value):
        note = "never" if key.endswith("speed") else ""
    return Row(key, words, unit, value, note)
