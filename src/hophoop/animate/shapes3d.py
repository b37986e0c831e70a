"""Shapes and matrices of scenes in 3D: X level, Y into the picture, Z up."""

from __future__ import annotations

import math

import numpy as np

from hophoop.results.poses import Floats, to_world

STATIONS, SECTIONS = 120, 20  # of the torus
TUBE, LOAD, HEAVY = 0.05, 0.1, 0.05  # radii of the torus's tube and of the spheres, over the rim's
LANE = 1.6  # between several motions, in radii
FORCE_LENGTH = 1.3  # of the arrow of the maximum force, in radii
SUN = np.array([0.32, 0.75, -1.0])  # direction of the light


def torus(radius: float, tube: float) -> tuple[Floats, Floats, Floats]:
    """Return points of a torus in the X–Z plane, their normals and their angles on the rim.

    radius: outer radius [m]; tube: radius of the tube [m]; points, normals: shape (STATIONS × SECTIONS, 3), [m] and [1];
    angles: shape (STATIONS,), from +Z, clockwise as seen from −Y; SECTIONS points belong to each [rad].
    """
    angles = np.linspace(0.0, 2.0 * math.pi, STATIONS, endpoint=False)
    around = np.linspace(0.0, 2.0 * math.pi, SECTIONS, endpoint=False)
    out = np.stack([np.sin(angles), np.zeros(STATIONS), np.cos(angles)], axis=-1)[:, None, :]
    side = np.array([0.0, 1.0, 0.0])
    normals = np.cos(around)[None, :, None] * out + np.sin(around)[None, :, None] * side
    points = (radius - tube) * out + tube * normals
    return points.reshape(-1, 3), normals.reshape(-1, 3), angles


def torus_faces() -> np.ndarray:
    """Return quadrangles of `torus`, shape (STATIONS × SECTIONS, 4), counter-clockwise from outside."""
    i, j = np.meshgrid(np.arange(STATIONS), np.arange(SECTIONS), indexing="ij")
    following, above = (i + 1) % STATIONS, (j + 1) % SECTIONS
    corners = (i * SECTIONS + j, following * SECTIONS + j, following * SECTIONS + above, i * SECTIONS + above)
    return np.stack([corner.ravel() for corner in corners], axis=-1)


def place_3d(points: Floats, lane: float) -> Floats:
    """Convert points of the world, X level and Y up, to X, lane, Z."""
    flat = np.asarray(points, dtype=float)
    return np.stack([flat[..., 0], np.full(flat.shape[:-1], lane), flat[..., 1]], axis=-1)


def shadow_matrix(slope: float, lift: float) -> Floats:
    """Return the projection along the light onto the plane, raised by a distance [m]: 4 × 4."""
    normal = place_3d(to_world(0.0, 1.0, slope), 0.0)
    matrix = np.eye(4)
    matrix[:3, :3] -= np.outer(SUN, normal) / float(normal @ SUN)
    matrix[:3, 3] = lift * normal
    return matrix


def pieces(count: int) -> np.ndarray:
    """Return the cells of a line with this number of pieces, for VTK."""
    first = np.arange(count)
    return np.column_stack([np.full(count, 2), first, first + 1])


def shift(spot: Floats) -> Floats:
    """Return the matrix of a translation to a point, 4 × 4."""
    matrix = np.eye(4)
    matrix[:3, 3] = spot
    return matrix


def frame(origin: Floats, axes: Floats) -> Floats:
    """Return the matrix that maps the axes to the columns of a 3 × 3 at an origin: 4 × 4."""
    matrix = np.eye(4)
    matrix[:3, :3] = axes
    matrix[:3, 3] = origin
    return matrix


def mix(color: str, other: str, share: float) -> str:
    """Interpolate between two colours."""
    pairs = zip(*([int(name[i : i + 2], 16) for i in (1, 3, 5)] for name in (color, other)), strict=True)
    return "#" + "".join(f"{round(a + share * (b - a)):02X}" for a, b in pairs)
