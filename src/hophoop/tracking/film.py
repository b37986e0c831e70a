"""Track the hoop in a film."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.tracking.doubts import DOUBT, doubt_hoop, doubt_marker, doubt_times, repeated, steps_of
from hophoop.tracking.following import Follower, Frame
from hophoop.tracking.ground import Ground, ground_line, line_through
from hophoop.tracking.hints import Hints, require_above_0
from hophoop.tracking.learning import FilmSetup, learn
from hophoop.tracking.scatter import spread, third_differences
from hophoop.tracking.table import FOUND, LOST, UNMARKED, Track, View, track_of
from hophoop.tracking.video import picture_times, pictures, sample_pictures

Floats = NDArray[np.float64]

SIDEWAYS = 2.0  # rise or fall of a hoop in a film that lies on its side, over the radius
LEAST_ERROR = 0.02  # minimum error of a centre, from lens and sensor [pixel]
SCALE_ERROR = 0.5  # error of the rim's radius that all pictures have alike: blur, coding, the width of a drawn line [pixel]
LONGEST = 120.0  # film without a window that is tracked [s]
SMALL = 40.0  # radius of a rim that deserves a word [pixel]
LEVEL_ERRORS = float(np.radians(2.0)), float(np.radians(0.1))  # of a camera that nobody levelled, and of a given level [rad]


def track(
    video: str | Path, radius: float, hints: Hints | None = None, progress: Callable[[int, int | None], None] | None = None
) -> Track:
    """Find a hoop in every frame of a film.

    Parameters
    ----------
    video : str or Path
        Anything that FFmpeg reads; times are those of its frames.
    radius : float
        Outer radius of the rim, which gives the scale [m].
    hints : Hints, optional
        Known properties of the film.
    progress : callable, optional
        Called with the number of frames done and of all, None if unknown.

    Returns
    -------
    track : Track
        Frames in which the hoop was not found are marked as lost.

    Raises
    ------
    ValueError
        If the file is no video, shows no hoop, or a value is not allowed.
    OSError
        If the file cannot be opened.
    ImportError
        If PyAV or SciPy is missing.
    """
    require_above_0(radius=radius)
    hints = hints or Hints()
    source = Path(video).name
    window = (hints.rate, hints.since, hints.until)
    span = picture_times(video, *window)
    if len(span) and span[-1] - span[0] > LONGEST:
        raise InputError(
            f"{source} lasts {span[-1] - span[0]:.0f} s, and a hoop moves freely for seconds: say from when until when, "
            "such as by --from 12.5 --to 15 (since and until in Hints)."
        )
    known = learn(sample_pictures(video, *window), hints, source)
    follower = Follower(known.search, known.marker, hints.exposure, hints.row_delay)
    first, times, changes, before = 0, [], [], None
    for k, picture in enumerate(pictures(video, *window)):
        if picture.size != (known.search.camera.width, known.search.camera.height):
            raise InputError(f"{source} has pictures of different sizes.")
        follower.add(picture)
        first = picture.row - k
        times.append(picture.t)
        small = picture.luma[::2, ::2].astype(np.int16)
        changes.append(np.nan if before is None else float(np.abs(small - before).mean()))
        before = small
        if progress is not None:
            progress(k + 1, len(span))
    rows, notes = _correct_times(follower.rows, np.array(times), np.array(changes), hints.rate)
    return _track_from_rows(rows, known, hints, radius, source, first, notes)


def _correct_times(rows: Frame, t: Floats, changes: Floats, rate: float | None) -> tuple[Frame, list[str]]:
    """Leave out repeated pictures, and count a given rate without them; return what there is to say about the times, too."""
    if np.isfinite(rows.circle[:, 0]).sum() < 3:
        return rows, []
    steps = steps_of(rows.circle, rows.angle)
    again = repeated(changes, steps)
    for values in (rows.circle, rows.covariance, rows.agreement, rows.arrow, rows.angle, rows.marker_pixel):
        values[again] = np.nan
    if rate is not None and again.any():
        right = np.arange(len(t)) - np.cumsum(again) + 0.5 * again  # between the neighbours, for an increasing order
        return rows._replace(t=rows.t - t + t[0] + right / rate), [f"{int(again.sum())} repeated pictures are left out."]
    return rows, doubt_times(t, steps, again)


def _track_from_rows(
    rows: Frame, known: FilmSetup, hints: Hints, radius: float, source: str, first: int, notes: list[str]
) -> Track:
    """Convert rectified pixels to metres along and above the plane."""
    t, circle, covariance = rows.t, rows.circle, rows.covariance
    arrow, angle = _at_one_time(rows)
    camera = known.search.camera
    there = np.isfinite(circle[:, 0])
    if there.sum() < 3:
        raise InputError(f"{source} shows the hoop in {int(there.sum())} frames; tracking needs at least 3.")
    size = float(np.median(circle[there, 2]))
    scale = size / radius
    if hints.ground is not None:
        ends = camera.to_plane(np.reshape(np.array(hints.ground, dtype=float), (2, 2)))
        line = line_through(ends[0], ends[1], size)
    else:
        line = ground_line(circle[there, :2], np.sqrt(covariance[there, 2]), size)
    cos, sin = np.cos(line.angle), np.sin(line.angle)
    turn = np.array([[cos, sin], [-sin, cos]])  # from the picture's axes to those of the plane
    base = np.array([line.x, line.y])
    origin = base + ((circle[there][0, :2] - base) @ turn[0]) * turn[0]
    place = (circle[:, :2] - origin) @ turn.T / scale + [0.0, radius]
    variances = np.einsum("ik,nkl,il->ni", turn, covariance[:, [[0, 1], [1, 2]]], turn)
    error = np.sqrt(variances + LEAST_ERROR**2) / scale
    ratio = float("nan") if known.marker is None else known.marker.ratio
    marker_error = _marker_error(t, arrow, angle, covariance) / scale
    reach = np.hypot(arrow[:, 0], arrow[:, 1]) / scale
    marker = place + arrow @ turn.T / scale
    pixel = camera.to_picture(circle[:, :2])
    columns: dict[str, Floats] = {
        "x": place[:, 0], "y": place[:, 1], "sigma_x": error[:, 0], "sigma_y": error[:, 1],
        "angle": angle + line.angle, "sigma_angle": marker_error / reach,
        "marker_x": marker[:, 0], "marker_y": marker[:, 1],
        "sigma_marker": np.hypot(marker_error, error.mean(axis=1)),
        "column": pixel[:, 0], "row": pixel[:, 1],
        "marker_column": rows.marker_pixel[:, 0], "marker_row": rows.marker_pixel[:, 1],
    }  # fmt: skip
    marked = np.isfinite(columns["angle"])
    state = [FOUND if b else UNMARKED if a else LOST for a, b in zip(there, marked, strict=True)]
    view = View(
        camera, scale, float(origin[0]), float(origin[1]), line.angle,
        None if known.marker is None else (known.marker.blue, known.marker.red), ratio,
        hints.exposure, hints.row_delay, hints.rate, SCALE_ERROR / size, line.height_error / scale, line.angle_error,
        first,
    )  # fmt: skip
    slope, slope_error = _slope(line, hints)
    others: dict[str, Any] = {
        "radius": radius, "placed": True, "view": view, "source": source, "slope": slope, "slope_error": slope_error,
    }  # fmt: skip
    tilt = (camera.tilt_x, camera.tilt_y) if known.tilted else (0.0, 0.0)
    doubts = doubt_hoop(circle, rows.agreement, float(np.median(np.diff(t))), radius, tilt) or notes
    if known.marker is not None:
        doubts += doubt_marker(columns["x"] / radius, columns["angle"])
    return track_of(t, columns, state, notes=(*doubts, *_notes(rows, state, known, line, hints)), **others)


def _slope(line: Ground, hints: Hints) -> tuple[float, float]:
    """Slope of the plane, downhill to the right, and its error, which is nan for a given slope [rad]."""
    if hints.slope is not None:
        return hints.slope, float("nan")
    error = LEVEL_ERRORS[hints.level is not None]
    return (hints.level or 0.0) - line.angle, float(np.hypot(line.angle_error, error))


def _at_one_time(rows: Frame) -> tuple[Floats, Floats]:
    """Return arrows from centre to marker, and their angles, at the exposure of the centre's row.

    With a rolling shutter the marker's row is exposed earlier or later. The motion in between follows from the frames before
    and after.
    """
    t, arrow, angle, late = rows.t, rows.arrow, rows.angle, rows.late
    there = np.flatnonzero(np.isfinite(angle))
    if len(there) < 2 or not late.any():
        return arrow, angle
    velocity = np.gradient(rows.circle[there, :2], t[there], axis=0)
    omega = np.gradient(angle[there], t[there])
    straight = arrow[there] - velocity * late[there, None]
    turned = np.exp(1j * omega * late[there])  # the rotation to undo, counterclockwise
    back = (straight[:, 0] + 1j * straight[:, 1]) * turned
    arrow[there] = np.column_stack([back.real, back.imag])
    bare = np.arctan2(back.real, back.imag)
    angle[there] = bare + 2 * np.pi * np.round((angle[there] - bare) / (2 * np.pi))
    return arrow, angle


def _marker_error(t: Floats, arrow: Floats, angle: Floats, covariance: Floats) -> Floats:
    """Error of the marker across the line to the centre [rectified pixels].

    The smaller one of two upper estimates: the scatter along that line, and third differences of its angle, to which the
    motion adds little in a fast film.
    """
    reach = np.hypot(arrow[:, 0], arrow[:, 1])
    known = reach[np.isfinite(reach)]
    if not len(known):
        return np.full(len(reach), np.nan)
    scatter = [spread(known)]
    third = third_differences(t, angle)
    if len(third) >= 8:
        scatter.append(spread(third) * float(np.median(known)))
    least = np.sqrt(np.maximum(0.5 * (covariance[:, 0] + covariance[:, 2]), LEAST_ERROR**2))
    return np.where(np.isfinite(reach), np.maximum(min(scatter), least), np.nan)


def _notes(rows: Frame, state: list[str], known: FilmSetup, line: Ground, hints: Hints) -> tuple[str, ...]:
    notes = []
    lost, bare = state.count(LOST), state.count(UNMARKED)
    if lost:
        notes.append(f"The hoop is lost in {lost} of {len(state)} frames.")
    if known.marker is None:
        notes.append("No marker was found, so there are no angles.")
    elif bare:
        notes.append(f"The marker is hidden in {bare} frames.")
    if rows.uncertain.any():
        notes.append(f"Whole revolutions may be missing after {rows.t[rows.uncertain][0]:.3f} s, where the marker comes back.")
    circle = rows.circle
    if not line.directed and np.ptp(circle[np.isfinite(circle[:, 0]), 1]) > SIDEWAYS * np.nanmedian(circle[:, 2]):
        notes.append(f"{DOUBT}the hoop moves up or down the picture. Is the film sideways? Turn it, and track it again.")
    elif not line.directed:
        notes.append("The hoop stays in one place, so the slope is unknown; the picture's rows are taken as level.")
    else:
        notes += _of_plane(line, hints)
    size = float(np.nanmedian(circle[:, 2]))
    if size < SMALL:
        notes.append(
            f"The rim has a radius of only {size:.0f} pixels in the picture, so the scale is uncertain by "
            f"{100 * SCALE_ERROR / size:.1g} %: film from nearer or zoom in, up to 100 pixels or more."
        )
    if known.tilted:
        a, b = np.degrees([known.search.camera.tilt_x, known.search.camera.tilt_y])
        notes.append(f"The plane of motion is tilted by {a:.1f}° and {b:.1f}° about the picture's axes.")
    return tuple(notes)


def _of_plane(line: Ground, hints: Hints) -> list[str]:
    """Say where the plane is, and what is assumed about the camera's level."""
    said = [f"The plane is the line under the hoop in {line.frames} frames."] if hints.ground is None else []
    if hints.slope is None and hints.level is None:
        falls, error = -np.degrees(line.angle), np.degrees(LEVEL_ERRORS[0])
        said.append(
            f"It falls by {falls:.2f}° to the right in the picture, by the plane's slope and the camera's roll. "
            f"The camera is taken as level to {error:.0f}°: give what you measured (--level-deg, --slope-deg)."
        )
    return said
