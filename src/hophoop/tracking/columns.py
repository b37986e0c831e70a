"""From the text of a table to columns of numbers: its separator, cells, heads, units and numbers, as people write them."""

from __future__ import annotations

import csv
import re
import statistics
import unicodedata
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.dialects import COMMA_WORDS, DIALECTS, KNOWN_UNITS, NAMES, NO_POSITION, PIXELS, ROTATION, UNITS, Dialect

Floats = NDArray[np.float64]

EMPTY = {"", "-", "–", "none", "nan", "na", "n/a", "null", "#n/a", "#nv", "#wert!", "#value!", "#div/0!"}
COMMENT = re.compile(r"\s*(?:#(?!N/A|NV\b|[A-Z/0]+!)|%|//)\s*(.*)")
SIGNS = {0x2212: "-", 0xFF0D: "-", 0xFF0E: ".", 0xFF0C: ",", 0x66B: "."}  # of typesetters, full width, Arabic
NUMBER = r"[-+]?(?:\d+(?:[.,]\d{3})*[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?"
GROUPED = {",": r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?", ".": r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?"}
CLOCK = (
    r"(?:(?P<date>\d{1,4}[-./]\d{1,2}[-./]\d{1,4})[T,\s]+)?"
    r"(?:(?P<hours>\d+):)?(?P<minutes>\d+):(?P<seconds>\d+(?:[.,]\d+)?)(?:[:;](?P<frames>\d+))?"
    r"\s*(?P<half>[APap]\.?[Mm]\.?)?\s*(?:Z|UTC|[-+]\d\d:?\d\d)?"
)
CELL = re.compile(rf"{NUMBER}|{CLOCK}")
BLANKS = r"\s+(?![\[(])"  # not before a unit
GROUPS = r"(?<=\d)[\s'’](?=\d{3}(?:\D|$))"  # signs that group digits and are no separators
HOUR, DAY = 3600.0, 86400.0
MOST_SNIFFED = 200  # lines


class Layout(NamedTuple):
    """Lines of a text, each with the comment above it, and the sign between their cells; '' for blanks."""

    separator: str
    lines: list[tuple[str, str]]


class Table(NamedTuple):
    """Cells of a table."""

    above: list[list[str]]  # rows above the numbers
    body: Any  # pandas.DataFrame of text, the rows of numbers
    comments: list[str]  # above each of these rows
    below: str  # text below the numbers
    separator: str


class Head(NamedTuple):
    """Name of a column, and its meaning."""

    label: str  # as the file spells it, after the words above it that tell it apart
    point: str = ""
    quantity: str = ""  # a name of COLUMNS, 'frame', 'polar', 'object' or ''; x, y and z for positions
    unit: str = ""
    run: str = ""


@dataclass(frozen=True, eq=False)
class Column:
    """A column of a table."""

    number: int  # from 1
    head: Head
    values: Floats  # nan for empty cells and words
    words: Sequence[str] = ()  # of a column without numbers
    group: str = ""  # of columns with times of their own

    @property
    def label(self) -> str:
        """Its head as the file spells it, or its number."""
        return self.head.label or f"column {self.number}"


def read_columns(text: str, name: str, rate: float | None = None) -> tuple[list[Column], list[str]]:
    """Read a table: its columns, and remarks on how it was understood.

    name: of the file, for messages; rate: frames per second, for clocks that count frames.
    """
    table = split(sniff(text), name)
    found, notes = columns(table, heads(table.above), name, rate)
    if table.below:
        notes.append(f"Lines below the table are not read: {table.below}")
    return apart(grouped(found), table.comments), notes


# --- lines and cells -------------------------------------------------------------------------------


def sniff(text: str) -> Layout:
    """Find the comments and the separator of a text."""
    digits = {ord(sign): str(unicodedata.decimal(sign)) for sign in set(text) if sign.isdecimal()}
    lines, comment = [], ""
    for line in text.translate(digits | SIGNS).splitlines():
        if found := COMMENT.match(line):
            comment = found[1].strip()
            lines.append((comment, ""))
        elif line.strip(" \t;,"):
            lines.append((comment, line))
    rows = [line for _, line in lines if line][:MOST_SNIFFED]
    return Layout(next((sign for sign in "\t;," if _divides(sign, rows)), ""), lines)


def _divides(sign: str, lines: list[str]) -> bool:
    """Return True if a sign divides the numbers, and the heads above them."""
    rows = list(csv.reader(lines, delimiter=sign, skipinitialspace=True))
    first = _first_row(rows)
    if first is None or min(map(len, rows[max(first - 1, 0) : first + 1])) < 2:
        return False
    begun = [cell for row in rows[first:] for cell in row if re.match(r"\s*[-+]?[.,]?\d", cell)]
    return sum(map(_is_number, begun)) >= 0.9 * len(begun)


