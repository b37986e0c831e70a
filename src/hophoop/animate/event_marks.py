"""Marks of take-offs, impacts and jams in a film: an expanding ring at the event, and a mark that stays on the plane."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from hophoop.animate.canvas import Canvas, Points, Rectangle, TextStyle
from hophoop.animate.layout import FONT
from hophoop.animate.themes import Theme
from hophoop.plots.marks import center_of_label, clusters
from hophoop.results.poses import Floats, to_world
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.names import EVENTS, MARKS

KINDS = tuple(kind for kind, facts in EVENTS.items() if facts.filmed)
FLASH = 0.5  # duration of the ring [s of film]
SPREAD = 0.45  # its final radius, in radii of the hoop
MOST = 400  # maximum number of marks, the last ones
SIZE, LETTER = 5.0, 0.617 * FONT  # of marks, and width of a letter [units]

ShownMark = tuple[str, Points]  # kind of an event, and its position in the picture [pixels]
ToPixels = Callable[[Floats], Points | None]


@dataclass(frozen=True)
class EventMark:
    """A marked event: kind, time [s], and position along the plane and in the world [m]."""

    kind: str
    t: float
    along: float
    place: Floats


def event_marks(motion: Trajectory, times: Floats) -> list[EventMark]:
    """Return the events to mark in a film.

    times: shape (frames,), time of each picture [s]; found: in order of time.
    """
    slope = motion.scenario.plane.slope
    found = []
    for event in motion.events:
        if event.kind in KINDS and times[0] <= event.t <= times[-1]:
            found.append(EventMark(event.kind, event.t, event.x, to_world(event.x, 0.0, slope)))
    return found


def draw_event_marks(
    canvas: Canvas,
    theme: Theme,
    found: Sequence[EventMark],
    now: tuple[float, float, float],
    to_pixels: ToPixels,
    radius: float,
    below: float,
) -> list[ShownMark]:
    """Draw the marks of events up to now; `label_event_marks` writes their labels.

    now: time of the motion [s], seconds of motion per second of film [1], and time of the final pause [s of film]; to_pixels:
    from the world to the canvas; None for invisible points; radius: radius of the hoop [pixels]; below: distance of labels
    below the plane [pixels]; seen: kind of each mark in the picture, and its position on the plane [pixels].
    """
    u = canvas.unit
    t, rate, still = now
    past = [one for one in found if one.t <= t][-MOST:]
    seen = [(one, spot) for one in past if (spot := to_pixels(one.place)) is not None]
    last = None
    for one, spot in seen:
        age = (t - one.t) / rate + still
        if age < FLASH:
            share = age / FLASH
            canvas.disc(spot, (0.08 + SPREAD * share) * radius, None, theme.ink, 3.0 * (1.0 - share) + 0.6, 1.0 - share)
        if last is None or one.kind != last[0] or abs(spot[0] - last[1]) > 2.0 * SIZE * u:
            _mark(canvas, theme, one.kind, spot - np.array([0.0, 0.5 * below]), SIZE * u)
            canvas.line(np.array([spot, spot - np.array([0.0, 0.5 * below - SIZE * u])]), theme.ink, 1.0, 0.6)
            last = one.kind, spot[0]
    return [(one.kind, spot) for one, spot in seen]


def label_event_marks(
    canvas: Canvas, theme: Theme, seen: Sequence[ShownMark], below: float, across: tuple[float, float]
) -> list[Rectangle]:
    """Label the marks below the plane, those of all hoops in a view together, so that labels do not overlap.

    seen: from `draw_event_marks` [pixels]; below: distance of labels below the plane [pixels]; across: left and width of the
    view, which labels do not leave [pixels]; taken: rectangle of each label with its marks: left, bottom, width, height
    [pixels].
    """
    left, width = across
    seen = [(kind, spot) for kind, spot in seen if left <= spot[0] <= left + width]
    if not seen:
        return []
    u = canvas.unit
    ordered = sorted(seen, key=lambda pair: float(pair[1][0]))
    taken = []
    places, up = np.array([spot[0] - left for _, spot in ordered]), np.array([spot[1] for _, spot in ordered])
    for group in clusters(list(places / u), [kind for kind, _ in ordered], width / u, LETTER):
        level = float(np.interp(group.middle * u, places, up))
        middle, wide = left + center_of_label(group, width / u) * u, canvas.text_width(group.words, FONT)
        canvas.text(middle, level - below, group.words, TextStyle(theme.ink, FONT, "center", vertical="center"))
        taken.append((middle - 0.5 * wide, level - below - 0.37 * FONT * u, wide, below))
    return taken


def _mark(canvas: Canvas, theme: Theme, kind: str, spot: Points, size: float) -> None:
    sign = MARKS[kind]
    if sign == "X":
        for turn in (1.0, -1.0):
            way = size * np.array([1.0, turn])
            canvas.line(np.array([spot - way, spot + way]), theme.ink, 2.6)
        return
    up = 1.0 if sign == "^" else -1.0
    corners = np.array([[-size, -up * size], [size, -up * size], [0.0, up * size]])
    canvas.polygon(spot + corners, theme.ink)
