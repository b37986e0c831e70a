"""`hophoop prove`: enclosures of every event; `--thresholds` encloses critical speeds and thresholds instead."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._output import print_json

if TYPE_CHECKING:
    from hophoop.prove import Proof
    from hophoop.results.records import EventRecord


def prove(
    scenario: Any,
    file: Any = None,
    digits: int = 15,
    until: str = "duration",
    seconds: float | None = None,
    thresholds: str | None = None,
    out: Path | None = None,
    json: bool = False,
) -> None:
    """Prove the events of a motion and enclose them; status 1 if something is undecided.

    Options
    -------
    digits
        Digits that the enclosures determine.
    until
        duration, or revolution: the first of a revolution, a turning point and a take-off.
    seconds
        Time limit, s.
    thresholds : KEY,…
        Prove critical speeds and thresholds instead of a motion: first_slip_speed, first_hop_speed, immediate_hop_speed,
        painleve_friction, needed_friction or all.

    Output
    ------
    out
        Write the result as JSON.
    json
        Print the result as JSON.
    """
    from hophoop.cli import NO_ANSWER, say
    from hophoop.cli._output import check_outputs
    from hophoop.cli._thresholds import prove_thresholds
    from hophoop.prove import prove as proof_of
    from hophoop.scenario import InputError

    if seconds is not None and thresholds is not None:
        raise InputError("--thresholds cannot be given together with --seconds.")
    check_outputs({"--out": (out, ())}, file)
    if thresholds is not None:
        prove_thresholds(scenario, thresholds, digits, out, json)
        return
    proof = proof_of(scenario, digits, until, seconds=seconds)
    if out is not None:
        proof.save(out)
    if json:
        print_json(proof.to_dict(), indent=None)
    else:
        _show(proof)
    if not proof.proved:
        say(f"Undecided after {len(proof.events)} events: {proof.why}.")
        raise typer.Exit(NO_ANSWER)


def _show(proof: Proof) -> None:
    """Print the events with their enclosures."""
    from hophoop.cli._motion import ENDLESS, SPARE_DIGITS, print_events
    from hophoop.results.event_table import change_of
    from hophoop.vocabulary.names import plain

    def cells(event: EventRecord[Any]) -> list[str]:
        return [plain(event.kind), change_of(event), *map(str, (event.t, event.angle, event.x, event.vx, event.omega))]

    titles = ("event", "mode", "t (s)", "θ (rad)", "x (m)", "v (m/s)", "θ̇ (rad/s)")
    print_events(titles, proof.events, cells, True, SPARE_DIGITS, ENDLESS)
    typer.echo(f"phases  {proof.sequence}\nverdict {proof.verdict}")
    if proof.proved:
        typer.echo(f"status  {proof.status.replace('_', ' ')}\ndigits  {proof.digits_proved}")
