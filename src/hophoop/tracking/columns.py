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
from hophoop.tracking.scatter import Floats

EMPTY = {"", "-", "–", "none", "nan", "na", "n/a", "null", "#n/a", "#nv", "#wert!", "#value!", "#div/0!"}
COMMENT = re.compile(r"\s*(?:#(?!N/A|NV\b|[A-Z/0]+!)|%|//)\s*(.*)")
SIGNS = {0x2212: "-", 0xFF0D: "-", 0xFF0E: ".", 0xFF0C: ",", 0x66B: "."}  # of typesetters, full width, Arabic
NUMBER = re.compile(r"[-+]?(?:\d+(?:[.,]\d{3})*[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?")
GROUPED = {",": r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?", ".": r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?"}
CLOCK = re.compile(
    r"(?:(?P<date>\d{1,4}[-./](?:\d{1,2}|[A-Za-z]{3})[-./]\d{1,4})[T,\s]+)?"
    r"(?:(?P<hours>\d+):)?(?P<minutes>\d+):(?P<seconds>\d+(?:[.,]\d+)?)(?:[:;](?P<frames>\d+))?"
    r"\s*(?:(?P<half>[APap])\.?[Mm]\.?)?\s*(?:Z|UTC|[-+]\d\d:?\d\d)?"
)
BLANKS = r"\s+(?![\[(])"  # not before a unit
GROUPS = re.compile(r"(?<=\d)[\s'’](?=\d{3}(?:\D|$))")  # signs that group digits and are no separators
HOUR, DAY = 3600.0, 86400.0
MOST_SNIFFED = 200  # lines


class TableError(ValueError):
    """Why a table is not read: what its file 'has' or 'is', a full sentence behind the file's name."""


def several_runs(row: int, place: str) -> TableError:
    """Return the error of two runs in one table; row: of the numbers, with which the second starts, from 1; place: its sign."""
    return TableError(
        f"seems to have two runs, one below the other: the second starts with row {row} of the numbers, {place}. Save each run "
        "in a file of its own, and give both, as in hophoop fit a.csv b.csv."
    )


class Table(NamedTuple):
    """Cells of a table."""

    above: list[list[str]]  # rows above the numbers
    body: list[list[str]]  # rows of numbers, '' for empty cells, without those at their ends
    comments: list[str]  # above each of these rows
    separator: str  # between cells; '' for blanks
    notes: list[str]  # remarks on how it was understood


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
    words: Sequence[str] = ()  # of a column without numbers, or that numbers objects

    @property
    def label(self) -> str:
        """Its head as the file spells it, or its number."""
        return self.head or f"column {self.number}"


def read_columns(text: str, rate: float | None = None) -> tuple[list[Column], list[str]]:
    """Read a table: its columns, and remarks on it; rate: frames per second, for clocks that count frames."""
    table = split(text)
    return apart(grouped(columns(table, rate)), table.comments), table.notes


# --- lines and cells -------------------------------------------------------------------------------


