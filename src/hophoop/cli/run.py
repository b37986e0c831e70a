"""`hophoop run`: one motion, as a table of events, JSON, CSV, a file that can be loaded, a picture."""

from __future__ import annotations

import json as json_text
import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand

from hophoop.cli._options import with_scenario
from hophoop.cli._output import console_of

if TYPE_CHECKING:
    from rich.table import Table

    from hophoop.explanation import Margins, PhaseRecord
    from hophoop.results import EventRecord
    from hophoop.trajectory import Trajectory

OUTPUT = "Output"
STORES = (".nc", ".zarr", ".zarr.zip")
FIRST_ROWS, LAST_ROWS = 60, 20  # of a table that is too long to read
CHECK_DIGITS = 25
SPARE_COLUMNS = ("slip (m/s)", "x (m)", "height (m)", "θ̇ (rad/s)", "v (m/s)", "mode", "θ (°)")  # where a terminal is narrow


class RunCommand(TyperCommand):
    """`--json` takes a file or nothing, which the parser itself does not know."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Spell out `--json` as `--json=FILE` or `--json=-`."""
        return super().parse_args(ctx, _spelt_out(list(args), self._valued()))

    def _valued(self) -> set[str]:
        return {name for parameter in self.params if not getattr(parameter, "is_flag", False) for name in parameter.opts}


def _spelt_out(args: list[str], valued: set[str]) -> list[str]:
    """What follows `--json` is the file to write, but for a scenario that stands nowhere else.

    So `run --json hop.toml` reads hop.toml and prints, and never writes over it.
    """
    result: list[str] = []
    words = 0  # scenarios seen outside of options
    pending = -1
    k = 0
    while k < len(args):
        word = args[k]
        if word == "--":
            words += len(args) - k - 1
            result += args[k:]
            break
        if word == "--json":
            following = args[k + 1] if k + 1 < len(args) else "--"
            if following.startswith("-"):
                result.append("--json=-")
            else:
                pending = len(result)
                result.append(f"--json={following}")
                k += 1
        else:
            result.append(word)
            if word.startswith("--") and "=" not in word and word in valued and k + 1 < len(args):
                result.append(args[k + 1])
                k += 1
            elif word == "-" or not word.startswith("-"):
                words += 1
        k += 1
    if pending >= 0 and words == 0:
        name = result[pending].removeprefix("--json=")
        if name.lower().endswith(".toml") or (Path(name).is_file() and _is_scenario(Path(name))):
            result[pending : pending + 1] = ["--json=-", name]
    return result


def _is_scenario(path: Path) -> bool:
    """Whether a file that is there is a scenario rather than an older result."""
    try:
        data = json_text.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return False
    return isinstance(data, dict) and "schema" not in data


COMMAND_CLASS = RunCommand


