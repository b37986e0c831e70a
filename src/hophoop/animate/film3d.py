"""Films in 3D: a torus, a sphere, their shadows, traces and arrows, rendered by PyVista without a display.

X is level, Y points into the picture, Z up.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.frames import Timing, common_slope, follow, subject_of
from hophoop.animate.head import Head
from hophoop.animate.look import FORCE_LENGTH, LANE, LONGEST, Look3D, bounded, nice
from hophoop.animate.sheet import Bytes, Sheet, shades_of
from hophoop.animate.themes import THEMES
from hophoop.results.poses import Floats, poses_of, rim_speeds, to_world
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors

SMOOTH = 4  # samples per pixel
STATIONS, SECTIONS = 120, 20  # of the torus
TUBE, LOAD, HEAVY = 0.05, 0.1, 0.05  # radii of the torus's tube and of the spheres, over the rim's
SUN = np.array([0.32, 0.75, -1.0])  # direction of the light
ANGLE = 30.0  # of the view, from its lower to its upper edge [°]
CALM = 0.6  # smoothing of the camera [s of film]
FAR, FARTHEST = 60.0, 1.7  # extension of the plane, in radii; distances with a number, over that of the focal point
TRACE_POINTS = 6000  # maximum, the last ones


class _Actor:
    """One motion in the scene, with its moving meshes."""

    def __init__(self, film: Film3D, row: int) -> None:
        subject, self.row = film.subject, row
        self.motion, self.trace = subject.motions[row], subject.traces[row]
        self.lane = LANE * film.radius * (row - 0.5 * (len(subject.motions) - 1))
        self.poses = poses_of(self.motion, film.clock.times[row])
        pv, theme, radius = film.pyvista, film.theme, self.motion.scenario.hoop.radius
        self.speeds = rim_speeds(self.poses, np.linspace(0.0, 2.0 * math.pi, STATIONS, endpoint=False) - film.slope, radius)
        tube = TUBE * radius
        torus = pv.ParametricTorus(ringradius=radius - tube, crosssectionradius=tube, u_res=STATIONS + 1, v_res=SECTIONS + 1)
        self.ring = torus.rotate_x(90.0, inplace=False)
        # the torus does not rotate: its points have the colours of the speed there
        angles = np.arctan2(self.ring.points[:, 0], self.ring.points[:, 2])
        self.station = np.rint(angles / (2.0 * math.pi) * STATIONS).astype(int) % STATIONS
        self.ring["shade"] = np.zeros((self.ring.n_points, 3), dtype=np.uint8)
        ball, bead = pv.Sphere(radius=LOAD * radius), pv.Sphere(radius=HEAVY * radius)
        shine = {"smooth_shading": True, "specular": 0.5, "specular_power": 25}
        gloss = {"smooth_shading": True, "specular": 0.25, "specular_power": 20, "ambient": 0.25}
        self.solids = {
            "ring": film.add(self.ring, scalars="shade", rgb=True, split_sharp_edges=False, **gloss),
            "load": film.add(ball, color=colors.mix(theme.load, "#808080", 0.12), **shine),
            "heavy": film.add(bead, color=theme.visible(colors.GRAVITY_CENTER), ambient=0.4, **shine),
        }
        self.shadows = {
            name: film.add(mesh.copy(), color=colors.mix(film.ground, "#000000", 0.38), lighting=False, scalars=None)
            for name, mesh in (("ring", self.ring), ("load", ball))
            if film.look.shadows
        }
        self.spoke = pv.Line()
        film.add(self.spoke, color=theme.muted, lighting=False, line_width=1.5)
        self.arrows = {}
        for name, color in (("normal_force", colors.NORMAL_FORCE), ("friction_force", colors.FRICTION_FORCE)):
            mesh = pv.Arrow()
            self.arrows[name] = mesh, film.add(mesh, color=theme.visible(color), ambient=0.35)
        self.inks = [theme.visible(ink) for ink in (colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE)]
        flies = self.trace.airborne.astype(int)
        paint = np.array([colors.rgb(ink) for ink in (*self.inks, theme.load)], dtype=np.uint8)
        self.lines = []
        for path, inks, width in ((self.trace.load, np.full_like(flies, 2), 2.5), (self.trace.gravity_center, flies, 4.0)):
            mesh = pv.Line()
            mesh.cell_data["ink"] = paint[:1]
            line = film.add(mesh, lighting=False, scalars="ink", rgb=True, line_width=width)
            self.lines.append((mesh, line, in_space(path, self.lane), paint[inks]))

    def move(self, film: Film3D, k: int) -> None:
        """Place the meshes for the k-th picture."""
        poses = self.poses
        spots = {"ring": poses.center, "load": poses.load, "heavy": poses.gravity_center}
        places = {name: in_space(points[k], self.lane) for name, points in spots.items()}
        shades = np.rint(255.0 * shades_of(self.speeds[k], film.subject.whole.speed)[:, :3]).astype(np.uint8)
        self.ring["shade"] = shades[self.station]
        for name, solid in self.solids.items():
            shift = np.eye(4)
            shift[:3, 3] = places[name]
            solid.user_matrix = shift
            if name in self.shadows:
                self.shadows[name].user_matrix = film.flat @ shift
        self.solids["heavy"].prop.color = self.inks[int(poses.mode[k] == "H")]
        self.spoke.points = np.stack([places["ring"], places["load"]])
        # in front of the ring, not inside its tube
        foot = in_space(poses.contact[k], self.lane - (TUBE + 0.04) * film.radius)
        for name, (mesh, arrow) in self.arrows.items():
            force = bounded(getattr(poses, name)[k] * film.newton, LONGEST * FORCE_LENGTH * film.radius)
            length, thick = float(np.hypot(*force)), 0.03 * film.radius
            arrow.visibility = film.look.forces and length > 0.02 * film.radius
            if arrow.visibility:
                point = min(0.2 * film.radius, length)
                shape = {
                    "tip_length": point,
                    "tip_radius": min(2.4 * thick, 0.6 * point),
                    "shaft_radius": min(thick, 0.3 * point),
                }
                relative = {name: size / length for name, size in shape.items()}
                mesh.copy_from(film.pyvista.Arrow(start=foot, direction=in_space(force, 0.0), scale=length, **relative))
        past = int(np.searchsorted(self.trace.t, poses.t[k]))
        for (mesh, line, points, inks), end in zip(self.lines, (places["load"], places["heavy"]), strict=True):
            line.visibility = film.look.traces and past > 0
            if line.visibility:
                first = max(0, past - TRACE_POINTS)
                way = film.pyvista.MultipleLines(np.vstack([points[first:past], end]))
                # one cell per piece, for its colour
                cells = np.arange(past - first)
                way.lines = np.column_stack([np.full_like(cells, 2), cells, cells + 1]).ravel()
                way.cell_data["ink"] = inks[first:past]
                mesh.copy_from(way)


class Film3D:
    """The pictures of a film in 3D: `draw(k)` gives the k-th. Close it.

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
        self.subject = subject_of(motions, timing, look.labels)
        self.clock, self.count = self.subject.clock, self.subject.clock.count
        self.fps, self.look, self.size, self.theme = timing.frame_rate, look, look.size, THEMES[look.theme]
        self.slope = common_slope(motions)
        self.pyvista = need("pyvista", "films3d")
        self.radius = max(motion.scenario.hoop.radius for motion in motions)
        self.newton = FORCE_LENGTH * self.radius / self.subject.whole.force
        self._open()
        normal = in_space(to_world(0.0, 1.0, self.slope), 0.0)
        self.flat = np.eye(4)  # the projection along the light onto the plane
        self.flat[:3, :3] -= np.outer(SUN, normal) / float(normal @ SUN)
        self.flat[:3, 3] = 0.002 * self.radius * normal
        self.ground = self.theme.ground if look.theme != "print" else "#F4F4F4"
        self.half = (0.5 * (len(motions) - 1) * LANE + 1.1) * self.radius  # of the track
        self.step = nice(1.01 * self.radius)  # between the marks across it
        self._add_plane()
        self.actors = [_Actor(self, row) for row in range(len(motions))]
        self.path = self._camera_path()
        self.away = float(np.linalg.norm(self.path[0][0] - self.path[1][0]))
        self.metre = self.size[1] / (2.0 * self.away * math.tan(math.radians(0.5 * ANGLE)))  # at the focal point [pixels]
        self.sheet = Sheet(look.size, "none")
        self.head = Head(self.sheet, self.theme, self.subject, look.forces)
        self.head.draw_keys(look.traces, self.newton * self.metre)
        self._keys = need("PIL.Image", "films3d").fromarray(self.sheet.render())

    def draw(self, k: int) -> Bytes:
        """The k-th picture, height × width × RGBA; valid until the next is drawn.

        k: from 0 to count − 1; picture: shape (height, width, 4), values from 0 to 255 [1].
        """
        for actor in self.actors:
            actor.move(self, k)
        self._aim(k)
        self._plotter.render()
        self.sheet.pixels[..., :3] = self._plotter.screenshot(None, return_img=True)
        self.sheet.pixels[..., 3] = 255
        self.sheet.image.alpha_composite(self._keys)
        self._draw_words(k)
        return self.sheet.pixels

    def pixel_of(self, k: int, actor: int, point: Floats) -> Floats:
        """Return the position of a point of the world [m] in the k-th picture: column, row from the top left [pixels]."""
        self._aim(k)
        x, y = self.on_screen(np.asarray(point), self.actors[actor].lane)
        return np.array([x, self.size[1] - y])

    def on_screen(self, point: Floats, lane: float) -> Floats:
        """Return the position of a point of the world in the picture, from the lower left [pixels]."""
        renderer = self._plotter.renderer
        renderer.SetWorldPoint(*in_space(point, lane), 1.0)
        renderer.WorldToDisplay()
        return np.array(renderer.GetDisplayPoint()[:2])

    def close(self) -> None:
        """Free the renderer."""
        self._plotter.close()

    def add(self, mesh: Any, **look: Any) -> Any:
        """Add a mesh to the scene."""
        return self._plotter.add_mesh(mesh, show_scalar_bar=False, reset_camera=False, **look)

    def _open(self) -> None:
        pv = self.pyvista
        with pv.vtk_verbosity("error"):  # without a display VTK warns, and renders in software
            self._plotter = pv.Plotter(off_screen=True, window_size=list(self.size), lighting="none")
            if SMOOTH:
                self._plotter.enable_anti_aliasing("msaa", multi_samples=SMOOTH)
            self._plotter.render_window.Render()
        if not self._plotter.render_window.SupportsOpenGL():
            raise OSError("VTK finds no OpenGL, not even in software; on Debian, libegl1 or libosmesa6 has it.")
        sky = self.theme.background if self.theme.dark else "#DCE6EE"
        self._plotter.set_background(self.theme.background, top=sky if self.look.theme != "print" else None)
        sun = pv.Light(position=tuple(-10.0 * SUN), focal_point=(0.0, 0.0, 0.0), intensity=0.75)
        sun.positional = False
        self._plotter.add_light(sun)
        self._plotter.add_light(pv.Light(light_type="headlight", intensity=0.45))

    def _add_plane(self) -> None:
        """Add a wide sheet, the track, and the marks across it."""
        radius, along, ink = self.radius, self.subject.whole.along, self.theme.ink
        ends = np.array(along) + FAR * radius * np.array([-1.0, 1.0])
        for half, lift, share in ((FAR * radius, -0.012, 0.0), (self.half, -0.008, 0.05)):
            edge = to_world(ends, np.full(2, lift * radius), self.slope)
            corners = np.vstack([in_space(edge, -half), in_space(edge[::-1], half)])
            self.add(
                self.pyvista.PolyData(corners, faces=[4, 0, 1, 2, 3]), color=colors.mix(self.ground, ink, share), lighting=False
            )
        first = math.floor((along[0] - 8.0 * radius) / self.step)
        last = min(math.ceil((along[1] + 8.0 * radius) / self.step), first + 2000)
        marks = np.arange(first, last + 1) * self.step
        feet = to_world(marks, np.full(len(marks), -0.005 * radius), self.slope)
        pairs = np.stack([in_space(feet, -self.half), in_space(feet, self.half)], axis=1).reshape(-1, 3)
        lines = self.pyvista.line_segments_from_points(pairs)
        self.add(lines, color=colors.mix(self.ground, ink, 0.25), lighting=False, line_width=1.3)

    def _camera_path(self) -> tuple[Floats, Floats]:
        """Return positions and focal points, one row per frame (or one for all)."""
        radius, tilt, n, whole = self.radius, self.slope, self.count, self.subject.whole
        camera = self._plotter.camera
        camera.view_angle, camera.up = ANGLE, (0.0, 0.0, 1.0)
        wide = 2.0 * math.tan(math.radians(0.5 * ANGLE)) * self.size[0] / self.size[1]  # of the view, at a distance of 1
        # a narrow picture needs more distance for the same width
        away = radius * max(6.2 + 1.1 * (len(self.actors) - 1), 4.2 / wide) + 1.5 * whole.height
        if self.look.camera == "hold":
            low, high = whole.along
            away = max(away, 1.12 * (high - low + 2.8 * radius) / wide)
            turn, along = np.full(1, math.radians(-8.0)), np.full(1, 0.5 * (low + high))
        else:
            along = np.mean([actor.poses.sample.x for actor in self.actors], axis=0)
            along = follow(np.arange(n) / self.fps, along, CALM)
            start = {"chase": -20.0, "side": 0.0, "orbit": -50.0}[self.look.camera]
            turn = np.radians(start + 100.0 * (self.look.camera == "orbit") * np.linspace(0.0, 1.0, n))
        rise = {"side": 0.08, "hold": 0.16}.get(self.look.camera, 0.19)
        target = in_space(to_world(along, np.full_like(along, 0.95 * radius), tilt), 0.0)
        reach = away * math.sqrt(1.0 - rise**2)
        offset = np.stack([reach * np.sin(turn), -reach * np.cos(turn), np.full_like(turn, rise * away)], axis=-1)
        offset[:, 2] += np.maximum(0.0, -offset[:, 0] * math.tan(tilt))  # above a plane that rises behind
        return target + offset, target

    def _aim(self, k: int) -> None:
        camera = self._plotter.camera
        camera.position, camera.focal_point = (tuple(row[min(k, len(row) - 1)]) for row in self.path)
        self._plotter.renderer.ResetCameraClippingRange()

    def _draw_words(self, k: int) -> None:
        u, head, radius = self.sheet.unit, self.head, self.radius
        view = 0.0, head.foot, float(self.size[0]), self.size[1] - head.head - head.foot
        head.draw_labels()
        head.draw_states(k, [(actor.poses, k) for actor in self.actors])
        for row, actor in enumerate(self.actors):
            if len(self.actors) > 1:
                head.draw_tag(self.on_screen(actor.poses.center[k], actor.lane), row, self.theme.background)
            # on the near side of the track, not hidden by the ring
            marks = self.subject.past(row, k)
            spots = np.array([self.on_screen(one.place, actor.lane - 0.35 * radius) for one in marks])
            head.draw_marks(k, row, marks, spots, radius * self.metre, 17.0 * u, view)
        self._draw_distances(k)
        head.draw_pace(k)

    def _draw_distances(self, k: int) -> None:
        """Write every second mark's distance at the near edge of the track, the nearest first, where there is room."""
        sheet, u, step, away = self.sheet, self.sheet.unit, 2.0 * self.step, self.away
        position, focus = (row[min(k, len(row) - 1)] for row in self.path)
        taken: list[tuple[float, float, float]] = []
        here = float(focus[[0, 2]] @ to_world(1.0, 0.0, self.slope))
        marks = np.arange(math.ceil((here - 2.0 * away) / step), math.floor((here + 2.0 * away) / step) + 1) * step
        places = to_world(marks, np.zeros_like(marks), self.slope)
        ways = in_space(places, -self.half) - position
        off = np.linalg.norm(ways, axis=1)
        low, high = self.head.foot + 8.0 * u, self.size[1] - self.head.head - 8.0 * u
        for k in np.argsort(off):
            if off[k] > FARTHEST * away or ways[k] @ (focus - position) <= 0.0:
                continue
            words = f"{marks[k]:g} m"
            x, y = self.on_screen(places[k], -self.half) - np.array([0.0, 17.0 * u])
            half = 0.5 * sheet.text_width(words)
            inside = half <= x <= self.size[0] - half and low <= y <= high
            if inside and all(abs(x - a) > half + b + 9.0 * u or abs(y - c) > 24.0 * u for a, b, c in taken):
                sheet.text(x, y, words, colors.mix(self.theme.ground, self.theme.ink, 0.7), "mm")
                taken.append((x, half, y))


def in_space(points: Floats, lane: float) -> Floats:
    """Convert points of the world, X level and Y up, to X, lane, Z."""
    flat = np.asarray(points, dtype=float)
    return np.stack([flat[..., 0], np.full(flat.shape[:-1], lane), flat[..., 1]], axis=-1)
