"""Words and keys of a film: mode, time and angle of each motion above the views, keys to lines and marks below."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.frames import Clock, EventMark, Trace, end_word
from hophoop.animate.look import nice
from hophoop.animate.sheet import Rectangle, Sheet, shades_of
from hophoop.animate.themes import Theme
from hophoop.results.poses import Poses
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import EVENTS, MARKS, WORDS

MARGIN, GAP = 22.0, 26.0  # at the sides, and between texts and keys [units]
BAR_WORDS, NORMAL, FRICTION = "speed of the ring's points, m/s", "normal force", "friction"
KEYS, ARROW = 66.0, 124.0  # height of the keys to colours and arrows, and width of the longest arrow [units]
FOOT, KEY_LINE = 34.0, 33.0  # height of a line at the bottom; width of a key and the gap to its text [units]
MOST_HEAD = 0.42  # maximum height of the head over that of the picture
MODE, TIME, ANGLE, EXTRA = 34.0, 164.0, 296.0, 440.0  # offsets of the texts of a state [units]
ROW = 32.0  # of texts [units]

Key = tuple[str, str, str]  # colour, text, and marker or nothing for a line


@dataclass(frozen=True)
class Layout:
    """Heights of head and foot [pixels], and rectangles of their contents: left, bottom, width, height [pixels].

    `words`: labels and states; `bar` and `forces`: keys to colours and to arrows, None without room; `lines`: keys to lines and
    marks, as far as there is room; `pace`: speed of the film.
    """

    head: float
    foot: float
    words: Rectangle
    bar: Rectangle | None
    forces: Rectangle | None
    lines: tuple[Rectangle, ...]
    pace: Rectangle | None


def keys_of(theme: Theme, traces: Sequence[Trace], found: Sequence[EventMark]) -> tuple[Key, ...]:
    """Return the keys to lines and to marks; without flight there is no airborne line."""
    lines = [(theme.load, "load", ""), (theme.visible(colors.GRAVITY_CENTER), "centre of gravity", "")]
    if any(airborne for track in traces for _, _, airborne in track.runs):
        lines.append((theme.visible(colors.GRAVITY_CENTER_AIRBORNE), "airborne", ""))
    kinds = {EVENTS[one.kind].noun: MARKS[one.kind] for one in found}
    return (*(lines if traces else ()), *((theme.ink, noun, mark) for noun, mark in kinds.items()))


def pace_words(rate: float) -> str:
    """Text of the film's speed relative to the motion; empty in real time."""
    if 0.985 < rate < 1.015:
        return ""
    return f"slow motion, 1/{1.0 / rate:.2g}" if rate < 1.0 else f"{rate:.3g} times as fast"


def newtons(amount: float) -> str:
    """Format a force with a suitable unit, such as 50 MN in a jam."""
    for least, size, unit in ((1e6, 1e6, "MN"), (1e4, 1e3, "kN")):
        if amount >= least:
            return f"{amount / size:g} {unit}"
    return f"{amount:g} N"


