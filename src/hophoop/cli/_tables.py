"""What `hophoop run` prints of a motion: events, their errors, phases, energies."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice
from typing import TYPE_CHECKING, TypeVar

from hophoop.cli._output import console_of, fitted
from hophoop.results.event_table import FIRST_ROWS, LAST_ROWS, SPARE, TITLES, WORDS, cells

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from hophoop.results.records import EventErrors
    from hophoop.simulation.phases import Margins, PhaseRecord
    from hophoop.simulation.trajectory import Trajectory

Row = TypeVar("Row")

SPARE_ERRORS = ("± v (m/s)", "± x (m)", "± θ̇ (rad/s)", "± θ (rad)")


def unanswered(duration: float, status: str) -> str:
    """The sentence that tells why a motion ended without an answer."""
    from hophoop.vocabulary.statuses import STATUSES

    return f"The motion ends at t = {duration:.9g} s, {status}. {STATUSES[status].sentence}"


def table_of(titles: Sequence[str], rows: Sequence[Row], cells: Callable[[Row], Iterable[str]], everything: bool) -> Table:
    """A table; of a long one the first and the last rows, with dots between."""
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, title=None, pad_edge=False)
    for title in titles:
        table.add_column(title, justify="left" if title in WORDS else "right", no_wrap=True)
    left_out = 0 if everything else _left_out(len(rows))
    for number, row in enumerate(rows):
        if left_out and number == FIRST_ROWS:
            table.add_row(*["…"] * len(titles))
        if not left_out or not FIRST_ROWS <= number < FIRST_ROWS + left_out:
            table.add_row(*cells(row))
    return table


def _left_out(count: int) -> int:
    return max(0, count - FIRST_ROWS - LAST_ROWS)


def say_left_out(console: Console, count: int, everything: bool) -> None:
    """Say how many of so many events a table does not show."""
    if not everything and (left_out := _left_out(count)):
        console.print(f"… {left_out:,} events are left out where the dots are; --all prints them.\n")


def _print_table(table: Table, spare: Sequence[str], count: int, everything: bool) -> None:
    console = console_of(120)
    missing = fitted(table, console, spare)
    console.print(table)
    if missing:
        console.print(f"Not shown for want of width: {', '.join(missing)}.\n")
    say_left_out(console, count, everything)


def print_motion(motion: Trajectory, everything: bool) -> None:
    """Events, and what the motion comes to."""
    events = motion.events
    _print_table(table_of(TITLES, events, cells, everything), SPARE, len(events), everything)
    console_of(120).print(_summary(motion))


def print_errors(motion: Trajectory, errors: EventErrors, everything: bool) -> None:
    """How sure each event is."""
    from hophoop.vocabulary.words import plain

    events = motion.events

    def row(i: int) -> list[str]:
        numbers = (errors.t[i], errors.angle[i], errors.x[i], errors.vx[i], errors.omega[i])
        return [f"{events[i].t:.15g}", plain(events[i].kind), *(f"{number:.0e}" for number in numbers)]

    titles = ("t (s)", "event", "± t (s)", "± θ (rad)", "± x (m)", "± v (m/s)", "± θ̇ (rad/s)")
    _print_table(table_of(titles, range(len(events)), row, everything), SPARE_ERRORS, len(events), everything)


def print_phases(phases: Iterator[PhaseRecord], everything: bool) -> None:
    """Why each phase begins and ends."""
    from rich.console import Console

    console = Console(highlight=False, soft_wrap=True)
    reached = 0.0
    for phase in islice(phases, None if everything else FIRST_ROWS):
        if phase.t_begin > reached:
            console.print(f"Until t = {phase.t_begin:.6f} s the events are decided in more digits than doubles have.")
        console.print(
            f"{phase.t_begin:.6f} to {phase.t_end:.6f} s: {phase.word} ({phase.mode}), "
            f"θ from {math.degrees(phase.angle_begin):.3f} to {math.degrees(phase.angle_end):.3f}°"
        )
        for name, found in (("begins", phase.begin), ("ends", phase.end)):
            console.print(f"    {name:6s} with {_margins(found)}")
        console.print(f"    {phase.ended_by} {phase.then}")
        reached = phase.t_end
    if next(phases, None) is not None:
        console.print(f"… These are the first {FIRST_ROWS} phases; --all explains the others, too.")


def _margins(found: Margins) -> str:
    slip = f"v_t = {_rounded(found.slip)} m/s"
    if found.height > 0.0 or (found.normal_force == 0.0 and found.friction_limit == 0.0):
        return f"gap {found.height:.6g} m, {slip}, f_n = {_rounded(found.free_acceleration)} m/s²"
    limit = _rounded(found.friction_limit)
    text = f"N = {_rounded(found.normal_force)} N, F = {_rounded(found.friction_force)} N of {limit} N"
    return text if math.isnan(found.p_sigma) else f"{text}, {slip}, p_σ = {found.p_sigma:.6g}"


def _rounded(number: float) -> str:
    return f"{0.0 if abs(number) < 1e-12 else number:.6g}"


def _summary(motion: Trajectory) -> Table:
    from rich.table import Table

    from hophoop.vocabulary.modes import LETTERS_SENTENCE
    from hophoop.vocabulary.words import plain

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
    table.add_row("fingerprint", motion.fingerprint)
    return table
