"""Small plots over time for the pages of tracks and fits; plots.html draws them as SVG."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Points = list[tuple[float, float]]

WIDTHS = {"wide": 900, "narrow": 420}  # of the page's screen [pixel]
HEIGHT, LEFT, TOP, BOTTOM = 170, 70, 22, 150  # of the drawing and of its frame [pixel]


class Curve(NamedTuple):
    """Values over time, as points or as a line."""

    t: Floats  # [s]
    values: Floats
    color: str
    line: bool = False


class Drawing(NamedTuple):
    """A plot in one width: texts, and places in pixels."""

    name: str
    width: int
    right: int
    low: str
    high: str
    start: str
    end: str
    ribbon: list[tuple[float, float, str]]
    zero: float | None
    curves: list[tuple[Curve, Points]]
    height: int = HEIGHT
    left: int = LEFT
    top: int = TOP
    bottom: int = BOTTOM


class Plot(NamedTuple):
    """A plot with its label, drawn for wide and for narrow screens."""

    label: str
    drawings: list[Drawing]


def plot(curves: Sequence[Curve], label: str, ribbon: Sequence[tuple[float, float, str]] = (), zero: bool = False) -> Plot:
    """A small plot over time; missing values are gaps.

    label: quantity and unit; ribbon: pieces of time [s] and their colour, below the plot; zero: whether to draw a line at 0.
    """
    return Plot(label, [_drawing(curves, ribbon, zero, name) for name in WIDTHS])


def _drawing(curves: Sequence[Curve], ribbon: Sequence[tuple[float, float, str]], zero: bool, name: str) -> Drawing:
    known = np.concatenate([curve.values[np.isfinite(curve.values)] for curve in curves])
    low, high = (float(round(one, 9)) for one in (known.min(), known.max()))
    if high - low < 1e-9:
        low, high = low - 1.0, high + 1.0
    start = min(float(curve.t[0]) for curve in curves)
    span = max(max(float(curve.t[-1]) for curve in curves) - start, 1e-9)
    width = WIDTHS[name]

    def across(t: Floats) -> list[float]:
        return [round(x, 1) for x in (LEFT + (t - start) / span * (width - LEFT - 8)).tolist()]

    def down(values: Floats) -> list[float]:
        return [round(y, 1) for y in (TOP + 4 + (high - values) / (high - low) * (BOTTOM - TOP - 12)).tolist()]

    pieces = []
    for first, last, color in ribbon:
        a, b = across(np.array([first, last]))
        pieces.append((a, round(max(b - a, 1.0), 1), color))
    drawn = []
    for curve in curves:
        there = np.isfinite(curve.values)
        drawn.append((curve, list(zip(across(curve.t[there]), down(curve.values[there]), strict=True))))
    return Drawing(
        name=name,
        width=width,
        right=width - 4,
        low=f"{low:.4g}",
        high=f"{high:.4g}",
        start=f"{start:.3g}",
        end=f"{start + span:.3g}",
        ribbon=pieces,
        zero=down(np.array([0.0]))[0] if zero and low < 0 < high else None,
        curves=drawn,
    )
