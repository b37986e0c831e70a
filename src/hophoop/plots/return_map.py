"""The return map of a hoop on a slope, with the path of a motion between map and diagonal."""

from __future__ import annotations

import math

import numpy as np

from hophoop._support.errors import check_whole
from hophoop.gaits.return_map import ReturnMap
from hophoop.kernel.model import MODE_LETTERS
from hophoop.plots.style import Axes, finish, new_axes
from hophoop.vocabulary import colors

FLIGHT = MODE_LETTERS[3]
MOST = 100_000


def return_map(
    found: ReturnMap, ax: Axes | None = None, start: float | None = None, passages: int = 100, skip: int = 0
) -> Axes:
    """Draw a return map with its diagonal, and a motion as steps between both (a cobweb).

    Pieces with a hop have the colour of flight, those without that of rolling; corners have a dot, jumps a dotted line.

    Parameters
    ----------
    found : ReturnMap
    ax : matplotlib.axes.Axes, optional
        New ones by default.
    start : float, optional
        θ̇ from which the motion is drawn; none by default [rad/s].
    passages : int, default 100
        Passages of the motion, at least 1 [1].
    skip : int, default 0
        Passages that are left out at its start, until it has settled [1].

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If passages or skip is not allowed.
    ImportError
        If Matplotlib is missing.
    """
    for name, value, least in (("passages", passages, 1), ("skip", skip, 0)):
        check_whole(name, value, least, MOST)
    ax = new_axes(ax, (5.0, 5.0))
    low, high = float(found.pieces[0].omega[0]), float(found.pieces[-1].omega[-1])
    ax.plot([low, high], [low, high], color=colors.GRAY, linewidth=1.0)
    if start is not None:
        steps = _steps(found, start, passages, skip)
        ax.plot(steps[:, 0], steps[:, 1], color=colors.BLACK, linewidth=0.6, alpha=0.5)
    for piece in found.pieces:
        name, mode = ("with a hop", "flight") if FLIGHT in piece.sequence else ("without a hop", "roll")
        ax.plot(piece.omega, piece.after, color=colors.MODES[mode], linewidth=1.8, label=name)
    for end in found.ends:
        one = next(piece for piece in found.pieces if float(piece.omega[-1]) == end.omega)
        if end.kind == "corner":
            ax.plot(end.omega, one.after[-1], "o", color=colors.BLACK, markersize=2.5)
        else:
            ax.axvline(end.omega, color=colors.GRAY, linewidth=0.7, linestyle=":")
    ax.set_xlim(low, high)
    finish(ax, r"$\dot\theta$ at the bottom (rad/s)", r"$\dot\theta$ one passage later (rad/s)")
    return ax


def _steps(found: ReturnMap, omega: float, passages: int, skip: int) -> np.ndarray:
    """Corners of the path from the diagonal to the map and back, until the motion passes the bottom no more."""
    corners = []
    for k in range(passages + skip):
        after = found(omega)
        if math.isnan(after):
            break
        if k >= skip:
            corners += [(omega, omega), (omega, after)]
        omega = after
    return np.array(corners or [(math.nan, math.nan)])