def _is_number(cell: str) -> bool:
    """Return True for a number, and for a clock with or without a date."""
    return CELL.fullmatch(re.sub(GROUPS, "", cell.strip())) is not None


def _is_data(row: Sequence[str]) -> bool:
    """Return True if at least half of the cells are numbers: labels may be among them."""
    return 2 * sum(map(_is_number, row)) >= max(1, sum(1 for cell in row if cell.strip().lower() not in EMPTY))


def _first_row(rows: list[list[str]]) -> int | None:
    """Return the index of the first row of numbers; one above words is no such row."""
    return next((k for k in range(len(rows)) if all(map(_is_data, rows[k : k + 2]))), None)


def split(layout: Layout, name: str) -> Table:
    """Split lines into cells, and the rows of numbers from those above and below; name: of the file, for messages."""
    pandas, lines = need("pandas", "fit"), [one for one in layout.lines if one[1]]
    if not lines:
        raise InputError(f"{name} is empty.")
    if layout.separator:
        rows = list(csv.reader([line for _, line in lines], delimiter=layout.separator, skipinitialspace=True))
        lines = lines[len(lines) - len(rows) :]  # a cell with a line break makes one row of two lines
    else:
        width = statistics.mode(len(re.split(BLANKS, line.strip())) for _, line in lines)
        rows = [_divided(line, width) for _, line in lines]
    first = _first_row(rows)
    if first is None:
        raise InputError(f"{name} has no {'table' if len(rows) < 2 else 'row of numbers'}.")
    last = max(k for k, row in enumerate(rows) if _is_data(row)) + 1
    body = pandas.DataFrame(dict(enumerate(zip_longest(*rows[first:last], fillvalue=""))), dtype=object).apply(_stripped)
    width = 1 + max(k for k in body if body[k].notna().any())
    short = [len(row) < width for row in rows[first:last]]
    if not layout.separator and any(short):
        raise InputError(
            f"{name} has a cell too few in row {short.index(True) + 1} of the numbers, and blanks do not show which one is "
            "empty: save the table with semicolons."
        )
    above = [[cell.strip() for cell in row] for row in rows[:first]]
    if width > 1 and not any(sum(map(bool, row)) > 1 for row in above):  # comments are heads where they are the only ones
        comments = [comment for comment, _ in layout.lines[: layout.lines.index(lines[first])]]
        above = [cells for comment in comments if len(cells := _divided(comment, width, layout.separator)) == width][-1:]
    comments = [comment for comment, _ in lines[first:last]]
    return Table(above, body[range(width)], comments, " ".join(cell for row in rows[last:] for cell in row), layout.separator)


def _stripped(cells: Any) -> Any:
    """Return the cells of a column without blanks and signs that group digits, nan for empty ones."""
    cells = cells.str.strip().str.replace(GROUPS, "", regex=True)
    return cells.mask(cells.str.lower().isin(EMPTY))


def _divided(line: str, width: int, sign: str = "") -> list[str]:
    """Return the cells of a line between signs, blanks or several blanks, as many as the table has if possible."""
    ways = [re.split(pattern, line.strip()) for pattern in (BLANKS, re.escape(sign or "\t"), r"\s{2,}|\s*[,;]\s*")]
    return next((cells for cells in ways if len(cells) == width), ways[0])


# --- heads and units -------------------------------------------------------------------------------


def heads(above: list[list[str]]) -> list[Head]:
    """Return the names of columns from the rows above the numbers: titles, points, names and units."""
    if not above:
        return []
    *rows, names = above
    below: list[str] = []
    if rows and all(_is_unit(cell) for cell in names if cell):
        (*rows, names), below = rows, names
    names = names[: 1 + max((k for k, name in enumerate(names) if name), default=0)]  # no separator at the end of a line
    points = [""] * len(names)
    for row in reversed(rows):
        words = [next(filter(None, row[k::-1]), "") for k in range(len(names))]
        # words above the times are a title, unless they tell equal heads apart
        if row[0] and (len(set(zip(points, names, strict=True))) == len(names) or len(set(words)) < 2):
            break
        points = [f"{word} {point}".strip() for word, point in zip(words, points, strict=True)]
    spoken = [one for one in DIALECTS if re.search(one.known, "\n".join(names), re.IGNORECASE | re.MULTILINE)]
    return [_head(*one, spoken) for one in zip_longest(names, points, below[: len(names)], fillvalue="")]


