"""Tables of any program as columns: heads, units and numbers as people write them."""

from __future__ import annotations

import io
import re
import unicodedata
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.table import COLUMNS

Floats = NDArray[np.float64]

LENGTHS = {
    **dict.fromkeys(("", "m", "meter", "meters", "metre", "metres", "metro", "metros"), 1.0),
    **dict.fromkeys(("cm", "centimeter", "centimeters", "centimetre", "centimetres", "zentimeter"), 0.01),
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 0.001),
    "km": 1000.0, "in": 0.0254, "inch": 0.0254, "ft": 0.3048, "μm": 1e-6,
}  # fmt: skip
TIMES = {
    **dict.fromkeys(("", "s", "sec", "secs", "sek", "second", "seconds", "sekunden", "secondes", "segundos"), 1.0),
    "ms": 1e-3, "msec": 1e-3, "μs": 1e-6, "us": 1e-6, "ns": 1e-9, "min": 60.0,
}  # fmt: skip
DEGREE = float(np.pi / 180)
ANGLES = {
    **dict.fromkeys(("rad", "radian", "radians", "radianes"), 1.0),
    **dict.fromkeys(("deg", "°", "degree", "degrees", "grad", "degre", "degres", "grados"), DEGREE),
}
RATES = {
    **{f"{unit}/{second}": factor for unit, factor in ANGLES.items() for second in ("s", "sec")},
    "1/s": 1.0, "s^-1": 1.0, "rpm": np.pi / 30,
}  # fmt: skip
SHOWN = {"length": "m, cm, mm, in and ft", "time": "s, ms and min", "angle": "rad and deg", "rate": "rad/s, deg/s and rpm"}
UNITS = {"length": LENGTHS, "time": TIMES, "angle": ANGLES, "rate": RATES}
KNOWN_UNITS = {unit for units in UNITS.values() for unit in units if unit}
KIND_OF = {"m": "length", "s": "time", "rad": "angle", "rad/s": "rate"}
KINDS = {name: KIND_OF[unit] for name, (_, _, unit) in COLUMNS.items() if unit in KIND_OF}

# Words of heads, without accents, for quantities that have no direction.
WORDS = {
    **dict.fromkeys(("t", "time", "zeit", "temps", "tiempo", "seconds elapsed", "timestamp"), "t"),
    **dict.fromkeys(("frame", "frames", "frame number", "bild", "bildnummer", "image", "imagen", "fotograma"), "frame"),
    **dict.fromkeys(("angle", "theta", "θ", "rotation", "winkel", "drehwinkel", "angulo"), "angle"),
    **dict.fromkeys(("θr", "thetar", "theta r", "θ r"), "polar"),
    **dict.fromkeys(("omega", "ω", "w", "angular velocity", "rotation rate", "winkelgeschwindigkeit", "drehrate"), "omega"),
    **dict.fromkeys(("vitesse angulaire", "velocidad angular", "gyro", "gyroscope", "gyroskop", "giroscopio"), "omega"),
    **{name.replace("_", " "): name for name in COLUMNS if name.startswith("sigma") or "column" in name or "row" in name},
}  # fmt: skip
# Columns with a direction that are no positions.
RATES_OF_CHANGE = ("veloc", "speed", "accel", "acelera", "geschwindigkeit", "beschleunigung", "vitesse")
NO_LENGTHS = KNOWN_UNITS - LENGTHS.keys()
DIGITS = r"[-+]?[\d.,]*\d[\d.,]*([eE][-+]?\d+)?"
CLOCK = r"(\d+:){1,2}\d+([.,]\d+)?"
DATA = re.compile(r'\s*"?[-+\u2212]?[\d.,:]*\d[\d.,:]*([eE][-+]?\d+)?"?\s*([\s;,]|$)')
GROUPED = {",": r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?", ".": r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?"}


