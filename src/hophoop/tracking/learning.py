"""Find hoop, marker and camera in sampled pictures, before the hoop is followed from frame to frame."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.tracking.camera import USUAL_FOCAL, Camera, fit_camera
from hophoop.tracking.circle import Circle, fit_circle
from hophoop.tracking.detection import Hoop, Search, confirm, detect, downsample, reduction
from hophoop.tracking.hints import Hints
from hophoop.tracking.marker import Marker, colour_chroma, find_marker, refine_marker
from hophoop.tracking.video import Picture

Floats = NDArray[np.float64]

ALIKE = 0.12  # relative difference of radii in different pictures while the camera is unknown
TIGHT = 0.004  # relative error of the radius after that
MOST_FOR_CAMERA = 14
STILL = 0.02  # distance over the radius below which a circle belongs to the background


class FilmSetup(NamedTuple):
    """Hoop, marker and camera of a film."""

    search: Search
    marker: Marker | None
    tilted: bool


def learn(pairs: list[tuple[Picture, Picture | None]], hints: Hints, source: str) -> FilmSetup:
    """Find hoop, marker and camera in pictures from the whole film.

    pairs: each with the next one, for the velocity of the hoop; source: name of the film.
    """
    pictures = [picture for picture, _ in pairs]
    wide, tall = pictures[0].size
    if any(picture.size != (wide, tall) for picture in pictures):
        raise InputError(f"{source} has pictures of different sizes.")
    focal = hints.focal or USUAL_FOCAL * max(wide, tall)
    tilt = hints.tilt or (0.0, 0.0)
    camera = Camera(wide, tall, focal, *tilt)
    rng = np.random.default_rng(0)
    search, seen = _hoops(pictures, camera, hints, rng)
    if len(seen) < 2:
        raise InputError(
            f"{source} shows no hoop that could be followed; a hint may help: its centre and radius in a frame, "
            f"or whether it is dark or light."
        )
    if hints.row_delay:
        seen = _correct_rolling_shutter(
            seen, dict(zip(map(id, pictures), (after for _, after in pairs), strict=True)), search, hints.row_delay
        )
    tilted = False
    if hints.tilt is None and len(seen) >= 4:
        chosen = [seen[k] for k in np.unique(np.linspace(0, len(seen) - 1, MOST_FOR_CAMERA).astype(int))]
        edges = [camera.to_picture(hoop.rim.points) for _, hoop in chosen]
        camera, tilted = fit_camera(camera, edges, hints.focal is not None)
    whole = [hoop.rim for _, hoop in seen if hoop.rim.seen > 0.6] or [hoop.rim for _, hoop in seen]
    radius = float(np.median([fit_circle(camera.to_plane(search.camera.to_picture(rim.points)))[2] for rim in whole]))
    before = search.camera
    search = search._replace(camera=camera, expected=(radius, TIGHT * radius))
    again = []
    for picture, hoop in seen:
        point = camera.to_plane(before.to_picture(np.array(hoop.rim.circle[:2])))
        found = confirm(picture.luma, search, Circle(float(point[0]), float(point[1]), radius))
        if found is not None:
            again.append((picture, found.rim.circle))
    if len(again) < 2:
        raise InputError(f"{source} shows circles, but none of constant size.")
    places = np.array([circle[:2] for _, circle in again])
    if np.ptp(places, axis=0).max() < STILL * radius:
        raise InputError(f"{source} shows a circle that does not move, but no hoop.")
    # all pictures together give a more accurate radius than each one
    radius = float(np.median([circle.radius for _, circle in again]))
    search = search._replace(expected=(radius, TIGHT * radius))
    return FilmSetup(search, _marker(again, camera, hints), tilted)


def _correct_rolling_shutter(
    seen: list[tuple[Picture, Hoop]],
    following: dict[int, Picture | None],
    search: Search,
    row_delay: float,
) -> list[tuple[Picture, Hoop]]:
    """Return the hoops, with the rolling shutter's distortion of the rim corrected by their velocities."""
    result = []
    for picture, hoop in seen:
        after = following[id(picture)]
        now = hoop.rim.circle
        near = search._replace(expected=(now.radius, 0.02 * now.radius))
        then = None if after is None else confirm(after.luma, near, now)
        if after is None or then is None:
            continue
        way = np.array([then.rim.circle.x - now.x, then.rim.circle.y - now.y]) / (after.t - picture.t) * row_delay
        again = confirm(picture.luma, near, now, (float(way[0]), float(way[1])))
        if again is not None:
            result.append((picture, again))
    return result if len(result) >= 2 else seen