def _head(name: str, point: str, below: str, spoken: Sequence[Dialect]) -> Head:
    """Return the meaning of a name; below: the unit in a row of its own; spoken: dialects of the table."""
    label, run, names = f"{point} {name}".strip(), "", dict(NAMES)
    for one in spoken:
        names |= dict(pair.split("=") for pair in one.names.split())
        if found := re.fullmatch(one.head, name, re.IGNORECASE):
            parts = found.groupdict()
            name, point, run = parts["name"], parts.get("point", point), parts.get("run", run)
    text, unit = units(name, below)
    words = re.findall(r"[^\W\d_]+|\d+", text)
    single = {names.get(word) for word in words}
    quantity = names.get(" ".join(words), single.pop() if len(single) == 1 else None)  # Winkel φ is an angle
    if quantity is not None:
        return Head(label, point, quantity, unit, run)
    axis = "".join(word for word in words if word in "xyz")
    rest = " ".join(word for word in words if word not in "xyz")
    if re.fullmatch("[wω][xyz]", rest) or (len(axis) == 1 and re.search(ROTATION, rest)):
        return Head(label, point, "omega", unit, run)
    moves = re.search(NO_POSITION, rest) or "/" in unit or unit in KNOWN_UNITS - UNITS["m"].keys() - {*PIXELS}
    usual = "" if moves or len(axis) != 1 else axis
    return Head(label, f"{point} {rest}".strip(), names.get(rest, usual) if axis else "", unit, run)


def units(name: str, below: str = "") -> tuple[str, str]:
    """Return the words of a name in lower case, and its unit: in brackets, behind a slash, or the last word.

    below: the unit in a row of its own.
    """
    unit = _unit(below)
    found = re.fullmatch(r"(.*?)\s*(?:[\[(]([^\])]*)[\])]|\s/\s(\S+))(.*)", name)
    if found and _plain(found[2] or "") in ("x", "y", "z"):  # Gyroscope (z)
        name = f"{found[1]} {found[2]} {found[4]}"
    elif found:
        name, unit = f"{found[1]} {found[4]}", _unit(found[2] or found[3] or "")
    text = _plain(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)).replace("_", " ").strip()
    last = re.fullmatch(r"(.*\w)\s*(?:,|\bin\b|\s)\s*(\S+)", text)
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


def columns(table: Table, names: list[Head], name: str, rate: float | None) -> tuple[list[Column], list[str]]:
    """Return the columns of a table under their names, and remarks on signs that group digits."""
    wide = len(table.body.columns)
    if names and wide > len(names):
        raise InputError(
            f"{name} has a row of {wide} cells under {len(names)} names: a comma can divide cells or numbers, not both. "
            "Save it with semicolons."
        )
    decimal, notes = _decimal_sign(table, name)
    result, names = [], names or [Head("")] * wide
    body = table.body.reindex(columns=range(len(names))).astype(object)
    for k, head in enumerate(names):
        cells = body[k]
        known, label = cells.dropna(), head.label or f"column {k + 1}"
        if len(known) and known.str.fullmatch(CLOCK).all():
            numbers, counted = _clock(known, rate, name, label)
            head = head._replace(unit="s", quantity="frame" if counted else head.quantity)
        else:
            numbers = _numbers(known, decimal, name, label)
        words = list(cells.fillna("")) if numbers.isna().any() else []
        result.append(Column(k + 1, head, numbers.reindex(cells.index).to_numpy(dtype=float), words))
    return result, notes


def _decimal_sign(table: Table, name: str) -> tuple[str, list[str]]:
    """Return the decimal sign of a table, ',.' if it has both or none, and a remark if the other one groups digits."""
    cells = table.body.stack().dropna()
    cells = cells[cells.str.fullmatch(NUMBER)]
    marked = {sign: cells[cells.str.contains(sign, regex=False)] for sign in GROUPED}
    grouped = {sign: found[found.str.fullmatch(GROUPED[sign])] for sign, found in marked.items()}
    signs = [sign for sign in GROUPED if len(grouped[sign])]
    decimals = [sign for sign in GROUPED if len(grouped[sign]) < len(marked[sign])]
    if len(decimals) == 1:
        signs = [sign for sign in signs if sign not in decimals]
    elif not decimals and len(signs) == 1:
        within = grouped[signs[0]].index.get_level_values(1)
        integers = cells.index.get_level_values(1).isin(within).sum() > len(within)
        if integers == (signs == [","]):  # 985, 1,002 and 1,019; or 1.002 and 1.019 in all rows
            decimals, signs = ["."], signs if integers else []
        elif not integers and (table.separator == ";" or re.search(COMMA_WORDS, _plain(str(table.above)))):  # 1,002 in all rows
            decimals, signs = signs, []
    if signs and len(decimals) != 1:
        raise InputError(
            f"{name} has the number {grouped[signs[0]].iloc[0]}, which has two readings: "
            "save the table without signs that group digits."
        )
    if not signs:
        return "".join(decimals) or ",.", []
    cell = grouped[signs[0]].iloc[0]
    return decimals[0], [f"{cell} is read as {_one_number(cell, decimals[0])}."]


