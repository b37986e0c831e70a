"""Names next to curves: each in the nearest free space, with a line to its curve if it is not close."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from hophoop.plots.style import SMALL
from hophoop.vocabulary import colors

if TYPE_CHECKING:
    from matplotlib.axes import Axes
else:
    Axes = Any

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

CELL = 2.0  # spacing of the grid of tried positions [points]
LETTER, LINE = 0.58, 1.25  # size of a letter relative to the font size
BESIDE = 4.0  # between a name and a curve [points]
REACH = (10.0, 16.0, 24.0, 34.0, 46.0, 60.0, 80.0)  # maximum distance of a name from its curve [points]
DIRECTIONS = 16
TRIED = 60  # points of a curve
GAP = 40.0  # between two points of a curve that leaves the axes [points]
LEADER = 9.0  # minimum distance for a line to the curve [points]


def name_curves(ax: Axes, curves: Sequence[Floats], names: Sequence[str], others: Sequence[Floats] = ()) -> None:
    """Write each curve's name into the axes, without covering curves or other names.

    ax: with its limits set; curves: shape (n, 2), in the units of the axes; names: one per curve; an empty curve gets none;
    others: shape (n, 2), lines without a name, which names avoid as well.
    """
    width, height = _size(ax)
    low, high = np.array([ax.get_xlim()[0], ax.get_ylim()[0]]), np.array([ax.get_xlim()[1], ax.get_ylim()[1]])
    points = [_points(each, low, high) * [width, height] for each in curves]
    own = [_cells(each, width, height) for each in points]
    taken = np.zeros((int(height / CELL) + 1, int(width / CELL) + 1), dtype=bool)
    for mask in own:
        taken |= mask
    borders = [_cells(_points(each, low, high) * [width, height], width, height) for each in others]
    blocked = np.logical_or.reduce([taken, *borders])
    for each, mask, name in zip(points, own, names, strict=True):
        if not each.size or not name:
            continue
        box = np.array([LETTER * SMALL * _letters(name), LINE * SMALL])
        place = _place(each, box, blocked, taken & ~mask)
        if place is None:
            continue
        middle, anchor = place
        _claim(blocked, middle, box)
        leader = {"arrowstyle": "-", "lw": 0.7, "color": colors.BLACK, "shrinkA": 0, "shrinkB": 0}
        far = float(np.hypot(*(np.clip(anchor, middle - 0.5 * box, middle + 0.5 * box) - anchor))) > LEADER
        ax.annotate(
            name, low + anchor / [width, height] * (high - low), low + middle / [width, height] * (high - low),
            fontsize=SMALL, ha="center", va="center", zorder=7, arrowprops=leader if far else None,
        )  # fmt: skip


def _points(curve: Floats, low: Floats, high: Floats) -> Floats:
    """Return a curve relative to the axes, without the points outside."""
    share = (np.asarray(curve, dtype=float).reshape(-1, 2) - low) / (high - low)
    with np.errstate(invalid="ignore"):
        inside: Floats = share[((share >= 0.0) & (share <= 1.0)).all(axis=1)]
    return inside


def _size(ax: Axes) -> tuple[float, float]:
    """Return width and height of the axes after the layout of everything else [points]."""
    figure = cast("Any", ax.figure).get_figure(root=True)
    figure.draw_without_rendering()
    box = ax.get_window_extent()
    return float(box.width * 72.0 / figure.dpi), float(box.height * 72.0 / figure.dpi)


def _letters(name: str) -> int:
    return len(name.replace("$", "").replace("\\mu", "μ").replace("_0", "0"))


def _cells(points: Floats, width: float, height: float) -> Mask:
    """Return the cells of the grid that a curve touches."""
    mask = np.zeros((int(height / CELL) + 1, int(width / CELL) + 1), dtype=bool)
    if len(points) > 1:
        way = _way_along(points, GAP)
        fine = np.arange(0.0, way[-1], 0.5 * CELL)
        points = np.stack([np.interp(fine, way, points[:, k]) for k in (0, 1)], axis=-1)
    rows = np.clip((points[:, 1] / CELL).astype(int), 0, mask.shape[0] - 1)
    columns = np.clip((points[:, 0] / CELL).astype(int), 0, mask.shape[1] - 1)
    mask[rows, columns] = True
    return mask


def _way_along(points: Floats, gap: float) -> Floats:
    """Return the length of a curve up to each of its points, without gaps outside the axes."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(np.where(steps > gap, 0.0, steps))])


def _place(points: Floats, box: Floats, taken: Mask, others: Mask) -> tuple[Floats, Floats] | None:
    """Return the centre of the nearest free space for a box, and the nearest point of the curve."""
    way = _way_along(points, GAP)
    tried = points[np.searchsorted(way, np.linspace(0.0, way[-1], TRIED))]
    turns = np.arange(DIRECTIONS) * 2.0 * np.pi / DIRECTIONS
    rays = np.stack([np.cos(turns), np.sin(turns)], axis=-1)
    # points in the middle first: a name at the edge looks like an axis label
    order = np.argsort(np.abs(np.arange(TRIED) - 0.4 * TRIED), kind="stable")
    for reach in REACH:
        for k in order:
            for ray in rays:
                middle = tried[k] + ray * (reach + 0.5 * np.abs(ray) @ box)
                if _free(taken, middle, box) and _clear(others, tried[k], middle):
                    return middle, tried[k]
    return None


def _window(mask: Mask, middle: Floats, box: Floats) -> tuple[int, int, int, int]:
    low, high = (middle - 0.5 * box - BESIDE) / CELL, (middle + 0.5 * box + BESIDE) / CELL
    return int(np.floor(low[0])), int(np.ceil(high[0])), int(np.floor(low[1])), int(np.ceil(high[1]))


def _free(taken: Mask, middle: Floats, box: Floats) -> bool:
    a, b, c, d = _window(taken, middle, box)
    return a >= 0 and c >= 0 and b < taken.shape[1] and d < taken.shape[0] and not taken[c:d, a:b].any()


def _claim(taken: Mask, middle: Floats, box: Floats) -> None:
    a, b, c, d = _window(taken, middle, box)
    taken[c:d, a:b] = True


def _clear(others: Mask, start: Floats, end: Floats) -> bool:
    """Return True if a line from a curve's point to its name crosses no other curve."""
    for share in np.linspace(0.0, 1.0, 12):
        column, row = ((start + share * (end - start)) / CELL).astype(int)
        if others[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].any():
            return False
    return True
