"""Small plots over time for the pages of tracks and fits; plots.html draws them as SVG."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Curve(NamedTuple):
    """Values over time, as points or as a line."""

    t: Floats  # [s]
    values: Floats
    color: str
    line: bool = False


class Plot(NamedTuple):
    """A plot: texts, and places from 0 to 1000 across and 0 to 100 down, which the page stretches to its width."""

    label: str
    low: str
    high: str
    start: str
    end: str
    ribbon: list[tuple[float, float, str]]  # place, width, colour
    zero: float | None
    curves: list[tuple[str, bool, str]]  # colour, whether it is a line, path


def plot(curves: Sequence[Curve], label: str, ribbon: Sequence[tuple[float, float, str]] = (), zero: bool = False) -> Plot:
    """Return a small plot over time; missing values are gaps.

    label: quantity and unit; ribbon: pieces of time [s] and their colour, below the plot; zero: whether to draw a line at 0.
    """
    known = np.concatenate([curve.values[np.isfinite(curve.values)] for curve in curves])
    low, high = (float(round(one, 9)) for one in (known.min(), known.max()))
    if high - low < 1e-9:
        low, high = low - 1.0, high + 1.0
    start = min(float(curve.t[0]) for curve in curves)
    span = max(max(float(curve.t[-1]) for curve in curves) - start, 1e-9)
    pieces = [(1e3 * (first - start) / span, max(1e3 * (last - first) / span, 1.0), color) for first, last, color in ribbon]
    drawn = []
    for curve in curves:
        there = np.isfinite(curve.values)
        places = np.column_stack([1e3 * (curve.t[there] - start) / span, 100.0 * (high - curve.values[there]) / (high - low)])
        path = " ".join(f"{x:.1f},{y:.1f}" if curve.line else f"M{x:.1f},{y:.1f}h0" for x, y in places.tolist())
        drawn.append((curve.color, curve.line, f"M{path}" if curve.line else path))
    level = 100.0 * high / (high - low) if zero and low < 0 < high else None
    return Plot(label, f"{low:.4g}", f"{high:.4g}", f"{start:.3g} s", f"{start + span:.3g} s", pieces, level, drawn)
