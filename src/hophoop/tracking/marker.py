"""The marker on the hoop, by its colour: a patch of chroma at one distance from the centre."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.camera import Camera
from hophoop.tracking.circle import Circle
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


class Marker(NamedTuple):
    """Colour, position and size of the marker."""

    blue: float  # its chroma
    red: float
    ratio: float  # distance from the centre over the radius; nan if unknown
    area: float  # sum of its weights in samples of chroma; nan if unknown


class Spot(NamedTuple):
    """A patch of colour on the hoop in a picture."""

    x: float  # in rectified pixels
    y: float
    row: float  # of the picture [pixel]
    blue: float  # its chroma
    red: float
    ratio: float  # distance from the centre over the radius
    area: float  # sum of its weights

    @property
    def radius(self) -> float:
        """Radius of a disc of that area; a sample of chroma is four pixels [pixel]."""
        return float(np.sqrt(4.0 * self.area / np.pi))


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


class _Patch(NamedTuple):
    """Samples of chroma in the box around a circle."""

    blue: Floats
    red: Floats
    rows: Floats  # of the picture [pixel]
    points: Floats  # [rectified pixels]
    ratio: Floats  # distance from the centre over the radius


def _patch(picture: Picture, camera: Camera, circle: Circle) -> _Patch | None:
    around = np.linspace(0, 2 * np.pi, 33)
    rim = np.array([circle.x, circle.y]) + OUTSIDE * circle.radius * np.stack([np.cos(around), np.sin(around)], axis=-1)
    box = camera.to_picture(rim) / 2
    tall, wide = picture.blue.shape
    left, top = np.floor(box.min(axis=0)).astype(int).clip(0, [wide, tall])
    right, bottom = (np.ceil(box.max(axis=0)).astype(int) + 1).clip(0, [wide, tall])
    if right - left < 3 or bottom - top < 3:
        return None
    cut = np.s_[top:bottom, left:right]
    columns, rows = np.meshgrid(
        np.arange(left, right) * 2.0 + picture.chroma[0], np.arange(top, bottom) * 2.0 + picture.chroma[1]
    )
    points = camera.to_plane(np.stack([columns, rows], axis=-1))
    ratio = np.hypot(points[..., 0] - circle.x, points[..., 1] - circle.y) / circle.radius
    blue, red = picture.blue[cut].astype(float) - 128, picture.red[cut].astype(float) - 128
    return _Patch(blue, red, rows, points, ratio)


def _spots_of(patch: _Patch, circle: Circle, weight: Floats) -> list[Spot]:
    """Return connected regions with a weight, the largest first, at the mean of their samples."""
    ndimage = need("scipy.ndimage", "track")
    labels, _ = ndimage.label(weight > 0.0, structure=np.ones((3, 3)))
    samples = np.stack([patch.points[..., 0], patch.points[..., 1], patch.rows, patch.blue, patch.red], axis=-1)
    result = []
    for k, box in enumerate(ndimage.find_objects(labels), 1):
        own = np.where(labels[box] == k, weight[box], 0.0)
        area = float(own.sum())
        if area >= FEWEST:
            x, y, row, blue, red = (np.einsum("ij,ijk->k", own, samples[box]) / area).tolist()
            result.append(Spot(x, y, row, blue, red, float(np.hypot(x - circle.x, y - circle.y) / circle.radius), area))
    return sorted(result, key=lambda spot: -spot.area)


def spots(picture: Picture, camera: Camera, circle: Circle, marker: Marker) -> list[Spot]:
    """Find patches of the marker's colour at its distance from the centre, the largest first."""
    patch = _patch(picture, camera, circle)
    if patch is None:
        return []
    size = float(np.hypot(marker.blue, marker.red))
    along = (patch.blue * marker.blue + patch.red * marker.red) / size
    across = np.abs(patch.blue * marker.red - patch.red * marker.blue) / size
    # a ramp about half of the full colour, so that blur and subsampled chroma do not move the centroid
    weight = ((along - 0.6 * np.maximum(across - 0.15 * size, 0.0)) / size - 0.25).clip(0.0, 0.5) * 2.0
    if np.isfinite(marker.ratio):
        near = np.abs(patch.ratio - marker.ratio) < max(0.2, 8.0 / circle.radius)
    else:
        near = patch.ratio < OUTSIDE
    return _spots_of(patch, circle, np.where(near, weight, 0.0))


def find_marker(seen: list[tuple[Picture, Circle]], camera: Camera) -> Marker | None:
    """Find the coloured patch at a constant distance from the moving centre.

    seen: pictures with the hoop in them; marker: None if there is no such patch in at least half of the pictures.
    """
    found: list[tuple[int, Spot]] = []
    for frame, (picture, circle) in enumerate(seen):
        patch = _patch(picture, camera, circle)
        if patch is not None:
            chroma = np.hypot(patch.blue - np.median(patch.blue), patch.red - np.median(patch.red))
            chroma[(patch.ratio >= OUTSIDE) | (patch.ratio <= INSIDE)] = 0.0
            most = float(chroma.max())
            weight = np.where(chroma > max(PALE, 0.45 * most), chroma / max(most, PALE), 0.0)
            found += [(frame, spot) for spot in _spots_of(patch, circle, weight)]
    best: dict[int, Spot] = {}
    for _, seed in found:
        alike = {frame: spot for frame, spot in found if _alike(spot, seed)}
        best = max(best, alike, key=len)
    if len(best) < max(2, 0.5 * len(seen)):
        return None
    blue, red, ratio = np.median([(spot.blue, spot.red, spot.ratio) for spot in best.values()], axis=0).tolist()
    return refine_marker(Marker(blue, red, ratio, np.nan), seen, camera)


def _alike(one: Spot, other: Spot) -> bool:
    size = np.hypot(other.blue, other.red)
    apart = np.hypot(one.blue - other.blue, one.red - other.red)
    return bool(apart < max(0.3 * size, 10.0) and abs(one.ratio - other.ratio) < 0.08)


def refine_marker(marker: Marker, seen: list[tuple[Picture, Circle]], camera: Camera) -> Marker:
    """Return the marker with its median distance and size."""
    largest = [found[0] for picture, circle in seen if (found := spots(picture, camera, circle, marker))]
    if not largest:
        return marker
    ratio, area = np.median([(spot.ratio, spot.area) for spot in largest], axis=0).tolist()
    return marker._replace(ratio=ratio, area=area)
