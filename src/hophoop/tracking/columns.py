"""From the text of a table to columns of numbers: its separator, cells, heads, units and numbers, as people write them."""

from __future__ import annotations

import csv
import re
import statistics
import unicodedata
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.tracking.dialects import (
    COMMA_WORDS,
    HEADS,
    KNOWN_UNITS,
    NAMES,
    NO_POSITION,
    OTHER_UNITS,
    ROTATION,
    UNITS,
)

Floats = NDArray[np.float64]

EMPTY = {"", "-", "–", "none", "nan", "na", "n/a", "null", "#n/a", "#nv", "#wert!", "#value!", "#div/0!"}
COMMENT = re.compile(r"\s*(?:#(?!N/A|NV\b|[A-Z/0]+!)|%|//)\s*(.*)")
SIGNS = {0x2212: "-", 0xFF0D: "-", 0xFF0E: ".", 0xFF0C: ",", 0x66B: "."}  # of typesetters, full width, Arabic
NUMBER = re.compile(r"[-+]?(?:\d+(?:[.,]\d{3})*[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?")
GROUPED = {",": r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?", ".": r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?"}
CLOCK = re.compile(
    r"(?:(?P<date>\d{1,4}[-./](?:\d{1,2}|[A-Za-z]{3})[-./]\d{1,4})[T,\s]+)?"
    r"(?:(?P<hours>\d+):)?(?P<minutes>\d+):(?P<seconds>\d+(?:[.,]\d+)?)(?:[:;](?P<frames>\d+))?"
    r"\s*(?P<half>[APap]\.?[Mm]\.?)?\s*(?:Z|UTC|[-+]\d\d:?\d\d)?"
)
BLANKS = r"\s+(?![\[(])"  # not before a unit
GROUPS = re.compile(r"(?<=\d)[\s'’](?=\d{3}(?:\D|$))")  # signs that group digits and are no separators
HOUR, DAY = 3600.0, 86400.0
MOST_SNIFFED = 200  # lines


class Table(NamedTuple):
    """Cells of a table."""

    above: list[list[str]]  # rows above the numbers
    body: list[list[str]]  # rows of numbers, '' for empty cells, without those at their ends
    comments: list[str]  # above each of these rows
    below: str  # text below the numbers
    separator: str  # between cells; '' for blanks


@dataclass(frozen=True, eq=False)
class Column:
    """A column of a table."""

    number: int  # from 1
    head: str = ""  # as the file spells it, after the words above it that tell it apart
    point: str = ""
    quantity: str = ""  # a name of COLUMNS, 'frame', 'polar', 'object' or ''; x, y and z for positions
    unit: str = ""
    group: str = ""  # of a run, or of columns with times of their own
    values: Floats = field(default_factory=lambda: np.zeros(0))  # nan for empty cells and words
    words: Sequence[str] = ()  # of a column without numbers

    @property
    def label(self) -> str:
        """Its head as the file spells it, or its number."""
        return self.head or f"column {self.number}"


def read_columns(text: str, name: str, rate: float | None = None) -> tuple[list[Column], list[str]]:
    """Read a table: its columns, and remarks on how it was understood.

    name: of the file, for messages; rate: frames per second, for clocks that count frames.
    """
    table = split(text, name)
    found, notes = columns(table, name, rate)
    if table.below:
        notes.append(f"Lines below the table are not read: {table.below}")
    return apart(grouped(found), table.comments), notes


# --- lines and cells -------------------------------------------------------------------------------


def split(text: str, name: str) -> Table:
    """Split a text into cells, and the rows of numbers from those above and below; name: of the file, for messages."""
    digits = {ord(sign): str(unicodedata.decimal(sign)) for sign in set(text) if sign.isdecimal()}
    said, counts, lines = [""], [], []  # comments, and lines with the number of comments above each
    for line in text.translate(digits | SIGNS).splitlines():
        if found := COMMENT.match(line):
            said.append(found[1].strip())
        elif line.strip(" \t;,"):
            lines.append(line)
            counts.append(len(said))
    if not lines:
        raise InputError(f"{name} is empty.")
    separator = next((sign for sign in "\t;," if _divides(sign, lines[:MOST_SNIFFED])), "")
    rows = _rows(lines, separator)
    counts = counts[-len(rows) :]  # a cell with a line break makes one row of two lines
    first = _first_row(rows)
    if first is None:
        raise InputError(f"{name} has no {'table' if len(rows) < 2 else 'row of numbers'}.")
    last = max(k for k, row in enumerate(rows) if _is_data(row)) + 1
    above, body = rows[:first], rows[first:last]
    width = max(map(len, body))
    short = next((k for k, row in enumerate(body, 1) if len(row) < width), None)
    if short and not separator:
        raise InputError(
            f"{name} has a cell too few in row {short} of the numbers, and blanks do not show which one is empty: "
            "save the table with semicolons."
        )
    if width > 1 and max(map(len, above), default=0) < 2:  # comments are heads where they are the only ones
        heads_in_comments = [_divided(comment, width, separator) for comment in said[1 : counts[first]]]
        above = [cells for cells in heads_in_comments if len(cells) == width][-1:]
    cells = [[_without_groups(cell) for cell in row] for row in body]
    comments = [said[count - 1] for count in counts[first:last]]
    return Table(above, cells, comments, " ".join(cell for row in rows[last:] for cell in row), separator)


