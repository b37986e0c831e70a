"""Tracks from files: our own, Tracker's export, plain tables."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.tracking.columns import KINDS, Column, read_columns
from hophoop.tracking.hints import require_above_0
from hophoop.tracking.table import COLUMNS, Track, parse_json, track_from_dict, track_of

Floats = NDArray[np.float64]

MOST_BYTES = 500_000_000
CENTRE_WORDS = ("cent", "mitte", "hub", "nabe", "axis", "axle", "zentr", "milieu", "moyeu", "buje", "eje")
MARKER_WORDS = ("mark", "load", "weight", "last", "gewicht", "dot", "charge", "carga", "poids", "peso", "marque", "marca")
UNIT = re.compile(r"\s*[(\[].*")
MOST_NAMED = 12  # columns that a remark names
ALIKE = 0.97  # minimum mean resultant length of the difference between an angle and the direction to the marker [1]
TRACKER, TABLES, OWN = (".trk", ".trz"), (".csv", ".txt", ".tsv", ".dat"), (".json",)
SHEETS = (".xlsx", ".xls", ".xlsm", ".ods", ".numbers")
CHANNELS = ("frame", *COLUMNS)
CERTAIN = COLUMNS.keys() - {"t", "x", "y", "angle", "omega"}  # columns whose name has only one meaning
UTF_16 = (b"\xff\xfe", b"\xfe\xff")


@dataclass(frozen=True)
class Reading:
    """Quantities that a file of a track may lack.

    Parameters
    ----------
    centre : str, optional
        Name of the point at the centre, or of a column of it.
    marker : str, optional
        Name of the point at the marker, or of a column of it.
    columns : dict, optional
        Columns as the file spells them, by quantity: t, frame, x, y, marker_x, marker_y, angle, omega, or another one of
        `Track.save`. Columns that are not given are found by their names.
    rate : float, optional
        Frames per second as taken, if the file has frames, or one row per frame, instead of times [1].
    since : float, optional
        Time from which the motion is free [s]; earlier rows are left out.
    until : float, optional
        Time up to which it is free [s].
    angle_unit : {'rad', 'deg'}, optional
        Unit of angles and angular velocities, if the data lack it.
    radius : float, optional
        Radius of the rim [m], if the data lack it.

    Raises
    ------
    ValueError
        If a value is not allowed.
    """

    centre: str | None = None
    marker: str | None = None
    columns: Mapping[str, str] = field(default_factory=dict)
    rate: float | None = None
    since: float | None = None
    until: float | None = None
    angle_unit: str | None = None
    radius: float | None = None

    def __post_init__(self) -> None:
        if self.angle_unit not in (None, "rad", "deg"):
            raise InputError.of_field("angle_unit", self.angle_unit, "'rad' or 'deg'")
        for name in self.columns:
            if name not in CHANNELS:
                raise InputError(f"columns cannot name {name!r}; it can name {', '.join(CHANNELS)}.", field="columns")
        require_above_0(radius=self.radius, rate=self.rate)


def read_track(path: str | Path, reading: Reading | None = None) -> Track:
    """Read a track.

    Parameters
    ----------
    path : str or Path
        A track of `track` (.json or .csv), or a table with named columns as programs export it: times, and x and y of the
        centre, those of the marker, the angle, or the angular velocity.
    reading : Reading, optional
        Quantities that the file lacks.

    Returns
    -------
    track : Track

    Raises
    ------
    ValueError
        If the file has another format.
    OSError
        If it cannot be read.
    ImportError
        If pandas is missing, for a table.
    """
    file, how = Path(path), reading or Reading()
    if not file.exists():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(file))
    ending = file.suffix.lower()
    if ending in TRACKER:
        raise InputError(f"{file} is a project of Tracker: open it there and save its points with File, Export, Data.")
    if file.stat().st_size > MOST_BYTES:
        raise InputError(f"{file} is larger than {MOST_BYTES // 1_000_000} MB, which no track is.")
    if ending in SHEETS:
        raise InputError(f"{file} is a spreadsheet: save the sheet as CSV.")
    text = _text(file)
    if ending in OWN:
        data = parse_json(text, str(file))
        if how.columns or how.rate:
            raise InputError(
                f"{file} is a track of hophoop, with columns and times of its own: columns and rate are for tables."
            )
        return _fill_in(track_from_dict(data, str(file)), how).between(how.since, how.until)
    if ending not in TABLES:
        raise InputError(f"{file} must end in {', '.join((*OWN, *TABLES[:-1]))} or {TABLES[-1]}.")
    columns, notes = read_columns(text, str(file))
    return _fill_in(_from_table(columns, notes, file, how), how).between(how.since, how.until)


def _text(file: Path) -> str:
    """Return a file's text in an encoding of spreadsheets: a name such as 'angle (°)' is not ASCII."""
    data = file.read_bytes()
    for encoding in ("utf-16",) if data.startswith(UTF_16) else ("utf-8-sig", "cp1252"):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise InputError(f"{file} is not text: a track is a table or JSON.")


