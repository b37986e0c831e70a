"""The report: a story on one page, with the films in files next to it."""

from __future__ import annotations

import base64
import math
from collections.abc import Mapping, Sequence
from datetime import date
from importlib.resources import files
from pathlib import Path
from typing import Any

from hophoop._support.extras import need
from hophoop._support.pages import render
from hophoop._version import __version__
from hophoop.article.facts import facts
from hophoop.article.figures import FIGURES, ArticleFigure
from hophoop.article.formulas import FORMULAS
from hophoop.article.runs import Runs
from hophoop.article.scenarios import scenarios
from hophoop.article.statement import AGREES, DIFFERS, FAILS, WITHIN_READING, Statement
from hophoop.article.typeset import typeset
from hophoop.plots.curves import phases
from hophoop.plots.style import DARK
from hophoop.scenario import Scenario
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import FLIGHT, ROLL, SKID, SPIN

ARTICLE_URL = "https://www.comsol.com/blogs/the-physics-of-a-hopping-hoop"
STARTS = ("slip_start", "takeoff")  # events of the table of motions
# names in the text: name of the file, and caption
FILMS = {
    "hop": ("v3.1", "The hop, at 3.1 m/s. It runs slower around take-off and landing, where a ring spreads."),
    "slow": ("v0.1", "A nudge of 0.1 m/s. The arrows are the forces of the floor, to the scale shown above."),
    "faster": ("v2", "At 2 m/s it rolls as before, only faster and more evenly."),
    "slipping": ("v2.8", "At 2.8 m/s it slips twice per revolution. Watch the word at the upper left."),
    "low": ("v0.1-mu0.3", "0.1 m/s on μ = 0.3: it slips, turns back, and rocks."),
    "hop3d": ("v3.1-3d", "The hop once more, in three dimensions."),
}
# figures in addition to those in the text, by section
MORE = {
    "rolling": ("path_slow", "velocity_time_slow", "energy_slow"),
    "slipping": ("forces_slow", "friction_slow", "path_faster", "path_slipping", "friction_slipping", "energy_slipping"),
    "landing": ("landing_restitution",),
    "low": ("path_low_friction", "velocity_low_friction", "energy_low_friction"),
}
FILM_SIZE = (960, 540)
# class in the style sheet, and words of the badge
VERDICTS = {
    AGREES: ("agrees", "agree"),
    WITHIN_READING: ("reading", "within reading accuracy"),
    DIFFERS: ("differs", "differ"),
    FAILS: ("fails", "fail"),
}
MODES = {
    ROLL: "the contact point is at rest",
    SPIN: "slips, with the rim rotating faster than it advances",
    SKID: "slides ahead",
    FLIGHT: "in the air",
}
MOST_PHASES = 12  # in the table of motions


def page(statements: Sequence[Statement], folder: Path, films: Sequence[Path], runs: Runs | None = None) -> str:
    """Return the page, with the figures in `folder` and links to the films.

    folder: folder with ``figures/NAME.svg``; films: existing films and pages that turn; a picture of the same name is the
    poster; runs: the motions, if already computed.
    """
    runs = runs or Runs()
    there = {path.name: path for path in films}
    order: list[str] = []

    def number(name: str) -> int:
        """Number of a figure, in the order in which the page shows them."""
        order.append(name)
        return len(order)

    whole = render(
        need("jinja2", "plots"),
        "article/report.html",
        version=__version__,
        today=date.today().isoformat(),
        article_url=ARTICLE_URL,
        font=base64.b64encode(files("hophoop.article").joinpath("fonts", "hoop-math.woff2").read_bytes()).decode("ascii"),
        statements=list(statements),
        verdicts=VERDICTS,
        modes=[(word, colors.MODES[word], meaning) for word, meaning in MODES.items()],
        runs=[_run(scenario, runs.motion(name)) for name, scenario in scenarios().items()],
        number=number,
        figures={figure.name: _figure(figure, folder) for figure in FIGURES},
        more_figures=MORE,
        films={name: _film(*film, there, folder) for name, film in FILMS.items()},
        film_size=FILM_SIZE,
        formulas=FORMULAS,
        **facts(statements, runs),
    )
    return typeset(whole)


def _run(scenario: Scenario, motion: Trajectory) -> dict[str, Any]:
    """A row of the table of motions; a phase has its letter, word and colour, and whether the letter is white."""
    ledger, pieces = motion.ledger, phases(motion)
    inks = {word: (color, colors.lightness(color) < DARK) for word, color in colors.MODES.items()}
    angles = [f"{math.degrees(found[0].angle):.3f}°" if (found := motion.find(kind)) else "–" for kind in STARTS]
    losses = [f"{ledger.friction_loss:.4f}", f"{ledger.normal_loss:.4f}"]
    return {
        "speed": f"{scenario.start.speed:g}",
        "mu": f"{scenario.plane.mu:g}",
        "phases": [(piece.mode, piece.word, *inks[piece.word]) for piece in pieces[:MOST_PHASES]],
        "cut": len(pieces) > MOST_PHASES,
        "cells": [*angles, *losses, f"{abs(ledger.residual):.0e}" if ledger.residual else "0"],
    }


def _figure(figure: ArticleFigure, folder: Path) -> dict[str, Any]:
    """A figure of the page, with its SVG in base64."""
    width, height = (round(96.0 * side) for side in figure.size)
    return {
        "image": base64.b64encode((folder / "figures" / f"{figure.name}.svg").read_bytes()).decode("ascii"),
        "width": width,
        "height": height,
        "wide": figure.size[0] > 8.0,
        "caption": figure.caption,
        "origin": "Not in the article." if figure.ours else f"In the article's part ‘{figure.section}’.",
    }


def _film(name: str, caption: str, there: Mapping[str, Path], folder: Path) -> dict[str, str]:
    """A film of the page; a picture of the same name is its poster, a page of the same name turns."""

    def place(path: Path | None) -> str:
        return path.relative_to(folder).as_posix() if path is not None and path.exists() else ""

    path = there.get(f"{name}.mp4")
    poster, turning = path and path.with_suffix(".png"), there.get(f"{name}.html")
    return {"name": name, "caption": caption, "place": place(path), "poster": place(poster), "turning": place(turning)}
