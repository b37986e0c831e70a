"""Animated plots of a film in 2D: drawn once by Matplotlib, then uncovered over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.canvas import Bytes, Canvas, Rectangle, TextStyle
from hophoop.animate.layout import FONT
from hophoop.animate.themes import Theme
from hophoop.plots.curves import curve
from hophoop.results.poses import Floats, Poses
from hophoop.results.records import ArraySample
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

# Opacity of the future part of a curve
AHEAD = 0.28
ROW, TIME_AXIS, GAP, RIGHT = 27.0, 56.0, 8.0, 32.0  # of titles, under an axis, between panels, on the right [units]
KEY_LINE, KEY_GAP = 20.0, 16.0  # of a line's key, and between keys [units]


_Words = tuple[float, str, str]  # left end [pixels], text, and colour of its line or nothing


class Panels:
    """The side panels of a film.

    Parameters
    ----------
    canvas : Canvas
        Canvas for the panels; its figure gets the axes.
    area : tuple of float
        Left, bottom, width, height [pixels].
    theme : Theme
    motions : sequence of Trajectory
        The first one is plotted.
    names : sequence of str
    start, end : float
        Part of the motion [s].
    """

    def __init__(
        self,
        canvas: Canvas,
        area: Rectangle,
        theme: Theme,
        motions: Sequence[Trajectory],
        names: Sequence[str],
        start: float,
        end: float,
    ) -> None:
        self._canvas, self._theme = canvas, theme
        self._axes: list[tuple[str, Any]] = []
        if not names:
            return
        motion = motions[0]
        sample = curve(motion, start, end)
        for name in names:
            axes = canvas.figure.add_axes((0.0, 0.0, 1.0, 1.0), label=name)
            self._style(axes, most_ticks=4 if len(names) < 3 else 2)
            DRAWN[name](axes, motion, sample)
            self._axes.append((name, axes))
        titles = self._place(area)
        self._paint()
        for x, y, title in titles:
            self._write(x, y, title)

    def _place(self, area: Rectangle) -> list[tuple[float, float, list[_Words]]]:
        """Place the axes under their titles; return the rows of the titles with their left ends and baselines [pixels]."""
        canvas, unit = self._canvas, self._canvas.unit
        left, bottom, width, height = area
        names = [name for name, _ in self._axes]
        margin = max(_margin(canvas, axes) for _, axes in self._axes)
        inner = width - margin - RIGHT * unit
        rows = [self._title(axes, inner) for _, axes in self._axes]
        # only the lowest panel over time has the label
        named = [name == "phase" or set(names[k + 1 :]) <= {"phase"} for k, name in enumerate(names)]
        taken = TIME_AXIS * sum(named) + GAP * (len(names) - 1) + ROW * sum(map(len, rows))
        high = max((height - taken * unit) / len(names), 4.0 * unit)
        y, titles = bottom + height, []
        for (_, axes), title, labelled in zip(self._axes, rows, named, strict=True):
            for row in title:
                y -= ROW * unit
                titles.append((left + margin, y + 8.0 * unit, row))
            y -= high
            size = canvas.size
            axes.set_position(((left + margin) / size[0], y / size[1], inner / size[0], high / size[1]))
            if not labelled:
                axes.tick_params(labelbottom=False)
                axes.set_xlabel("")
            y -= (TIME_AXIS * labelled + GAP) * unit
        return titles

    def _title(self, axes: Any, width: float) -> list[list[_Words]]:
        """Return the rows of a panel's title: its quantity, and the keys of several lines."""
        canvas, theme, unit = self._canvas, self._theme, self._canvas.unit
        words = [(axes.get_ylabel(), "")]
        axes.set_ylabel("")
        lines = axes.get_lines()
        if len(lines) > 1:
            words += [(str(line.get_label()), theme.visible(line.get_color())) for line in lines]
        rows: list[list[_Words]] = [[]]
        x = 0.0
        for text, color in words:
            broad = canvas.text_width(text, FONT) + (KEY_LINE + 6.0) * unit * bool(color)
            if x and x + broad > width:
                rows.append([])
                x = 0.0
            rows[-1].append((x, text, color))
            x += broad + KEY_GAP * unit
        return rows

    def _write(self, x: float, y: float, row: list[_Words]) -> None:
        canvas, unit = self._canvas, self._canvas.unit
        for start, text, color in row:
            here = x + start
            if color:
                level = y + 7.0 * unit
                canvas.line(np.array([[here, level], [here + KEY_LINE * unit, level]]), color, 3.0)
                here += (KEY_LINE + 6.0) * unit
            canvas.text(here, y, text, TextStyle(self._theme.ink, FONT))

    def _style(self, axes: Any, most_ticks: int) -> None:
        theme, ticker = self._theme, need("matplotlib.ticker", "plots")
        for axis, most in ((axes.xaxis, 5), (axes.yaxis, most_ticks)):
            axis.set_major_locator(ticker.MaxNLocator(most))
            axis.set_major_formatter(ticker.FuncFormatter(_number))
        axes.set_facecolor(theme.background)
        axes.tick_params(colors=theme.ink, labelsize=FONT)
        for spine in axes.spines.values():
            spine.set_color(theme.muted)
        axes.grid(True, color=theme.muted, alpha=0.22, linewidth=0.8)
        axes.xaxis.label.set_color(theme.ink)

    def _paint(self) -> None:
        canvas, theme = self._canvas, self._theme
        for _, axes in self._axes:
            axes.xaxis.label.set_size(FONT)
            for line in axes.get_lines():
                line.set_color(theme.visible(line.get_color()))
        canvas.render()
        self._full: Bytes = canvas.pixels.copy()
        for _, axes in self._axes:
            for line in axes.get_lines():
                line.set_visible(False)
        canvas.render()
        bare = canvas.pixels.astype(np.float32)
        for _, axes in self._axes:
            for line in axes.get_lines():
                line.set_visible(True)
        faded = bare + AHEAD * (self._full.astype(np.float32) - bare)
        canvas.pixels[...] = np.round(faded).astype(np.uint8)

    def draw(self, now: Sequence[tuple[float, Poses | None, int]]) -> None:
        """Uncover the curves up to now: for each motion its time, its poses and the index of the present one."""
        if not self._axes:
            return
        canvas = self._canvas
        t, poses, i = now[0]
        assert poses is not None
        for name, axes in self._axes:
            box = axes.bbox
            if name == "phase":
                here = np.array([math.degrees(poses.angle[i]), poses.omega[i]])
                self._draw_way(axes, t, here)
                continue
            x = float(axes.transData.transform((t, 0.0))[0])
            a, b = math.ceil(box.x0), min(math.floor(x), math.floor(box.x1))
            top, low = canvas.size[1] - math.floor(box.y1), canvas.size[1] - math.ceil(box.y0)
            if b > a:
                canvas.pixels[top:low, a:b] = self._full[top:low, a:b]
            canvas.clip((box.x0, box.y0, box.width, box.height))
            canvas.line(np.array([[x, box.y0], [x, box.y1]]), self._theme.muted, 1.0)
            for line in axes.get_lines():
                value = _value(line, t)
                if math.isfinite(value):
                    spot = axes.transData.transform((t, value))
                    canvas.disc(spot, 4.0 * canvas.unit, line.get_color(), self._theme.background, 1.0)
            canvas.clip(None)

    def _draw_way(self, axes: Any, t: float, here: Floats) -> None:
        canvas, box = self._canvas, axes.bbox
        line = axes.get_lines()[0]
        past = int(np.searchsorted(line.hophoop_times, t))
        way = np.vstack([np.column_stack(line.get_data())[:past], here])
        canvas.clip((box.x0, box.y0, box.width, box.height))
        canvas.line(axes.transData.transform(way), self._theme.ink, 1.6)
        canvas.disc(axes.transData.transform(here), 5.5 * canvas.unit, self._theme.ink, self._theme.background, 1.2)
        canvas.clip(None)