def _fill_in(track: Track, how: Reading) -> Track:
    """Fill in what the file lacks."""
    angle = track.angle
    if np.isnan(angle).all():
        angle = _unwrapped(np.arctan2(*(track.marker - track.centre).T))
    return replace(track, angle=angle, radius=track.radius if how.radius is None else how.radius)


# --- tables ----------------------------------------------------------------------------------------


def _from_table(columns: list[Column], notes: list[str], file: Path, how: Reading) -> Track:
    name = str(file)
    used = {channel: _of_label(columns, channel, label, name) for channel, label in how.columns.items()}
    used = {column.quantity: column for column in columns if column.quantity in CERTAIN} | used
    # points of other programs are not along and above the plane; our own table's are
    ours = {"sigma_x", "sigma_y"} <= used.keys()
    centre = _find_positions(columns, used, how, name, notes)
    _find_rotation(columns, used, centre, notes)
    for a, b in (("x", "y"), ("marker_x", "marker_y")):
        if (a in used) != (b in used):
            missing, there = (b, a) if a in used else (a, b)
            raise InputError(f"{name} has a column {used[there].label}, but none for {missing}: {_listed(columns, missing)}.")
    if not {"x", "marker_x", "angle", "omega"} & used.keys():
        raise InputError(
            f"{name} has neither x and y, nor marker_x and marker_y, nor angle, nor omega: {_listed(columns, 'x')}."
        )
    t = _times(columns, used, how, name)
    values = _values(used, how, name)
    _orient(values, used, t, notes)
    _compare_angles(values, used, notes)
    keep = np.isfinite(t)
    if not ours:  # a row with a time only is a frame without marks
        looked = np.isfinite(list(values.values())).any(axis=0)
        keep &= looked | ~looked.any()
    values = {key: numbers[keep] for key, numbers in values.items()}
    said = {id(column) for column in used.values()} | {id(column) for column in columns if column.quantity == "polar"}
    unused = [column.label for column in columns if id(column) not in said and column.label.lower() != "state"]
    if unused:
        more = f" and {len(unused) - MOST_NAMED} more" if len(unused) > MOST_NAMED else ""
        notes.append(f"Columns of {file.name} that are not used: {', '.join(unused[:MOST_NAMED])}{more}.")
    return track_of(t[keep], values, source=file.name, placed=ours, notes=tuple(notes))


def _listed(columns: list[Column], channel: str) -> str:
    """The columns as the file spells them, with the option that names one."""
    shown = ", ".join(column.label for column in columns)
    return f"its columns are {shown}; --column {channel}=HEAD names one (columns= in a Reading)"


