"""Where centre and marker are in each picture, with one camera and one radius for the whole film."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.scenario import InputError
from hophoop.tracking.camera import USUAL_FOCAL, Camera, fit_camera, flat, pairs
from hophoop.tracking.circle import UNKNOWN, CircleFit, fit_circle, robust_circle
from hophoop.tracking.doubts import count_taken, doubt_times, repeated, steps_of
from hophoop.tracking.hints import Hints
from hophoop.tracking.looking import Seen
from hophoop.tracking.marker import choose_spots, count_revolutions
from hophoop.tracking.rim import RAYS, WANTED, Rim
from hophoop.tracking.scatter import NOWHERE, Complexes, Flags, Floats

MOST_FOR_CAMERA = 14
WHOLE = 0.6  # share of a rim in the picture that gives its radius
TIGHT = 0.004  # relative error of the radius of all pictures
UNLIKE = 0.1  # relative difference from it that no picture of the hoop has, also through a lens that distorts
FAR = 0.1  # distance of an edge from the first circle through it, over the radius, above which it is none of the rim's


class Places(NamedTuple):
    """Centre and marker in each frame, in the complex plane of rectified pixels, nan where nothing was found."""

    camera: Camera
    t: Floats  # of the exposure of the centre's row, from the file [s]
    centre: Complexes
    covariance: Floats  # of the centre, shape (n, 2, 2)
    radius: float  # of the rim in all frames
    agreement: Floats  # share of the whole rim that is seen [1]
    reach: Floats  # distance of the marker from the centre
    angle: Floats  # of the line to the marker from up, clockwise, without jumps, at the exposure of the centre's row [rad]
    marker_pixel: Complexes
    doubtful: float | None  # time after which whole revolutions may be missing [s]
    again: Flags  # pictures that repeat the one before
    notes: list[str]  # on the times

    @property
    def usual_reach(self) -> float:
        """Median distance of the marker from the centre."""
        known = self.reach[np.isfinite(self.reach)]
        return float(np.median(known)) if len(known) else np.nan


def find_places(seen: Seen, hints: Hints, source: str) -> Places:
    """Find camera, radius and marker in what the pictures show; source: name of the film."""
    rims = {k: rim for k, rim in enumerate(seen.rims) if rim is not None}
    _require_frames(len(rims), source)
    velocity = np.gradient([rim.circle.centre for rim in rims.values()], seen.t[[*rims]])
    edges = [  # a rolling shutter shears what moves
        rim.points - hints.row_delay * speed * (rim.points - rim.circle.centre).imag
        for rim, speed in zip(rims.values(), velocity, strict=True)
    ]
    camera = _camera(seen.size, edges, hints.exposure * np.abs(velocity), hints)
    centre, covariance, radius, agreement = _circles(camera, rims, edges, len(seen.t))
    pixel = np.where(np.isfinite(centre), choose_spots(seen.spots), NOWHERE)
    mark = flat(camera, pixel)
    again, t, notes = _times(seen, steps_of(centre, mark, radius), hints.rate)
    for values in (centre, covariance, agreement, pixel, mark):
        values[again] = np.nan
    there = np.isfinite(agreement)
    _require_frames(int(there.sum()), source)
    row = camera.to_picture(pairs(centre))[:, 1]
    t = t + 0.5 * hints.exposure + hints.row_delay * np.interp(t, t[there], row[there])
    reach, angle, doubtful = _arrows(t, centre, mark, hints.row_delay * (pixel.imag - row))
    return Places(camera, t, centre, covariance, radius, agreement, reach, angle, pixel, doubtful, again, notes)


def _times(seen: Seen, steps: Floats, rate: float | None) -> tuple[Flags, Floats, list[str]]:
    """Return which pictures repeat the one before, times that count a given rate without them, and remarks on these."""
    again = repeated(seen.changes, steps)
    if rate is None or not again.any():
        return again, seen.t, doubt_times(seen.t, steps, again)
    return again, seen.t[0] + count_taken(steps, again) / rate, [f"{again.sum()} repeated pictures are left out."]


def _require_frames(count: int, source: str) -> None:
    if count < 3:
        raise InputError(f"{source} shows the hoop in {count} frames; tracking needs at least 3.")


def _camera(size: tuple[int, int], edges: list[Complexes], blur: Floats, hints: Hints) -> Camera:
    """Return the camera as hinted, or tilted so that the rim has one radius; blur: way of the hoop in each exposure [pixel]."""
    camera = Camera(*size, hints.focal or USUAL_FOCAL * max(size), *(hints.tilt or (0.0, 0.0)))
    if hints.tilt is not None or len(edges) < 4:
        return camera
    chosen = np.unique(np.linspace(0, len(edges) - 1, MOST_FOR_CAMERA).astype(int))
    return fit_camera(camera, [edges[k] for k in chosen], hints.focal is not None, blur[chosen])


def _circles(
    camera: Camera, rims: dict[int, Rim], edges: list[Complexes], count: int
) -> tuple[Complexes, Floats, float, Floats]:
    """Fit circles of one radius to the edges; return centres, their covariances, the radius and the agreement of all frames."""
    planar = [flat(camera, points) for points in edges]
    whole = [points for points in planar if len(points) > WHOLE * RAYS] or planar
    sizes = [fit.circle.radius for points in whole if (fit := _fit(points, UNKNOWN)) is not None]
    size = float(np.median(sizes or [rim.circle.radius for rim in rims.values()]))
    centre, covariance, agreement = np.full(count, NOWHERE), np.full((count, 2, 2), np.nan), np.full(count, np.nan)
    for (k, rim), points in zip(rims.items(), planar, strict=True):
        fit = _fit(points, (size, TIGHT * size))
        if fit is not None and fit.inside.sum() >= WANTED * rim.looked and abs(fit.circle.radius - size) <= UNLIKE * size:
            centre[k], covariance[k], agreement[k] = fit.circle.centre, fit.covariance[:2, :2], fit.inside.sum() / RAYS
    return centre, covariance, size, agreement


def _fit(points: Complexes, expected: tuple[float, float]) -> CircleFit | None:
    start, _ = fit_circle(points)
    return robust_circle(points, start, FAR * start.radius, expected)


def _arrows(t: Floats, centre: Complexes, mark: Complexes, late: Floats) -> tuple[Floats, Floats, float | None]:
    """Return length and angle of the line from centre to marker, and the time after which revolutions may be missing.

    late: delay of the exposure of the marker's row after that of the centre's, by a rolling shutter [s]; the motion in between
    follows from the frames before and after.
    """
    arrow, there = mark - centre, np.isfinite(mark)
    moves = there.sum() > 1
    if moves:
        arrow[there] -= late[there] * np.gradient(centre[there], t[there])
    angle, doubtful = count_revolutions(t, np.arctan2(arrow.real, arrow.imag))
    if moves:
        angle[there] -= late[there] * np.gradient(angle[there], t[there])
    return np.abs(arrow), angle, doubtful
