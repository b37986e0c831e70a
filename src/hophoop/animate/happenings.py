"""Take-offs, impacts and jams in a film: a ring that spreads as they happen, and a mark that stays on the plane."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from hophoop.animate.canvas import Canvas, Points
from hophoop.animate.themes import Theme
from hophoop.plots.marks import clusters
from hophoop.results.poses import Floats, to_world
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.events import EVENTS, MARKS

KINDS = tuple(kind for kind, facts in EVENTS.items() if facts.filmed)
FLASH = 0.5  # how long a ring spreads [s of film]
SPREAD = 0.45  # how far, in radii of the hoop
MOST = 400  # of the last ones are drawn
SIZE, FONT, LETTER = 5.0, 12.0, 7.4  # of marks and words, and width of a letter [units]

Seen = tuple[str, Points]  # kind of an event, and its place in the picture [pixels]
ToPixels = Callable[[Floats], Points | None]


@dataclass(frozen=True)
class Happening:
    """An event that a film marks: what it is, when it happens [s], and where on the plane: along it, and in the world [m]."""

    kind: str
    t: float
    along: float
    place: Floats


def happenings(motion: Trajectory, times: Floats) -> list[Happening]:
    """The events to be marked in the pictures at some times.

    Parameters
    ----------
    motion : Trajectory
    times : ndarray, shape (frames,)
        Time of each picture [s].

    Returns
    -------
    found : list of Happening
        In order of time.
    """
    slope = motion.scenario.plane.slope
    found = []
    for event in motion.events:
        if event.kind in KINDS and times[0] <= event.t <= times[-1]:
            found.append(Happening(event.kind, event.t, event.x, to_world(event.x, 0.0, slope)))
    return found


def draw_happenings(
    canvas: Canvas,
    theme: Theme,
    found: Sequence[Happening],
    now: tuple[float, float, float],
    to_pixels: ToPixels,
    radius: float,
    below: float,
) -> list[Seen]:
    """Draw the signs of what has happened up to now, whose words `say_happenings` writes.

    Parameters
    ----------
    canvas : Canvas
    theme : Theme
    found : sequence of Happening
    now : tuple of float
        Time of the motion [s], seconds of motion a second of film [1], and how long the film has stayed there [s of film].
    to_pixels : callable
        From the world to the canvas; None where a point cannot be seen.
    radius : float
        Of the hoop [pixels].
    below : float
        How far under the plane words stand [pixels].

    Returns
    -------
    seen : list of (str, ndarray)
        What each sign in the picture says, and its place on the plane [pixels].
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


def say_happenings(canvas: Canvas, theme: Theme, seen: Sequence[Seen], below: float) -> None:
    """Write what has happened, under the plane: the words of all hoops in a view at once, so that none lies on another.

    Parameters
    ----------
    canvas : Canvas
    theme : Theme
    seen : sequence of (str, ndarray)
        As `draw_happenings` gives them [pixels].
    below : float
        How far under the plane words stand [pixels].
    """
    if not seen:
        return
    u = canvas.unit
    ordered = sorted(seen, key=lambda pair: float(pair[1][0]))
    across, up = (np.array([spot[k] for _, spot in ordered]) for k in (0, 1))
    for group in clusters(list(across / u), [kind for kind, _ in ordered], np.inf, LETTER):
        level = float(np.interp(group.middle * u, across, up))
        canvas.text(group.middle * u, level - below, group.words, theme.ink, FONT, "center", vertical="center")


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
