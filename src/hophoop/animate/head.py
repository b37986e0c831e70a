"""Texts and keys of a film: mode, time and angle of each motion above the views, keys to colours, lines and marks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.frames import EventMark, Subject, end_word
from hophoop.animate.look import nice
from hophoop.animate.sheet import FONT, Points, Rectangle, Sheet
from hophoop.animate.themes import Theme
from hophoop.results.poses import Floats, Poses
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import EVENTS, MARKS, WORDS

MARGIN, GAP = 22.0, 26.0  # at the sides, and between texts and keys [units]
BAR, FORCES, KEYS = 322.0, 260.0, 66.0  # widths of the keys to colours and to forces, and their height [units]
ARROW = 124.0  # width of the longest arrow in its key [units]
ROW, FOOT = 32.0, 34.0  # heights of a line of text above, and of the line below [units]
STATE = (34.0, 164.0, 296.0, 440.0, 599.0)  # offsets of mode, time, angle and velocity or label, and their end [units]
KEY, PACE = 145.0, 255.0  # widths of a key of the legend, and of the speed of the film beside it [units]
MOST_HEAD = 0.42  # maximum height of the head over that of the picture
MARK = 11.0  # size of marks [units]
FLASH, SPREAD = 0.5, 0.45  # duration of the ring at an event [s of film], and its final radius in radii of the hoop


def pace_words(rate: float) -> str:
    """Text of the film's speed relative to the motion; empty in real time."""
    if 0.985 < rate < 1.015:
        return ""
    return f"slow motion, 1/{1.0 / rate:.2g}" if rate < 1.0 else f"{rate:.3g} times as fast"


def arrow_look(theme: Theme, unit: float) -> dict[str, Any]:
    """Options of Matplotlib's quiver for the arrows of normal force and friction, to the scale of its axes."""
    shaft = 7.0 * unit
    inks = [theme.visible(color) for color in (colors.NORMAL_FORCE, colors.FRICTION_FORCE)]
    head = {"headwidth": 18.0 / 7.0, "headlength": 25.0 / 7.0, "headaxislength": 25.0 / 7.0}
    edge = {"edgecolors": theme.background, "linewidths": 0.8}
    return {"color": inks, "angles": "xy", "scale_units": "xy", "scale": 1.0, "units": "dots", "width": shaft, **head, **edge}


