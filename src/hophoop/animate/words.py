"""What a film says: mode, time and angle in words, and the keys to colours and arrows."""

from __future__ import annotations

import math

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.canvas import Canvas, Rectangle
from hophoop.animate.layout import COLUMNS, KEY_FONT, LABEL_FONT, PACE_FONT, STATE_FONT, Layout
from hophoop.animate.look import nice
from hophoop.animate.themes import Theme
from hophoop.results.poses import Floats, Poses
from hophoop.vocabulary import colors
from hophoop.vocabulary.modes import PARTICIPLES


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


def fitted(canvas: Canvas, words: str, size: float, room: float) -> str:
    """A line of parameters as far as there is room [pixels]: its last ones are left out first."""
    if canvas.text_width(words, size) <= room:
        return words
    parts = words.split(", ")
    while len(parts) > 1:
        parts.pop()
        if canvas.text_width(", ".join([*parts, "…"]), size) <= room:
            return ", ".join([*parts, "…"])
    return ""


def draw_state(
    canvas: Canvas,
    theme: Theme,
    place: tuple[float, float],
    poses: Poses,
    i: int,
    ended: str,
    extra: str,
    room: float = math.inf,
    tag: str = "",
) -> None:
    """The mode in words, time and angle, and one thing more, in a line from a place on [pixels].

    A motion that has ended says so in a word of its own. What would reach beyond `room` pixels is left out. A tag is the
    letter that the hoop has in the picture.
    """
    u = canvas.unit
    x, y = place
    word = str(poses.words[i])
    spot = np.array([x + 7.0 * u, y + 6.0 * u])
    if tag:
        draw_tag(canvas, theme, spot, tag, colors.mode_color(word))
    else:
        canvas.disc(spot, 7.0 * u, colors.mode_color(word), theme.ink, 0.8)
    said = ended or PARTICIPLES[word]
    if 22.0 * u + canvas.text_width(said, 18.0, "bold") <= room:
        canvas.text(x + 22.0 * u, y, said, theme.ink, 18.0, weight="bold")
    turned = f"θ = {math.degrees(poses.angle[i]):.1f}°"
    for offset, words in zip(COLUMNS, (f"t = {poses.t[i]:.3f} s", turned, extra), strict=True):
        shown = fitted(canvas, words, STATE_FONT, room - offset * u)
        if not shown:
            break
        canvas.text(x + offset * u, y, minus(shown), theme.ink, STATE_FONT)


def draw_label(canvas: Canvas, theme: Theme, place: tuple[float, float], label: str, room: float) -> None:
    """A motion's label, as far as there is room [pixels]."""
    canvas.text(*place, fitted(canvas, label, LABEL_FONT, room), theme.muted, LABEL_FONT)


def draw_tag(canvas: Canvas, theme: Theme, spot: Floats, tag: str, fill: str = "") -> None:
    """A letter in a disc, by which hoops in one view are told apart."""
    canvas.disc(spot, 9.5 * canvas.unit, fill or theme.background, theme.ink, 1.2)
    ink = theme.ink if not fill else ("#FFFFFF" if colors.lightness(fill) < 0.5 else colors.BLACK)
    canvas.text(float(spot[0]), float(spot[1]), tag, ink, 12.0, "center", "bold", "center")


def speed_words(poses: Poses, i: int) -> str:
    """Velocity of the centre along the plane, in words."""
    return f"v = {poses.velocity[i, 0]:.2f} m/s"


def minus(words: str) -> str:
    """A text with the minus sign instead of the hyphen."""
    return words.replace("-", "−")


def newtons(amount: float) -> str:
    """A force in the unit in which it is short, such as 50 MN in a jam."""
    for least, size, unit in ((1e6, 1e6, "MN"), (1e4, 1e3, "kN")):
        if amount >= least:
            return f"{amount / size:g} {unit}"
    return f"{amount:g} N"


def pace_words(rate: float) -> str:
    """How much slower or faster the film is than the motion; nothing in real time."""
    if 0.985 < rate < 1.015:
        return ""
    return f"slow motion, 1/{1.0 / rate:.1f}" if rate < 1.0 else f"{rate:.1f} times as fast"


def longest_pace(rates: Floats) -> str:
    """The longest text about the pace in a film; empty where there is none."""
    return max((pace_words(float(rate)) for rate in (np.min(rates), np.max(rates))), key=len)


