"""`hophoop run --digits` and `--check`: the motion in arbitrary precision, and the correct digits of the kernel."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._motion import ENDLESS, SPARE_DIGITS, TITLES_DIGITS, cells_in_digits, no_answer, print_events
from hophoop.cli._output import print_json, write_json
from hophoop.vocabulary.names import plain

if TYPE_CHECKING:
    from hophoop.precise import Agreement, PreciseMotion
    from hophoop.precise import Row as AgreementRow
    from hophoop.results.records import EventRecord


def run(scenario: Any, digits: int, check: bool, json: bool, out: Path | None, quiet: bool, everything: bool) -> None:
    """Solve in arbitrary precision; print or write the motion, or compare the kernel's motion with it."""
    from hophoop.cli import NO_ANSWER, say
    from hophoop.simulation.simulate import simulate

    precise = simulate(scenario, digits=digits)
    if check:
        from hophoop.precise import compare

        agreement = compare(simulate(scenario), precise)
        if json:
            print_json(_agreement_dict(agreement, precise))
        elif not quiet:
            _show_agreement(agreement, precise, everything)
        if agreement.difference:
            say(agreement.difference)
            raise typer.Exit(NO_ANSWER)
        return
    if out is not None:
        write_json(precise.to_dict(), out)
    if json:
        print_json(precise.to_dict())
    elif not quiet:
        _show_motion(precise, digits, everything)
    if precise.digits_right < digits:
        say(f"Only {precise.digits_right} of the {digits} digits asked are certain.")
    if not precise.ok:
        say(no_answer(float(precise.duration), precise.status))
        raise typer.Exit(NO_ANSWER)


def _show_motion(precise: PreciseMotion, digits: int, everything: bool) -> None:
    def cells(event: EventRecord[Any]) -> list[str]:
        return [*cells_in_digits(event), str(event.digits_right)]

    print_events((*TITLES_DIGITS, "digits"), precise.events, cells, everything, SPARE_DIGITS, ENDLESS)
    typer.echo(f"phases  {precise.sequence}\nstatus  {plain(precise.status)}")
    typer.echo(f"digits  {min(precise.digits_right, digits)} right of {digits} asked, in every event")


def _show_agreement(agreement: Agreement, precise: PreciseMotion, everything: bool) -> None:
    from hophoop.precise.agreement import NUMBERS

    def cells(row: AgreementRow) -> list[str]:
        counts = [f"{row.digits[name]:.1f}" if name in row.digits else "" for name in NUMBERS]
        return [plain(row.kind), f"{row.t:.9f}", *counts]

    print_events(
        ("event", "t (s)", "of t", "of θ", "of x", "of v", "of θ̇"), agreement.rows, cells, everything, ("of θ̇", "of v", "of x")
    )
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
