"""The track drawn over the film: a film, and a page of stills."""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop._support.pages import render
from hophoop._version import __version__
from hophoop.scenario import InputError
from hophoop.tracking.plots import Curve, plot
from hophoop.tracking.table import FOUND, LOST, Track, View
from hophoop.tracking.video import Picture, jpeg, open_writer, pictures, rgb

Floats = NDArray[np.float64]
Colour = tuple[int, int, int]

RIM, MARK, GROUND, GONE = (255, 214, 10), (0, 229, 255), (255, 255, 255), (230, 30, 30)
MODEL = (255, 60, 220)  # a computed hoop
POINTS = "#0a6"
DARK = (20, 20, 20)
FAR = 1e5  # of a point outside the picture [pixel]
STILLS = 9
LOST_STILLS = 3
STILL_WIDTH = 640


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
    rim = centre + radius * np.stack([np.sin(around), np.cos(around)], axis=-1)
    pieces = np.array_split(rim, 2 * dashes)[::2] if dashes else [rim]
    for piece in pieces:
        curve(pen, view.to_picture(piece, radius), colour)
    cross = 0.06 * radius
    for along in ((cross, 0.0), (0.0, cross)):
        curve(pen, view.to_picture(np.array([centre - along, centre + along]), radius), colour, 1)
    if np.isfinite(angle):
        reach = radius * (view.marker_ratio if np.isfinite(view.marker_ratio) else 1.0)
        tip = centre + reach * np.array([np.sin(angle), np.cos(angle)])
        curve(pen, view.to_picture(np.array([centre, tip]), radius), MARK)
        small = tip + 0.05 * radius * np.stack([np.sin(around), np.cos(around)], axis=-1)
        curve(pen, view.to_picture(small, radius), MARK)


def _draw_frame(picture: Picture, track: Track, row: int, model: tuple[Floats, Floats] | None) -> Any:
    """Return a picture of Pillow with the hoop of a row, and with the computed one."""
    image = need("PIL.Image", "track").fromarray(rgb(picture))
    pen = need("PIL.ImageDraw", "track").Draw(image)
    view = track.view
    assert view is not None
    span = np.linspace(np.nanmin(track.centre[:, 0]) - 3 * track.radius, np.nanmax(track.centre[:, 0]) + 3 * track.radius, 60)
    curve(pen, view.to_picture(np.stack([span, 0.0 * span], axis=-1), track.radius), GROUND, 1)
    if track.state[row] == LOST:
        pen.rectangle((0, 0, image.width - 1, image.height - 1), outline=GONE, width=max(4, image.width // 160))
    else:
        draw(pen, view, track.radius, track.centre[row], track.angle[row])
    if model is not None and np.isfinite(model[0][row]).all():
        draw(pen, view, track.radius, model[0][row], model[1][row], MODEL, 12)
    return image


def overlay(
    video: str | Path,
    track: Track,
    film: str | Path | None = None,
    page: str | Path | None = None,
    progress: Callable[[int, int], None] | None = None,
    model: tuple[Floats, Floats] | None = None,
) -> None:
    """Draw a track over its film.

    Parameters
    ----------
    video : str or Path
        The film that was tracked.
    track : Track
    film : str or Path, optional
        Film to write, ends in .mp4: rim, marker and ground, and a red border while the hoop is lost.
    page : str or Path, optional
        Page of stills to write, ends in .html.
    progress : callable, optional
        Called with the number of frames done and of all.
    model : tuple of ndarray, optional
        Another hoop to draw: its centre in each frame, shape (n, 2) [m], and the angle of its marker, shape (n,) [rad].

    Raises
    ------
    ValueError
        If the track is not of a film, or a name has another ending.
    OSError
        If a file cannot be read or written.
    ImportError
        If PyAV is missing.
    """
    if track.view is None:
        raise InputError("The track is not of a film, so it cannot be drawn over one.")
    for name, path, ending in (("film", film, ".mp4"), ("page", page, ".html")):
        if path is not None and Path(path).suffix.lower() != ending:
            raise InputError(f"{name} = {path} must end in {ending}.", field=name, value=path)
    wanted = set(_stills(track)) if page is not None else set()
    stills: list[tuple[int, bytes]] = []
    camera = track.view.camera
    target: Any = nullcontext(None) if film is None else open_writer(Path(film), (camera.width, camera.height))
    with target as add:
        for row, picture in _rows(video, track):
            if add is not None or row in wanted:
                image = _draw_frame(picture, track, row, model)
                if add is not None:
                    add(np.asarray(image), picture.t)
                if row in wanted:
                    stills.append((row, jpeg(np.asarray(image.reduce(max(1, image.width // STILL_WIDTH))))))
            if progress is not None:
                progress(row + 1, len(track.t))
    if page is not None:
        with replacing(Path(page)) as fresh:
            fresh.write_text(_page(track, stills, None if film is None else Path(film).name), encoding="utf-8")


def _rows(video: str | Path, track: Track) -> Iterator[tuple[int, Any]]:
    assert track.view is not None
    for picture in pictures(video, track.view.rate):
        row = picture.row - track.view.first
        if row >= len(track.t):
            break
        if row >= 0:
            yield row, picture


def _stills(track: Track) -> list[int]:
    """Frames from the whole film, and some without hoop or marker."""
    found = np.flatnonzero(track.found)
    even = found[np.unique(np.linspace(0, len(found) - 1, STILLS).astype(int))]
    missing = np.array([k for k, word in enumerate(track.state) if word != FOUND], dtype=int)
    if len(missing):
        missing = missing[np.unique(np.linspace(0, len(missing) - 1, LOST_STILLS).astype(int))]
    return sorted({*even.tolist(), *missing.tolist()})


def _page(track: Track, stills: list[tuple[int, bytes]], film: str | None) -> str:
    good, bare = int(track.found.sum()), sum(word != FOUND for word in track.state)
    usual = [
        float(np.nanmedian(values)) if np.isfinite(values).any() else np.nan
        for values in (track.centre_error, track.angle_error)
    ]
    words = [f"Found in {good} of {len(track.t)} frames, with marker in {len(track.t) - bare}."]
    words.append(f"Typical uncertainty of the centre {1e3 * usual[0]:.2g} mm" + ("." if np.isnan(usual[1]) else ""))
    if np.isfinite(usual[1]):
        words[-1] += f", of the angle {1e3 * usual[1]:.2g} mrad."
    words += track.notes
    captions = [f"t = {track.t[row]:.3f} s, {track.state[row]}" for row, _ in stills]
    for k, (row, _) in enumerate(stills):
        if np.isfinite(track.angle[row]):
            captions[k] += f", {np.degrees(track.angle[row]):.1f}°"
    curves = {
        "x (m)": track.centre[:, 0],
        "height of the rim above the plane (mm)": 1e3 * (track.centre[:, 1] - track.radius),
        "angle (°)": np.degrees(track.angle),
    }
    return render(
        need("jinja2", "track"),
        "tracking/track.html",
        version=__version__,
        source=track.source,
        summary=" ".join(words),
        film=film,
        stills=[(base64.b64encode(image).decode("ascii"), text) for (_, image), text in zip(stills, captions, strict=True)],
        plots=[plot([Curve(track.t, values, POINTS)], label) for label, values in curves.items() if np.isfinite(values).any()],
    )