def draw_pace(canvas: Canvas, theme: Theme, layout: Layout, rate: float) -> None:
    """Say how much slower or faster the film is, where the layout has room."""
    if layout.pace is not None:
        x, y, room, _ = layout.pace
        words = pace_words(rate)
        if canvas.text_width(words, PACE_FONT, "bold") <= room + 1.0:
            canvas.text(x, y + 10.0 * canvas.unit, words, theme.ink, PACE_FONT, weight="bold")


def line_keys(traces: bool, airborne: bool) -> tuple[tuple[str, str], ...]:
    """Colour and words of each line that a film has: what never flies has no line in the air."""
    if not traces:
        return ()
    return _TRACE_KEY if airborne else _TRACE_KEY[:2]


def draw_keys(canvas: Canvas, theme: Theme, layout: Layout, top_speed: float, keys: tuple[tuple[str, str], ...]) -> None:
    """Colour bar and keys of the lines, where the layout has them.

    Parameters
    ----------
    canvas : Canvas
    theme : Theme
    layout : Layout
    top_speed : float
        At the right end of the colour bar [m/s].
    keys : tuple of (str, str)
        Colour and words of each line.
    """
    if layout.bar is not None:
        _draw_color_bar(canvas, theme, top_speed, layout.bar)
    u = canvas.unit
    for (color, word), (x, y, _, height) in zip(keys, layout.lines, strict=False):
        level = y + 0.5 * height
        canvas.line(np.array([[x, level], [x + 26.0 * u, level]]), theme.shown(color), 3.0)
        canvas.text(x + 33.0 * u, level, word, theme.ink, KEY_FONT, vertical="center")


def _draw_color_bar(canvas: Canvas, theme: Theme, top_speed: float, place: Rectangle) -> None:
    u = canvas.unit
    x, y, width, _ = place
    x, width, height = x + 4.0 * u, width - 12.0 * u, 12.0 * u  # numbers at its ends reach beyond it
    y += 22.0 * u
    columns = round(width)
    shades = shades_of(np.linspace(0.0, 1.0, columns), 1.0)
    a, b = round(x), canvas.size[1] - round(y + height)
    canvas.pixels[b : b + max(round(height), 1), a : a + columns] = np.round(255 * shades)[None].astype(np.uint8)
    frame = np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])
    canvas.polygon(frame, None, theme.ink, 0.8)
    canvas.text(x, y + height + 7.0 * u, "speed of the ring's points, m/s", theme.ink, KEY_FONT)
    for value in np.arange(0.0, top_speed * (1.0 + 1e-9), nice(top_speed / 3.0)):
        spot = x + width * value / top_speed
        canvas.line(np.array([[spot, y], [spot, y - 4.0 * u]]), theme.ink, 0.8)
        canvas.text(spot, y - 8.0 * u, f"{value:g}", theme.ink, 12.0, "center", vertical="top")


def draw_force_key(canvas: Canvas, theme: Theme, layout: Layout, newton: float, most: float) -> None:
    """The arrows' key at the scale of a picture: a round force, as long as its arrow would be.

    Parameters
    ----------
    canvas : Canvas
    theme : Theme
    layout : Layout
    newton : float
        Length of a newton's arrow [pixels].
    most : float
        Force whose arrow has the full length [N].
    """
    if layout.forces is None:
        return
    u = canvas.unit
    left, bottom, width, _ = layout.forces
    x, y = left + width - 124.0 * u, bottom + 28.0 * u
    amount = nice(min(120.0 * u / newton, most))
    kinds = ((colors.NORMAL_FORCE, "normal force"), (colors.FRICTION_FORCE, "friction"))
    for row, (color, words) in enumerate(kinds):
        level = y - 20.0 * u * row
        canvas.text(x - 8.0 * u, level, words, theme.ink, KEY_FONT, "right", vertical="center")
        tail = np.array([x, level])
        canvas.arrow(tail, tail + np.array([amount * newton, 0.0]), theme.shown(color), theme.background, 7.0)
    canvas.text(x + 0.5 * amount * newton, y + 13.0 * u, newtons(amount), theme.ink, 12.0, "center")


_TRACE_KEY = (
    (colors.LOAD, "load"),
    (colors.GRAVITY_CENTER, "centre of gravity"),
    (colors.GRAVITY_CENTER_AIRBORNE, "airborne"),
)
