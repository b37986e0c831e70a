"""The page of a fit: parameters, residuals, and the film with the fitted hoop."""

from __future__ import annotations

import io
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop._support.pages import render
from hophoop._version import __version__
from hophoop.fitting.problem import Run
from hophoop.fitting.result import GIVEN, Fit
from hophoop.plots.over_time import Row, over_time
from hophoop.simulation.trajectory import Trajectory
from hophoop.tracking import overlay
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import mode_words

Floats = NDArray[np.float64]

UNITS = {"angle": "mrad", "omega": "mrad/s"}  # of residuals; those of places are in mm


def report(
    fit: Fit, folder: str | Path, video: str | Path | None = None, progress: Callable[[int, int], None] | None = None
) -> Path:
    """Write a fit as a page, with its scenario, and with the film if there is one.

    Parameters
    ----------
    fit : Fit
    folder : str or Path
        Created if missing: index.html, fit.json, scenario.toml, and fitted.mp4 with a film.
    video : str or Path, optional
        The film of the track, to draw the fitted hoop over.
    progress : callable, optional
        Called with the number of frames drawn and of all.

    Returns
    -------
    page : Path

    Raises
    ------
    ValueError
        If a film is given and the track is not of a film.
    OSError
        If a file cannot be written.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    fit.save(target / "fit.json")
    fit.scenario.save(target / "scenario.toml")
    film = None
    if video is not None:
        film = target / "fitted.mp4"
        overlay(video, fit.track, film, progress=progress, model=places_in_film(fit))
    page = target / "index.html"
    with replacing(page) as fresh:
        fresh.write_text(_page(fit, None if film is None else film.name), encoding="utf-8")
    return page


def places_in_film(fit: Fit) -> tuple[Floats, Floats]:
    """Centre and marker's angle of the fitted motion in every frame of the track; nan outside the data's time.

    centre shape (n, 2) [m]; angle shape (n,) [rad].
    """
    run = fit.problem.runs[0]
    places = run.places(fit.motion, run.own(fit.values))
    first = first_row(fit)
    count = len(run.t)
    centre, angle = np.full((len(fit.track.t), 2), np.nan), np.full(len(fit.track.t), np.nan)
    centre[first : first + count] = np.stack([places["x"], places["y"]], axis=-1)
    angle[first : first + count] = places["angle"]
    return centre, angle


def first_row(fit: Fit) -> int:
    """Return the first row of the track with data, the start of the motion [1]."""
    track = fit.track
    known = np.isfinite([track.centre[:, 0], track.marker[:, 0], track.angle, track.omega]).any(axis=0)
    return int(np.flatnonzero(known)[0])


def on_plane(values: dict[str, float], x: Floats, y: Floats, ground: float) -> tuple[Floats, Floats]:
    """Places or velocities of the data along the plane and away from it: tilt and scale undone.

    values: of a fit; x, y: shape (n,), in the data's axes [m or m/s]; ground: height of the plane in the data, 0 for velocities
    [m]; along, away shape (n,) [m or m/s].
    """
    cos, sin = np.cos(values["tilt"]) / values["scale"], np.sin(values["tilt"]) / values["scale"]
    return cos * x + sin * (y - ground), -sin * x + cos * (y - ground)


def _page(fit: Fit, film: str | None) -> str:
    residuals = []
    words: dict[str, None] = {}
    for k, (run, motion) in enumerate(zip(fit.problem.runs, fit.motions, strict=True)):
        ribbon, of_run = _ribbon(run, motion), f", run {k + 1}" if fit.alone else ""
        for channel in run.channels:
            unit, errors = UNITS.get(channel.name, "mm"), 1e3 * channel.errors
            off = fit.residuals[channel.name + run.suffix] * errors
            label = f"{channel.name} ({unit}){of_run}, one standard deviation {float(np.median(errors)):.2g}"
            residuals.append(Row(label, run.t[channel.rows], off, ribbon))
        state = motion.at(motion.times(600))
        words |= dict.fromkeys(mode_words(state.mode, state.omega).tolist())
    return render(
        need("jinja2", "fit"),
        "fitting/fit.html",
        version=__version__,
        source=fit.source,
        sentences=fit.sentences(),
        details=fit.details(),
        found=[row for row in fit.rows() if not row[1].endswith(GIVEN)],
        given=[(name, text.removesuffix(GIVEN), meaning) for name, text, meaning in fit.rows() if text.endswith(GIVEN)],
        comparison=fit.comparison() if fit.alone else [],
        query=fit.scenario.to_query(),
        film=film,
        modes=[(word, colors.mode_color(word)) for word in words],
        residuals=_svg(residuals),
    )


def _svg(rows: list[Row]) -> str:
    """Return a figure of residuals as an element of a page."""
    with io.StringIO() as stream, need("matplotlib", "fit").rc_context({"svg.fonttype": "none"}):
        over_time(rows, need("matplotlib.figure", "fit").Figure()).savefig(
            stream, format="svg", transparent=True, metadata={"Date": None}
        )
        return stream.getvalue().partition("<!DOCTYPE")[2].partition(">\n")[2]


def _ribbon(run: Run, motion: Trajectory) -> list[tuple[float, float, str]]:
    """Pieces of time and the colour of their mode."""
    t = np.linspace(0.0, min(float(run.t[-1]), motion.duration), 600)
    state = motion.at(t)
    modes = mode_words(state.mode, state.omega)
    borders = [0, *(np.flatnonzero(modes[1:] != modes[:-1]) + 1).tolist(), len(t)]
    return [(float(t[a]), float(t[min(b, len(t) - 1)]), colors.mode_color(str(modes[a]))) for a, b in pairwise(borders)]