def split(text: str) -> Table:
    """Split a text into cells, and the rows of numbers from those above and below."""
    digits = {ord(sign): str(unicodedata.decimal(sign)) for sign in set(text) if sign.isdecimal()}
    said, counts, lines = [""], [], []  # comments, and lines with the number of comments above each
    for line in text.translate(digits | SIGNS).splitlines():
        if found := COMMENT.match(line):
            said.append(found[1].strip())
        elif line.strip(" \t;,"):
            lines.append(line)
            counts.append(len(said))
    if not lines:
        raise TableError("is empty.")
    separator = next((sign for sign in "\t;," if _divides(sign, lines[:MOST_SNIFFED])), "")
    rows = _rows(lines, separator)
    counts = counts[-len(rows) :]  # a cell with a line break makes one row of two lines
    first = _first_row(rows)
    if first is None:
        raise TableError(f"has no {'table' if len(rows) < 2 else 'row of numbers'}.")
    last = max(k for k, row in enumerate(rows, 1) if _is_data(row))
    above, body = rows[:first], [["" if cell.lower() in EMPTY else cell for cell in row] for row in rows[first:last]]
    for k, row in enumerate(body, 1):  # a title, or the names again
        if any(row[:1]) and not any(map(_is_number, row)) and _is_number(body[0][0]):
            raise several_runs(k, f"below the line {separator.join(row)!r}")
    width = max(map(len, body))
    short = next((k for k, row in enumerate(body, 1) if len(row) < width), None)
    if short and not separator:
        raise TableError(
            f"has a cell too few in row {short} of the numbers, and blanks do not show which one is empty: "
            "save the table with semicolons."
        )
    if width > 1 and max(map(len, above), default=0) < 2:  # comments are heads where they are the only ones
        heads_in_comments = (_divided(comment, width, separator or "\t") for comment in said[1 : counts[first]])
        above = [cells for cells in heads_in_comments if len(cells) == width][-1:]
    comments = [said[count - 1] for count in counts[first:last]]
    below = " ".join(map(" ".join, rows[last:]))
    return Table(above, body, comments, separator, [f"Lines below the table are not read: {below}"] if below else [])


def _divides(sign: str, lines: list[str]) -> bool:
    """Return True if a sign divides the numbers, and the heads above them."""
    rows = _rows(lines, sign)
    first = _first_row(rows)
    if first is None or min(map(len, rows[max(first - 1, 0) : first + 1])) < 2:
        return False
    begun = [cell for row in rows[first:] for cell in row if re.match(r"[-+]?[.,]?\d", cell)]
    return sum(map(_is_number, begun)) >= 0.9 * len(begun)


def _rows(lines: list[str], separator: str) -> list[list[str]]:
    """Return the cells of lines without signs that group digits, and without empty cells at their ends."""
    if separator:
        rows = list(csv.reader(lines, delimiter=separator, skipinitialspace=True))
    else:
        width = statistics.mode(len(re.split(BLANKS, line.strip())) for line in lines)
        rows = [_divided(line, width) for line in lines]
    for row in rows:
        while row and not row[-1].strip():
            row.pop()
    return [[GROUPS.sub("", cell.strip()) for cell in row] for row in rows]


def _divided(line: str, width: int, sign: str = "\t") -> list[str]:
    """Return the cells of a line between signs, blanks or several blanks, as many as the table has if possible."""
    ways = [re.split(pattern, line.strip()) for pattern in (BLANKS, re.escape(sign), r"\s{2,}|\s*[,;]\s*")]
    return next((cells for cells in ways if len(cells) == width), ways[0])


def _is_number(cell: str) -> bool:
    """Return True for a number, and for a clock with or without a date."""
    return bool(NUMBER.fullmatch(cell) or CLOCK.fullmatch(cell))


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
        # words above the times are a title, unless they tell equal heads apart or are above units
        alike = len(set(zip(points, names, strict=True))) < len(names) or any(map(_is_unit, names))
        if row[0] and (not alike or len(set(words)) < 2):
            break
        points = [f"{word} {point}".strip() for word, point in zip(words, points, strict=True)]
    found = [_head(k, *cells) for k, cells in enumerate(zip_longest(names, points, below[: len(names)], fillvalue=""), 1)]
    clock = "time" if "seconds_elapsed" in names else ""  # of Sensor Logger, which writes both
    return [replace(column, quantity="") if column.head == clock else column for column in found]