@dataclass(frozen=True, eq=False)
class Column:
    """A column of a table."""

    label: str  # as the file spells it, after the point's name if that is above it
    point: str  # '' if it has none
    quantity: str  # a name of COLUMNS, 'frame', 'polar' or ''; x, y and z for positions
    unit: str  # '' if it is not written
    values: Floats  # nan for empty cells and words

    def converted(self, kind: str, name: str, unit: str = "") -> Floats:
        """Return values in SI units and radians.

        kind: a key of UNITS; name: of the file, for messages; unit: for a column without one.
        """
        given = self.unit or unit
        if given not in UNITS[kind]:
            if not given:
                raise InputError(
                    f"{name} has no unit of {self.label}: write it behind the name, such as {self.label} (deg), or give "
                    "--angle-unit deg, or angle_unit='deg' in a Reading."
                )
            raise InputError(f"{name} gives {self.label} in an unknown unit; known units are {SHOWN[kind]}.")
        return self.values * UNITS[kind][given]


def read_columns(text: str, name: str) -> tuple[list[Column], list[str]]:
    """Read a table of numbers under heads: the columns, and remarks on how the numbers were understood.

    name: of the file, for messages.
    """
    pandas = need("pandas", "fit")
    lines = [line.lstrip("#") for line in text.splitlines() if line.strip(" \t;,#\r")]
    if not lines:
        raise InputError(f"{name} is empty.")
    data = [DATA.match(line) is not None for line in lines]
    first = next((k for k in range(len(lines)) if all(data[k : k + 2])), None)
    if first is None:
        raise InputError(f"{name} has no {'table' if len(lines) < 2 else 'row of numbers'}.")
    if first == 0:
        raise InputError(f"{name} has no row of column names, such as t, x, y, angle (deg).")
    separator = next((sign for sign in "\t;," if sign in lines[first] and sign in lines[first - 1]), r"\s+(?![\[(])")
    if len(separator) > 1:
        lines = [line.strip() for line in lines]
    frame = pandas.read_csv(
        io.StringIO("\n".join(lines)),
        sep=separator,
        engine="python" if len(separator) > 1 else "c",
        header=None,
        names=range(max(len(re.split(separator, line)) for line in lines)),
        index_col=False,
        dtype=str,
        skipinitialspace=True,
        na_values=["-", "–", "none", "None", "#WERT!", "#VALUE!", "#DIV/0!"],
    )
    frame = frame.apply(lambda cells: cells.str.strip())
    first = len(frame) - (len(lines) - first)  # a cell with a line break makes one row of two lines
    heads, units, points = _head_rows(frame, first)
    body = frame.iloc[first:].map(_tidy, na_action="ignore")
    wide = 1 + max((k for k in body if body[k].notna().any()), default=0)
    if wide > len(heads):
        raise InputError(
            f"{name} has a row of {wide} cells under {len(heads)} names: a comma can divide cells or numbers, "
            "not both. Save it with semicolons."
        )
    decimal, notes = _decimal_sign(body, name)
    columns = []
    for k, head in enumerate(heads):
        if head:
            values = _numbers(pandas, body[k], decimal, name, head)
            columns.append(_column(head, points[k], units[k], values))
    return columns, notes


def _head_rows(frame: Any, first: int) -> tuple[list[str], list[str], list[str]]:
    """Return the heads of a table, and the units and points from rows of their own below and above them."""
    rows = frame.iloc[:first].fillna("").values.tolist()
    heads, units = rows[-1], [""] * len(rows[-1])
    bare = [_unit(cell) for cell in heads]
    if len(rows) > 1 and all(unit in KNOWN_UNITS for unit in bare if unit):
        heads, units = rows[-2], bare
        rows.pop()
    while heads and not heads[-1]:
        heads = heads[:-1]  # a separator at the end of every line
    points, now = [], ""
    above = rows[-2] if len(rows) > 1 and not rows[-2][0] else []  # words above the times are a title
    for cell in above:
        now = cell or now
        points.append(now)
    return heads, units, points or [""] * len(heads)


def _unit(text: str) -> str:
    return _plain(text).strip("[]() .").replace(" per ", "/").replace("·", "").replace("µ", "μ")


def _plain(text: str) -> str:
    """Return lower-case text without accents and special spaces."""
    letters = unicodedata.normalize("NFKD", text)
    return "".join(letter for letter in letters if not unicodedata.combining(letter)).lower()


