"""A track: positions of the hoop over time, with uncertainties; to and from files."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import Field, TypeAdapter, ValidationError

from hophoop._support.files import replacing
from hophoop.scenario import InputError
from hophoop.scenario.checking import input_error
from hophoop.scenario.formats import parse_reason
from hophoop.tracking.camera import Camera
from hophoop.tracking.scatter import Flags, Floats

SCHEMA = "hophoop-track/1"
HEAD = ("radius", "slope", "slope_error")  # numbers of the whole track


@dataclass(frozen=True)
class View:
    """Mapping between a film's picture and the plane.

    Attributes
    ----------
    camera : Camera
    scale : float
        Rectified pixels per metre [1/m].
    x, y : float
        Position of the centre at x = 0 in contact [rectified pixels].
    rise : float
        Angle of the rise of the ground to the right in the picture [rad].
    chroma : tuple of float or None
        Colour of the marker, as differences of blue and red from luma [1].
    marker_ratio : float
        Distance of the marker from the centre over the radius [1].
    exposure : float
        Exposure time [s].
    row_delay : float
        Delay of the exposure from row to row [s].
    rate : float or None
        Frames per second given instead of the file's times [Hz].
    scale_error : float
        Relative standard deviation of the scale, one error for all frames [1].
    height_error : float
        Standard deviation of the height of the plane at x = 0 [m].
    rise_error : float
        Standard deviation of the rise [rad].
    first : int
        Number of the film's pictures before the first frame of the track [1].
    """

    camera: Camera
    scale: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    x: float
    y: float
    rise: float
    chroma: tuple[float, float] | None = None
    marker_ratio: float = float("nan")
    exposure: float = 0.0
    row_delay: float = 0.0
    rate: float | None = None
    scale_error: float = float("nan")
    height_error: float = float("nan")
    rise_error: float = float("nan")
    first: int = 0

    def to_picture(self, points: Floats, radius: float) -> Floats:
        """Project points of the plane to pixels.

        Parameters
        ----------
        points : ndarray, shape (…, 2)
            Along the plane and above it [m].
        radius : float
            Of the hoop [m].

        Returns
        -------
        pixels : ndarray, shape (…, 2)
            Column and row [pixel].
        """
        return self.camera.to_picture([self.x, self.y] + self.scale * (points - [0.0, radius]) @ along(self.rise))

    def to_plane(self, pixels: Floats, radius: float) -> Floats:
        """Return the points of the plane at pixels, the inverse of `to_picture`.

        Parameters
        ----------
        pixels : ndarray, shape (…, 2)
            Column and row [pixel].
        radius : float
            Of the hoop [m].

        Returns
        -------
        points : ndarray, shape (…, 2)
            Along the plane and above it [m].
        """
        away = (self.camera.to_plane(pixels) - [self.x, self.y]) / self.scale
        return np.asarray(away @ along(self.rise).T + [0.0, radius])


def along(rise: float) -> Floats:
    """Rows of unit vectors along the plane and away from it, in the picture's axes; rise: of the plane [rad]."""
    cos, sin = np.cos(rise), np.sin(rise)
    return np.array([[cos, sin], [-sin, cos]])


# Columns of a table: attribute, its column, unit.
COLUMNS: dict[str, tuple[str, Any, str]] = {
    "t": ("t", ..., "s"),
    "x": ("centre", 0, "m"),
    "y": ("centre", 1, "m"),
    "angle": ("angle", ..., "rad"),
    "sigma_x": ("centre_error", 0, "m"),
    "sigma_y": ("centre_error", 1, "m"),
    "sigma_angle": ("angle_error", ..., "rad"),
    "marker_x": ("marker", 0, "m"),
    "marker_y": ("marker", 1, "m"),
    "sigma_marker": ("marker_error", ..., "m"),
    "omega": ("omega", ..., "rad/s"),
    "sigma_omega": ("omega_error", ..., "rad/s"),
    "column": ("pixel", 0, "pixel"),
    "row": ("pixel", 1, "pixel"),
    "marker_column": ("marker_pixel", 0, "pixel"),
    "marker_row": ("marker_pixel", 1, "pixel"),
}
PAIRS = {name for name, index, _ in COLUMNS.values() if index == 1}


