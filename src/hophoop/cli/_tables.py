"""Tables on a terminal, and the colours of verdicts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

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


def print_table(
    titles: Sequence[str],
    rows: Iterable[Iterable[str | Text]],
    width: int,
    spare: Sequence[str] | None = None,
    *,
    right: Collection[str] = (),
    wrap: Collection[str] = (),
) -> None:
    """Print a table that fits, and name the columns that are left out for it; the rest is as in `table_of`.

    `width` is that of a pipe; `spare` are the columns to leave out, in this order: by default all but the first, from the last.
    Where this is not enough, cells take several lines, since cut numbers are useless.
    """
    console = console_of(width)
    cells = [list(row) for row in rows]
    missing: list[str] = []
    left_out = list(titles[:0:-1] if spare is None else spare)
    while True:
        kept = [k for k, title in enumerate(titles) if title not in missing]
        shown = [[row[k] for k in kept] for row in cells]
        table = table_of([titles[k] for k in kept], shown, right=right, wrap=wrap)
        if _least_width(table, console) <= console.width or not left_out:
            break
        missing.append(left_out.pop(0))
    if _least_width(table, console) > console.width:
        for column in table.columns:
            column.no_wrap, column.overflow = False, "fold"
    console.print(table)
    if missing:
        console.print(f"Not shown for want of width: {', '.join(missing)}.\n")


def _least_width(table: Table, console: Console) -> int:
    """Return the width in which only the columns that may wrap do, between words."""
    from rich.cells import cell_len
    from rich.measure import Measurement

    width = Measurement.get(console, console.options.update(width=10_000), table).maximum
    for column in table.columns:
        if not column.no_wrap:
            texts = [str(cell) for cell in (column.header, *column.cells)]
            width -= max(map(cell_len, texts)) - max(cell_len(word) for text in texts for word in text.split() or [""])
    return width


def print_parameters(rows: Iterable[tuple[str, str, str]]) -> None:
    """Print parameters with their values and meanings."""
    print_table(("parameter", "value", "meaning"), rows, 200, ("meaning",), wrap=("meaning",))


def print_comparison(rows: Sequence[Sequence[str]]) -> None:
    """Print a table whose first row is its head."""
    print_table(rows[0], rows[1:], 200, ())
