"""Figures of a comparison: the hop of every engine and the exact one, and error against work."""

from __future__ import annotations

import io
import re
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.engines.comparing import COMMON_STEP, LADDER_SCENARIO, Comparison, Row
from hophoop.engines.measures import exact_record
from hophoop.engines.scenarios import bench_scenarios
from hophoop.vocabulary import colors

COLUMNS = 3  # a page of 736 px shows them at their size
SPAN = (0.95, 1.95)  # s, around the hop
FLOOR = 1e-3  # mm, the resolution of the record


def _panels(count: int, size: tuple[float, float]) -> tuple[Any, list[Any]]:
    rows = -(-count // COLUMNS)
    figure, axes = need("matplotlib.pyplot", "plots").subplots(
        rows,
        COLUMNS,
        figsize=(COLUMNS * size[0], rows * size[1]),
        sharex=True,
        sharey=True,
        layout="constrained",
        squeeze=False,
    )
    flat = [ax for line in axes for ax in line]
    for ax in flat[count:]:
        ax.set_axis_off()
    for ax in flat[:count]:
        ax.grid(True, color="#000000", alpha=0.1, linewidth=0.6)
        for side in ("top", "right"):
            ax.spines[side].set_visible(False)
    return figure, flat[:count]


def _label_below(axes: list[Any], words: str) -> None:
    for k, ax in enumerate(axes):
        lowest = k + COLUMNS >= len(axes)
        ax.tick_params(labelbottom=lowest)
        if k >= COLUMNS * ((len(axes) - 1) // COLUMNS):  # a label in a higher row would push the rows apart
            ax.set_xlabel(words)


def hops(comparison: Comparison, dt: float = COMMON_STEP) -> Any:
    """Height of the rim over time in the hop, one panel per engine, with the exact motion.

    Parameters
    ----------
    comparison : Comparison
    dt : float
        The shown time step [s].

    Returns
    -------
    figure : Figure

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    exact = exact_record(bench_scenarios()[LADDER_SCENARIO])
    near = np.flatnonzero((exact.t >= SPAN[0]) & (exact.t <= SPAN[1]))[::5]
    shown = [name for name in comparison.engines if any(row.states is not None for row in _hop_rows(comparison, name))]
    figure, axes = _panels(len(shown), (2.55, 1.95))
    for ax, name in zip(axes, shown, strict=True):
        one = comparison.engines[name]
        ax.fill_between(exact.t[near], 0.0, 1e3 * exact.y[near], color=colors.LIGHT_GRAY, linewidth=0)
        words = []
        for row, color, dashes in zip(
            _shown_rows(comparison, name, dt), (colors.VERMILION, colors.BLUE), ("-", (0, (4, 2))), strict=False
        ):
            assert row.states is not None
            inside = np.flatnonzero((row.states.t >= SPAN[0]) & (row.states.t <= SPAN[1]))
            inside = inside[:: max(1, len(inside) // 400)]
            ax.plot(row.states.t[inside], 1e3 * row.states.y[inside], color=color, lw=1.6, ls=dashes)
            words.append((_height_words(row), color))
        ax.set_title(one.title, fontsize=10, loc="left", pad=4)
        for k, (text, color) in enumerate(words):  # left of the hop
            ax.text(0.03, 0.96 - 0.15 * k, text, transform=ax.transAxes, va="top", fontsize=8, color=color)
        ax.set_xlim(*SPAN)
        ax.set_ylim(-20.0, 420.0)
    for ax in axes[::COLUMNS]:
        ax.set_ylabel("gap (mm)")
    _label_below(axes, "time (s)")
    figure.suptitle(
        f"The hop in each engine with steps of {1e3 * dt:g} ms. Gray: the exact motion. Red: the manual’s settings.\n"
        "Blue, dashed: our settings, where they come closer at this step.",
        fontsize=10.5, x=0.01, ha="left",
    )  # fmt: skip
    return figure


def drawing(figure: Any) -> str:
    """Return a figure as SVG: the same for the same numbers, its lines to a tenth of a point.

    Parameters
    ----------
    figure : Figure

    Returns
    -------
    svg : str
    """
    stream = io.StringIO()
    with need("matplotlib", "plots").rc_context({"svg.hashsalt": "hophoop"}):
        figure.savefig(stream, format="svg", metadata={"Date": None})
    lines = re.compile(r' d="[ML\d\s.z-]+"')  # letters of text and marks are curves, and keep their digits
    return lines.sub(lambda path: re.sub(r"-?\d+\.\d+", lambda number: f"{float(number[0]):.1f}", path[0]), stream.getvalue())


def _shown_rows(comparison: Comparison, name: str, dt: float) -> list[Row]:
    """The run with the manual's settings, and the one with ours if it comes closer at this step."""
    found = [comparison.row(name, setting, LADDER_SCENARIO, dt) for setting in comparison.engines[name].settings]
    rows = [row for row in found if row is not None and row.states is not None and row.scores is not None]
    return rows[:1] + [row for row in rows[1:] if _error(row) < _error(rows[0])]


def _hop_rows(comparison: Comparison, name: str) -> list[Row]:
    return [row for row in comparison.rows if row.engine == name and row.scenario == LADDER_SCENARIO]


def _height_words(row: Row) -> str:
    assert row.scores is not None
    error = row.scores.hop_height
    if error is None or np.isnan(error):
        return "no hop"
    return f"{1e3 * error:+.1f} mm".replace("-", "−") if abs(error) >= 5e-5 else "exact"


def work_precision(comparison: Comparison) -> Any:
    """Error of the hop's height against wall time for all time steps, one panel per engine.

    Parameters
    ----------
    comparison : Comparison

    Returns
    -------
    figure : Figure

    Raises
    ------
    ImportError
        If Matplotlib is missing.
    """
    curves = {
        (name, setting): [(row, _error(row)) for row in comparison.ladder(name, setting) if row.scores]
        for name, one in comparison.engines.items()
        for setting in one.settings
    }
    shown = [name for name in comparison.engines if any(curves[name, s] for s in comparison.engines[name].settings)]
    figure, axes = _panels(len(shown), (2.55, 2.1))
    for ax, name in zip(axes, shown, strict=True):
        one = comparison.engines[name]
        marks = zip(one.settings, (colors.VERMILION, colors.BLUE), ("o", "s"), strict=False)
        for setting, color, mark in marks:
            points = curves[name, setting]
            if not points:
                continue
            work, errors = [_wall(row) for row, _ in points], [e for _, e in points]
            ax.plot(work, errors, color=color, marker=mark, ms=3.2, lw=1.4)
            for k, (row, _) in enumerate(points):
                if row.dt == COMMON_STEP:
                    ax.plot(work[k], errors[k], color=color, marker=mark, ms=7.5, mfc="white", mew=1.4)
        ax.set_title(one.title, fontsize=10, loc="left", pad=4)
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_ylim(0.2 * FLOOR, 2000.0)
    for ax in axes[::COLUMNS]:
        ax.set_ylabel("error of hop (mm)")
    _label_below(axes, "wall time (s)")
    figure.suptitle(
        "Error of the hop’s height against work, for steps from 10 ms to 0.01 ms. Red: the manual’s settings.\n"
        "Blue: our settings. Large marks: 1 ms. At the top: no hop.",
        fontsize=10.5, x=0.01, ha="left",
    )  # fmt: skip
    return figure


def _wall(row: Row) -> float:
    assert row.scores is not None
    return row.scores.wall_seconds or float("nan")


def _error(row: Row) -> float:
    assert row.scores is not None
    error = row.scores.hop_height
    if error is None or np.isnan(error):
        return 292.0
    return max(1e3 * abs(error), FLOOR)
