"""Films in 2D: pictures of one or several motions, by Matplotlib's artists over a background drawn once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.frames import Clock, Extent, Timing, Trace, clock, event_marks, extent, trace
from hophoop.animate.head import Head, bounded, draw_marks, keys_of, new_arrow, place_arrow
from hophoop.animate.look import FORCE_LENGTH, LONGEST, TAGS, Look, labels_of, nice
from hophoop.animate.panels import Panels
from hophoop.animate.sheet import Bytes, Points, Rectangle, Sheet, shades_of
from hophoop.animate.themes import Theme, theme_of
from hophoop.animate.views import (
    BELOW,
    View,
    following_scale,
    following_view,
    grid,
    labelled_scale,
    labelled_view,
    project,
    whole_path_scale,
    whole_path_view,
)
from hophoop.results.poses import Floats, Poses, part_side, poses_of, rim_speeds, to_world
from hophoop.scenario import Disk, PointMass, Ring, Rod
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors

PIECES = 96  # of the ring, with one colour each
BLOCK = 256  # frames whose poses are computed together
TRACE_POINTS = 6000  # maximum, the last ones
RING, LOAD, HEAVY = 0.05, 0.085, 0.042  # width of the ring, radii of the load and of the centre of gravity, in radii
LABEL_STRIP = 54.0  # least height below the plane, for metres and events [units]
FADE = 0.45  # opacity of all motions in one view except the first
VIEW_HEAD = 68.0  # of the texts of a view [units]


class _Actor:
    """One motion in the film, and its artists in the coordinates of the world."""

    def __init__(self, sheet: Sheet, theme: Theme, motion: Trajectory, times: Floats, view: View, track: Trace) -> None:
        self.sheet, self.theme, self.motion, self.times, self.view, self.trace = sheet, theme, motion, times, view, track
        self.found = event_marks(motion, times)
        self.label = self.tag = ""
        self.alpha = 1.0
        self._block = -1

    def dress(self, label: str, tag: str, alpha: float) -> None:
        """Make the artists."""
        self.label, self.tag, self.alpha = label, tag, alpha
        lines, patches = need("matplotlib.lines", "plots"), need("matplotlib.patches", "plots")
        transforms = need("matplotlib.transforms", "plots")
        collections = need("matplotlib.collections", "plots")
        theme, view, hoop, unit = self.theme, self.view, self.motion.scenario.hoop, self.sheet.unit
        world, self.here = transforms.Affine2D(), transforms.Affine2D()
        self.world, around = world, self.here + world

        def add(artist: Any, transform: Any = world) -> Any:
            artist.set_transform(transform)
            return self.sheet.add(artist, view.rectangle)

        def line(color: str, width: float, opacity: float = 1.0) -> Any:
            return add(lines.Line2D([], [], color=color, lw=width, alpha=opacity))

        def disc(radius: float, color: str, edge: str, width: float) -> Any:
            return add(patches.Circle((0.0, 0.0), radius, fc=color, ec=edge, lw=width, alpha=alpha))

        radius = hoop.radius
        self.ground = add(patches.Polygon(np.zeros((3, 2)), fc=theme.ground, lw=0.0))
        self.edge, self.ticks = line(theme.ink, 1.6), line(theme.muted, 1.2)
        airborne = np.zeros(len(self.trace.t), dtype=bool), np.zeros(len(self.trace.t), dtype=bool)
        for a, b, flies in self.trace.runs:
            airborne[int(flies)][a : b + 1] = True
        heavy = self.trace.gravity_center
        inks = [theme.visible(color) for color in (colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE)]
        self.inks = inks
        self.paths = [(self.trace.load, line(theme.load, 1.7, 0.85 * alpha))]
        self.paths += [
            (np.where(shown[:, None], heavy, np.nan), line(ink, 2.6, alpha)) for shown, ink in zip(airborne, inks, strict=True)
        ]
        self.parts = [add(part, around) for part in self._parts(patches)]
        self.spoke = line(theme.muted, 1.2, 0.7 * alpha)
        width = RING * radius * view.scale / unit
        middle = radius * (1.0 - 0.5 * RING)
        self.outline = add(patches.Circle((0.0, 0.0), middle, fill=False, ec=theme.outline, lw=width + 1.6, alpha=alpha))
        self.around = np.linspace(0.0, 2.0 * math.pi, PIECES, endpoint=False)
        angle = self.around + view.slope
        rim = middle * np.stack([np.sin(angle), np.cos(angle)], axis=-1)
        trios = np.stack([np.roll(rim, 1, axis=0), rim, np.roll(rim, -1, axis=0)], axis=1)  # overlap, to hide seams
        self.place = transforms.Affine2D()
        self.ring = add(collections.LineCollection(trios, linewidths=width), self.place + world)
        self.load = disc(LOAD * radius, theme.load, theme.background, 1.5)
        self.heavy = disc(HEAVY * radius, inks[0], theme.background, 1.2)
        self.arrows = [
            self.sheet.add(new_arrow(theme, color, world), view.rectangle)
            for color in (colors.NORMAL_FORCE, colors.FRICTION_FORCE)
        ]

    def _parts(self, patches: Any) -> list[Any]:
        """The parts of a hoop made of parts, with the centre of the rim at the origin and that of gravity above."""
        theme, hoop, made = self.theme, self.motion.scenario.hoop, []
        for part in sorted(hoop.parts or (), key=lambda part: not isinstance(part, Ring)):
            middle = part_side(hoop) * part.at
            ink, edge = (theme.load, theme.background) if part.mass > 0.0 else (theme.background, theme.load)  # or a hole
            if isinstance(part, Ring):
                thick = max((part.outer_radius - part.inner_radius) * self.view.scale / self.sheet.unit, 1.0)
                mean = 0.5 * (part.inner_radius + part.outer_radius)
                made.append(patches.Circle((0.0, 0.0), mean, fill=False, ec=theme.muted, lw=thick, alpha=0.35 * self.alpha))
            elif isinstance(part, Rod):
                wide, high = 4.0 * self.sheet.unit / self.view.scale, part.length
                if part.direction != "radial":
                    wide, high = high, wide
                corner = -0.5 * wide, middle - 0.5 * high
                made.append(patches.Rectangle(corner, wide, high, fc=ink, lw=0.0, alpha=0.8 * self.alpha))
            elif isinstance(part, Disk | PointMass):
                size, opacity = (part.radius, 0.8) if isinstance(part, Disk) else (LOAD * hoop.radius, 1.0)
                look = {"fc": ink, "ec": edge, "lw": 1.3, "alpha": opacity * self.alpha}
                made.append(patches.Circle((0.0, middle), size, **look))
        return made

    def pose(self, k: int) -> tuple[Poses, int]:
        """Return poses and the index of the k-th picture among them; the artists get its view."""
        if self._block != k // BLOCK:
            self._block = k // BLOCK
            self.poses = poses_of(self.motion, self.times[self._block * BLOCK : (self._block + 1) * BLOCK])
            self.speeds = rim_speeds(self.poses, self.around, self.motion.scenario.hoop.radius)
        self.world.set_matrix(self.view.matrix(k))
        return self.poses, k % BLOCK

    def draw_plane(self, k: int) -> None:
        """Draw the plane with marks across it, and metres below."""
        sheet, view, unit = self.sheet, self.view, self.sheet.unit
        matrix, radius, slope = view.matrix(k), self.motion.scenario.hoop.radius, view.slope
        left, bottom, width, height = view.rectangle
        # the visible part of the plane, along it from the origin of the world
        middle = (np.array([left + 0.5 * width, bottom + 0.5 * height]) - matrix[:2, 2]) / view.scale
        here, reach = float(middle @ to_world(1.0, 0.0, slope)), math.hypot(width, height) / view.scale
        ends = np.array([here - reach, here + reach])
        self.ground.set_xy(to_world(ends[[0, 1, 1, 0]], np.array([0.0, 0.0, -2.0 * reach, -2.0 * reach]), slope))
        self.edge.set_data(*to_world(ends, np.zeros(2), slope).T)
        step = nice(200.0 * unit / view.scale)
        marks = np.arange(math.ceil(ends[0] / step), math.floor(ends[1] / step) + 1) * step
        nowhere = np.full_like(marks, np.nan)
        across = np.column_stack([np.zeros_like(marks), np.full_like(marks, -0.09 * radius), nowhere]).ravel()
        self.ticks.set_data(*to_world(np.repeat(marks, 3), across, slope).T)
        sheet.draw(self.ground, self.edge, self.ticks)
        depth = label_depth(radius * view.scale, unit)
        below = project(matrix, to_world(marks, np.full_like(marks, -depth / view.scale), slope))
        for mark, (x, y) in zip(marks, below, strict=True):
            words = f"{mark:g} m"
            half = 0.5 * sheet.text_width(words)
            if left + half <= x <= left + width - half and bottom + 0.4 * sheet.size[1] > y > bottom + 10.0 * unit:
                sheet.text(x, y, words, self.theme.muted, "mm")

    def draw_hoop(self, k: int, newton: float, longest: float, top_speed: float, traces: bool, forces: bool) -> None:
        """Draw traces, hoop and forces; newton: length of the arrow of 1 N, longest: at most [m]; top_speed [m/s]."""
        poses, i = self.pose(k)
        center, load, heavy = poses.center[i], poses.load[i], poses.gravity_center[i]
        flies, hoop, sheet = poses.mode[i] == "H", self.motion.scenario.hoop, self.sheet
        past = int(np.searchsorted(self.trace.t, poses.t[i]))
        if traces and past:
            nowhere = np.full(2, np.nan)
            for (path, line), end in zip(
                self.paths, (load, nowhere if flies else heavy, heavy if flies else nowhere), strict=True
            ):
                line.set_data(*np.vstack([path[max(0, past - TRACE_POINTS) : past], end]).T)
                sheet.draw(line)
        self.here.clear().rotate(-float(poses.angle[i]) - self.view.slope).translate(*center)
        self.place.clear().translate(*center)
        sheet.draw(*self.parts)
        if hoop.parts is None:
            self.spoke.set_data(*np.array([center, load]).T)
            sheet.draw(self.spoke)
        self.outline.set_center(center)
        shades = shades_of(self.speeds[i], top_speed)[:, :3]
        back = np.array([int(self.theme.background[j : j + 2], 16) / 255.0 for j in (1, 3, 5)])
        self.ring.set_color(self.alpha * shades + (1.0 - self.alpha) * back)  # pieces overlap: opacity would add up
        sheet.draw(self.outline, self.ring)
        if hoop.parts is None:
            self.load.set_center(load)
            sheet.draw(self.load)
        self.heavy.set_center(heavy)
        self.heavy.set_facecolor(self.inks[int(flies)])
        sheet.draw(self.heavy)
        if forces and self.alpha == 1.0:
            for arrow, force in zip(self.arrows, (poses.normal_force[i], poses.friction_force[i]), strict=True):
                place_arrow(arrow, poses.contact[i], bounded(force * newton, longest), sheet.unit / self.view.scale)
                sheet.draw(arrow)
        if self.tag:
            spot = project(self.view.matrix(k), center)
            sheet.dot(spot, 26.0, self.theme.background, self.theme.ink, 1.2)
            sheet.text(float(spot[0]), float(spot[1]), self.tag, self.theme.ink, "mm", bold=True)

    def draw_events(self, k: int, rate: float, still: float) -> None:
        """Draw the marks of events; rate: of the motion per time of film [1]; still: time of the final pause [s of film]."""
        matrix, size = self.view.matrix(k), self.motion.scenario.hoop.radius * self.view.scale
        past = [one for one in self.found if one.t <= self.times[k]]
        ages = [(float(self.times[k]) - one.t) / rate + still for one in past]
        spots = [project(matrix, one.place) for one in past]
        depth = label_depth(size, self.sheet.unit) + 19.0 * self.sheet.unit
        draw_marks(self.sheet, self.theme, [one.kind for one in past], spots, ages, size, depth, self.view.rectangle)


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
        self.clock: Clock = clock(motions, timing)
        self.fps, self.look, self.size = timing.frame_rate, look, look.size
        self.count = self.clock.count
        self.theme: Theme = theme_of(look.theme)
        self.sheet = Sheet(look.size, self.theme.background)
        labels = labels_of(motions, look.labels)
        ends = [min(float(times[-1]), motion.duration) for times, motion in zip(self.clock.times, motions, strict=True)]
        extents = [extent(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True)]
        self.top_speed = max(size.speed for size in extents) or 1.0
        self.force = max(size.force for size in extents) or 1.0
        traces = [trace(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True)]
        found = [one for motion, times in zip(motions, self.clock.times, strict=True) for one in event_marks(motion, times)]
        self.overlay = look.layout == "overlay" and len(motions) > 1
        self.side = len(motions) > 1 and not self.overlay
        self.keys = keys_of(self.theme, traces if look.traces else (), found)
        head = Head(self.sheet, self.theme, self.clock, self.keys, () if self.side else labels, self.overlay)
        self.head, self.layout = head, head.lay_out(look.forces)
        views = self._views(self._stage(), motions, extents)
        self.actors = [
            _Actor(self.sheet, self.theme, motion, self.clock.times[i], views[i], traces[i]) for i, motion in enumerate(motions)
        ]
        for i, actor in enumerate(self.actors):
            actor.dress(labels[i], TAGS[i % len(TAGS)] if self.overlay else "", FADE if self.overlay and i else 1.0)
        self._full = min(FORCE_LENGTH * actor.motion.scenario.hoop.radius * actor.view.scale for actor in self.actors)
        self.newton = self._full / self.force
        self.panels = Panels(self.sheet, self._panel_area, self.theme, motions[0], look.panels, timing.start, max(ends))
        head.draw_keys(self.top_speed, self.newton, self.force)
        self._draw_labels()
        self.sheet.keep()

    def draw(self, k: int) -> Bytes:
        """The k-th picture, height × width × RGBA; valid until the next is drawn.

        k: from 0 to count − 1; picture: shape (height, width, 4), values from 0 to 255 [1].
        """
        self.sheet.restore()
        look, rate, still = self.look, float(self.clock.rate[k]), float(self.clock.still[k])
        for actor in self.actors[:1] if self.overlay else self.actors:
            actor.pose(k)
            actor.draw_plane(k)
        for actor in reversed(self.actors):  # the first of an overlay is on top
            newton = self.newton / actor.view.scale
            longest = LONGEST * self._full / actor.view.scale
            actor.draw_hoop(k, newton, longest, self.top_speed, look.traces, look.forces)
            actor.draw_events(k, rate, still)
        for row, actor in enumerate(self.actors):
            self._draw_state(actor, k, row)
        self.head.draw_pace(k)
        poses, i = self.actors[0].pose(k)
        self.panels.draw(float(self.actors[0].times[k]), poses, i)
        return self.sheet.pixels

    def pixel_of(self, k: int, actor: int, point: Floats) -> Points:
        """Return the position of a point of the world [m] in the k-th picture: column, row from the top left [pixels]."""
        x, y = project(self.actors[actor].view.matrix(k), np.asarray(point))
        return np.array([x, self.size[1] - y])

    # --- layout --------------------------------------------------------------------------------

    def _stage(self) -> Rectangle:
        """The rectangle of the views; the panels are next to it, or below it in an upright picture."""
        width, height = self.size
        foot = self.layout.foot
        body = height - self.layout.head - foot
        if not self.look.panels:
            self._panel_area: Rectangle = (0.0, 0.0, 0.0, 0.0)
            return 0.0, foot, width, body
        if width >= 1.1 * height:
            share = round(0.38 * width)
            self._panel_area = (width - share, foot, share, body)
            return 0.0, foot, width - share, body
        share = round(0.5 * body)
        self._panel_area = (0.0, foot, width, share)
        return 0.0, foot + share, width, body - share

    def _views(self, stage: Rectangle, motions: Sequence[Trajectory], extents: Sequence[Extent]) -> list[View]:
        head, radii = VIEW_HEAD * self.sheet.unit * self.side, [motion.scenario.hoop.radius for motion in motions]
        places = [np.asarray(motion.at(self.clock.times[i]).x) for i, motion in enumerate(motions)]
        highest = max(size.height for size in extents)
        if self.overlay:
            along = min(size.along[0] for size in extents), max(size.along[1] for size in extents)
            whole = Extent(along, highest, self.top_speed, self.force)
            rectangles, extents, radii = [stage], [whole], [max(radii)]
            places = [np.mean(places, axis=0)]
        else:
            wanted = 1.5
            if self.look.camera == "hold":
                pairs = zip(extents, radii, strict=True)
                wanted = max((size.along[1] - size.along[0] + 2.7 * r) / (size.height + 3.0 * r) for size, r in pairs)
            rectangles = [
                (left, bottom, width, height - head)
                for left, bottom, width, height in grid(stage, len(motions), wanted, 10.0 * self.sheet.unit)
            ]
        cases = list(zip(rectangles, extents, radii, motions, strict=False))
        # one scale for all views, and their planes at one height
        scale = min(self._scale(*case) for case in cases)
        views = [
            self._view(rectangle, replace(size, height=highest), radius, motion, scale, places[i])
            for i, (rectangle, size, radius, motion) in enumerate(cases)
        ]
        return views * len(motions) if self.overlay else views

    def _scale(self, rectangle: Rectangle, size: Extent, radius: float, motion: Trajectory) -> float:
        def scale_of(inner: Rectangle) -> float:
            if self.look.camera == "hold":
                return whole_path_scale(inner, size, radius, motion.scenario.plane.slope)
            return following_scale(inner, size, radius)

        return labelled_scale(scale_of, rectangle, radius, LABEL_STRIP * self.sheet.unit)

    def _view(
        self, rectangle: Rectangle, size: Extent, radius: float, motion: Trajectory, scale: float, places: Floats
    ) -> View:
        slope = motion.scenario.plane.slope

        def view_of(inner: Rectangle) -> View:
            if self.look.camera == "hold":
                return whole_path_view(inner, size, radius, slope, scale)
            return following_view(inner, size, radius, slope, scale, places, self.fps)

        return labelled_view(view_of, rectangle, LABEL_STRIP * self.sheet.unit - BELOW * radius * scale)

    # --- words ---------------------------------------------------------------------------------

    def _draw_labels(self) -> None:
        """Write the labels of the views, which do not change."""
        sheet, u = self.sheet, self.sheet.unit
        for actor in self.actors if not self.overlay else ():
            left, bottom, wide, high = actor.view.rectangle
            place, room = (22.0 * u, sheet.size[1] - 28.0 * u), self.layout.words[2]
            if self.side:
                place, room = (left + 22.0 * u, bottom + high + 42.0 * u), wide - 30.0 * u
            sheet.text(*place, sheet.shortened(actor.label, room), self.theme.muted)

    def _draw_state(self, actor: _Actor, k: int, row: int) -> None:
        u, (poses, i) = self.sheet.unit, actor.pose(k)
        left, bottom, width, height = actor.view.rectangle
        extra = f"v = {poses.velocity[i, 0]:.2f} m/s"
        place, room = (22.0 * u, self.size[1] - 60.0 * u), self.layout.words[2]
        if self.side:
            place, room = (left + 22.0 * u, bottom + height + 10.0 * u), width - 30.0 * u
        elif self.overlay:
            place, extra = (22.0 * u, self.size[1] - (32.0 + 32.0 * row) * u), actor.label
        self.head.draw_state(place, k, actor.motion, poses, i, extra, actor.tag, room)


def label_depth(radius: float, unit: float) -> float:
    """Depth of the labels of metres below the plane, for a radius in pixels [pixels]."""
    return max(0.24 * radius, 0.09 * radius + 13.0 * unit)