@with_scenario
def run(
    scenario: Any,
    file: Any,
    json: Annotated[
        str | None,
        typer.Option(
            "--json",
            metavar="[FILE]",
            help="The whole result as JSON, to standard output or a file.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    csv: Annotated[
        Path | None,
        typer.Option(
            "--csv",
            metavar="FILE",
            help="Sampled states, one line each.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    save: Annotated[
        Path | None,
        typer.Option(
            "--save",
            metavar="FILE",
            help="A file for hophoop.load: .nc, .zarr or .zarr.zip.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot",
            metavar="FILE",
            help="The motion on a page: .png, .svg or .pdf.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    samples: Annotated[int, typer.Option("--samples", help="Number of lines in --csv.", rich_help_panel=OUTPUT)] = 1001,
    everything: Annotated[
        bool,
        typer.Option(
            "--all", help=f"Print all events, not the first {FIRST_ROWS} and the last {LAST_ROWS}.", rich_help_panel=OUTPUT
        ),
    ] = False,
    errors: Annotated[
        bool,
        typer.Option("--errors", help="Print also how sure each event is: estimated errors.", rich_help_panel=OUTPUT),
    ] = False,
    explain: Annotated[
        bool,
        typer.Option("--explain", help="Say also why each phase begins and ends, with the margins.", rich_help_panel=OUTPUT),
    ] = False,
    sensitivity: Annotated[
        str | None,
        typer.Option(
            "--sensitivity",
            metavar="OF,…",
            help="Say, also in --json, how quantities change with the parameters of --wrt, such as takeoff.angle,hop.height.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    wrt: Annotated[
        str | None,
        typer.Option(
            "--wrt",
            metavar="PATH,…",
            help="Parameters for --sensitivity, such as plane.mu,start.speed.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="Print no table.", rich_help_panel=OUTPUT)] = False,
    digits: Annotated[
        int | None,
        typer.Option(
            "--digits",
            metavar="N",
            help="Solve in so many digits, 15 to 1000: the table, and --json with decimal strings.",
            rich_help_panel=OUTPUT,
            show_default=False,
        ),
    ] = None,
    check: Annotated[
        bool,
        typer.Option(
            "--check",
            help="Say how many digits of every event are right, by a solution in 25 digits or --digits.",
            rich_help_panel=OUTPUT,
        ),
    ] = False,
) -> None:
    """Compute one motion, from a scenario file or from options."""
    from hophoop.cli import NO_ANSWER, say
    from hophoop.cli._output import PICTURES, check_apart, check_ending, check_folder
    from hophoop.scenario import InputError

    if plot is not None:
        check_ending("--plot", plot, PICTURES)
    if save is not None:
        check_ending("--save", save, STORES)
    if samples < 2:
        raise InputError(f"--samples = {samples} must be at least 2.")
    result = Path(json) if json not in (None, "-") else None
    if (sensitivity is None) != (wrt is None):
        raise InputError("--sensitivity and --wrt need each other: what changes, and with which parameters.")
    outputs = {"--csv": csv, "--save": save, "--plot": plot, "--json": result}
    for option, path in outputs.items():
        if path is not None:
            check_folder(option, path)
    check_apart([path for path in outputs.values() if path is not None], file)

    if digits is not None or check:
        for option, path in outputs.items():
            if path is not None and (check or option != "--json"):
                raise InputError(f"{option} cannot be given together with {'--check' if check else '--digits'}.")
        for option, given in (("--explain", explain), ("--sensitivity", sensitivity)):
            if given:
                raise InputError(f"{option} cannot be given together with {'--check' if check else '--digits'}.")
        from hophoop.cli import precise

        precise.run(scenario, CHECK_DIGITS if digits is None else digits, check, json, quiet)
        return

    from rich.console import Console

    from hophoop.cli._work import with_progress, work_ahead
    from hophoop.explanation import phases

    explained = phases(scenario) if explain else None  # says at once what it cannot explain
    ahead = work_ahead(scenario)
    if ahead is not None and not quiet:
        say(ahead)
    motion = with_progress(scenario, Console(stderr=True, quiet=quiet))
    derived = (
        motion.sensitivity(sensitivity.split(","), wrt.split(",")) if sensitivity is not None and wrt is not None else None
    )
    more = {} if derived is None else {"sensitivity": derived.to_dict()}
    if json == "-":
        text = json_text.dumps(motion.to_dict() | more, indent=2, ensure_ascii=False, allow_nan=False)
        typer.echo(text)
    if csv is not None or result is not None:
        from hophoop import io

        if result is not None:
            io.write_json(motion, result, more)
        if csv is not None:
            io.write_csv(motion, csv, motion.times(samples))
    if save is not None:
        motion.save(save)
    if plot is not None:
        from hophoop.plots.overview import save_overview

        save_overview(motion, plot)
    if json != "-" and not quiet:
        _print(motion, everything)
        if errors:
            _print_errors(motion)
        if explained is not None:
            _print_phases(explained, everything)
        if derived is not None:
            typer.echo(derived)
    if not motion.ok:
        say(unanswered(motion.duration, motion.status))
        raise typer.Exit(NO_ANSWER)


def unanswered(duration: float, status: str) -> str:
    """The sentence that tells why a motion ended without an answer."""
    from hophoop.vocabulary.words import STATUSES

    return f"The motion ends at t = {duration:.9g} s, {status}. {STATUSES[status]}"


def _print(motion: Trajectory, everything: bool) -> None:

    from hophoop.cli._output import fitted

    # a pipe has no width of its own; a table that is cut is worth little
    console = console_of(120)
    events = motion.events
    left_out = 0 if everything else max(0, len(events) - FIRST_ROWS - LAST_ROWS)
    table = _events(events, left_out)
    missing = fitted(table, console, SPARE_COLUMNS)
    console.print(table)
    if missing:
        console.print(f"Not shown for want of width: {', '.join(missing)}.\n")
    if left_out:
        console.print(f"… {left_out:,} events are left out where the dots are; --all prints them.\n")
    console.print(_summary(motion))


def _print_errors(motion: Trajectory) -> None:
    from rich import box
    from rich.console import Console
    from rich.table import Table

    from hophoop.vocabulary.words import plain

    found = motion.errors
    table = Table(box=box.SIMPLE_HEAD, title=None, pad_edge=False)
    for title in ("t (s)", "event", "± t (s)", "± θ (rad)", "± x (m)", "± v (m/s)", "± θ̇ (rad/s)"):
        table.add_column(title, justify="left" if title == "event" else "right", no_wrap=True)
    for i, event in enumerate(motion.events):
        numbers = (found.t[i], found.angle[i], found.x[i], found.vx[i], found.omega[i])
        table.add_row(f"{event.t:.15g}", plain(event.kind), *(f"{number:.0e}" for number in numbers))
    Console(highlight=False, width=120).print(table)


def _print_phases(phases: Iterator[PhaseRecord], everything: bool) -> None:
    from itertools import islice

    from rich.console import Console

    console = Console(highlight=False, soft_wrap=True)
    for number, phase in enumerate(islice(phases, None if everything else FIRST_ROWS)):
        if number == 0 and phase.t_begin > 0.0:
            console.print(f"Until t = {phase.t_begin:.6f} s the events are decided in more digits than doubles have.")
        console.print(
            f"{phase.t_begin:.6f} to {phase.t_end:.6f} s: {phase.word} ({phase.mode}), "
            f"θ from {math.degrees(phase.angle_begin):.3f} to {math.degrees(phase.angle_end):.3f}°"
        )
        for name, found in (("begins", phase.begin), ("ends", phase.end)):
            console.print(f"    {name:6s} with {_margins(found)}")
        console.print(f"    {phase.ended_by} {phase.then}")


def _margins(found: Margins) -> str:
    slip = f"v_t = {_rounded(found.slip)} m/s"
    if found.height > 0.0 or (found.normal_force == 0.0 and found.friction_limit == 0.0):
        return f"gap {found.height:.6g} m, {slip}, f_n = {_rounded(found.free_acceleration)} m/s²"
    limit = _rounded(found.friction_limit)
    text = f"N = {_rounded(found.normal_force)} N, F = {_rounded(found.friction_force)} N of {limit} N"
    return text if math.isnan(found.p_sigma) else f"{text}, {slip}, p_σ = {found.p_sigma:.6g}"


def _rounded(number: float) -> str:
    return f"{0.0 if abs(number) < 1e-12 else number:.6g}"


def _events(events: Sequence[EventRecord], left_out: int) -> Table:
    from rich import box
    from rich.table import Table

    from hophoop.vocabulary.words import plain

    table = Table(box=box.SIMPLE_HEAD, title=None, pad_edge=False)
    for title in (
        "t (s)",
        "event",
        "mode",
        "θ (°)",
        "x (m)",
        "height (m)",
        "v (m/s)",
        "θ̇ (rad/s)",
        "slip (m/s)",
    ):
        table.add_column(title, justify="left" if title in ("event", "mode") else "right", no_wrap=True)
    shown = [*events[:FIRST_ROWS], None, *events[FIRST_ROWS + left_out :]] if left_out else events
    for event in shown:
        if event is None:
            table.add_row(*["…"] * len(table.columns))
            continue
        change = event.to_mode if event.from_mode in (None, event.to_mode) else f"{event.from_mode} → {event.to_mode}"
        numbers = (math.degrees(event.angle), event.x, event.height, event.vx, event.omega, event.slip)
        table.add_row(
            f"{event.t:.6f}",
            plain(event.kind),
            change,
            *(f"{_clean(number):.4f}" for number in numbers),
        )
    return table


def _clean(number: float) -> float:
    return 0.0 if abs(number) < 5e-5 else number


def _summary(motion: Trajectory) -> Table:
    from rich.table import Table

    from hophoop.vocabulary.words import LETTERS_SENTENCE, plain

    ledger = motion.ledger
    impacts = ledger.impact_normal + ledger.impact_tangential
    resists = motion.scenario.plane.rolling_resistance > 0.0
    rolling = f", rolling resistance {ledger.rolling_resistance:.6g} J" if resists else ""
    table = Table.grid(padding=(0, 2))
    phases = motion.sequence if len(motion.sequence) <= 60 else motion.sequence[:59] + "…"
    table.add_row("phases", f"{phases}   ({LETTERS_SENTENCE})")
    table.add_row("status", plain(motion.status))
    table.add_row(
        "energy",
        f"kinetic {ledger.kinetic:.6g} J, potential {ledger.potential:.6g} J; lost: friction "
        f"{ledger.friction:.6g} J, impacts {impacts:.6g} J{rolling}; residual {ledger.residual:.1e} J",
    )
    return table
