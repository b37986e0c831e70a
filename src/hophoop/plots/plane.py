"""The (θ, θ̇) plane: where a rolling hoop continues to roll, slips or lifts off, with motions drawn on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any, cast

import numpy as np

from hophoop import theory
from hophoop._support.extras import need
from hophoop.plots.curves import curve, shown_words
from hophoop.plots.path import legend_above
from hophoop.plots.style import Axes, check_labels, degrees, new_axes
from hophoop.scenario import Hoop, InputError, Plane, Scenario
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities
from hophoop.vocabulary.names import FLIGHT, MARKS, ROLL, SKID, SKIM, SPIN, mode_words

GRID = (900, 560)
TINT = 0.30  # opacity of a region's colour; motions have the full colour
NO_ANSWER = "?"
MARKED = ("takeoff", "impact", "jam")
FOLLOWS = {
    ROLL: "rolls on",
    SPIN: "slips: spin",
    SKID: "slips: skid",
    FLIGHT: "lifts off",
    SKIM: "skims",
    NO_ANSWER: "no answer",
}


def phase_plane(
    hoop: Hoop | None = None,
    plane: Plane | None = None,
    motions: Sequence[Trajectory] = (),
    labels: Sequence[str] | None = None,
    ax: Axes | None = None,
    angles: tuple[float, float] = (0.0, 2.0 * math.pi),
    speeds: tuple[float, float] | None = None,
) -> Axes:
    """Draw the mode that follows contact without slip, at every angle and angular velocity.

    On the solid boundary rolling requires all of the static friction. On the dashed one gravity no longer holds
    the rim down (f_n = 0); above it a slipping hoop leaves the plane. Motions are drawn in their modes'
    colours, dashed if their hoop or plane differs from that of the regions.

    Parameters
    ----------
    hoop : Hoop, optional
        By default that of the first motion, else the reference hoop.
    plane : Plane, optional
        By default that of the first motion, else the reference plane.
    motions : sequence of Trajectory, optional
        Drawn on the plane.
    labels : sequence of str, optional
        One per motion.
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    angles : tuple of float, default (0, 2π)
        Minimum and maximum θ [rad].
    speeds : tuple of float, optional
        Minimum and maximum θ̇; by default so that the motions fit [rad/s].

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If the numbers of labels and motions differ, or a range is empty.
    ImportError
        If Matplotlib is missing.
    """
    check_labels(labels, motions)
    first = motions[0].scenario if motions else Scenario()
    hoop, plane = hoop or first.hoop, plane or first.plane
    low, high = _speeds(hoop, plane, motions) if speeds is None else speeds
    for name, (least, most) in (("angles", angles), ("speeds", (low, high))):
        if not (math.isfinite(least) and math.isfinite(most) and least < most):
            raise InputError.of_field(name, (least, most), "a smaller and a greater number")
    ax = new_axes(ax, (8.4, 5.6))
    regions = _regions(ax, hoop, plane, angles, (low, high))
    borders = _borders(ax, hoop, plane, angles, (low, high))
    for motion in motions:
        own = motion.scenario.hoop == hoop and motion.scenario.plane == plane
        _draw(ax, motion, "-" if own else (0, (3, 1.2)))
    ax.set_xlim(*np.degrees(angles))
    ax.set_ylim(low, high)
    degrees(ax, math.degrees(angles[1] - angles[0]))
    ax.set_xlabel(quantities.ANGLE)
    ax.set_ylabel(quantities.ROTATION)
    legend_above(ax, [*regions, *borders])
    if labels is not None:
        _name(ax, motions, labels, angles)
    return ax


def _speeds(hoop: Hoop, plane: Plane, motions: Sequence[Trajectory]) -> tuple[float, float]:
    rates = [rate for motion in motions for rate in motion.at(motion.times(600)).omega if math.isfinite(rate)]
    usual = 3.2 * math.sqrt(max(plane.gravity, 1.0) / hoop.radius)
    return 1.06 * min([0.0, *rates]), 1.06 * max([usual, *rates])


def _regions(ax: Axes, hoop: Hoop, plane: Plane, angles: tuple[float, float], speeds: tuple[float, float]) -> list[Any]:
    """Draw every pixel's mode, exact at its centre, and return the keys to the modes in the picture."""
    columns, rows = GRID
    theta = angles[0] + (np.arange(columns) + 0.5) * (angles[1] - angles[0]) / columns
    omega = speeds[0] + (np.arange(rows) + 0.5) * (speeds[1] - speeds[0]) / rows
    modes = mode_words(theory.mode_of(theta[None, :], omega[:, None], hoop, plane), omega[:, None])
    # works on light and dark backgrounds
    paint = need("matplotlib.colors", "plots").to_rgba_array([_color(word) for word in FOLLOWS], TINT)
    codes = np.select([modes == word for word in FOLLOWS], range(len(FOLLOWS)))
    ax.imshow(
        paint[codes], origin="lower", aspect="auto", interpolation="nearest", zorder=0,
        extent=(*np.degrees(angles), *speeds),
    )  # fmt: skip
    patch = need("matplotlib.patches", "plots").Patch
    return [
        patch(fc=paint[code], ec=colors.GRAY, lw=0.5, label=follows)
        for code, follows in enumerate(FOLLOWS.values())
        if (codes == code).any()
    ]