def _divides(sign: str, lines: list[str]) -> bool:
    """Return True if a sign divides the numbers, and the heads above them."""
    rows = _rows(lines, sign)
    first = _first_row(rows)
    if first is None or min(map(len, rows[max(first - 1, 0) : first + 1])) < 2:
        return False
    begun = [cell for row in rows[first:] for cell in row if re.match(r"[-+]?[.,]?\d", cell)]
    return sum(map(_is_number, begun)) >= 0.9 * len(begun)


def _rows(lines: list[str], separator: str) -> list[list[str]]:
    """Return the cells of lines, without empty ones at their ends."""
    if separator:
        rows = list(csv.reader(lines, delimiter=separator, skipinitialspace=True))
    else:
        width = statistics.mode(len(re.split(BLANKS, line.strip())) for line in lines)
        rows = [_divided(line, width) for line in lines]
    stripped = [[cell.strip() for cell in row] for row in rows]
    return [row[: max((k for k, cell in enumerate(row, 1) if cell), default=0)] for row in stripped]


def _divided(line: str, width: int, sign: str = "") -> list[str]:
    """Return the cells of a line between signs, blanks or several blanks, as many as the table has if possible."""
    ways = [re.split(pattern, line.strip()) for pattern in (BLANKS, re.escape(sign or "\t"), r"\s{2,}|\s*[,;]\s*")]
    return next((cells for cells in ways if len(cells) == width), ways[0])


def _without_groups(cell: str) -> str:
    """Return a cell without signs that group digits, '' if it says that it is empty."""
    return "" if cell.lower() in EMPTY else GROUPS.sub("", cell)


def _is_number(cell: str) -> bool:
    """Return True for a number, and for a clock with or without a date."""
    bare = GROUPS.sub("", cell)
    return bool(NUMBER.fullmatch(bare) or CLOCK.fullmatch(bare))


def _is_data(row: Sequence[str]) -> bool:
    """Return True if at least half of the cells are numbers: labels may be among them."""
    return 2 * sum(map(_is_number, row)) >= max(1, sum(cell.lower() not in EMPTY for cell in row))


def _first_row(rows: list[list[str]]) -> int | None:
    """Return the index of the first row of numbers; one above words is no such row."""
    return next((k for k in range(len(rows)) if all(map(_is_data, rows[k : k + 2]))), None)


# --- heads and units -------------------------------------------------------------------------------


def heads(above: list[list[str]]) -> list[Column]:
    """Return columns without numbers yet, by the rows above these: titles, points, names and units."""
    if not above:
        return []
    *rows, names = above
    below: list[str] = []
    if rows and all(_is_unit(cell) for cell in names if cell):
        (*rows, names), below = rows, names
    points = [""] * len(names)
    for row in reversed(rows):
        words = [next(filter(None, row[k::-1]), "") for k in range(len(names))]
        # words above the times are a title, unless they tell equal heads apart
        if row[0] and (len(set(zip(points, names, strict=True))) == len(names) or len(set(words)) < 2):
            break
        points = [f"{word} {point}".strip() for word, point in zip(words, points, strict=True)]
    names, points = (  # a name in the row of points, over no name
        [name or point for name, point in zip(names, points, strict=True)],
        [point if name else "" for name, point in zip(names, points, strict=True)],
    )
    meanings = NAMES | ({"time": ""} if "seconds_elapsed" in names else {})  # of Sensor Logger
    return [
        _head(Column(k, f"{point} {name}".strip(), point), name, unit, meanings)
        for k, (name, point, unit) in enumerate(zip_longest(names, points, below[: len(names)], fillvalue=""), 1)
    ]


