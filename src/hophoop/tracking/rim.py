"""The rim in a picture: the steepest point on each ray from the centre, to a fraction of a pixel, and a circle through them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop._support.extras import need
from hophoop.tracking.circle import UNKNOWN, Circle, CircleFit, robust_circle
from hophoop.tracking.scatter import Complexes
from hophoop.tracking.video import Bytes

RAYS = 180
DIRECTIONS = np.exp(2j * np.pi * (np.arange(RAYS) + 0.5) / RAYS)[:, None]
STEP = 0.5  # between samples of a ray [pixel]
WIDE = 2.5  # distance from the steepest sample up to which samples count for its position [pixel]
WEAKEST = 3.0  # rise of luma that counts as an edge
CLOSE = (4.0, 0.04)  # reach of the last search [pixel], and over the radius
OVAL = 0.03  # amplitude by which a rim is no circle, over the radius: a tilted hoop is an ellipse in the picture
NEARBY = 0.15  # distance of the outer edge from a circle that was found, over the radius
WANTED = 0.5  # share of the visible rim that must agree
SEEN = 0.22  # share of the rim that must lie in the picture
SMALLEST = 9.0  # radius [pixel]


class Rim(NamedTuple):
    """A rim found in a picture."""

    circle: Circle
    points: Complexes  # of its outer edge [pixel]
    looked: int  # rays that lie in the picture
    sign: int  # 1 dark, −1 light
    oval: tuple[float, float]  # as in `CircleFit`

    @property
    def share(self) -> float:
        """Share of the visible rim that agrees [1]."""
        return len(self.points) / self.looked


def edges(luma: Bytes, circle: Circle, sign: int, reach: float, over: float = 1.0) -> tuple[Complexes, int]:
    """Find the steepest point on each ray near a circle.

    luma shape (height, width) [1]; sign: 1 if luma rises outwards, as at a dark hoop; 0 for edges of either sign; reach:
    maximum distance from the circle [pixel]; over: distance over which luma rises, the thinner the rim the less, since its
    inner edge is near [pixel]; points: shape (n,), one per ray that has it [pixel]; looked: number of rays that lie in the
    picture.
    """
    offsets = np.arange(-reach - 1.0, reach + 1.0 + 0.5 * STEP, STEP)
    at = circle.centre + (circle.radius + offsets) * DIRECTIONS
    sample = need("scipy.ndimage", "track").map_coordinates
    values = sample(luma, [at.imag, at.real], output=np.float32, order=1, cval=np.nan)  # nan outside the picture
    half = round(0.5 * over / STEP)
    rise, offsets = values[:, 2 * half :] - values[:, : -2 * half], offsets[half:-half]
    there = np.isfinite(rise).all(axis=1)
    rise = np.nan_to_num(sign * rise if sign else np.abs(rise)).clip(0.0)
    best = np.argmax(rise * (1.0 - 0.4 * (offsets / (reach + 1.0)) ** 2), axis=1)[:, None]
    strength = np.take_along_axis(rise, best, axis=1)
    least = 0.25 * np.median(strength[there]) if there.any() else 0.0
    good = there & (strength[:, 0] >= max(WEAKEST, least))
    # only the peak around the steepest point, not a neighbouring one
    weight = np.where((np.abs(offsets - offsets[best]) <= WIDE) & (rise > 0.2 * strength), rise, 0.0)
    mean = (weight * offsets).sum(axis=1) / np.maximum(weight.sum(axis=1), 1e-9)
    points = circle.centre + (circle.radius + mean) * DIRECTIONS[:, 0]
    return points[good], int(there.sum())


def find_rim(
    luma: Bytes,
    circle: Circle,
    sign: int,
    reach: float,
    expected: tuple[float, float],
    oval: tuple[float, float, float],
) -> Rim | None:
    """Find the rim near a circle; None if too little of it agrees.

    luma shape (height, width) [1]; circle: start of the search; sign: 1 for a dark hoop; reach: maximum distance from the
    circle [pixel]; expected, oval: as in `robust_circle` [pixel].
    """
    fit: CircleFit | None = None
    for close in (reach, max(CLOSE[0], CLOSE[1] * circle.radius)):
        points, looked = edges(luma, circle, sign, close)
        fit = robust_circle(points, circle, close + 2.0, expected, oval)
        if fit is None or looked < SEEN * RAYS:
            return None
        circle = fit.circle
    assert fit is not None
    rim, size = Rim(circle, points[fit.inside], looked, sign, fit.oval), circle.radius
    good = rim.share >= WANTED and size >= SMALLEST and fit.spread <= max(0.8, 0.02 * size)
    return rim if good and abs(size - expected[0]) < 4.0 * expected[1] + 0.02 * expected[0] else None


def confirm(luma: Bytes, circle: Circle, sign: int, expected: tuple[float, float] = UNKNOWN) -> Rim | None:
    """Find a rim whose outer edge is near a circle, which may be its inner edge or off by a few pixels.

    luma shape (height, width) [1]; sign: 1 dark, −1 light, 0 unknown; expected: radius and its error [pixel].
    """
    reach, oval = max(6.0, NEARBY * circle.radius), (0.0, 0.0, OVAL * circle.radius)
    found = [find_rim(luma, circle, one, reach, expected, oval) for one in ((sign,) if sign else (1, -1))]
    # the outer one of both edges is the outside of the rim
    return max((rim for rim in found if rim is not None), key=lambda rim: rim.circle.radius, default=None)


def find_disc(luma: Bytes, circle: Circle) -> Circle | None:
    """Find a round patch by its outline in luma, which is finer than chroma.

    luma shape (height, width) [1]; circle: position by its colour; disc: None if the outline is not that of a disc.
    """
    reach = min(max(2.0, 0.35 * circle.radius), 4.0)
    points, _ = edges(luma, circle, 0, reach, over=2.0)
    fit = robust_circle(points, circle, reach + 1.0, (circle.radius, 0.1 * circle.radius))
    if fit is None or fit.inside.sum() < 0.6 * RAYS or fit.spread > max(0.3, 0.08 * circle.radius):
        return None
    return fit.circle if abs(fit.circle.centre - circle.centre) < 0.3 + 0.1 * circle.radius else None
