"""Texts of a film: mode, time and angle, and the keys to colours and arrows."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.canvas import Canvas, Rectangle, TextStyle
from hophoop.animate.layout import (
    ARROW,
    BAR_WORDS,
    COLUMNS,
    FONT,
    FRICTION,
    KEY_LINE,
    MODE,
    MODE_FONT,
    NORMAL,
    TAGGED_MODE,
    Layout,
)
from hophoop.animate.look import nice
from hophoop.animate.themes import Theme
from hophoop.results.poses import Floats, Poses
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import WORDS


def shades_of(speeds: Floats, top: float) -> Floats:
    """Return colours of the ring's points by speed.

    speeds [m/s]; top: speed at the upper end of the map [m/s]; shades: red, green, blue and opacity, from 0 to 1 [1].
    """
    shades: Floats = need("matplotlib", "plots").colormaps[colors.RING_SPEED_MAP](np.clip(speeds / top, 0.0, 1.0))
    return shades


def shorten(canvas: Canvas, words: str, size: float, room: float) -> str:
    """Shorten a line of parameters to a width [pixels]; the last ones are dropped first."""
    if canvas.text_width(words, size) <= room:
        return words
    parts = words.split(", ")
    while len(parts) > 1:
        parts.pop()
        if canvas.text_width(", ".join([*parts, "…"]), size) <= room:
            return ", ".join([*parts, "…"])
    return ""


class StateLine(NamedTuple):
    """Texts on the state of one motion in a picture."""

    mode: str  # word of the mode
    t: float  # [s]
    angle: float  # [rad]
    extra: str  # one more text
    end: str = ""  # word in place of the mode after the end of the motion
    tag: str = ""  # letter of the hoop in the picture


def draw_state(canvas: Canvas, theme: Theme, place: tuple[float, float], line: StateLine, room: float = math.inf) -> None:
    """Write a line on the state of a motion from a point on [pixels]; texts wider than `room` pixels are dropped."""
    u = canvas.unit
    x, y = place
    spot = np.array([x + (11.0 if line.tag else 8.0) * u, y + 8.0 * u])
    before = (TAGGED_MODE if line.tag else MODE) * u
    if line.tag:
        draw_tag(canvas, theme, spot, line.tag, colors.mode_color(line.mode))
    else:
        canvas.disc(spot, 8.0 * u, colors.mode_color(line.mode), theme.ink, 0.8)
    said = line.end or WORDS[line.mode].participle
    if before + canvas.text_width(said, MODE_FONT, "bold") <= room:
        canvas.text(x + before, y, said, TextStyle(theme.ink, MODE_FONT, weight="bold"))
    turned = f"θ = {math.degrees(line.angle):.1f}°"
    for offset, words in zip(COLUMNS, (f"t = {line.t:.3f} s", turned, line.extra), strict=True):
        shown = shorten(canvas, words, FONT, room - offset * u)
        if not shown:
            break
        canvas.text(x + offset * u, y, minus(shown), TextStyle(theme.ink, FONT))


def draw_label(canvas: Canvas, theme: Theme, place: tuple[float, float], label: str, room: float) -> None:
    """Write a motion's label, shortened to a width [pixels]."""
    canvas.text(*place, shorten(canvas, label, FONT, room), TextStyle(theme.muted, FONT))


def draw_tag(canvas: Canvas, theme: Theme, spot: Floats, tag: str, fill: str = "") -> None:
    """Draw a letter in a disc, to distinguish hoops in one view."""
    canvas.disc(spot, 13.5 * canvas.unit, fill or theme.background, theme.ink, 1.2)
    ink = theme.ink if not fill else ("#FFFFFF" if colors.lightness(fill) < 0.5 else colors.BLACK)
    canvas.text(float(spot[0]), float(spot[1]), tag, TextStyle(ink, FONT, "center", "bold", "center"))


def speed_words(poses: Poses, i: int) -> str:
    """Text of the velocity of the centre along the plane."""
    return f"v = {poses.velocity[i, 0]:.2f} m/s"


def minus(words: str) -> str:
    """Replace hyphens by minus signs."""
    return words.replace("-", "−")


def newtons(amount: float) -> str:
    """Format a force with a suitable unit, such as 50 MN in a jam."""
    for least, size, unit in ((1e6, 1e6, "MN"), (1e4, 1e3, "kN")):
        if amount >= least:
            return f"{amount / size:g} {unit}"
    return f"{amount:g} N"


