"""The marker on the hoop, by its colour: a patch of chroma at one distance from the centre."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.circle import Circle
from hophoop.tracking.rim import Rim, find_disc
from hophoop.tracking.video import Picture

Floats = NDArray[np.float64]

NAMES = {
    "red": (220, 30, 30), "orange": (240, 130, 20), "yellow": (230, 220, 30), "green": (30, 170, 50),
    "cyan": (30, 190, 200), "blue": (30, 70, 220), "magenta": (220, 40, 200), "pink": (240, 110, 170),
}  # fmt: skip
LEAST_CHROMA = 16.0  # minimum, to distinguish a colour from gray
PALE = 18.0  # minimum chroma of a marker above its surroundings
FEWEST = 3.0  # minimum chroma samples of a marker
INSIDE, OUTSIDE = 0.15, 1.12  # distances of a marker from the centre, over the radius
AREAS = (0.55, 1.7)  # area of a visible marker over its usual area
NEAR = 0.12  # tolerance of its distance from the centre in the picture, over the radius


class Marker(NamedTuple):
    """Colour and position of the marker."""

    blue: float  # its chroma
    red: float
    ratio: float = float("nan")  # distance from the centre over the radius in the picture


class Spot(NamedTuple):
    """A patch of colour on the hoop in a picture."""

    x: float  # [pixel]
    y: float
    blue: float  # its chroma
    red: float
    ratio: float  # distance from the centre over the radius in the picture
    area: float  # samples of chroma, by their weights


def colour_chroma(text: str) -> tuple[float, float]:
    """Return the chroma of a colour.

    text: a name, or red, green and blue as #rrggbb; blue, red: differences of blue and red from luma, after BT.601 [1].
    """
    word = text.strip().lower()
    if word in NAMES:
        r, g, b = NAMES[word]
    else:
        try:
            if len(word) != 7 or word[0] != "#":
                raise ValueError
            r, g, b = (int(word[k : k + 2], 16) for k in (1, 3, 5))
        except ValueError:
            raise InputError.of_field("marker_color", text, f"auto, none, {', '.join(NAMES)} or a colour as #rrggbb") from None
    blue = (-37.797 * r - 74.203 * g + 112.0 * b) / 255
    red = (112.0 * r - 93.786 * g - 18.214 * b) / 255
    if np.hypot(blue, red) < LEAST_CHROMA:
        raise InputError(
            f"marker_color = {text!r} is too near to gray to be found by its colour.", field="marker_color", value=text
        )
    return blue, red


def learn_marker(seen: list[tuple[Picture, Rim]], color: str) -> Marker | None:
    """Find the patch of colour at a constant distance from the moving centre.

    seen: stills with the hoop in them; color: auto, none or the marker's; marker: None if there is no such patch in at least
    half of the stills.
    """
    if color == "none":
        return None
    given = None if color == "auto" else Marker(*colour_chroma(color))
    found = [(k, spot) for k, (still, rim) in enumerate(seen) for spot in spots(still, rim.circle, given)]
    best: dict[int, Spot] = {}
    for _, seed in found:
        best = max(best, {k: spot for k, spot in found if _alike(spot, seed)}, key=len)
    if given is not None and not best:
        raise InputError(
            f"marker_color = {color!r}: no patch of that colour was seen on the hoop.", field="marker_color", value=color
        )
    if given is None and len(best) < max(2, 0.5 * len(seen)):
        return None
    usual = Marker(*np.median([(spot.blue, spot.red, spot.ratio) for spot in best.values()], axis=0).tolist())
    return usual if given is None else given._replace(ratio=usual.ratio)


def _alike(one: Spot, other: Spot) -> bool:
    size = np.hypot(other.blue, other.red)
    apart = np.hypot(one.blue - other.blue, one.red - other.red)
    return bool(apart < max(0.3 * size, 10.0) and abs(one.ratio - other.ratio) < 0.08)


def spots(picture: Picture, circle: Circle, marker: Marker | None) -> list[Spot]:
    """Find patches of the marker's colour at its distance from the centre, or of any colour if it is unknown.

    spots: the largest first, each at the mean of its samples.
    """
    ndimage = need("scipy.ndimage", "track")
    reach = OUTSIDE * circle.radius
    rows, columns = (
        slice(max(int((middle - reach) / 2), 0), max(int((middle + reach) / 2) + 2, 0)) for middle in (circle.y, circle.x)
    )
    blue, red = (plane[rows, columns].astype(float) - 128 for plane in (picture.blue, picture.red))
    if min(blue.shape) < 3:
        return []
    y, x = (2.0 * place for place in np.mgrid[rows, columns][:, : blue.shape[0], : blue.shape[1]])
    x, y = x + picture.chroma[0], y + picture.chroma[1]
    ratio = np.hypot(x - circle.x, y - circle.y) / circle.radius
    weight = _above_surroundings(blue, red, ratio) if marker is None else _like(marker, blue, red, ratio, circle.radius)
    labels, count = ndimage.label(weight > 0.0, structure=np.ones((3, 3)))
    sums = [ndimage.sum_labels(weight * one, labels, np.arange(count) + 1) for one in (1.0, x, y, blue, red)]
    found = []
    for area, *moments in np.transpose(sums).tolist():
        if area >= FEWEST:
            u, v, cb, cr = (moment / area for moment in moments)
            found.append(Spot(u, v, cb, cr, float(np.hypot(u - circle.x, v - circle.y)) / circle.radius, area))
    return sorted(found, key=lambda spot: -spot.area)


def _above_surroundings(blue: Floats, red: Floats, ratio: Floats) -> Floats:
    """Weights of samples by their chroma above the median."""
    chroma = np.hypot(blue - np.median(blue), red - np.median(red))
    chroma[(ratio >= OUTSIDE) | (ratio <= INSIDE)] = 0.0
    most = float(chroma.max())
    return np.where(chroma > max(PALE, 0.45 * most), chroma / max(most, PALE), 0.0)


def _like(marker: Marker, blue: Floats, red: Floats, ratio: Floats, radius: float) -> Floats:
    """Weights of samples by their likeness to the marker's colour; radius [pixel]."""
    size = float(np.hypot(marker.blue, marker.red))
    along = (blue * marker.blue + red * marker.red) / size
    across = np.abs(blue * marker.red - red * marker.blue) / size
    # a ramp about half of the full colour, so that blur and subsampled chroma do not move the centroid
    weight = ((along - 0.6 * np.maximum(across - 0.15 * size, 0.0)) / size - 0.25).clip(0.0, 0.5) * 2.0
    known = np.isfinite(marker.ratio)
    near = np.abs(ratio - marker.ratio) < max(0.2, 8.0 / radius) if known else ratio < OUTSIDE
    return np.where(near, weight, 0.0)


