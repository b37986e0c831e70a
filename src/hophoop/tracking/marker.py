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
OUTSIDE = 1.12  # maximum distance of a marker from the centre, over the radius


class Marker(NamedTuple):
    """Colour, position and size of the marker."""

    blue: float  # its chroma
    red: float
    ratio: float  # distance from the centre over the radius; nan if unknown
    area: float  # sum of its weights in samples of chroma; nan if unknown


class Spot(NamedTuple):
    """A patch of the marker's colour in a picture."""

    x: float  # in rectified pixels
    y: float
    row: float  # of the picture [pixel]
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
    """Chroma of the box around a circle, and the positions of its samples."""

    blue: Floats
    red: Floats
    pixels: Floats  # [pixel]
    points: Floats  # [rectified pixels]


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
    pixels = np.stack([columns, rows], axis=-1)
    blue, red = picture.blue[cut].astype(float) - 128, picture.red[cut].astype(float) - 128
    return _Patch(blue, red, pixels, camera.to_plane(pixels))


def spots(picture: Picture, camera: Camera, circle: Circle, marker: Marker) -> list[Spot]:
    """Find patches of the marker's colour at its distance from the centre, the largest first."""
    ndimage = need("scipy.ndimage", "track")
    patch = _patch(picture, camera, circle)
    if patch is None:
        return []
    size = float(np.hypot(marker.blue, marker.red))
    along = (patch.blue * marker.blue + patch.red * marker.red) / size
    across = np.abs(patch.blue * marker.red - patch.red * marker.blue) / size
    # a ramp about half of the full colour, so that blur and subsampled chroma do not move the centroid
    weight = ((along - 0.6 * np.maximum(across - 0.15 * size, 0.0)) / size - 0.25).clip(0.0, 0.5) * 2.0
    ratio = np.hypot(patch.points[..., 0] - circle.x, patch.points[..., 1] - circle.y) / circle.radius
    if np.isfinite(marker.ratio):
        weight = np.where(np.abs(ratio - marker.ratio) < max(0.2, 8.0 / circle.radius), weight, 0.0)
    else:
        weight = np.where(ratio < OUTSIDE, weight, 0.0)
    labels, _ = ndimage.label(weight > 0.0, structure=np.ones((3, 3)))
    result = []
    for k, box in enumerate(ndimage.find_objects(labels)):
        one = np.where(labels[box] == k + 1, weight[box], 0.0)
        area = float(one.sum())
        if area < FEWEST:
            continue
        x, y = ((one[..., None] * patch.points[box]).sum(axis=(0, 1)) / area).tolist()
        row = float((one * patch.pixels[box][..., 1]).sum() / area)
        result.append(Spot(x, y, row, area))
    return sorted(result, key=lambda spot: -spot.area)


class _Seen(NamedTuple):
    blue: float
    red: float
    ratio: float
    frame: int


def find_marker(seen: list[tuple[Picture, Circle]], camera: Camera) -> Marker | None:
    """Find the coloured patch at a constant distance from the moving centre.

    seen: pictures with the hoop in them; marker: None if there is no such patch in at least half of the pictures.
    """
    ndimage = need("scipy.ndimage", "track")
    patches: list[_Seen] = []
    for frame, (picture, circle) in enumerate(seen):
        patch = _patch(picture, camera, circle)
        if patch is None:
            continue
        usual = np.median(patch.blue), np.median(patch.red)
        chroma = np.hypot(patch.blue - usual[0], patch.red - usual[1])
        away = np.hypot(patch.points[..., 0] - circle.x, patch.points[..., 1] - circle.y) / circle.radius
        inside = (away < OUTSIDE) & (away > 0.15)
        if not inside.any():
            continue
        strong = inside & (chroma > max(PALE, 0.45 * float(chroma[inside].max())))
        labels, count = ndimage.label(strong, structure=np.ones((3, 3)))
        for k in range(1, count + 1):
            own = labels == k
            if own.sum() >= FEWEST:
                core = own & (chroma >= np.quantile(chroma[own], 0.5))
                blue, red = float(patch.blue[core].mean()), float(patch.red[core].mean())
                x, y = (float(np.average(patch.points[..., i][own], weights=chroma[own])) for i in (0, 1))
                ratio = float(np.hypot(x - circle.x, y - circle.y) / circle.radius)
                patches.append(_Seen(blue, red, ratio, frame))
    best: list[_Seen] = []
    for seed in patches:
        alike = [one for one in patches if _alike(one, seed)]
        if len({one.frame for one in alike}) > len({one.frame for one in best}):
            best = alike
    if len({one.frame for one in best}) < max(2, 0.5 * len(seen)):
        return None
    blue, red, ratio = (float(np.median([getattr(one, name) for one in best])) for name in ("blue", "red", "ratio"))
    return refine_marker(Marker(blue, red, ratio, np.nan), seen, camera)


def _alike(one: _Seen, other: _Seen) -> bool:
    size = np.hypot(other.blue, other.red)
    apart = np.hypot(one.blue - other.blue, one.red - other.red)
    return bool(apart < max(0.3 * size, 10.0) and abs(one.ratio - other.ratio) < 0.08)


def refine_marker(marker: Marker, seen: list[tuple[Picture, Circle]], camera: Camera) -> Marker:
    """Return the marker with its median colour, distance and size."""
    ratios, areas = [], []
    for picture, circle in seen:
        found = spots(picture, camera, circle, marker)
        if found:
            ratios.append(np.hypot(found[0].x - circle.x, found[0].y - circle.y) / circle.radius)
            areas.append(found[0].area)
    if not areas:
        return marker
    return marker._replace(ratio=float(np.median(ratios)), area=float(np.median(areas)))
