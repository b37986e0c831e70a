"""Common parts of all figures: new axes, labels, modes as a ribbon and a tint, marks at events."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, cast

from hophoop._support.extras import need
from hophoop.plots.curves import Phase, phases, turning
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


# Width of a legend's entry: its line with space, and one letter of its name [inch].
HANDLE, LETTER = 0.7, 0.066


def finish(ax: Axes, across: str, up: str) -> None:
    """Add labels, a light grid and a legend clear of the curves; remove the frame without a scale."""
    ax.set_xlabel(across)
    ax.set_ylabel(_scaled(ax, up))
    ax.grid(True, color="#000000", alpha=0.10, linewidth=0.6)
    ax.set_axisbelow(True)
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    handles, names = ax.get_legend_handles_labels()
    if not handles:
        return
    # below the axes, clear of the curves and of neighbouring axes
    columns = len(handles) if len(handles) <= 3 else math.ceil(len(handles) / 2)
    columns = min(columns, max(1, int(_width(ax) / (HANDLE + LETTER * max(len(name) for name in names)))))
    ax.legend(
        frameon=False, fontsize=9, loc="upper center", bbox_to_anchor=(0.5, -0.155), ncol=columns,
        handlelength=3.2,
    )  # fmt: skip


def _width(ax: Axes) -> float:
    """Width of axes in a grid of a figure [inch]."""
    figure = ax.figure
    place = ax.get_subplotspec()
    share = 1.0 if place is None else (place.colspan.stop - place.colspan.start) / place.get_gridspec().ncols
    return float(figure.bbox.width / figure.dpi) * share


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


def abscissa(ax: Axes, motion: Trajectory, against: Against) -> str:
    """Set the scale of time or angle to the motion, and return its label."""
    if against == "time":
        ax.set_xlim(0.0, motion.duration or 1.0)
        return quantities.TIME
    marks = [phase.angle for phase in phases(motion)] + [phase.end_angle for phase in phases(motion)]
    turns = [math.degrees(event.angle) for event in motion.events]
    low, high = min(*marks, *turns), max(*marks, *turns)
    if high > low:
        ax.set_xlim(low, high)
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
    pieces = phases(motion)
    low, high = ax.get_xlim()
    transform = ax.get_xaxis_transform()
    for piece in pieces:
        begin, end = (piece.t, piece.end_t) if against == "time" else (piece.angle, piece.end_angle)
        if not end > begin:
            begin, end = end, begin
        color = colors.mode_color(piece.word)
        ax.axvspan(begin, end, color=color, alpha=colors.SHADE, linewidth=0, zorder=0)
        ax.axvspan(begin, end, ymin=1.0, ymax=1.055, color=color, linewidth=0, clip_on=False, zorder=3)
        if begin > low:
            ax.plot(
                [begin, begin],
                [1.0, 1.055],
                color="white",
                lw=0.8,
                transform=transform,
                clip_on=False,
                zorder=4,
            )
        word = _word(piece, (end - begin) / (high - low), ax)
        if word:
            ax.text(
                0.5 * (begin + end), 1.026, word, transform=transform, ha="center", va="center_baseline",
                fontsize=SMALL - 1, color=_ink(piece.word), zorder=5,
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


def _word(piece: Phase, share: float, ax: Axes) -> str:
    # a letter takes about 5.5 points of the axes' width
    inches = cast("Any", ax.figure).get_figure(root=True).get_size_inches()[0]
    room = share * ax.get_position().width * inches * 72.0 / 5.0
    if room >= len(piece.word) + 1:
        return piece.word
    return ""  # the word, since the colour follows the word, not the letter


def _ink(word: str) -> str:
    return "white" if colors.lightness(colors.mode_color(word)) < 0.45 else "black"


def as_list(motions: Trajectory | Sequence[Trajectory]) -> list[Trajectory]:
    """Return one motion or several as a non-empty list."""
    many = [motions] if isinstance(motions, Trajectory) else list(motions)
    if not many:
        raise InputError("motions must hold at least one motion.", field="motions")
    return many