def _head(number: int, name: str, point: str, below: str) -> Column:
    """Return a column with the meaning of its name; below: the unit in a row of its own."""
    head, group = f"{point} {name}".strip(), ""
    if not name or _is_unit(name):  # it is in the row of points
        name, point = head, ""
    for pattern in HEADS:
        if found := re.fullmatch(pattern, name, re.IGNORECASE):
            parts = found.groupdict()
            name, point, group = parts["name"], parts.get("point", point), parts.get("group", group)
    text, unit = units(name, below)
    words = re.findall(r"[gwω](?=[xyz]\b)|[^\W\d_]+|\d+", text)  # gx is an axis of a gyroscope
    axis = "".join(word for word in words if word in "xyz")
    rest = " ".join(word for word in words if word not in "xyz")
    said = " ".join(words)
    quantity = next((name for name, known in NAMES.items() if re.fullmatch(rf"((^| )({known}))+", said)), "")  # Winkel φ
    if not quantity:
        moves = re.search(NO_POSITION, rest) or "/" in unit or unit in OTHER_UNITS
        if len(axis) == 1 and re.search(ROTATION, rest) and not unit.startswith("m"):
            quantity = "omega"
        else:
            point, quantity = f"{point} {rest}".strip(), "" if moves or len(axis) != 1 else axis
    return Column(number, head, point, quantity, unit, group)


def units(name: str, below: str = "") -> tuple[str, str]:
    """Return the words of a name in lower case, and its unit: in brackets, the last word, or behind a slash.

    below: the unit in a row of its own.
    """
    unit, name = _unit(below), re.sub(r"[\[(]([XYZxyz])[\])]", r" \1 ", name)  # Gyroscope (z)
    found = re.fullmatch(r"(.*?)\s*(?:[\[(]([^\])]*)[\])]|\s/\s(\S+))(.*)", name)
    if found:
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
    return "".join(sign for sign in unicodedata.normalize("NFKD", text) if not unicodedata.combining(sign)).lower()


# --- numbers ---------------------------------------------------------------------------------------


def columns(table: Table, rate: float | None) -> list[Column]:
    """Return the columns of a table."""
    wide = max(map(len, table.body))
    named = heads(table.above)
    if 0 < len(named) < wide and table.separator in ("", ","):
        raise TableError(
            f"has a row of {wide} cells under {len(named)} names: a comma can divide cells or numbers, not both. "
            "Save it with semicolons."
        )
    named += [Column(k + 1) for k in range(len(named), wide)]  # such as a remark without a name
    decimal = _decimal_sign(table)
    found = []
    missing = [[""] * len(table.body)] * (len(named) - wide)
    for column, cells in zip(named, [*zip_longest(*table.body, fillvalue=""), *missing], strict=True):
        known = [cell for cell in cells if cell]
        if known and all(map(CLOCK.fullmatch, known)):
            numbers, counted = _clock(known, rate, column.label)
            column = replace(column, unit="s", quantity="frame" if counted else column.quantity)
        else:
            numbers = np.array([float(_pointed(cell, decimal)) if NUMBER.fullmatch(cell) else np.nan for cell in known])
        values, there = np.full(len(cells), np.nan), np.array([cell != "" for cell in cells])
        values[there] = numbers
        bad, has_numbers = np.flatnonzero(there & ~np.isfinite(values)), bool(np.isfinite(values).any())
        if len(bad) and has_numbers:
            row = bad[0]
            said = f"has {cells[row][:40]!r} in column {column.label}, row {row + 1} below the names"
            raise TableError(f"{said}, which must be a number.")
        words = list(map("{:g}".format, values)) if column.quantity == "object" else ()
        found.append(replace(column, values=values, words=words if has_numbers else cells))
    return found