def _of_label(columns: list[Column], channel: str, label: str, name: str) -> Column:
    for same in (str, str.casefold):
        for column in columns:
            if same(column.label) == same(label.strip()):
                return column
    raise InputError(f"{name} has no column {label!r}: {_listed(columns, channel)}.")


def _only(columns: list[Column], quantity: str, name: str) -> Column | None:
    """Return the column of a quantity, None if there is none; two are asked for."""
    found = [column for column in columns if column.quantity == quantity]
    if len(found) > 1:
        both = " and ".join(column.label for column in found[:2])
        raise InputError(
            f"{name} has the columns {both} for {quantity}: name one by --column '{quantity}={found[0].label}' "
            "(columns= in a Reading)."
        )
    return found[0] if found else None


def _times(columns: list[Column], used: dict[str, Column], how: Reading, name: str) -> Floats:
    """Times of the rows [s], from a column of times or from the numbers of frames."""
    times = used.get("t") or (None if "frame" in used else _only(columns, "t", name))
    frames = used.get("frame") or (times if how.rate and times else _only(columns, "frame", name))
    if how.rate:
        rows = frames.values if frames else np.arange(len(columns[0].values), dtype=float)
        known = rows[np.isfinite(rows)]
        if (known != np.round(known)).any():
            raise InputError(f"{name} has times, no numbers of frames: leave out --rate (rate= in a Reading).")
        used |= {"frame": frames} if frames else {}
        return rows / how.rate
    if times is None:
        said = "no column of times" if frames is None else "numbers of frames instead of times"
        raise InputError(
            f"{name} has {said}: {_listed(columns, 't')}, and --rate 240 the frames per second as taken (rate= in a Reading)."
        )
    used["t"] = times
    return times.converted("time", name)


def _values(used: dict[str, Column], how: Reading, name: str) -> dict[str, Floats]:
    """Values of all columns but the times, in SI units and radians."""
    values = {}
    for channel, column in used.items():
        kind, angle = KINDS.get(channel, ""), "rad" if channel.startswith("sigma") else how.angle_unit
        unit = {"angle": angle, "rate": angle and f"{angle}/s"}.get(kind) or ""
        if channel not in ("t", "frame"):
            values[channel] = column.converted(kind, name, unit) if kind else column.values
    if "angle" in values:
        values["angle"] = _unwrapped(values["angle"])
    return values


def _unwrapped(angle: Floats) -> Floats:
    """Return an angle without jumps of whole revolutions; nan stays."""
    result, there = angle.copy(), np.isfinite(angle)
    result[there] = np.unwrap(angle[there])
    return result


def _find_positions(columns: list[Column], used: dict[str, Column], how: Reading, name: str, notes: list[str]) -> str | None:
    """Find the columns of centre and marker; return the name of the point at the centre."""
    free = [column for column in columns if column.quantity in ("x", "y") and column not in used.values()]
    points = list(dict.fromkeys(column.point for column in free))
    named = {"x", "y", "marker_x", "marker_y"} & used.keys()
    roles = _roles(free, points, how, name, notes, asks=not named)
    for role, point in roles.items():
        for axis in ("x", "y"):
            channel = axis if role == "centre" else f"marker_{axis}"
            found = None if channel in named else _only([column for column in free if column.point == point], axis, name)
            if found is not None:
                used[channel] = found
    return roles.get("centre")


