"""Path of the hoop: traces of load and centre of gravity, with the hoop drawn at its events."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.plots.curves import curve, phases
from hophoop.plots.hoop import HoopArtist
from hophoop.plots.style import Axes, new_axes
from hophoop.results.poses import Poses, load_distance, poses_of, to_world
from hophoop.results.records import EventRecord
from hophoop.scenario import Hoop, InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities

MOST_POSES = 14
WIDTH = 10.0  # of a figure [inch]
MARGIN, BELOW = 1.25, 0.3  # around the centres, and below the plane, in radii


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
    way = poses_of(motion, curve(motion).t)
    poses = poses_of(motion, _pose_times(motion) if times is None else times)
    ax = scene(ax, way, hoop.radius, slope, 0.9)
    for center, angle, word in zip(poses.center, poses.angle.tolist(), poses.words.tolist(), strict=True):
        drawn = HoopArtist(ax, hoop, slope, ring=1.6, load=7.0, line=colors.mode_color(word), alpha=0.9)
        drawn.pose(center, angle)
        drawn.paint(colors.mode_color(word))
    draw_traces(ax, way, zorder=4)
    add_mode_keys(ax, poses)
    legend_above(ax)
    return ax


def scene(ax: Axes | None, way: Poses, radius: float, slope: float, more: float) -> Axes:
    """Return axes of equal scales around a motion, with the plane; more: height of what is above and below [inch]."""
    low, high = way.center.min(axis=0) - MARGIN * radius, way.center.max(axis=0) + MARGIN * radius
    low[1] = min(low[1], -max(low[0] * math.tan(slope), high[0] * math.tan(slope)) - BELOW * radius)
    height = WIDTH * (high[1] - low[1]) / (high[0] - low[0]) + more
    ax = new_axes(ax, (WIDTH, float(np.clip(height, 2.3, 7.0))))
    reach = 2.0 * float(np.abs([low, high]).max())
    ground = to_world([-reach, reach, reach, -reach], [0.0, 0.0, -reach, -reach], slope)
    ax.fill(*ground.T, color=colors.LIGHT_GRAY, alpha=0.6, lw=0, zorder=0)
    ax.plot(*ground[:2].T, color=colors.BLACK, lw=1.0, zorder=1)
    ax.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), ylabel=quantities.HEIGHT)
    ax.set_xlabel(quantities.PLACE if slope == 0.0 else quantities.DISTANCE)
    ax.spines[["top", "right"]].set_visible(False)
    return ax


def draw_traces(ax: Axes, way: Poses, zorder: float) -> None:
    """Draw the traces of the load, and of the centre of gravity in contact and airborne."""
    # the dots are the loads of the drawn hoops: this line has one in the legend alone
    ax.plot(*way.load.T, "o-", color=colors.LOAD, lw=1.2, markevery=[], zorder=zorder, label="load")
    airborne = way.mode == "H"
    for here, ink, dashes, width, label in (
        (~airborne, colors.GRAVITY_CENTER, "-", 2.0, "centre of gravity"),
        (airborne, colors.GRAVITY_CENTER_AIRBORNE, (0, (5, 1)), 2.4, "airborne"),
    ):
        if here.any():
            # the part after a point has that point's mode
            shown = here | np.append(False, here[:-1])
            line = np.where(shown[:, None], way.gravity_center, np.nan)
            ax.plot(*line.T, color=ink, lw=width, ls=dashes, zorder=zorder + 1, label=label)


def add_mode_keys(ax: Axes, poses: Poses) -> None:
    """Add keys to the colours of rings by mode."""
    for word in dict.fromkeys(poses.words.tolist()):
        ax.plot([], [], "o", color=colors.mode_color(word), label=word, ms=9, mfc="none", mew=2)


def legend_above(ax: Axes, handles: Sequence[Any] = ()) -> None:
    """Draw a legend above the axes, in two rows where it is long; handles: by default all that have a label."""
    handles = handles or ax.get_legend_handles_labels()[0]
    columns = len(handles) if len(handles) <= 8 else math.ceil(len(handles) / 2)
    ax.legend(
        handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=columns, frameon=False, fontsize=9,
        columnspacing=1.4,
    )  # fmt: skip


def _pose_times(motion: Trajectory) -> list[float]:
    """Return the times of events, without those where the hoop would cover an earlier one; every mode is shown."""
    chosen: list[EventRecord[float]] = []
    for event in motion.events:
        if all(abs(event.x - other.x) > 0.45 * motion.scenario.hoop.radius for other in chosen):
            chosen.append(event)
    if len(chosen) < 4:  # equally spaced along the path
        grid = motion.times(400)
        x = motion.at(grid).x
        way = np.cumsum(np.abs(np.diff(x, prepend=x[0])))
        times = np.interp(np.linspace(0.0, way[-1], 6), way, grid).tolist()
    else:
        kept = np.linspace(0, len(chosen) - 1, min(len(chosen), MOST_POSES)).astype(int)
        times = [chosen[k].t for k in kept]
    shown = set(poses_of(motion, times).words.tolist())
    # the longest phase of each mode is the last
    longest = {piece.word: piece for piece in sorted(phases(motion), key=lambda piece: piece.end_t - piece.t)}
    return sorted([*times, *(0.5 * (piece.t + piece.end_t) for word, piece in longest.items() if word not in shown)])


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
    black, gray, green = colors.BLACK, colors.GRAY, colors.GRAVITY_CENTER
    # θ from the outward normal to the line from C to G
    dashed: dict[str, Any] = {"color": gray, "lw": 0.9, "ls": (0, (6, 2, 1, 2))}
    ax.plot([0.0, 0.0], [1.0, 2.3], **dashed)
    ax.plot([0.0, load * sine], [1.0, 1.0 + load * cosine], **dashed)
    ax.add_patch(
        need("matplotlib.patches", "plots").Arc((0.0, 1.0), 0.9, 0.9, theta1=90.0 - math.degrees(angle), theta2=90.0, lw=1.2)
    )
    tip, tail = ((0.45 * math.sin(angle - less), 1.0 + 0.45 * math.cos(angle - less)) for less in (0.02, 0.2))
    for head, foot, color, width in (
        (tip, tail, black, 0.0),
        ((-0.92, 1.39), (0.0, 1.0), gray, 1.4),
        ((0.62, 1.0), (0.0, 1.0), colors.CENTER_SPEED, 2.0),
        ((0.0, 0.62), (0.0, 0.0), colors.NORMAL_FORCE, 2.2),
        ((0.74, 0.035), (0.0, 0.035), colors.FRICTION_FORCE, 2.2),  # it acts on the hoop where it touches the plane
        ((-1.6, 0.55), (-1.6, 1.15), black, 1.4),
        ((2.2, -0.12), (1.6, -0.12), black, 1.4),
    ):
        arrow = {"arrowstyle": "-|>", "lw": width, "color": color, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 13}
        ax.annotate("", head, foot, arrowprops=arrow)
    ax.plot(0.0, 1.0, "o", color=black, mfc="white", ms=5, mew=1.3)
    ax.plot(eps * sine, 1.0 + eps * cosine, "o", color=green, ms=8)
    middle = (0.56 * math.sin(0.5 * angle), 1.0 + 0.56 * math.cos(0.5 * angle))
    for (x, y), words, size, color, across, up in (
        (middle, r"$\theta$", 14, black, "center", "center"),
        ((-0.46, 1.26), "$R$", 12, gray, "center", "bottom"),
        ((0.66, 0.99), "$v$", 13, black, "left", "center"),
        ((-0.08, 0.94), "$C$", 12, black, "right", "top"),
        ((load * sine + 0.17, 1.06 + load * cosine), r"load, $\gamma m$" if ideal else "load", 12, black, "left", "bottom"),
        ((-0.80, 1.72), r"ring, $(1-\gamma)m$" if ideal else "", 12, black, "right", "bottom"),
        ((eps * sine - 0.02, 0.9 + eps * cosine), "$G$", 12, green, "left", "top"),
        ((1.06, 1.32), r"$CG = \varepsilon R$" + (r" $= \gamma R$" if ideal else ""), 12, green, "left", "center"),
        ((0.07, 0.45), "$N$", 13, colors.NORMAL_FORCE, "left", "center"),
        ((0.80, 0.13), "$F$", 13, colors.FRICTION_FORCE, "left", "center"),
        ((-1.53, 0.85), "$g$", 13, black, "left", "center"),
        ((1.53, -0.12), "$x$", 13, black, "right", "center"),
    ):
        ax.text(x, y, words, fontsize=size, color=color, ha=across, va=up)
    ax.set_aspect("equal")
    ax.set_xlim(-2.0, 2.4)
    ax.set_ylim(-0.24, 2.4)
    ax.axis("off")
    return ax
