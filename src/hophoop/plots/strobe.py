"""Stroboscopic picture: the hoop at equal steps of time or angle, for print."""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np

from hophoop._support.extras import need
from hophoop.plots.curves import curve
from hophoop.plots.hoop import AROUND, HoopArtist
from hophoop.plots.path import add_mode_keys, draw_traces, legend_above, scene
from hophoop.plots.style import Axes
from hophoop.results.poses import Floats, Poses, poses_of, rim_speeds, times_at_turn, turned_at
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

FLASHES = 12  # approximate default
MOST_FLASHES = 400
FIRST, LAST = 0.35, 1.0  # opacity of the first and last hoop


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
    flashes = poses_of(motion, _flashes(motion, every, every_deg, start, end))
    way = poses_of(motion, curve(motion, start, end).t)
    radius, slope = motion.scenario.hoop.radius, motion.scenario.plane.slope
    ax = scene(ax, way, radius, slope, 1.6 if color == "speed" else 1.1)
    _draw_hoops(ax, motion, flashes, color)
    draw_traces(ax, way, zorder=5)
    _say_times(ax, flashes, radius)
    if color == "mode":
        add_mode_keys(ax, flashes)
    if forces:
        _draw_forces(ax, motion, flashes)
    legend_above(ax)
    return ax


def _flashes(motion: Trajectory, every: float | None, every_deg: float | None, start: float, end: float) -> Floats:
    if every is not None and every_deg is not None:
        raise InputError(f"every = {every!r} and every_deg = {every_deg!r} cannot be given together.")
    if end == start:
        return np.array([start])
    if every is None and every_deg is None:
        every = _round((end - start) / FLASHES)
    name, step = ("every", every) if every is not None else ("every_deg", every_deg)
    if step is None or not 0.0 < step < math.inf:
        raise InputError.of_field(name, step, "positive")
    low, high = (start, end) if every is not None else np.degrees(turned_at(motion, [start, end])).tolist()
    count = (high - low) / step
    if count > MOST_FLASHES:
        raise InputError(
            f"{name} = {step!r} makes {count:.0f} flashes; at most {MOST_FLASHES} can be told apart.", field=name, value=step
        )
    marks = low + np.arange(int(count + 1e-9) + 1, dtype=float) * step
    return marks if every is not None else np.unique(np.clip(times_at_turn(motion, np.radians(marks)), start, end))


def _round(step: float) -> float:
    power = 10.0 ** math.floor(math.log10(step))
    return min((1.0, 2.0, 2.5, 5.0, 10.0), key=lambda part: abs(math.log(part * power / step))) * power


def _draw_hoops(ax: Axes, motion: Trajectory, flashes: Poses, color: str) -> None:
    hoop, slope = motion.scenario.hoop, motion.scenario.plane.slope
    paints: Any = [colors.mode_color(word) for word in flashes.words.tolist()]
    if color == "speed":
        speeds = rim_speeds(flashes, AROUND, hoop.radius)
        scale = ax.scatter([], [], c=[], cmap=colors.RING_SPEED_MAP, vmin=0.0, vmax=float(speeds.max()) or 1.0)
        ax.figure.colorbar(
            scale, ax=ax, orientation="horizontal", shrink=0.4, aspect=40, pad=0.02, label=quantities.POINT_SPEED
        )
        paints = [scale.to_rgba(each) for each in speeds]
    opacity = np.linspace(LAST, FIRST, len(paints))[::-1]  # of a single one LAST
    for i, (center, angle, alpha) in enumerate(zip(flashes.center, flashes.angle.tolist(), opacity.tolist(), strict=True)):
        drawn = HoopArtist(
            ax, hoop, slope, ring=2.6, load=6.5, line=colors.GRAY, alpha=alpha, pieces=color == "speed", zorder=2.0 + 0.01 * i
        )
        drawn.pose(center, angle)
        drawn.paint(paints[i])


def _draw_forces(ax: Axes, motion: Trajectory, flashes: Poses) -> None:
    """Draw arrows at the contact, to a scale that their keys give."""
    hoop = motion.scenario.hoop
    greatest = max(float(np.hypot(*flashes.normal_force.T).max()), hoop.mass * motion.scenario.plane.gravity)
    scale = 1.2 * hoop.radius / (greatest or 1.0)
    for force, ink, label in (
        (flashes.normal_force, colors.NORMAL_FORCE, f"normal force, to {greatest:.3g} N"),
        (flashes.friction_force, colors.FRICTION_FORCE, "friction, to the same scale"),
    ):
        ax.quiver(
            *flashes.contact.T, *(scale * force).T, color=ink, angles="xy", scale_units="xy", scale=1.0, width=0.0035, zorder=8
        )
        ax.plot([], [], color=ink, lw=2.0, marker=">", label=label)


def _say_times(ax: Axes, flashes: Poses, radius: float) -> None:
    """Write the time above each hoop where it fits."""
    halo = need("matplotlib.patheffects", "plots").withStroke(linewidth=2.5, foreground="white")
    low, high = ax.get_xlim()
    last = -math.inf
    # two digits of the shortest step
    digits = 1 - math.floor(math.log10(max(float(np.diff(flashes.t).min(initial=1.0)), 1e-9)))
    for i in np.argsort(flashes.center[:, 0], kind="stable"):
        x, y = flashes.center[i]
        if x - last < 0.055 * (high - low):
            continue
        last = x
        ax.text(
            x, y + 1.06 * radius, f"{round(float(flashes.t[i]), digits):g} s", ha="center", va="bottom", fontsize=8,
            color=colors.GRAY, path_effects=[halo], zorder=9,
        )  # fmt: skip