class Head:
    """Texts and keys of a film, and their layout."""

    def __init__(
        self, sheet: Sheet, theme: Theme, clock: Clock, keys: Sequence[Key], labels: Sequence[str], tagged: bool
    ) -> None:
        self.sheet, self.theme, self.keys, self.clock = sheet, theme, keys, clock
        u = sheet.unit
        rows = 0 if not labels else 2 if len(labels) == 1 and not tagged else len(labels)
        extra = labels if tagged else ["v = −10.00 m/s"]
        self.wide = max((EXTRA * u + sheet.text_width(words) for words in extra), default=0.0)
        if not tagged:
            self.wide = max([self.wide, *map(sheet.text_width, labels)])
        self.rows = rows
        self.wide = self.wide if rows else 0.0

    def lay_out(self, forces: bool) -> Layout:
        """Place texts and keys without overlap: next to each other, else in rows, else dropped."""
        u, (width, height) = self.sheet.unit, self.sheet.size
        left, right, top = MARGIN * u, width - MARGIN * u, height - 8.0 * u
        broad, high = min(self.wide, right - left), (ROW * self.rows + 4.0 * bool(self.rows)) * u
        sizes = [self.sheet.text_width(BAR_WORDS) + 18.0 * u]
        if forces:
            sizes.append(self.sheet.text_width(NORMAL) + (ARROW + 9.0) * u)
        places: list[Rectangle | None] = [None, None]
        head = 8.0 * u + high
        for rows, below in _arrangements(len(sizes)):
            room = right - left - (0.0 if below else broad + GAP * u)
            widest = max(sum(sizes[k] for k in row) + GAP * u * (len(row) - 1) for row in rows)
            tall = len(rows) * KEYS * u
            if widest > room or tall + below * high > MOST_HEAD * height - 8.0 * u:
                continue
            y = top - below * high
            for row in rows:
                x, y = right, y - KEYS * u
                for k in row:
                    places[k] = (x - sizes[k], y, sizes[k], KEYS * u)
                    x -= sizes[k] + GAP * u
            head = max(head, height - y)
            break
        foot, lines, pace = self._foot()
        self.layout = Layout(head, foot, (left, top - high, broad, high), places[0], places[1], lines, pace)
        return self.layout

    def _foot(self) -> tuple[float, tuple[Rectangle, ...], Rectangle | None]:
        u, wide = self.sheet.unit, self.sheet.size[0]
        left, right = 0.5 * MARGIN * u, wide - 0.5 * MARGIN * u
        paces = [pace_words(float(rate)) for rate in self.clock.rate]
        said = max((self.sheet.text_width(words, bold=True) for words in set(paces) if words), default=0.0)
        widths = [self.sheet.text_width(words) + KEY_LINE * u for _, words, _ in self.keys]
        total = sum(widths) + max(len(widths) - 1, 0) * 14.0 * u
        two = bool(said) and total + said + 2.0 * MARGIN * u > wide
        x, placed = max(right - total, left), []
        for width in widths:
            if x + width > right + 0.5:
                break  # no room
            placed.append((x, FOOT * u * two, width, FOOT * u))
            x += width + 14.0 * u
        pace = (MARGIN * u, 0.0, min(said, wide - MARGIN * u), FOOT * u) if said else None
        return (1.0 + two) * FOOT * u, tuple(placed), pace

    def draw_keys(self, top_speed: float, newton: float, most: float) -> None:
        """Draw the keys.

        top_speed: at the right end of the colour bar [m/s]; newton: length of the arrow of 1 N [pixels]; most: maximum force of
        the film [N].
        """
        sheet, u = self.sheet, self.sheet.unit
        if self.layout.bar is not None:
            self._draw_bar(self.layout.bar, top_speed)
        if self.layout.forces is not None:
            self._draw_arrows(self.layout.forces, newton, most)
        for (color, words, marker), (x, y, _, height) in zip(self.keys, self.layout.lines, strict=False):
            level = y + 0.5 * height
            if marker:
                sheet.line(np.array([[x + 16.0 * u, level]]), color=color, marker=marker, ms=11.0)
            else:
                sheet.line(np.array([[x, level], [x + 26.0 * u, level]]), color=color, lw=3.0)
            sheet.text(x + KEY_LINE * u, level, words, self.theme.ink, "lm")

    def _draw_bar(self, place: Rectangle, top_speed: float) -> None:
        sheet, theme, u = self.sheet, self.theme, self.sheet.unit
        x, y, width, _ = place
        x, width, height, y = x + 10.0 * u, width - 28.0 * u, 12.0 * u, y + 28.0 * u  # numbers extend beyond its ends
        a, b = round(x), sheet.size[1] - round(y + height)
        shades = shades_of(np.linspace(0.0, 1.0, round(width)), 1.0)
        sheet.pixels[b : b + max(round(height), 1), a : a + round(width)] = np.round(255 * shades)[None].astype(np.uint8)
        frame = np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height], [x, y]])
        sheet.line(frame, color=theme.ink, lw=0.8)
        sheet.text(x, y + height + 7.0 * u, BAR_WORDS, theme.ink)
        for value in np.arange(0.0, top_speed * (1.0 + 1e-9), nice(top_speed / 3.0)):
            spot = x + width * value / top_speed
            sheet.line(np.array([[spot, y], [spot, y - 4.0 * u]]), color=theme.ink, lw=0.8)
            sheet.text(spot, y - 16.0 * u, f"{value:g}", theme.ink, "mm")

    def _draw_arrows(self, place: Rectangle, newton: float, most: float) -> None:
        sheet, theme, u = self.sheet, self.theme, self.sheet.unit
        x, y = place[0] + place[2] - ARROW * u, place[1] + 34.0 * u
        amount = nice(min(120.0 * u / newton, most))
        for row, (color, words) in enumerate(((colors.NORMAL_FORCE, NORMAL), (colors.FRICTION_FORCE, FRICTION))):
            level = y - 24.0 * u * row
            sheet.text(x - 8.0 * u, level, words, theme.ink, "rm")
            shown = sheet.add(new_arrow(theme, color, None))
            place_arrow(shown, np.array([x, level]), np.array([amount * newton, 0.0]), u)
            sheet.draw(shown)
        sheet.text(x + 0.5 * amount * newton, y + 13.0 * u, newtons(amount), theme.ink, "ms")

    def draw_state(
        self, place: tuple[float, float], k: int, motion: Trajectory, poses: Poses, i: int, extra: str, tag: str, room: float
    ) -> None:
        """Write mode, time, angle and one more text, the i-th of `poses`, from a point on [pixels], in `room` pixels."""
        sheet, theme, u = self.sheet, self.theme, self.sheet.unit
        x, y = place
        mode = str(poses.words[i])
        self.draw_tag(np.array([x + 12.0 * u, y + 8.0 * u]), tag, colors.mode_color(mode))
        words = end_word(motion, float(poses.t[i]), k in (0, self.clock.count - 1)) or WORDS[mode].participle
        if MODE * u + sheet.text_width(words, bold=True) <= room:
            sheet.text(x + MODE * u, y, words, theme.ink, bold=True)
        turned = f"θ = {math.degrees(poses.angle[i]):.1f}°"
        for offset, words in ((TIME, f"t = {poses.t[i]:.3f} s"), (ANGLE, turned), (EXTRA, extra)):
            shown = sheet.shortened(words, room - offset * u)
            if not shown:
                break
            sheet.text(x + offset * u, y, shown, theme.ink)

    def draw_tag(self, spot: Any, tag: str, fill: str) -> None:
        """Draw a disc, with the letter of a hoop where there are several in a view."""
        u, ink = self.sheet.unit, "#FFFFFF" if colors.lightness(fill) < 0.5 else colors.BLACK
        self.sheet.dot(spot, 26.0 if tag else 17.0, fill, self.theme.ink)
        if tag:
            self.sheet.text(float(spot[0]), float(spot[1] - 0.5 * u), tag, ink, "mm", bold=True)

    def draw_pace(self, k: int) -> None:
        """Write the speed of the film."""
        if self.layout.pace is not None:
            x, y, room, _ = self.layout.pace
            words = pace_words(float(self.clock.rate[k]))
            if self.sheet.text_width(words, bold=True) <= room + 1.0:
                self.sheet.text(x, y + 10.0 * self.sheet.unit, words, self.theme.ink, bold=True)