def _column(head: str, point: str, unit: str, values: Floats) -> Column:
    """Return a column with the meaning of its head.

    It understands prefixes (Data Set 1:X), runs (x Run #1), paths (hub/0/X), numbered points (X 2), and a unit in
    parentheses, behind a slash or as the last word.
    """
    label = f"{point} {head}".strip()
    text = re.sub(r"^[^:()\[\]]*:", "", re.sub(r"\s\w+ #\d+$", "", head))
    if path := re.fullmatch(r"(.+)/\d+/([XYxy])", text):
        point, text = path[1], path[2]
    found = re.fullmatch(r"(.*?)\s*(?:[\[(]([^\])]*)[\])]|\s/\s(\S+))", text)
    if found:
        text, unit = found[1], _unit(found[2] or found[3] or "")
    words = re.findall(r"[^\W\d_]+|\d+", _plain(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)))
    if not unit and len(words) > 1 and words[-1] in KNOWN_UNITS:
        unit = words.pop()
        words = words[:-1] if words[-1] == "in" and len(words) > 1 else words
    quantity = WORDS.get(" ".join(words), "")
    axes = [word for word in words if word in ("x", "y", "z")]
    if not quantity and len(words) == 1 and re.fullmatch("[wω][xyz]", words[0]):
        quantity = "omega"
    elif not quantity and len(axes) == 1:
        rest = " ".join(word for word in words if word not in axes)
        quantity = WORDS.get(rest, axes[0])
        if quantity == axes[0]:
            point = point or rest
            if "/" in unit or unit in NO_LENGTHS or any(word in rest for word in RATES_OF_CHANGE):
                quantity = ""
    return Column(label, point, quantity, unit, values)


# --- numbers ---------------------------------------------------------------------------------------


def _tidy(cell: str) -> str:
    """Return a cell with an ASCII minus sign and without spaces and apostrophes that group digits."""
    return re.sub(r"(?<=\d)[\s'’](?=\d{3}(\D|$))", "", cell.replace("\u2212", "-"))


def _decimal_sign(body: Any, name: str) -> tuple[str, list[str]]:
    """Return the decimal sign of a table, ',.' if it has both or none, and a remark if the other one groups digits."""
    cells = body.stack()
    cells = cells[cells.str.fullmatch(DIGITS)]
    marked = {sign: cells[cells.str.contains(sign, regex=False)] for sign in GROUPED}
    grouped = {sign: found[found.str.fullmatch(GROUPED[sign])] for sign, found in marked.items()}
    signs = [sign for sign in GROUPED if len(grouped[sign])]
    decimals = [sign for sign in GROUPED if len(grouped[sign]) < len(marked[sign])]
    if len(decimals) == 1:
        signs = [sign for sign in signs if sign not in decimals]
    elif not decimals and len(signs) == 1:
        columns = grouped[signs[0]].index.get_level_values(1)
        integers = cells.index.get_level_values(1).isin(columns).sum() > len(columns)
        if integers == (signs == [","]):  # 985, 1,002 and 1,019; or 1.002 and 1.019 in all rows
            decimals, signs = ["."], signs if integers else []
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


def _numbers(pandas: Any, cells: Any, decimal: str, name: str, head: str) -> Floats:
    """Return the numbers of a column, nan for empty cells; one of words, such as a state, is all nan."""
    known = cells.dropna()
    if len(known) and known.str.fullmatch(CLOCK).all():
        short = known.str.count(":") == 1
        clock = pandas.to_timedelta(known.where(~short, "0:" + known).str.replace(",", "."))
        values = clock.dt.total_seconds()
    else:
        values = pandas.to_numeric(known.map(lambda cell: _one_number(cell, decimal)), errors="coerce")
        bad = values.isna() | np.isinf(values)
        if bad.all():
            return np.full(len(cells), np.nan)
        if bad.any():
            row = bad.idxmax() - cells.index[0] + 1
            raise InputError(
                f"{name} has {known[bad.idxmax()][:40]!r} in column {head}, row {row} below the names, which must be a number."
            )
    result: Floats = values.reindex(cells.index).to_numpy(dtype=float)
    return result