def _head(column: Column, name: str, below: str, meanings: dict[str, str]) -> Column:
    """Return a column with the meaning of its name; below: the unit in a row of its own; meanings: of words."""
    for pattern in HEADS:
        if found := re.fullmatch(pattern, name, re.IGNORECASE):
            parts, name = found.groupdict(), found["name"]
            column = replace(column, point=parts.get("point", column.point), group=parts.get("group", column.group))
    text, unit = units(name, below)
    words = re.findall(r"[^\W\d_]+|\d+", text)
    single = {meanings.get(word) for word in words}
    quantity = meanings.get(" ".join(words), single.pop() if len(single) == 1 else None)  # Winkel φ is an angle
    if quantity is not None:
        return replace(column, quantity=quantity, unit=unit)
    axis = "".join(word for word in words if word in "xyz")
    rest = " ".join(word for word in words if word not in "xyz")
    if (re.fullmatch("[gwω][xyz]", rest) and not unit.startswith("m")) or (len(axis) == 1 and re.search(ROTATION, rest)):
        return replace(column, quantity="omega", unit=unit)
    moves = re.search(NO_POSITION, rest) or "/" in unit or unit in OTHER_UNITS
    usual = "" if moves or len(axis) != 1 else axis
    return replace(column, point=f"{column.point} {rest}".strip(), quantity=usual, unit=unit)


def units(name: str, below: str = "") -> tuple[str, str]:
    """Return the words of a name in lower case, and its unit: in brackets, the last word, or behind a slash.

    below: the unit in a row of its own.
    """
    unit = _unit(below)
    found = re.fullmatch(r"(.*?)\s*(?:[\[(]([^\])]*)[\])]|\s/\s(\S+))(.*)", name)
    if found and _plain(found[2] or "") in ("x", "y", "z"):  # Gyroscope (z)
        name = f"{found[1]} {found[2]} {found[4]}"
    elif found:
        name, unit = f"{found[1]} {found[4]}", _unit(found[2] or found[3] or "")
    text = _plain(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)).replace("_", " ").strip(" /")
    for pattern in (r"(.*\w)\s*(?:,|\bin\b|\s)\s*(\S+)", r"(.*\w)/(\S+)"):
        last = re.fullmatch(pattern, text)
        if not unit and last and _unit(last[2]) in KNOWN_UNITS:
            text, unit = last[1].removesuffix(" in"), _unit(last[2])
    return text, unit


def _is_unit(cell: str) -> bool:
    return _unit(cell) in KNOWN_UNITS or re.fullmatch(r"[\[(].*[\])]", cell) is not None


def _unit(text: str) -> str:
    return _plain(text).strip("[]() .").replace(" per ", "/").replace("·", "").replace("μ", "u")


def unit_factor(text: str, kind: str) -> float | None:
    """Return the size of a unit, or of a number as one, in SI units and radians, negative behind a minus; None if unknown."""
    with suppress(ValueError):
        return float(text) or None
    size = UNITS.get(kind, {}).get(_unit(text.removeprefix("-")))
    return -size if size and text.startswith("-") else size


def _plain(text: str) -> str:
    """Return lower-case text without accents and special spaces."""
    letters = unicodedata.normalize("NFKD", text)
    return "".join(letter for letter in letters if not unicodedata.combining(letter)).lower()


# --- numbers ---------------------------------------------------------------------------------------


def columns(table: Table, name: str, rate: float | None) -> tuple[list[Column], list[str]]:
    """Return the columns of a table, and remarks on signs that group digits."""
    wide = max(map(len, table.body))
    named = heads(table.above) or [Column(k + 1) for k in range(wide)]
    if wide > len(named) and table.separator in ("", ","):
        raise InputError(
            f"{name} has a row of {wide} cells under {len(named)} names: a comma can divide cells or numbers, not both. "
            "Save it with semicolons."
        )
    named += [Column(k + 1) for k in range(len(named), wide)]  # such as a remark without a name
    decimal, notes = _decimal_sign(table, name)
    found = []
    for k, column in enumerate(named):
        cells = [row[k] if k < len(row) else "" for row in table.body]
        known = [cell for cell in cells if cell]
        if known and all(map(CLOCK.fullmatch, known)):
            numbers, counted = _clock(known, rate, name, column.label)
            column = replace(column, unit="s", quantity="frame" if counted else column.quantity)
        else:
            numbers = np.array([_number(cell, decimal) for cell in known])
        values = np.full(len(cells), np.nan)
        values[[cell != "" for cell in cells]] = numbers
        bad = next((row for row, cell in enumerate(cells) if cell and not np.isfinite(values[row])), None)
        has_numbers = bool(np.isfinite(values).any())
        if bad is not None and has_numbers:
            raise InputError(
                f"{name} has {cells[bad][:40]!r} in column {column.label}, row {bad + 1} below the names, "
                "which must be a number."
            )
        found.append(replace(column, values=values, words=() if has_numbers else cells))
    return found, notes


