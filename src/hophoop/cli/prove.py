"""`hophoop prove`: enclosures of every event and a certificate of the sequence; `--check` verifies a certificate.

`--boxes`, `--thresholds`, `--gait`, `--chaos` and `--article` prove something else.
"""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._options import with_scenario
from hophoop.cli._output import print_json

if TYPE_CHECKING:
    from hophoop.prove import Proof
    from hophoop.prove.proof import ProvedEvent

OUTPUT, INSTEAD = "Output", "Instead of one motion"


@with_scenario
def prove(
    scenario: Any,
    file: Any,
    digits: Annotated[int, typer.Option("--digits", help="Digits that the enclosures determine.")] = 15,
    until: Annotated[
        str,
        typer.Option("--until", help="duration, or revolution: the first of a revolution, a turning point and a take-off."),
    ] = "duration",
    check: Annotated[
        Path | None,
        typer.Option("--check", metavar="CERTIFICATE", help="Verify a certificate instead; no scenario is read."),
    ] = None,
    boxes: Annotated[
        list[str] | None,
        typer.Option(
            "--boxes",
            metavar="PATH=LOW:HIGH",
            help="Prove a window of parameters box by box, each with one sequence in the first revolution; may be repeated.",
            rich_help_panel=INSTEAD,
            show_default=False,
        ),
    ] = None,
    depth: Annotated[
        int | None,
        typer.Option(
            "--depth", help="Maximum number of halvings of a box, 8 by default.", rich_help_panel=INSTEAD, show_default=False
        ),
    ] = None,
    seconds: Annotated[
        float | None,
        typer.Option("--seconds", help="Time limit, s.", show_default=False),
    ] = None,
    thresholds: Annotated[
        str | None,
        typer.Option(
            "--thresholds",
            metavar="KEY,…",
            help="Prove critical speeds and thresholds: first_slip_speed, first_hop_speed, immediate_hop_speed, "
            "painleve_friction, needed_friction or all.",
            rich_help_panel=INSTEAD,
            show_default=False,
        ),
    ] = None,
    gait: Annotated[
        str | None,
        typer.Option(
            "--gait",
            metavar="LOW:HIGH",
            help="Prove that one gait passes the bottom with θ̇ in this interval, rad/s, and attracts all motions that do.",
            rich_help_panel=INSTEAD,
            show_default=False,
        ),
    ] = None,
    chaos: Annotated[
        list[str] | None,
        typer.Option(
            "--chaos",
            metavar="LOW:HIGH",
            help="Prove chaos: the return map takes intervals of θ̇ at the bottom, rad/s, over each other; given twice or more.",
            rich_help_panel=INSTEAD,
            show_default=False,
        ),
    ] = None,
    article: Annotated[
        bool,
        typer.Option("--article", help="Prove the article's inequalities and sequences.", rich_help_panel=INSTEAD),
    ] = False,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="Write the result as JSON.", rich_help_panel=OUTPUT)
    ] = None,
    certify: Annotated[
        Path | None,
        typer.Option(
            "--certify", metavar="FILE", help="Write a certificate of --gait or --chaos for --check.", rich_help_panel=OUTPUT
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print the result as JSON.", rich_help_panel=OUTPUT)] = False,
) -> None:
    """Prove the events of a motion and enclose them; status 1 if something is undecided."""
    from hophoop.cli import NO_ANSWER, _proofs, say
    from hophoop.cli._output import check_apart, check_folder
    from hophoop.prove import prove as proof_of
    from hophoop.scenario import InputError

    kinds = {
        "--check": check is not None, "--boxes": bool(boxes), "--thresholds": thresholds is not None,
        "--gait": gait is not None, "--chaos": bool(chaos), "--article": article,
    }  # fmt: skip
    asked = [option for option, is_asked in kinds.items() if is_asked]
    if len(asked) > 1:
        raise InputError(f"{asked[0]} cannot be given together with {asked[1]}.")
    if depth is not None and not boxes:
        raise InputError("--depth needs --boxes: it limits the division of the window.")
    if seconds is not None and (check is not None or thresholds is not None or article):
        raise InputError(f"{asked[0]} cannot be given together with --seconds.")
    if certify is not None and gait is None and not chaos:
        raise InputError("--certify needs --gait or --chaos; --out writes the certificate of one motion.")
    if check is not None:
        if file is not None or out is not None or json:
            raise InputError("--check takes only a certificate, which includes its scenario.")
        _verify(check)
        return
    outputs = {option: path for option, path in (("--out", out), ("--certify", certify)) if path is not None}
    for option, path in outputs.items():
        check_folder(option, path)
    check_apart(list(outputs.values()), file)
    if boxes:
        _proofs.boxes(scenario, boxes, 8 if depth is None else depth, seconds, out, json)
        return
    if thresholds is not None:
        _proofs.thresholds(scenario, thresholds, digits, out, json)
        return
    if gait is not None:
        _proofs.gait(scenario, gait, seconds, out, certify, json)
        return
    if chaos:
        _proofs.chaos(scenario, chaos, seconds, out, certify, json)
        return
    if article:
        _proofs.statements(out, json)
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
    from hophoop.prove.checker.check import SCHEMAS
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
    if certificate.get("schema") not in SCHEMAS:
        said = f"--check = {path} has the format {certificate.get('schema')!r}, which must be {' or '.join(SCHEMAS)}."
        raise InputError(said, field="--check", value=path)
    verdict = check(certificate)
    if verdict.accepted:
        said = certificate["claim"] if "claim" in certificate else f"{certificate['sequence']}, {certificate['status']}"
        typer.echo(f"accepted  {said}: {verdict.events} events verified")
        for line in verdict.conventions:
            typer.echo(f"          {line}")
        return
    say(f"Refused after {verdict.events} events: it cannot be shown that {verdict.why}.")
    raise typer.Exit(NO_ANSWER)


def _show(proof: Proof) -> None:
    """Print the events with their enclosures."""
    from hophoop.cli._motion import print_events
    from hophoop.results.event_table import change_of
    from hophoop.vocabulary.words import plain

    def cells(event: ProvedEvent) -> list[str]:
        return [plain(event.kind), change_of(event), *map(str, (event.t, event.angle, event.x, event.vx, event.omega))]

    print_events(("event", "mode", "t (s)", "θ (rad)", "x (m)", "v (m/s)", "θ̇ (rad/s)"), proof.events, cells, everything=True)
    typer.echo(f"phases  {proof.sequence}\nverdict {proof.verdict}")
    if proof.proved:
        typer.echo(f"status  {proof.status.replace('_', ' ')}\ndigits  {proof.digits_proved}")
