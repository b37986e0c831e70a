"""Tracker's own files: XML with points in pixels, axes, scale and the time between frames; a .trz is a ZIP with one inside."""

from __future__ import annotations

import io
import zipfile
import zlib
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError

Floats = NDArray[np.float64]

MOST_BYTES = 200_000_000
MOST_FRAMES = 10_000_000


class Points(NamedTuple):
    """A point mass with its marks."""

    name: str
    frames: NDArray[np.int64]  # numbers of frames
    places: Floats  # shape (n, 2): in the axes of the file, y upwards, in its unit of length


class Project(NamedTuple):
    """Points and times of a Tracker file."""

    points: list[Points]
    start_frame: int
    start: float  # time of that frame [s]
    step: float  # between frames [s]
    unit: str

    def times(self, frames: NDArray[np.int64]) -> Floats:
        """Times of frames [s]."""
        return np.asarray(self.start + (frames - self.start_frame) * self.step, dtype=float)


def read_project(path: Path) -> Project:
    """Read a .trk or .trz file.

    Parameters
    ----------
    path : Path

    Returns
    -------
    project : Project

    Raises
    ------
    ValueError
        If it is not a file of Tracker, or has no points.
    OSError
        If it cannot be read.
    """
    root = _root(path)
    panel = root if root.get("class", "").endswith(".TrackerPanel") else _object_of(root, ".TrackerPanel")
    if panel is None:
        raise InputError(f"{path} is not a file of Tracker: no TrackerPanel in it.")
    clip = _property(panel, "videoclip")
    control = _property(panel, "clipcontrol")
    step = _value(control, "delta_t")
    if step is None:
        step = _value(_property(clip, "video"), "delta_t")
    if step is None or not step > 0:
        raise InputError(f"{path} has no time between frames (delta_t).")
    axes = _axes(panel, path)
    masses = [one for one in panel.iter("object") if one.get("class", "").endswith(".tracker.PointMass")]
    points = [found for one in masses if (found := _points(one, axes, path)) is not None]
    if not points:
        raise InputError(f"{path} has no point mass with marks.")
    unit = _text(panel, "length_unit") or ""
    first = _value(clip, "startframe") or 0.0
    return Project(points, int(first), 1e-3 * (_value(clip, "starttime") or 0.0), 1e-3 * step, unit)


def _root(path: Path) -> ElementTree.Element:
    try:
        data = path.read_bytes() if path.stat().st_size <= MOST_BYTES else b""
        if path.suffix.lower() == ".trz":
            with zipfile.ZipFile(path) as archive:
                names = [name for name in archive.namelist() if name.lower().endswith(".trk")]
                if not names:
                    raise InputError(f"{path} has no .trk file in it.")
                info = archive.getinfo(names[0])
                data = archive.read(info) if info.file_size <= MOST_BYTES else b""
    except zipfile.BadZipFile:
        raise InputError(f"{path} is not a ZIP archive, as a .trz file is.") from None
    except (zlib.error, EOFError, RuntimeError) as error:
        reason = str(error).rstrip(".") or "it ends too early"
        raise InputError(f"{path} cannot be unpacked: {reason}.") from None
    if not data:
        raise InputError(f"{path} is empty or larger than {MOST_BYTES // 1_000_000} MB.")
    if b"<!ENTITY" in data[:100_000]:
        raise InputError(f"{path} declares entities, which a file of Tracker does not.")
    try:
        return ElementTree.parse(io.BytesIO(data)).getroot()
    except (ElementTree.ParseError, ValueError, LookupError) as error:  # the last two: unknown encoding
        raise InputError(f"{path} is not valid XML: {error}.") from None


def _property(parent: ElementTree.Element | None, name: str) -> ElementTree.Element | None:
    """Return the object of a property, or the property itself."""
    if parent is None:
        return None
    for one in parent.findall("property"):
        if one.get("name") == name:
            inner = one.find("object")
            return one if inner is None else inner
    return None


def _object_of(root: ElementTree.Element, ending: str) -> ElementTree.Element | None:
    return next((one for one in root.iter("object") if one.get("class", "").endswith(ending)), None)


def _text(parent: ElementTree.Element | None, name: str) -> str | None:
    found = _property(parent, name)
    return None if found is None or found.text is None else found.text.strip()


def _value(parent: ElementTree.Element | None, name: str) -> float | None:
    text = _text(parent, name)
    try:
        number = float(text) if text is not None else None
    except ValueError:
        return None
    return number if number is None or np.isfinite(number) else None


class _Axes(NamedTuple):
    """Origin [pixel], direction [rad] and scale [pixel/unit], from a frame on."""

    frame: int
    x: float
    y: float
    angle: float
    x_scale: float
    y_scale: float


def _axes(panel: ElementTree.Element, path: Path) -> list[_Axes]:
    coords = _property(panel, "coords")
    frames = _property(coords, "framedata")
    result = []
    for one in frames.findall("property") if frames is not None else []:
        inner = one.find("object")
        values = [_value(inner, name) for name in ("xorigin", "yorigin", "angle", "xscale", "yscale")]
        numbers = [value for value in values if value is not None]
        if len(numbers) == 5 and numbers[3] * numbers[4] > 0:
            result.append(_Axes(_index(one), numbers[0], numbers[1], np.radians(numbers[2]), numbers[3], numbers[4]))
    if not result:
        raise InputError(f"{path} has no axes and scale (coords).")
    return sorted(result)


def _index(element: ElementTree.Element) -> int:
    word = (element.get("name") or "").strip("[]")
    number = int(word) if word.isdigit() and len(word) < 9 else -1
    return number if number < MOST_FRAMES else -1


def _points(mass: ElementTree.Element, axes: list[_Axes], path: Path) -> Points | None:
    data = _property(mass, "framedata")
    frames, places = [], []
    for one in data.findall("property") if data is not None else []:
        inner, number = one.find("object"), _index(one)
        x, y = _value(inner, "x"), _value(inner, "y")
        if number < 0 or x is None or y is None:
            continue
        now = [each for each in axes if each.frame <= number][-1:] or axes[:1]
        frames.append(number)
        places.append(_in_axes(x, y, now[0]))
    if not frames:
        return None
    order = np.argsort(frames)
    return Points(_text(mass, "name") or "point", np.array(frames)[order], np.array(places)[order])


def _in_axes(column: float, row: float, axes: _Axes) -> tuple[float, float]:
    x, y = (column - axes.x) / axes.x_scale, (row - axes.y) / axes.y_scale
    cos, sin = np.cos(axes.angle), np.sin(axes.angle)
    return float(cos * x - sin * y), float(-sin * x - cos * y)
