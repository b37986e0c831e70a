"""The marker on the hoop, by its colour: a patch of chroma at one distance from the centre."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.circle import Circle
from hophoop.tracking.rim import Rim, find_disc
from hophoop.tracking.scatter import NOWHERE, Complexes, Floats
from hophoop.tracking.video import Picture

CHROMA = np.array([-37.797 + 112.0j, -74.203 - 93.786j, 112.0 - 18.214j]) / 255  # of red, green and blue, after BT.601
LEAST_CHROMA = 16.0  # minimum, to distinguish a colour from gray
DULL = 80.0  # largest chroma of a real marker, which is duller than the colour of its name
PALE = 18.0  # minimum chroma of a marker above its surroundings
MOST_SPOTS = 6  # in a picture
FEWEST = 3.0  # minimum chroma samples of a marker
INSIDE, OUTSIDE = 0.15, 1.12  # distances of a marker from the centre, over the radius
OTHER_AREA = 0.6  # logarithm of the area of a visible marker over its usual one
NEAR = 0.12  # tolerance of its distance from the centre in the picture, over the radius


class Marker(NamedTuple):
    """Colour and position of the marker."""

    chroma: complex  # differences from luma: blue + i red
    ratio: float  # distance from the centre over the radius in the picture; nan if unknown


class Spot(NamedTuple):
    """A patch of colour on the hoop in a picture."""

    place: complex  # column + i row [pixel]
    chroma: complex  # of its strongest sample
    ratio: float  # distance from the centre over the radius in the picture
    area: float  # samples of chroma, by their weights


def colour_chroma(text: str) -> complex:
    """Return the chroma of a colour: a name, or red, green and blue as #rrggbb."""
    try:
        chroma = complex(CHROMA @ need("PIL.ImageColor", "track").getrgb(text.strip())[:3])
    except ValueError:
        allowed = "auto, none, red, orange, yellow, green, cyan, blue, magenta, pink or a colour as #rrggbb"
        raise InputError.of_field("marker_color", text, allowed) from None
    if abs(chroma) < LEAST_CHROMA:
        raise InputError(
            f"marker_color = {text!r} is too near to gray to be found by its colour.", field="marker_color", value=text
        )
    return chroma


def learn_marker(seen: list[tuple[Picture, Rim]], color: str) -> Marker | None:
    """Find the patch of colour at a constant distance from the moving centre.

    seen: stills with the hoop in them; color: auto, none or the marker's; marker: None if there is no such patch in at least
    half of the stills.
    """
    if color == "none":
        return None
    given = None
    if color != "auto":
        chroma = colour_chroma(color)
        given = Marker(chroma * min(1.0, DULL / abs(chroma)), np.nan)
    found = [(k, spot) for k, (still, rim) in enumerate(seen) for spot in spots(still, rim.circle, given)]
    groups = ({k: spot for k, spot in found if _alike(spot, seed)} for _, seed in found)
    best = max(groups, key=len, default={})
    if given is not None and not best:
        raise InputError(
            f"marker_color = {color!r}: no patch of that colour was seen on the hoop.", field="marker_color", value=color
        )
    if given is None and len(best) < max(2, 0.5 * len(seen)):
        return None
    blue, red, ratio = np.median([(spot.chroma.real, spot.chroma.imag, spot.ratio) for spot in best.values()], axis=0)
    return Marker(complex(blue, red) if given is None else given.chroma, float(ratio))


def _alike(one: Spot, other: Spot) -> bool:
    """Return True for spots of one colour at one distance from the centre."""
    return abs(one.chroma - other.chroma) < max(0.3 * abs(other.chroma), 10.0) and abs(one.ratio - other.ratio) < 0.08


