"""The track drawn over its film."""

from __future__ import annotations

from collections.abc import Callable
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking.scatter import Floats
from hophoop.tracking.table import Track, View
from hophoop.tracking.video import Picture, open_writer, pictures, rgb

Colour = tuple[int, int, int]

RIM, MARK, GROUND, GONE = (255, 214, 10), (0, 229, 255), (255, 255, 255), (230, 30, 30)
MODEL = (255, 60, 220)  # a computed hoop
DARK = (20, 20, 20)
FAR = 1e5  # of a point outside the picture [pixel]


def curve(pen: Any, pixels: Floats, colour: Colour, width: int = 2) -> None:
    """Draw a line through points, with a dark edge so that it is visible on any background.

    pen: Pillow's ImageDraw; pixels shape (n, 2) [pixel]; colour: red, green and blue [1]; width [pixel].
    """
    if np.isfinite(pixels).all():
        places = [tuple(place) for place in pixels.clip(-FAR, FAR).tolist()]
        for brush, paint in ((width + 2, DARK), (width, colour)):
            pen.line(places, paint, brush, joint="curve")


def draw(pen: Any, view: View, radius: float, centre: Floats, angle: float, colour: Colour = RIM, dashes: int = 0) -> None:
    """Draw a hoop over a picture.

    pen: Pillow's ImageDraw; radius [m]; centre: shape (2,), along the plane and above it [m];
    angle: angle of the marker; nan if unknown [rad]; colour: colour of the rim [1]; dashes: number of gaps in the rim [1].
    """
    around = np.linspace(0.0, 2 * np.pi, 91)
    circle = np.stack([np.sin(around), np.cos(around)], axis=-1)
    cross = 0.06 * np.array([[[-1, 0], [1, 0]], [[0, -1], [0, 1]]])
    lines = [(piece, colour, 2) for piece in np.array_split(circle, 2 * dashes or 1)[::2]]
    lines += [(line, colour, 1) for line in cross]
    if np.isfinite(angle):
        tip = np.nan_to_num(view.marker_ratio, nan=1.0) * np.array([np.sin(angle), np.cos(angle)])
        lines += [(np.array([0.0 * tip, tip]), MARK, 2), (tip + 0.05 * circle, MARK, 2)]
    for points, paint, width in lines:  # in radii from the centre
        curve(pen, view.to_picture(centre + radius * points, radius), paint, width)


def _draw_frame(picture: Picture, track: Track, row: int, model: tuple[Floats, Floats] | None) -> Any:
    """Return a picture of Pillow with the hoop of a row, and with the computed one."""
    image = need("PIL.Image", "track").fromarray(rgb(picture))
    pen = need("PIL.ImageDraw", "track").Draw(image)
    view = track.view
    assert view is not None
    x = track.centre[track.found, 0]
    span = np.linspace(x.min() - 3 * track.radius, x.max() + 3 * track.radius, 60)
    curve(pen, view.to_picture(np.stack([span, 0.0 * span], axis=-1), track.radius), GROUND, 1)
    if np.isnan(track.centre[row, 0]):
        pen.rectangle((0, 0, image.width - 1, image.height - 1), outline=GONE, width=max(4, image.width // 160))
    else:
        draw(pen, view, track.radius, track.centre[row], track.angle[row])
    if model is not None and np.isfinite(model[0][row]).all():
        draw(pen, view, track.radius, model[0][row], model[1][row], MODEL, 12)
    return image


def overlay(
    video: str | Path,
    track: Track,
    film: str | Path,
    progress: Callable[[int, int], None] | None = None,
    model: tuple[Floats, Floats] | None = None,
) -> None:
    """Draw a track over its film: rim, marker and ground, and a red border while the hoop is lost.

    Parameters
    ----------
    video : str or Path
        The film that was tracked.
    track : Track
    film : str or Path
        Film to write, ends in .mp4.
    progress : callable, optional
        Called with the number of frames done and of all.
    model : tuple of ndarray, optional
        Another hoop to draw: its centre in each frame, shape (n, 2) [m], and the angle of its marker, shape (n,) [rad].

    Raises
    ------
    ValueError
        If the track is not of a film, or the name has another ending.
    OSError
        If a file cannot be read or written.
    ImportError
        If PyAV is missing.
    """
    if track.view is None:
        raise InputError("The track is not of a film, so it cannot be drawn over one.")
    if Path(film).suffix.lower() != ".mp4":
        raise InputError(f"film = {film} must end in .mp4.", field="film", value=film)
    camera, first, count = track.view.camera, track.view.first, len(track.t)
    with open_writer(Path(film), (camera.width, camera.height)) as add:
        for row, picture in enumerate(islice(pictures(video, track.view.rate), first, first + count)):
            add(np.asarray(_draw_frame(picture, track, row, model)), picture.t)
            if progress is not None:
                progress(row + 1, count)
