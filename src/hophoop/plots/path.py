"""Path of the hoop: traces of load and centre of gravity, with the hoop drawn at its events."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.plots.curves import curve, phases
from hophoop.plots.hoop import HoopArtist
from hophoop.plots.style import Axes, new_axes
from hophoop.results.poses import Floats, Poses, load_distance, poses_of, to_world
from hophoop.scenario import Hoop, InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

# Events at which the hoop is drawn: those that change its motion.
POSED = (
    "start", "slip_start", "stick", "takeoff", "apex", "impact", "turn", "skim", "jam", "rest", "end",
    "painleve_inconsistent", "painleve_indeterminate",
)  # fmt: skip
MOST_POSES = 14


def path(motion: Trajectory, ax: Axes | None = None, times: Sequence[float] | None = None) -> Axes:
    """Draw the paths of the load (black) and of the centre of gravity (green, red in flight).

    The hoop is drawn in its mode's colour at the events or at the given times.

    Parameters
    ----------
    motion : Trajectory
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    times : sequence of float, optional
        Times at which the hoop is drawn; by default those of events that do not overlap [s].

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If a time is outside the motion.
    ImportError
        If Matplotlib is missing.
    """
    hoop, slope = motion.scenario.hoop, motion.scenario.plane.slope
    radius = hoop.radius
    sample = curve(motion)
    grid = sample.t
    poses = poses_of(motion, grid)
    places = np.concatenate([poses.center, poses.load])
    low, high = places.min(axis=0) - 1.35 * radius, places.max(axis=0) + 1.35 * radius
    if slope == 0.0:
        low[1] = -0.35 * radius
    width = 10.0
    ax = new_axes(ax, (width, float(np.clip(width * (high[1] - low[1]) / (high[0] - low[0]) + 0.9, 2.2, 7.0))))
    ground(ax, slope, low[0], high[0], radius)
    moments = _pose_times(motion, radius) if times is None else [float(t) for t in times]
    for t in moments:
        pose, ink = poses_of(motion, t), colors.mode_color(_word(motion, t))
        drawn = HoopArtist(ax, hoop, slope, ring=1.6, load=7.0, line=ink, alpha=0.9)
        drawn.pose(pose.center[0], float(pose.angle[0]))
        drawn.paint(ink)
    draw_traces(ax, poses, zorder=4)
    frame(ax, low, high, slope)
    legend_above(ax, mode_keys(_word(motion, t) for t in moments))
    return ax


def frame(ax: Axes, low: Floats, high: Floats, slope: float) -> None:
    """Set equal scales from a lower left to an upper right corner, and the labels of both axes."""
    ax.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), ylabel=quantities.HEIGHT)
    ax.set_xlabel(quantities.PLACE if slope == 0.0 else quantities.DISTANCE)
    ax.spines[["top", "right"]].set_visible(False)


def draw_traces(ax: Axes, way: Poses, zorder: float) -> None:
    """Draw the traces of the load, and of the centre of gravity in contact and airborne."""
    ax.plot(*way.load.T, color=colors.LOAD, lw=1.2, zorder=zorder, label="load")
    airborne = way.mode == "H"
    for flies, ink, dashes, width, label in (
        (False, colors.GRAVITY_CENTER, "-", 2.0, "centre of gravity"),
        (True, colors.GRAVITY_CENTER_AIRBORNE, (0, (5, 1)), 2.4, "airborne"),
    ):
        # the part after a point has that point's mode
        shown = airborne == flies
        shown[1:] |= (airborne == flies)[:-1]
        if flies and not airborne.any():
            continue
        line = np.where(shown[:, None], way.gravity_center, np.nan)
        ax.plot(*line.T, color=ink, lw=width, ls=dashes, zorder=zorder + 1, label=label)


def mode_keys(words: Iterable[str]) -> list[Any]:
    """Return keys to the colours of rings by mode."""
    line = need("matplotlib.lines", "plots").Line2D
    look = {"lw": 0, "marker": "o", "ms": 9, "mfc": "none", "mew": 2}
    return [line([], [], color=colors.mode_color(word), label=word, **look) for word in dict.fromkeys(words)]


def legend_above(ax: Axes, more: Sequence[Any]) -> None:
    """Draw a legend of the lines with a label and more keys above the axes, in two rows where it is long."""
    handles = [*ax.get_legend_handles_labels()[0], *more]
    columns = len(handles) if len(handles) <= 8 else math.ceil(len(handles) / 2)
    ax.legend(
        handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=columns, frameon=False, fontsize=9,
        handlelength=2.0, columnspacing=1.4,
    )  # fmt: skip


def _word(motion: Trajectory, t: float) -> str:
    return str(poses_of(motion, t).words[0])


def _pose_times(motion: Trajectory, radius: float) -> list[float]:
    """Return the events in order, without those where the hoop would cover the previous one; every mode is shown."""
    chosen: list[tuple[float, float]] = []
    for event in motion.events:
        if event.kind not in POSED:
            continue
        if all(abs(event.x - x) > 0.45 * radius for _, x in chosen):
            chosen.append((event.t, event.x))
    if len(chosen) > MOST_POSES:
        keep = np.unique(np.linspace(0, len(chosen) - 1, MOST_POSES).astype(int))
        chosen = [chosen[k] for k in keep]
    if len(chosen) < 4:  # without events to show: equally spaced along the path
        grid = motion.times(400)
        way = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(motion.at(grid).x)))])
        return _with_every_word(motion, [float(t) for t in np.interp(np.linspace(0.0, way[-1], 6), way, grid)])
    return _with_every_word(motion, [t for t, _ in chosen])


def _with_every_word(motion: Trajectory, times: list[float]) -> list[float]:
    """Return the times, and the middle of the longest phase of each word that they miss."""
    shown = {_word(motion, t) for t in times}
    longest: dict[str, tuple[float, float]] = {}
    for piece in phases(motion):
        lasts = piece.end_t - piece.t
        if piece.word not in shown and lasts > longest.get(piece.word, (0.0, 0.0))[0]:
            longest[piece.word] = (lasts, 0.5 * (piece.t + piece.end_t))
    return sorted([*times, *(t for _, t in longest.values())])


def ground(ax: Axes, slope: float, low: float, high: float, radius: float) -> None:
    """Draw the plane as a line with a band below it."""
    reach = max(abs(low), abs(high)) / math.cos(slope) + 2.0 * radius
    ends = to_world([-reach, reach], [0.0, 0.0], slope)
    # deep enough for both ends of a slope
    deep = -4.0 * radius - 2.0 * reach * abs(math.tan(slope))
    below = to_world([reach, -reach], [deep, deep], slope)
    corners: Floats = np.concatenate([ends, below])
    ax.fill(corners[:, 0], corners[:, 1], color=colors.LIGHT_GRAY, alpha=0.6, lw=0, zorder=0)
    ax.plot(ends[:, 0], ends[:, 1], color=colors.BLACK, lw=1.0, zorder=1)


def geometry(hoop: Hoop | None = None, angle: float = 0.9, ax: Axes | None = None) -> Axes:
    """Draw the hoop on the plane, with the names and signs of the model.

    Parameters
    ----------
    hoop : Hoop, optional
        By default the reference hoop.
    angle : float, default 0.9
        θ at which it is drawn [rad].
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If the angle is not finite.
    ImportError
        If Matplotlib is missing.
    """
    if not math.isfinite(angle):
        raise InputError.of_field("angle", angle, "a finite number")
    hoop = Hoop() if hoop is None else hoop
    ax = new_axes(ax, (5.6, 3.6))
    sine, cosine = math.sin(angle), math.cos(angle)
    eps = hoop.eccentricity
    load = load_distance(hoop) / hoop.radius
    ax.fill_between([-2.0, 2.4], -0.24, 0.0, color=colors.LIGHT_GRAY, alpha=0.6, lw=0)
    ax.plot([-2.0, 2.4], [0.0, 0.0], color=colors.BLACK, lw=1.2)
    drawn = HoopArtist(ax, hoop, 0.0, ring=4.0, load=16.0, line="none")
    drawn.pose((0.0, 1.0), angle, 1.0 / hoop.radius)
    drawn.paint("#3A4A5A")
    ideal = hoop.load_fraction is not None
    green, load_words = colors.GRAVITY_CENTER, r"load, $\gamma m$" if ideal else "load"
    # θ from the outward normal to the line from C to G
    dashed: dict[str, Any] = {"color": colors.GRAY, "lw": 0.9, "ls": (0, (6, 2, 1, 2))}
    ax.plot([0.0, 0.0], [1.0, 2.3], **dashed)
    ax.plot([0.0, load * sine], [1.0, 1.0 + load * cosine], **dashed)
    ax.add_patch(
        need("matplotlib.patches", "plots").Arc((0.0, 1.0), 0.9, 0.9, theta1=90.0 - math.degrees(angle), theta2=90.0, lw=1.2)
    )
    tip, tail = ((0.45 * math.sin(angle - less), 1.0 + 0.45 * math.cos(angle - less)) for less in (0.02, 0.2))
    for head, foot, color, width in (
        (tip, tail, colors.BLACK, 0.0),
        ((-0.92, 1.39), (0.0, 1.0), colors.GRAY, 1.4),
        ((0.62, 1.0), (0.0, 1.0), colors.CENTER_SPEED, 2.0),
        ((0.0, 0.62), (0.0, 0.0), colors.NORMAL_FORCE, 2.2),
        ((0.74, 0.035), (0.0, 0.035), colors.FRICTION_FORCE, 2.2),  # it acts on the hoop where it touches the plane
        ((-1.6, 0.55), (-1.6, 1.15), colors.BLACK, 1.4),
        ((2.2, -0.12), (1.6, -0.12), colors.BLACK, 1.4),
    ):
        look: dict[str, Any] = {
            "arrowstyle": "-|>",
            "lw": width,
            "shrinkA": 0,
            "shrinkB": 0,
            "mutation_scale": 13,
            "color": color,
        }
        ax.annotate("", head, foot, arrowprops=look)
    ax.plot(0.0, 1.0, "o", color=colors.BLACK, mfc="white", ms=5, mew=1.3)
    ax.plot(eps * sine, 1.0 + eps * cosine, "o", color=green, ms=8)
    middle = (0.56 * math.sin(0.5 * angle), 1.0 + 0.56 * math.cos(0.5 * angle))
    for (x, y), words, size, color, across, up in (
        (middle, r"$\theta$", 14, colors.BLACK, "center", "center"),
        ((-0.46, 1.26), "$R$", 12, colors.GRAY, "center", "bottom"),
        ((0.66, 0.99), "$v$", 13, colors.BLACK, "left", "center"),
        ((-0.08, 0.94), "$C$", 12, colors.BLACK, "right", "top"),
        ((load * sine + 0.17, 1.06 + load * cosine), load_words, 12, colors.BLACK, "left", "bottom"),
        ((-0.80, 1.72), r"ring, $(1-\gamma)m$" if ideal else "", 12, colors.BLACK, "right", "bottom"),
        ((eps * sine - 0.02, 0.9 + eps * cosine), "$G$", 12, green, "left", "top"),
        ((1.06, 1.32), r"$CG = \varepsilon R$" + (r" $= \gamma R$" if ideal else ""), 12, green, "left", "center"),
        ((0.07, 0.45), "$N$", 13, colors.NORMAL_FORCE, "left", "center"),
        ((0.80, 0.13), "$F$", 13, colors.FRICTION_FORCE, "left", "center"),
        ((-1.53, 0.85), "$g$", 13, colors.BLACK, "left", "center"),
        ((1.53, -0.12), "$x$", 13, colors.BLACK, "right", "center"),
    ):
        ax.text(x, y, words, fontsize=size, color=color, ha=across, va=up)
    ax.set_aspect("equal")
    ax.set_xlim(-2.0, 2.4)
    ax.set_ylim(-0.24, 2.4)
    ax.axis("off")
    return ax
