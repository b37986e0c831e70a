"""Branches of gaits over a parameter, with their special points."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from hophoop.gaits.branch import Branch
from hophoop.plots.diagram import KINDS
from hophoop.plots.style import Axes, finish, new_axes, parameter_axis
from hophoop.vocabulary import colors

PLACES = {"bottom": "at the bottom", "landing": "after the landing"}
MARKS = {
    "fold": "o", "period doubling": "s", "border collision": "D", "joins a shorter period": "^", "top of the hill": "v",
    "end": "x",
}  # fmt: skip


def branch(found: Branch | Sequence[Branch], ax: Axes | None = None) -> Axes:
    """Draw θ̇ at the section over the parameter: stable gaits solid, unstable ones dashed, with marks at special points.

    Parameters
    ----------
    found : Branch or sequence of Branch
        Over one parameter.
    ax : matplotlib.axes.Axes, optional
        New ones by default.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    ax = new_axes(ax, (8.0, 4.2))
    branches = [found] if isinstance(found, Branch) else list(found)
    path = branches[0].path
    scale, label = parameter_axis(path)
    for one in branches:
        _lines(ax, one, scale)
    for kind, mark in MARKS.items():
        special = [point for one in branches for point in one.special if point.kind == kind]
        if special:
            x, y = np.array([(point.parameter * scale, point.omega) for point in special]).T
            face = colors.BLACK if mark == "x" else "white"
            ax.scatter(x, y, marker=mark, s=28, linewidths=0.9, zorder=3, label=kind, facecolor=face, edgecolor=colors.BLACK)
    finish(ax, label, rf"$\dot\theta$ {PLACES[branches[0].section]} (rad/s)")
    return ax


def _lines(ax: Axes, one: Branch, scale: float) -> None:
    """Draw the parts of a branch that have the same stability and colour."""
    stable, hops = np.asarray(one.stable), np.asarray(one.hops) > 0
    changes = np.flatnonzero((stable[1:] != stable[:-1]) | (hops[1:] != hops[:-1])) + 1
    for begin, end in pairwise([0, *changes.tolist(), len(stable)]):
        kind = "gait with hops" if hops[begin] else "gait without a hop"
        part = slice(begin, end + 1)  # up to the next part
        look: dict[str, Any] = (
            {"lw": 1.8, "label": kind} if stable[begin] else {"lw": 1.2, "ls": (0, (3, 2)), "label": f"{kind}, unstable"}
        )
        ax.plot(one.parameter[part] * scale, one.omega[part], color=KINDS[kind][0], **look)
