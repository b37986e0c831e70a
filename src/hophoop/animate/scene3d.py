"""Films in 3D: a torus, a sphere, their shadows, traces and arrows, rendered by VTK without a display."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from types import TracebackType
from typing import Any, Self

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.canvas import Bytes, Canvas
from hophoop.animate.event_marks import EventMark, draw_event_marks, event_marks, label_event_marks
from hophoop.animate.frames import Extent, Timing, Trace, clock, end_word, extent, follow, trace
from hophoop.animate.layout import FONT, LABEL_BASE, ONE_HEAD, ROW, ROW_HEAD, Layout, lay_out, state_width
from hophoop.animate.look import Look3D, labels_of
from hophoop.animate.plane3d import draw_distances, half_track, mark_step, plane_meshes
from hophoop.animate.scaling import arrow, force_levels
from hophoop.animate.shapes3d import (
    FORCE_LENGTH,
    HEAVY,
    LANE,
    LOAD,
    SECTIONS,
    SUN,
    TUBE,
    frame,
    mix,
    pieces,
    place_3d,
    shadow_matrix,
    shift,
    torus,
    torus_faces,
)
from hophoop.animate.themes import Theme, theme_of
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
    shades_of,
    speed_words,
)
from hophoop.results.poses import Floats, Poses, poses_of, rim_speeds, to_world
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors

SMOOTH = 4  # samples per pixel
CALM = 0.6  # smoothing of the camera [s of film]
ANGLE = 30.0  # of the view, from its lower to its upper edge [°]
FARTHEST = 1.7  # marks of the plane with a number, over the distance of the focal point
TAGS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"  # of several motions


@dataclass
class _Actor:
    """One motion in the scene, with its moving meshes."""

    motion: Trajectory
    poses: Poses
    label: str
    trace: Trace
    lane: float
    speeds: Floats
    found: list[EventMark]
    tag: str
    meshes: dict[str, Any]
    actors: dict[str, Any]


class Film3D:
    """The pictures of a film in 3D: `draw(k)` gives the k-th. Close it, or use it in a with statement.

    Parameters
    ----------
    motions : sequence of Trajectory
    timing : Timing
    look : Look3D

    Raises
    ------
    ValueError
        If labels or times do not fit the motions, or their slopes differ.
    ImportError
        If PyVista is missing.
    OSError
        If VTK finds no OpenGL, not even in software.
    """

    def __init__(self, motions: Sequence[Trajectory], timing: Timing, look: Look3D) -> None:
        self.clock = clock(motions, timing)
        self.fps, self.look = timing.frame_rate, look
        self.theme: Theme = theme_of(look.theme)
        slopes = {motion.scenario.plane.slope for motion in motions}
        if len(slopes) > 1:
            raise InputError.of_field("plane.slope", sorted(slopes), "the same in all motions of one scene")
        self._slope = slopes.pop()
        self._pyvista = need("pyvista", "films3d")
        self.canvas = Canvas(look.size, self.theme.background)
        labels = labels_of(motions, look.labels)
        ends = [min(float(t[-1]), motion.duration) for t, motion in zip(self.clock.times, motions, strict=True)]
        extents = [extent(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True)]
        self._radius = max(motion.scenario.hoop.radius for motion in motions)
        self.extent = Extent(
            (min(size.along[0] for size in extents), max(size.along[1] for size in extents)),
            max(size.height for size in extents),
            max(size.speed for size in extents) or 1.0,
            max(size.force for size in extents) or 1.0,
        )
        self.force_levels = force_levels(motions, self.clock, self.fps, self.extent.force)
        self._open()
        self._light()
        self._flat = shadow_matrix(self._slope, 0.002 * self._radius)
        ground = self.theme.ground if look.theme != "print" else "#F4F4F4"
        self._shade = mix(ground, "#000000", 0.38)
        for sheet in plane_meshes(
            self._pyvista, self.theme, ground, self.extent.along, self._radius, self._slope, len(motions)
        ):
            self._add(sheet.mesh, sheet.color, lit=False, **sheet.options)
        _, _, angles = torus(1.0, TUBE)
        self.actors = []
        for i, motion in enumerate(motions):
            poses = poses_of(motion, self.clock.times[i])
            self.actors.append(
                _Actor(
                    motion=motion,
                    poses=poses,
                    label=labels[i],
                    trace=trace(motion, timing.start, ends[i]),
                    lane=LANE * self._radius * (i - 0.5 * (len(motions) - 1)),
                    # the torus does not rotate: its points have the colours of the speed there
                    speeds=rim_speeds(poses, angles - self._slope, motion.scenario.hoop.radius),
                    found=event_marks(motion, self.clock.times[i]),
                    tag=TAGS[i % len(TAGS)] if len(motions) > 1 else "",
                    meshes={},
                    actors={},
                )
            )
            self._build_hoop(self.actors[-1])
        self._path = self._camera_path()
        flies = any(airborne for actor in self.actors for _, _, airborne in actor.trace.runs)
        self._keys = line_keys(look.traces, flies)
        self.layout = self._lay_out(labels)

    # --- the sequence of pictures --------------------------------------------------------------

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
        for actor in self.actors:
            self._move(actor, k)
        camera = self._plotter.camera
        camera.position, camera.focal_point = (tuple(row[min(k, len(row) - 1)]) for row in self._path)
        self._plotter.renderer.ResetCameraClippingRange()
        self._window.Render()
        width, height = self.look.size
        self._window.GetPixelData(0, 0, width - 1, height - 1, 1, self._buffer, 0)
        self.canvas.pixels[..., :3] = self._picture.reshape(height, width, 3)[::-1]
        self.canvas.pixels[..., 3] = 255
        self._draw_words(k)
        return self.canvas.pixels

    def newton(self, k: int) -> float:
        """Length of the arrow of 1 N in the k-th picture [m]."""
        return float(FORCE_LENGTH * self._radius / self.force_levels[k])

    def pixel_of(self, k: int, actor: int, point: Floats) -> Floats:
        """Return the position of a point of the world [m] in the k-th picture: column, row from the top left [pixels]."""
        camera = self._plotter.camera
        camera.position, camera.focal_point = (tuple(row[min(k, len(row) - 1)]) for row in self._path)
        x, y = self._display(np.asarray(point), self.actors[actor].lane)
        return np.array([x, self.look.size[1] - y])

    def _display(self, point: Floats, lane: float) -> Floats:
        """Return the position of a point of the world in the view, from the lower left [pixels]."""
        renderer = self._plotter.renderer
        renderer.SetWorldPoint(*place_3d(point, lane), 1.0)
        renderer.WorldToDisplay()
        return np.array(renderer.GetDisplayPoint()[:2])

    def _metre(self, k: int) -> float:
        """Length of a metre at the focal point [pixels]."""
        position, focus = (row[min(k, len(row) - 1)] for row in self._path)
        away = float(np.linalg.norm(position - focus))
        return float(self.look.size[1] / (2.0 * away * math.tan(math.radians(0.5 * ANGLE))))

    def close(self) -> None:
        """Free the renderer."""
        self._plotter.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, where: TracebackType | None) -> None:
        self.close()

    # --- the scene -----------------------------------------------------------------------------

    def _open(self) -> None:
        logger = need("vtkmodules.vtkCommonCore", "films3d").vtkLogger
        support = need("vtkmodules.util.numpy_support", "films3d")
        array = need("vtkmodules.vtkCommonCore", "films3d").vtkUnsignedCharArray
        before = logger.GetCurrentVerbosityCutoff()
        # without a display VTK warns, and renders in software
        logger.SetStderrVerbosity(logger.VERBOSITY_ERROR)
        try:
            self._plotter = self._pyvista.Plotter(off_screen=True, window_size=list(self.look.size), lighting="none")
            self._window = self._plotter.render_window
            self._window.SetMultiSamples(SMOOTH)
            self._window.Render()
        finally:
            logger.SetStderrVerbosity(before)
        if not self._window.SupportsOpenGL():
            raise OSError("VTK finds no OpenGL, not even in software; on Debian, libegl1 or libosmesa6 has it.")
        self._buffer = array()
        self._buffer.SetNumberOfComponents(3)
        self._buffer.SetNumberOfTuples(self.look.size[0] * self.look.size[1])
        self._picture = support.vtk_to_numpy(self._buffer)
        sky = self.theme.background if self.theme.dark else "#DCE6EE"
        self._plotter.set_background(self.theme.background, top=sky if self.look.theme != "print" else None)

    def _light(self) -> None:
        pyvista = self._pyvista
        sun = pyvista.Light(position=tuple(-10.0 * SUN), focal_point=(0.0, 0.0, 0.0), intensity=0.75)
        sun.positional = False
        self._plotter.add_light(sun)
        self._plotter.add_light(pyvista.Light(light_type="headlight", intensity=0.45))

    def _add(self, mesh: Any, color: str | None, lit: bool = True, **options: Any) -> Any:
        return self._plotter.add_mesh(
            mesh,
            color=color,
            lighting=lit,
            show_scalar_bar=False,
            reset_camera=False,
            **options,
        )

    def _build_hoop(self, actor: _Actor) -> None:
        pyvista, theme = self._pyvista, self.theme
        radius = actor.motion.scenario.hoop.radius
        points, normals, _ = torus(radius, TUBE * radius)
        faces = np.column_stack([np.full(len(points), 4), torus_faces()]).ravel()
        ring = pyvista.PolyData(points, faces=faces)
        ring.point_data["Normals"] = normals
        ring.point_data.active_normals_name = "Normals"
        ring.point_data["shade"] = np.zeros((len(points), 3), dtype=np.uint8)
        ball = pyvista.Sphere(radius=LOAD * radius, theta_resolution=32, phi_resolution=24)
        bead = pyvista.Sphere(radius=HEAVY * radius, theta_resolution=24, phi_resolution=16)
        meshes, actors = actor.meshes, actor.actors
        meshes["ring"] = ring
        actors["ring"] = self._add(
            ring,
            None,
            scalars="shade",
            rgb=True,
            smooth_shading=False,
            specular=0.25,
            specular_power=20,
            ambient=0.25,
        )
        actors["ring"].prop.interpolation = "Gouraud"
        shine: dict[str, Any] = {"smooth_shading": True, "specular": 0.5, "specular_power": 25}
        actors["load"] = self._add(ball, mix(theme.load, "#808080", 0.12), **shine)
        actors["load"].prop.specular_color = "white"
        actors["heavy"] = self._add(bead, theme.visible(colors.GRAVITY_CENTER), ambient=0.4, **shine)
        spoke = pyvista.PolyData(np.zeros((2, 3)), lines=[2, 0, 1])
        meshes["spoke"] = spoke
        self._add(spoke, theme.muted, lit=False, line_width=1.5)
        if self.look.shadows:
            for name, mesh in (("ring", ring), ("load", ball)):
                actors[f"{name} shadow"] = self._add(mesh.copy(), self._shade, lit=False, scalars=None)
        if self.look.forces:
            for name, color in (("normal", colors.NORMAL_FORCE), ("friction", colors.FRICTION_FORCE)):
                shaft = pyvista.Cylinder(center=(0.5, 0, 0), direction=(1, 0, 0), radius=1.0, height=1.0)
                head = pyvista.Cone(center=(0.5, 0, 0), direction=(1, 0, 0), radius=1.0, height=1.0, resolution=32)
                for part, mesh in ((f"{name} shaft", shaft), (f"{name} head", head)):
                    actors[part] = self._add(mesh, theme.visible(color), ambient=0.35)
        if self.look.traces:
            track = actor.trace
            self._build_line(actor, "load trace", track.load, [theme.load] * (len(track.t) - 1), 2.5)
            inks = [
                theme.visible(colors.GRAVITY_CENTER_AIRBORNE if airborne else colors.GRAVITY_CENTER)
                for a, b, airborne in track.runs
                for _ in range(b - a)
            ]
            self._build_line(actor, "heavy trace", track.gravity_center, inks, 4.0)

    def _build_line(self, actor: _Actor, name: str, way: Floats, inks: list[str], width: float) -> None:
        points = place_3d(way, actor.lane)
        cells = pieces(len(points) - 1)
        # one more point and cell, for the piece up to now
        mesh = self._pyvista.PolyData(np.vstack([points, points[-1:]]), lines=cells.ravel())
        paint = np.array([[int(ink[i : i + 2], 16) for i in (1, 3, 5)] for ink in inks], dtype=np.uint8)
        mesh.cell_data["ink"] = paint.reshape(-1, 3)
        actor.meshes[name] = mesh
        actor.meshes[f"{name} points"] = points
        actor.meshes[f"{name} inks"] = paint.reshape(-1, 3)
        actor.actors[name] = self._add(mesh, None, lit=False, scalars="ink", rgb=True, line_width=width)

    # --- what moves ----------------------------------------------------------------------------

    def _move(self, actor: _Actor, k: int) -> None:
        poses, meshes, actors = actor.poses, actor.meshes, actor.actors
        center, load, heavy, contact = (
            place_3d(points[k], actor.lane) for points in (poses.center, poses.load, poses.gravity_center, poses.contact)
        )
        shades = shades_of(actor.speeds[k], self.extent.speed)[:, :3]
        meshes["ring"].point_data["shade"] = np.repeat(np.rint(255.0 * shades).astype(np.uint8), SECTIONS, axis=0)
        for name, spot in (("ring", center), ("load", load), ("heavy", heavy)):
            matrix = shift(spot)
            actors[name].user_matrix = matrix
            if f"{name} shadow" in actors:
                actors[f"{name} shadow"].user_matrix = self._flat @ matrix
        airborne = poses.mode[k] == "H"
        ink = colors.GRAVITY_CENTER_AIRBORNE if airborne else colors.GRAVITY_CENTER
        actors["heavy"].prop.color = self.theme.visible(ink)
        meshes["spoke"].points = np.array([center, load])
        if self.look.forces:
            for name, force in (("normal", poses.normal_force[k]), ("friction", poses.friction_force[k])):
                way = arrow(force, self.newton(k), FORCE_LENGTH * self._radius)
                self._point(actors, name, contact, place_3d(way, 0.0))
        if self.look.traces:
            past = int(np.searchsorted(actor.trace.t, poses.t[k]))
            for name, spot in (("load trace", load), ("heavy trace", heavy)):
                self._uncover(actor, name, past, spot)

    def _point(self, actors: dict[str, Any], name: str, tail: Floats, force: Floats) -> None:
        length = float(np.linalg.norm(force))
        shaft, head = actors[f"{name} shaft"], actors[f"{name} head"]
        visible = length > 0.02 * self._radius
        shaft.visibility = head.visibility = visible
        if not visible:
            return
        along = force / length
        side = np.array([0.0, 1.0, 0.0])
        turn = np.column_stack([along, side, np.cross(along, side)])
        thick = 0.03 * self._radius
        point = min(0.2 * self._radius, length)
        wide = min(2.4 * thick, 0.6 * point)
        # in front of the ring, not inside its tube
        foot = tail + np.array([0.0, -(TUBE + 0.04) * self._radius, 0.0])
        shaft.user_matrix = frame(foot, turn * [max(length - point, 1e-6), thick, thick])
        head.user_matrix = frame(foot + (length - point) * along, turn * [point, wide, wide])

    def _uncover(self, actor: _Actor, name: str, past: int, spot: Floats) -> None:
        mesh, points, inks = (actor.meshes[key] for key in (name, f"{name} points", f"{name} inks"))
        actor.actors[name].visibility = past > 0
        if past == 0:
            return
        mesh.points = np.vstack([points[:past], spot[None, :]])
        mesh.lines = pieces(past).ravel()
        mesh.cell_data["ink"] = inks[:past] if past <= len(inks) else np.vstack([inks, inks[-1:]])

    # --- camera --------------------------------------------------------------------------------

    def _camera_path(self) -> tuple[Floats, Floats]:
        """Return positions and focal points, one row per frame (or one for all)."""
        radius, tilt, n = self._radius, self._slope, self.count
        width, height = self.look.size
        camera = self._plotter.camera
        camera.view_angle = ANGLE
        camera.up = (0.0, 0.0, 1.0)
        wide = 2.0 * math.tan(math.radians(0.5 * ANGLE)) * width / height  # of the view, at a distance of 1
        # a narrow picture needs more distance for the same width
        away = radius * max(6.2 + 1.1 * (len(self.actors) - 1), 4.2 / wide) + 1.5 * self.extent.height
        if self.look.camera == "hold":
            low, high = self.extent.along
            middle = 0.5 * (low + high)
            away = max(away, 1.12 * (high - low + 2.8 * radius) / wide)
            turn = np.full(1, math.radians(-8.0))
            along = np.full(1, middle)
        else:
            along = np.mean([actor.poses.sample.x for actor in self.actors], axis=0)
            along = follow(np.arange(n) / self.fps, along, CALM)
            start = {"chase": -20.0, "side": 0.0, "orbit": -50.0}[self.look.camera]
            sweep = 100.0 if self.look.camera == "orbit" else 0.0
            turn = np.radians(start + sweep * np.linspace(0.0, 1.0, n))
        rise = {"side": 0.08, "hold": 0.16}.get(self.look.camera, 0.19)
        target = place_3d(to_world(along, np.full_like(along, 0.95 * radius), tilt), 0.0)
        reach = away * math.sqrt(1.0 - rise**2)
        # stay above a plane that rises behind
        offset = np.stack([reach * np.sin(turn), -reach * np.cos(turn), np.full_like(turn, rise * away)], axis=-1)
        offset[:, 2] += np.maximum(0.0, -offset[:, 0] * math.tan(tilt))
        return target + offset, target

    # --- words ---------------------------------------------------------------------------------

    def _lay_out(self, labels: Sequence[str]) -> Layout:
        canvas, u = self.canvas, self.canvas.unit
        if len(labels) == 1:
            words, high = [canvas.text_width(labels[0], FONT), state_width(canvas, "v = −10.00 m/s")], ONE_HEAD * u
        else:
            words, high = [state_width(canvas, label) for label in labels], (ROW_HEAD + ROW * (len(labels) - 1)) * u
        keys = [word for _, word in self._keys]
        return lay_out(canvas, words, high, self.look.forces, keys, longest_pace(self.clock.rate))

    def _draw_words(self, k: int) -> None:
        canvas, theme, u = self.canvas, self.theme, self.canvas.unit
        height = self.look.size[1]
        several = len(self.actors) > 1
        room = self.layout.words[2]
        metre = self._metre(k)
        view = 0.0, self.layout.foot, float(self.look.size[0]), height - self.layout.head - self.layout.foot
        taken = []
        if not several:
            draw_label(canvas, theme, (22.0 * u, height - LABEL_BASE * u), self.actors[0].label, room)
        for row, actor in enumerate(self.actors):
            poses = actor.poses
            line = StateLine(
                str(poses.words[k]),
                float(poses.t[k]),
                float(poses.angle[k]),
                extra=actor.label if several else speed_words(poses, k),
                end=end_word(actor.motion, float(poses.t[k]), k in (0, self.count - 1)),
                tag=actor.tag,
            )
            place = 22.0 * u, height - ((ROW_HEAD - 10.0 if several else ONE_HEAD - 6.0) + ROW * row) * u
            draw_state(canvas, theme, place, line, room)
            if actor.tag:
                draw_tag(canvas, theme, self._display(actor.poses.center[k], actor.lane), actor.tag)
            # on the near side of the track, not hidden by the ring
            near = actor.lane - 0.35 * self._radius
            canvas.clip(view)
            now = float(actor.poses.t[k]), float(self.clock.rate[k]), float(self.clock.still[k])
            spot_of = partial(self._visible_point, lane=near)
            seen = draw_event_marks(canvas, theme, actor.found, now, spot_of, self._radius * metre, 34.0 * u)
            taken += label_event_marks(canvas, theme, seen, 34.0 * u, (0.0, float(self.look.size[0])))
            canvas.clip(None)
        draw_distances(canvas, theme, self._distances(k), taken, view)
        if self.look.forces:
            draw_force_key(canvas, theme, self.layout, self.newton(k) * metre, float(self.force_levels[k]))
        draw_pace(canvas, theme, self.layout, float(self.clock.rate[k]))
        draw_keys(canvas, theme, self.layout, self.extent.speed, self._keys)

    def _distances(self, k: int) -> list[tuple[float, Floats]]:
        """Return every second mark at the near edge of the track that is not far, and its place in the picture."""
        position, focus = (row[min(k, len(row) - 1)] for row in self._path)
        step, edge = 2.0 * mark_step(self._radius), -half_track(self._radius, len(self.actors))
        away = float(np.linalg.norm(position - focus))
        here = float(focus[[0, 2]] @ to_world(1.0, 0.0, self._slope))
        near = np.arange(math.ceil((here - 2.0 * away) / step), math.floor((here + 2.0 * away) / step) + 1)
        shown = []
        for mark in near:
            place = to_world(mark * step, 0.0, self._slope)
            off = float(np.linalg.norm(place_3d(place, edge) - position))
            if off < FARTHEST * away and (place_3d(place, edge) - position) @ (focus - position) > 0.0:
                shown.append((off, float(mark * step), self._display(place, edge)))
        return [(mark, spot) for _, mark, spot in sorted(shown, key=lambda one: one[0])]

    def _visible_point(self, point: Floats, lane: float) -> Floats | None:
        spot = self._display(point, lane)
        width, height = self.look.size
        return spot if -width < spot[0] < 2 * width and 0.0 < spot[1] < height else None
