"""Branches of gaits over a parameter, with their special points."""

from __future__ import annotations

from collections.abc import Sequence
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
    named: set[str] = set()
    for one in branches:
        _lines(ax, one, scale, named)
    for kind, mark in MARKS.items():
        special = [point for one in branches for point in one.special if point.kind == kind]
        points = [(point.parameter * scale, point.omega) for point in special]
        if points:
            x, y = np.array(points).T
            style: dict[str, Any] = (
                {"color": colors.BLACK} if mark == "x" else {"facecolor": "white", "edgecolor": colors.BLACK}
            )
            ax.scatter(x, y, marker=mark, s=28, linewidths=0.9, zorder=3, label=kind, **style)
    finish(ax, label, rf"$\dot\theta$ {PLACES[branches[0].section]} (rad/s)")
    return ax


def _lines(ax: Axes, one: Branch, scale: float, named: set[str]) -> None:
    """Draw the parts of a branch that have the same stability and colour."""
    states = list(zip(one.stable.tolist(), (one.hops > 0).tolist(), strict=True))
    begin = 0
    for k in range(1, len(states) + 1):
        if k < len(states) and states[k] == states[begin]:
            continue
        stable, hops = states[begin]
        kind = "gait with hops" if hops else "gait without a hop"
        name = kind + ("" if stable else ", unstable")
        part = slice(begin, min(k + 1, len(states)))
        ax.plot(
            one.parameter[part] * scale, one.omega[part], color=KINDS[kind][0], linewidth=1.8 if stable else 1.2,
            linestyle="-" if stable else (0, (3, 2)), label=None if name in named else name,
        )  # fmt: skip
        named.add(name)
        begin = k
