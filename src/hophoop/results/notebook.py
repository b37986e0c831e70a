"""A motion in notebooks: a small picture and a short table, as HTML without dependencies."""

from __future__ import annotations

import math
from html import escape
from itertools import pairwise

import numpy as np

from hophoop._support import tables
from hophoop.results.event_table import TITLES, WORDS, cells
from hophoop.results.poses import Floats, Poses, event_times, poses_of, to_world
from hophoop.results.records import Motion
from hophoop.scenario import describe
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import plain

MOST_ROWS = 12
MOST_HOOPS = 10
POINTS = 600  # points of a trace
WIDTH, HIGHEST = 760.0, 300.0  # size of the picture [pixels]
EDGE = 8.0  # margin around the drawing [pixels]


def html(motion: Motion) -> str:
    """Return a small picture and a short table of a motion as HTML.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    html : str
    """
    shown = motion.events[:MOST_ROWS]
    more = len(motion.events) - len(shown)
    left = [TITLES.index(title) for title in WORDS]
    table = tables.html(map(cells, shown), TITLES, left, after=[f"… and {more} more"] if more else [])
    head = (
        f"<b>{escape(describe(motion.scenario))}</b><br>phases <code>{escape(shortened(motion.sequence))}</code>, "
        f"{escape(plain(motion.status))} after {motion.duration:.6g} s"
    )
    return f"<div>{head}<br>{picture(motion)}{table}</div>"


def shortened(sequence: str, most: int = 24) -> str:
    """Return a sequence, shortened to a maximum length.

    Parameters
    ----------
    sequence : str
    most : int, default 24
        Maximum number of letters [1].

    Returns
    -------
    sequence : str
    """
    return sequence if len(sequence) <= most else sequence[: most - 1] + "…"


def picture(motion: Motion) -> str:
    """Return the path of the hoop as SVG: traces of load and centre of gravity, and the hoop at events in its mode's colour.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    svg : str
    """
    radius, slope = motion.scenario.hoop.radius, motion.scenario.plane.slope
    marks = event_times(motion)
    way = poses_of(motion, np.union1d(motion.times(POINTS), marks))
    low, high = way.center.min(axis=0) - radius, way.center.max(axis=0) + radius
    scale = min((WIDTH - 2.0 * EDGE) / (high[0] - low[0]), (HIGHEST - 2.0 * EDGE) / (high[1] - low[1]))
    # lines and dots have a width in pixels, however small the hoop is
    low, high = low - EDGE / scale, high + EDGE / scale
    wide, tall = (scale * (high - low)).tolist()

    def path(points: Floats) -> str:
        placed = (points - [low[0], high[1]]) * [scale, -scale]
        return "M" + "L".join(f"{x:.1f},{y:.1f}" for x, y in placed)

    reach = (high[0] - low[0] + high[1] - low[1]) / math.cos(slope)
    middle = float(0.5 * (low[0] + high[0]) / math.cos(slope))
    ground = to_world([middle - reach, middle + reach], [0.0, 0.0], slope)
    chosen = marks[np.unique(np.linspace(0, marks.size - 1, min(MOST_HOOPS, marks.size)).astype(int))]
    shapes = [f"<path d='{path(ground)}' stroke='{colors.GRAY}'/>"]
    shapes += [_hoop(poses_of(motion, t), radius, low, high, scale) for t in chosen]
    shapes.append(f"<path d='{path(way.load)}' stroke='{colors.LOAD}'/>")
    airborne = (way.mode == "H")[:-1]
    edges = [0, *(np.flatnonzero(np.diff(airborne.astype(int))) + 1).tolist(), len(airborne)]
    for a, b in pairwise(edges):
        if b > a:
            ink = colors.GRAVITY_CENTER_AIRBORNE if airborne[a] else colors.GRAVITY_CENTER
            shapes.append(f"<path d='{path(way.gravity_center[a : b + 1])}' stroke='{ink}' stroke-width='2'/>")
    return (
        f"<svg xmlns='http://www.w3.org/2000/svg' role='img' aria-label='Path of the hoop' width='{wide:.0f}' "
        f"height='{tall:.0f}' viewBox='0 0 {wide:.1f} {tall:.1f}' fill='none' style='background:white;max-width:100%;"
        f"height:auto'>{''.join(shapes)}</svg>"
    )


def _hoop(poses: Poses, radius: float, low: Floats, high: Floats, scale: float) -> str:
    (x, y), (load_x, load_y) = (
        ((points[0] - [low[0], high[1]]) * [scale, -scale]).tolist() for points in (poses.center, poses.load)
    )
    word = str(poses.words[0])
    ink = colors.mode_color(word)
    return (
        f"<g stroke='{ink}'><title>{word}, t = {poses.t[0]:.4g} s</title><circle cx='{x:.1f}' cy='{y:.1f}' "
        f"r='{radius * scale:.1f}' stroke-width='1.6'/><path d='M{x:.1f},{y:.1f}L{load_x:.1f},{load_y:.1f}'/></g>"
        f"<circle cx='{load_x:.1f}' cy='{load_y:.1f}' r='3.5' fill='{colors.LOAD}'/>"
    )