def _decimal_sign(table: Table, name: str) -> tuple[str, list[str]]:
    """Return the decimal sign of a table, ',.' if it has both or none, and a remark if the other one groups digits."""
    numbers = [(k, cell) for row in table.body for k, cell in enumerate(row) if NUMBER.fullmatch(cell)]
    marked = {sign: [(k, cell) for k, cell in numbers if sign in cell] for sign in GROUPED}
    grouped = {sign: [(k, cell) for k, cell in marked[sign] if re.fullmatch(GROUPED[sign], cell)] for sign in GROUPED}
    decimals = [sign for sign in GROUPED if len(grouped[sign]) < len(marked[sign])]
    signs = [sign for sign in GROUPED if grouped[sign] and decimals != [sign]]
    if not decimals and len(signs) == 1:
        within = {k for k, _ in grouped[signs[0]]}
        integers = any(k in within and signs[0] not in cell for k, cell in numbers)
        if integers == (signs == [","]):  # 985, 1,002 and 1,019; or 1.002 and 1.019 in all rows
            decimals, signs = ["."], signs if integers else []
        elif not integers and (table.separator == ";" or re.search(COMMA_WORDS, _plain(str(table.above)))):  # 1,002 in all rows
            decimals, signs = signs, []
    if not signs:
        return "".join(decimals) or ",.", []
    _, cell = grouped[signs[0]][0]
    if len(decimals) != 1:
        raise InputError(
            f"{name} has the number {cell}, which has two readings: save the table without signs that group digits."
        )
    return decimals[0], [f"{cell} is read as {_pointed(cell, decimals[0])}."]


def _pointed(cell: str, decimal: str) -> str:
    """Return a number with a decimal point, without signs that group digits."""
    other = {",": ".", ".": ","}.get(decimal, "")
    return (cell.replace(other, "") if other else cell).replace(",", ".")


def _number(cell: str, decimal: str) -> float:
    """Return the number of a cell, nan for words."""
    return float(_pointed(cell, decimal)) if NUMBER.fullmatch(cell) else float("nan")


def _clock(known: list[str], rate: float | None, name: str, label: str) -> tuple[Floats, bool]:
    """Return seconds of clocks, from the first row unless it is below an hour, or numbers of frames, and which these are."""
    parts = [found.groupdict() for cell in known if (found := CLOCK.fullmatch(cell))]
    hours, minutes, seconds, frames = (
        np.array([float((one[part] or "0").replace(",", ".")) for one in parts])
        for part in ("hours", "minutes", "seconds", "frames")
    )
    halves = np.array([(one["half"] or "").lower()[:1] for one in parts])
    values = HOUR * np.where(halves == "", hours, hours % 12 + 12 * (halves == "p")) + 60.0 * minutes + seconds
    values += DAY * np.cumsum(np.diff(values, prepend=values[0]) < -0.5 * DAY)
    counted = any(one["frames"] for one in parts)
    if counted:
        if rate is None or frames.max() >= round(rate):
            raise InputError(
                f"{name} counts frames in {label}: give the frames per second as taken, such as "
                f"--rate {30 if frames.max() < 30 else frames.max() + 1:.0f} (rate= in a Reading)."
            )
        values = values * round(rate) + frames
    elapsed = values[0] < HOUR and not counted and not any(one["date"] for one in parts)
    return values if elapsed else values - values[0], counted


# --- groups of columns, and rows of several objects ------------------------------------------------


def grouped(found: list[Column]) -> list[Column]:
    """Put columns behind times of their own into groups, unless their heads name runs."""
    times = [column for column in found if column.quantity == "t"]
    labels, points = {column.label for column in times}, {column.point for column in times}
    named = any(column.group for column in found)
    if named or len(times) < 2 or (len(labels) == len(times) and len(points) == 1):
        return found
    starts = [column.number for column in times]
    return [replace(column, group=str(sum(start <= column.number for start in starts) or "")) for column in found]


def apart(found: list[Column], comments: list[str]) -> list[Column]:
    """Give each object columns of its own, where a table has one row per object and time.

    comments: above each row, which may name the object.
    """
    key = next((column for quantity in ("t", "frame") for column in found if column.quantity == quantity), None)
    if key is None or len(set(key.values)) == len(key.values):
        return found
    times = np.unique(key.values)
    numbers = [column for column in found if column.quantity not in ("t", "frame") and not column.words]
    named = [list(map("{:g}".format, column.values)) for column in numbers if column.quantity == "object"]
    for labels in (comments, *(column.words for column in found if column.words), *named):
        kinds = list(dict.fromkeys(labels))
        if len(set(zip(key.values, labels, strict=True))) < len(labels) or not 1 < len(kinds) <= len(labels) / 3:
            continue
        split_up = [replace(key, values=times)]
        for kind in kinds:
            own = np.array(labels) == kind
            rows = np.searchsorted(times, key.values[own])
            for column in numbers:
                values = np.full(len(times), np.nan)
                values[rows] = column.values[own]
                point, head = f"{kind} {column.point}".strip(), f"{kind} {column.label}"
                split_up.append(replace(column, head=head, point=point, values=values))
        return split_up
    return found