def _value(line: Any, t: float) -> float:
    x, y = line.get_xdata(), line.get_ydata()
    return float(np.interp(t, x, y)) if len(x) > 1 else math.nan


def _number(value: float, _place: int | None = None) -> str:
    """Text of a tick."""
    return f"{value:g}".replace("-", "−")


def _margin(canvas: Canvas, axes: Any) -> float:
    """Width of the texts on the left of axes [pixels]."""
    low, high = sorted(axes.get_ylim())
    shown = [_number(value) for value in axes.get_yticks() if low <= value <= high]
    return float(max((canvas.text_width(words, FONT) for words in shown), default=0.0)) + 16.0 * canvas.unit


def _velocity(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    axes.plot(sample.t, sample.vx, color=colors.CENTER_SPEED, linewidth=1.8, label="v")
    axes.plot(
        sample.t,
        motion.scenario.hoop.radius * sample.omega,
        color=colors.ROTATION_SPEED,
        linewidth=1.8,
        label="Rθ̇",
    )
    axes.set_ylabel(quantities.VELOCITY)
    _over_time(axes, sample.t)


def _energy(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    for values, color, label in (
        (sample.kinetic, colors.KINETIC, "kinetic"),
        (sample.potential, colors.POTENTIAL, "potential"),
        (sample.total, colors.TOTAL, "sum"),
        (sample.friction_loss, colors.FRICTION_LOSS, "friction"),
        (sample.normal_loss, colors.IMPACT_LOSS, "impacts, normal" if motion.scenario.contact.model == "rigid" else "damper"),
    ):
        axes.plot(sample.t, values, color=color, linewidth=1.8, label=label)
    axes.set_ylabel(quantities.ENERGY)
    _over_time(axes, sample.t)


def _forces(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    axes.plot(sample.t, sample.normal_force, color=colors.NORMAL_FORCE, linewidth=1.8, label="normal")
    axes.plot(sample.t, sample.friction_force, color=colors.FRICTION_FORCE, linewidth=1.8, label="friction")
    axes.set_ylabel(quantities.FORCE)
    _over_time(axes, sample.t)


def _utilization(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    share = sample.utilization(motion.scenario.plane)
    axes.plot(sample.t, share, color=colors.FRICTION_FORCE, linewidth=1.8, label="|F| / μN")
    axes.set_ylabel(quantities.UTILIZATION)
    _over_time(axes, sample.t)
    axes.set_ylim(0.0, 1.15)
    axes.set_yticks([0.0, 0.5, 1.0])


def _phase(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    (line,) = axes.plot(np.degrees(sample.angle), sample.omega, color=colors.BLACK, linewidth=1.6)
    line.hophoop_times = sample.t
    axes.set_xlabel(quantities.ANGLE)
    axes.set_ylabel("θ̇ (rad/s)")


def _over_time(axes: Any, times: Floats) -> None:
    axes.set_xlim(times[0], times[-1] if times[-1] > times[0] else times[0] + 1.0)
    axes.set_xlabel(quantities.TIME)


DRAWN = {
    "velocity": _velocity,
    "energy": _energy,
    "forces": _forces,
    "utilization": _utilization,
    "phase": _phase,
}
