"""Films in 2D: pictures of one or several motions, by Matplotlib's artists over a background drawn once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.frames import Extent, Timing, follow, subject_of
from hophoop.animate.head import Head, arrow_look
from hophoop.animate.look import FORCE_LENGTH, LONGEST, Look, bounded, nice
from hophoop.animate.panels import Panels
from hophoop.animate.sheet import Bytes, Points, Rectangle, Sheet, shades_of
from hophoop.animate.themes import THEMES
from hophoop.plots.hoop import AROUND, LOAD, HoopArtist
from hophoop.results.poses import Floats, Poses, poses_of, rim_speeds, to_world
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors

BLOCK = 256  # frames whose poses are computed together
TRACE_POINTS = 6000  # maximum, the last ones
RING, HEAVY = 0.05, 0.042  # width of the ring, radius of the centre of gravity, in radii
FADE = 0.45  # opacity of all motions in one view except the first
ABOVE, SIDE, LEAST_WIDTH = 0.4, 1.35, 3.4  # margins of a view above the hoop and at its sides, and its least width, in radii
BELOW, BELOW_SHARE = 58.0, 0.16  # least height below the plane [units], and share of the view's height
VIEW_HEAD = 68.0  # of the texts of a view [units]
CALM = 0.45  # inertia of the following camera [s of film]


class _View:
    """A part of the picture with a camera: axes in metres, with their lower left corner in each frame, or in all."""

    def __init__(self, sheet: Sheet, rectangle: Rectangle, scale: float, slope: float, corners: Floats) -> None:
        self.rectangle, self.scale, self.slope, self.corners = rectangle, scale, slope, corners
        self.extent = np.array(rectangle[2:]) / scale
        self.axes = sheet.axes(rectangle, facecolor="none", autoscale_on=False)
        self.axes.set_axis_off()

    def aim(self, k: int) -> None:
        """Point the camera for the k-th picture."""
        corner = self.corners[min(k, len(self.corners) - 1)]
        self.axes.viewLim.set_points(np.array([corner, corner + self.extent]))

    def pixels(self, points: Floats) -> Points:
        """Convert points of the world to pixels."""
        return np.asarray(self.axes.transData.transform(points))


class _Actor:
    """One motion in the film, and its artists in the coordinates of the world."""

    def __init__(self, film: Film2D, row: int, view: _View) -> None:
        self.film, self.row, self.view, self.sheet, self.theme = film, row, view, film.sheet, film.theme
        self.motion, self.trace, self.times = film.subject.motions[row], film.subject.traces[row], film.clock.times[row]
        self.alpha = FADE if film.overlay and row else 1.0
        self._block = -1
        patches = need("matplotlib.patches", "plots")
        theme, axes, hoop, unit, alpha = self.theme, view.axes, self.motion.scenario.hoop, self.sheet.unit, self.alpha

        def add(artist: Any, transform: Any = axes.transData) -> Any:
            artist.set(transform=transform, animated=True)
            return axes.add_artist(artist)

        def line(color: str, width: float, opacity: float = 1.0) -> Any:
            return axes.plot([], [], color=color, lw=width, alpha=opacity, animated=True)[0]

        radius, reach, self.depth = hoop.radius, 2.0 * float(np.hypot(*view.extent)), self._depth()
        ends = np.add(film.subject.whole.along, (-reach, reach))
        ground = to_world(ends[[0, 1, 1, 0]], np.array([0.0, 0.0, -reach, -reach]), view.slope)
        self.plane = [add(patches.Polygon(ground, fc=theme.ground, lw=0.0)), line(theme.ink, 1.6), line(theme.muted, 1.2)]
        self.plane[1].set_data(ground[:2].T)
        self.step = nice(200.0 * unit / view.scale)
        self.inks = [theme.visible(color) for color in (colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE)]
        self.paths = [(self.trace.load, line(theme.load, 1.7, 0.85 * alpha))]
        self.paths += [
            (self.trace.gravity_path(flies), line(ink, 2.6, alpha)) for flies, ink in zip((False, True), self.inks, strict=True)
        ]
        metre = view.scale / unit  # [points]
        width, load = RING * radius * metre, 2.0 * LOAD * radius * metre
        self.hoop = HoopArtist(
            axes, hoop, view.slope, ring=width, load=load, line=theme.muted, ink=theme.load, edge=theme.background,
            alpha=alpha, pieces=True, metre=metre,
        )  # fmt: skip
        outline = patches.Circle((0.0, 0.0), self.hoop.middle, fill=False, ec=theme.outline, lw=width + 1.6, alpha=alpha)
        heavy = patches.Circle((0.0, hoop.eccentricity * radius), HEAVY * radius, lw=1.2, ec=theme.background, alpha=alpha)
        self.heavy, around = heavy, self.hoop.turned + axes.transData
        for artist in self.hoop.artists:
            artist.set_animated(True)
        self.shown = [add(outline, around), *self.hoop.artists, add(heavy, around)]
        self.forces = axes.quiver([0.0] * 2, [0.0] * 2, [0.0] * 2, [0.0] * 2, animated=True, **arrow_look(theme, unit))

    def _depth(self) -> float:
        """Depth of the labels of metres below the plane [pixels]."""
        radius = self.motion.scenario.hoop.radius * self.view.scale
        return max(0.24 * radius, 0.09 * radius + 13.0 * self.sheet.unit)

    def pose(self, k: int) -> tuple[Poses, int]:
        """Return poses and the index of the k-th picture among them."""
        if self._block != k // BLOCK:
            self._block = k // BLOCK
            self.poses = poses_of(self.motion, self.times[self._block * BLOCK : (self._block + 1) * BLOCK])
            self.speeds = rim_speeds(self.poses, AROUND, self.motion.scenario.hoop.radius)
        return self.poses, k % BLOCK

    def draw_plane(self) -> None:
        """Draw the plane with marks across it, and metres below."""
        sheet, view, unit, step = self.sheet, self.view, self.sheet.unit, self.step
        left, bottom, width, _ = view.rectangle
        here = float(np.mean(view.axes.viewLim.get_points(), axis=0) @ to_world(1.0, 0.0, view.slope))
        reach = 0.5 * float(np.hypot(*view.extent))
        marks = np.arange(math.ceil((here - reach) / step), math.floor((here + reach) / step) + 1) * step
        depths = np.array([0.0, -0.09 * self.motion.scenario.hoop.radius, np.nan])
        self.plane[2].set_data(to_world(np.repeat(marks, 3), np.tile(depths, len(marks)), view.slope).T)
        sheet.draw(*self.plane)
        below = view.pixels(to_world(marks, np.full_like(marks, -self.depth / view.scale), view.slope))
        for mark, (x, y) in zip(marks, below, strict=True):
            words = f"{mark:g} m"
            half = 0.5 * sheet.text_width(words)
            if left + half <= x <= left + width - half and bottom + 0.4 * sheet.size[1] > y > bottom + 10.0 * unit:
                sheet.text(x, y, words, self.theme.muted, "mm")

    def draw(self, k: int) -> None:
        """Draw traces, hoop, forces and events."""
        (poses, i), film, sheet, view = self.pose(k), self.film, self.sheet, self.view
        center, flies = poses.center[i], poses.mode[i] == "H"
        past = int(np.searchsorted(self.trace.t, poses.t[i]))
        if film.look.traces and past:
            heavy, nowhere = poses.gravity_center[i], np.full(2, np.nan)
            ends = (poses.load[i], nowhere if flies else heavy, heavy if flies else nowhere)
            for (path, line), end in zip(self.paths, ends, strict=True):
                line.set_data(*np.vstack([path[max(0, past - TRACE_POINTS) : past], end]).T)
                sheet.draw(line)
        self.hoop.pose(center, float(poses.angle[i]))
        self.hoop.paint(shades_of(self.speeds[i], film.subject.whole.speed), self.theme.background)
        self.heavy.set_facecolor(self.inks[int(flies)])
        sheet.draw(*self.shown)
        if film.look.forces and self.alpha == 1.0:
            forces = np.array([poses.normal_force[i], poses.friction_force[i]]) * film.newton / view.scale
            ways = np.array([bounded(force, LONGEST * film.longest / view.scale) for force in forces])
            ways[np.hypot(*ways.T) * view.scale < 2.5 * sheet.unit] = np.nan
            self.forces.set_offsets([poses.contact[i]] * 2)
            self.forces.set_UVC(*ways.T)
            sheet.draw(self.forces)
        if film.overlay:
            film.head.draw_tag(view.pixels(center), self.row, self.theme.background)
        marks, size = film.subject.past(self.row, k), self.motion.scenario.hoop.radius * view.scale
        spots = view.pixels(np.array([one.place for one in marks]).reshape(-1, 2))
        film.head.draw_marks(k, self.row, marks, spots, size, self.depth + 19.0 * sheet.unit, view.rectangle)


class Film2D:
    """The pictures of a film in 2D: `draw(k)` gives the k-th.

    Parameters
    ----------
    motions : sequence of Trajectory
    timing : Timing
    look : Look

    Raises
    ------
    ValueError
        If labels or times do not fit the motions.
    ImportError
        If Matplotlib is missing.
    """

    def __init__(self, motions: Sequence[Trajectory], timing: Timing, look: Look) -> None:
        self.subject = subject_of(motions, timing, look.labels)
        self.clock, self.count = self.subject.clock, self.subject.clock.count
        self.fps, self.look, self.size, self.theme = timing.frame_rate, look, look.size, THEMES[look.theme]
        self.sheet = Sheet(look.size, self.theme.background)
        self.overlay = look.layout == "overlay" and len(motions) > 1
        self.side = len(motions) > 1 and not self.overlay
        self.head = Head(self.sheet, self.theme, self.subject, look.forces, self.side)
        stage, self.panel_area = self._areas()
        self.actors = [_Actor(self, row, view) for row, view in enumerate(self._views(stage))]
        if self.side:
            self.head.move_to([actor.view.rectangle for actor in self.actors])
        self.longest = min(FORCE_LENGTH * actor.motion.scenario.hoop.radius * actor.view.scale for actor in self.actors)
        self.newton = self.longest / self.subject.whole.force  # length of the arrow of 1 N [pixels]
        self.head.draw_keys(look.traces, self.newton)
        self.panels = Panels(self.sheet, self.panel_area, self.theme, motions[0], look.panels, timing.start, self.subject.end)
        self.sheet.render()
        self.head.draw_labels()
        self._still = self.sheet.pixels.copy()

    def draw(self, k: int) -> Bytes:
        """The k-th picture, height × width × RGBA; valid until the next is drawn.

        k: from 0 to count − 1; picture: shape (height, width, 4), values from 0 to 255 [1].
        """
        self.sheet.pixels[...] = self._still
        for actor in self.actors[:1] if self.overlay else self.actors:
            actor.view.aim(k)
            actor.draw_plane()
        for actor in reversed(self.actors):  # the first of an overlay is on top
            actor.draw(k)
        poses = [actor.pose(k) for actor in self.actors]
        self.head.draw_states(k, poses)
        self.head.draw_pace(k)
        self.panels.draw(float(self.clock.times[0][k]), *poses[0])
        return self.sheet.pixels

    def pixel_of(self, k: int, actor: int, point: Floats) -> Points:
        """Return the position of a point of the world [m] in the k-th picture: column, row from the top left [pixels]."""
        view = self.actors[actor].view
        view.aim(k)
        x, y = view.pixels(np.asarray(point))
        return np.array([x, self.size[1] - y])

    def _areas(self) -> tuple[Rectangle, Rectangle]:
        """The rectangles of the views and of the panels, which are next to them, or below in an upright picture."""
        (width, height), foot = self.size, self.head.foot
        body = height - self.head.head - foot
        wide, high = (round(0.38 * width), body) if width >= 1.1 * height else (width, round(0.5 * body))
        if not self.look.panels:
            return (0.0, foot, width, body), (0.0, foot, 0.0, 0.0)
        if high == body:
            return (0.0, foot, width - wide, body), (width - wide, foot, wide, body)
        return (0.0, foot + high, width, body - high), (0.0, foot, width, high)

    def _views(self, stage: Rectangle) -> list[_View]:
        """One view per motion, or the same for all, in one scale and with their planes at one height."""
        motions, extents, times = self.subject.motions, list(self.subject.extents), self.clock.times
        radii = [motion.scenario.hoop.radius for motion in motions]
        places = [np.asarray(motion.at(t).x) for motion, t in zip(motions, times, strict=True)]
        rectangles = self._grid(stage, len(motions))
        if self.overlay:
            rectangles, extents, radii, places = [stage], [self.subject.whole], [max(radii)], [np.mean(places, axis=0)]
        extents = [replace(size, height=self.subject.whole.height) for size in extents]
        slopes = [motion.scenario.plane.slope for motion in motions]
        cases = list(zip(rectangles, extents, radii, slopes, strict=False))
        scale = min(self._scale(*case) for case in cases)
        views = [
            _View(self.sheet, case[0], scale, case[3], self._corners(*case, scale, along))
            for case, along in zip(cases, places, strict=True)
        ]
        return views * (len(motions) if self.overlay else 1)

    def _grid(self, stage: Rectangle, count: int) -> list[Rectangle]:
        """Rectangles for several views: long paths below each other, following cameras next to each other."""
        left, bottom, width, height = stage
        columns = 1 if self.look.camera == "hold" or width < height else math.ceil(math.sqrt(count))
        rows, gap, head = math.ceil(count / columns), 10.0 * self.sheet.unit, VIEW_HEAD * self.sheet.unit * self.side
        wide, high = (width - gap * (columns - 1)) / columns, (height - gap * (rows - 1)) / rows
        places = [divmod(i, columns) for i in range(count)]
        return [
            (left + column * (wide + gap), bottom + (rows - 1 - row) * (high + gap), wide, high - head)
            for row, column in places
        ]

    def _below(self, rectangle: Rectangle) -> float:
        return max(BELOW * self.sheet.unit, BELOW_SHARE * rectangle[3])

    def _world(self, size: Extent, radius: float, slope: float) -> tuple[Floats, Floats]:
        """The lower left and upper right corners of the whole path [m], or for a following camera those of the hoop."""
        (low, high), top = size.along, size.height + (2.0 + ABOVE) * radius
        if self.look.camera == "follow":
            half = 0.5 * LEAST_WIDTH * radius
            return np.array([-half, 0.0]), np.array([half, top])
        low, high = low - SIDE * radius, high + SIDE * radius
        corners = to_world([low, high, low, high], [0.0, 0.0, top, top], slope)
        return corners.min(axis=0), corners.max(axis=0)

    def _scale(self, rectangle: Rectangle, size: Extent, radius: float, slope: float) -> float:
        """The largest scale of a view [pixels/m]."""
        least, most = self._world(size, radius, slope)
        room = np.array([rectangle[2], rectangle[3] - self._below(rectangle)])
        return float(np.min(room / (most - least)))

    def _corners(self, rectangle: Rectangle, size: Extent, radius: float, slope: float, scale: float, places: Floats) -> Floats:
        """The lower left corner of a view in each frame, or in all; places: of the hoop along the plane [m]."""
        below, (least, most) = self._below(rectangle), self._world(size, radius, slope)
        spare = rectangle[3] - below - scale * (most[1] - least[1])
        corner = np.array([0.5 * rectangle[2], below + 0.3 * max(spare, 0.0)]) / scale
        if self.look.camera == "hold":
            return np.array([[0.5 * (least[0] + most[0]), least[1]] - corner])
        half = corner[0] / math.cos(slope)
        low, high = size.along[0] - SIDE * radius, size.along[1] + SIDE * radius
        if slope == 0.0 and high - low <= 2.0 * half:
            along = np.full(1, 0.5 * (low + high))
        else:
            along = follow(np.arange(len(places)) / self.fps, places, CALM)
            if slope == 0.0:
                along = np.clip(along, low + half, high - half)
            # a fast hoop stays in the picture, and on a slope the plane below it
            room = max(half - SIDE * radius, 0.0)
            if slope != 0.0:
                room = min(room, 0.7 * corner[1] / abs(math.sin(slope)))
            along = np.clip(along, places - room, places + room)
        return to_world(along, np.zeros_like(along), slope) - corner
