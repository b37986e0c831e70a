"""Views of a film in 2D: their rectangles in the picture, and their projections."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from hophoop.animate.frames import Extent, follow
from hophoop.animate.sheet import Points, Rectangle
from hophoop.results.poses import Floats, to_world

# Margins of a view in radii: below the plane, above a hoop on it, ahead and behind.
BELOW, ABOVE, SIDE = 0.55, 0.4, 1.35
LEAST_WIDTH = 3.4
MOST_STRIP = 0.3  # of the height of a view, for labels below the plane
# Inertia of the following camera [s of film]
CALM = 0.45


@dataclass(frozen=True)
class View:
    """A part of the picture with a camera.

    Attributes
    ----------
    rectangle : tuple of float
        Left, bottom, width, height [pixels].
    scale : float
        Pixels per metre [pixels/m].
    slope : float
        [rad].
    camera : ndarray, shape (frames, 2) or (1, 2)
        Point of the world at the anchor in each frame, or in all [m].
    anchor : tuple of float
        [pixels].
    """

    rectangle: Rectangle
    scale: float
    slope: float
    camera: Floats
    anchor: tuple[float, float]

    def matrix(self, frame: int) -> Points:
        """Return the matrix from the world to pixels, 3 × 3."""
        x, y = self.camera[min(frame, len(self.camera) - 1)]
        s = self.scale
        return np.array([[s, 0.0, self.anchor[0] - s * x], [0.0, s, self.anchor[1] - s * y], [0.0, 0.0, 1.0]])


def project(matrix: Points, points: Floats) -> Points:
    """Convert points of the world to pixels."""
    return np.asarray(points * matrix[0, 0] + matrix[:2, 2])


def whole_path_scale(rectangle: Rectangle, extent: Extent, radius: float, slope: float) -> float:
    """Return the largest scale of a view of the whole path [pixels/m]."""
    _, _, width, height = rectangle
    least, most = _corners(extent, radius, slope)
    return float(min(width / (most[0] - least[0]), height / (most[1] - least[1])))


def whole_path_view(rectangle: Rectangle, extent: Extent, radius: float, slope: float, scale: float) -> View:
    """Return a view of the whole path."""
    left, bottom, width, height = rectangle
    least, most = _corners(extent, radius, slope)
    middle = 0.5 * (least + most)
    # spare height goes above the plane
    spare = height - scale * (most[1] - least[1])
    return View(rectangle, scale, slope, middle[None, :], (left + 0.5 * width, bottom + 0.5 * height - 0.2 * spare))


def labelled_scale(scale_of: Callable[[Rectangle], float], rectangle: Rectangle, radius: float, strip: float) -> float:
    """Return the largest scale with at least `strip` pixels below the plane [pixels/m]."""
    scale = scale_of(rectangle)
    for _ in range(3):  # a smaller scale needs more pixels below the plane
        scale = scale_of(_raised(rectangle, strip - BELOW * radius * scale))
    return scale


def labelled_view(view_of: Callable[[Rectangle], View], rectangle: Rectangle, room: float) -> View:
    """Return a view that leaves `room` pixels more below the plane than its margin."""
    return replace(view_of(_raised(rectangle, room)), rectangle=rectangle)


def _raised(rectangle: Rectangle, room: float) -> Rectangle:
    left, bottom, width, height = rectangle
    room = min(max(room, 0.0), MOST_STRIP * height)
    return left, bottom + room, width, height - room


def _corners(extent: Extent, radius: float, slope: float) -> tuple[Floats, Floats]:
    low, high = extent.along[0] - SIDE * radius, extent.along[1] + SIDE * radius
    top = extent.height + (2.0 + ABOVE) * radius
    corners = to_world([low, high, low, high], [-BELOW * radius, -BELOW * radius, top, top], slope)
    return corners.min(axis=0), corners.max(axis=0)


def following_scale(rectangle: Rectangle, extent: Extent, radius: float) -> float:
    """Return the largest scale of a following view with the hoop at its maximum height [pixels/m]."""
    _, _, width, height = rectangle
    return min(height / (extent.height + (2.0 + BELOW + ABOVE) * radius), width / (LEAST_WIDTH * radius))


def following_view(
    rectangle: Rectangle, extent: Extent, radius: float, slope: float, scale: float, places: Floats, fps: float
) -> View:
    """Return a view that follows the hoop; `places` are the positions of its centre along the plane in each frame."""
    left, bottom, width, height = rectangle
    half = 0.5 * width / scale / math.cos(slope)
    used = scale * (extent.height + (2.0 + BELOW + ABOVE) * radius)
    floor = bottom + 0.3 * (height - used) + BELOW * radius * scale
    low, high = extent.along[0] - SIDE * radius, extent.along[1] + SIDE * radius
    if slope == 0.0 and high - low <= 2.0 * half:
        along = np.full(1, 0.5 * (low + high))
    else:
        along = follow(np.arange(len(places)) / fps, places, CALM)
        if slope == 0.0:
            along = np.clip(along, low + half, high - half)
        # a fast hoop stays in the picture, and on a slope the plane below it
        room = max(half - SIDE * radius, 0.0)
        if slope != 0.0:
            room = min(room, 0.7 * (floor - bottom) / scale / abs(math.sin(slope)))
        along = np.clip(along, places - room, places + room)
    return View(rectangle, scale, slope, to_world(along, np.zeros_like(along), slope), (left + 0.5 * width, floor))


def grid(area: Rectangle, count: int, ratio: float, gap: float) -> list[Rectangle]:
    """Return rectangles for several views, in the rows and columns with the most room for each.

    `ratio` is the preferred width over height of a view.
    """
    left, bottom, width, height = area

    def room(columns: int) -> float:
        rows = math.ceil(count / columns)
        return min((width - gap * (columns - 1)) / columns / ratio, (height - gap * (rows - 1)) / rows)

    columns = max(range(1, count + 1), key=room)
    rows = math.ceil(count / columns)
    wide = (width - gap * (columns - 1)) / columns
    high = (height - gap * (rows - 1)) / rows
    return [
        (left + (i % columns) * (wide + gap), bottom + (rows - 1 - i // columns) * (high + gap), wide, high)
        for i in range(count)
    ]
