"""Draw the parts of a hoop made of parts in a film in 2D."""

from __future__ import annotations

import math

import numpy as np

from hophoop.animate.canvas import Canvas, Points
from hophoop.animate.themes import Theme
from hophoop.results.poses import part_side
from hophoop.scenario import Disk, Hoop, PointMass, Ring, Rod

LOAD = 0.085  # of a point mass, in radii of the hoop


def draw_parts(canvas: Canvas, theme: Theme, hoop: Hoop, center: Points, tilt: float, scale: float, alpha: float) -> None:
    """Draw rings, then disks, points and rods.

    hoop: a hoop made of parts; center: centre of the rim [pixels]; tilt: angle from upright to the line from the centre to the
    centre of gravity, clockwise [rad]; scale: scale of the picture [pixels/m]; alpha: opacity [1].
    """
    side = part_side(hoop)
    along = np.array([math.sin(tilt), math.cos(tilt)])
    across = np.array([along[1], -along[0]])
    for part in sorted(hoop.parts or (), key=lambda part: not isinstance(part, Ring)):
        ink = theme.load if part.mass > 0.0 else theme.background  # a hole
        edge = theme.background if part.mass > 0.0 else theme.load
        middle = center + side * part.at * scale * along
        if isinstance(part, Ring):
            mean = 0.5 * (part.inner_radius + part.outer_radius) * scale
            thick = max((part.outer_radius - part.inner_radius) * scale / canvas.unit, 1.0)
            canvas.disc(center, mean, None, theme.muted, thick, 0.35 * alpha)
        elif isinstance(part, Disk):
            canvas.disc(middle, part.radius * scale, ink, edge, 1.2, 0.8 * alpha)
        elif isinstance(part, PointMass):
            canvas.disc(middle, LOAD * hoop.radius * scale, ink, edge, 1.5, alpha)
        elif isinstance(part, Rod):
            half = 0.5 * part.length * scale * (along if part.direction == "radial" else across)
            canvas.line(np.array([middle - half, middle + half]), ink, 4.0, 0.8 * alpha)
