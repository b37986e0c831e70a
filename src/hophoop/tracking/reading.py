"""Tracks from files: our own, Tracker's export, plain tables."""

from __future__ import annotations

import errno
import json
import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.scenario.sentences import parse_reason
from hophoop.tracking.table import COLUMNS, Track, track_from_dict, track_of
from hophoop.tracking.text import ANGLES, OMEGAS, Column, in_metres, in_radians, in_seconds, read_columns

Floats = NDArray[np.float64]

MOST_BYTES = 500_000_000
CENTRE_WORDS = ("cent", "mitte", "hub", "nabe", "axis", "axle", "zentr")
MARKER_WORDS = ("mark", "load", "weight", "last", "gewicht", "dot")
TRACKER, TABLES, OWN = (".trk", ".trz"), (".csv", ".txt", ".tsv", ".dat"), (".json",)
SHEETS = (".xlsx", ".xls", ".xlsm", ".ods", ".numbers")
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
USED = {"t", "time", "state", *COLUMNS, *ANGLES, *OMEGAS}


@dataclass(frozen=True)
class Reading:
    """Quantities that a file of a track may lack.

    Parameters
    ----------
    centre, marker : str, optional
        Names of the rim's centre and of the marker.
    angle_unit : {'rad', 'deg'}, optional
        Unit of angles, if the file has none.
    radius : float, optional
        Radius of the rim [m].
    sigma : float, optional
        Standard deviation of each coordinate, if the file has none [m].
    sigma_angle : float, optional
        The same of the angle [rad].

    Raises
    ------
    ValueError
        If a value is not allowed.
    """

    centre: str | None = None
    marker: str | None = None
    angle_unit: str | None = None
    radius: float | None = None
    sigma: float | None = None
    sigma_angle: float | None = None

    def __post_init__(self) -> None:
        if self.angle_unit not in (None, "rad", "deg"):
            raise InputError.of_field("angle_unit", self.angle_unit, "'rad' or 'deg'")
        for name in ("radius", "sigma", "sigma_angle"):
            value = getattr(self, name)
            if value is not None and not (np.isfinite(value) and value > 0):
                raise InputError.of_field(name, value, "a number above 0")


