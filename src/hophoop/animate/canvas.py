"""Fast drawing in pixels on Matplotlib's Agg renderer, over a finished background.

A full redraw of a Matplotlib figure takes about 50 ms, drawing paths with its renderer a few.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need

Bytes = NDArray[np.uint8]
Points = NDArray[np.float64]
Rectangle = tuple[float, float, float, float]
PAD = 2  # pixels around a text's mask


@lru_cache(maxsize=512)
def rgba(color: str, alpha: float = 1.0) -> tuple[float, float, float, float]:
    """Return red, green, blue and opacity of a colour, from 0 to 1."""
    red, green, blue = (int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue, alpha


class TextStyle(NamedTuple):
    """Colour, size and alignment of a text."""

    color: str
    size: float  # [units]
    anchor: str = "left"  # left, center or right
    weight: str = "normal"
    vertical: str = "baseline"  # baseline, center or top


class Canvas:
    """A picture of fixed size. Points are in pixels from the lower left corner, widths in units.

    One unit is a pixel of a picture of 1280 × 720. In larger pictures it grows with them; in smaller pictures it shrinks less
    than the picture, so that text stays legible.
    """

    def __init__(self, size: tuple[int, int], background: str) -> None:
        figure_module = need("matplotlib.figure", "plots")
        agg = need("matplotlib.backends.backend_agg", "plots")
        self._path = need("matplotlib.path", "plots").Path
        self._identity = need("matplotlib.transforms", "plots").IdentityTransform()
        self._affine = need("matplotlib.transforms", "plots").Affine2D
        self._font = need("matplotlib.font_manager", "plots").FontProperties
        self._bbox = need("matplotlib.transforms", "plots").Bbox
        self.size = size
        share = min(size[0] / 1280.0, size[1] / 720.0)
        self.unit: float = max(share, share**0.7)
        # 72 points per inch: at this resolution a point is a unit, also in Matplotlib's widths
        self.figure = figure_module.Figure(
            figsize=(size[0] / (72.0 * self.unit), size[1] / (72.0 * self.unit)),
            dpi=72.0 * self.unit,
            facecolor=background,
        )
        self._agg = agg.FigureCanvasAgg(self.figure)
        self._new_renderer = agg.RendererAgg
        self._masks: dict[tuple[str, float, str], tuple[Points, int, float]] = {}
        self._renderer: Any = None
        self._pixels: Bytes = np.zeros((0, 0, 4), dtype=np.uint8)
        self._clip: Any = None
        self.render()

    def render(self) -> None:
        """Draw the Matplotlib figure, for a background."""
        # rounding of inches must not lose a pixel
        self.figure.set_size_inches((self.size[0] + 1e-3) / self.figure.dpi, (self.size[1] + 1e-3) / self.figure.dpi)
        self._agg.draw()
        self._renderer = self._agg.get_renderer()
        self._pixels = np.asarray(self._renderer.buffer_rgba())

    @property
    def pixels(self) -> Bytes:
        """The picture, height × width × RGBA, rows from the top; a view of the canvas."""
        return self._pixels

    def restore(self, picture: Bytes) -> None:
        """Copy a picture of the same size over this one."""
        self._pixels[...] = picture

    def clip(self, rectangle: Rectangle | None) -> None:
        """Restrict drawing to left, bottom, width, height."""
        self._clip = None if rectangle is None else self._bbox.from_bounds(*rectangle)

    def _context(self, color: tuple[float, ...], width: float, cap: str = "butt") -> Any:
        context = self._renderer.new_gc()
        context.set_linewidth(width)
        context.set_foreground(color, isRGBA=True)
        context.set_capstyle(cap)
        context.set_joinstyle("round")
        if self._clip is not None:
            context.set_clip_rectangle(self._clip)
        return context

    def line(
        self,
        points: Points,
        color: str,
        width: float,
        alpha: float = 1.0,
        dashes: tuple[float, ...] | None = None,
        matrix: Points | None = None,
        cap: str = "butt",
    ) -> None:
        """Draw a polyline; `matrix` (3 × 3) maps its points to pixels."""
        if len(points) < 2:
            return
        context = self._context(rgba(color, alpha), width, cap)
        if dashes:
            context.set_dashes(0.0, dashes)
        transform = self._identity if matrix is None else self._affine(matrix)
        path = self._path(points)
        path.should_simplify = len(points) > 200 and not dashes
        self._renderer.draw_path(context, path, transform, None)
        context.restore()

    def segments(self, points: Points, colors: Points, width: float) -> None:
        """Draw a closed line with one colour per piece, n × RGBA; pieces overlap to hide seams."""
        context = self._context((0.0, 0.0, 0.0, 1.0), width)
        trios = np.stack([np.roll(points, 1, axis=0), points, np.roll(points, -1, axis=0)], axis=1)
        self._renderer.draw_path_collection(
            context,
            self._identity.frozen(),
            [self._path(trio) for trio in trios],
            np.zeros((0, 3, 3)),
            np.zeros((1, 2)),
            self._identity.frozen(),
            np.zeros((0, 4)),
            colors,
            np.array([width]),
            [(0.0, None)],
            np.array([True]),
            [None],
            "screen",
        )
        context.restore()

    def polygon(
        self,
        points: Points,
        fill: str | None,
        edge: str | None = None,
        width: float = 1.0,
        alpha: float = 1.0,
    ) -> None:
        """Draw a filled and outlined polygon."""
        context = self._context(rgba(edge, alpha) if edge else (0.0, 0.0, 0.0, 0.0), width if edge else 0.0)
        path = self._path(points, closed=False)
        path = self._path(np.vstack([path.vertices, path.vertices[:1]]), closed=True)
        self._renderer.draw_path(context, path, self._identity, rgba(fill, alpha) if fill else None)
        context.restore()

    def disc(
        self,
        center: Points,
        radius: float,
        fill: str | None,
        edge: str | None = None,
        width: float = 1.0,
        alpha: float = 1.0,
    ) -> None:
        """Draw a circle; its radius is in pixels."""
        transform = self._affine().scale(radius).translate(float(center[0]), float(center[1]))
        context = self._context(rgba(edge, alpha) if edge else (0.0, 0.0, 0.0, 0.0), width if edge else 0.0)
        self._renderer.draw_path(context, self._path.unit_circle(), transform, rgba(fill, alpha) if fill else None)
        context.restore()

    def arrow(self, tail: Points, head: Points, color: str, halo: str, width: float) -> None:
        """Draw an arrow of exact length between two points; a short one is only a head."""
        along = head - tail
        length = float(np.hypot(*along))
        if length < 2.5 * self.unit:  # too short to see
            return
        unit = along / length
        across = np.array([-unit[1], unit[0]])
        half = 0.5 * width * self.unit
        point = min(3.6 * half * 2.0, length)
        wide = min(2.6 * half, 0.75 * point)
        neck = head - point * unit
        outline = np.array(
            [
                tail + half * across,
                neck + half * across,
                neck + wide * across,
                head,
                neck - wide * across,
                neck - half * across,
                tail - half * across,
            ]
        )
        self.polygon(outline, color, halo, 0.8)

    def text(self, x: float, y: float, words: str, style: TextStyle) -> None:
        """Draw one line of text."""
        color, size, anchor, weight, vertical = style
        mask, base, advance = self._mask(words, size, weight)
        high, wide = mask.shape
        left = round(x - {"left": 0.0, "center": 0.5 * advance, "right": advance}[anchor]) - PAD
        # the height of capitals is about 0.73 of the size
        lift = {"baseline": 0.0, "center": 0.365, "top": 0.73}[vertical] * size * self.unit
        top = self.size[1] - round(y - lift) - base
        a, b = max(0, -left), min(wide, self.size[0] - left)
        c, d = max(0, -top), min(high, self.size[1] - top)
        if self._clip is not None:
            a = max(a, math.ceil(self._clip.x0) - left)
            b = min(b, math.floor(self._clip.x1) - left)
            c = max(c, self.size[1] - math.floor(self._clip.y1) - top)
            d = min(d, self.size[1] - math.ceil(self._clip.y0) - top)
        if a >= b or c >= d:
            return
        cover = mask[c:d, a:b, None]
        spot = self._pixels[top + c : top + d, left + a : left + b, :3]
        spot[...] = np.rint(spot + cover * (255.0 * np.array(rgba(color)[:3]) - spot)).astype(np.uint8)

    def text_width(self, words: str, size: float, weight: str = "normal") -> float:
        """Return the width of a text [pixels]."""
        return self._mask(words, size, weight)[2] if words else 0.0

    def _mask(self, words: str, size: float, weight: str) -> tuple[Points, int, float]:
        """Return the coverage of a text from 0 to 1, the row of its baseline, and its advance width."""
        key = (words, size, weight)
        found = self._masks.get(key)
        if found is not None:
            return found
        if len(words) > 1 and any(letter.isdigit() for letter in words):
            # Numbers change from picture to picture: compose them from cached characters.
            parts = [self._mask(letter, size, weight) for letter in words]
            starts = np.concatenate([[0.0], np.cumsum([advance for _, _, advance in parts])])
            mask = np.zeros((parts[0][0].shape[0], math.ceil(starts[-1]) + 4 * PAD))
            for (part, _, _), start in zip(parts, starts, strict=False):
                place = mask[:, round(start) : round(start) + part.shape[1]]
                np.maximum(place, part[:, : place.shape[1]], out=place)
            return mask, parts[0][1], float(starts[-1])
        font = self._font(family="DejaVu Sans", size=size, weight=weight)
        advance = self._renderer.get_text_width_height_descent(words, font, False)[0]
        if len(words) == 1:  # Agg measures ink only, so a space needs neighbours
            pair = self._renderer.get_text_width_height_descent(f"0{words}0", font, False)[0]
            advance = pair - self._renderer.get_text_width_height_descent("00", font, False)[0]
        base = math.ceil(1.1 * size * self.unit) + PAD
        high, wide = base + math.ceil(0.4 * size * self.unit), math.ceil(advance) + 4 * PAD
        renderer = self._new_renderer(wide, high, self.figure.dpi)
        context = renderer.new_gc()
        context.set_foreground((0.0, 0.0, 0.0, 1.0), isRGBA=True)
        renderer.draw_text(context, PAD, base, words, font, 0.0)
        mask = np.asarray(renderer.buffer_rgba())[..., 3] / 255.0
        self._masks[key] = mask, base, advance
        return self._masks[key]
