"""Search of the hoop in a picture without a prediction, by motion or contrast; what the stills of a film show of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.circle import UNKNOWN, Circle, ransac_circles
from hophoop.tracking.hints import Hints
from hophoop.tracking.rim import SMALLEST, Rim, confirm
from hophoop.tracking.scatter import Complexes, Flags, Floats
from hophoop.tracking.video import Bytes, Picture

WIDTH = 640  # of the downsampled picture for the search [pixel]
MOVED = 14.0  # change of luma that counts as motion
CONTRAST = 18.0  # difference from the surroundings that counts as dark or light
MOST_POINTS = 600
COMPONENTS = 5
CERTAIN = 0.8  # share of a rim that ends the search
ALIKE = 0.12  # relative difference of radii in different pictures
SIZE_ERROR = 0.25 * ALIKE  # of a radius from other pictures, relative
STILL = 0.02  # distance over the radius below which a circle belongs to the background


class Search(NamedTuple):
    """What is known of the hoop before it is looked for in a picture."""

    background: Floats | None  # downsampled luma without the hoop, for a search by motion; None for a search by contrast
    sign: int  # 1 dark, −1 light, 0 unknown
    expected: tuple[float, float] = UNKNOWN  # radius and its error [pixel]


def learn_hoop(stills: list[Picture], hints: Hints, source: str) -> tuple[Search, list[tuple[Picture, Rim]]]:
    """Find the hoop in stills of a film: a search that knows its size and tone, and the stills that show it.

    source: name of the film.
    """
    start = _with_hint(Search(None, {"dark": 1, "light": -1}.get(hints.ring, 0)), stills, hints)
    background = np.median([_reduced(still.luma)[0] for still in stills], axis=0)
    best: list[tuple[Picture, Rim]] = []
    for search in (start._replace(background=background), start):
        found = [(still, rim) for still in stills if (rim := detect(still.luma, search)) is not None]
        groups = ([pair for pair in found if _alike(pair[1], seed)] for _, seed in found)
        alike = max(groups, key=lambda group: (len(group), sum(rim.share for _, rim in group)), default=[])
        if len(alike) > len(best):
            best, known = alike, search
        if len(best) >= max(2, 0.1 * len(stills)):
            break
    if len(best) < 2:
        raise InputError(
            f"{source} shows no hoop that could be followed; a hint may help: its centre and radius in a frame, "
            f"or whether it is dark or light."
        )
    centre, radius = np.transpose([rim.circle for _, rim in best])
    size = float(np.median(radius.real))
    if np.abs(centre - centre[0]).max() < STILL * size:
        raise InputError(f"{source} shows a circle that does not move, but no hoop.")
    error = max(SIZE_ERROR * size, 0.25 * float(np.ptp(radius.real)))  # a tilted hoop has other sizes at either side
    return known._replace(sign=best[0][1].sign, expected=(size, error)), best


def _with_hint(search: Search, stills: list[Picture], hints: Hints) -> Search:
    """Return a search that knows size and tone of the hoop at the hinted centre."""
    if hints.centre is None or hints.rim is None:
        return search
    still = min(stills, key=lambda one: abs(one.t - hints.at))
    rim = confirm(still.luma, Circle(complex(*hints.centre), hints.rim), search.sign)
    if rim is None:
        raise InputError(
            f"centre = {hints.centre[0]:g}, {hints.centre[1]:g} and a rim of {hints.rim:g} pixels show no rim "
            f"in the frame at {still.t:.3f} s.",
            field="centre",
            value=hints.centre,
        )
    return search._replace(sign=rim.sign, expected=(rim.circle.radius, SIZE_ERROR * rim.circle.radius))


def _alike(one: Rim, other: Rim) -> bool:
    """Return True for rims of one size and one tone."""
    size = other.circle.radius
    return one.sign == other.sign and abs(one.circle.radius - size) < ALIKE * size


# --- one picture -----------------------------------------------------------------------------------


def _reduced(luma: Bytes) -> tuple[Floats, int]:
    """Return a picture of about `WIDTH`, and the side of the squares whose means are its pixels [pixel]."""
    by = max(1, round(len(luma[0]) / WIDTH))
    means = need("scipy.ndimage", "track").uniform_filter(luma, by, output=np.float32)
    return means[by // 2 :: by, by // 2 :: by], by


def detect(luma: Bytes, search: Search) -> Rim | None:
    """Find the hoop in a picture.

    luma shape (height, width) [1].
    """
    small, by = _reduced(luma)
    rng = np.random.default_rng(0)
    size, error = search.expected
    sizes = ((0.96 * size - 2.0 * error) / by, (1.04 * size + 2.0 * error) / by)
    if search.expected == UNKNOWN:
        sizes = (SMALLEST / by + 3.0, 0.6 * max(small.shape))
    best: Rim | None = None
    for mask in _masks(small, search.background):
        for points in _outlines(mask, sizes[0]):
            some = rng.choice(points, min(len(points), MOST_POINTS), replace=False)
            for share, (centre, radius) in ransac_circles(some, sizes, small.shape, rng):
                middle = complex(0.5, 0.5)  # of a pixel
                circle = Circle((centre + middle) * by - middle, radius * by)
                rim = confirm(luma, circle, search.sign, search.expected) if share >= 0.3 else None
                if rim is not None and (best is None or rim.share > best.share):
                    best = rim
                    if rim.share > CERTAIN:
                        return rim
    return best


def _masks(small: Floats, background: Floats | None) -> list[Flags]:
    if background is not None:
        return [np.abs(small - background) > MOVED]
    around = need("scipy.ndimage", "track").gaussian_filter(small, 0.05 * small.shape[1])
    return [small < around - CONTRAST, small > around + CONTRAST]


def _outlines(mask: Flags, least: float) -> list[Complexes]:
    """Return outlines of the largest components, and of all of them together; least: radius of a hoop [pixel]."""
    ndimage = need("scipy.ndimage", "track")
    labels, _ = ndimage.label(mask, structure=np.ones((3, 3)))
    sizes = np.array([max(side.stop - side.start for side in box) for box in ndimage.find_objects(labels)])
    edge = mask & ~ndimage.binary_erosion(mask, border_value=1)
    points, own = np.argwhere(edge) @ [1j, 1.0], labels[edge] - 1
    largest = [points[own == k] for k in np.argsort(-sizes)[:COMPONENTS] if sizes[k] >= 2 * least]
    return [*largest, points[sizes[own] >= 3]] if len(sizes) else []
