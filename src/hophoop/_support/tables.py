"""Small tables of results: plain text for `repr`, HTML for notebooks."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Iterable, Sequence
from html import escape


def length(text: str) -> int:
    """Return the width of a text [characters]; an accent such as the dot over θ̇ has no width."""
    return sum(not unicodedata.combining(character) for character in text)


def columns(rows: Sequence[Sequence[str]], left: Collection[int] = (0,)) -> list[str]:
    """Return rows as lines with columns of one width; those of `left` are aligned on the left, the others on the right."""
    if not rows:
        return []
    widths = [max(map(length, column)) for column in zip(*rows, strict=True)]
    lines = []
    for row in rows:
        cells = []
        for k, (cell, width) in enumerate(zip(row, widths, strict=True)):
            space = " " * (width - length(cell))
            cells.append(cell + space if k in left else space + cell)
        lines.append("  ".join(cells).rstrip())
    return lines


def report(head: str, rows: Sequence[Sequence[str]], notes: Iterable[str] = (), left: Collection[int] = (0,)) -> str:
    """Return the `repr` of a result: a line in angle brackets, then a table and notes, indented."""
    return "\n".join([f"<{head}>", *(f"  {line}" for line in [*columns(rows, left), *notes])])


def html(
    rows: Iterable[Sequence[str]],
    titles: Sequence[str] = (),
    left: Collection[int] = (0,),
    *,
    before: Iterable[str] = (),
    after: Iterable[str] = (),
) -> str:
    """Return a table for notebooks, with notes above and below it."""

    def said(notes: Iterable[str]) -> str:
        return "".join(f"<p>{escape(note)}</p>" for note in notes)

    def line(tag: str, cells: Sequence[str]) -> str:
        styles = [" style='text-align:left'" if k in left else "" for k in range(len(cells))]
        inner = (f"<{tag}{style}>{escape(cell)}</{tag}>" for style, cell in zip(styles, cells, strict=True))
        return f"<tr>{''.join(inner)}</tr>"

    head = f"<thead>{line('th', titles)}</thead>" if titles else ""
    body = "".join(line("td", row) for row in rows)
    return f"<div>{said(before)}<table>{head}<tbody>{body}</tbody></table>{said(after)}</div>"