def _roles(free: list[Column], points: list[str], how: Reading, name: str, notes: list[str], *, asks: bool) -> dict[str, str]:
    """Return the points of centre and marker: as given, by their names, or by their numbers; asks: whether one is needed."""
    roles: dict[str, str] = {}
    for role, said, words in (("centre", how.centre, CENTRE_WORDS), ("marker", how.marker, MARKER_WORDS)):
        if said is not None:
            same = [column.point for column in free if said in (column.point, column.label, UNIT.sub("", column.label))]
            if not same:
                raise InputError(f"{name} has no point {said!r}; its points are {_shown(points)}.")
            roles[role] = same[0]
        else:
            fit = [point for point in points if any(word in point.lower() for word in words)]
            if len(fit) == 1:
                roles[role] = fit[0]
    rest = [point for point in points if point not in roles.values()]
    numbered = [point for point in rest if not point or point.isdigit()]
    if not roles and len(numbered) == 2:
        numbered.sort(key=lambda point: _rise_and_fall(free, point))
        labels = [next(column.label for column in free if column.point == point) for point in numbered]
        notes.append(
            f"{labels[0]} is taken for the centre and {labels[1]}, which rises and falls more, for the marker; "
            "--centre and --marker name others."
        )
        return dict(zip(("centre", "marker"), numbered, strict=True))
    if "centre" not in roles and (len(numbered) == 1 or (rest == points and len(points) == 1)):
        roles["centre"] = (numbered or rest)[0]
    elif "marker" not in roles and len(numbered) == 1:
        roles["marker"] = numbered[0]
    if asks and points and not roles:
        raise InputError(
            f"{name} has the points {_shown(points)}: name the one at the centre and the one at the marker by "
            "--centre and --marker (centre= and marker= in a Reading)."
        )
    return roles


def _shown(points: list[str]) -> str:
    return ", ".join(repr(point) if point else "one without a name" for point in points)


def _rise_and_fall(free: list[Column], point: str) -> float:
    """Standard deviation of a point's y from a straight line."""
    y = next((column.values for column in free if column.point == point and column.quantity == "y"), np.zeros(1))
    y = y[np.isfinite(y)]
    row = np.arange(len(y))
    return float(np.std(y - np.polyval(np.polyfit(row, y, 1), row))) if len(y) > 2 else 0.0


def _find_rotation(columns: list[Column], used: dict[str, Column], centre: str | None, notes: list[str]) -> None:
    """Find the column of the angle, or without angle and marker that of the angular velocity."""
    known = [column for column in columns if np.isfinite(column.values).any() and column not in used.values()]
    polar = [column.label for column in known if column.quantity == "polar"]
    if "angle" not in used:
        angles = [column for column in known if column.quantity == "angle" and column.point in ("", centre)]
        used |= {"angle": angles[0]} if angles else {}
    if polar and "angle" not in used:
        notes.append(f"{polar[0]} is the direction as seen from the axes, not the rotation of the hoop: it is not used.")
    rates = [column for column in known if column.quantity == "omega"]
    if rates and not {"angle", "marker_x", "omega"} & used.keys():
        used["omega"] = max(rates, key=lambda column: float(np.nanmean(column.values**2)))
        if len(rates) > 1:
            notes.append(
                f"The angular velocity is that of {used['omega'].label}, the axis with the most rotation; "
                "--column omega= names another one."
            )


def _orient(values: dict[str, Floats], used: dict[str, Column], t: Floats, notes: list[str]) -> None:
    """Count an angular velocity as that of a hoop that rolls to greater x: a sensor may look to either side."""
    if "omega" in values:
        way = np.gradient(values["x"], t) if "x" in values else np.ones(len(t))
        if np.nansum(values["omega"] * way) < 0:
            values["omega"] = -values["omega"]
            notes.append(f"The sign of {used['omega'].label} is reversed, for a hoop that rolls to the right.")


def _compare_angles(values: dict[str, Floats], used: dict[str, Column], notes: list[str]) -> None:
    """Leave out an angle that contradicts the marker, with a remark."""
    if {"x", "marker_x", "angle"} <= values.keys():
        towards = np.arctan2(values["marker_x"] - values["x"], values["marker_y"] - values["y"])
        apart = values["angle"] - towards
        apart = apart[np.isfinite(apart)]
        if len(apart) and abs(np.exp(1j * apart).mean()) < ALIKE:
            del values["angle"]
            notes.append(f"{used['angle'].label} contradicts the line from the centre to the marker: the marker is used.")
