"""Attractors over a parameter: the bifurcation diagram of a hoop."""

from __future__ import annotations

import numpy as np

from hophoop.gaits.diagram import Attractor, Diagram
from hophoop.plots.style import Axes, finish, new_axes, parameter_axis
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import FATES, Fate

SIZE = (8.0, 4.2)
KINDS = {  # colour and size of the dots
    "gait without a hop": (colors.MODES["roll"], 1.6),
    "gait with hops": (colors.MODES["flight"], 1.6),
    "chaos": (colors.BLACK, 0.25),
    "not decided": (colors.GRAY, 0.25),
}


def diagram(found: Diagram, ax: Axes | None = None, speed: bool = False) -> Axes:
    """Draw θ̇ at the passages on which a hoop settles, over the parameter.

    Where no start settles on a gait or on chaos, the ground is grey, and the legend names the fates.

    Parameters
    ----------
    found : Diagram
    ax : matplotlib.axes.Axes, optional
        New ones by default.
    speed : bool, default False
        Draw the mean velocity of the centre instead.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    ax = new_axes(ax, SIZE)
    scale, label = parameter_axis(found.path)
    across = found.values * scale
    _shade_ends(ax, found, across)
    for kind, (color, size) in KINDS.items():
        points = [
            (x, height)
            for x, several in zip(across.tolist(), found.attractors, strict=True)
            for one in several
            if _kind(one) == kind
            for height in ([one.speed] if speed else one.omega.tolist())
        ]
        if points:
            x, y = np.transpose(points)
            ax.scatter(x, y, s=size, color=color, linewidths=0, rasterized=True)
            ax.scatter([], [], s=20, color=color, linewidths=0, label=kind)
    ax.set_xlim(float(across.min()), float(across.max()))
    up = "Mean speed (m/s)" if speed else r"$\dot\theta$ at the " + found.section + " (rad/s)"
    finish(ax, label, up)
    return ax


def _kind(one: Attractor) -> str | None:
    """Return the kind of an attractor that goes on over the top."""
    if one.fate == Fate.GAIT:
        return "gait with hops" if one.hops else "gait without a hop"
    return {Fate.CHAOTIC: "chaos", Fate.UNDECIDED: "not decided"}.get(one.fate)


def _shade_ends(ax: Axes, found: Diagram, across: np.ndarray) -> None:
    """Tint the values at which no start settles on a motion that goes on."""
    ended = [all(_kind(one) is None for one in several) for several in found.attractors]
    half = 0.5 * float(np.median(np.diff(across))) if len(across) > 1 else 0.5
    fates = {one.fate for several, over in zip(found.attractors, ended, strict=True) if over for one in several}
    label = ", ".join(str(fate) for fate in FATES if fate in fates)
    changes = np.flatnonzero(np.diff(ended, prepend=False, append=False))
    for first, last in zip(changes[::2], changes[1::2] - 1, strict=True):
        ax.axvspan(across[first] - half, across[last] + half, color=colors.GRAY, alpha=colors.SHADE, linewidth=0, label=label)
