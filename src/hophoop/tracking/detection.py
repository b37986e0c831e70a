"""Detection of the hoop in a picture without a prediction, by motion or contrast."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.tracking.camera import Camera
from hophoop.tracking.circle import Circle, ransac_circles
from hophoop.tracking.rays import RAYS, Rim, find_rim, profile
from hophoop.tracking.video import Bytes

Floats = NDArray[np.float64]

WIDTH = 640  # of the downsampled picture for the search [pixel]
MOVED = 14.0  # change of luma that counts as motion
CONTRAST = 18.0  # difference from the surroundings that counts as dark or light
SMALLEST = 9.0  # radius [pixel]
MOST_POINTS = 600
COMPONENTS = 5
CERTAIN = 0.8  # share that ends the search
WANTED = 0.5  # share of the visible rim that must agree
SEEN = 0.22  # share of the rim that must lie in the picture


class Hoop(NamedTuple):
    """A hoop found in a picture."""

    rim: Rim
    sign: int  # 1 dark, −1 light


class Search(NamedTuple):
    """Settings of the search in a film."""

    camera: Camera
    background: Floats | None  # downsampled luma without the hoop, for a search by motion; None for a search by contrast
    by: int  # factor of downsampling
    sign: int  # 1 dark, −1 light, 0 unknown
    expected: tuple[float, float] | None  # radius and its error [pixel]


def reduction(width: int) -> int:
    """Factor of downsampling for the search [1]."""
    return max(1, round(width / WIDTH))


def downsample(luma: Bytes, by: int) -> Floats:
    """Downsample a picture: each pixel is the mean of by × by."""
    tall, wide = luma.shape[0] // by * by, luma.shape[1] // by * by
    blocks = luma[:tall, :wide].reshape(tall // by, by, wide // by, by)
    result: Floats = blocks.mean(axis=(1, 3), dtype=np.float32)
    return result


def detect(luma: Bytes, search: Search, rng: np.random.Generator) -> Hoop | None:
    """Find the hoop in a picture.

    luma shape (height, width) [1].
    """
    small = downsample(luma, search.by)
    best: Hoop | None = None
    sizes = (SMALLEST / search.by + 3.0, 0.6 * max(small.shape))
    if search.expected is not None:
        sizes = (0.9 * search.expected[0] / search.by, 1.1 * search.expected[0] / search.by)
    for mask in _masks(small, search.background):
        for points in _outlines(mask, sizes[0]):
            if len(points) > MOST_POINTS:
                points = points[rng.choice(len(points), MOST_POINTS, replace=False)]
            for share, circle in ransac_circles(points, sizes, (small.shape[1], small.shape[0]), rng):
                if share < 0.3:
                    break
                middle = (np.array([circle.x, circle.y]) + 0.5) * search.by - 0.5
                # with a tilt the size in the picture differs from that in the plane, but little enough for the search
                plane = search.camera.to_plane(middle)
                hoop = confirm(luma, search, Circle(float(plane[0]), float(plane[1]), circle.radius * search.by))
                if hoop is not None and (best is None or hoop.rim.share > best.rim.share):
                    best = hoop
                if best is not None and best.rim.share > CERTAIN:
                    return best
    return best


def confirm(luma: Bytes, search: Search, circle: Circle, lean: tuple[float, float] = (0.0, 0.0)) -> Hoop | None:
    """Find the hoop's outer edge near a circle, which may be its inner edge or off by a few pixels.

    luma shape (height, width) [1]; lean: as in `find_rim` [rectified pixels per row]; hoop: None if too little of a rim is
    visible.
    """
    angles = (np.arange(RAYS) + 0.5) * 2 * np.pi / RAYS
    span = max(0.2 * circle.radius, 6.0)
    offsets = np.arange(-span, span + 0.5)
    values, _, _ = profile(luma, search.camera, circle, angles, offsets)
    seen = np.isfinite(values).all(axis=1)
    if seen.mean() < SEEN:
        return None
    middle = np.median(values[seen], axis=0)
    rise = 0.5 * (middle[2:] - middle[:-2])
    size = float(np.abs(rise).max())
    if search.sign:
        rise = np.where(np.sign(rise) == search.sign, rise, 0.0)
    steep = np.abs(rise) >= max(0.4 * size, 1.0)
    if not steep.any():
        return None
    # the outermost steep edge is the outside of the rim; it ends where the profile falls again
    last = int(np.flatnonzero(steep)[-1])
    while last > 0 and abs(rise[last - 1]) > abs(rise[last]) and np.sign(rise[last - 1]) == np.sign(rise[last]):
        last -= 1
    sign = 1 if rise[last] > 0 else -1
    outer = circle._replace(radius=circle.radius + float(offsets[last + 1]))
    if outer.radius < SMALLEST:
        return None
    reach = max(5.0, 0.06 * outer.radius)
    rim = find_rim(luma, search.camera, outer, sign, reach, search.expected, lean)
    if rim is None or not acceptable(rim, search.expected):
        return None
    return Hoop(rim, sign)


def acceptable(rim: Rim, expected: tuple[float, float] | None) -> bool:
    """Return True if enough of the rim agrees."""
    size = rim.circle.radius
    if rim.share < WANTED or rim.seen < SEEN or rim.spread > max(0.8, 0.02 * size):
        return False
    return expected is None or abs(size - expected[0]) < 4.0 * expected[1] + 0.02 * expected[0]


def _masks(small: Floats, background: Floats | None) -> list[NDArray[np.bool_]]:
    ndimage = need("scipy.ndimage", "track")
    if background is not None:
        return [np.abs(small - background) > MOVED]
    around = ndimage.gaussian_filter(small, 0.05 * small.shape[1])
    return [small < around - CONTRAST, small > around + CONTRAST]


def _outlines(mask: NDArray[np.bool_], least: float) -> list[Floats]:
    """Return outlines of the largest components, and of all of them together."""
    ndimage = need("scipy.ndimage", "track")
    labels, count = ndimage.label(mask, structure=np.ones((3, 3)))
    if not count:
        return []
    edge = mask & ~ndimage.binary_erosion(mask, border_value=1)
    boxes = ndimage.find_objects(labels)
    sizes = np.array([max(box[0].stop - box[0].start, box[1].stop - box[1].start) for box in boxes])
    rows, columns = np.nonzero(edge)
    points, own = np.column_stack([columns, rows]).astype(float), labels[rows, columns]
    wide = np.flatnonzero(sizes >= 3) + 1
    largest = [points[own == k + 1] for k in np.argsort(-sizes)[:COMPONENTS] if sizes[k] >= 2 * least]
    return [*largest, *([points[np.isin(own, wide)]] if len(wide) > 1 else [])]
