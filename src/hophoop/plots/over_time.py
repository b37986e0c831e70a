"""Measured quantities over time, one below the other: a track, or the residuals of a fit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.plots.style import SMALL
from hophoop.vocabulary import colors, quantities

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Figure

    from hophoop.tracking import Track
else:
    Figure = Any

Floats = NDArray[np.float64]

WIDTH, HEIGHT = 9.6, 1.7  # of a figure, and of each of its rows [inch]
RIBBON = 0.07  # height of the ribbon below a row, over that of the row


class Row(NamedTuple):
    """A quantity over time."""

    label: str  # with its unit
    t: Floats  # [s]
    values: Floats  # nan where missing
    ribbon: Sequence[tuple[float, float, str]] = ()  # pieces of time [s] and their colour


def over_time(rows: Sequence[Row], figure: Figure) -> Figure:
    """Draw quantities as dots over one axis of time, into an empty figure."""
    figure.set_layout_engine("constrained")
    figure.set_size_inches(WIDTH, 0.4 + HEIGHT * len(rows))
    for row, ax in zip(rows, figure.subplots(len(rows), sharex=True, squeeze=False).flat, strict=True):
        ax.plot(row.t, row.values, ".", color=colors.GREEN, ms=3.5)
        ax.set_title(row.label, loc="left", fontsize=SMALL + 1)
        ax.grid(True, color=colors.GRAY, alpha=0.25, lw=0.6)
        ax.tick_params(labelsize=SMALL)
        ax.tick_params("x", pad=9)  # below the ribbon
        ax.ticklabel_format(useOffset=False)
        for start, end, color in row.ribbon:
            ax.axvspan(start, end, ymin=-RIBBON, ymax=0.0, color=color, lw=0, clip_on=False, zorder=3)
    ax.set_xlabel(quantities.TIME, fontsize=SMALL + 1)
    return figure


def track(found: Track, figure: Figure | None = None) -> Figure:
    """Draw what a track has over time: x, height of the rim above the plane, angle, angular velocity.

    Parameters
    ----------
    found : Track
    figure : matplotlib.figure.Figure, optional
        An empty one; by default a new one.

    Returns
    -------
    figure : matplotlib.figure.Figure

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    known = {
        "x (m)": found.centre[:, 0],
        "Height of the rim above the plane (mm)": 1e3 * (found.centre[:, 1] - found.radius),
        "Angle (°)": np.degrees(found.angle),
        "Angular velocity (rad/s)": found.omega,
    }
    rows = [Row(label, found.t, values) for label, values in known.items() if np.isfinite(values).any()]
    return over_time(rows, figure or need("matplotlib.pyplot", "plots").figure())
