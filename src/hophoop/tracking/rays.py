"""The rim's outer edge: the steepest point on each ray from the centre, to a fraction of a pixel."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.tracking.camera import Camera
from hophoop.tracking.circle import Circle, CircleFit, robust_circle
from hophoop.tracking.video import Bytes

Floats = NDArray[np.float64]

RAYS = 180
WIDE = 5  # samples on either side of the steepest one, averaged for its position
WEAKEST = 4.0  # rise of luma over two pixels that counts as an edge
CLOSE = 4.0  # reach of the last search [pixel]


class Edges(NamedTuple):
    """Points of an edge, one per ray that has it."""

    points: Floats  # in rectified pixels, shape (n, 2)
    angles: Floats  # of the rays [rad]
    offsets: Floats  # outwards from the circle of the search [pixel]
    strength: Floats  # rise of luma over two pixels [1]
    rows: Floats  # of the picture [pixel]
    looked: int  # rays that lie in the picture


class Rim(NamedTuple):
    """A rim found in a picture."""

    circle: Circle  # in rectified pixels
    covariance: Floats  # [pixel²]
    share: float  # of the rays in the picture that agree [1]
    seen: float  # share of the circumference that lies in the picture [1]
    spread: float  # of the edge about the circle [pixel]
    points: Floats  # of the agreeing edge, corrected for the rolling shutter [rectified pixels]


def profile(luma: Bytes, camera: Camera, circle: Circle, angles: Floats, offsets: Floats) -> tuple[Floats, Floats, Floats]:
    """Sample luma along rays.

    luma shape (height, width) [1]; angles: shape (n,), of the rays [rad]; offsets: shape (k,), from the circle, outwards
    [pixel]; values: shape (n, k), nan outside the picture [1]; points: shape (n, k, 2), their positions [rectified pixels];
    pixels: shape (n, k, 2), the same in the picture [pixel].
    """
    ndimage = need("scipy.ndimage", "track")
    away = circle.radius + offsets
    points = np.array([circle.x, circle.y]) + away[:, None] * np.stack([np.cos(angles), np.sin(angles)], -1)[:, None, :]
    pixels = camera.to_picture(points)
    values = ndimage.map_coordinates(luma, [pixels[..., 1], pixels[..., 0]], output=np.float32, order=1, mode="nearest")
    inside = ((pixels >= 0) & (pixels <= np.array([camera.width - 1, camera.height - 1]))).all(axis=-1)
    return np.where(inside, values, np.nan), points, pixels


def edges(luma: Bytes, camera: Camera, circle: Circle, sign: int, reach: float, step: float = 0.5) -> Edges:
    """Find the steepest point on each ray near a circle.

    luma shape (height, width) [1]; sign: 1 if luma rises outwards, as at a dark hoop; 0 for edges of either sign; reach:
    maximum distance from the circle [pixel]; step: between samples [pixel].
    """
    angles = (np.arange(RAYS) + 0.5) * 2 * np.pi / RAYS
    apart = round(1.0 / step)
    offsets = np.arange(-reach - 1.0, reach + 1.0 + 0.5 * step, step)
    values, points, pixels = profile(luma, camera, circle, angles, offsets)
    rise = values[:, 2 * apart :] - values[:, : -2 * apart]
    rise = sign * rise if sign else np.abs(rise)
    offsets, points, pixels = offsets[apart:-apart], points[:, apart:-apart], pixels[:, apart:-apart]
    there = np.isfinite(rise).all(axis=1)
    rise = np.where(np.isfinite(rise), rise, 0.0).clip(0.0)
    best = np.argmax(rise * (1.0 - 0.4 * (offsets / (reach + 1.0)) ** 2), axis=1)
    rows = np.arange(RAYS)
    strength = rise[rows, best]
    good = there & (strength >= max(WEAKEST, 0.25 * float(np.median(strength[there])) if there.any() else WEAKEST))
    place = best[:, None] + np.arange(-WIDE, WIDE + 1)
    fair = (place >= 0) & (place < len(offsets))
    place = place.clip(0, len(offsets) - 1)
    # only the peak around the steepest point, not a neighbouring one
    weight = np.where(fair, rise[rows[:, None], place], 0.0)
    weight = np.where(weight > 0.2 * strength[:, None], weight, 0.0)
    mean = (weight * offsets[place]).sum(axis=1) / np.maximum(weight.sum(axis=1), 1e-9)
    direction = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    found = np.array([circle.x, circle.y]) + (circle.radius + mean)[:, None] * direction
    return Edges(found[good], angles[good], mean[good], strength[good], pixels[rows, best, 1][good], int(there.sum()))


def find_rim(
    luma: Bytes,
    camera: Camera,
    circle: Circle,
    sign: int,
    reach: float,
    expected: tuple[float, float] | None,
    lean: tuple[float, float] = (0.0, 0.0),
) -> Rim | None:
    """Find the rim near a circle.

    luma shape (height, width) [1]; circle: start of the search; sign: 1 for a dark hoop; reach: maximum distance from the
    circle [pixel]; expected: radius and its error [pixel]; lean: displacement of the hoop per row of the rolling shutter
    [rectified pixels per row].
    """
    fit: CircleFit | None = None
    for close in (reach, CLOSE):
        found = edges(luma, camera, circle, sign, close)
        if len(found.points) < 12:
            return None
        row = camera.to_picture(np.array([circle.x, circle.y]))[1]
        upright = found.points - np.outer(found.rows - row, lean)
        fit = robust_circle(upright, circle, close + 2.0, expected)
        if fit is None:
            return None
        circle = fit.circle
    assert fit is not None
    share = float(fit.inside.sum() / max(found.looked, 1))
    return Rim(fit.circle, fit.covariance, share, found.looked / RAYS, fit.spread, upright[fit.inside])


def find_disc(luma: Bytes, camera: Camera, circle: Circle) -> tuple[float, float] | None:
    """Find the centre of a round patch by its outline in luma, which is finer than chroma.

    luma shape (height, width) [1]; circle: position by its colour; x, y: None if the outline is not that of a disc [rectified
    pixels].
    """
    reach = min(max(2.0, 0.35 * circle.radius), 4.0)
    found = edges(luma, camera, circle, 0, reach)
    if len(found.points) < 0.6 * RAYS:
        return None
    fit = robust_circle(found.points, circle, reach + 1.0, (circle.radius, 0.1 * circle.radius))
    if fit is None or fit.inside.sum() < 0.6 * RAYS or fit.spread > max(0.3, 0.08 * circle.radius):
        return None
    if np.hypot(fit.circle.x - circle.x, fit.circle.y - circle.y) > 0.3 + 0.1 * circle.radius:
        return None
    return fit.circle.x, fit.circle.y
