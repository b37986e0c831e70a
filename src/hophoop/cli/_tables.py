"""Tables on a terminal, and the colours of verdicts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import TYPE_CHECKING

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

if TYPE_CHECKING:
    from rich.console import RenderableType

VERDICT_STYLES = {
    "agrees": "green",
    "agrees within reading accuracy": "cyan",
    "differs": "yellow",
    "fails": "bold white on red",
}


def console_of(width: int) -> Console:
    """Console for tables; a pipe gets a fixed width so that tables are not cut."""
    console = Console(highlight=False)
    return console if console.is_terminal else Console(highlight=False, width=width)


def verdict(word: str) -> Text:
    """Cell with a verdict in its colour."""
    return Text(word, VERDICT_STYLES[word])


def table_of(
    titles: Sequence[str],
    rows: Iterable[Iterable[str | Text]],
    *,
    right: Collection[str] = (),
    wrap: Collection[str] = (),
) -> Table:
    """Table in the style of all commands.

    `right` are the columns of numbers, aligned on the right; `wrap` those whose cells may take several lines.
    """
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for title in titles:
        table.add_column(
            title,
            justify="right" if title in right else "left",
            no_wrap=title not in wrap,
            overflow="fold" if title in wrap else "ellipsis",
        )
    for row in rows:
        # as Text, since [1] in a cell is no markup
        table.add_row(*(Text(cell) if isinstance(cell, str) else cell for cell in row))
    return table


def print_table(table: RenderableType, width: int) -> None:
    """Print a table; `width` is that of a pipe."""
    console_of(width).print(table)


def drop_columns(table: Table, console: Console, spare: Sequence[str]) -> list[str]:
    """Remove spare columns until the table fits, since cut numbers are useless; return their titles."""
    from rich.measure import Measurement

    dropped: list[str] = []
    endless = console.options.update(width=10_000)
    for title in spare:
        if Measurement.get(console, endless, table).maximum <= console.width:
            break
        table.columns = [column for column in table.columns if column.header != title]
        dropped.append(title)
    return dropped


def print_parameters(rows: Iterable[tuple[str, str, str]]) -> None:
    """Print parameters with their values and meanings."""
    print_table(table_of(("parameter", "value", "meaning"), rows, wrap=("meaning",)), 200)