def read_track(path: str | Path, reading: Reading | None = None) -> Track:
    """Read a track.

    Parameters
    ----------
    path : str or Path
        A track of `track` (.json or .csv), Tracker's text export (.txt, .csv), or a table with named columns: t, and x and y of
        the centre, marker_x and marker_y, or angle.
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
        try:
            data = json.loads(text)
        except (ValueError, RecursionError) as error:
            raise InputError(f"{file} is not valid JSON: {parse_reason(error)}.") from None
        return _fill_in(track_from_dict(data, str(file)), how)
    if ending not in TABLES:
        raise InputError(f"{file} must end in {', '.join((*OWN, *TABLES[:-1]))} or {TABLES[-1]}.")
    return _fill_in(_from_table(read_columns(text, str(file)), file, how), how)


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
    values: dict[str, Any] = {}
    if np.isnan(track.angle).all():
        arrow = track.marker - track.centre
        there = np.isfinite(arrow[:, 0])
        angle = np.arctan2(arrow[:, 0], arrow[:, 1])
        angle[there] = np.unwrap(angle[there])
        if there.any():
            values["angle"] = angle
    if how.radius is not None:
        values["radius"] = how.radius
    if how.sigma is not None:
        there = np.where(np.isfinite(track.centre), how.sigma, np.nan)
        values["centre_error"] = np.where(np.isfinite(track.centre_error), track.centre_error, there)
        there = np.where(np.isfinite(track.marker[:, 0]), how.sigma, np.nan)
        values["marker_error"] = np.where(np.isfinite(track.marker_error), track.marker_error, there)
    if how.sigma_angle is not None:
        there = np.where(np.isfinite(track.angle), how.sigma_angle, np.nan)
        values["angle_error"] = np.where(np.isfinite(track.angle_error), track.angle_error, there)
    return replace(track, **values) if values else track


# --- tables ----------------------------------------------------------------------------------------


def _from_table(columns: list[Column], file: Path, how: Reading) -> Track:
    name = str(file)
    columns = _usual_names(columns)
    points = list(dict.fromkeys(column.point for column in columns if column.name not in ("t", "time")))
    times = [column for column in columns if column.name in ("t", "time")]
    if not times:
        found = ", ".join(column.name for column in columns)
        raise InputError(f"{name} has no column t: its columns are {found}.")
    t = in_seconds(times[0], name)
    result: dict[str, Floats] = {}
    if len(points) == 1 and not how.marker:
        result = _one_point(columns, points[0], t, how, name)
    else:
        roles = _roles(points, how, name)
        for role, point in roles.items():
            own = [column for column in columns if column.point == point]
            for axis in ("x", "y"):
                column = next((one for one in own if one.name == axis), None)
                if column is None:
                    raise InputError(f"{name} has no column {axis} for the point {point!r}.")
                result[axis if role == "centre" else f"marker_{axis}"] = in_metres(column, name)
            if role == "centre":
                result |= _angle(own, t, how, name)
    states = dict.fromkeys(column.name for column in columns)
    if not any(key in result for key in ("x", "marker_x", "angle")):
        raise InputError(
            f"{name} has neither x and y, nor marker_x and marker_y, nor angle: its columns are {', '.join(states)}."
        )
    # Tracker's points are not along and above the plane; our own table is
    ours = {"sigma_x", "sigma_y"} <= states.keys()
    keep = np.isfinite(t)
    if not ours:  # a row of Tracker with a time only is a frame without marks
        looked = np.isfinite(list(result.values())).any(axis=0)
        keep &= looked | ~looked.any()
    result = {key: values[keep] for key, values in result.items()}
    unused = [word for word in states if word not in USED] if points == [""] else []
    notes = (f"Columns of {file.name} that are not used: {', '.join(unused)}.",) if unused else ()
    return track_of(t[keep], result, source=file.name, placed=ours, notes=notes)


def _usual_names(columns: list[Column]) -> list[Column]:
    """Give columns such as load_x and centre_x of a table without points the names of our own."""
    taken, result = {column.name for column in columns}, []
    for column in columns:
        word, _, axis = column.name.rpartition("_")
        ours = f"marker_{axis}" if _marks(word, MARKER_WORDS) else axis if _marks(word, CENTRE_WORDS) else ""
        if column.point or axis not in ("x", "y") or word == "sigma" or ours in taken:
            ours = ""
        result.append(column._replace(name=ours) if ours else column)
    return result


def _one_point(columns: list[Column], point: str, t: Floats, how: Reading, name: str) -> dict[str, Floats]:
    own = {column.name: column for column in columns if column.point == point}
    result = {}
    for key, (_, _, unit) in COLUMNS.items():
        if key in own and key not in ("t", "angle", "sigma_angle"):
            result[key] = in_metres(own[key], name) if unit == "m" else own[key].values
    for a, b in (("x", "y"), ("marker_x", "marker_y")):
        if (a in result) != (b in result):
            missing, there = (b, a) if a in result else (a, b)
            raise InputError(f"{name} has a column {there}, but none {missing}.")
    if _marks(point, MARKER_WORDS) or (how.marker and how.marker == point):
        result |= {f"marker_{axis}": result.pop(axis) for axis in ("x", "y") if axis in result}
    result |= _angle(list(own.values()), t, how, name)
    if "sigma_angle" in own and "angle" in result:
        result["sigma_angle"] = own["sigma_angle"].values * (np.pi / 180 if own["sigma_angle"].unit == "deg" else 1.0)
    return result


def _angle(own: list[Column], t: Floats, how: Reading, name: str) -> dict[str, Floats]:
    angle = next((column for column in own if column.name in ANGLES and np.isfinite(column.values).any()), None)
    if angle is None:
        return {}
    omega = next((column for column in own if column.name in OMEGAS), None)
    return {"angle": in_radians(angle, t, omega, how.angle_unit, name)}


def _marks(name: str, words: tuple[str, ...]) -> bool:
    return any(word in name.lower() for word in words)


def _roles(points: list[str], how: Reading, name: str) -> dict[str, str]:
    """Return the points of centre and marker: as given, by their names, or the only one."""
    roles: dict[str, str] = {}
    for role, said, words in (("centre", how.centre, CENTRE_WORDS), ("marker", how.marker, MARKER_WORDS)):
        if said is not None:
            if said not in points:
                raise InputError(f"{name} has no point {said!r}; its points are {', '.join(points)}.")
            roles[role] = said
        else:
            fit = [point for point in points if _marks(point, words)]
            if len(fit) == 1:
                roles[role] = fit[0]
    if not roles and len(points) == 1:
        roles["centre"] = points[0]
    if not roles:
        raise InputError(f"{name} has the points {', '.join(points)}: give the names of the centre and of the marker.")
    return roles