def _one_number(cell: str, decimal: str) -> str:
    other = {",": ".", ".": ","}.get(decimal, "")
    return (cell.replace(other, "") if other else cell).replace(",", ".")


def _numbers(known: Any, decimal: str, name: str, label: str) -> Any:
    """Return the numbers of a column's cells, all nan for words such as a state."""
    values = need("pandas", "fit").to_numeric(known.map(lambda cell: _one_number(cell, decimal)), errors="coerce")
    bad = values.isna() | np.isinf(values)
    if bad.any() and not bad.all():
        raise InputError(
            f"{name} has {known[bad.idxmax()][:40]!r} in column {label}, row {bad.idxmax() + 1} below the names, "
            "which must be a number."
        )
    return values


def _clock(known: Any, rate: float | None, name: str, label: str) -> tuple[Any, bool]:
    """Return seconds of clocks, from the first row unless it is below an hour, or numbers of frames, and which these are."""
    parts = known.str.extract(CLOCK)
    half = parts["half"].str.lower().str[0]
    hours, minutes, seconds, frames = (
        parts[part].str.replace(",", ".").astype(float).fillna(0.0) for part in ("hours", "minutes", "seconds", "frames")
    )
    hours = hours.where(half.isna(), hours % 12 + 12 * (half == "p"))
    values = HOUR * hours + 60.0 * minutes + seconds
    values += DAY * (values.diff() < -0.5 * DAY).cumsum()
    counted = bool(parts["frames"].notna().any())
    if counted:
        if rate is None or frames.max() >= round(rate):
            raise InputError(
                f"{name} counts frames in {label}: give the frames per second as taken, such as "
                f"--rate {30 if frames.max() < 30 else frames.max() + 1:.0f} (rate= in a Reading)."
            )
        values = values * round(rate) + frames
    elapsed = values.iloc[0] < HOUR and parts["date"].isna().all() and not counted
    return values if elapsed else values - values.iloc[0], counted


# --- groups of columns, and rows of several objects ------------------------------------------------


def grouped(found: list[Column]) -> list[Column]:
    """Put columns into groups: runs that their heads name, or columns behind times of their own."""
    if any(column.head.run for column in found):
        return [replace(column, group=column.head.run) for column in found]
    times = [column for column in found if column.head.quantity == "t"]
    labels, points = {column.label for column in times}, {column.head.point for column in times}
    if len(times) < 2 or (len(labels) == len(times) and len(points) == 1):
        return found
    starts = [column.number for column in times]
    return [replace(column, group=str(sum(start <= column.number for start in starts) or "")) for column in found]


def apart(found: list[Column], comments: list[str]) -> list[Column]:
    """Give each object columns of its own, where a table has one row per object and time.

    comments: above each row, which may name the object.
    """
    keys = [column for quantity in ("t", "frame") for column in found if column.head.quantity == quantity]
    if not keys or len(set(keys[0].values)) == len(keys[0].values):
        return found
    key, pandas = keys[0], need("pandas", "fit")
    numbers = [column for column in found if column not in keys and not column.words]
    named = [list(map("{:g}".format, column.values)) for column in numbers if column.head.quantity == "object"]
    for labels in (comments, *(column.words for column in found if column.words), *named):
        rows = pandas.MultiIndex.from_arrays([key.values, labels])
        kinds = list(dict.fromkeys(labels))
        if rows.is_unique and 1 < len(kinds) <= len(labels) / 3:
            wide = pandas.DataFrame({column.number: column.values for column in numbers}, index=rows).unstack()
            split_up = [replace(key, values=wide.index.to_numpy())]
            for kind in kinds:
                for column in numbers:
                    point = f"{kind} {column.head.point}".strip()
                    head = column.head._replace(label=f"{kind} {column.label}", point=point)
                    split_up.append(replace(column, head=head, values=wide[column.number, kind].to_numpy()))
            return split_up
    return found