def _arrangements(count: int) -> Iterator[tuple[list[list[int]], bool]]:
    """Rows of the keys, the best first, and whether they are below the words; at last the one to arrows alone."""
    every = list(range(count))
    for rows in ([every], [[k] for k in every], [every[-1:]]):
        yield rows, False
        yield rows, True


def new_arrow(theme: Theme, color: str, transform: Any) -> Any:
    """Return the arrow of a force; transform: from its coordinates to pixels, None for pixels."""
    arrow = need("matplotlib.patches", "plots").FancyArrow
    identity = need("matplotlib.transforms", "plots").IdentityTransform()
    look = {"fc": theme.visible(color), "ec": theme.background, "lw": 0.8, "transform": transform or identity}
    return arrow(0.0, 0.0, 1.0, 0.0, length_includes_head=True, **look)


def place_arrow(arrow: Any, tail: Any, way: Any, unit: float) -> None:
    """Place an arrow; a short one is only a head.

    tail, way: its tail and its extent; unit: length of a unit of the picture in their unit.
    """
    length = float(np.hypot(*way))
    arrow.set_visible(length > 2.5 * unit)
    point = min(25.0 * unit, length)
    wide = min(18.0 * unit, 1.5 * point)
    (x, y), (dx, dy) = tail, way
    arrow.set_data(x=x, y=y, dx=dx, dy=dy, width=min(7.0 * unit, wide), head_width=wide, head_length=point)


def bounded(way: Any, longest: float) -> Any:
    """Return an arrow, at most `longest` long: in a jam forces are unbounded."""
    return way * min(1.0, longest / max(float(np.hypot(*way)), 1e-300))


FLASH, SPREAD = 0.5, 0.45  # duration of the ring at an event [s of film], and its final radius in radii of the hoop
MARK = 11.0  # size of marks [units]


def draw_marks(
    sheet: Sheet,
    theme: Theme,
    kinds: Sequence[str],
    spots: Sequence[Any],
    ages: Sequence[float],
    radius: float,
    depth: float,
    clip: Rectangle,
) -> None:
    """Draw events: a ring that spreads, and a mark that stays below the plane.

    kinds, spots, ages: kind, position on the plane [pixels] and age [s of film] of each; radius: of the hoop [pixels];
    depth: of the marks below the plane [pixels]; clip: left, bottom, width, height [pixels].
    """
    box = need("matplotlib.transforms", "plots").Bbox.from_bounds(*clip)
    down = np.array([0.0, depth])
    for kind, spot, age in zip(kinds, spots, ages, strict=True):
        if not (clip[0] - radius < spot[0] < clip[0] + clip[2] + radius):
            continue
        sheet.line(np.array([spot, spot - down]), color=theme.ink, lw=1.0, alpha=0.6, clip=box)
        sheet.line(np.array([spot - down]), color=theme.ink, marker=MARKS[kind], ms=MARK, clip=box)
        share = age / FLASH
        if share < 1.0:
            size = 2.0 * (0.08 + SPREAD * share) * radius / sheet.unit
            look = {"mfc": "none", "mec": theme.ink, "mew": 3.0 * (1.0 - share) + 0.6, "alpha": 1.0 - share}
            sheet.line(np.array([spot]), marker="o", ms=size, clip=box, **look)
