"""What a film says: mode, time and angle in words, and the keys to colours and arrows."""

from __future__ import annotations

import math

import numpy as np

from hophoop._extras import need
from hophoop.animate.canvas import Canvas
from hophoop.animate.look import nice
from hophoop.animate.themes import Theme
from hophoop.poses import Floats, Poses
from hophoop.vocabulary import colors
from hophoop.vocabulary.words import PARTICIPLES


def shades_of(speeds: Floats, top: float) -> Floats:
    """Colours of the ring's points by their speed.

    Parameters
    ----------
    speeds : ndarray
        [m/s].
    top : float
        Speed at the upper end of the map [m/s].

    Returns
    -------
    shades : ndarray, one axis more than speeds
        Red, green, blue and opacity, from 0 to 1 [1].
    """
    shades: Floats = need("matplotlib", "plots").colormaps[colors.RING_SPEED_MAP](np.clip(speeds / top, 0.0, 1.0))
    return shades


def draw_state(
    canvas: Canvas,
    theme: Theme,
    place: tuple[float, float],
    poses: Poses,
    i: int,
    ended: bool,
    extra: str,
    room: float = math.inf,
) -> None:
    """The mode in words, time and angle, and one thing more, in a line from a place on [pixels].

    What would reach beyond `room` units of the canvas is left out: many views in one picture are narrow.
    """
    u = canvas.unit
    x, y = place
    word = str(poses.words[i])
    canvas.disc(np.array([x + 7.0 * u, y + 6.0 * u]), 7.0 * u, colors.mode_color(word), theme.ink, 0.8)
    canvas.text(x + 22.0 * u, y, "ended" if ended else PARTICIPLES[word], theme.ink, 18.0, weight="bold")
    turned = f"θ = {math.degrees(poses.angle[i]):.1f}°"
    for offset, words in ((140.0, f"t = {poses.t[i]:.3f} s"), (268.0, turned), (396.0, extra)):
        if offset + 8.0 * len(words) <= room:
            canvas.text(x + offset * u, y, minus(words), theme.ink, 15.0)


def speed_words(poses: Poses, i: int) -> str:
    """Velocity of the centre along the plane, in words."""
    return f"v = {poses.velocity[i, 0]:.2f} m/s"


def minus(words: str) -> str:
    """A text with the minus sign instead of the hyphen."""
    return words.replace("-", "−")


def draw_pace(canvas: Canvas, theme: Theme, x: float, rate: float) -> None:
    """Says that the film is slower or faster than the motion; nothing in real time."""
    if 0.985 < rate < 1.015:
        return
    words = f"slow motion, 1/{1.0 / rate:.1f}" if rate < 1.0 else f"{rate:.1f} times as fast"
    canvas.text(x, 10.0 * canvas.unit, words, theme.ink, 14.0, weight="bold")


def draw_keys(
    canvas: Canvas,
    theme: Theme,
    top_speed: float,
    newton: float | None,
    force: float,
    traces: bool,
    forces: bool = False,
) -> None:
    """Colour bar, and keys of the arrows and of the traces.

    Parameters
    ----------
    canvas : Canvas
    theme : Theme
    top_speed : float
        At the right end of the colour bar [m/s].
    newton : float or None
        Length of a newton's arrow; None draws no scale [pixels].
    force : float
        The greatest force that occurs [N].
    traces, forces : bool
        Whether the traces, and arrows without a scale, need a key.
    """
    u = canvas.unit
    width, height = canvas.size
    right = width - 24.0 * u
    top = height - (20.0 if wide(canvas) else 84.0) * u
    _draw_color_bar(canvas, theme, top_speed, (right - 270.0 * u, top - 26.0 * u, 270.0 * u, 12.0 * u))
    if newton is not None:
        _draw_force_key(canvas, theme, (right - 440.0 * u, top - 20.0 * u), newton, force)
    _draw_line_key(canvas, theme, (_TRACE_KEY if traces else ()) + (_FORCE_KEY if forces else ()))


def wide(canvas: Canvas) -> bool:
    """Whether the keys find room beside the words."""
    return bool(canvas.size[0] / canvas.unit >= 1050.0)


def _draw_color_bar(canvas: Canvas, theme: Theme, top_speed: float, place: tuple[float, float, float, float]) -> None:
    u = canvas.unit
    x, y, width, height = place
    columns = round(width)
    shades = shades_of(np.linspace(0.0, 1.0, columns), 1.0)
    a, b = round(x), canvas.size[1] - round(y + height)
    canvas.pixels[b : b + round(height), a : a + columns] = np.round(255 * shades)[None].astype(np.uint8)
    frame = np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])
    canvas.polygon(frame, None, theme.ink, 0.8)
    canvas.text(x, y + height + 7.0 * u, "speed of the ring's points, m/s", theme.ink, 13.0)
    for value in np.arange(0.0, top_speed * (1.0 + 1e-9), nice(top_speed / 3.0)):
        spot = x + width * value / top_speed
        canvas.line(np.array([[spot, y], [spot, y - 4.0 * u]]), theme.ink, 0.8)
        canvas.text(spot, y - 8.0 * u, f"{value:g}", theme.ink, 12.0, "center", vertical="top")


def _draw_force_key(canvas: Canvas, theme: Theme, place: tuple[float, float], newton: float, force: float) -> None:
    u = canvas.unit
    x, y = place
    amount = nice(min(120.0 * u / newton, force))
    kinds = ((colors.NORMAL_FORCE, "normal force"), (colors.FRICTION_FORCE, "friction"))
    for row, (color, words) in enumerate(kinds):
        level = y - 20.0 * u * row
        canvas.text(x - 8.0 * u, level, words, theme.ink, 13.0, "right", vertical="center")
        tail = np.array([x, level])
        canvas.arrow(tail, tail + np.array([amount * newton, 0.0]), theme.shown(color), theme.background, 7.0)
    canvas.text(x + 0.5 * amount * newton, y + 13.0 * u, f"{amount:g} N", theme.ink, 12.0, "center")


_TRACE_KEY = (
    (colors.LOAD, "load", 86.0),
    (colors.GRAVITY_CENTER, "centre of gravity", 172.0),
    (colors.GRAVITY_CENTER_AIRBORNE, "airborne", 116.0),
)
_FORCE_KEY = ((colors.NORMAL_FORCE, "normal force", 142.0), (colors.FRICTION_FORCE, "friction", 106.0))


def _draw_line_key(canvas: Canvas, theme: Theme, words: tuple[tuple[str, str, float], ...]) -> None:
    u = canvas.unit
    x = canvas.size[0] - 10.0 * u - sum(room for _, _, room in words) * u
    for color, word, room in words:
        canvas.line(np.array([[x, 15.0 * u], [x + 26.0 * u, 15.0 * u]]), theme.shown(color), 3.0)
        canvas.text(x + 33.0 * u, 15.0 * u, word, theme.ink, 13.0, vertical="center")
        x += room * u