@dataclass(frozen=True, eq=False)
class Track:
    """Position of a hoop in each frame of a film; nan where it was not found.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times [s].
    centre : ndarray, shape (n, 2)
        x along the plane and y, the height above it, of the rim's centre [m].
    marker : ndarray, shape (n, 2)
        The same of the marker [m].
    angle : ndarray, shape (n,)
        From the plane's normal to the line from centre to marker, clockwise, without jumps [rad].
    centre_error : ndarray, shape (n, 2)
        Standard deviations of the centre [m].
    marker_error, angle_error : ndarray, shape (n,)
        Standard deviations of each of the marker's coordinates [m] and of the angle [rad].
    pixel, marker_pixel : ndarray, shape (n, 2)
        Centre and marker in the picture: column and row [pixel].
    omega, omega_error : ndarray, shape (n,)
        Angular velocity, clockwise, of a sensor on the hoop, and its standard deviation [rad/s].
    radius : float
        Radius of the rim [m]; nan if unknown.
    slope : float
        Slope of the plane, downhill to the right [rad]; nan if unknown. The slope in the picture is -view.rise; the rest is the
        camera's roll.
    slope_error : float
        Its standard deviation, with that of the camera's level [rad]; nan if the slope was given or is unknown.
    placed : bool
        Whether x runs along the plane and y is the height above it; otherwise the fit determines the axes.
    view : View or None
        Mapping between picture and plane, of a film.
    source : str
        Name of the film or file.
    notes : tuple of str
        Remarks, one sentence each.
    """

    t: Floats
    centre: Floats
    marker: Floats
    angle: Floats
    centre_error: Floats
    marker_error: Floats
    angle_error: Floats
    pixel: Floats
    marker_pixel: Floats
    omega: Floats
    omega_error: Floats
    radius: float = float("nan")
    slope: float = float("nan")
    slope_error: float = float("nan")
    placed: bool = False
    view: View | None = None
    source: str = ""
    notes: tuple[str, ...] = field(default=())

    @property
    def state(self) -> tuple[str, ...]:
        """'found', 'no marker' or 'lost' for each frame."""
        placed = np.isfinite(self.centre[:, 0])
        marked = np.isfinite([self.marker[:, 0], self.angle, self.omega]).any(axis=0)
        found = placed | (marked & ~placed.any())  # a record without centres lacks none
        return tuple(np.where(found, np.where(marked, "found", "no marker"), "lost").tolist())

    @property
    def found(self) -> Flags:
        """True for each frame in which the hoop was found [1]."""
        return np.array([word != "lost" for word in self.state])

    def between(self, since: float | None = None, until: float | None = None) -> Track:
        """Return the part of the track between two times, such as between hand and wall.

        Parameters
        ----------
        since, until : float, optional
            Times of the first and the last frame to keep [s].

        Returns
        -------
        track : Track

        Raises
        ------
        ValueError
            If fewer than 3 frames are left.
        """
        low, high = -np.inf if since is None else since, np.inf if until is None else until
        keep = (self.t >= low) & (self.t <= high)
        if keep.all():
            return self
        if keep.sum() < 3:
            raise InputError(
                f"{self.source or 'The track'} has times from {self.t[0]:g} to {self.t[-1]:g} s, of which {keep.sum()} "
                "are in the window; at least 3 are needed."
            )
        arrays = {name: getattr(self, name)[keep] for name, _, _ in COLUMNS.values()}
        view = self.view and replace(self.view, first=self.view.first + int(np.argmax(keep)))
        return replace(self, **arrays, view=view)

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary, nan as None.

        Returns
        -------
        track : dict
            Ready for `json.dumps`; SI units and radians.
        """
        columns = {name: plain(values.tolist()) for name, values in self._known().items()}
        head: dict[str, Any] = {"schema": SCHEMA, "source": self.source, "placed": self.placed, "notes": list(self.notes)}
        head |= {name: value for name in HEAD if np.isfinite(value := getattr(self, name))}
        if self.view is not None:
            head["view"] = {key: value for key, value in asdict(self.view).items() if value is not None and value == value}
        return head | {"state": list(self.state), "columns": columns}

    def save(self, path: str | Path) -> None:
        """Write the track as JSON, or its table as CSV.

        Parameters
        ----------
        path : str or Path
            Ends in .json or .csv.

        Raises
        ------
        ValueError
            If the name has another ending.
        OSError
            If it cannot be written.
        """
        if Path(path).suffix.lower() != ".csv":
            write_json(path, self.to_dict(), ".json or .csv")
            return
        with replacing(Path(path)) as fresh, fresh.open("w", newline="", encoding="utf-8") as stream:
            csv.writer(stream).writerows(self.rows())

    def _known(self) -> dict[str, Floats]:
        """Columns with values, by their names in a table."""
        return {
            name: values
            for name, (key, index, _) in COLUMNS.items()
            if np.isfinite(values := getattr(self, key).T[index]).any()
        }

    def rows(self) -> Iterable[list[str]]:
        """The table as text: names with units, then one row per frame; unknown values are empty cells.

        Yields
        ------
        row : list of str
        """
        known = self._known()
        yield [*(f"{name} [{COLUMNS[name][2]}]" for name in known), "state"]
        for *values, word in zip(*known.values(), self.state, strict=True):
            yield [*("" if np.isnan(value) else repr(float(value)) for value in values), word]

    def __repr__(self) -> str:
        return f"<Track of {self.source or 'a hoop'}: found in {self.found.sum()} of {len(self.t)} frames>"


def track_of(t: Floats, columns: dict[str, Floats], **others: Any) -> Track:
    """Make a track from the known columns; the others are nan.

    t: shape (n,), times [s]; columns: by name in COLUMNS; **others: attributes of the track.
    """
    count, name = len(t), others.get("source") or "The track"
    if count < 3:
        raise InputError(f"{name} has {count} rows; at least 3 are needed.")
    bad = np.flatnonzero(~(np.diff(t, prepend=-np.inf) > 0) | ~np.isfinite(t))
    if len(bad):
        raise InputError(f"{name} must have times that increase, which they do not in row {bad[0] + 1}.")
    arrays: dict[str, Any] = {key: np.full((count, 2) if key in PAIRS else count, np.nan) for key, _, _ in COLUMNS.values()}
    for column, values in {**columns, "t": t}.items():
        key, index, _ = COLUMNS[column]
        arrays[key].T[index] = values
    # drop positions with only one coordinate
    for pair in PAIRS:
        arrays[pair][~np.isfinite(arrays[pair]).all(axis=1)] = np.nan
    track = Track(**arrays, **others)
    if not track.found.any():
        raise InputError(f"{name} has the hoop in no row.")
    return track


def track_from_dict(data: Any, name: str) -> Track:
    """Return the track that `Track.to_dict` wrote.

    name: name of the file, for messages.
    """
    if not isinstance(data, dict) or data.get("schema") != SCHEMA:
        raise InputError(f"{name} is not a track of hophoop ({SCHEMA}).")
    with complete(name):
        columns = {key: np.array(values, dtype=float) for key, values in data["columns"].items() if key in COLUMNS}
        view = None
        if "view" in data:
            lens = Camera(**data["view"]["camera"])  # refuses strange names, as View does; pydantic the values
            view = TypeAdapter(View).validate_python(asdict(View(**{**data["view"], "camera": lens})))
        others = {key: float(data[key]) for key in HEAD if key in data}
        return track_of(
            columns.pop("t"),
            columns,
            placed=bool(data["placed"]),
            view=view,
            source=str(data["source"]),
            notes=tuple(str(note) for note in data["notes"]),
            **others,
        )


# --- JSON ------------------------------------------------------------------------------------------


def write_json(path: str | Path, data: Any, endings: str = ".json") -> None:
    """Write data as JSON, if the name ends so; endings: for the message."""
    file = Path(path)
    if file.suffix.lower() != ".json":
        raise InputError(f"{file} must end in {endings}.")
    with replacing(file) as fresh:
        fresh.write_text(json.dumps(plain(data), ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")


def plain(value: Any) -> Any:
    """Replace nan and infinity, which JSON does not have, by None."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value


def parse_json(text: str, name: str) -> Any:
    """Return the data of a text; name: of its file, for messages."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{name} is not valid JSON: {parse_reason(error)}.") from None


@contextmanager
def complete(name: str) -> Iterator[None]:
    """Refuse data in which something is missing or of another kind; name: of the file, for messages."""
    try:
        yield
    except InputError:
        raise
    except ValidationError as error:
        raise InputError(f"{name}: {input_error(error)}") from None
    except (KeyError, TypeError, IndexError, AttributeError, ValueError) as error:
        raise InputError(f"{name} is incomplete: {error}.") from None
