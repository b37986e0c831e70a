"""Common parts of all figures: new axes, labels, modes as a ribbon and a tint, marks at events."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, cast

from hophoop._support.extras import need
from hophoop.plots.curves import phases, turning
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities
from hophoop.vocabulary.names import EVENTS, MARKS
from hophoop.vocabulary.parameters import PARAMETERS

if TYPE_CHECKING:
    from matplotlib.axes import Axes as Axes
else:
    Axes = Any

Against = Literal["time", "angle"]

SIZE = (7.2, 4.0)
SMALL = 8.5
MOST_LINES = 12  # at take-offs or landings; more would hide the curves


def new_axes(ax: Axes | None, size: tuple[float, float] = SIZE) -> Axes:
    """Return the given axes, or those of a new figure."""
    if ax is not None:
        return ax
    _, fresh = need("matplotlib.pyplot", "plots").subplots(figsize=size, layout="constrained")
    return cast("Axes", fresh)


def parameter_axis(path: str) -> tuple[float, str]:
    """Return the factor from SI units to those of a parameter's axis, degrees for angles, and its label."""
    row = PARAMETERS.get(path)
    if row is None:
        return 1.0, path
    angular = row.unit == "rad"
    return (math.degrees(1.0) if angular else 1.0), quantities.with_unit(row.figure or row.label, "°" if angular else row.unit)


def check_against(against: str) -> None:
    """Refuse a value other than time and angle."""
    if against not in ("time", "angle"):
        raise InputError.of_field("against", against, "'time' or 'angle'")


def check_labels(labels: Sequence[str] | None, motions: Sequence[Trajectory]) -> None:
    """Refuse labels that are not one for each motion."""
    if labels is not None and len(labels) != len(motions):
        raise InputError.of_field("labels", list(labels), f"one for each of the {len(motions)} motions")


# Width of a legend's entry, its line with space and a letter of its name, and of a letter on the ribbon [inch].
HANDLE, LETTER, WIDE = 0.54, 0.051, 0.069
DARK = 0.45  # maximum lightness of a colour under white letters


def finish(ax: Axes, across: str, up: str) -> None:
    """Add labels, a light grid and a legend clear of the curves; remove the frame without a scale."""
    ax.set_xlabel(across)
    ax.set_ylabel(_scaled(ax, up))
    ax.grid(True, color="#000000", alpha=0.10, linewidth=0.6)
    ax.set_axisbelow(True)
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    # a name has one key, also of several curves
    keys = {name: handle for handle, name in zip(*ax.get_legend_handles_labels(), strict=True)}
    if not keys:
        return
    # below the axes, clear of the curves and of neighbouring axes
    columns = len(keys) if len(keys) <= 3 else math.ceil(len(keys) / 2)
    columns = min(columns, max(1, int(_width(ax) / (HANDLE + LETTER * max(map(len, keys))))))
    ax.legend(
        handles=keys.values(), frameon=False, fontsize=9, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=columns,
        handlelength=3.2, borderaxespad=3.6,
    )  # fmt: skip


def _width(ax: Axes) -> float:
    """Width of axes before the figure is laid out [inch]."""
    return float(ax.bbox.width / ax.figure.dpi)


def _scaled(ax: Axes, label: str) -> str:
    """Return the label with the power of ten that is factored out of the tick numbers.

    Matplotlib writes it above the axes, under the ribbon of modes.
    """
    ticker = need("matplotlib.ticker", "plots")
    if ax.get_yscale() != "linear":
        return label
    size = max(abs(end) for end in ax.get_ylim())
    power = 3 * math.floor(math.log10(size) / 3.0) if 0.0 < size < math.inf else 0
    plain = ticker.ScalarFormatter(useOffset=False)
    plain.set_scientific(False)
    if -3 < power < 6:
        ax.yaxis.set_major_formatter(plain)
        return label
    ax.yaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value / 10.0**power:g}".replace("-", "−")))
    words, bracket, unit = label.rpartition("(")
    if bracket:
        return rf"{words}($10^{{{power}}}$ {unit}"
    return rf"{label} ($10^{{{power}}}$)"


def abscissa(ax: Axes, against: Against) -> str:
    """Fit the scale of time or angle to the curves, and return its label."""
    ax.margins(x=0.0)
    if against == "time":
        return quantities.TIME
    low, high = ax.get_xlim()
    degrees(ax, high - low)
    return quantities.ANGLE


def degrees(ax: Axes, span: float) -> None:
    """Set ticks at fractions or multiples of a right angle."""
    step = next((step for step in (15, 30, 45, 90, 180, 360, 720, 1800, 3600) if span / step <= 9), 7200)
    ax.xaxis.set_major_locator(need("matplotlib.ticker", "plots").MultipleLocator(step))


def show_modes(ax: Axes, motion: Trajectory, against: Against) -> None:
    """Draw modes as a tint behind the curves and as a ribbon with their names above; mark events on the ribbon."""
    if against == "angle" and turning(motion):
        return  # the angle does not order the phases
    low, high = ax.get_xlim()
    for piece in phases(motion):
        begin, end = sorted((piece.t, piece.end_t) if against == "time" else (piece.angle, piece.end_angle))
        color = colors.mode_color(piece.word)
        ax.axvspan(begin, end, color=color, alpha=colors.SHADE, linewidth=0, zorder=0)
        ax.axvspan(begin, end, ymin=1.0, ymax=1.055, facecolor=color, edgecolor="white", lw=0.8, clip_on=False, zorder=3)
        # the word, since the colour follows the word, not the letter
        if (end - begin) / (high - low) * _width(ax) >= WIDE * (len(piece.word) + 1):
            ax.text(
                0.5 * (begin + end), 1.026, piece.word, transform=ax.get_xaxis_transform(), ha="center", va="center_baseline",
                fontsize=SMALL - 1, color="white" if colors.lightness(color) < DARK else "black", zorder=5,
            )  # fmt: skip
    _mark_events(ax, motion, against)


def _mark_events(ax: Axes, motion: Trajectory, against: Against) -> None:
    """Draw marks above the ribbon, which the legend explains, and lines at take-offs and landings."""
    style: dict[str, Any] = {"ls": "", "ms": 5, "color": colors.BLACK, "transform": ax.get_xaxis_transform(), "clip_on": False}
    shown = [event for event in motion.events if event.kind in MARKS]
    for kind in dict.fromkeys(event.kind for event in shown):
        places = [event.t if against == "time" else math.degrees(event.angle) for event in shown if event.kind == kind]
        count = f"{len(places)} × " if len(places) > MOST_LINES else ""  # the marks of as many may lie over each other
        ax.plot(places, [1.09] * len(places), marker=MARKS[kind], label=count + EVENTS[kind].noun, **style)
        if kind in ("takeoff", "impact") and len(places) <= MOST_LINES:
            for place in places:
                ax.axvline(place, color=colors.GRAY, lw=0.8, ls=(0, (2, 2)), zorder=1)


def as_list(motions: Trajectory | Sequence[Trajectory]) -> list[Trajectory]:
    """Return one motion or several as a non-empty list."""
    many = [motions] if isinstance(motions, Trajectory) else list(motions)
    if not many:
        raise InputError("motions must hold at least one motion.", field="motions")
    return many
