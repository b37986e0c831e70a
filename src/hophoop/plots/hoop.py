"""The one drawing of a hoop by Matplotlib, for figures and films in 2D: its ring, and its load or its parts."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Final

import numpy as np

from hophoop._support.extras import need
from hophoop.plots.style import Axes
from hophoop.results.poses import Floats, load_distance, part_side
from hophoop.scenario import Hoop, Ring, Rod
from hophoop.vocabulary import colors

AROUND: Final = np.linspace(0.0, 2.0 * math.pi, 96, endpoint=False)  # of points of a ring, from the outward normal
LOAD: Final = 0.085  # radius of a load without size, in radii


class HoopArtist:
    """A hoop in axes, moved by `pose` and coloured by `paint`; `artists` are its parts from back to front.

    ring, load: width of the ring and diameter of the load [points]; line, ink, edge: colours of the line to the load, of the
    load, and of its edge; pieces: whether each piece of the ring has its colour; metre: length of 1 m, to draw all of a hoop to
    scale, also its parts [points].
    """

    def __init__(
        self,
        axes: Axes,
        hoop: Hoop,
        slope: float,
        *,
        ring: float,
        load: float,
        line: str,
        ink: str = colors.LOAD,
        edge: str = "none",
        alpha: float = 1.0,
        pieces: bool = False,
        metre: float = 0.0,
        zorder: float = 2.0,
    ) -> None:
        self.hoop, self.slope, self.alpha = hoop, slope, alpha
        lines, transforms = need("matplotlib.lines", "plots"), need("matplotlib.transforms", "plots")
        self.turned, self.moved = transforms.Affine2D(), transforms.Affine2D()
        self.middle = hoop.radius - (0.5 * ring / metre if metre else 0.0)  # radius of the ring's middle [m]
        rim = self.middle * np.stack([np.sin(AROUND + slope), np.cos(AROUND + slope)], axis=-1)
        # three points per piece: neighbours overlap, which hides seams
        parts = np.stack([np.roll(rim, 1, axis=0), rim, np.roll(rim, -1, axis=0)], axis=1) if pieces else [[*rim, *rim[:2]]]
        self.ring = need("matplotlib.collections", "plots").LineCollection(parts, linewidths=ring, capstyle="butt")
        self.artists = [self.ring]
        if metre and hoop.parts is not None:
            self.artists[:0] = self._parts(line, ink, edge, metre)
        else:
            at = load_distance(hoop)
            disc = {"marker": "o", "ms": load, "mec": edge, "mew": 0.0 if edge == "none" else 1.5}
            spoke = lines.Line2D([0.0, 0.0], [0.0, at], color=line, lw=1.2 if metre else 0.8, alpha=0.7 * alpha)
            self.artists = [spoke, self.ring, lines.Line2D([0.0], [at], color=ink, alpha=alpha, zorder=zorder + 5.0, **disc)]
        for artist in self.artists:
            way = self.moved if artist is self.ring else self.turned
            artist.set(transform=way + axes.transData, zorder=max(artist.zorder, zorder))
            axes.add_artist(artist)

    def _parts(self, line: str, ink: str, edge: str, metre: float) -> Iterator[Any]:
        """Yield the parts of the hoop, with the centre of the rim at the origin and that of gravity above."""
        patches = need("matplotlib.patches", "plots")
        for part in sorted(self.hoop.parts or (), key=lambda part: not isinstance(part, Ring)):
            middle = part_side(self.hoop) * part.at
            face, border = (ink, edge) if part.mass > 0.0 else (edge, ink)  # or a hole
            look = {"fc": face, "ec": border, "lw": 1.3, "alpha": 0.8 * self.alpha}
            if isinstance(part, Ring):
                thick = max((part.outer_radius - part.inner_radius) * metre, 1.0)
                mean = 0.5 * (part.inner_radius + part.outer_radius)
                yield patches.Circle((0.0, 0.0), mean, fill=False, ec=line, lw=thick, alpha=0.35 * self.alpha)
            elif isinstance(part, Rod):
                thick = 4.0 / metre
                wide, high = (thick, part.length) if part.direction == "radial" else (part.length, thick)
                yield patches.Rectangle((-0.5 * wide, middle - 0.5 * high), wide, high, **look | {"lw": 0.0})
            else:
                size = getattr(part, "radius", LOAD * self.hoop.radius)  # of a disk; or a point mass
                yield patches.Circle((0.0, middle), size, **look)

    def pose(self, center: Floats | tuple[float, float], angle: float, scale: float = 1.0) -> None:
        """Move the hoop: its centre in the coordinates of the axes, θ [rad], and the length of 1 m there."""
        self.turned.clear().scale(scale).rotate(-angle - self.slope).translate(*center)
        self.moved.clear().scale(scale).translate(*center)

    def paint(self, paint: Any, paper: str = "white") -> None:
        """Colour the ring, or its pieces, over paper: where pieces overlap, opacity would add up."""
        inks, back = (need("matplotlib.colors", "plots").to_rgba_array(color)[:, :3] for color in (paint, paper))
        self.ring.set_color(self.alpha * inks + (1.0 - self.alpha) * back)
