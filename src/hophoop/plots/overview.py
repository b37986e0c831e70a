"""One page with all figures of a motion: `hophoop run --plot`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop.plots.curves import turning
from hophoop.plots.motion import contact_forces, energies, friction_utilization, velocities
from hophoop.plots.path import path
from hophoop.plots.style import Against
from hophoop.results import notebook as portrait
from hophoop.scenario import describe
from hophoop.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.figure import Figure
else:
    Figure = Any

SIZE = (8.5, 10.0)


def overview(motion: Trajectory) -> Figure:
    """Draw path, velocities, energies, forces and friction of a motion on one page.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    figure : matplotlib.figure.Figure
        In a notebook it is shown as the value of a cell, not a second time with pyplot's figures.

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    pyplot = need("matplotlib.pyplot", "plots")
    new = need("matplotlib.figure", "plots").Figure if "inline" in pyplot.get_backend() else pyplot.figure
    figure: Figure = new(figsize=SIZE, layout="constrained")
    _fill(figure, motion)
    return figure


def _fill(figure: Figure, motion: Trajectory) -> None:
    grid = figure.add_gridspec(3, 2, height_ratios=[0.85, 1.0, 1.0])
    path(motion, ax=figure.add_subplot(grid[0, :]))
    across: Against = "time" if turning(motion) else "angle"
    velocities(motion, "time", ax=figure.add_subplot(grid[1, 0]))
    energies(motion, across, ax=figure.add_subplot(grid[1, 1]))
    contact_forces(motion, across, ax=figure.add_subplot(grid[2, 0]))
    friction_utilization(motion, across, ax=figure.add_subplot(grid[2, 1]))
    phases = portrait.shortened(motion.sequence)
    figure.suptitle(f"{describe(motion.scenario)}    phases {phases}    {motion.status}", fontsize=11)


def save_overview(motion: Trajectory, path: str | Path) -> None:
    """Write `overview` to a picture file, atomically.

    path: with an extension that Matplotlib supports, such as .png, .svg or .pdf.
    """
    with replacing(Path(path)) as temporary:
        figure: Figure = need("matplotlib.figure", "plots").Figure(figsize=SIZE, layout="constrained")
        _fill(figure, motion)
        figure.savefig(temporary, dpi=180)
