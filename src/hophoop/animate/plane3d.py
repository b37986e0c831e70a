"""The plane of a scene in 3D: a wide sheet, the track with marks across it, and distances next to it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hophoop.animate.look import nice
from hophoop.animate.shapes3d import LANE, mix, place_3d
from hophoop.animate.themes import Theme
from hophoop.results.poses import to_world

FAR = 60.0  # extension of the plane, in radii
MOST_MARKS, MOST_NUMBERS = 2000, 400


@dataclass(frozen=True)
class Part:
    """A mesh with colour and drawing options."""

    mesh: Any
    color: str
    options: dict[str, Any] = field(default_factory=dict)


def plane_meshes(
    pyvista: Any, theme: Theme, ground: str, along: tuple[float, float], radius: float, slope: float, lanes: int
) -> Iterator[Part]:
    """Yield the parts of the plane.

    Parameters
    ----------
    pyvista : module
    theme : Theme
    ground : str
        Colour of the plane.
    along : tuple of float
        Minimum and maximum position of the hoops along the plane [m].
    radius : float
        Radius of the largest hoop [m].
    slope : float
        [rad].
    lanes : int
        Number of hoops next to each other.

    Yields
    ------
    part : Part
    """

    def sheet(reach: tuple[float, float], across: tuple[float, float], lift: float) -> Any:
        corners = [(reach[0], across[0]), (reach[1], across[0]), (reach[1], across[1]), (reach[0], across[1])]
        points = [place_3d(to_world(s, lift * radius, slope), y) for s, y in corners]
        return pyvista.PolyData(np.array(points), faces=[4, 0, 1, 2, 3])

    reach = along[0] - FAR * radius, along[1] + FAR * radius
    half = (0.5 * (lanes - 1) * LANE + 1.1) * radius
    yield Part(sheet(reach, (-FAR * radius, FAR * radius), -0.012), ground)
    yield Part(sheet(reach, (-half, half), -0.008), mix(ground, theme.ink, 0.05))
    step = nice(1.01 * radius)
    first = math.floor((along[0] - 8.0 * radius) / step)
    last = math.ceil((along[1] + 8.0 * radius) / step)
    marks = np.arange(first, min(last, first + MOST_MARKS) + 1) * step
    feet = place_3d(to_world(marks, np.full(len(marks), -0.005 * radius), slope), -half)
    ends = feet + np.array([0.0, 2.0 * half, 0.0])
    cells = np.column_stack([np.full(len(marks), 2), np.arange(len(marks)), np.arange(len(marks)) + len(marks)])
    lines = pyvista.PolyData(np.vstack([feet, ends]), lines=cells.ravel())
    yield Part(lines, mix(ground, theme.ink, 0.25), {"line_width": 1.3})
    for mark in marks[np.abs(np.round(marks / step)) % 2 == 0][:MOST_NUMBERS]:
        yield Part(_number(pyvista, mark, half, radius, slope), mix(theme.ground, theme.ink, 0.55))


def _number(pyvista: Any, mark: float, half: float, radius: float, slope: float) -> Any:
    """Return a distance as text on the plane in front of the track."""
    size = 0.24 * radius
    text = pyvista.Text3D(f"{mark:g} m", depth=0.0)
    # Text3D chooses its height: take it from the bounds
    bounds = text.bounds
    scale = size / max(bounds[3] - bounds[2], 1e-9)
    flat = (text.points - [0.5 * (bounds[0] + bounds[1]), bounds[2], 0.0]) * scale
    along = flat[:, 0] + mark
    points = to_world(along, np.full(len(along), -0.004 * radius), slope)
    text.points = np.column_stack([points[:, 0], flat[:, 1] - half - 1.5 * size, points[:, 1]])
    return text
