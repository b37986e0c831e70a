"""The article's figures, redrawn from computed motions, and some more."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from typing import TYPE_CHECKING, Any

import numpy as np

from hophoop import plots
from hophoop._support.extras import need
from hophoop.article.compliant_figures import energy_balance, landing_against_restitution
from hophoop.article.runs import LONG, Runs
from hophoop.article.scenarios import RUNS, title
from hophoop.article.slipping import after_each_slip
from hophoop.plots.style import Axes, finish
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary import colors, quantities

if TYPE_CHECKING:
    from matplotlib.figure import Figure
else:
    Figure = Any


@dataclass(frozen=True)
class ArticleFigure:
    """One figure: name of its files and its row of figures.toml."""

    name: str
    section: str
    caption: str
    plot: str
    motions: Sequence[str] = ()
    against: str | None = None
    turn: bool = False  # only the first 360°
    size: Sequence[float] = (7.2, 4.1)
    ours: bool = False
    long: bool = False


def draw_figure(figure: ArticleFigure, runs: Runs) -> Figure:
    """Draw a figure outside of pyplot."""
    sheet: Figure = need("matplotlib.figure", "plots").Figure(figsize=figure.size, layout="constrained")
    ax = sheet.subplots()
    if figure.plot in SPECIAL:
        SPECIAL[figure.plot](runs, ax)
        return sheet
    motions: Any = [runs.motion(name) for name in figure.motions]
    options: dict[str, Any] = {} if figure.against is None else {"against": figure.against}
    if len(motions) > 1:
        motions, options["labels"] = [motions], [title(name) for name in figure.motions]
    getattr(plots, figure.plot)(*motions, ax=ax, **options)
    if figure.turn:
        ax.set_xlim(0.0, 360.0)
    return sheet


def first_swing(runs: Runs, ax: Axes) -> None:
    """Path to the first turning point and back to the next; later ones would cover it."""
    motion = runs.motion("low_friction")
    back = motion.find("turn")[1].t
    plots.path(simulate(motion.scenario.replace("duration", back)), ax=ax)


def phase_plane(runs: Runs, ax: Axes) -> None:
    motions = [runs.motion(name) for name in RUNS]
    # up to the turning point: the rocking has its own figure
    motions[-1] = simulate(motions[-1].scenario.replace("duration", motions[-1].find("turn")[0].t))
    plots.phase_plane(
        runs.hoop, runs.plane, motions, [title(name) for name in RUNS], ax=ax,
        angles=(0.0, math.radians(540.0)), speeds=(0.0, 12.0),
    )  # fmt: skip


def phase_plane_low(runs: Runs, ax: Axes) -> None:
    motion = runs.motion("low_friction")
    plots.phase_plane(motions=[motion], ax=ax, angles=(0.0, 2.0 * math.pi), speeds=(-8.0, 8.0))


def slow_end(runs: Runs, ax: Axes) -> None:
    """Excess energy of the motion at 2.8 m/s over that at which slip would end."""
    t, excess = after_each_slip(runs)
    ax.loglog(t, excess, ".", color=colors.TOTAL, ms=3, label="after each slip")
    law, late = excess[-1] * t[-1], t[t > 10.0]
    ax.loglog(late, law / late, color=colors.LIMIT, lw=1.4, ls=(0, (5, 2)), label=f"{law:.0f} J s / t")
    ax.set_xlim(0.5, LONG * 1.2)
    finish(ax, quantities.TIME, "Energy above rolling at the critical speed (J)")


def both_models(_: Runs, ax: Axes) -> None:
    sheet = ax.figure
    ax.remove()
    energy_balance(*sheet.subplots(1, 2, sharey=True))


def landing_restitution(_: Runs, ax: Axes) -> None:
    landing_against_restitution(np.linspace(0.0, 0.9, 10), ax)


SPECIAL: dict[str, Callable[[Runs, Axes], Any]] = {
    function.__name__: function
    for function in (first_swing, slow_end, both_models, landing_restitution, phase_plane, phase_plane_low)
}
_ROWS = tomllib.loads(files("hophoop.article").joinpath("figures.toml").read_text("utf-8"))
FIGURES = tuple(ArticleFigure(name, **row) for name, row in _ROWS.items())
