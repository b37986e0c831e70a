"""Tables as text: Tracker's export of one or several points, and plain CSV with named columns."""

from __future__ import annotations

import contextlib
import csv
import re
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError

Floats = NDArray[np.float64]

MOST_CELLS = 20_000_000
NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?")
ANGLES = {"angle", "theta", "θ", "θr", "thetar", "rotation"}
OMEGAS = {"omega", "ω", "angular_velocity"}


class Column(NamedTuple):
    """A column of a table."""

    point: str  # name of the point in Tracker; '' if there is only one
    name: str
    unit: str  # '' if it is not written
    values: Floats  # nan for empty cells


def read_columns(text: str, name: str) -> list[Column]:
    """Read a table with tab, semicolon or comma between cells, and point or comma in numbers.

    name: name of the file, for messages.
    """
    lines = [line for line in text.lstrip("\ufeff").splitlines() if line.strip()]
    while lines and lines[0].lstrip().startswith("#"):
        lines.pop(0)  # '#multi:' and comments
    if not lines:
        raise InputError(f"{name} is empty.")
    if len(lines) < 2:
        raise InputError(f"{name} has no table.")
    separator = _separator(lines)
    rows = [[cell.strip().strip('"').strip() for cell in _cells(line, separator)] for line in lines]
    first = next((k for k, row in enumerate(rows) if _is_data(row)), len(rows))
    if first == 0:
        raise InputError(f"{name} has no row of column names, such as t, x, y, angle (deg).")
    if first == len(rows):
        raise InputError(f"{name} has no row of numbers.")
    heads = rows[first - 1]
    while heads and not heads[-1]:
        heads.pop()  # a separator at the end of every line
    longest = max(rows[first:], key=lambda row: len(row) if row[-1] else 0)
    if longest[-1] and len(longest) > len(heads):
        raise InputError(
            f"{name} has a row of {len(longest)} cells under {len(heads)} names: a comma can divide cells or numbers, "
            "not both. Save it with semicolons."
        )
    if len(heads) * (len(rows) - first) > MOST_CELLS:
        raise InputError(f"{name} has {len(rows) - first:,} rows of {len(heads)} columns, more than a film has.")
    points = _points(rows[first - 2], len(heads)) if first >= 2 else [""] * len(heads)
    result = []
    for k, head in enumerate(heads):
        if head:
            word, unit = _split_head(head)
            cells = [row[k] if k < len(row) else "" for row in rows[first:]]
            result.append(Column(points[k], word, unit, _numbers(cells, name, head)))
    return result


def _separator(lines: list[str]) -> str:
    """Return the separator that divides most lines into equally many cells; a comma may be a decimal one."""
    sample = lines[: min(len(lines), 40)]
    for sign in ("\t", ";"):
        if sum(sign in line for line in sample) > 0.5 * len(sample):
            return sign
    return ","


def _cells(line: str, separator: str) -> list[str]:
    """Return the cells of a line; a separator between quotes divides nothing."""
    if '"' in line:
        with contextlib.suppress(csv.Error):
            return next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    return line.split(separator)


def _is_data(row: list[str]) -> bool:
    """Return True for a row of numbers; its last column may have words, such as a state."""
    filled = [cell for cell in row if cell]
    return bool(filled) and NUMBER.fullmatch(filled[0]) is not None


NOTHING = ("", "nan", "na", "n/a", "-", "null", "none")


def _numbers(cells: list[str], name: str, head: str) -> Floats:
    """Return a column; one of words, such as a state, is all nan."""
    fits = [NUMBER.fullmatch(cell) is not None for cell in cells]
    if any(fits):
        for k, (cell, fit) in enumerate(zip(cells, fits, strict=True)):
            if not fit and cell.lower() not in NOTHING:
                raise InputError(
                    f"{name} has {cell[:40]!r} in column {head}, row {k + 1} below the names, which must be a number."
                )
    return np.array([float(cell.replace(",", ".")) if fit else np.nan for cell, fit in zip(cells, fits, strict=True)])


def _points(row: list[str], count: int) -> list[str]:
    """Return the point of each column: its name is above its first column. Words above the times are a title."""
    if row and row[0]:
        return [""] * count
    result, now = [], ""
    for k in range(count):
        if k < len(row) and row[k]:
            now = row[k]
        result.append(now)
    return result


def _split_head(head: str) -> tuple[str, str]:
    """Split the head of a column into name and unit: 'x [m]', 'x (m)', 'x'."""
    found = re.fullmatch(r"(.*?)\s*[\[(]\s*([^\])]*)\s*[\])]", head)
    word, unit = (found[1], found[2]) if found else (head, "")
    word = word.strip().strip("$").replace("_{r}", "r").replace("{", "").replace("}", "").replace(" ", "_").lower()
    return word, unit.strip()


LENGTHS = {"": 1.0, "m": 1.0, "cm": 0.01, "mm": 0.001, "km": 1000.0, "in": 0.0254, "ft": 0.3048, "μm": 1e-6}
TIMES = {"": 1.0, "s": 1.0, "ms": 1e-3, "min": 60.0}


def in_metres(column: Column, name: str) -> Floats:
    """Values of a length [m]."""
    return _convert(column, LENGTHS, name)


def in_seconds(column: Column, name: str) -> Floats:
    """Values of a time [s]."""
    return _convert(column, TIMES, name)


def _convert(column: Column, units: dict[str, float], name: str) -> Floats:
    if column.unit not in units:
        known = ", ".join(unit for unit in units if unit)
        raise InputError(f"{name} gives {column.name} in {column.unit!r}; known units are {known}.")
    return column.values * units[column.unit]


def in_radians(column: Column, t: Floats, omega: Column | None, unit: str | None, name: str) -> Floats:
    """Values of an angle; without a unit, the column of the angular velocity determines it [rad].

    t: shape (n,), times [s]; omega: angular velocity, with a unit or in rad/s [rad/s]; unit: given unit; name: of the file;
    angle: shape (n,), without jumps of 2π [rad].
    """
    said = unit or column.unit.replace("°", "deg").replace("degrees", "deg").replace("radians", "rad")
    if said not in ("", "rad", "deg"):
        raise InputError(f"{name} gives {column.name} in {column.unit!r}; known units are rad and deg.")
    if not said:
        said = _guess_unit(column.values, t, omega)
    if not said:
        raise InputError(
            f"{name} has no unit of {column.name}: name it {column.name} (deg) or {column.name} (rad), or give the unit: "
            "--angle-unit deg, or angle_unit='deg' in a Reading."
        )
    turn = 2 * np.pi if said == "rad" else 360.0
    values = column.values.copy()
    there = np.flatnonzero(np.isfinite(values))
    values[there] = np.unwrap(values[there], period=turn)
    return values * (2 * np.pi / turn)


def _guess_unit(values: Floats, t: Floats, omega: Column | None) -> str:
    if omega is None or "deg" in omega.unit or "°" in omega.unit:
        return ""
    steps = np.diff(values)
    steps = np.where(np.abs(steps) < 0.5 * np.nanmax(np.abs(values)) + 1e-12, steps, np.nan)  # without jumps of 2π
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = steps / np.diff(t) / (0.5 * (omega.values[1:] + omega.values[:-1]))
    usual = float(np.nanmedian(np.abs(ratio))) if np.isfinite(ratio).any() else np.nan
    if abs(np.log(usual)) < 0.3:
        return "rad"
    return "deg" if abs(np.log(usual / np.degrees(1.0))) < 0.3 else ""
