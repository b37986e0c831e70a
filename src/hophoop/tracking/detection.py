"""The hoop in a picture of which nothing is known: what moves, or is darker or lighter than what is around it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.tracking.camera import Camera
from hophoop.tracking.circle import Circle, circles_by_lot
from hophoop.tracking.rays import RAYS, Rim, find_rim, profile
from hophoop.tracking.video import Bytes

Floats = NDArray[np.float64]

WIDTH = 640  # of the picture in which candidates are looked for [pixel]
MOVED = 14.0  # change of luma that counts as moved
CONTRAST = 18.0  # difference from what is around that counts as dark or light
SMALLEST = 9.0  # radius [pixel]
MOST_POINTS = 600
COMPONENTS = 5
CERTAIN = 0.8  # share after which no other circle is looked for
WANTED = 0.5  # share of the visible rim that must agree
SEEN = 0.22  # share of the rim that must lie in the picture


class Hoop(NamedTuple):
    """A hoop found in a picture."""

    rim: Rim
    sign: int  # 1 dark, −1 light


class Search(NamedTuple):
    """What finding the hoop needs to know about a film."""

    camera: Camera
    background: Floats | None  # luma without the hoop, reduced; None where nothing moves apart from it
    by: int  # factor by which it is reduced
    sign: int  # 1 dark, −1 light, 0 not known
    expected: tuple[float, float] | None  # radius and how well it is known [pixel]


def reduction(width: int) -> int:
    """Factor by which pictures are reduced before candidates are looked for [1]."""
    return max(1, round(width / WIDTH))


def reduced(luma: Bytes, by: int) -> Floats:
    """A smaller picture, each pixel the mean of by × by."""
    tall, wide = luma.shape[0] // by * by, luma.shape[1] // by * by
    blocks = luma[:tall, :wide].reshape(tall // by, by, wide // by, by)
    result: Floats = blocks.mean(axis=(1, 3), dtype=np.float32)
    return result


def detect(luma: Bytes, search: Search, rng: np.random.Generator) -> Hoop | None:
    """The hoop in a picture, if there is one.

    Parameters
    ----------
    luma : ndarray, shape (height, width)
        [1]
    search : Search
    rng : numpy.random.Generator

    Returns
    -------
    hoop : Hoop or None
    """
    small = reduced(luma, search.by)
    best: Hoop | None = None
    sizes = (SMALLEST / search.by + 3.0, 0.6 * max(small.shape))
    if search.expected is not None:
        sizes = (0.9 * search.expected[0] / search.by, 1.1 * search.expected[0] / search.by)
    for mask in _masks(small, search.background):
        for points in _outlines(mask, sizes[0]):
            if len(points) > MOST_POINTS:
                points = points[rng.choice(len(points), MOST_POINTS, replace=False)]
            for share, circle in circles_by_lot(points, sizes, (small.shape[1], small.shape[0]), rng):
                if share < 0.3:
                    break
                middle = (np.array([circle.x, circle.y]) + 0.5) * search.by - 0.5
                # with a tilt the size in the picture is not that in the plane, but near enough to look there
                plane = search.camera.to_plane(middle)
                hoop = confirm(luma, search, Circle(float(plane[0]), float(plane[1]), circle.radius * search.by), rng)
                if hoop is not None and (best is None or hoop.rim.share > best.rim.share):
                    best = hoop
                if best is not None and best.rim.share > CERTAIN:
                    return best
    return best


def confirm(
    luma: Bytes, search: Search, circle: Circle, rng: np.random.Generator, lean: tuple[float, float] = (0.0, 0.0)
) -> Hoop | None:
    """The hoop's outer edge near a circle that may be its inner one, or off by some pixels.

    Parameters
    ----------
    luma : ndarray, shape (height, width)
        [1]
    search : Search
    circle : Circle
    rng : numpy.random.Generator
    lean : tuple of float
        As in `find_rim` [rectified pixels a row].

    Returns
    -------
    hoop : Hoop or None
        None where too little of a rim is there.
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
    # the outermost of the steep places is the outside of the rim; its top is up to where it falls again
    last = int(np.flatnonzero(steep)[-1])
    while last > 0 and abs(rise[last - 1]) > abs(rise[last]) and np.sign(rise[last - 1]) == np.sign(rise[last]):
        last -= 1
    sign = 1 if rise[last] > 0 else -1
    outer = circle._replace(radius=circle.radius + float(offsets[last + 1]))
    if outer.radius < SMALLEST:
        return None
    reach = max(5.0, 0.06 * outer.radius)
    rim = find_rim(luma, search.camera, outer, sign, reach, search.expected, rng, lean)
    if rim is None or not acceptable(rim, search.expected):
        return None
    return Hoop(rim, sign)


def acceptable(rim: Rim, expected: tuple[float, float] | None) -> bool:
    """Whether enough of a rim is there to believe it."""
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
    """Outlines of the largest components, and of all of them together."""
    ndimage = need("scipy.ndimage", "track")
    labels, count = ndimage.label(mask, structure=np.ones((3, 3)))
    if not count:
        return []
    edge = mask & ~ndimage.binary_erosion(mask, border_value=1)
    boxes = ndimage.find_objects(labels)
    sizes = np.array([max(box[0].stop - box[0].start, box[1].stop - box[1].start) for box in boxes])
    result = []
    for k in np.argsort(-sizes)[:COMPONENTS]:
        if sizes[k] >= 2 * least:
            rows, columns = np.nonzero(edge[boxes[k]] & (labels[boxes[k]] == k + 1))
            result.append(np.column_stack([columns + boxes[k][1].start, rows + boxes[k][0].start]).astype(float))
    wide = np.flatnonzero(sizes >= 3)
    if len(wide) > 1:
        rows, columns = np.nonzero(edge & np.isin(labels, wide + 1))
        result.append(np.column_stack([columns, rows]).astype(float))
    return result
