"""The plane of a scene in 3D: a wide sheet, the track with marks across it, and distances next to it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hophoop.animate.canvas import Canvas, Points, Rectangle, TextStyle
from hophoop.animate.layout import FONT
from hophoop.animate.look import nice
from hophoop.animate.shapes3d import LANE, mix, place_3d
from hophoop.animate.themes import Theme
from hophoop.animate.words import minus
from hophoop.results.poses import to_world

FAR = 60.0  # extension of the plane, in radii
MOST_MARKS = 2000
BELOW = 9.0  # the distances are under their marks [units]


@dataclass(frozen=True)
class Part:
    """A mesh with colour and drawing options."""

    mesh: Any
    color: str
    options: dict[str, Any] = field(default_factory=dict)


def half_track(radius: float, lanes: int) -> float:
    """Half the width of the track [m], for hoops of a radius [m] next to each other."""
    return (0.5 * (lanes - 1) * LANE + 1.1) * radius


def mark_step(radius: float) -> float:
    """Distance of the marks across the track [m], for a radius [m]."""
    return nice(1.01 * radius)


def plane_meshes(
    pyvista: Any, theme: Theme, ground: str, along: tuple[float, float], radius: float, slope: float, lanes: int
) -> Iterator[Part]:
    """Yield the parts of the plane.

    ground: colour of the plane; along: minimum and maximum position of the hoops along the plane [m]; radius: radius of the
    largest hoop [m]; slope [rad]; lanes: number of hoops next to each other.
    """

    def sheet(reach: tuple[float, float], across: tuple[float, float], lift: float) -> Any:
        corners = [(reach[0], across[0]), (reach[1], across[0]), (reach[1], across[1]), (reach[0], across[1])]
        points = [place_3d(to_world(s, lift * radius, slope), y) for s, y in corners]
        return pyvista.PolyData(np.array(points), faces=[4, 0, 1, 2, 3])

    reach = along[0] - FAR * radius, along[1] + FAR * radius
    half = half_track(radius, lanes)
    yield Part(sheet(reach, (-FAR * radius, FAR * radius), -0.012), ground)
    yield Part(sheet(reach, (-half, half), -0.008), mix(ground, theme.ink, 0.05))
    step = mark_step(radius)
    first = math.floor((along[0] - 8.0 * radius) / step)
    last = math.ceil((along[1] + 8.0 * radius) / step)
    marks = np.arange(first, min(last, first + MOST_MARKS) + 1) * step
    feet = place_3d(to_world(marks, np.full(len(marks), -0.005 * radius), slope), -half)
    ends = feet + np.array([0.0, 2.0 * half, 0.0])
    cells = np.column_stack([np.full(len(marks), 2), np.arange(len(marks)), np.arange(len(marks)) + len(marks)])
    lines = pyvista.PolyData(np.vstack([feet, ends]), lines=cells.ravel())
    yield Part(lines, mix(ground, theme.ink, 0.25), {"line_width": 1.3})


def draw_distances(
    canvas: Canvas, theme: Theme, marks: Sequence[tuple[float, Points]], taken: Sequence[Rectangle], view: Rectangle
) -> None:
    """Write distances below their marks at the near edge of the track, where there is room.

    marks: position along the plane [m], and in the picture [pixels]; the most important first; taken: rectangles of other text:
    left, bottom, width, height [pixels]; view: rectangle that the distances do not leave [pixels].
    """
    u, placed = canvas.unit, list(taken)
    high, apart = 0.73 * FONT * u, 9.0 * u
    ink = mix(theme.ground, theme.ink, 0.7)
    for mark, spot in marks:
        words = minus(f"{mark:g} m")
        wide = canvas.text_width(words, FONT)
        box = float(spot[0]) - 0.5 * wide, float(spot[1]) - BELOW * u - high, wide, high
        if _inside(box, view) and not any(_meet(box, other, apart) for other in placed):
            canvas.text(box[0], box[1], words, TextStyle(ink, FONT))
            placed.append(box)


def _inside(box: Rectangle, view: Rectangle) -> bool:
    return all(view[i] <= box[i] and box[i] + box[i + 2] <= view[i] + view[i + 2] for i in (0, 1))


def _meet(one: Rectangle, other: Rectangle, apart: float) -> bool:
    """Whether two rectangles are closer than a distance."""
    return all(one[i] < other[i] + other[i + 2] + apart and other[i] < one[i] + one[i + 2] + apart for i in (0, 1))
