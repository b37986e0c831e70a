"""Track the hoop in a film: from the places in its pictures to metres along and above the plane."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hophoop.tracking.doubts import DOUBT, doubt_hoop, doubt_marker, doubt_times, repeated, steps_of
from hophoop.tracking.ground import LEAST_ERROR, Ground, ground_line, line_through
from hophoop.tracking.hints import Hints, require_above_0
from hophoop.tracking.looking import Seen, look
from hophoop.tracking.places import Places, find_places
from hophoop.tracking.scatter import spread, third_differences
from hophoop.tracking.table import Track, View, along, track_of

Floats = NDArray[np.float64]

SIDEWAYS = 2.0  # rise or fall of a hoop in a film that lies on its side, over the radius
SCALE_ERROR = 0.5  # error of the rim's radius that all pictures have alike: blur, coding, the width of a drawn line [pixel]
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
    hints, source = hints or Hints(), Path(video).name
    seen = look(video, hints, progress)
    places, notes = _correct_times(find_places(seen, hints, source), seen, hints.rate)
    return _track(_at_one_time(places), notes, seen, hints, radius, source)


def _correct_times(places: Places, seen: Seen, rate: float | None) -> tuple[Places, list[str]]:
    """Leave out repeated pictures, and count a given rate without them; return what there is to say about the times, too."""
    steps = steps_of(places.circle, places.angle)
    again = repeated(seen.changes, steps)
    for values in (places.circle, places.covariance, places.agreement, places.arrow, places.angle, places.marker_pixel):
        values[again] = np.nan
    if rate is not None and again.any():
        right = np.arange(len(again)) - np.cumsum(again) + 0.5 * again  # between the neighbours, for an increasing order
        t = places.t - seen.t + seen.t[0] + right / rate
        return places._replace(t=t), [f"{int(again.sum())} repeated pictures are left out."]
    return places, doubt_times(seen.t, steps, again)


def _at_one_time(places: Places) -> Places:
    """Return the arrows from centre to marker, and their angles, at the exposure of the centre's row.

    With a rolling shutter the marker's row is exposed earlier or later. The motion in between follows from the frames before
    and after.
    """
    t, arrow, angle, late = places.t, places.arrow, places.angle, places.late
    there = np.flatnonzero(np.isfinite(angle))
    if len(there) < 2 or not late[there].any():
        return places
    velocity = np.gradient(places.circle[there, :2], t[there], axis=0)
    omega = np.gradient(angle[there], t[there])
    straight = arrow[there] - velocity * late[there, None]
    bare = np.arctan2(*straight.T)
    whole = bare + 2 * np.pi * np.round((angle[there] - bare) / (2 * np.pi))
    angle[there] = whole - omega * late[there]
    arrow[there] = np.hypot(*straight.T)[:, None] * np.stack([np.sin(angle[there]), np.cos(angle[there])], axis=-1)
    return places


def _track(places: Places, notes: list[str], seen: Seen, hints: Hints, radius: float, source: str) -> Track:
    """Convert rectified pixels to metres along and above the plane; radius [m]; source: name of the film."""
    camera, circle, arrow = places.camera, places.circle, places.arrow
    there, marked = np.isfinite(circle[:, 0]), np.isfinite(places.angle)
    size = float(np.median(circle[there, 2]))
    scale = size / radius
    if hints.ground is not None:
        ends = camera.to_plane(np.reshape(np.array(hints.ground, dtype=float), (2, 2)))
        line = line_through(ends[0], ends[1], size)
    else:
        line = ground_line(circle[there, :2], np.sqrt(places.covariance[there, 2]), size)
    turn, base = along(line.angle), np.array([line.x, line.y])
    origin = base + ((circle[there][0, :2] - base) @ turn[0]) * turn[0]
    place = (circle[:, :2] - origin) @ turn.T / scale + [0.0, radius]
    variances = np.einsum("ik,nkl,il->ni", turn, places.covariance[:, [[0, 1], [1, 2]]], turn)
    error = np.sqrt(variances + LEAST_ERROR**2) / scale
    reach = np.hypot(*arrow.T)
    across = _marker_error(places.t, reach, places.angle, error.mean(axis=1) * scale)
    marker, pixel = place + arrow @ turn.T / scale, camera.to_picture(circle[:, :2])
    columns: dict[str, Floats] = {
        "x": place[:, 0], "y": place[:, 1], "sigma_x": error[:, 0], "sigma_y": error[:, 1],
        "angle": places.angle + line.angle, "sigma_angle": across / reach,
        "marker_x": marker[:, 0], "marker_y": marker[:, 1],
        "sigma_marker": np.hypot(across / scale, error.mean(axis=1)),
        "column": pixel[:, 0], "row": pixel[:, 1],
        "marker_column": places.marker_pixel[:, 0], "marker_row": places.marker_pixel[:, 1],
    }  # fmt: skip
    view = View(
        camera, scale, float(origin[0]), float(origin[1]), line.angle, seen.marker,
        float(np.median(reach[marked])) / size if marked.any() else np.nan,
        hints.exposure, hints.row_delay, hints.rate, SCALE_ERROR / size, line.height_error / scale, line.angle_error,
        seen.first,
    )  # fmt: skip
    doubts = doubt_hoop(circle, places.agreement, float(np.median(np.diff(places.t))), radius, places.tilt) or notes
    if seen.marker is not None:
        doubts += doubt_marker(columns["x"] / radius, columns["angle"])
    slope, slope_error = _slope(line, hints)
    return track_of(
        places.t, columns, radius=radius, placed=True, view=view, source=source, slope=slope, slope_error=slope_error,
        notes=(*doubts, *_notes(places, seen.marker is not None, line, hints)),
    )  # fmt: skip


def _slope(line: Ground, hints: Hints) -> tuple[float, float]:
    """Slope of the plane, downhill to the right, and its error, which is nan for a given slope [rad]."""
    if hints.slope is not None:
        return hints.slope, float("nan")
    error = LEVEL_ERRORS[hints.level is not None]
    return (hints.level or 0.0) - line.angle, float(np.hypot(line.angle_error, error))


def _marker_error(t: Floats, reach: Floats, angle: Floats, least: Floats) -> Floats:
    """Error of the marker across the line to the centre [rectified pixels].

    The smaller one of two upper estimates: the scatter along that line, and third differences of its angle, to which the
    motion adds little in a fast film.
    """
    known = reach[np.isfinite(reach)]
    if not len(known):
        return np.full(len(reach), np.nan)
    scatter = [spread(known)]
    third = third_differences(t, angle)
    if len(third) >= 8:
        scatter.append(spread(third) * float(np.median(known)))
    return np.where(np.isfinite(reach), np.maximum(min(scatter), least), np.nan)


def _notes(places: Places, with_marker: bool, line: Ground, hints: Hints) -> tuple[str, ...]:
    notes, circle, there = [], places.circle, np.isfinite(places.circle[:, 0])
    lost, bare = int((~there).sum()), int((there & np.isnan(places.angle)).sum())
    if lost:
        notes.append(f"The hoop is lost in {lost} of {len(there)} frames.")
    if not with_marker:
        notes.append("No marker was found, so there are no angles.")
    elif bare:
        notes.append(f"The marker is hidden in {bare} frames.")
    if places.doubtful is not None:
        notes.append(f"Whole revolutions may be missing after {places.doubtful:.3f} s, where the marker comes back.")
    if not line.directed and np.ptp(circle[there, 1]) > SIDEWAYS * np.nanmedian(circle[:, 2]):
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
    if any(places.tilt):
        a, b = np.degrees(places.tilt)
        notes.append(f"The plane of motion is tilted by {a:.1f}° and {b:.1f}° about the picture's axes.")
    return tuple(notes)


def _of_plane(line: Ground, hints: Hints) -> list[str]:
    """Say where the plane is, and what is assumed about the camera's level."""
    said = [f"The plane is the line under the hoop in {line.frames} frames."] if hints.ground is None else []
    if hints.slope is None and hints.level is None:
        falls, error = -np.degrees(line.angle), np.degrees(LEVEL_ERRORS[0])
        said.append(
            f"It falls by {falls:z.2f}° to the right in the picture, by the plane's slope and the camera's roll. "
            f"The camera is taken as level to {error:.0f}°: give what you measured (--level-deg, --slope-deg)."
        )
    return said