def pace_words(rate: float) -> str:
    """Text of the film's speed relative to the motion; empty in real time."""
    if 0.985 < rate < 1.015:
        return ""
    return f"slow motion, 1/{1.0 / rate:.1f}" if rate < 1.0 else f"{rate:.1f} times as fast"


def longest_pace(rates: Floats) -> str:
    """The longest text of the speed in a film; empty if there is none."""
    return max((pace_words(float(rate)) for rate in (np.min(rates), np.max(rates))), key=len)


def draw_pace(canvas: Canvas, theme: Theme, layout: Layout, rate: float) -> None:
    """Write the speed of the film if it fits into the layout."""
    if layout.pace is not None:
        x, y, room, _ = layout.pace
        words = pace_words(rate)
        if canvas.text_width(words, FONT, "bold") <= room + 1.0:
            canvas.text(x, y + 10.0 * canvas.unit, words, TextStyle(theme.ink, FONT, weight="bold"))


def line_keys(traces: bool, airborne: bool) -> tuple[tuple[str, str], ...]:
    """Return colour and text of each line of a film; without flight there is no airborne line."""
    if not traces:
        return ()
    return _TRACE_KEY if airborne else _TRACE_KEY[:2]


def draw_keys(canvas: Canvas, theme: Theme, layout: Layout, top_speed: float, keys: tuple[tuple[str, str], ...]) -> None:
    """Draw the colour bar and the keys of the lines, if the layout has them.

    top_speed: speed at the right end of the colour bar [m/s]; keys: colour and text of each line.
    """
    if layout.bar is not None:
        _draw_color_bar(canvas, theme, top_speed, layout.bar)
    u = canvas.unit
    for (color, word), (x, y, _, height) in zip(keys, layout.lines, strict=False):
        level = y + 0.5 * height
        canvas.line(np.array([[x, level], [x + 26.0 * u, level]]), theme.visible(color), 3.0)
        canvas.text(x + KEY_LINE * u, level, word, TextStyle(theme.ink, FONT, vertical="center"))


def _draw_color_bar(canvas: Canvas, theme: Theme, top_speed: float, place: Rectangle) -> None:
    u = canvas.unit
    x, y, width, _ = place
    x, width, height = x + 10.0 * u, width - 28.0 * u, 12.0 * u  # numbers extend beyond its ends
    y += 28.0 * u
    columns = round(width)
    shades = shades_of(np.linspace(0.0, 1.0, columns), 1.0)
    a, b = round(x), canvas.size[1] - round(y + height)
    canvas.pixels[b : b + max(round(height), 1), a : a + columns] = np.round(255 * shades)[None].astype(np.uint8)
    frame = np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])
    canvas.polygon(frame, None, theme.ink, 0.8)
    canvas.text(x, y + height + 7.0 * u, BAR_WORDS, TextStyle(theme.ink, FONT))
    for value in np.arange(0.0, top_speed * (1.0 + 1e-9), nice(top_speed / 3.0)):
        spot = x + width * value / top_speed
        canvas.line(np.array([[spot, y], [spot, y - 4.0 * u]]), theme.ink, 0.8)
        canvas.text(spot, y - 8.0 * u, f"{value:g}", TextStyle(theme.ink, FONT, "center", vertical="top"))


def draw_force_key(canvas: Canvas, theme: Theme, layout: Layout, newton: float, most: float) -> None:
    """Draw the key to arrows at the scale of a picture: the arrow of a round force.

    newton: length of the arrow of 1 N [pixels]; most: force whose arrow has the full length [N].
    """
    if layout.forces is None:
        return
    u = canvas.unit
    left, bottom, width, _ = layout.forces
    x, y = left + width - ARROW * u, bottom + 34.0 * u
    amount = nice(min(120.0 * u / newton, most))
    kinds = ((colors.NORMAL_FORCE, NORMAL), (colors.FRICTION_FORCE, FRICTION))
    for row, (color, words) in enumerate(kinds):
        level = y - 24.0 * u * row
        canvas.text(x - 8.0 * u, level, words, TextStyle(theme.ink, FONT, "right", vertical="center"))
        tail = np.array([x, level])
        canvas.arrow(tail, tail + np.array([amount * newton, 0.0]), theme.visible(color), theme.background, 7.0)
    canvas.text(x + 0.5 * amount * newton, y + 13.0 * u, newtons(amount), TextStyle(theme.ink, FONT, "center"))


_TRACE_KEY = (
    (colors.LOAD, "load"),
    (colors.GRAVITY_CENTER, "centre of gravity"),
    (colors.GRAVITY_CENTER_AIRBORNE, "airborne"),
)
