"""Tables on a terminal, and the colours of verdicts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Literal

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


def print_table(
    titles: Sequence[str],
    rows: Iterable[Iterable[str | Text]],
    width: int,
    spare: Sequence[str] | None = None,
    *,
    right: Collection[str] = (),
    wrap: Collection[str] = (),
) -> None:
    """Print a table that fits, and name the columns that are left out for it.

    `width` is that of a pipe; `spare` are the columns to leave out, in this order: by default all but the first, from the last;
    `right` are the columns of numbers, aligned on the right; `wrap` those whose cells may take several lines. Where nothing
    else helps, Rich folds the cells of all columns, since cut numbers are useless.
    """
    console, cells = console_of(width), [list(row) for row in rows]
    needed = {title: _least_width([title, *(str(row[k]) for row in cells)], title in wrap) for k, title in enumerate(titles)}
    left_out, missing = list(titles[:0:-1] if spare is None else spare), []
    while (narrow := sum(needed.values()) + 3 * len(needed) - 1 > console.width) and left_out:  # with lines and padding
        missing.append(left_out.pop(0))
        del needed[missing[-1]]
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for title in needed:
        side: Literal["left", "right"] = "right" if title in right else "left"
        table.add_column(title, justify=side, no_wrap=not narrow and title not in wrap, overflow="fold")
    for row in cells:
        # as Text, since [1] in a cell is no markup
        shown = (cell for title, cell in zip(titles, row, strict=True) if title in needed)
        table.add_row(*(Text(cell) if isinstance(cell, str) else cell for cell in shown))
    console.print(table)
    if missing:
        console.print(f"Not shown for want of width: {', '.join(missing)}.\n")


def _least_width(texts: Iterable[str], wrap: bool) -> int:
    """Return the width of the widest of some texts, or of their words if they may be wrapped between them."""
    from rich.cells import cell_len

    return max(map(cell_len, [part for text in texts for part in (text.split() if wrap else [text])]), default=0)


def print_parameters(rows: Iterable[tuple[str, str, str]]) -> None:
    """Print parameters with their values and meanings."""
    print_table(("parameter", "value", "meaning"), rows, 200, ("meaning",), wrap=("meaning",))
