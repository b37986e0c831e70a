"""Stroboscopic picture: the hoop at equal steps of time or angle, for print."""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np

from hophoop._support.extras import need
from hophoop.plots.curves import curve
from hophoop.plots.hoop import AROUND, HoopArtist
from hophoop.plots.path import draw_traces, frame, ground, legend_above, mode_keys
from hophoop.plots.style import Axes, new_axes
from hophoop.results.poses import Floats, Poses, poses_of, rim_speeds, times_at_turn, turned_at
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

FLASHES = 12  # approximate default
MOST_FLASHES = 400
FIRST, LAST = 0.35, 1.0  # opacity of the first and last hoop
WIDTH = 10.0  # inches


def strobe(
    motion: Trajectory,
    every: float | None = None,
    every_deg: float | None = None,
    start: float = 0.0,
    end: float | None = None,
    color: Literal["speed", "mode"] = "speed",
    forces: bool = False,
    ax: Axes | None = None,
) -> Axes:
    """Draw the hoop at equal steps, with the traces of load and centre of gravity.

    Parameters
    ----------
    motion : Trajectory
    every : float, optional
        Time between two flashes; by default a round number that gives about 12 flashes [s].
    every_deg : float, optional
        Rotation between two flashes, instead of a time [°].
    start, end : float, optional
        Start and end of the part shown [s].
    color : {'speed', 'mode'}
        Colour the ring by the speed of its points, with a colour bar, or by its mode.
    forces : bool, default False
        Whether to draw the contact forces, to scale.
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If the part is not within the motion, a step is not positive, both steps are given, or there are too many flashes.
    ImportError
        If Matplotlib is missing.
    """
    if color not in ("speed", "mode"):
        raise InputError.of_field("color", color, "'speed' or 'mode'")
    end = motion.duration if end is None else end
    if not 0.0 <= start <= end <= motion.duration:
        raise InputError(f"start = {start!r}, end = {end!r} must be a part of the motion, from 0 to {motion.duration!r} s.")
    times = _flashes(motion, every, every_deg, start, end)
    radius, slope = motion.scenario.hoop.radius, motion.scenario.plane.slope
    way = poses_of(motion, curve(motion, start, end).t)
    flashes = poses_of(motion, times)
    low, high = way.center.min(axis=0) - 1.25 * radius, way.center.max(axis=0) + 1.25 * radius
    if slope == 0.0:
        low[1] = -0.3 * radius
    else:  # the plane below the lowest hoop
        low[1] = min(low[1], -max(low[0] * math.tan(slope), high[0] * math.tan(slope)) - 0.1 * radius)
    height = WIDTH * (high[1] - low[1]) / (high[0] - low[0]) + (1.6 if color == "speed" else 1.1)
    ax = new_axes(ax, (WIDTH, float(np.clip(height, 2.4, 9.0))))
    ground(ax, slope, float(low[0]), float(high[0]), radius)
    frame(ax, low, high, slope)
    _draw_hoops(ax, motion, flashes, color)
    draw_traces(ax, way, zorder=5)
    greatest = _draw_forces(ax, motion, flashes) if forces else None
    _say_times(ax, flashes, radius, float(high[0] - low[0]))
    keys = mode_keys(map(str, flashes.words)) if color == "mode" else []
    legend_above(ax, keys + ([] if greatest is None else _force_keys(greatest)))
    return ax


def _flashes(motion: Trajectory, every: float | None, every_deg: float | None, start: float, end: float) -> Floats:
    if every is not None and every_deg is not None:
        raise InputError(f"every = {every!r} and every_deg = {every_deg!r} cannot be given together.")
    for name, step in (("every", every), ("every_deg", every_deg)):
        if step is not None and not (0.0 < step < math.inf):
            raise InputError.of_field(name, step, "positive")
    if every_deg is not None:
        first, last = turned_at(motion, [start, end])
        step = math.radians(every_deg)
        _check_count((last - first) / step, "every_deg", every_deg)
        marks = np.arange(math.ceil(first / step - 1e-9), math.floor(last / step + 1e-9) + 1) * step
        times = times_at_turn(motion, marks)
        return np.unique(np.clip(times, start, end))
    if end == start:
        return np.array([start])
    step = _round((end - start) / FLASHES) if every is None else every
    _check_count((end - start) / step, "every", step)
    return start + np.arange(math.floor((end - start) / step + 1e-9) + 1, dtype=float) * step


