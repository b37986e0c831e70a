"""Circle fitting: algebraic start, geometric and robust refinement, and RANSAC among outliers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.tracking.scatter import Complexes, Flags, Floats, spread

BINS = 72  # of the circumference
UNKNOWN = 0.0, np.inf  # radius, and its error [pixel]
ROUND = 0.0, 0.0, 1e-6  # amplitudes of a circle that is no oval, and their error [pixel]


class Circle(NamedTuple):
    """A circle in the plane or the picture, which are complex planes: x + i y, or column + i row [pixel]."""

    centre: complex
    radius: float


def fit_circle(points: Complexes) -> tuple[Circle, Floats]:
    """Fit a circle by algebraic least squares, which are those of the distances where the points are near a circle.

    points: shape (n,), at least three [pixel]; off: shape (n,), distance of each point from the circle, positive outside
    [pixel].
    """
    shift = points.mean()
    near = points - shift
    design = np.column_stack([2.0 * near.real, 2.0 * near.imag, np.ones(len(near))])
    x, y, square = np.linalg.lstsq(design, np.abs(near) ** 2, rcond=None)[0].tolist()
    centre = complex(x, y)
    radius = float(np.sqrt(max(square + x * x + y * y, 1e-12)))
    return Circle(complex(shift) + centre, radius), np.abs(near - centre) - radius


class CircleFit(NamedTuple):
    """A robust fit of a circle to edges."""

    circle: Circle
    covariance: Floats  # of centre's real and imaginary part and radius [pixel²]
    inside: Flags  # points on the circle
    spread: float  # of those points about it [pixel]
    oval: tuple[float, float]  # amplitudes of the cosine and sine, twice around, of its radius [pixel]


def robust_circle(
    points: Complexes,
    start: Circle,
    reach: float,
    expected: tuple[float, float] = UNKNOWN,
    oval: tuple[float, float, float] = ROUND,
) -> CircleFit | None:
    """Fit a circle geometrically to most of the points, with Tukey's weights.

    points shape (n,) [pixel]; reach: points further than this from the start are ignored [pixel]; expected: known radius and
    its error, for a fit to a part of the rim [pixel]; oval: expected amplitudes and their error, for the ellipse that is the
    picture of a tilted circle [pixel]; fit: None if the points are not on a circle.
    """
    if len(points) < 8:
        return None
    size = np.median(np.abs(points - start.centre))  # the start may be the inner edge of the rim, the points its outer one
    found = np.array([start.centre.real, start.centre.imag, size, *oval[:2]])
    goal = np.array([0.0, 0.0, expected[0], *oval[:2]])
    hold = np.array([np.inf, np.inf, expected[1], oval[2], oval[2]]) ** -2.0
    width = reach
    for _ in range(10):
        away = points - complex(*found[:2])
        distance = np.maximum(np.abs(away), 1e-9)
        way = away / distance
        twice = way**2
        jacobian = np.stack([way.real, way.imag, np.ones(len(points)), twice.real, twice.imag], axis=-1)
        off = distance - jacobian[:, 2:] @ found[2:]
        near = np.abs(off) < width
        if near.sum() < 8:
            return None
        # the median of the near points is small although half of the rest are outliers
        scatter = max(spread(off[near]), 0.03)
        scale = max(4.685 * scatter, 0.3)
        weight = (1.0 - (off / scale) ** 2).clip(0.0) ** 2
        normal = jacobian.T @ (weight[:, None] * jacobian)
        if np.linalg.det(normal[:3, :3]) <= 1e-4 * np.trace(normal[:3, :3]) ** 2:
            return None  # an arc too short to distinguish from a line
        normal += np.diag(scatter**2 * hold)
        step = np.linalg.solve(normal, jacobian.T @ (weight * off) + scatter**2 * hold * (goal - found))
        found += step
        width = max(3.0 * scatter, 1.0)
        if np.abs(step).max() < 1e-3:
            break
    covariance = np.asarray(scatter**2 * np.linalg.inv(normal)[:3, :3], dtype=float)
    x, y, radius, cos2, sin2 = found.tolist()
    return CircleFit(Circle(complex(x, y), radius), covariance, weight > 0.0, scatter, (cos2, sin2))


def ransac_circles(
    points: Complexes, sizes: tuple[float, float], picture: tuple[int, int], rng: np.random.Generator, draws: int = 240
) -> list[tuple[float, Circle]]:
    """Find circles through three random points (RANSAC), those with most points on their circumference first.

    points shape (n,) [pixel]; sizes: minimum and maximum radius [pixel]; picture: height and width; only the circumference
    inside counts [pixel]; draws: number of triples [1]; found: covered share of the circumference [1], and the circle; at most
    three separate ones.
    """
    if len(points) < 12:
        return []
    a, b, c = points[rng.integers(0, len(points), (draws, 3))].T
    with np.errstate(divide="ignore", invalid="ignore"):  # three points on a line
        ratio = (c - a) / (b - a)
        centre = a + (b - a) * (ratio - np.abs(ratio) ** 2) / (2.0j * ratio.imag)
    radius = np.abs(a - centre)
    fair = (radius > sizes[0]) & (radius < sizes[1])
    around = np.exp(2.0j * np.pi * np.arange(BINS) / BINS)
    found = []
    for one in map(Circle, centre[fair].tolist(), radius[fair].tolist()):
        away, rim = points - one.centre, one.centre + one.radius * around
        near = np.abs(np.abs(away) - one.radius) < max(1.2, 0.015 * one.radius)
        covered = np.unique(np.round(np.angle(away[near]) * BINS / (2.0 * np.pi)).astype(int) % BINS)
        seen = (rim.real >= 0) & (rim.real < picture[1]) & (rim.imag >= 0) & (rim.imag < picture[0])
        found.append((float(seen[covered].sum() / max(seen.sum(), 0.25 * BINS)), one))
    result: list[tuple[float, Circle]] = []
    for share, one in sorted(found, key=lambda pair: -pair[0]):
        apart = (abs(one.centre - old.centre) + abs(one.radius - old.radius) - 0.1 * old.radius for _, old in result)
        if len(result) < 3 and all(distance > 0.0 for distance in apart):
            result.append((share, one))
    return result
