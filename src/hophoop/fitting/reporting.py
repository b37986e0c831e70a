"""The page of a fit: parameters, residuals, and the film with the fitted hoop."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path

import numpy as np

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop._support.pages import render
from hophoop._version import __version__
from hophoop.fitting.channels import KINDS, Floats
from hophoop.fitting.result import GIVEN, Fit
from hophoop.plots.curves import phases
from hophoop.plots.over_time import Row, over_time
from hophoop.tracking import overlay
from hophoop.vocabulary import colors


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
    result = np.full((len(fit.track.t), 3), np.nan)
    result[run.first : run.first + len(run.t)] = np.column_stack([places[name] for name in ("x", "y", "angle")])
    return result[:, :2], result[:, 2]


def _page(fit: Fit, film: str | None) -> str:
    residuals: list[Row] = []
    modes: dict[str, str] = {}
    for (k, channel, _), off in zip(fit.problem.pieces, fit.residuals.values(), strict=True):
        run, parts = fit.problem.runs[k], phases(fit.motions[k])
        modes |= {part.word: colors.mode_color(part.word) for part in parts}
        unit, errors = next(kind.unit for kind in KINDS.values() if channel.name in kind.channels), 1e3 * channel.errors
        of_run = f", run {k + 1}" if fit.alone else ""
        label = f"{channel.name} ({unit}){of_run}, one standard deviation {float(np.median(errors)):.2g}"
        ribbon = [(part.t, part.end_t, modes[part.word]) for part in parts]
        residuals.append(Row(label, run.t[channel.rows], off * errors, ribbon))
    return render(
        need("jinja2", "fit"),
        "fitting/fit.html",
        version=__version__,
        source=fit.source,
        sentences=fit.sentences(),
        details=fit.details(),
        found=fit.rows(given=False),
        given=[(name, text.removesuffix(GIVEN), meaning) for name, text, meaning in fit.rows() if text.endswith(GIVEN)],
        comparison=fit.comparison() if fit.alone else [],
        query=fit.scenario.to_query(),
        film=film,
        modes=modes,
        residuals=_svg(residuals),
    )


def _svg(rows: list[Row]) -> str:
    """Return a figure of residuals as an element of a page."""
    with io.StringIO() as stream, need("matplotlib", "fit").rc_context({"svg.fonttype": "none"}):
        over_time(rows, need("matplotlib.figure", "fit").Figure()).savefig(
            stream, format="svg", transparent=True, metadata={"Date": None}
        )
        return stream.getvalue().partition("<!DOCTYPE")[2].partition(">\n")[2]