def _check_count(count: float, name: str, step: float) -> None:
    if count > MOST_FLASHES:
        raise InputError(
            f"{name} = {step!r} makes {count:.0f} flashes; at most {MOST_FLASHES} can be told apart.", field=name, value=step
        )


def _round(step: float) -> float:
    power = 10.0 ** math.floor(math.log10(step))
    return min((1.0, 2.0, 2.5, 5.0, 10.0), key=lambda part: abs(math.log(part * power / step))) * power


def _draw_hoops(ax: Axes, motion: Trajectory, flashes: Poses, color: str) -> None:
    hoop, slope = motion.scenario.hoop, motion.scenario.plane.slope
    opacity = np.linspace(FIRST, LAST, len(flashes.t)) if len(flashes.t) > 1 else np.array([LAST])
    shades = need("matplotlib", "plots").colormaps[colors.RING_SPEED_MAP]
    speeds = rim_speeds(flashes, AROUND, hoop.radius)
    top = float(speeds.max()) or 1.0
    for i, alpha in enumerate(opacity):
        drawn = HoopArtist(
            ax, hoop, slope, ring=2.6, load=6.5, line=colors.GRAY, alpha=float(alpha), pieces=color == "speed",
            zorder=2.0 + 0.01 * i,
        )  # fmt: skip
        drawn.pose(flashes.center[i], float(flashes.angle[i]))
        drawn.paint(shades(speeds[i] / top) if color == "speed" else colors.mode_color(str(flashes.words[i])))
    if color == "speed":
        scale = need("matplotlib.cm", "plots").ScalarMappable(need("matplotlib.colors", "plots").Normalize(0.0, top), shades)
        ax.figure.colorbar(
            scale, ax=ax, orientation="horizontal", shrink=0.4, aspect=40, pad=0.02,
            label=quantities.POINT_SPEED,
        )  # fmt: skip


def _draw_forces(ax: Axes, motion: Trajectory, flashes: Poses) -> float:
    """Draw arrows at the contact and return the force of the longest one [N]."""
    hoop = motion.scenario.hoop
    greatest = max(float(np.hypot(*flashes.normal_force.T).max()), hoop.mass * motion.scenario.plane.gravity)
    scale = 1.2 * hoop.radius / (greatest or 1.0)
    for force, ink in (
        (flashes.normal_force, colors.NORMAL_FORCE),
        (flashes.friction_force, colors.FRICTION_FORCE),
    ):
        ax.quiver(
            flashes.contact[:, 0], flashes.contact[:, 1], scale * force[:, 0], scale * force[:, 1], color=ink,
            angles="xy", scale_units="xy", scale=1.0, width=0.0035, zorder=8,
        )  # fmt: skip
    return greatest


def _say_times(ax: Axes, flashes: Poses, radius: float, width: float) -> None:
    """Write the time above each hoop where it fits."""
    halo = need("matplotlib.patheffects", "plots").withStroke(linewidth=2.5, foreground="white")
    room = 0.055 * width
    last = -math.inf
    digits = max(0, min(4, -math.floor(math.log10(max(float(np.diff(flashes.t).min(initial=1.0)), 1e-9)))))
    order = np.argsort(flashes.center[:, 0], kind="stable")
    for i in order:
        x, y = flashes.center[i]
        if x - last < room:
            continue
        last = x
        words = f"{flashes.t[i]:.{digits}f}".rstrip("0").rstrip(".") or "0"
        ax.text(
            x,
            y + 1.06 * radius,
            f"{words} s",
            ha="center",
            va="bottom",
            fontsize=8,
            color=colors.GRAY,
            path_effects=[halo],
            zorder=9,
        )


def _force_keys(greatest: float) -> list[Any]:
    line = need("matplotlib.lines", "plots").Line2D
    names = {
        colors.NORMAL_FORCE: f"normal force, to {greatest:.3g} N",
        colors.FRICTION_FORCE: "friction, to the same scale",
    }
    return [line([], [], color=ink, lw=2.0, marker=">", ms=6, label=label) for ink, label in names.items()]