def outlined(picture: Picture, spot: Spot) -> Spot:
    """Return a spot at the centre of its outline, if that is a disc."""
    disc = find_disc(picture.luma, Circle(spot.x, spot.y, float(np.sqrt(4.0 * spot.area / np.pi))))  # a sample is four pixels
    return spot if disc is None else spot._replace(x=disc.x, y=disc.y)


def choose_spots(found: list[list[Spot]]) -> Floats:
    """Return the place of the marker in each frame: the patch of its usual size at its usual distance from the centre.

    found: spots of each frame, the largest first; places: shape (n, 2), nan where there is none [pixel].
    """
    places = np.full((len(found), 2), np.nan)
    usual = [(those[0].ratio, those[0].area) for those in found if those]
    ratio, area = np.median(usual or [(np.nan, np.nan)], axis=0)

    def unlike(spot: Spot) -> float:
        share, off = spot.area / area, abs(spot.ratio - ratio)
        fits = AREAS[0] < share < AREAS[1] and off < NEAR
        return abs(np.log(share)) + off / NEAR if fits else np.inf

    for place, those in zip(places, found, strict=True):
        best = min(those, key=unlike, default=None)
        if best is not None and unlike(best) < np.inf:
            place[:] = best[:2]
    return places


def count_revolutions(t: Floats, angle: Floats) -> tuple[Floats, float | None]:
    """Return an angle without jumps, each next to where the two before it lead, and the time after which revolutions may miss.

    t, angle: shape (n,), nan where unknown [s], [rad].
    """
    whole, doubt, omega, last = angle.copy(), None, 0.0, None
    for k in np.flatnonzero(np.isfinite(angle)):
        if last is not None:
            wait = t[k] - t[last]
            whole[k] += 2 * np.pi * np.round((whole[last] + omega * wait - angle[k]) / (2 * np.pi))
            if doubt is None and k > last + 1 and abs(omega) * wait > 0.5 * np.pi:
                doubt = float(t[k])
            omega = (whole[k] - whole[last]) / wait
        last = k
    return whole, doubt