class Head:
    """Texts and keys of a film: heights of head and foot, and places of the texts [pixels].

    side: whether texts are in the views, one each. The captions are of four kinds: with the keys beside the texts, below them,
    above the views with their texts, and without keys in a small picture.
    """

    def __init__(self, sheet: Sheet, theme: Theme, subject: Subject, forces: bool, side: bool = False) -> None:
        self.sheet, self.theme, self.subject, self.forces = sheet, theme, subject, forces
        u, (width, height), rows = sheet.unit, sheet.size, len(subject.labels)
        self.tagged = rows > 1 and not side
        texts, keys = (0.0 if side else ROW * max(rows, 2) + 4.0), BAR + GAP + (FORCES + GAP) * forces
        room = width / u - 2.0 * MARGIN
        self.keys = keys <= room and texts + KEYS < MOST_HEAD * height / u
        beside = side or (STATE[-1] + keys <= room and not self.tagged)
        self.head = u * (8.0 + (max(texts, KEYS) if beside or not self.keys else texts + KEYS))
        self.foot = u * FOOT
        levels = [ROW * (row + 1) for row in range(rows)] if self.tagged else [60.0]
        space = u * (room - keys * beside)
        self.places = [(MARGIN * u, height - level * u, space) for level in levels]  # and width of the texts

    def draw_keys(self, traces: bool, newton: float) -> None:
        """Draw the keys, before the sheet is rendered; newton: length of the arrow of 1 N [pixels]."""
        sheet, theme, u, level = self.sheet, self.theme, self.sheet.unit, self.sheet.size[1] - self.head
        right = sheet.size[0] - MARGIN * u
        if self.keys:
            self._draw_bar((right - (BAR - 10.0) * u, level + 28.0 * u, (BAR - 28.0) * u, 12.0 * u))
            if self.forces:
                self._draw_arrows((right - (BAR + GAP + FORCES) * u, level, FORCES * u, KEYS * u), newton)
        line = need("matplotlib.lines", "plots").Line2D
        lines = {"load": theme.load, "centre of gravity": theme.visible(colors.GRAVITY_CENTER)}
        if any(track.airborne.any() for track in self.subject.traces):
            lines["airborne"] = theme.visible(colors.GRAVITY_CENTER_AIRBORNE)
        handles = [line([], [], color=color, lw=3.0, label=words) for words, color in lines.items() if traces]
        kinds = {EVENTS[one.kind].noun: MARKS[one.kind] for found in self.subject.marks for one in found}
        handles += [line([], [], color=theme.ink, lw=0.0, marker=mark, ms=MARK, label=noun) for noun, mark in kinds.items()]
        handles = handles[: max(0, int((sheet.size[0] / u - PACE) / KEY))]  # the first ones in a small picture
        if handles:
            sheet.figure.legend(
                handles=handles, loc="lower right", ncols=len(handles), frameon=False, fontsize=FONT, labelcolor=theme.ink,
                borderpad=0.0, borderaxespad=0.35, handlelength=1.3, handletextpad=0.35, columnspacing=0.7,
            )  # fmt: skip

    def _draw_bar(self, place: Rectangle) -> None:
        sheet, ink, top = self.sheet, self.theme.ink, self.subject.whole.speed
        scale = need("matplotlib.colors", "plots").Normalize(0.0, top)
        shades = need("matplotlib.cm", "plots").ScalarMappable(scale, colors.RING_SPEED_MAP)
        ticks = np.arange(0.0, top * (1.0 + 1e-9), nice(top / 3.0))
        bar = sheet.figure.colorbar(shades, cax=sheet.axes(place), orientation="horizontal", ticks=ticks, format="{x:g}")
        bar.outline.set(edgecolor=ink, linewidth=0.8)
        bar.ax.tick_params(color=ink, labelcolor=ink, labelsize=FONT, length=4.0, width=0.8, pad=3.0)
        bar.ax.set_title("speed of the ring's points, m/s", loc="left", fontsize=FONT, color=ink, pad=6.0)

    def _draw_arrows(self, place: Rectangle, newton: float) -> None:
        u, theme = self.sheet.unit, self.theme
        axes = self.sheet.axes(place, xlim=(0.0, FORCES), ylim=(0.0, KEYS), facecolor="none")
        axes.set_axis_off()
        amount = nice(min(120.0 * u / newton, self.subject.whole.force))
        newtons = need("matplotlib.ticker", "plots").EngFormatter("N")
        x, long, levels = FORCES - ARROW, amount * newton / u, (34.0, 10.0)
        axes.quiver([x, x], levels, [long, long], [0.0, 0.0], **arrow_look(theme, u))
        look = {"fontsize": FONT, "color": theme.ink}
        for level, words in zip(levels, ("normal force", "friction"), strict=True):
            axes.text(x - 8.0, level, words, ha="right", va="center_baseline", **look)
        axes.text(x + 0.5 * long, levels[0] + 13.0, newtons(amount), ha="center", va="baseline", **look)

    def move_to(self, views: Sequence[Rectangle]) -> None:
        """Place the texts of each motion above its view."""
        u = self.sheet.unit
        self.places = [(x + MARGIN * u, y + high + 10.0 * u, wide - 30.0 * u) for x, y, wide, high in views]

    def draw_labels(self) -> None:
        """Write the labels of the motions, above their states."""
        for (x, y, room), label in zip(() if self.tagged else self.places, self.subject.labels, strict=False):
            self.sheet.text(x, y + ROW * self.sheet.unit, self.sheet.shortened(label, room), self.theme.muted)

    def draw_states(self, k: int, actors: Sequence[tuple[Poses, int]]) -> None:
        """Write mode, time, angle and velocity or label of all motions; actors: their poses, with the index of the k-th."""
        sheet, u, last = self.sheet, self.sheet.unit, k in (0, self.subject.clock.count - 1)
        for row, ((poses, i), (x, y, room)) in enumerate(zip(actors, self.places, strict=True)):
            mode, label, t = str(poses.words[i]), self.subject.labels[row], float(poses.t[i])
            self.draw_tag(np.array([x + 12.0 * u, y + 8.0 * u]), row, colors.mode_color(mode))
            words = end_word(self.subject.motions[row], t, last) or WORDS[mode].participle
            turned, speed = f"θ = {math.degrees(poses.angle[i]):.1f}°", f"v = {poses.velocity[i, 0]:.2f} m/s"
            extra = sheet.shortened(label, room - STATE[3] * u) if self.tagged else speed
            for text, start, end in zip((words, f"t = {t:.3f} s", turned, extra), STATE, STATE[1:], strict=False):
                if end * u <= room or (self.tagged and text is extra):
                    sheet.text(x + start * u, y, text, self.theme.ink, bold=text is words)

    def draw_pace(self, k: int) -> None:
        """Write the speed of the film."""
        words = pace_words(float(self.subject.clock.rate[k]))
        self.sheet.text(MARGIN * self.sheet.unit, 10.0 * self.sheet.unit, words, self.theme.ink, bold=True)

    def draw_tag(self, spot: Points, row: int, fill: str) -> None:
        """Draw a disc, with the letter of a hoop where there are several in a view."""
        self.sheet.dot(spot, 26.0 if self.tagged else 17.0, fill, self.theme.ink)
        if self.tagged:
            ink = "#FFFFFF" if colors.lightness(fill) < 0.5 else colors.BLACK
            self.sheet.text(float(spot[0]), float(spot[1]) - 0.5 * self.sheet.unit, self.subject.tag(row), ink, "mm", bold=True)

    def draw_marks(
        self, k: int, row: int, marks: Sequence[EventMark], spots: Floats, radius: float, depth: float, clip: Rectangle
    ) -> None:
        """Draw the events of a motion so far: a ring that spreads, and a mark that stays below the plane.

        spots: of the events on the plane [pixels]; radius: of the hoop, depth: of the marks below the plane [pixels].
        """
        sheet, ink, film = self.sheet, self.theme.ink, self.subject.clock
        box = need("matplotlib.transforms", "plots").Bbox.from_bounds(*clip)
        for one, spot in zip(marks, spots, strict=True):
            if not (clip[0] - radius < spot[0] < clip[0] + clip[2] + radius):
                continue
            foot = spot - [0.0, depth]
            sheet.line(np.array([spot, foot]), box, color=ink, lw=1.0, alpha=0.6)
            sheet.line(np.array([foot]), box, color=ink, marker=MARKS[one.kind], ms=MARK)
            share = ((float(film.times[row][k]) - one.t) / float(film.rate[k]) + float(film.still[k])) / FLASH
            if share < 1.0:
                size = 2.0 * (0.08 + SPREAD * share) * radius / sheet.unit
                look = {"mfc": "none", "mec": ink, "mew": 3.6 - 3.0 * share, "alpha": 1.0 - share}
                sheet.line(np.array([spot]), box, marker="o", ms=size, **look)
