"""Layout of texts and keys of a film at any size: next to each other, else in rows, else dropped."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from hophoop.animate.canvas import Canvas, Rectangle
from hophoop.vocabulary.names import WORDS

MARGIN, GAP = 22.0, 26.0  # at the sides, and between texts and keys [units]
BAR_WORDS, NORMAL, FRICTION = "speed of the ring's points, m/s", "normal force", "friction"  # of the keys
KEYS, ARROW = 66.0, 124.0  # height of the keys to colours and arrows, and width of the longest arrow [units]
FOOT = 34.0  # of a line at the bottom [units]
MOST_HEAD = 0.42  # maximum height of the head over that of the picture
COLUMNS = (164.0, 296.0, 440.0)  # offsets of time, angle and one more text from the mode [units]
FONT, MODE_FONT = 20.0, 22.0  # of all texts, and of the mode: 20 pixels at 1280 × 720
MODE, TAGGED_MODE = 24.0, 34.0  # offsets of the mode from its mark, and from a letter [units]
KEY_LINE = 33.0  # of a line and the gap to its text [units]
ONE_HEAD, ROW_HEAD, ROW = 66.0, 42.0, 32.0  # heights of the texts of one motion, of a row for each, and of further rows [units]
LABEL_BASE = 28.0  # of the parameters of one motion under the upper edge [units]


@dataclass(frozen=True)
class Layout:
    """Heights of head and foot, and rectangles of their contents; left, bottom, width, height [pixels].

    Attributes
    ----------
    head, foot : float
        [pixels].
    words : Rectangle
        Rectangle of labels and states.
    bar, forces : Rectangle or None
        Rectangles of the keys to colours and to arrows; None without room.
    lines : tuple of Rectangle
        Rectangles of the keys to lines, in order, as far as there is room.
    pace : Rectangle or None
    """

    head: float
    foot: float
    words: Rectangle
    bar: Rectangle | None
    forces: Rectangle | None
    lines: tuple[Rectangle, ...]
    pace: Rectangle | None


def state_width(canvas: Canvas, extra: str) -> float:
    """Width of a line on a state: mode, time, angle and one more text [pixels]."""
    u = canvas.unit
    words = max(canvas.text_width(word.participle, MODE_FONT, "bold") for word in WORDS.values()) + TAGGED_MODE * u
    column = COLUMNS[2 if extra else 1] * u
    return float(max(words, column + canvas.text_width(extra or "θ = −1000.0°", FONT)))


def lay_out(canvas: Canvas, words: Sequence[float], height: float, forces: bool, keys: Sequence[str], pace: str) -> Layout:
    """Place texts and keys without overlap.

    words: width of each line of text in the head [pixels]; height: height of all lines of text [pixels]; forces: whether there
    is a key to arrows; keys: texts of the keys to lines; pace: the longest text on the speed of the film; empty if there is
    none.
    """
    u = canvas.unit
    wide, high = canvas.size
    left, right, top = MARGIN * u, wide - MARGIN * u, high - 8.0 * u
    broad = min(max(words, default=0.0), right - left)
    blocks = [(canvas.text_width(BAR_WORDS, FONT) + 18.0 * u, KEYS * u)]
    if forces:
        blocks.append((canvas.text_width(NORMAL, FONT) + (ARROW + 9.0) * u, KEYS * u))
    next_to = right - left - broad - GAP * u
    rows = _rows(blocks, next_to, right - left, height, MOST_HEAD * high - 8.0 * u)
    places: list[Rectangle | None] = [None, None]
    head = 8.0 * u + height
    level = top
    for row, below in rows:
        if below:
            level = min(level, top - height)
        x = right
        tall = max(blocks[k][1] for k in row)
        for k in row:
            x -= blocks[k][0]
            places[k] = (x, level - tall, *blocks[k])
            x -= GAP * u
        level -= tall
        head = max(head, high - level)
    foot, lines, said = _foot(canvas, keys, pace)
    return Layout(head, foot, (left, top - height, broad, height), places[0], places[1], lines, said)


def _rows(
    blocks: list[tuple[float, float]], next_to: float, width: float, height: float, most: float
) -> list[tuple[list[int], bool]]:
    """Return the blocks of each row, and whether there is a row below the text."""
    whole = sum(block[0] for block in blocks) + (len(blocks) - 1) * 0.1 * blocks[0][0]
    tall = max(block[1] for block in blocks)
    every = list(range(len(blocks)))
    if whole <= next_to:
        return [(every, False)]
    if len(blocks) * tall <= most and max(block[0] for block in blocks) <= next_to:
        return [([k], False) for k in every]
    if whole <= width and height + tall <= most:
        return [(every, True)]
    if max(block[0] for block in blocks) <= width and height + len(blocks) * tall <= most:
        return [([k], True) for k in every]
    # the key to arrows comes first, since their scale changes
    last = every[-1]
    if blocks[last][0] <= next_to and tall <= most:
        return [([last], False)]
    return [([last], True)] if blocks[last][0] <= width and height + tall <= most else []


def _foot(canvas: Canvas, keys: Sequence[str], pace: str) -> tuple[float, tuple[Rectangle, ...], Rectangle | None]:
    u = canvas.unit
    wide = canvas.size[0]
    left, right = 0.5 * MARGIN * u, wide - 0.5 * MARGIN * u
    said = canvas.text_width(pace, FONT, "bold") if pace else 0.0
    widths = [canvas.text_width(key, FONT) + KEY_LINE * u for key in keys]
    total = sum(widths) + max(len(widths) - 1, 0) * 14.0 * u
    two = bool(pace) and total + said + 2.0 * MARGIN * u > wide
    level = FOOT * u if two else 0.0
    x = max(right - total, left)
    placed = []
    for width in widths:
        if x + width > right + 0.5:
            break  # no room
        placed.append((x, level, width, FOOT * u))
        x += width + 14.0 * u
    foot = (2.0 if two else 1.0) * FOOT * u
    return foot, tuple(placed), ((MARGIN * u, 0.0, min(said, wide - MARGIN * u), FOOT * u) if pace else None)
