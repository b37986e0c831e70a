"""`hophoop run`: one motion, as a table of events, JSON, CSV, a file that can be loaded, a picture."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from hophoop.cli._options import ADVANCED, panel, with_scenario
from hophoop.results.event_table import FIRST_ROWS, LAST_ROWS

if TYPE_CHECKING:
    from hophoop.scenario import Scenario
    from hophoop.simulation.phases import PhaseRecord
    from hophoop.simulation.trajectory import Trajectory

in_output, in_advanced = panel("Output"), panel(ADVANCED)
STORES = (".nc", ".zarr", ".zarr.zip")
CHECK_DIGITS = 25


@with_scenario
def run(
    scenario: Any,
    file: Any,
    json: Annotated[bool, in_output("--json", help="Print the whole result as JSON, and nothing else.")] = False,
    out: Annotated[
        Path | None,
        in_output("--out", metavar="FILE", help="The same JSON into a file."),
    ] = None,
    csv: Annotated[
        Path | None,
        in_output(
            "--csv",
            metavar="FILE",
            help="Sampled states, one per line.",
        ),
    ] = None,
    save: Annotated[
        Path | None,
        in_output(
            "--save",
            metavar="FILE",
            help="A file for hophoop.load: .nc, .zarr or .zarr.zip.",
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        in_output(
            "--plot",
            metavar="FILE",
            help="The motion on a page: .png, .svg or .pdf.",
        ),
    ] = None,
    samples: Annotated[int, in_output("--samples", help="Number of lines in --csv.")] = 1001,
    everything: Annotated[
        bool,
        in_output(
            "--all",
            help=f"Print all rows, not the first {FIRST_ROWS} and the last {LAST_ROWS}.",
        ),
    ] = False,
    errors: Annotated[
        bool,
        in_advanced("--errors", help="Print also the estimated errors of the events."),
    ] = False,
    explain: Annotated[
        bool,
        in_output("--explain", help="Print also why each phase starts and ends, with the margins."),
    ] = False,
    sensitivity: Annotated[
        str | None,
        in_advanced(
            "--sensitivity",
            metavar="OF,…",
            help="Print, also in the JSON, derivatives of quantities like takeoff.angle,hop.height by the parameters of --wrt.",
        ),
    ] = None,
    wrt: Annotated[
        str | None,
        in_advanced(
            "--wrt",
            metavar="PATH,…",
            help="Parameters for --sensitivity, such as plane.mu,start.speed.",
        ),
    ] = None,
    until: Annotated[
        str | None,
        typer.Option(
            "--until",
            metavar="WORD",
            help="End earlier: revolutions:N, landings:N, angle:RADIANS, takeoff or reversal.",
        ),
    ] = None,
    quiet: Annotated[bool, in_output("--quiet", help="Print no table.")] = False,
    digits: Annotated[
        int | None,
        in_advanced(
            "--digits",
            metavar="N",
            help="Solve with this number of digits, 15 to 1000: the table, and --json and --out with decimal strings.",
        ),
    ] = None,
    check: Annotated[
        bool,
        in_advanced(
            "--check",
            help="Print the number of correct digits of each event, by a solution in 25 digits or --digits.",
        ),
    ] = False,
    check_fingerprint: Annotated[
        str | None,
        in_advanced(
            "--check-fingerprint",
            metavar="HEX",
            help="Compare the motion's fingerprint with this one, to check that this machine gets the same bits.",
        ),
    ] = None,
) -> None:
    """Compute one motion, from a scenario file or from options."""
    from hophoop._support.fingerprint import DIGITS, is_fingerprint
    from hophoop.cli import NO_ANSWER, _motion, say
    from hophoop.cli._output import PICTURES, check_outputs, named_options, print_json
    from hophoop.scenario import InputError

    if samples < 2:
        raise InputError.of_field("--samples", samples, "at least 2")
    if check_fingerprint is not None and not is_fingerprint(check_fingerprint):
        raise InputError.of_field("--check-fingerprint", check_fingerprint, f"{DIGITS} hexadecimal digits")
    if (sensitivity is None) != (wrt is None):
        raise InputError("--sensitivity and --wrt need each other: the quantities and the parameters.")
    if errors and scenario.contact.model != "rigid":
        raise InputError("--errors needs rigid contact; a compliant contact keeps to contact.rtol.")
    outputs = {"--csv": csv, "--save": save, "--plot": plot, "--out": out}
    endings = {"--save": STORES, "--plot": PICTURES}
    check_outputs({option: (path, endings.get(option, ())) for option, path in outputs.items()}, file)

    if digits is not None or check:
        asked = outputs | {
            "--explain": explain,
            "--errors": errors,
            "--sensitivity": sensitivity,
            "--check-fingerprint": check_fingerprint,
            "--until": until,
        }
        for option, given in asked.items():
            if given and (check or option != "--out"):
                raise InputError(f"{option} cannot be given together with {'--check' if check else '--digits'}.")
        from hophoop.cli import precise

        precise.run(scenario, CHECK_DIGITS if digits is None else digits, check, json, out, quiet, everything)
        return
    if until is not None and explain:
        raise InputError("--until cannot be given together with --explain.")
    shown = not (quiet or json)
    explained = _phases(scenario) if explain else None  # refuses a compliant contact before anything is computed
    motion = _simulate(scenario, quiet, until)
    with named_options({"of": "--sensitivity"}):
        derived = None if sensitivity is None or wrt is None else motion.sensitivity(sensitivity.split(","), wrt.split(","))
    more = {} if derived is None else {"sensitivity": derived.to_dict()}
    if json:
        print_json(motion.to_dict() | more)
    _write(motion, outputs, samples, more)
    if shown:
        _motion.print_motion(motion, everything)
        if until is not None:
            typer.echo(f"ended by {motion.ending}")
        if errors:
            _motion.print_errors(motion, everything)
        if explained is not None:
            _motion.print_phases(explained, everything)
        if derived is not None:
            typer.echo(derived)
    same = check_fingerprint is None or _compare_fingerprints(motion, check_fingerprint.lower(), json)
    if not motion.ok:
        say(_motion.no_answer(motion.duration, motion.status))
    if not (motion.ok and same):
        raise typer.Exit(NO_ANSWER)


def _compare_fingerprints(motion: Trajectory, expected: str, aside: bool) -> bool:
    """Report whether this machine gets the expected bits, on standard error if `aside`."""
    from hophoop.cli import say

    found = motion.fingerprint
    if found == expected:
        typer.echo(f"This machine gets the same bits: the fingerprint is {found}.", err=aside)
        return True
    say(
        f"hophoop {motion.version} gets other bits on this machine: the fingerprint is {found}, not {expected}. "
        "Only the same version of hophoop and the same scenario give the same bits."
    )
    return False


def _phases(scenario: Scenario) -> Iterator[PhaseRecord]:
    from hophoop.simulation.phases import phases

    return phases(scenario)


def _simulate(scenario: Scenario, quiet: bool, until: str | None) -> Trajectory:
    """Compute the motion; announce the work of a long one."""
    from hophoop._support.progress import bar
    from hophoop.cli import say
    from hophoop.cli._work import work_ahead
    from hophoop.simulation.simulate import simulate

    ahead = work_ahead(scenario)
    if ahead is not None and not quiet:
        say(ahead)
    with bar("motion", quiet=quiet, share=True) as progress:
        return simulate(scenario, until=until, progress=progress)


def _write(motion: Trajectory, outputs: Mapping[str, Path | None], samples: int, more: Mapping[str, Any]) -> None:
    """Write the requested files."""
    from hophoop import io

    if (out := outputs["--out"]) is not None:
        io.write_json(motion, out, more)
    if (csv := outputs["--csv"]) is not None:
        io.write_csv(motion, csv, motion.times(samples))
    if (save := outputs["--save"]) is not None:
        motion.save(save)
    if (plot := outputs["--plot"]) is not None:
        from hophoop.plots.overview import save_overview

        save_overview(motion, plot)