def _decimal_sign(table: Table) -> str:
    """Return the decimal sign of a table, ',.' if it has both or none; remark on another one that groups digits."""
    numbers = [(k, cell) for row in table.body for k, cell in enumerate(row) if NUMBER.fullmatch(cell)]
    grouped = {sign: [(k, cell) for k, cell in numbers if re.fullmatch(GROUPED[sign], cell)] for sign in GROUPED}
    decimals = [sign for sign in GROUPED if len(grouped[sign]) < sum(sign in cell for _, cell in numbers)]
    signs = [sign for sign in GROUPED if grouped[sign] and decimals != [sign]]
    if not decimals and len(signs) == 1:
        sign = signs[0]
        within = {k for k, _ in grouped[sign]}
        if any(k in within and sign not in cell for k, cell in numbers):  # 985, 1,002 and 1,019
            decimals = ["."] if sign == "," else []
        elif sign == "." or table.separator == ";" or re.search(COMMA_WORDS, _plain(str(table.above))):  # 1.002 in all rows
            decimals, signs = signs, []
    decimal = "".join(decimals) or ",."
    if signs:
        _, cell = grouped[signs[0]][0]
        if len(decimal) > 1:
            raise TableError(f"has the number {cell}, which has two readings: save the table without signs that group digits.")
        table.notes.insert(0, f"{cell} is read as {_pointed(cell, decimal)}.")
    return decimal


def _pointed(cell: str, decimal: str) -> str:
    """Return a number with a decimal point, without signs that group digits."""
    return "".join(sign for sign in cell if sign in decimal or sign not in ",.").replace(",", ".")


def _clock(known: list[str], rate: float | None, label: str) -> tuple[Floats, bool]:
    """Return seconds of clocks, from the first row unless it is below an hour, or numbers of frames, and which these are."""
    clocks = [found for cell in known if (found := CLOCK.fullmatch(cell))]
    values, frames = np.array([(_seconds(one), float(one["frames"] or 0)) for one in clocks]).T
    values = values + DAY * np.cumsum(np.diff(values, prepend=values[0]) < -0.5 * DAY)
    counted = any(one["frames"] for one in clocks)
    if counted:
        if rate is None or frames.max() >= round(rate):
            raise TableError(
                f"counts frames in {label}: give the frames per second as taken, such as "
                f"--rate {30 if frames.max() < 30 else frames.max() + 1:.0f} (rate= in a Reading)."
            )
        values = values * round(rate) + frames
    elapsed = values[0] < HOUR and not counted and not any(one["date"] for one in clocks)
    return values if elapsed else values - values[0], counted


def _seconds(clock: re.Match[str]) -> float:
    """Seconds of a clock from midnight, without its frames."""
    hours, minutes, seconds = (float((clock[part] or "0").replace(",", ".")) for part in ("hours", "minutes", "seconds"))
    if clock["half"]:
        hours = hours % 12 + 12 * (clock["half"] in "pP")
    return HOUR * hours + 60.0 * minutes + seconds


# --- groups of columns, and rows of several objects ------------------------------------------------


def grouped(found: list[Column]) -> list[Column]:
    """Put columns behind times of their own into groups, unless their heads name runs."""
    times = [column for column in found if column.quantity == "t"]
    alike = len({column.label for column in times}) < len(times) or len({column.point for column in times}) > 1
    if not alike or any(column.group for column in found):
        return found
    return [replace(one, group=str(sum(time.number <= one.number for time in times) or "")) for one in found]


def apart(found: list[Column], comments: list[str]) -> list[Column]:
    """Give each object columns of its own, where a table has one row per object and time.

    comments: above each row, which may name the object.
    """
    key = next((column for quantity in ("t", "frame") for column in found if column.quantity == quantity), None)
    if key is None:
        return found
    times, rows = np.unique(key.values, return_inverse=True)
    numbers = [column for column in found if column.quantity not in ("t", "frame") and not column.words]
    for labels in (comments, *(column.words for column in found if column.words)):
        kinds = list(dict.fromkeys(labels))
        whole = len(times) < len(rows) == len(set(zip(rows, labels, strict=True)))
        if not whole or not 1 < len(kinds) <= len(rows) / 3:
            continue
        split_up = [replace(key, values=times)]
        for kind in kinds:
            own = np.array(labels) == kind
            for column in numbers:
                values = np.full(len(times), np.nan)
                values[rows[own]] = column.values[own]
                point, head = f"{kind} {column.point}".strip(), f"{kind} {column.label}"
                split_up.append(replace(column, head=head, point=point, values=values))
        return split_up
    return found