def _hoops(
    pictures: list[Picture], camera: Camera, hints: Hints, rng: np.random.Generator
) -> tuple[Search, list[tuple[Picture, Hoop]]]:
    """Find the hoop in the pictures, by motion or else by contrast."""
    by = reduction(camera.width)
    sign = {"dark": 1, "light": -1}.get(hints.ring, 0)
    small = np.stack([downsample(picture.luma, by) for picture in pictures])
    background = np.median(small, axis=0)
    given = _hoop_at_hint(pictures, camera, hints, sign)
    best: list[tuple[Picture, Hoop]] = []
    result = Search(camera, None, by, sign, None)
    for way in (background, None):
        search = Search(camera, way, by, sign, None)
        if given is not None:
            search = search._replace(sign=given.sign, expected=(given.rim.circle.radius, ALIKE / 4 * given.rim.circle.radius))
        found = []
        for picture in pictures:
            hoop = detect(picture.luma, search, rng)
            if hoop is not None:
                found.append((picture, hoop))
        alike = _most_alike(found)
        if len(alike) > len(best):
            best, result = alike, search._replace(sign=alike[0][1].sign)
        if len(best) >= max(2, 0.1 * len(pictures)):
            break
    return result, best


def _hoop_at_hint(pictures: list[Picture], camera: Camera, hints: Hints, sign: int) -> Hoop | None:
    """Find the hoop at the hinted centre."""
    if hints.centre is None or hints.rim is None:
        return None
    picture = min(pictures, key=lambda one: abs(one.t - hints.at))
    place = camera.to_plane(np.array(hints.centre, dtype=float))
    search = Search(camera, None, 1, sign, None)
    hoop = confirm(picture.luma, search, Circle(float(place[0]), float(place[1]), hints.rim))
    if hoop is None:
        raise InputError(
            f"centre = {hints.centre[0]:g}, {hints.centre[1]:g} and a rim of {hints.rim:g} pixels show no rim "
            f"in the frame at {picture.t:.3f} s.",
            field="centre",
            value=hints.centre,
        )
    return hoop


def _most_alike(found: list[tuple[Picture, Hoop]]) -> list[tuple[Picture, Hoop]]:
    """Return the largest group of one size and one contrast, of equal ones the best."""

    def alike(one: Hoop, other: Hoop) -> bool:
        size = other.rim.circle.radius
        return one.sign == other.sign and abs(one.rim.circle.radius - size) < ALIKE * size

    groups = ([pair for pair in found if alike(pair[1], seed)] for _, seed in found)
    return max(groups, key=lambda group: (len(group), sum(hoop.rim.share for _, hoop in group)), default=[])


def _marker(seen: list[tuple[Picture, Circle]], camera: Camera, hints: Hints) -> Marker | None:
    if hints.marker_color == "none":
        return None
    if hints.marker_color == "auto":
        return find_marker(seen, camera)
    blue, red = colour_chroma(hints.marker_color)
    found = refine_marker(Marker(blue, red, np.nan, np.nan), seen, camera)
    if np.isnan(found.area):
        raise InputError(
            f"marker_color = {hints.marker_color!r}: no patch of that colour was seen on the hoop.",
            field="marker_color",
            value=hints.marker_color,
        )
    return found
