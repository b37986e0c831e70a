"""The surface of a film's pictures: Matplotlib's artists and Pillow's text on one array of pixels."""

from __future__ import annotations

import re
from functools import cache, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.results.poses import Floats
from hophoop.vocabulary import colors

Bytes = NDArray[np.uint8]
Points = NDArray[np.float64]
Rectangle = tuple[float, float, float, float]
FONT, MODE_FONT = 20.0, 22.0  # of all texts, and of the mode: 20 pixels at 1280 × 720


class Sheet:
    """A picture of fixed size. Points are in pixels from the lower left corner, widths in units.

    One unit is a pixel of a picture of 1280 × 720. In larger pictures it grows with them; in smaller pictures it shrinks less
    than the picture, so that text stays legible.
    """

    def __init__(self, size: tuple[int, int], background: str) -> None:
        self.size = size
        share = min(size[0] / 1280.0, size[1] / 720.0)
        self.unit: float = max(share, share**0.7)
        dpi = 72.0 * self.unit  # a point, Matplotlib's unit of widths, is a unit
        inches = (size[0] + 1e-3) / dpi, (size[1] + 1e-3) / dpi  # rounding must not lose a pixel
        self.figure: Any = need("matplotlib.figure", "plots").Figure(inches, dpi, facecolor=background)
        self.canvas = need("matplotlib.backends.backend_agg", "plots").FigureCanvasAgg(self.figure)
        self.renderer = self.canvas.get_renderer()
        self.pixels: Bytes = np.asarray(self.renderer.buffer_rgba())
        self.image = need("PIL.Image", "plots").frombuffer("RGBA", size, self.pixels, "raw", "RGBA", 0, 1)
        self.image.readonly = 0  # draw on the renderer's pixels
        self._pen = need("PIL.ImageDraw", "plots").Draw(self.image)
        line = need("matplotlib.lines", "plots").Line2D
        # making a line takes as long as drawing it
        self._styled = lru_cache(200)(lambda look: line([], [], transform=None, figure=self.figure, **dict(look)))

    def axes(self, rectangle: Rectangle, **look: Any) -> Any:
        """Add axes in a rectangle: left, bottom, width, height [pixels]."""
        return self.figure.add_axes(tuple(np.divide(rectangle, (*self.size, *self.size))), **look)

    def render(self) -> Bytes:
        """Draw the figure without what is animated, and return a copy of the picture."""
        self.canvas.draw()
        return self.pixels.copy()

    def draw(self, *artists: Any) -> None:
        """Draw artists over the picture."""
        for artist in artists:
            artist.draw(self.renderer)

    def line(self, points: Points, clip: Any = None, **look: Any) -> None:
        """Draw a line, or its markers, through points [pixels]; clip: a box of Matplotlib."""
        line = self._styled(tuple(look.items()))
        line.set_clip_box(clip)
        line.set_data(np.transpose(points))
        line.draw(self.renderer)

    def dot(self, spot: Points, size: float, fill: str, edge: str) -> None:
        """Draw a disc; size: diameter [units]."""
        self.line(np.array([spot]), marker="o", ms=size, mfc=fill, mec=edge, mew=1.0)

    def text(self, x: float, y: float, words: str, color: str, anchor: str = "ls", bold: bool = False) -> None:
        """Write a line of text; anchor: Pillow's, 'ls' is the left end of the baseline, 'mm' the middle."""
        self._pen.text((x, self.size[1] - y), minus(words), color, _font(self.unit, bold), anchor)

    def text_width(self, words: str, bold: bool = False) -> float:
        """Return the width of a text [pixels]."""
        return _width(self.unit, bold, words)

    def shortened(self, words: str, room: float) -> str:
        """Shorten a line of parameters to a width [pixels]; the last ones are dropped first."""
        parts = words.split(", ")
        while parts and self.text_width(words) > room:
            parts.pop()
            words = ", ".join([*parts, "…"]) if parts else ""
        return words


@cache
def _font(unit: float, bold: bool) -> Any:
    manager = need("matplotlib.font_manager", "plots")
    path = manager.findfont(manager.FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal"))
    return need("PIL.ImageFont", "plots").truetype(path, (MODE_FONT if bold else FONT) * unit)


@lru_cache(10_000)
def _width(unit: float, bold: bool, words: str) -> float:
    return float(_font(unit, bold).getlength(minus(words)))


def minus(words: str) -> str:
    """Replace the hyphens of negative numbers by minus signs."""
    return re.sub(r"-(?=\d)", "−", words)


def shades_of(speeds: Floats, top: float) -> Floats:
    """Return colours of the ring's points by speed.

    speeds [m/s]; top: speed at the upper end of the map [m/s]; shades: red, green, blue and opacity, from 0 to 1 [1].
    """
    shades: Floats = need("matplotlib", "plots").colormaps[colors.RING_SPEED_MAP](np.clip(speeds / top, 0.0, 1.0))
    return shades
