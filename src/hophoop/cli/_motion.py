"""Tables of a motion for `hophoop run`: events, their errors, phases, energies."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice
from typing import TYPE_CHECKING, Any, TypeVar

from rich.console import Console
from rich.table import Table

from hophoop.cli._tables import console_of, print_table
from hophoop.results.event_table import FIRST_ROWS, LAST_ROWS, SPARE, TITLES, WORDS, cells, change_of

if TYPE_CHECKING:
    from hophoop.results.records import EventRecord
    from hophoop.simulation.phases import Margins, PhaseRecord
    from hophoop.simulation.trajectory import Trajectory

Row = TypeVar("Row")

SPARE_ERRORS = ("± v (m/s)", "± x (m)", "± θ̇ (rad/s)", "± θ (rad)")
TITLES_DIGITS = ("event", "mode", "t (s)", "θ (rad)", "x (m)", "v (m/s)", "θ̇ (rad/s)")
SPARE_DIGITS = ("θ̇ (rad/s)", "v (m/s)", "x (m)", "θ (rad)")
ENDLESS = 4000  # width of a pipe for numbers of up to 1000 digits


def no_answer(duration: float, status: str) -> str:
    """Sentence on why a motion ended without an answer."""
    from hophoop.vocabulary.names import STATUSES

    return f"The motion ends at t = {duration:.9g} s, {status}. {STATUSES[status].sentence}"


def print_events(
    titles: Sequence[str],
    events: Sequence[Row],
    cells: Callable[[Row], Iterable[str]],
    everything: bool,
    spare: Sequence[str],
    width: int = 120,
) -> None:
    """Print a table with one row per event, of a long one the first and the last rows; the rest is as in `print_table`."""
    left_out = 0 if everything else max(0, len(events) - FIRST_ROWS - LAST_ROWS)
    rows = [list(cells(event)) for event in (events[:FIRST_ROWS] if left_out else events)]
    if left_out:
        rows += [["…"] * len(titles), *(list(cells(event)) for event in events[len(events) - LAST_ROWS :])]
    print_table(titles, rows, width, spare, right=set(titles) - set(WORDS))
    if left_out:
        console_of(width).print(f"… {left_out:,} events are left out where the dots are; --all prints them.\n")


def cells_in_digits(event: EventRecord[Any]) -> list[str]:
    """Return the cells of an event in arbitrary precision."""
    from hophoop.vocabulary.names import plain

    return [plain(event.kind), change_of(event), *map(str, (event.t, event.angle, event.x, event.vx, event.omega))]


def print_motion(motion: Trajectory, everything: bool) -> None:
    """Print the events, and a summary of the motion."""
    print_events(TITLES, motion.events, cells, everything, SPARE)
    console_of(120).print(_summary(motion))


def print_errors(motion: Trajectory, everything: bool) -> None:
    """Print the estimated error of each event."""
    from hophoop.vocabulary.names import plain

    events, errors = motion.events, motion.errors

    def row(i: int) -> list[str]:
        numbers = (errors.t[i], errors.angle[i], errors.x[i], errors.vx[i], errors.omega[i])
        return [f"{events[i].t:.15g}", plain(events[i].kind), *(f"{number:.0e}" for number in numbers)]

    titles = ("t (s)", "event", "± t (s)", "± θ (rad)", "± x (m)", "± v (m/s)", "± θ̇ (rad/s)")
    print_events(titles, range(len(events)), row, everything, SPARE_ERRORS)


def print_phases(phases: Iterator[PhaseRecord], everything: bool) -> None:
    """Print why each phase starts and ends."""
    console = Console(highlight=False, soft_wrap=True)
    for phase in islice(phases, None if everything else FIRST_ROWS):
        console.print(
            f"{phase.t_begin:.6f} to {phase.t_end:.6f} s: {phase.word} ({phase.mode}), "
            f"θ from {math.degrees(phase.angle_begin):.3f} to {math.degrees(phase.angle_end):.3f}°"
        )
        for name, found in (("begins", phase.begin), ("ends", phase.end)):
            console.print(f"    {name:6s} with {_margins(found)}")
        console.print(f"    {phase.ended_by} {phase.then}")
    if next(phases, None) is not None:
        console.print(f"… These are the first {FIRST_ROWS} phases; --all explains the others, too.")


def _margins(found: Margins) -> str:
    slip = f"v_t = {_format(found.slip)} m/s"
    if found.height > 0.0 or (found.normal_force == 0.0 and found.friction_limit == 0.0):
        return f"gap {found.height:.6g} m, {slip}, f_n = {_format(found.free_acceleration)} m/s²"
    limit = _format(found.friction_limit)
    text = f"N = {_format(found.normal_force)} N, F = {_format(found.friction_force)} N of {limit} N"
    return text if math.isnan(found.p_sigma) else f"{text}, {slip}, p_σ = {found.p_sigma:.6g}"


def _format(number: float) -> str:
    return f"{0.0 if abs(number) < 1e-12 else number:.6g}"


def _summary(motion: Trajectory) -> Table:
    from hophoop.vocabulary.names import LETTERS, plain
    from hophoop.vocabulary.quantities import normal_loss

    ledger = motion.ledger
    normal = normal_loss(motion.scenario.contact.model).removeprefix("lost ")
    resists = motion.scenario.plane.rolling_resistance > 0.0
    rolling = f", to rolling resistance {ledger.rolling_resistance:.6g} J" if resists else ""
    table = Table.grid(padding=(0, 2))
    letters = ", ".join(f"{letter} {word}" for letter, word in LETTERS.items() if letter != "+")
    phases = motion.sequence if len(motion.sequence) <= 60 else motion.sequence[:59] + "…"
    table.add_row("phases", f"{phases}   ({letters})")
    table.add_row("status", plain(motion.status))
    table.add_row(
        "energy",
        f"kinetic {ledger.kinetic:.6g} J, potential {ledger.potential:.6g} J; lost: to friction "
        f"{ledger.friction_loss:.6g} J (in slip {ledger.friction:.6g} J, in impacts {ledger.impact_tangential:.6g} J), "
        f"{normal} {ledger.normal_loss:.6g} J{rolling}; residual {ledger.residual:.1e} J",
    )
    table.add_row("fingerprint", motion.fingerprint)
    return table
