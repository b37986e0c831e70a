"""`hophoop run --digits` and `--check`: the motion in many digits, and what of the kernel's answer is right."""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._output import console_of

if TYPE_CHECKING:
    from rich.table import Table

    from hophoop.precise import Agreement, PreciseMotion


def run(scenario: Any, digits: int, check: bool, json: str | None, quiet: bool) -> None:
    """Solve in many digits; print or write it, or compare the kernel's motion with it."""
    from hophoop._files import replacing
    from hophoop.cli import NO_ANSWER, say
    from hophoop.cli.run import unanswered
    from hophoop.simulation import simulate

    precise = simulate(scenario, digits=digits)
    if check:
        from hophoop.precise import compare

        agreement = compare(simulate(scenario), precise)
        if json is not None:
            typer.echo(json_text.dumps(_agreement_dict(agreement, precise), indent=2, ensure_ascii=False))
        elif not quiet:
            _show(_rows(agreement))
            _say_digits(agreement, precise)
        if agreement.difference:
            say(agreement.difference)
            raise typer.Exit(NO_ANSWER)
        return
    if json is not None:
        text = json_text.dumps(precise.to_dict(), indent=2, ensure_ascii=False, allow_nan=False)
        if json == "-":
            typer.echo(text)
        else:
            with replacing(Path(json)) as file:
                file.write_text(text + "\n", encoding="utf-8")
    if json != "-" and not quiet:
        _show(_events(precise))
        typer.echo(f"phases  {precise.sequence}\nstatus  {precise.status.replace('_', ' ')}")
        typer.echo(f"digits  {min(precise.digits_right, digits)} right of {digits} asked, in every event")
    if precise.digits_right < digits:
        say(f"Only {precise.digits_right} of the {digits} digits asked are certain.")
    if not precise.ok:
        say(unanswered(float(precise.duration), precise.status))
        raise typer.Exit(NO_ANSWER)


def _show(table: Table) -> None:

    console = console_of(4000)
    console.print(table)


def _table(*titles: str) -> Table:
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, title=None, pad_edge=False)
    for title in titles:
        table.add_column(title, justify="left" if title in ("event", "mode") else "right", no_wrap=True)
    return table


def _events(precise: PreciseMotion) -> Table:
    table = _table("event", "mode", "t (s)", "θ (rad)", "x (m)", "v (m/s)", "θ̇ (rad/s)", "digits")
    for event in precise.events:
        change = event.to_mode if event.from_mode in (None, event.to_mode) else f"{event.from_mode} → {event.to_mode}"
        numbers = (event.t, event.angle, event.x, event.vx, event.omega)
        table.add_row(event.kind.replace("_", " "), change, *map(str, numbers), str(event.digits_right))
    return table


def _rows(agreement: Agreement) -> Table:
    from hophoop.precise.agreement import NUMBERS

    table = _table("event", "t (s)", "of t", "of θ", "of x", "of v", "of θ̇")
    for row in agreement.rows:
        counts = [f"{row.digits[name]:.1f}" if name in row.digits else "" for name in NUMBERS]
        table.add_row(row.kind.replace("_", " "), f"{row.t:.9f}", *counts)
    return table


def _say_digits(agreement: Agreement, precise: PreciseMotion) -> None:
    if agreement.rows:
        typer.echo(
            f"At least {agreement.least:.1f} digits of every number are right, by a solution in {precise.digits} digits "
            f"({precise.digits_right} of them certain)."
        )


def _agreement_dict(agreement: Agreement, precise: PreciseMotion) -> dict[str, Any]:
    return {
        "sequence": precise.sequence,
        "status": precise.status,
        "difference": agreement.difference,
        "events": [{"kind": row.kind, "t": row.t, "digits": row.digits} for row in agreement.rows],
    }
