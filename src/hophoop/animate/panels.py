"""Animated plots of a film in 2D: drawn once by Matplotlib, then uncovered over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from hophoop.animate.canvas import Bytes, Canvas, Rectangle
from hophoop.animate.themes import Theme
from hophoop.plots.curves import curve
from hophoop.results.poses import Floats, Poses
from hophoop.results.records import ArraySample
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, labels

# Opacity of the future part of a curve
AHEAD = 0.28


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
        left, bottom, width, height = area
        unit = canvas.unit
        gap, margin = 14.0 * unit, 62.0 * unit
        time_axis = 34.0 * unit
        # only the lowest panel over time has the label
        high = (height - time_axis * (1 + ("phase" in names)) - gap * (len(names) - 1)) / len(names)
        y = bottom + height
        for index, name in enumerate(names):
            y -= high
            last_over_time = name != "phase" and not any(other != "phase" for other in names[index + 1 :])
            place = (
                (left + margin) / canvas.size[0],
                y / canvas.size[1],
                (width - margin - 20.0 * unit) / canvas.size[0],
                high / canvas.size[1],
            )
            axes = canvas.figure.add_axes(place)
            self._style(axes)
            DRAWN[name](axes, motion, sample)
            if name == "phase" or last_over_time:
                y -= time_axis
            elif name != "phase":
                axes.tick_params(labelbottom=False)
                axes.set_xlabel("")
            self._axes.append((name, axes))
            y -= gap
        self._paint()

    def _style(self, axes: Any) -> None:
        theme = self._theme
        axes.set_facecolor(theme.background)
        axes.tick_params(colors=theme.ink, labelsize=11)
        for spine in axes.spines.values():
            spine.set_color(theme.muted)
        axes.grid(True, color=theme.muted, alpha=0.22, linewidth=0.8)
        axes.xaxis.label.set_color(theme.ink)
        axes.yaxis.label.set_color(theme.ink)

    def _paint(self) -> None:
        canvas, theme = self._canvas, self._theme
        for _, axes in self._axes:
            axes.xaxis.label.set_size(12)
            axes.yaxis.label.set_size(12)
            legend = axes.get_legend()
            for line in axes.get_lines():
                line.set_color(theme.visible(line.get_color()))
            if legend is not None:
                legend.get_frame().set_facecolor(theme.background)
                legend.get_frame().set_edgecolor("none")
                for words in legend.get_texts():
                    words.set_color(theme.ink)
                for handle in legend.legend_handles:
                    handle.set_color(theme.visible(handle.get_color()))
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


def _legend(axes: Any) -> int:
    """Draw a legend with as many columns as fit; return its number of rows."""
    _, names = axes.get_legend_handles_labels()
    room = axes.get_position().width * axes.figure.get_size_inches()[0] * 72.0
    widest = 7.0 * max(map(len, names)) + 36.0  # letters, handle and space [points]
    columns = max(1, min(len(names), int(room / widest)))
    axes.legend(
        fontsize=11,
        loc="upper left",
        frameon=True,
        framealpha=0.75,
        ncols=columns,
        borderpad=0.2,
        handlelength=1.4,
        columnspacing=1.0,
    )
    return math.ceil(len(names) / columns)


def _velocity(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    axes.plot(sample.t, sample.vx, color=colors.CENTER_SPEED, linewidth=1.8, label="v")
    axes.plot(
        sample.t,
        motion.scenario.hoop.radius * sample.omega,
        color=colors.ROTATION_SPEED,
        linewidth=1.8,
        label="Rθ̇",
    )
    axes.set_ylabel(labels.VELOCITY)
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
    axes.set_ylabel(labels.ENERGY)
    _over_time(axes, sample.t)


def _forces(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    axes.plot(sample.t, sample.normal_force, color=colors.NORMAL_FORCE, linewidth=1.8, label="normal")
    axes.plot(sample.t, sample.friction_force, color=colors.FRICTION_FORCE, linewidth=1.8, label="friction")
    axes.set_ylabel(labels.FORCE)
    _over_time(axes, sample.t)


def _utilization(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    share = sample.utilization(motion.scenario.plane)
    axes.plot(sample.t, share, color=colors.FRICTION_FORCE, linewidth=1.8, label="|F| / μN")
    axes.set_ylabel(labels.UTILIZATION)
    _over_time(axes, sample.t)
    axes.set_ylim(0.0, 1.35)  # the key is above the line at 1


def _phase(axes: Any, motion: Trajectory, sample: ArraySample) -> None:
    (line,) = axes.plot(np.degrees(sample.angle), sample.omega, color=colors.BLACK, linewidth=1.6)
    line.hophoop_times = sample.t
    axes.set_xlabel(labels.ANGLE)
    axes.set_ylabel("θ̇ (rad/s)")


def _over_time(axes: Any, times: Floats) -> None:
    axes.set_xlim(times[0], times[-1] if times[-1] > times[0] else times[0] + 1.0)
    axes.set_xlabel(labels.TIME)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.16 * _legend(axes) * (high - low))


DRAWN = {
    "velocity": _velocity,
    "energy": _energy,
    "forces": _forces,
    "utilization": _utilization,
    "phase": _phase,
}