def _color(word: str) -> str:
    return colors.LIGHT_GRAY if word == NO_ANSWER else colors.mode_color(word)


def _borders(ax: Axes, hoop: Hoop, plane: Plane, angles: tuple[float, float], speeds: tuple[float, float]) -> list[Any]:
    """Draw the boundaries of rolling and of lift-off, and return the keys to both."""
    theta = np.linspace(*angles, 4001)
    ends = theory.rolling_range(theta, hoop, plane)
    single = ends.low >= (1.0 - 1e-9) * ends.high  # one angular velocity, where the massless hoop is on both thresholds
    least, most = (np.nan_to_num(np.where(single, 0.0, border)) for border in ends)
    lift = np.asarray(theory.lift_off_speed(theta, hoop, plane), dtype=float)
    top = 3.0 * max(abs(speeds[0]), abs(speeds[1]))
    rolling: dict[str, Any] = {"color": "black", "lw": 1.1, "zorder": 2}
    lifting: dict[str, Any] = {"color": colors.GRAVITY_CENTER_AIRBORNE, "lw": 1.5, "ls": (0, (5, 2)), "zorder": 2}
    # the boundary is vertical where it comes down to θ̇ = 0: to the next point of the grid
    above = np.pad(least > 0.0, 1)
    foot = ~above[1:-1] & (above[2:] | above[:-2])
    for sign in (1.0, -1.0) if speeds[0] < 0.0 else (1.0,):
        for border, shown in ((least, (least > 0.0) | foot), (most, most > 0.0)):
            values = np.where(shown & (border < top), np.maximum(border, 0.0), np.nan)
            ax.plot(np.degrees(theta), sign * values, **rolling)
        ax.plot(np.degrees(theta), sign * np.where(lift < top, lift, np.nan), **lifting)
    return [
        *ax.plot([], [], **rolling, label=r"$|F| = \mu N$ in rolling"),
        *ax.plot([], [], **lifting, label="lift-off, $f_n = 0$"),
    ]


def _draw(ax: Axes, motion: Trajectory, dashes: Any) -> None:
    sample = curve(motion)
    across = np.degrees(sample.angle)
    ax.plot(across, sample.omega, color="white", lw=3.6, zorder=3, alpha=0.85, solid_capstyle="round")
    words = shown_words(sample)
    changes = np.flatnonzero(words[1:] != words[:-1]) + 1
    for a, b in pairwise([0, *changes.tolist(), len(across)]):
        piece = slice(max(a - 1, 0), b)  # from the last point of the previous phase
        ink = colors.mode_color(str(words[a]))
        ax.plot(across[piece], sample.omega[piece], color=ink, lw=2.2, ls=dashes, zorder=4)
    for event in motion.events:
        if event.kind in MARKED:
            ax.plot(math.degrees(event.angle), event.omega, MARKS[event.kind], color="black", mec="white", ms=8, zorder=6)


def _name(ax: Axes, motions: Sequence[Trajectory], labels: Sequence[str], angles: tuple[float, float]) -> None:
    """Put a number on each motion, at an angle of its own, and explain the numbers below."""
    span = min(angles[1] - angles[0], 2.0 * math.pi)
    for k, motion in enumerate(motions):
        sample = curve(motion)
        at = int(np.nanargmin(np.abs(sample.angle - angles[0] - span * (k + 1) / (len(motions) + 1))))
        ax.text(
            math.degrees(sample.angle[at]), sample.omega[at], str(k + 1), ha="center", va="center", fontsize=9,
            bbox={"boxstyle": "circle,pad=0.15", "fc": "white", "ec": colors.GRAY, "lw": 0.6}, zorder=7, clip_on=True,
        )  # fmt: skip
    above = cast("Any", ax.get_legend())
    ax.add_artist(above)
    above.set_clip_on(False)  # it would be given no room
    handles = [ax.plot([], [], " ", label=f"{k + 1}  {label}")[0] for k, label in enumerate(labels)]
    ax.legend(
        handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.09), ncol=min(3, len(handles)), frameon=False, fontsize=9,
        handlelength=0, handletextpad=0,
    )  # fmt: skip
