"""`hophoop run`: one motion, as a table of events, JSON, CSV, a file that can be loaded, a picture."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

if TYPE_CHECKING:
    from hophoop.simulation.trajectory import Trajectory

STORES = (".nc", ".zarr", ".zarr.zip")
CHECK_DIGITS = 25


def run(
    scenario: Any,
    file: Any = None,
    json: bool = False,
    out: Path | None = None,
    csv: Path | None = None,
    save: Path | None = None,
    plot: Path | None = None,
    samples: int = 1001,
    everything: bool = False,
    errors: bool = False,
    explain: bool = False,
    sensitivity: str | None = None,
    wrt: str | None = None,
    until: str | None = None,
    quiet: bool = False,
    digits: int | None = None,
    check: bool = False,
    check_fingerprint: str | None = None,
) -> None:
    """Compute one motion, from a scenario file or from options.

    Options
    -------
    until : WORD
        End earlier: revolutions:N, landings:N, angle:RADIANS, takeoff or reversal.

    Output
    ------
    json
        Print the whole result as JSON, and nothing else.
    out
        The same JSON into a file.
    csv
        Sampled states, one per line.
    save
        A file for hophoop.load: .nc, .zarr or .zarr.zip.
    plot
        The motion on a page: .png, .svg or .pdf.
    samples
        Number of lines in --csv.
    everything : --all
        Print all rows of long tables, not only the first and the last ones.
    explain
        Print also why each phase starts and ends, with the margins.
    quiet
        Print no table.

    Advanced
    --------
    errors
        Print also the estimated errors of the events.
    sensitivity : OF,…
        Print, also in the JSON, derivatives of quantities like takeoff.angle,hop.height by the parameters of --wrt.
    wrt : PATH,…
        Parameters for --sensitivity, such as plane.mu,start.speed.
    digits : N
        Solve with this number of digits, 15 to 1000: the table, and --json and --out with decimal strings.
    check
        Print the number of correct digits of each event, by a solution in 25 digits or --digits.
    check_fingerprint : HEX
        Compare the motion's fingerprint with this one, to check that this machine gets the same bits.
    """
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
    from hophoop._support.progress import bar
    from hophoop.simulation.phases import phases
    from hophoop.simulation.simulate import simulate

    if until is not None and explain:
        raise InputError("--until cannot be given together with --explain.")
    shown = not (quiet or json)
    explained = phases(scenario) if explain else None  # refuses a compliant contact before anything is computed
    with bar("motion", quiet=quiet, share=True) as progress:
        motion = simulate(scenario, until=until, progress=progress)
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
