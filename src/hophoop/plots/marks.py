"""Events marked above a figure. Events whose labels would overlap share one label, such as '9 impacts'."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import EVENTS, MARKS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
else:
    Axes = Any

FOLLOW = ("takeoff", "apex")  # each impact of a series has one of each
LETTER = 0.58  # width of a letter over the size of the font, on average
FONT, MARKER = 8.0, 4.5  # [points]
APART = 6.0  # between two labels [points]
LEVEL, ABOVE = 1.085, 1.11  # of marks and of words, over the height of the axes


@dataclass(frozen=True)
class Cluster:
    """Events under one label: their positions across the axes [points] and the label's text."""

    places: tuple[float, ...]
    kinds: tuple[str, ...]
    words: str
    letter: float  # width of a letter [points]

    @property
    def middle(self) -> float:
        """Halfway between the first and the last."""
        return 0.5 * (self.places[0] + self.places[-1])

    @property
    def width(self) -> float:
        """Of the label."""
        return self.letter * len(self.words)

    @property
    def dense(self) -> bool:
        """Whether its marks would overlap."""
        return len(self.places) > 2 and self.places[-1] - self.places[0] < 1.5 * MARKER * (len(self.places) - 1)


def clusters(places: Sequence[float], kinds: Sequence[str], width: float, letter: float = LETTER * FONT) -> list[Cluster]:
    """Group events until no two labels overlap.

    places: from the left end of the axes, in order [points]; kinds: one per position; width: width of the axes; labels stay
    inside where they fit [points]; letter: width of a letter, in the same unit as the others [points].
    """
    found: list[Cluster] = []
    for place, kind in zip(places, kinds, strict=True):
        found.append(_cluster((place,), (kind,), letter))
        while len(found) > 1 and _collide(found[-2], found[-1], width):
            last = found.pop()
            before = found.pop()
            found.append(_cluster(before.places + last.places, before.kinds + last.kinds, letter))
    return found


def center_of_label(cluster: Cluster, width: float) -> float:
    """Return the centre of a label: above its events, but not beyond the axes [points]."""
    half = 0.5 * cluster.width
    return min(max(cluster.middle, half), max(width - half, half))


def _collide(left: Cluster, right: Cluster, width: float) -> bool:
    room = center_of_label(right, width) - center_of_label(left, width)
    return room < 0.5 * (left.width + right.width) + APART


def _cluster(places: tuple[float, ...], kinds: tuple[str, ...], letter: float) -> Cluster:
    order = [kind for kind in MARKS if kind in kinds] if len(kinds) > 3 else list(dict.fromkeys(kinds))
    counts = {kind: kinds.count(kind) for kind in order}
    if counts.get("impact", 0) > 1:
        counts = {kind: count for kind, count in counts.items() if kind not in FOLLOW}
    return Cluster(places, kinds, ", ".join(_words(kind, count) for kind, count in counts.items()), letter)


def _words(kind: str, count: int) -> str:
    noun = EVENTS[kind].noun
    if count == 1:
        return noun
    return f"{count} impacts" if kind == "impact" else f"{count} × {noun}"


def mark_events(ax: Axes, motion: Trajectory, places: Sequence[float]) -> None:
    """Draw marks and labels above the axes, and vertical lines at take-offs and landings.

    places: positions of the motion's events, in the unit of the axis [s or °].
    """
    low, high = ax.get_xlim()
    # measured before the layout: the axes become wider rather than narrower
    inches = cast("Any", ax.figure).get_figure(root=True).get_size_inches()[0]
    width = ax.get_position().width * inches * 72.0
    shown = sorted(
        (place, event.kind)
        for event, place in zip(motion.events, places, strict=True)
        if event.kind in MARKS and low <= place <= high
    )
    point = (high - low) / width
    found = clusters([(place - low) / point for place, _ in shown], [kind for _, kind in shown], width)
    last_line = -APART
    for cluster in found:
        for place, kind in zip(cluster.places, cluster.kinds, strict=True):
            if kind in ("takeoff", "impact") and place - last_line >= MARKER:
                ax.axvline(low + point * place, color=colors.GRAY, lw=0.8, ls=(0, (2, 2)), zorder=1)
                last_line = place
        _draw(ax, cluster, low, point, width)


def _draw(ax: Axes, cluster: Cluster, low: float, point: float, width: float) -> None:
    transform = ax.get_xaxis_transform()
    style: dict[str, Any] = {"color": colors.BLACK, "transform": transform, "clip_on": False, "zorder": 5}
    across = [low + point * place for place in cluster.places]
    alone = list(zip(across, cluster.kinds, strict=True))
    if cluster.dense:
        # the line spans the counted events; the rise before the first impact is not among them
        row = [place for place, kind in alone if kind == "impact"]
        first, last = (row[0], row[-1]) if len(row) > 1 else (across[0], across[-1])
        ax.plot([first, last], [LEVEL, LEVEL], "-|", ms=6, lw=1.4, **style)
        alone = [(place, kind) for place, kind in alone if not first - MARKER * point < place < last + MARKER * point]
    for place, kind in alone:
        ax.plot([place], [LEVEL], MARKS[kind], ms=MARKER, **style)
    middle = low + point * center_of_label(cluster, width)
    ax.text(middle, ABOVE, cluster.words, transform=transform, ha="center", va="bottom", fontsize=FONT)
