"""The film of a fit as the background of the drawn motion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from hophoop.fitting.result import Fit
from hophoop.scenario import InputError
from hophoop.tracking.video import open_writer, pictures, rgb

EVERY = 12  # frames between key frames, so that a browser seeks fast


@dataclass(frozen=True)
class Backdrop:
    """A film and where it lies on the plane of the motion.

    Attributes
    ----------
    film : Path
        .mp4, in real time.
    size : tuple of int
        Width and height [pixel].
    corners : tuple of tuple of float
        Where the picture's corners lie, from the top left clockwise: along the plane, and above it [m].
    start : float
        Time of the film at which the motion starts [s].
    """

    film: Path
    size: tuple[int, int]
    corners: tuple[tuple[float, float], ...]
    start: float

    def to_dict(self) -> dict[str, Any]:
        """Position and start of the film, for a page.

        Returns
        -------
        backdrop : dict
            Ready for `json.dumps` [m, s].
        """
        return {"size": self.size, "corners": self.corners, "start": self.start}


def backdrop(fit: Fit, video: str | Path, film: str | Path, progress: Callable[[int, int], None] | None = None) -> Backdrop:
    """Write the film as MP4 for a browser, and compute its position relative to the fitted motion.

    Parameters
    ----------
    fit : Fit
        To a track of that film.
    video : str or Path
        The film that was tracked.
    film : str or Path
        File to write, .mp4.
    progress : callable, optional
        Called with the number of frames done and of all.

    Returns
    -------
    backdrop : Backdrop

    Raises
    ------
    ValueError
        If the fit is not to a track of a film, or the film is another one.
    OSError
        If a file cannot be read or written.
    ImportError
        If PyAV is missing.
    """
    view = fit.track.view
    if view is None:
        raise InputError("The fit is not to a track of a film, so that no film can be laid under it.")
    camera, target = view.camera, Path(film)
    size, first, start = (camera.width, camera.height), view.first + fit.problem.runs[0].first, 0.0
    with open_writer(target, size, EVERY) as add:
        for picture in pictures(video, view.rate):
            if picture.size != size:
                raise InputError(f"{video} is not the film of the track, whose pictures have {size[0]} × {size[1]} pixels.")
            if picture.row == first:
                start = picture.t
            add(rgb(picture), picture.t)
            if progress is not None:
                progress(picture.row + 1, max(len(fit.track.t), picture.row + 1))
    wide, tall = size[0] - 0.5, size[1] - 0.5
    pixels = np.array([[-0.5, -0.5], [wide, -0.5], [wide, tall], [-0.5, tall]])
    tilt, scale, ground = (fit.values[name] for name in ("tilt", "scale", "origin_y"))
    along, above = (view.to_plane(pixels, fit.track.radius) - [0.0, ground]).T
    corners = (along + 1j * above) * np.exp(-1j * tilt) / scale
    return Backdrop(target, size, tuple((corner.real, corner.imag) for corner in corners.tolist()), start)
