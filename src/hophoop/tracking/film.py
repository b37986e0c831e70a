"""Track the hoop in a film: from the places in its pictures to metres along and above the plane."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from hophoop.tracking.camera import pairs
from hophoop.tracking.doubts import DOUBT, doubt_hoop, doubt_marker
from hophoop.tracking.ground import LEAST_ERROR, Ground, ground_line, line_through
from hophoop.tracking.hints import Hints, require_above_0
from hophoop.tracking.looking import Seen, look
from hophoop.tracking.places import Places, find_places
from hophoop.tracking.scatter import Floats, spread, third_differences
from hophoop.tracking.table import Track, View, along, track_of

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
    return _track(find_places(seen, hints, source), seen, hints, radius, source)


def _track(places: Places, seen: Seen, hints: Hints, radius: float, source: str) -> Track:
    """Convert rectified pixels to metres along and above the plane; radius [m]; source: name of the film."""
    camera, size, centre = places.camera, places.radius, places.centre
    there, scale = np.isfinite(places.agreement), size / radius
    if hints.ground is not None:
        line = line_through(camera.to_plane(np.reshape(hints.ground, (2, 2))), size)
    else:
        line = ground_line(pairs(centre[there]), np.sqrt(places.covariance[there, 1, 1]), size)
    level, base, turn = np.exp(-1j * line.angle), complex(line.x, line.y), along(line.angle)
    origin = base + ((centre[there][0] - base) * level).real / level
    place = (centre - origin) * level / scale + 1j * radius
    error = np.sqrt(np.einsum("ik,nkl,il->in", turn, places.covariance, turn) + LEAST_ERROR**2) / scale
    angle, across = places.angle + line.angle, _marker_error(places, error.mean(axis=0) * scale)
    marker = place + 1j * places.reach / scale * np.exp(-1j * angle)
    pixel = camera.to_picture(pairs(centre)).T
    columns: dict[str, Floats] = {
        "x": place.real, "y": place.imag, "sigma_x": error[0], "sigma_y": error[1],
        "angle": angle, "sigma_angle": across / places.reach,
        "marker_x": marker.real, "marker_y": marker.imag, "sigma_marker": np.hypot(across / scale, error.mean(axis=0)),
        "column": pixel[0], "row": pixel[1],
        "marker_column": places.marker_pixel.real, "marker_row": places.marker_pixel.imag,
    }  # fmt: skip
    chroma = None if seen.marker is None else (seen.marker.chroma.real, seen.marker.chroma.imag)
    view = View(
        camera, scale, float(origin.real), float(origin.imag), line.angle, chroma, places.usual_reach / size,
        hints.exposure, hints.row_delay, hints.rate, SCALE_ERROR / size, line.height_error / scale, line.angle_error,
        seen.first,
    )  # fmt: skip
    fresh, tilt = ~places.again, max(abs(camera.tilt_x), abs(camera.tilt_y))
    step = float(np.median(np.diff(places.t[fresh])))
    doubts = doubt_hoop(centre[fresh] / size, places.agreement, step, radius, tilt) or places.notes
    if chroma is not None:
        doubts += doubt_marker(place.real / radius, angle)
    slope, slope_error = hints.slope, float("nan")
    if slope is None:
        slope = (hints.level or 0.0) - line.angle
        slope_error = float(np.hypot(line.angle_error, LEVEL_ERRORS[hints.level is not None]))
    return track_of(
        places.t, columns, radius=radius, placed=True, view=view, source=source, slope=slope, slope_error=slope_error,
        notes=(*doubts, *_notes(places, chroma is not None, line, hints)),
    )  # fmt: skip


def _marker_error(places: Places, least: Floats) -> Floats:
    """Error of the marker across the line to the centre [rectified pixels].

    The smaller one of two upper estimates: the scatter along that line, and third differences of its angle, to which the
    motion adds little in a fast film.
    """
    known = places.reach[np.isfinite(places.reach)]
    if not len(known):
        return places.reach
    scatter, third = spread(known), third_differences(places.t, places.angle)
    if len(third) >= 8:
        scatter = min(scatter, spread(third) * places.usual_reach)
    return np.where(np.isfinite(places.reach), np.maximum(scatter, least), np.nan)


def _notes(places: Places, with_marker: bool, line: Ground, hints: Hints) -> tuple[str, ...]:
    notes, there = [], np.isfinite(places.agreement)
    lost, bare = (~there & ~places.again).sum(), (there & np.isnan(places.angle)).sum()
    heights, size = places.centre[there].imag, places.radius
    if lost:
        notes.append(f"The hoop is lost in {lost} of {len(there)} frames.")
    if not with_marker:
        notes.append("No marker was found, so there are no angles.")
    elif bare:
        notes.append(f"The marker is hidden in {bare} frames.")
    if places.doubtful is not None:
        notes.append(f"Whole revolutions may be missing after {places.doubtful:.3f} s, where the marker comes back.")
    if not line.directed and np.ptp(heights) > SIDEWAYS * size:
        notes.append(f"{DOUBT}the hoop moves up or down the picture. Is the film sideways? Turn it, and track it again.")
    elif not line.directed:
        notes.append("The hoop stays in one place, so the slope is unknown; the picture's rows are taken as level.")
    elif hints.ground is None:
        notes.append(f"The plane is the line under the hoop in {line.frames} frames.")
    if line.directed and hints.slope is None and hints.level is None:
        notes.append(
            f"It falls by {-np.degrees(line.angle):z.2f}° to the right in the picture, by the plane's slope and the camera's "
            f"roll. The camera is taken as level to {np.degrees(LEVEL_ERRORS[0]):.0f}°: give what you measured (--level-deg, "
            "--slope-deg)."
        )
    if size < SMALL:
        notes.append(
            f"The rim has a radius of only {size:.0f} pixels in the picture, so the scale is uncertain by "
            f"{100 * SCALE_ERROR / size:.1g} %: film from nearer or zoom in, up to 100 pixels or more."
        )
    if hints.tilt is None and any(tilt := np.degrees([places.camera.tilt_x, places.camera.tilt_y])):
        notes.append(f"The plane of motion is tilted by {tilt[0]:.1f}° and {tilt[1]:.1f}° about the picture's axes.")
    return tuple(notes)
