"""`hophoop prove`: enclosures of every event and a certificate of the sequence; `--check` verifies a certificate.

`--thresholds` proves critical speeds and thresholds instead.
"""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from hophoop.cli._output import print_json

if TYPE_CHECKING:
    from hophoop.prove import Proof
    from hophoop.prove.proof import ProvedEvent


def prove(
    scenario: Any,
    file: Any = None,
    digits: int = 15,
    until: str = "duration",
    check: Path | None = None,
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
    check : CERTIFICATE
        Verify a certificate instead; no scenario is read.
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

    if check is not None and thresholds is not None:
        raise InputError("--check cannot be given together with --thresholds.")
    if seconds is not None and (check is not None or thresholds is not None):
        raise InputError(f"{'--thresholds' if check is None else '--check'} cannot be given together with --seconds.")
    if check is not None:
        if file is not None or out is not None or json:
            raise InputError("--check takes only a certificate, which includes its scenario.")
        _verify(check)
        return
    check_outputs({"--out": (out, ())}, file)
    if thresholds is not None:
        prove_thresholds(scenario, thresholds, digits, out, json)
        return
    proof = proof_of(scenario, digits, until, seconds=seconds)
    if out is not None and proof.proved:
        proof.save(out)
    if json and proof.certificate is not None:
        print_json(proof.certificate, indent=None)
    elif not json:
        _show(proof)
    if not proof.proved:
        say(f"Undecided after {len(proof.events)} events: {proof.why}.")
        raise typer.Exit(NO_ANSWER)


def _verify(path: Path) -> None:
    """Verify a certificate and print the verdict."""
    from hophoop.cli import NO_ANSWER, say
    from hophoop.prove import check
    from hophoop.prove.checker.conventions import SCHEMA
    from hophoop.scenario import InputError
    from hophoop.scenario.sentences import parse_reason

    try:
        certificate = json_text.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise InputError(
            f"--check = {path} must be a certificate in JSON: {parse_reason(error)}.", field="--check", value=path
        ) from None
    if not isinstance(certificate, dict):
        raise InputError(f"--check = {path} must be a certificate in JSON.", field="--check", value=path)
    if certificate.get("schema") != SCHEMA:
        said = f"--check = {path} has the format {certificate.get('schema')!r}, which must be {SCHEMA}."
        raise InputError(said, field="--check", value=path)
    verdict = check(certificate)
    if verdict.accepted:
        typer.echo(f"accepted  {certificate['sequence']}, {certificate['status']}: {verdict.events} events verified")
        for line in verdict.conventions:
            typer.echo(f"          {line}")
        return
    say(f"Refused after {verdict.events} events: it cannot be shown that {verdict.why}.")
    raise typer.Exit(NO_ANSWER)


def _show(proof: Proof) -> None:
    """Print the events with their enclosures."""
    from hophoop.cli._motion import ENDLESS, SPARE_DIGITS, print_events
    from hophoop.results.event_table import change_of
    from hophoop.vocabulary.names import plain

    def cells(event: ProvedEvent) -> list[str]:
        return [plain(event.kind), change_of(event), *map(str, (event.t, event.angle, event.x, event.vx, event.omega))]

    titles = ("event", "mode", "t (s)", "θ (rad)", "x (m)", "v (m/s)", "θ̇ (rad/s)")
    print_events(titles, proof.events, cells, True, SPARE_DIGITS, ENDLESS)
    typer.echo(f"phases  {proof.sequence}\nverdict {proof.verdict}")
    if proof.proved:
        typer.echo(f"status  {proof.status.replace('_', ' ')}\ndigits  {proof.digits_proved}")
