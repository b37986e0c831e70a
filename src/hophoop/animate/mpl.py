"""Films in 2D: pictures of one or several motions, by Matplotlib's Agg renderer."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from hophoop.animate.canvas import Bytes, Canvas, Points, Rectangle, TextStyle
from hophoop.animate.event_marks import EventMark, ShownMark, draw_event_marks, event_marks, label_event_marks
from hophoop.animate.frames import Clock, Extent, Timing, Trace, clock, end_word, extent, trace
from hophoop.animate.layout import FONT, LABEL_BASE, ONE_HEAD, ROW, ROW_HEAD, Layout, lay_out, state_width
from hophoop.animate.look import Look, labels_of, nice
from hophoop.animate.panels import Panels
from hophoop.animate.parts import LOAD, draw_parts
from hophoop.animate.scaling import arrow, force_levels
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
from hophoop.animate.words import (
    StateLine,
    draw_force_key,
    draw_keys,
    draw_label,
    draw_pace,
    draw_state,
    draw_tag,
    line_keys,
    longest_pace,
    minus,
    shades_of,
    speed_words,
)
from hophoop.results.poses import Floats, Poses, poses_of, rim_speeds, to_world
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors

PIECES = 96  # of the ring, with one colour each
BLOCK = 256  # frames whose poses are computed together
TRACE_POINTS = 6000  # maximum, the last ones
# Length of the arrow of the maximum force, in radii
FORCE_LENGTH = 1.3
RING = 0.05  # width in radii
LABEL_STRIP = 54.0  # least height below the plane, for metres and events [units]
FADE = 0.45  # opacity of all motions in one view except the first
TAGS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"  # of motions in one view
VIEW_HEAD = 68.0  # of the texts of a view [units]


@dataclass
class _Actor:
    """One motion in the film, with the data of its drawing."""

    motion: Trajectory
    times: Floats
    label: str
    extent: Extent
    trace: Trace
    view: View
    alpha: float
    found: list[EventMark]
    tag: str
    block: int = -1
    poses: Poses | None = None
    speeds: Floats | None = None


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
        self.fps = timing.frame_rate
        self.look = look
        self.theme: Theme = theme_of(look.theme)
        self.canvas = Canvas(look.size, self.theme.background)
        labels = labels_of(motions, look.labels)
        ends = [min(float(times[-1]), motion.duration) for times, motion in zip(self.clock.times, motions, strict=True)]
        extents = [extent(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True)]
        self.top_speed = max((size.speed for size in extents), default=0.0) or 1.0
        self._force = max(size.force for size in extents) or 1.0
        self._around = np.linspace(0.0, 2.0 * math.pi, PIECES, endpoint=False)
        traces = [trace(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True)]
        self._keys = line_keys(look.traces, any(airborne for track in traces for _, _, airborne in track.runs))
        stage = self._lay_out(labels)
        views = self._views(stage, motions, extents)
        overlay = look.layout == "overlay" and len(motions) > 1
        self.actors = [
            _Actor(
                motion=motion,
                times=self.clock.times[i],
                label=labels[i],
                extent=extents[i],
                trace=traces[i],
                view=views[i],
                alpha=FADE if overlay and i else 1.0,
                found=event_marks(motion, self.clock.times[i]),
                tag=TAGS[i % len(TAGS)] if overlay else "",
            )
            for i, motion in enumerate(motions)
        ]
        self._full = min(FORCE_LENGTH * actor.motion.scenario.hoop.radius * actor.view.scale for actor in self.actors)
        self.force_levels = force_levels(motions, self.clock, self.fps, self._force)
        self.panels = Panels(self.canvas, self._panel_area, self.theme, motions, look.panels, timing.start, max(ends))
        self._draw_heading()
        self._background: Bytes = self.canvas.pixels.copy()

    @property
    def count(self) -> int:
        """Number of pictures."""
        return self.clock.count

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.look.size

    def draw(self, k: int) -> Bytes:
        """The k-th picture, height × width × RGBA; valid until the next is drawn.

        k: from 0 to count − 1; picture: shape (height, width, 4), values from 0 to 255 [1].
        """
        canvas = self.canvas
        canvas.restore(self._background)
        overlay = self.look.layout == "overlay"
        for i, actor in enumerate(self.actors):
            self._prepare(actor, k)
            if i == 0 or not overlay:
                canvas.clip(actor.view.rectangle)
                self._draw_plane(actor, k)
                canvas.clip(None)
        # the first of an overlay is on top
        seen: list[ShownMark] = []
        for actor in reversed(self.actors):
            canvas.clip(actor.view.rectangle)
            self._draw_hoop(actor, k)
            seen += self._draw_event_marks(actor, k)
            if not overlay or actor is self.actors[0]:
                _, below = self._label_depths(actor.motion.scenario.hoop.radius * actor.view.scale)
                left, _, width, _ = actor.view.rectangle
                label_event_marks(canvas, self.theme, seen, below, (left, width))
                seen = []
            canvas.clip(None)
        for i, actor in enumerate(self.actors):
            self._draw_words(actor, k, i if overlay else 0)
        if self.look.forces:
            draw_force_key(canvas, self.theme, self.layout, self.newton(k), float(self.force_levels[k]))
        draw_pace(canvas, self.theme, self.layout, float(self.clock.rate[k]))
        self.panels.draw([(actor.times[k], actor.poses, k % BLOCK) for actor in self.actors])
        return canvas.pixels

    def newton(self, k: int) -> float:
        """Length of the arrow of 1 N in the k-th picture [pixels]."""
        return float(self._full / self.force_levels[k])

    def pixel_of(self, k: int, actor: int, point: Floats) -> Points:
        """Return the position of a point of the world [m] in the k-th picture: column, row from the top left [pixels]."""
        x, y = project(self.actors[actor].view.matrix(k), np.asarray(point))
        return np.array([x, self.look.size[1] - y])

    # --- layout --------------------------------------------------------------------------------

    def _lay_out(self, labels: Sequence[str]) -> Rectangle:
        width, height = self.look.size
        canvas, u = self.canvas, self.canvas.unit
        self._view_head = VIEW_HEAD * u if len(labels) > 1 and self.look.layout == "side" else 0.0
        if len(labels) == 1:
            words = [canvas.text_width(labels[0], FONT), state_width(canvas, "v = −10.00 m/s")]
            high = ONE_HEAD * u
        elif self.look.layout == "side":
            words, high = [], 0.0
        else:
            words = [state_width(canvas, label) for label in labels]
            high = (ROW_HEAD + ROW * (len(labels) - 1)) * u
        keys = [word for _, word in self._keys]
        self.layout: Layout = lay_out(canvas, words, high, self.look.forces, keys, longest_pace(self.clock.rate))
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
        look, gap = self.look, 10.0 * self.canvas.unit
        if look.layout == "overlay":
            radius = max(motion.scenario.hoop.radius for motion in motions)
            whole = Extent(
                (min(size.along[0] for size in extents), max(size.along[1] for size in extents)),
                max(size.height for size in extents),
                self.top_speed,
                self._force,
            )
            left, bottom, width, height = stage
            inner = (left, bottom, width, height - self._view_head)
            places = np.mean([self._places(motion, i) for i, motion in enumerate(motions)], axis=0)
            scale = self._scale(inner, whole, radius, motions[0])
            return [self._view(inner, whole, radius, motions[0], scale, places)] * len(motions)
        if look.camera == "hold":
            wanted = max(
                (size.along[1] - size.along[0] + 2.7 * m.scenario.hoop.radius) / (size.height + 3.0 * m.scenario.hoop.radius)
                for size, m in zip(extents, motions, strict=True)
            )
        else:
            wanted = 1.5
        rectangles = [
            (left, bottom, width, height - self._view_head)
            for left, bottom, width, height in grid(stage, len(motions), wanted, gap)
        ]
        cases = list(zip(rectangles, extents, (motion.scenario.hoop.radius for motion in motions), motions, strict=True))
        # one scale for all views, and their planes at one height
        scale = min(self._scale(*case) for case in cases)
        highest = max(size.height for size in extents)
        return [
            self._view(rectangle, replace(size, height=highest), radius, motion, scale, self._places(motion, i))
            for i, (rectangle, size, radius, motion) in enumerate(cases)
        ]

    def _scale(self, rectangle: Rectangle, size: Extent, radius: float, motion: Trajectory) -> float:
        def scale_of(inner: Rectangle) -> float:
            if self.look.camera == "hold":
                return whole_path_scale(inner, size, radius, motion.scenario.plane.slope)
            return following_scale(inner, size, radius)

        return labelled_scale(scale_of, rectangle, radius, LABEL_STRIP * self.canvas.unit)

    def _view(
        self, rectangle: Rectangle, size: Extent, radius: float, motion: Trajectory, scale: float, places: Floats
    ) -> View:
        slope = motion.scenario.plane.slope

        def view_of(inner: Rectangle) -> View:
            if self.look.camera == "hold":
                return whole_path_view(inner, size, radius, slope, scale)
            return following_view(inner, size, radius, slope, scale, places, self.fps)

        return labelled_view(view_of, rectangle, LABEL_STRIP * self.canvas.unit - BELOW * radius * scale)

    def _places(self, motion: Trajectory, i: int) -> Floats:
        return np.asarray(motion.at(self.clock.times[i]).x)

    def _prepare(self, actor: _Actor, k: int) -> None:
        if actor.block != k // BLOCK:
            actor.block = k // BLOCK
            actor.poses = poses_of(actor.motion, actor.times[actor.block * BLOCK : (actor.block + 1) * BLOCK])
            actor.speeds = rim_speeds(actor.poses, self._around, actor.motion.scenario.hoop.radius)

    # --- what moves ----------------------------------------------------------------------------

    def _draw_plane(self, actor: _Actor, k: int) -> None:
        canvas, theme, view = self.canvas, self.theme, actor.view
        matrix = view.matrix(k)
        radius, slope = actor.motion.scenario.hoop.radius, view.slope
        left, bottom, width, height = view.rectangle
        # the visible part of the plane, along it from the origin of the world
        middle = (np.array([left + 0.5 * width, bottom + 0.5 * height]) - matrix[:2, 2]) / view.scale
        here = float(middle @ to_world(1.0, 0.0, slope))
        reach = math.hypot(width, height) / view.scale
        edge = to_world([here - reach, here + reach], [0.0, 0.0], slope)
        deep = to_world([here + reach, here - reach], [-2.0 * reach, -2.0 * reach], slope)
        canvas.polygon(project(matrix, np.vstack([edge, deep])), theme.ground)
        canvas.line(project(matrix, edge), theme.ink, 1.6)
        step = nice(200.0 * canvas.unit / view.scale)
        first, last = math.ceil((here - reach) / step), math.floor((here + reach) / step)
        marks = np.arange(first, last + 1) * step
        tops = project(matrix, to_world(marks, np.zeros_like(marks), slope))
        ends = project(matrix, to_world(marks, np.full_like(marks, -0.09 * radius), slope))
        depth, events_depth = self._label_depths(radius * view.scale)
        below = project(matrix, to_world(marks, np.full_like(marks, -depth / view.scale), slope))
        taken = np.array([one.along for one in actor.found if one.t <= actor.times[k]])
        for place, top, end, under in zip(marks, tops, ends, below, strict=True):
            if left - 40 < top[0] < left + width + 40:
                canvas.line(np.array([top, end]), theme.muted, 1.2)
                apart = float(np.min(np.abs(taken - place), initial=np.inf)) * view.scale
                words = minus(f"{place:g} m")
                half = 0.5 * canvas.text_width(words, FONT)
                inside = left + half <= under[0] <= left + width - half
                # not under the mark of an event
                if inside and events_depth > depth and apart > half + 9.0 * canvas.unit:
                    canvas.text(under[0], under[1], words, TextStyle(theme.muted, FONT, "center", vertical="center"))

    def _label_depths(self, radius: float) -> tuple[float, float]:
        """Depths of the labels of metres and of events below the plane, for a radius in pixels [pixels]."""
        u = self.canvas.unit
        metres = max(0.24 * radius, 0.09 * radius + 13.0 * u)
        return metres, max(0.42 * radius, metres + 21.0 * u)

    def _draw_hoop(self, actor: _Actor, k: int) -> None:
        poses, speeds, view, theme, canvas = actor.poses, actor.speeds, actor.view, self.theme, self.canvas
        assert poses is not None
        assert speeds is not None
        i = k % BLOCK
        matrix = view.matrix(k)
        hoop = actor.motion.scenario.hoop
        size = hoop.radius * view.scale
        width = RING * size / canvas.unit
        alpha = actor.alpha
        center = project(matrix, poses.center[i])
        load, heavy, contact = (project(matrix, points[i]) for points in (poses.load, poses.gravity_center, poses.contact))
        if self.look.traces:
            self._draw_traces(actor, poses, i, matrix)
        airborne = poses.mode[i] == "H"
        heavy_color = theme.visible(colors.GRAVITY_CENTER_AIRBORNE if airborne else colors.GRAVITY_CENTER)
        if hoop.parts is not None:
            draw_parts(canvas, theme, hoop, center, float(poses.angle[i]) + view.slope, view.scale, alpha)
        else:
            canvas.line(np.array([center, load]), theme.muted, 1.2, 0.7 * alpha)
        # the ring is inside the rim, so that its outer edge touches the plane
        angle = self._around + view.slope
        outer = np.stack([np.sin(angle), np.cos(angle)], axis=-1)
        shades = shades_of(speeds[i], self.top_speed)
        shades[:, 3] = alpha
        line = size * (1.0 - 0.5 * RING)
        canvas.disc(center, line, None, theme.outline, width + 1.6, alpha)
        if alpha == 1.0:
            canvas.segments(center + line * outer, shades, width)
        else:
            canvas.segments(center + line * outer, self._blend(shades, alpha), width)
        if hoop.parts is None:
            canvas.disc(load, LOAD * size, theme.load, theme.background, 1.5, alpha)
        canvas.disc(heavy, 0.042 * size, heavy_color, theme.background, 1.2, alpha)
        if self.look.forces:
            for force, color in (
                (poses.normal_force[i], colors.NORMAL_FORCE),
                (poses.friction_force[i], colors.FRICTION_FORCE),
            ):
                if alpha == 1.0:
                    way = arrow(force, self.newton(k), self._full)
                    canvas.arrow(contact, contact + way, theme.visible(color), theme.background, 7.0)
        if actor.tag:
            draw_tag(canvas, theme, center, actor.tag)

    def _draw_event_marks(self, actor: _Actor, k: int) -> list[ShownMark]:
        matrix = actor.view.matrix(k)
        size = actor.motion.scenario.hoop.radius * actor.view.scale
        now = float(actor.times[k]), float(self.clock.rate[k]), float(self.clock.still[k])
        _, below = self._label_depths(size)
        return draw_event_marks(self.canvas, self.theme, actor.found, now, lambda place: project(matrix, place), size, below)

    def _blend(self, shades: Floats, alpha: float) -> Floats:
        # pieces of the ring overlap, and opacity would add up: blend with the background instead
        back = np.array([int(self.theme.background[j : j + 2], 16) / 255.0 for j in (1, 3, 5)])
        mixed = shades.copy()
        mixed[:, :3] = alpha * shades[:, :3] + (1.0 - alpha) * back
        mixed[:, 3] = 1.0
        return mixed

    def _draw_traces(self, actor: _Actor, poses: Poses, i: int, matrix: Points) -> None:
        canvas, track = self.canvas, actor.trace
        past = int(np.searchsorted(track.t, poses.t[i]))
        first = max(0, past - TRACE_POINTS)
        if past == 0:
            return
        path = np.vstack([track.load[first:past], poses.load[i : i + 1]])
        canvas.line(path, self.theme.load, 1.7, 0.85 * actor.alpha, matrix=matrix)
        for a, b, airborne in track.runs:
            if a >= past or b <= first:
                continue
            part = track.gravity_center[max(a, first) : min(b + 1, past)]
            if b + 1 > past or b == len(track.t) - 1:
                part = np.vstack([part, poses.gravity_center[i : i + 1]])
            color = colors.GRAVITY_CENTER_AIRBORNE if airborne else colors.GRAVITY_CENTER
            canvas.line(part, self.theme.visible(color), 2.6, actor.alpha, matrix=matrix)

    # --- words ---------------------------------------------------------------------------------

    def _draw_words(self, actor: _Actor, k: int, row: int) -> None:
        u, poses = self.canvas.unit, actor.poses
        assert poses is not None
        left, bottom, width, height = actor.view.rectangle
        several = len(self.actors) > 1
        if several and self.look.layout == "side":
            place = left + 22.0 * u, bottom + height + 10.0 * u
        else:
            place = 22.0 * u, self.look.size[1] - ((ROW_HEAD - 10.0 if several else ONE_HEAD - 6.0) + ROW * row) * u
        i, overlay = k % BLOCK, several and self.look.layout == "overlay"
        line = StateLine(
            str(poses.words[i]),
            float(poses.t[i]),
            float(poses.angle[i]),
            extra=actor.label if overlay else speed_words(poses, i),
            end=end_word(actor.motion, float(actor.times[k]), k in (0, self.count - 1)),
            tag=actor.tag,
        )
        room = width - 30.0 * u if several and not overlay else self.layout.words[2]
        draw_state(self.canvas, self.theme, place, line, room)

    def _draw_heading(self) -> None:
        """Draw the constant labels and keys."""
        canvas, theme, u = self.canvas, self.theme, self.canvas.unit
        if len(self.actors) == 1:
            place = 22.0 * u, self.look.size[1] - LABEL_BASE * u
            draw_label(canvas, theme, place, self.actors[0].label, self.layout.words[2])
        elif self.look.layout == "side":
            for actor in self.actors:
                left, bottom, wide, high = actor.view.rectangle
                draw_label(canvas, theme, (left + 22.0 * u, bottom + high + 42.0 * u), actor.label, wide - 30.0 * u)
        draw_keys(canvas, theme, self.layout, self.top_speed, self._keys)