def spots(picture: Picture, circle: Circle, marker: Marker | None) -> list[Spot]:
    """Find patches of the marker's colour at its distance from the centre, or of any colour if it is unknown.

    spots: the largest first, each at the centre of its outline, if that is a disc, otherwise at the mean of its samples.
    """
    ndimage = need("scipy.ndimage", "track")
    reach = OUTSIDE * circle.radius
    middle = circle.centre.imag, circle.centre.real
    box = tuple(slice(max(int((at - reach) / 2), 0), max(int((at + reach) / 2) + 2, 0)) for at in middle)
    chroma = (picture.blue[box] - 128.0) + 1j * (picture.red[box] - 128.0)
    if min(chroma.shape) < 3:
        return []
    row, column = np.mgrid[box][:, : chroma.shape[0], : chroma.shape[1]]
    place = 2.0 * (column + 1j * row) + complex(*picture.chroma)
    ratio = np.abs(place - circle.centre) / circle.radius
    weight = _above_surroundings(chroma, ratio) if marker is None else _like(marker, chroma, ratio, circle.radius)
    labels, _ = ndimage.label(weight > 0.0, structure=np.ones((3, 3)))
    found = []
    for k, part in enumerate(ndimage.find_objects(labels), 1):
        own = np.where(labels[part] == k, weight[part], 0.0)
        if (area := float(own.sum())) >= FEWEST:
            centre = complex((own * place[part]).sum() / area)
            strongest = complex(chroma[part].flat[own.argmax()])  # the rest is blurred
            found.append(Spot(centre, strongest, abs(centre - circle.centre) / circle.radius, area))
    return [_outlined(picture, spot) for spot in sorted(found, key=lambda spot: -spot.area)[:MOST_SPOTS]]


def _above_surroundings(chroma: Complexes, ratio: Floats) -> Floats:
    """Weights of samples by their chroma above the median."""
    above = np.abs(chroma - np.median(chroma.real) - 1j * np.median(chroma.imag))
    above[(ratio >= OUTSIDE) | (ratio <= INSIDE)] = 0.0
    most = above.max()
    return np.where(above > max(PALE, 0.45 * most), above / max(most, PALE), 0.0)


def _like(marker: Marker, chroma: Complexes, ratio: Floats, radius: float) -> Floats:
    """Weights of samples by their likeness to the marker's colour; radius [pixel]."""
    share = chroma / marker.chroma  # 1 for its very colour
    # a ramp about half of the full colour, so that blur and subsampled chroma do not move the centroid
    weight = (share.real - 0.6 * np.maximum(np.abs(share.imag) - 0.15, 0.0) - 0.25).clip(0.0, 0.5) * 2.0
    known = np.isfinite(marker.ratio)
    near = np.abs(ratio - marker.ratio) < max(0.2, 8.0 / radius) if known else ratio < OUTSIDE
    return np.where(near, weight, 0.0)


def _outlined(picture: Picture, spot: Spot) -> Spot:
    """Return a spot at the centre of its outline, if that is a disc."""
    size = float(np.sqrt(4.0 * spot.area / np.pi))  # a sample is four pixels
    disc = find_disc(picture.luma, Circle(spot.place, size))
    return spot if disc is None else spot._replace(place=disc.centre)


def choose_spots(found: Sequence[list[Spot]]) -> Complexes:
    """Return the place of the marker in each frame: the patch of its usual size at its usual distance from the centre.

    found: spots of each frame, the largest first; places: shape (n,), nan where there is none [pixel].
    """
    largest = [(those[0].ratio, np.log(those[0].area)) for those in found if those]
    usual = np.median(largest or [(np.nan, np.nan)], axis=0)

    def unlike(spot: Spot) -> Floats:
        return np.asarray(np.abs([spot.ratio, np.log(spot.area)] - usual) / [NEAR, OTHER_AREA])

    fits = ([spot for spot in those if unlike(spot).max() < 1.0] for those in found)
    return np.array([min(those, key=lambda spot: unlike(spot).sum()).place if those else NOWHERE for those in fits])


def count_revolutions(t: Floats, angle: Floats) -> tuple[Floats, float | None]:
    """Return an angle without jumps, each next to where the two before it lead, and the time after which revolutions may miss.

    t, angle: shape (n,), nan where unknown [s], [rad].
    """
    whole, doubt, omega = angle.copy(), None, 0.0
    for last, k in pairwise(np.flatnonzero(np.isfinite(angle))):
        wait = t[k] - t[last]
        whole[k] += 2 * np.pi * np.round((whole[last] + omega * wait - angle[k]) / (2 * np.pi))
        if doubt is None and k > last + 1 and abs(omega) * wait > 0.5 * np.pi:
            doubt = float(t[k])
        omega = (whole[k] - whole[last]) / wait
    return whole, doubt
