"""The table of a motion's events as text; `hophoop run` prints the same columns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from hophoop._support import tables
from hophoop.vocabulary.names import plain

if TYPE_CHECKING:
    from hophoop.results.records import EventRecord

TITLES = ("t (s)", "event", "mode", "θ (°)", "x (m)", "height (m)", "v (m/s)", "θ̇ (rad/s)", "slip (m/s)")
WORDS = ("event", "mode")  # text columns; all others are numbers
SPARE = ("slip (m/s)", "x (m)", "height (m)", "θ̇ (rad/s)", "v (m/s)", "mode", "θ (°)")  # left out in this order if too wide
FIRST_ROWS, LAST_ROWS = 60, 20  # rows shown of a long table
WIDTH = 100  # of the text [characters]


def cells(event: EventRecord[float]) -> list[str]:
    """Return a row of the table, in the order of `TITLES`."""
    numbers = (math.degrees(event.angle), event.x, event.height, event.vx, event.omega, event.slip)
    return [f"{event.t:.6f}", plain(event.kind), change_of(event), *(f"{number:z.4f}" for number in numbers)]


def change_of(event: EventRecord[Any]) -> str:
    """Return the letters of the mode before and after an event."""
    return event.to_mode if event.from_mode in (None, event.to_mode) else f"{event.from_mode} → {event.to_mode}"


def text_table(events: Sequence[EventRecord[float]], width: int = WIDTH) -> str:
    """Return the table as plain text.

    width: maximum width; columns are left out until the table fits [characters].
    """
    left_out = max(0, len(events) - FIRST_ROWS - LAST_ROWS)
    shown = [*events[:FIRST_ROWS], *events[FIRST_ROWS + left_out :]] if left_out else events
    columns = {title: [title, *column] for title, *column in zip(TITLES, *map(cells, shown), strict=True)}
    if left_out:
        for column in columns.values():
            column.insert(1 + FIRST_ROWS, "…")
    missing = []
    for title in SPARE:
        if sum(max(map(tables.length, column)) + 2 for column in columns.values()) - 2 <= width:
            break
        del columns[title]
        missing.append(title)
    for column in columns.values():
        column.insert(1, "─" * max(map(tables.length, column)))
    left = [k for k, title in enumerate(columns) if title in WORDS]
    lines = tables.columns(list(zip(*columns.values(), strict=True)), left)
    if missing:
        lines.append(f"Not shown for want of width: {', '.join(missing)}.")
    if left_out:
        lines.append(f"… {left_out:,} events are left out where the dots are.")
    return "\n".join(lines)
