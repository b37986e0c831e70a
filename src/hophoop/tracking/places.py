"""Where centre and marker are in each picture, with one camera and one radius for the whole film."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.tracking.camera import USUAL_FOCAL, Camera, fit_camera
from hophoop.tracking.circle import UNKNOWN, CircleFit, fit_circle, robust_circle
from hophoop.tracking.doubts import Flags, doubt_times, repeated, steps_of
from hophoop.tracking.hints import Hints
from hophoop.tracking.looking import Seen
from hophoop.tracking.marker import choose_spots, count_revolutions
from hophoop.tracking.rim import RAYS, WANTED, Rim

Floats = NDArray[np.float64]

MOST_FOR_CAMERA = 14
WHOLE = 0.6  # share of a rim in the picture that gives its radius
TIGHT = 0.004  # relative error of the radius of all pictures
UNLIKE = 0.1  # relative difference from it that no picture of the hoop has, also through a lens that distorts
FAR = 0.1  # distance of an edge from the first circle through it, over the radius, above which it is none of the rim's


class Places(NamedTuple):
    """Centre and marker in each frame, in rectified pixels, nan where nothing was found."""

    camera: Camera
    tilt: tuple[float, float]  # of the camera, if it was found in the film, otherwise 0 [rad]
    t: Floats  # of the exposure of the centre's row, from the file [s]
    circle: Floats  # shape (n, 3)
    covariance: Floats  # of the centre: xx, xy, yy
    agreement: Floats  # share of the whole rim that is seen [1]
    reach: Floats  # distance of the marker from the centre
    angle: Floats  # of the line to the marker from up, clockwise, without jumps, at the exposure of the centre's row [rad]
    marker_pixel: Floats  # shape (n, 2) [pixel]
    doubtful: float | None  # time after which whole revolutions may be missing [s]
    notes: list[str]  # on the times


def find_places(seen: Seen, hints: Hints, source: str) -> Places:
    """Find camera, radius and marker in what the pictures show; source: name of the film."""
    rims = {k: rim for k, rim in enumerate(seen.rims) if rim is not None}
    _require_frames(len(rims), source)
    velocity = np.gradient(np.array([rim.circle[:2] for rim in rims.values()]), seen.t[[*rims]], axis=0)
    edges = [  # a rolling shutter shears what moves
        rim.points - np.outer(rim.points[:, 1] - rim.circle.y, hints.row_delay * speed)
        for rim, speed in zip(rims.values(), velocity, strict=True)
    ]
    camera, tilt = _camera(seen.size, edges, hints.exposure * np.hypot(*velocity.T), hints)
    circle, covariance, agreement = _circles(camera, rims, edges, len(seen.t))
    pixel = np.where(np.isfinite(circle[:, :2]), choose_spots(seen.spots), np.nan)
    centre, mark = circle[:, :2], camera.to_plane(pixel)
    again, t, notes = _times(seen, circle, _arrows(seen.t, centre, mark, np.zeros(len(seen.t)))[1], hints.rate)
    for values in (circle, covariance, agreement, pixel, mark):
        values[again] = np.nan
    there = np.isfinite(agreement)
    _require_frames(int(there.sum()), source)
    row = camera.to_picture(centre)[:, 1]
    t = t + 0.5 * hints.exposure + hints.row_delay * np.interp(t, t[there], row[there])
    reach, angle, doubtful = _arrows(t, centre, mark, hints.row_delay * (pixel[:, 1] - row))
    return Places(camera, tilt, t, circle, covariance, agreement, reach, angle, pixel, doubtful, notes)


def _times(seen: Seen, circle: Floats, angle: Floats, rate: float | None) -> tuple[Flags, Floats, list[str]]:
    """Return which pictures repeat the one before, times that count a given rate without them, and remarks on these."""
    steps = steps_of(circle, angle)
    again = repeated(seen.changes, steps)
    if rate is None or not again.any():
        return again, seen.t, doubt_times(seen.t, steps, again)
    counted = np.arange(len(again)) - np.cumsum(again) + 0.5 * again  # between the neighbours, for an increasing order
    return again, seen.t[0] + counted / rate, [f"{int(again.sum())} repeated pictures are left out."]


def _require_frames(count: int, source: str) -> None:
    if count < 3:
        raise InputError(f"{source} shows the hoop in {count} frames; tracking needs at least 3.")


def _camera(size: tuple[int, int], edges: list[Floats], blur: Floats, hints: Hints) -> tuple[Camera, tuple[float, float]]:
    """Return the camera as hinted, or tilted as found, so that the rim has one radius; and what was found.

    blur: way of the hoop during each exposure [pixel].
    """
    camera = Camera(*size, hints.focal or USUAL_FOCAL * max(size), *(hints.tilt or (0.0, 0.0)))
    if hints.tilt is not None or len(edges) < 4:
        return camera, (0.0, 0.0)
    chosen = np.unique(np.linspace(0, len(edges) - 1, MOST_FOR_CAMERA).astype(int))
    camera = fit_camera(camera, [edges[k] for k in chosen], hints.focal is not None, blur[chosen])
    return camera, (camera.tilt_x, camera.tilt_y)


def _circles(camera: Camera, rims: dict[int, Rim], edges: list[Floats], count: int) -> tuple[Floats, Floats, Floats]:
    """Fit circles of one radius to the edges; return circles, covariances and agreement of all frames."""
    flat = [camera.to_plane(points) for points in edges]
    whole = [points for points in flat if len(points) > WHOLE * RAYS] or flat
    sizes = [fit.circle.radius for points in whole if (fit := _fit(points, UNKNOWN)) is not None]
    size = float(np.median(sizes or [rim.circle.radius for rim in rims.values()]))
    found = np.full((count, 7), np.nan)
    for (k, rim), points in zip(rims.items(), flat, strict=True):
        fit = _fit(points, (size, TIGHT * size))
        if fit is not None and fit.inside.sum() >= WANTED * rim.looked and abs(fit.circle.radius - size) <= UNLIKE * size:
            found[k] = [*fit.circle, *fit.covariance[[0, 0, 1], [0, 1, 1]], fit.inside.sum() / RAYS]
    return found[:, :3], found[:, 3:6], found[:, 6]


def _fit(points: Floats, expected: tuple[float, float]) -> CircleFit | None:
    start, _ = fit_circle(points)
    return robust_circle(points, start, FAR * start.radius, expected)


def _arrows(t: Floats, centre: Floats, mark: Floats, late: Floats) -> tuple[Floats, Floats, float | None]:
    """Return length and angle of the line from centre to marker, and the time after which revolutions may be missing.

    late: delay of the exposure of the marker's row after that of the centre's, by a rolling shutter [s]; the motion in between
    follows from the frames before and after.
    """
    arrow, there = mark - centre, np.isfinite(mark[:, 0])
    moves = there.sum() > 1
    if moves:
        arrow[there] -= late[there, None] * np.gradient(centre[there], t[there], axis=0)
    angle, doubtful = count_revolutions(t, np.arctan2(*arrow.T))
    if moves:
        angle[there] -= late[there] * np.gradient(angle[there], t[there])
    return np.hypot(*arrow.T), angle, doubtful
